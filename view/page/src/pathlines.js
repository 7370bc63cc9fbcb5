// The path as coloured lines: what the tool tip did, and what was planned on the surface.
import * as THREE from 'three';
import { ofHex, sequential } from './colour.js';
import { chordSamples } from './lod.js';
import { linear } from './solids.js';
import { limitColours, limitNames, short } from './words.js';

const rapidColour = [0.62, 0.62, 0.62], linkColour = [0.85, 0.1, 0.1];

function lineObject(positions, colours, opacity) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(positions, 3));
  geometry.setAttribute('color', new THREE.BufferAttribute(colours, 3));
  return new THREE.Line(geometry, new THREE.LineBasicMaterial({ vertexColors: true, transparent: opacity < 1, opacity }));
}

/** What can colour the path: name, legend, colour of sample i. */
function colourings(run, machine) {
  const { trace } = run;
  const motion = trace.integers('motion');
  const cuttingMost = (column) => {
    let most = 0;
    for (let i = 0; i < run.count; ++i) if (motion[i] !== 2 && column[i] > most) most = column[i];
    return most || 1;
  };
  const feed = trace.values('feed'), feedMost = cuttingMost(feed), limits = trace.integers('limit');
  const list = [
    { id: 'feed', name: 'feed', bar: ['feed of the tool tip, mm/min', 0, feedMost], at: (i) => sequential(feed[i] / feedMost) },
    { id: 'limit', name: 'what holds the speed down', keys: usedLimits(limits), at: (i) => ofHex(limitColours[limits[i]]) },
    { id: 'time', name: 'time', bar: ['time, s', 0, run.end], at: (i) => sequential(run.times[i] / run.end) },
  ];
  for (const axis of machine?.axes ?? []) {
    if (!axis.rotary) continue;
    const speed = trace.values(`velocity.${axis.letter}`);
    list.push({ id: `speed-${axis.letter}`, name: `speed of ${axis.letter}`, bar: [`|speed of ${axis.letter}|, share of its limit, %`, 0, 100],
      at: (i) => sequential(Math.abs(speed[i]) / axis.velocity_max) });
  }
  return list;
}

function usedLimits(limits) {
  const used = new Set(limits);
  return limitNames.map((name, i) => [name, limitColours[i], used.has(i)]).filter(([, , shown]) => shown);
}

/** The tip's path: a bright line up to now, a faint one for what comes. */
export class TipPath {
  constructor(run, machine, size) {
    this.run = run;
    const points = run.trace.points('tip');
    const motion = run.trace.integers('motion');
    this.samples = chordSamples(points, run.count, size / 4000, (i) => motion[i]);
    this.positions = new Float32Array(3 * this.samples.length);
    this.samples.forEach((sample, k) => this.positions.set(points.subarray(3 * sample, 3 * sample + 3), 3 * k));
    this.colourings = colourings(run, machine);
    this.colours = new Float32Array(this.positions.length);
    this.done = lineObject(this.positions, this.colours, 1);
    this.ahead = lineObject(this.positions, this.colours, 0.22);
    this.ahead.geometry = this.done.geometry.clone();
    this.group = new THREE.Group().add(this.done, this.ahead);
  }

  colourBy(id) {
    const colouring = this.colourings.find((c) => c.id === id) ?? this.colourings[0];
    const motion = this.run.trace.integers('motion');
    this.samples.forEach((sample, k) => {
      const colour = motion[sample] === 2 ? rapidColour : colouring.at(sample);
      for (let c = 0; c < 3; ++c) this.colours[3 * k + c] = linear(colour[c]);
    });
    for (const line of [this.done, this.ahead]) {
      line.geometry.getAttribute('color').copyArray(this.colours);
      line.geometry.getAttribute('color').needsUpdate = true;
    }
    return colouring;
  }

  /** How many points of the line lie at or before a sample. */
  pointsUpTo(sample) {
    let low = 0, high = this.samples.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.samples[middle] <= sample) low = middle + 1;
      else high = middle;
    }
    return low;
  }

  showUpTo(sample) {
    const whole = sample === 0;
    const count = whole ? this.samples.length : this.pointsUpTo(sample);
    this.done.geometry.setDrawRange(0, count);
    this.ahead.geometry.setDrawRange(Math.max(count - 1, 0), this.samples.length - count + 1);
    this.ahead.visible = !whole && count < this.samples.length;
  }
}

/** The planned path on the surface, coloured by turn or tilt; nothing when nothing was planned. */
export class PlannedPath {
  constructor(columns) {
    const all = columns.points('plan.contact'), move = columns.integers('plan.move');
    const kept = [];
    for (let i = 0; i < move.length; ++i) if (move[i] === 2 || move[i] === 3) kept.push(i);
    this.kept = kept;
    this.move = move;
    this.columns = columns;
    const positions = new Float32Array(3 * kept.length);
    kept.forEach((i, k) => positions.set(all.subarray(3 * i, 3 * i + 3), 3 * k));
    this.line = lineObject(positions, new Float32Array(positions.length), 1);
    this.line.visible = false;
  }

  colourBy(quantity) {
    const values = this.columns.values(`plan.${quantity}`);
    let least = Infinity, greatest = -Infinity;
    for (const i of this.kept) {
      least = Math.min(least, values[i]);
      greatest = Math.max(greatest, values[i]);
    }
    if (quantity === 'turn') least = 0;
    const span = greatest > least ? greatest - least : 1;
    const colours = this.line.geometry.getAttribute('color');
    this.kept.forEach((i, k) => {
      const colour = this.move[i] === 3 ? linkColour : sequential((values[i] - least) / span);
      colours.setXYZ(k, ...colour.map(linear));
    });
    colours.needsUpdate = true;
    return { bar: [quantity === 'turn' ? 'turn of the spiral' : 'tilt of the tool from the surface normal, deg', least, greatest] };
  }
}

/** Tool axes as strokes from the tip, evenly spread over the cutting samples. */
export function axisStrokes(run, length, wanted = 1500) {
  const tips = run.trace.points('tip'), axes = run.trace.points('axis'), motion = run.trace.integers('motion');
  const cutting = [];
  for (let i = 0; i < run.count; ++i) if (motion[i] === 1) cutting.push(i);
  const stride = Math.max(1, Math.floor(cutting.length / wanted));
  const positions = [];
  for (let k = 0; k < cutting.length; k += stride)
    for (const along of [0, length]) for (let c = 0; c < 3; ++c) positions.push(tips[3 * cutting[k] + c] + along * axes[3 * cutting[k] + c]);
  const geometry = new THREE.BufferGeometry().setAttribute('position', new THREE.Float32BufferAttribute(positions, 3));
  return new THREE.LineSegments(geometry, new THREE.LineBasicMaterial({ color: 0x7a2a8a, transparent: true, opacity: 0.55 }));
}

export const barTicks = ([, least, greatest]) => [least, 0.5 * (least + greatest), greatest].map((value) => short(value, 3));
