// The drawing: three complexes, the input's segments and their sources. Coordinates are relative to
// the middle of the drawing, y downwards, in doubles.

import { Arrays } from "./arrays";
import { Box, emptyBox, grow } from "./box";
import { ComplexName, complexNames, Report } from "./report";

const none = 0xffffffff;

/// A list of lists, stored flat.
export class Lists {
  readonly begin: Uint32Array;
  constructor(
    sizes: Uint32Array,
    readonly values: Uint32Array,
  ) {
    this.begin = new Uint32Array(sizes.length + 1);
    for (let i = 0; i < sizes.length; ++i) this.begin[i + 1] = this.begin[i] + sizes[i];
  }
  get size(): number {
    return this.begin.length - 1;
  }
  of(i: number): Uint32Array {
    return i < this.size ? this.values.subarray(this.begin[i], this.begin[i + 1]) : this.values.subarray(0, 0);
  }
}

export interface Incidences {
  tail: Uint32Array;
  head: Uint32Array;
  cycles: Lists; // of halfedges: 2 e along edge e, 2 e + 1 against it
  faceOuter: Uint32Array;
  faceHoles: Lists;
  faceDepth: Uint32Array;
  isolated: Uint32Array;
  edgeSegments: Lists;
}

function readIncidences(arrays: Arrays, name: string): Incidences {
  const lists = (list: string) =>
    new Lists(arrays.u32(`${name}.${list}_sizes`), arrays.u32(`${name}.${list}`));
  return {
    tail: arrays.u32(`${name}.tail`),
    head: arrays.u32(`${name}.head`),
    cycles: lists("cycles"),
    faceOuter: arrays.u32(`${name}.face_outer`),
    faceHoles: lists("face_holes"),
    faceDepth: arrays.u32(`${name}.face_depth`),
    isolated: arrays.u32(`${name}.isolated_vertices`),
    edgeSegments: lists("edge_segments"),
  };
}

export class Complex {
  private boxes?: Float64Array;

  constructor(
    readonly name: ComplexName,
    readonly x: Float64Array,
    readonly y: Float64Array,
    readonly cells: Incidences,
    readonly area: Float64Array,
  ) {}

  get faceCount(): number {
    return this.cells.faceOuter.length;
  }

  originOf(halfedge: number): number {
    const edge = halfedge >>> 1;
    return halfedge & 1 ? this.cells.head[edge] : this.cells.tail[edge];
  }

  /// The vertices of a cycle, in its order.
  ring(cycle: number): Uint32Array {
    return this.cells.cycles.of(cycle).map((halfedge) => this.originOf(halfedge));
  }

  /// The cycles of a face, its outer boundary first.
  cyclesOf(face: number): number[] {
    const outer = this.cells.faceOuter[face];
    return [...(outer === none ? [] : [outer]), ...this.cells.faceHoles.of(face)];
  }

  /// Per face its box: left, top, right, bottom; empty for faces without outer boundary.
  faceBoxes(): Float64Array {
    if (this.boxes) return this.boxes;
    const boxes = new Float64Array(4 * this.faceCount);
    for (let face = 0; face < this.faceCount; ++face) {
      const box = emptyBox();
      const outer = this.cells.faceOuter[face];
      if (outer !== none) for (const h of this.cells.cycles.of(outer)) this.growBy(box, this.originOf(h));
      boxes.set([box.left, box.top, box.right, box.bottom], 4 * face);
    }
    return (this.boxes = boxes);
  }

  growBy(box: Box, vertex: number): void {
    grow(box, this.x[vertex], this.y[vertex]);
  }

  /// The input segments on the boundary of a face.
  segmentsAround(face: number): Set<number> {
    const segments = new Set<number>();
    for (const cycle of this.cyclesOf(face))
      for (const h of this.cells.cycles.of(cycle))
        for (const segment of this.cells.edgeSegments.of(h >>> 1)) segments.add(segment);
    return segments;
  }
}

/// Pairs of vertices of a complex, drawn as lines.
export interface Lines {
  complex: Complex;
  from: Uint32Array;
  to: Uint32Array;
}

