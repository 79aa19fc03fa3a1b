// What lies on top of the drawing: vertices seen from near, the chosen finding's cells, the face
// under the pointer, the findings' markers.

import { Box, emptyBox, extent, grow } from "./box";
import { clipSegment } from "./clip";
import type { Complex, Drawing } from "./drawing";
import { drawMarkers, Marker, markersOf, Places } from "./markers";
import type { ComplexName, Finding } from "./report";
import { facePath, Scene } from "./scene";
import type { View } from "./view";

const mostVertices = 1500;
const roomyVertices = 60; // pixels between them on average

export interface Side {
  complex: Complex;
  cells: number[];
}

export class Overlay {
  showFindings = true;
  chosen?: { finding: Finding; sides: Side[] };
  hovered?: { complex: Complex; face: number };
  markers: Marker[] = [];
  private places: Places;
  private readonly context: CanvasRenderingContext2D;

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly view: View,
    private readonly drawing: Drawing,
    private readonly scene: Scene,
  ) {
    this.context = canvas.getContext("2d")!;
    this.places = new Places([], drawing);
  }

  setFindings(findings: Finding[]): void {
    this.places = new Places(findings, this.drawing);
    this.draw();
  }

  draw(): void {
    const { width, height } = this.view;
    const ratio = devicePixelRatio || 1;
    const on = this.context;
    this.canvas.width = Math.round(width * ratio);
    this.canvas.height = Math.round(height * ratio);
    on.setTransform(ratio, 0, 0, ratio, 0, 0);
    this.markers = [];
    if (this.scene.size < 1) return;
    this.drawHovered(on);
    this.drawVertices(on);
    if (this.chosen) for (const side of this.chosen.sides) this.drawCells(on, side);
    if (!this.showFindings) return;
    this.markers = markersOf(this.places, this.view);
    const colours = { mark: this.css("mark"), paper: this.css("paper") };
    drawMarkers(on, this.markers, this.view, this.chosen?.finding, colours);
  }

  private css(name: string): string {
    return this.scene.theme.css(name);
  }

  private drawHovered(on: CanvasRenderingContext2D): void {
    if (!this.hovered) return;
    const path = facePath(this.hovered.complex, this.hovered.face, this.view, 8);
    on.fillStyle = this.css("hover");
    on.fill(path, "evenodd");
    on.strokeStyle = this.css("ink");
    on.lineWidth = 1.5;
    on.stroke(path);
  }

  private drawVertices(on: CanvasRenderingContext2D): void {
    for (const name of ["float", "doubles", "authored"] as ComplexName[]) {
      if (!this.scene.lines.has(name)) continue;
      const complex = this.drawing.complexes[name];
      for (const vertex of complex.cells.isolated) this.dot(on, complex, vertex, 2.5);
      const inView = this.verticesInView(complex);
      if (inView) for (const vertex of inView) this.dot(on, complex, vertex, name === "float" ? 4.5 : 2.4);
    }
  }

  /// The vertices in view, unless they are too many to be told apart.
  private verticesInView(complex: Complex): number[] | undefined {
    const box = this.view.visible(8);
    const inView: number[] = [];
    for (let v = 0; v < complex.x.length; ++v) {
      if (complex.x[v] < box.left || complex.x[v] > box.right) continue;
      if (complex.y[v] < box.top || complex.y[v] > box.bottom) continue;
      if (inView.push(v) > mostVertices) return undefined;
    }
    const spacing = Math.sqrt((this.view.width * this.view.height) / Math.max(inView.length, 1));
    return spacing > roomyVertices ? inView : undefined;
  }

  private dot(on: CanvasRenderingContext2D, complex: Complex, vertex: number, radius: number): void {
    const { k, x, y } = this.view.transform;
    on.beginPath();
    on.arc(complex.x[vertex] * k + x, complex.y[vertex] * k + y, radius, 0, 2 * Math.PI);
    on.fillStyle = this.css(complex.name);
    on.fill();
  }

  private drawCells(on: CanvasRenderingContext2D, { complex, cells }: Side): void {
    const kind = this.chosen!.finding.kind;
    on.strokeStyle = this.css(`${complex.name}-strong`);
    on.lineWidth = complex.name === "authored" ? 3 : 7;
    on.globalAlpha = complex.name === "authored" ? 1 : 0.55;
    on.lineCap = "round";
    if (kind === "vertex") for (const cell of cells) this.ring(on, complex, cell);
    if (kind === "edge") this.strokeEdges(on, complex, cells);
    if (kind === "hole")
      for (const cell of cells)
        this.strokeEdges(on, complex, Array.from(complex.cells.cycles.of(cell), (h) => h >>> 1));
    if (kind === "face") for (const cell of cells) if (cell > 0) this.strokeFace(on, complex, cell);
    on.globalAlpha = 1;
  }

  private ring(on: CanvasRenderingContext2D, complex: Complex, vertex: number): void {
    const { k, x, y } = this.view.transform;
    on.beginPath();
    const radius = complex.name === "authored" ? 6 : 11;
    on.arc(complex.x[vertex] * k + x, complex.y[vertex] * k + y, radius, 0, 2 * Math.PI);
    on.stroke();
  }

  private strokeEdges(on: CanvasRenderingContext2D, complex: Complex, edges: number[]): void {
    const { tail, head } = complex.cells;
    const { k, x, y } = this.view.transform;
    const ends: number[] = [];
    const box = this.view.visible(16);
    for (const edge of edges) {
      const [a, b] = [tail[edge], head[edge]];
      clipSegment(box, complex.x[a], complex.y[a], complex.x[b], complex.y[b], ends);
    }
    on.beginPath();
    for (let i = 0; i < ends.length; i += 4) {
      on.moveTo(ends[i] * k + x, ends[i + 1] * k + y);
      on.lineTo(ends[i + 2] * k + x, ends[i + 3] * k + y);
    }
    on.stroke();
  }

  private strokeFace(on: CanvasRenderingContext2D, complex: Complex, face: number): void {
    const edges = complex
      .cyclesOf(face)
      .flatMap((cycle) => Array.from(complex.cells.cycles.of(cycle), (h) => h >>> 1));
    this.strokeEdges(on, complex, edges);
    on.globalAlpha = 0.12;
    on.fillStyle = this.css(`${complex.name}-strong`);
    on.fill(facePath(complex, face, this.view, 16), "evenodd");
    on.globalAlpha = complex.name === "authored" ? 1 : 0.55;
  }
}

