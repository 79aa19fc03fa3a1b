// Reads back what src/report/page_arrays.cpp packed.

import type { ArrayEntry } from "./report";

export type Numbers = Uint32Array | Float64Array;

function bytesOfBase64(text: string): Uint8Array {
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

async function inflated(bytes: Uint8Array): Promise<Uint8Array> {
  const stream = new Blob([bytes as BlobPart])
    .stream()
    .pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
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

function doubles(planes: Uint8Array, count: number, reference?: Float64Array): Float64Array {
  const values = new Float64Array(count);
  const bytes = new Uint8Array(values.buffer); // little-endian, as everywhere that browsers run
  for (let plane = 0; plane < 8; ++plane)
    for (let i = 0; i < count; ++i) bytes[8 * i + plane] = planes[plane * count + i];
  if (reference) {
    const others = new Uint8Array(reference.buffer);
    for (let i = 0; i < bytes.length; ++i) bytes[i] ^= others[i];
  }
  return values;
}

export class Arrays {
  private readonly byName = new Map<string, Numbers>();

  static async read(text: string, entries: ArrayEntry[]): Promise<Arrays> {
    const bytes = await inflated(bytesOfBase64(text));
    const arrays = new Arrays();
    let begin = 0;
    for (const entry of entries) {
      const end = begin + entry.count * (entry.type === "u32" ? 4 : 8);
      const planes = bytes.subarray(begin, end);
      arrays.byName.set(
        entry.name,
        entry.type === "u32"
          ? integers(planes, entry.count)
          : doubles(planes, entry.count, entry.reference ? arrays.f64(entry.reference) : undefined),
      );
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

  private get(name: string): Numbers {
    const values = this.byName.get(name);
    if (!values) throw new Error(`the page has no array ${name}`);
    return values;
  }
}
