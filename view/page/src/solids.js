// Meshes and tool as three.js objects.
import * as THREE from 'three';
import { diverging, ofHex } from './colour.js';

export function meshGeometry(columns, name) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(columns.points(name), 3));
  geometry.setIndex(new THREE.BufferAttribute(new Uint32Array(columns.integers(`${name}.corners`)), 1));
  return geometry;
}

/** Box-like bodies are shown with flat faces, surfaces smooth. */
export function solid(columns, name, colour, options = {}) {
  let geometry = meshGeometry(columns, name);
  if (options.flat) geometry = geometry.toNonIndexed();
  geometry.computeVertexNormals();
  const material = new THREE.MeshLambertMaterial({ color: new THREE.Color(colour), side: THREE.DoubleSide,
    polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 });
  return new THREE.Mesh(geometry, material);
}

/** Colours of the surface's vertices by deviation, and the value at the ends of the scale. */
export function deviationColours(columns) {
  const deviation = columns.values('surface.deviation'), reached = columns.integers('surface.reached');
  const magnitudes = Array.from(deviation.filter((_, i) => reached[i] === 1), Math.abs).sort((a, b) => a - b);
  const greatest = magnitudes.length ? magnitudes[Math.floor(0.998 * (magnitudes.length - 1))] : 0;
  const range = greatest > 0 ? greatest : 1;
  const colours = new Float32Array(3 * deviation.length);
  for (let i = 0; i < deviation.length; ++i) {
    const colour = reached[i] ? diverging(deviation[i] / range) : [0.13, 0.13, 0.13];
    colours.set(colour.map(linear), 3 * i);
  }
  return { colours, range };
}

/** sRGB share to the linear light that the renderer computes in. */
export function linear(value) { return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4; }

/** The tool as bodies of revolution about z: cutter, shank, holder. */
export function toolBody(tool) {
  const group = new THREE.Group();
  const parts = [[0, tool.flutes_end_mm, '#e0a526'], [tool.flutes_end_mm, tool.holder_start_mm, '#b9c0c7'], [tool.holder_start_mm, Infinity, '#58616b']];
  for (const [from, to, colour] of parts) {
    const points = slice(tool.profile, from, to);
    if (points.length < 2) continue;
    const geometry = new THREE.LatheGeometry(points.map(([z, radius]) => new THREE.Vector2(radius, z)), 48).rotateX(Math.PI / 2);
    const [r, g, b] = ofHex(colour).map(linear);
    group.add(new THREE.Mesh(geometry, new THREE.MeshLambertMaterial({ color: new THREE.Color(r, g, b), side: THREE.DoubleSide })));
  }
  return group;
}

/** The profile between two heights, with points put in where it is cut and closed to the axis at the top. */
function slice(profile, from, to) {
  const out = [];
  for (let i = 0; i < profile.length; ++i) {
    const [z, radius] = profile[i];
    if (i > 0) {
      const [z0, r0] = profile[i - 1];
      for (const cut of [from, to])
        if (z0 < cut && cut < z) out.push([cut, r0 + ((cut - z0) / (z - z0)) * (radius - r0)]);
    }
    if (z >= from && z <= to) out.push([z, radius]);
  }
  if (out.length) out.push([out.at(-1)[0], 0]);
  return out;
}