/// The part of the drawing that shows a finding: its place, its cells, and room around them. Large
/// cells are not shown whole: the place is what matters.
export function boxOf(finding: Finding, sides: Side[], drawing: Drawing): Box {
  const whole = extent(drawing.box);
  if (!finding.where) return drawing.box;
  const [x, y] = drawing.local(finding.where.nearest);
  const box = emptyBox();
  grow(box, x, y);
  for (const { complex, cells } of sides)
    for (const cell of cells) growByCell(box, complex, finding.kind, cell);
  const size = Math.max(extent(box), finding.distance ?? 0);
  const fallback = Math.max(drawing.report.tolerance, whole * 1e-3);
  const room = size > 0 ? size : fallback * 4;
  const half = finding.kind === "vertex" ? room * 2.5 : room * 0.75;
  const [cx, cy] = [(box.left + box.right) / 2, (box.top + box.bottom) / 2];
  return { left: cx - half, right: cx + half, top: cy - half, bottom: cy + half };
}

function growByCell(box: Box, complex: Complex, kind: Finding["kind"], cell: number): void {
  const byHalfedges = (cycle: number) => {
    for (const h of complex.cells.cycles.of(cycle)) complex.growBy(box, complex.originOf(h));
  };
  if (kind === "vertex") complex.growBy(box, cell);
  if (kind === "edge") {
    complex.growBy(box, complex.cells.tail[cell]);
    complex.growBy(box, complex.cells.head[cell]);
  }
  if (kind === "hole") byHalfedges(cell);
  if (kind === "face" && cell > 0) complex.cyclesOf(cell).forEach(byHalfedges);
}
