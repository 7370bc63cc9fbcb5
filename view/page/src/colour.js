// Colours for values, readable by colour-blind people. The same maps as view/colour_map.cpp.
const viridis = [[0.267, 0.005, 0.329], [0.283, 0.141, 0.458], [0.254, 0.265, 0.530], [0.207, 0.372, 0.553], [0.164, 0.471, 0.558],
  [0.128, 0.567, 0.551], [0.135, 0.659, 0.518], [0.267, 0.749, 0.441], [0.478, 0.821, 0.318], [0.741, 0.873, 0.150], [0.993, 0.906, 0.144]];
const blueToBrown = [[0.10, 0.26, 0.58], [0.45, 0.62, 0.85], [0.90, 0.90, 0.88], [0.90, 0.60, 0.35], [0.60, 0.18, 0.05]];

function between(samples, share) {
  const place = Math.min(Math.max(share, 0), 1) * (samples.length - 1);
  const index = Math.min(Math.floor(place), samples.length - 2);
  const part = place - index;
  return samples[index].map((value, i) => value + part * (samples[index + 1][i] - value));
}

export const sequential = (share) => between(viridis, share);
export const diverging = (share) => between(blueToBrown, 0.5 * (share + 1));

export function ofHex(hex) {
  const value = parseInt(hex.slice(1), 16);
  return [(value >> 16) / 255, ((value >> 8) & 255) / 255, (value & 255) / 255];
}

export const css = (colour) => `rgb(${colour.map((value) => Math.round(255 * value)).join(' ')})`;
