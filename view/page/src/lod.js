// Level of detail: a curve of a million samples as what a thousand pixel columns can show, peaks kept.
const block = 64;

/** Least and greatest value of every block of samples, made once a column. */
export class PeakPyramid {
  constructor(values) {
    this.values = values;
    const blocks = Math.ceil(values.length / block);
    this.least = new Int32Array(blocks);
    this.greatest = new Int32Array(blocks);
    for (let b = 0; b < blocks; ++b) [this.least[b], this.greatest[b]] = this.scan(b * block, Math.min((b + 1) * block, values.length));
  }

  scan(from, to) {
    const { values } = this;
    let least = from, greatest = from;
    for (let i = from + 1; i < to; ++i) {
      if (values[i] < values[least]) least = i;
      if (values[i] > values[greatest]) greatest = i;
    }
    return [least, greatest];
  }

  /** Samples with the least and the greatest value in [from, to), from < to. */
  extremes(from, to) {
    const first = Math.ceil(from / block), last = Math.floor(to / block);
    if (first >= last) return this.scan(from, to);
    const { values } = this;
    let [least, greatest] = from < first * block ? this.scan(from, first * block) : [this.least[first], this.greatest[first]];
    const take = (low, high) => {
      if (values[low] < values[least]) least = low;
      if (values[high] > values[greatest]) greatest = high;
    };
    for (let b = first; b < last; ++b) take(this.least[b], this.greatest[b]);
    if (last * block < to) take(...this.scan(last * block, to));
    return [least, greatest];
  }
}

/** First index with values[index] >= wanted, in a rising column. */
export function lowerBound(values, wanted) {
  let low = 0, high = values.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (values[middle] < wanted) low = middle + 1;
    else high = middle;
  }
  return low;
}

/**
 * Curves over a shared x for `columns` pixel columns between least and greatest x: every sample when they are few, else two
 * points a column, the least and the greatest value in the order in which they come. Samples just outside close the curve.
 */
export function curvesFor(x, pyramids, least, greatest, columns) {
  const from = Math.max(lowerBound(x, least) - 1, 0), to = Math.min(lowerBound(x, greatest) + 1, x.length);
  if (to - from <= 4 * columns) return [x.subarray(from, to), ...pyramids.map((pyramid) => pyramid.values.subarray(from, to))];
  const xs = [], curves = pyramids.map(() => []);
  for (let column = 0, start = from; column < columns && start < to; ++column) {
    const edge = least + ((column + 1) * (greatest - least)) / columns;
    const stop = column + 1 === columns ? to : Math.min(lowerBound(x, edge), to);
    if (stop <= start) continue;
    xs.push(x[start], 0.5 * (x[start] + x[stop - 1]));
    pyramids.forEach((pyramid, i) => {
      const [low, high] = pyramid.extremes(start, stop);
      const values = pyramid.values;
      if (low < high) curves[i].push(values[low], values[high]);
      else curves[i].push(values[high], values[low]);
    });
    start = stop;
  }
  return [xs, ...curves];
}

/**
 * Samples of a polyline that a picture needs: those left out lie within `tolerance` of the chord between kept neighbours (checked against at
 * most 64 of them). A sample whose `group` differs from the one before is kept.
 */
export function chordSamples(points, count, tolerance, group) {
  const kept = [];
  if (count === 0) return Int32Array.from(kept);
  kept.push(0);
  let anchor = 0;
  for (let i = 1; i < count; ++i) {
    const breaks = i + 1 === count || group(i) !== group(i - 1) || group(i) !== group(i + 1) || i - anchor >= 64;
    if (breaks || !withinChord(points, anchor, i + 1, tolerance)) {
      kept.push(i);
      anchor = i;
    }
  }
  return Int32Array.from(kept);
}

function withinChord(points, from, to, tolerance) {
  const ax = points[3 * from], ay = points[3 * from + 1], az = points[3 * from + 2];
  const dx = points[3 * to] - ax, dy = points[3 * to + 1] - ay, dz = points[3 * to + 2] - az;
  const lengthSquared = dx * dx + dy * dy + dz * dz;
  for (let i = from + 1; i < to; ++i) {
    const px = points[3 * i] - ax, py = points[3 * i + 1] - ay, pz = points[3 * i + 2] - az;
    const along = lengthSquared > 0 ? Math.min(Math.max((px * dx + py * dy + pz * dz) / lengthSquared, 0), 1) : 0;
    const ex = px - along * dx, ey = py - along * dy, ez = pz - along * dz;
    if (ex * ex + ey * ey + ez * ez > tolerance * tolerance) return false;
  }
  return true;
}
