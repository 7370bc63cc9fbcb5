// The run being looked at: where in time it stands, and who wants to know.

export class Run {
  constructor(trace) {
    this.trace = trace;
    this.times = trace.values('time');
    this.count = this.times.length;
    this.end = this.count ? this.times[this.count - 1] : 0;
    this.time = 0;
    this.listeners = [];
  }

  onTime(listener) { this.listeners.push(listener); }

  setTime(time) {
    this.time = Math.min(Math.max(time, 0), this.end);
    for (const listener of this.listeners) listener(this.time);
  }

  setSample(index) { this.setTime(this.times[index]); }

  /** Times of the first and last cutting sample; the whole run when nothing cuts. */
  cuttingRange() {
    const motion = this.trace.integers('motion');
    const first = motion.indexOf(1), last = motion.lastIndexOf(1);
    return last > first ? [this.times[first], this.times[last]] : [0, this.end];
  }

  /** The last sample at or before a time. */
  sampleAt(time) {
    let low = 0, high = this.count - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.times[middle] <= time) low = middle;
      else high = middle - 1;
    }
    return low;
  }

  /** Sample and share of the way to the next one. */
  place(time) {
    const index = this.sampleAt(time);
    const next = Math.min(index + 1, this.count - 1);
    const span = this.times[next] - this.times[index];
    return { index, next, share: span > 0 ? (time - this.times[index]) / span : 0 };
  }

  value(name, { index, next, share }) {
    const column = this.trace.values(name);
    return column[index] + share * (column[next] - column[index]);
  }

  /** Time of the first sample that a line of the program caused, or null. */
  timeOfLine(line) {
    const lines = this.trace.integers('line');
    const index = lines.indexOf(line);
    return index < 0 ? null : this.times[index];
  }
}
