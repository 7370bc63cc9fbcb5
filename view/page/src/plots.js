// The axes over time: uPlot panels one above the other, with the run's place in time marked in all of them.
import uPlot from 'uplot';
import { curvesFor, lowerBound, PeakPyramid } from './lod.js';
import { element, short } from './words.js';

const panelHeight = 158, limitReach = 1.6, snapPixels = 7;
const quantities = [
  { id: 'feed', name: 'Feed' }, { id: 'position', name: 'Position' }, { id: 'velocity', name: 'Velocity', per: '/s', limit: 'velocity_max' },
  { id: 'acceleration', name: 'Acceleration', per: '/s²', limit: 'acceleration_max' }, { id: 'jerk', name: 'Jerk', per: '/s³', limit: 'jerk_max' },
  { id: 'lag', name: 'Servo lag', per: '' },
];

export class AxisPlots {
  constructor(host, run, report) {
    this.run = run;
    this.axes = report.machine?.axes ?? [];
    this.colours = report.colours;
    this.host = element('div.panels');
    this.pyramids = new Map();
    this.panels = [];
    this.shown = new Set(['feed', 'velocity', 'acceleration', 'jerk']);
    this.group = this.axes.some((axis) => axis.rotary) ? 'rotary' : 'linear';
    this.range = run.cuttingRange();
    host.append(this.toolbar(), this.host);
    this.rebuild();
    run.onTime(() => this.markNow());
    new ResizeObserver(() => this.resize()).observe(this.host);
  }

  toolbar() {
    const bar = element('div.toolbar');
    const groups = [['rotary', 'rotary axes'], ['linear', 'linear axes']].filter(([id]) => this.axes.some((axis) => axis.rotary === (id === 'rotary')));
    const choose = element('select', { 'aria-label': 'axes shown', id: 'axis-group', onchange: (event) => { this.group = event.target.value; this.rebuild(); } },
      ...groups.map(([id, name]) => element('option', { value: id }, `${this.letters(id)}: ${name}`)));
    if (groups.length) bar.append(choose);
    for (const { id, name } of quantities) {
      if (id !== 'feed' && !groups.length) continue;
      const box = element('input', { type: 'checkbox', checked: this.shown.has(id), onchange: (event) => {
        if (event.target.checked) this.shown.add(id); else this.shown.delete(id);
        this.rebuild();
      } });
      bar.append(element('label', {}, box, ` ${name}`));
    }
    bar.append(element('button', { onclick: () => this.zoom(this.run.cuttingRange()), id: 'cutting' }, 'Cutting'),
      element('button', { onclick: () => this.zoom([0, this.run.end]), id: 'whole-run' }, 'Whole run'));
    return bar;
  }

  letters(group) { return this.groupAxes(group).map((axis) => axis.letter).join(' '); }
  groupAxes(group = this.group) { return this.axes.filter((axis) => axis.rotary === (group === 'rotary')); }

  pyramid(name) {
    if (!this.pyramids.has(name)) this.pyramids.set(name, new PeakPyramid(this.run.trace.values(name)));
    return this.pyramids.get(name);
  }

  rebuild() {
    for (const panel of this.panels) panel.plot.destroy();
    this.host.replaceChildren();
    this.panels = quantities.filter(({ id }) => this.shown.has(id) && (id === 'feed' || this.axes.length)).map((quantity) => this.makePanel(quantity));
    this.refresh();
  }

  makePanel(quantity) {
    const axes = quantity.id === 'feed' ? [] : this.groupAxes();
    const names = quantity.id === 'feed' ? ['feed'] : axes.map((axis) => `${quantity.id}.${axis.letter}`);
    const unit = quantity.id === 'feed' ? 'mm/min' : `${this.group === 'rotary' ? 'deg' : 'mm'}${quantity.per ?? ''}`;
    const limits = quantity.limit ? [...new Set(axes.map((axis) => axis[quantity.limit]))] : [];
    const panel = { quantity, names, limits, marker: element('div.now') };
    const series = [{}, ...names.map((name, i) => ({
      label: quantity.id === 'feed' ? 'tip' : axes[i].letter, stroke: this.colours[i % this.colours.length], width: 1.3, points: { show: false },
      value: (_, value) => short(value),
    }))];
    panel.title = element('div.panel-title', {}, `${quantity.name}, ${unit}`);
    const box = element('div.panel', { 'data-quantity': quantity.id }, panel.title);
    this.host.append(box);
    panel.plot = new uPlot(this.options(panel, series), [[0], ...names.map(() => [0])], box);
    panel.plot.over.append(panel.marker);
    return panel;
  }

