// Reads back what src/output/page/arrays.cpp packed.

import type { ArrayEntry } from "./report";

export type Numbers = Uint32Array | Float64Array;

function bytesOfBase64(text: string): Uint8Array {
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

/// The bytes that `packed` of src/output/page/arrays.cpp compressed.
export async function unpacked(text: string): Promise<Response> {
  const stream = new Blob([bytesOfBase64(text) as BlobPart])
    .stream()
    .pipeThrough(new DecompressionStream("deflate"));
  return new Response(stream);
}

function integers(planes: Uint8Array, count: number): Uint32Array {
  const values = new Uint32Array(count);
  let previous = 0;
  for (let i = 0; i < count; ++i) {
    const zigzag =
      planes[i] |
      (planes[count + i] << 8) |
      (planes[2 * count + i] << 16) |
      (planes[3 * count + i] << 24);
    previous = (previous + ((zigzag >>> 1) ^ -(zigzag & 1))) >>> 0;
    values[i] = previous;
  }
  return values;
}

function doubles(planes: Uint8Array, count: number): Float64Array {
  const values = new Float64Array(count);
  const bytes = new Uint8Array(values.buffer); // little-endian, as everywhere that browsers run
  for (let plane = 0; plane < 8; ++plane)
    for (let i = 0; i < count; ++i) bytes[8 * i + plane] = planes[plane * count + i];
  return values;
}

/// Turns differences of bits into values.
function addReference(values: Float64Array, others: Float64Array, index: Uint32Array): void {
  const words = new Uint32Array(values.buffer);
  const otherWords = new Uint32Array(others.buffer);
  for (let i = 0; i < values.length; ++i) {
    words[2 * i] ^= otherWords[2 * index[i]];
    words[2 * i + 1] ^= otherWords[2 * index[i] + 1];
  }
}

export class Arrays {
  private readonly byName = new Map<string, Numbers>();

  static async read(text: string, entries: ArrayEntry[]): Promise<Arrays> {
    const bytes = new Uint8Array(await (await unpacked(text)).arrayBuffer());
    const arrays = new Arrays();
    let begin = 0;
    for (const entry of entries) {
      const end = begin + entry.count * (entry.type === "u32" ? 4 : 8);
      arrays.byName.set(entry.name, arrays.decode(entry, bytes.subarray(begin, end)));
      begin = end;
    }
    return arrays;
  }

  u32(name: string): Uint32Array {
    return this.get(name) as Uint32Array;
  }

  f64(name: string): Float64Array {
    return this.get(name) as Float64Array;
  }

  private decode(entry: ArrayEntry, planes: Uint8Array): Numbers {
    if (entry.type === "u32") return integers(planes, entry.count);
    const values = doubles(planes, entry.count);
    if (entry.reference) addReference(values, this.f64(entry.reference), this.u32(entry.index));
    return values;
  }

  private get(name: string): Numbers {
    const values = this.byName.get(name);
    if (!values) throw new Error(`the page has no array ${name}`);
    return values;
  }
}