export class Drawing {
  private constructor(
    readonly report: Report,
    private readonly arrays: Arrays,
    readonly complexes: Record<ComplexName, Complex>,
    readonly box: Box,
    private readonly origin: { x: number; y: number },
    private readonly ids: Map<number, string>,
  ) {}

  static async read(report: Report, text: string): Promise<Drawing> {
    const arrays = await Arrays.read(text, report.page.arrays);
    const box = emptyBox();
    for (const name of complexNames) {
      const x = arrays.f64(`${name}.x`);
      const y = arrays.f64(`${name}.y`);
      for (let i = 0; i < x.length; ++i) grow(box, x[i], y[i]);
    }
    if (box.left > box.right) grow(box, 0, 0);
    const origin = { x: (box.left + box.right) / 2, y: (box.top + box.bottom) / 2 };
    const up = report.page.y_up ? -1 : 1;
    const complexes = {} as Record<ComplexName, Complex>;
    for (const name of complexNames) {
      const same = report.page.same_incidences.includes(name);
      complexes[name] = new Complex(
        name,
        arrays.f64(`${name}.x`).map((x) => x - origin.x),
        arrays.f64(`${name}.y`).map((y) => (y - origin.y) * up),
        same ? complexes.authored.cells : readIncidences(arrays, name),
        arrays.f64(`${name}.area`),
      );
    }
    const half = { x: (box.right - box.left) / 2, y: (box.bottom - box.top) / 2 };
    const local = { left: -half.x, right: half.x, top: -half.y, bottom: half.y };
    return new Drawing(report, arrays, complexes, local, origin, new Map(report.page.ids));
  }

  /// From the drawing's coordinates to local ones, and back.
  local(place: [number, number]): [number, number] {
    return [place[0] - this.origin.x, (place[1] - this.origin.y) * (this.report.page.y_up ? -1 : 1)];
  }
  place(x: number, y: number): [number, number] {
    return [x + this.origin.x, y * (this.report.page.y_up ? -1 : 1) + this.origin.y];
  }

  edges(name: ComplexName): Lines {
    const complex = this.complexes[name];
    return { complex, from: complex.cells.tail, to: complex.cells.head };
  }

  /// Each segment of the input runs from the first to the last vertex of the edges that it covers:
  /// vertices are sorted by (x, y).
  segments(): Lines {
    const complex = this.complexes.authored;
    const count = this.arrays.u32("segment_source").length;
    const from = new Uint32Array(count).fill(none);
    const to = new Uint32Array(count);
    const { tail, head, edgeSegments } = complex.cells;
    for (let edge = 0; edge < tail.length; ++edge)
      for (const segment of edgeSegments.of(edge)) {
        from[segment] = Math.min(from[segment], tail[edge]);
        to[segment] = Math.max(to[segment], head[edge]);
      }
    const covered = (_: number, segment: number) => from[segment] !== none;
    return { complex, to: to.filter(covered), from: from.filter((vertex) => vertex !== none) };
  }

  /// The elements that segments came from, each once.
  sourcesOf(segments: Iterable<number>): number[] {
    const source = this.arrays.u32("segment_source");
    const found = new Set<number>();
    for (const segment of segments) found.add(source[segment]);
    return [...found].sort((a, b) => a - b);
  }

  /// "file:line:column element #id (path)".
  sourceText(source: number, withFile = true): string {
    const kind = this.report.page.kinds[this.arrays.u32("source_kind")[source]];
    return describeSource(
      {
        ...kind,
        line: this.arrays.u32("source_line")[source],
        column: this.arrays.u32("source_column")[source],
        id: this.ids.get(source) ?? "",
      },
      withFile ? this.report.files : [],
    );
  }
}

interface Source {
  file: number;
  line: number;
  column: number;
  element: string;
  id: string;
  path: string;
}

export function describeSource(source: Source, files: string[]): string {
  const file = files[source.file];
  const line = source.line ? `${source.line}:${source.column}` : "";
  return [
    file === undefined ? line && `line ${source.line}` : [file, line].filter(Boolean).join(":"),
    source.element,
    source.id && `#${source.id}`,
    source.path && `(${source.path})`,
  ]
    .filter(Boolean)
    .join(" ");
}
