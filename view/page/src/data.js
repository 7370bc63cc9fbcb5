// Opens the parts of the page's data. The layout is that of view/packed_data.hpp.

function bytesOfBase64(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const letters = atob(text);
  const bytes = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; ++i) bytes[i] = letters.charCodeAt(i);
  return bytes;
}

async function inflated(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** The bytes of a packed part, or null when the page has none of that name. */
export async function packedPart(id) {
  const element = document.getElementById(`data-${id}`);
  if (!element) return null;
  const bytes = bytesOfBase64(element.textContent);
  element.remove();
  return inflated(bytes);
}

export function jsonPart(id) {
  return JSON.parse(document.getElementById(`data-${id}`).textContent);
}

/** Columns by name, each decoded when it is first asked for. */
export class Columns {
  constructor(bytes) {
    const headerLength = new DataView(bytes.buffer, bytes.byteOffset, 4).getUint32(0, true);
    const header = JSON.parse(new TextDecoder().decode(bytes.subarray(4, 4 + headerLength)));
    this.bytes = bytes;
    this.decoded = new Map();
    this.entries = new Map();
    let offset = 4 + headerLength;
    for (const [name, entry] of Object.entries(header)) {
      this.entries.set(name, { ...entry, offset });
      offset += 4 * entry.count;
    }
  }

  has(name) { return this.entries.has(name); }
  count(name) { return this.entries.get(name)?.count ?? 0; }

  /** Whole numbers of steps. */
  steps(name) {
    const { count, order, offset } = this.entries.get(name);
    const bytes = this.bytes;
    const out = new Int32Array(count);
    const [b1, b2, b3] = [offset + count, offset + 2 * count, offset + 3 * count];
    for (let i = 0; i < count; ++i) {
      const coded = bytes[offset + i] | (bytes[b1 + i] << 8) | (bytes[b2 + i] << 16) | (bytes[b3 + i] << 24);
      out[i] = (coded >>> 1) ^ -(coded & 1);
    }
    for (let pass = 0; pass < order; ++pass)
      for (let i = 1; i < count; ++i) out[i] = (out[i] + out[i - 1]) | 0;
    return out;
  }

  integers(name) { return this.kept(name, () => this.steps(name)); }

  values(name) {
    return this.kept(name, () => {
      const steps = this.steps(name);
      const { step } = this.entries.get(name);
      const out = name === 'time' ? new Float64Array(steps.length) : new Float32Array(steps.length);
      for (let i = 0; i < steps.length; ++i) out[i] = steps[i] * step;
      return out;
    });
  }

  /** x y z x y z ... of the columns name.x, name.y, name.z. */
  points(name) {
    return this.kept(`${name}.xyz`, () => {
      const parts = ['x', 'y', 'z'].map((axis) => this.steps(`${name}.${axis}`));
      const { step } = this.entries.get(`${name}.x`);
      const out = new Float32Array(3 * parts[0].length);
      for (let axis = 0; axis < 3; ++axis)
        for (let i = 0; i < parts[axis].length; ++i) out[3 * i + axis] = parts[axis][i] * step;
      return out;
    });
  }

  kept(key, make) {
    if (!this.decoded.has(key)) this.decoded.set(key, make());
    return this.decoded.get(key);
  }
}
