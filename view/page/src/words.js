// Every word that the page shows about a quantity, and how numbers become text.

export const limitNames = ['programmed feed', 'axis velocity', 'axis acceleration', 'axis jerk', 'corner', 'block time', 'look-ahead', 'rapid', 'dwell', 'stop'];
export const limitColours = ['#009e73', '#0072b2', '#d55e00', '#cc79a7', '#e69f00', '#56b4e9', '#8a6d3b', '#9a9a9a', '#555555', '#000000'];

export const causeNames = {
  feed: 'at the programmed feed', acceleration: 'speeding up or slowing down', corner: 'slowed at corners', block_time: 'blocks too short for the control',
  rotary_limit: 'a rotary axis at its limit', rapid: 'rapid moves in the air', dwell: 'standing still', axis_velocity: 'an axis at its top speed',
};

/** Table 2 of [Sun2016], column by column: key in the report, name, what it means. */
export const tableTwo = [
  ['path.rapid_traversals', 'Rapid traversals', 'moves in the air from one place to another'],
  ['path.liftings', 'Liftings', 'times the tool leaves the surface'],
  ['path.linkings', 'Linkings', 'moves from one pass to the next along the surface'],
  ['path.sharp_corners', 'Sharp corners', 'places where the path turns abruptly and the machine must slow down'],
  ['machining.uncut', 'Uncut', 'whether material higher than the allowed ridge is left'],
  ['run.actual_feed_mm_min', 'Actual feed, mm/min', 'length of the cutting moves over the time they really took'],
  ['run.feed_loss_percent', 'Loss of feed, %', 'actual against programmed feed; 0 is perfect'],
];

export const kindWords = {
  collision: 'two bodies touch', gouge: 'the cutter went below the surface', limit: 'an axis is asked for more than it can', travel: 'an axis leaves its travel',
  uncut: 'material is left standing', tilt: 'the tool leans too far', disagreement: 'two independent checks disagree', clearance: 'bodies come closer than allowed',
};

export function fixed(value, digits) {
  const text = value.toFixed(digits);
  return Number(text) === 0 ? (0).toFixed(digits) : text;
}

/** About `digits` significant digits, grouped by thousands, never an exponent. */
export function short(value, digits = 4) {
  if (value === null || value === undefined || !Number.isFinite(value)) return '–';
  if (value === 0) return '0';
  const magnitude = Math.floor(Math.log10(Math.abs(value)));
  const decimals = Math.min(Math.max(digits - 1 - magnitude, 0), 6);
  return Number(value.toFixed(decimals)).toLocaleString('en-US', { maximumFractionDigits: decimals });
}

export function timeText(seconds) {
  const tenths = Math.round(seconds * 10);
  const minutes = Math.floor(tenths / 600);
  const rest = fixed((tenths - 600 * minutes) / 10, 1);
  if (minutes === 0) return `${rest} s`;
  if (minutes < 60) return `${minutes} min ${rest} s`;
  return `${Math.floor(minutes / 60)} h ${minutes % 60} min`;
}

export const clock = (seconds) => `${Math.floor(seconds / 60)}:${fixed(seconds % 60, 2).padStart(5, '0')}`;

/** report["a"]["b"] of 'a.b', or undefined. */
export const pick = (object, path) => path.split('.').reduce((value, key) => value?.[key], object);

/** element('p.note', {title: 'x'}, 'text', child, ...) */
export function element(spec, attributes = {}, ...children) {
  const [tag, ...classes] = spec.split('.');
  const node = document.createElement(tag || 'div');
  if (classes.length) node.className = classes.join(' ');
  for (const [key, value] of Object.entries(attributes)) {
    if (key.startsWith('on')) node.addEventListener(key.slice(2), value);
    else if (value !== undefined && value !== false) node.setAttribute(key, value === true ? '' : value);
  }
  node.append(...children.filter((child) => child !== null && child !== undefined));
  return node;
}
