// The program's text: only the lines in sight are in the page.
import { element } from './words.js';

const rowHeight = 18, spare = 6;

export class ProgramText {
  constructor(host, bytes, onLine) {
    this.bytes = bytes;
    this.starts = lineStarts(bytes);
    this.decoder = new TextDecoder();
    this.onLine = onLine;
    this.current = 0;
    this.rows = element('div.rows');
    this.spacer = element('div.spacer', {}, this.rows);
    this.box = element('div.program', { tabindex: 0, 'aria-label': 'program text', id: 'program' }, this.spacer);
    this.spacer.style.height = `${rowHeight * this.starts.length}px`;
    this.box.addEventListener('scroll', () => this.show());
    host.append(this.box);
    new ResizeObserver(() => this.show()).observe(this.box);
  }

  line(number) {
    const from = this.starts[number - 1], to = number < this.starts.length ? this.starts[number] - 1 : this.bytes.length;
    return this.decoder.decode(this.bytes.subarray(from, to)).replace(/\r$/, '');
  }

  setLine(number) {
    if (number === this.current) return;
    this.current = number;
    const top = (number - 1) * rowHeight, { scrollTop, clientHeight } = this.box;
    if (top < scrollTop + rowHeight || top > scrollTop + clientHeight - 2 * rowHeight) this.box.scrollTop = top - 0.4 * clientHeight;
    this.show();
  }

  show() {
    const first = Math.max(Math.floor(this.box.scrollTop / rowHeight) - spare, 0);
    const last = Math.min(first + Math.ceil(this.box.clientHeight / rowHeight) + 2 * spare, this.starts.length);
    const rows = [];
    for (let i = first; i < last; ++i) {
      const row = element(i + 1 === this.current ? 'div.row.current' : 'div.row', { onclick: () => this.onLine(i + 1) },
        element('span.number', {}, String(i + 1)), this.line(i + 1));
      rows.push(row);
    }
    this.rows.style.transform = `translateY(${first * rowHeight}px)`;
    this.rows.replaceChildren(...rows);
  }
}

function lineStarts(bytes) {
  const starts = [0];
  for (let at = bytes.indexOf(10); at >= 0 && at + 1 < bytes.length; at = bytes.indexOf(10, at + 1)) starts.push(at + 1);
  return Uint32Array.from(starts);
}