  options(panel, series) {
    return {
      width: Math.max(this.host.clientWidth, 240), height: panelHeight, series,
      legend: { live: true },
      cursor: { sync: { key: 'run' }, drag: { x: true, y: false, setScale: false }, points: { size: 6 }, bind: { dblclick: () => () => this.zoom([0, this.run.end]) } },
      select: { show: true },
      scales: { x: { time: false, range: () => this.range }, y: { range: (_, least, greatest) => this.yRange(panel, least, greatest) } },
      axes: [{ size: 38, label: 'time, s', labelSize: 14, labelFont: '11px system-ui', values: (_, ticks) => ticks.map((tick) => short(tick, 6)), font: '11px system-ui', stroke: '#444', grid: { stroke: '#e8ebee' } },
        { size: 62, space: 24, values: (_, ticks) => ticks.map((tick) => short(tick, 5)), font: '11px system-ui', stroke: '#444', grid: { stroke: '#e8ebee' } }],
      hooks: {
        setSelect: [(plot) => this.zoomToSelection(plot)],
        draw: [(plot) => this.drawLimits(plot, panel)],
        ready: [(plot) => this.bind(plot, panel)],
      },
    };
  }

  yRange(panel, least, greatest) {
    if (least === null || greatest === null) return [0, 1];
    const reach = limitReach * Math.max(Math.abs(least), Math.abs(greatest));
    for (const limit of panel.limits) {
      if (limit > reach) continue;
      greatest = Math.max(greatest, limit);
      least = Math.min(least, -limit);
    }
    const margin = 0.06 * (greatest - least) || Math.max(1e-3 * Math.abs(greatest), 1e-3);
    return [least - margin, greatest + margin];
  }

  drawLimits(plot, panel) {
    const { ctx, bbox } = plot;
    ctx.save();
    ctx.strokeStyle = '#b00020';
    ctx.setLineDash([7 * devicePixelRatio, 5 * devicePixelRatio]);
    for (const limit of panel.limits)
      for (const value of [limit, -limit]) {
        const y = plot.valToPos(value, 'y', true);
        if (y < bbox.top || y > bbox.top + bbox.height) continue;
        ctx.beginPath();
        ctx.moveTo(bbox.left, y);
        ctx.lineTo(bbox.left + bbox.width, y);
        ctx.stroke();
      }
    ctx.restore();
  }

  bind(plot, panel) {
    let down = 0;
    plot.over.addEventListener('mousedown', (event) => { down = event.clientX; });
    plot.over.addEventListener('click', (event) => {
      if (Math.abs(event.clientX - down) < 4) this.pickPeak(plot, panel, event.clientX - plot.over.getBoundingClientRect().left);
    });
    plot.over.addEventListener('wheel', (event) => {
      event.preventDefault();
      this.zoomAbout(plot.posToVal(event.clientX - plot.over.getBoundingClientRect().left, 'x'), event.deltaY > 0 ? 1.25 : 0.8);
    }, { passive: false });
  }

  /** The sample of greatest magnitude within a few pixels of the click: what the eye aimed at. */
  pickPeak(plot, panel, x) {
    const times = this.run.times;
    const from = lowerBound(times, plot.posToVal(x - snapPixels, 'x'));
    const to = Math.max(lowerBound(times, plot.posToVal(x + snapPixels, 'x')), from + 1);
    if (to > times.length) return;
    const lowest = panel.quantity.id === 'feed';
    let best = from, most = -Infinity;
    for (const name of panel.names) {
      const pyramid = this.pyramid(name);
      for (const index of pyramid.extremes(from, to)) {
        const size = lowest ? -pyramid.values[index] : Math.abs(pyramid.values[index]);
        if (size > most) [best, most] = [index, size];
      }
    }
    this.run.setSample(best);
  }

  zoomToSelection(plot) {
    const { left, width } = plot.select;
    if (width < 4) return;
    this.zoom([plot.posToVal(left, 'x'), plot.posToVal(left + width, 'x')]);
    plot.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
  }

  zoomAbout(centre, factor) { this.zoom(this.range.map((edge) => centre + factor * (edge - centre))); }

  zoom([least, greatest]) {
    const room = Math.max(greatest - least, 0.004);
    this.range = [Math.max(least, 0), Math.min(Math.max(least, 0) + room, this.run.end)];
    this.refresh();
  }

  /** Makes a moment visible without changing the width of the window. */
  reveal(time) {
    const [least, greatest] = this.range;
    if (time >= least && time <= greatest) return;
    const half = 0.5 * (greatest - least);
    this.zoom([time - half, time + half]);
  }

  refresh() {
    for (const { plot, names } of this.panels)
      plot.setData(curvesFor(this.run.times, names.map((name) => this.pyramid(name)), this.range[0], this.range[1], Math.max(plot.over.clientWidth, 300)));
    this.markNow();
  }

  markNow() {
    const [least, greatest] = this.range;
    const share = (this.run.time - least) / (greatest - least);
    for (const { marker } of this.panels) {
      marker.style.display = share < 0 || share > 1 ? 'none' : '';
      marker.style.left = `${100 * share}%`;
    }
  }

  resize() {
    const width = Math.max(this.host.clientWidth, 240);
    for (const { plot } of this.panels) if (plot.width !== width) plot.setSize({ width, height: panelHeight });
    this.refresh();
  }
}
