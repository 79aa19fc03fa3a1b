// What is in the page of a repair: src/output/page/repair.cpp writes it. Coordinates are relative to
// the middle of the drawing, y downwards, in doubles.

import { Arrays, unpacked } from "./arrays";
import { Box, emptyBox, grow } from "./box";
import type { ArrayEntry, Place } from "./report";

/// In the order of LineFate in src/output/svg/repair_parts.hpp.
export const fates = ["kept", "added", "removed", "moved-from", "moved-to", "virtual"] as const;
export type Fate = (typeof fates)[number];
/// What becomes of faces, and those that have no more than a virtual border.
export const faceKinds = ["closed", "split", "joined", "opened", "virtual"] as const;

/// A row of one of the lists.
export interface Item {
  number: number;
  kind: string;
  where: Place;
  title?: string;
  message?: string; // what it did to rooms, or why it was refused
  at?: string;
  size?: number;
  squared_size?: string;
  area?: number;
  element?: string;
  elements?: string[];
  edits?: number[];
  is_after?: boolean;
  is_other?: boolean; // which of two colours tells it from its neighbours
}

interface Content {
  line: string;
  tolerances: string;
  reasons: string[];
  anchored: number;
  y_up: boolean;
  edits: Item[];
  refused: Item[];
  faces: Item[];
  arrays: ArrayEntry[];
}

export type Ring = [number, number][];

export interface Face {
  item: Item;
  rings: Ring[];
  box: Box;
}

/// Ends of lines, four numbers each.
export type Ends = Float64Array;

export interface RepairData {
  content: Content;
  box: Box;
  lines: Record<Fate, Ends>;
  faces: Face[];
  before: Ends[]; // per edit
  after: Ends[];
  local(place: [number, number]): [number, number];
  place(x: number, y: number): [number, number];
}

export async function readRepair(report: string, packed: string): Promise<RepairData> {
  const content = (await (await unpacked(report)).json()) as Content;
  const arrays = await Arrays.read(packed, content.arrays);
  const whole = boxOf(arrays);
  const origin = [(whole.left + whole.right) / 2, (whole.top + whole.bottom) / 2];
  const up = content.y_up ? -1 : 1;
  const half = [(whole.right - whole.left) / 2, (whole.bottom - whole.top) / 2];
  const local = ([x, y]: [number, number]): [number, number] => [x - origin[0], (y - origin[1]) * up];
  const place = (x: number, y: number): [number, number] => [x + origin[0], y * up + origin[1]];
  const ends = (name: string): Ends => {
    const [ax, ay, bx, by] = ["ax", "ay", "bx", "by"].map((end) => arrays.f64(`${name}.${end}`));
    const all = new Float64Array(4 * ax.length);
    for (let i = 0; i < ax.length; ++i)
      all.set([...local([ax[i], ay[i]]), ...local([bx[i], by[i]])], 4 * i);
    return all;
  };
  return {
    content,
    box: { left: -half[0], right: half[0], top: -half[1], bottom: half[1] },
    lines: linesByFate(ends("lines"), arrays.u32("lines.fate")),
    faces: facesOf(content.faces, arrays, local),
    ...linesOfEdits(ends("edits"), arrays),
    local,
    place,
  };
}

function boxOf(arrays: Arrays): Box {
  const box = emptyBox();
  for (const end of ["a", "b"]) {
    const [x, y] = [arrays.f64(`lines.${end}x`), arrays.f64(`lines.${end}y`)];
    for (let i = 0; i < x.length; ++i) grow(box, x[i], y[i]);
  }
  if (box.left > box.right) grow(box, 0, 0);
  return box;
}

function linesByFate(ends: Ends, fateOf: Uint32Array): Record<Fate, Ends> {
  const lines = {} as Record<Fate, Ends>;
  fates.forEach((fate, f) => {
    const some: number[] = [];
    for (let i = 0; i < fateOf.length; ++i)
      if (fateOf[i] === f) some.push(...ends.subarray(4 * i, 4 * i + 4));
    lines[fate] = new Float64Array(some);
  });
  return lines;
}

function linesOfEdits(ends: Ends, arrays: Arrays): { before: Ends[]; after: Ends[] } {
  const counts = { before: arrays.u32("edits.before"), after: arrays.u32("edits.after") };
  const lines = { before: [] as Ends[], after: [] as Ends[] };
  let begin = 0;
  for (let e = 0; e < counts.before.length; ++e)
    for (const side of ["before", "after"] as const) {
      const end = begin + 4 * counts[side][e];
      lines[side].push(ends.subarray(begin, end));
      begin = end;
    }
  return lines;
}

function facesOf(items: Item[], arrays: Arrays, local: RepairData["local"]): Face[] {
  const [x, y] = [arrays.f64("faces.x"), arrays.f64("faces.y")];
  const [ringsOf, points] = [arrays.u32("faces.rings"), arrays.u32("faces.points")];
  let ring = 0;
  let point = 0;
  return items.map((item, f) => {
    const box = emptyBox();
    const rings: Ring[] = [];
    for (const last = ring + ringsOf[f]; ring < last; ++ring) {
      const places: Ring = [];
      for (const end = point + points[ring]; point < end; ++point) {
        const at = local([x[point], y[point]]);
        grow(box, ...at);
        places.push(at);
      }
      rings.push(places);
    }
    return { item, rings, box };
  });
}

export function isInside({ rings, box }: Face, x: number, y: number): boolean {
  if (x < box.left || x > box.right || y < box.top || y > box.bottom) return false;
  let inside = false;
  for (const ring of rings)
    ring.forEach(([bx, by], i) => {
      const [ax, ay] = ring[(i + ring.length - 1) % ring.length];
      if (ay > y !== by > y && x < ax + ((y - ay) / (by - ay)) * (bx - ax)) inside = !inside;
    });
  return inside;
}
