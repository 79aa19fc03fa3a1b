// The stage of a repair: the drawing before, after or both, the faces that changed, a ring at each
// item of the list that is open.

import { clipRing, clipSegment } from "./clip";
import { drawMarkers, Marker, markersOf, Places } from "./markers";
import { Ends, Face, Fate, Item, RepairData } from "./repair_data";
import { currentTheme } from "./theme";
import type { View } from "./view";

export type Side = "before" | "after" | "both";

/// From the lowest to the topmost.
const order: Fate[] = ["kept", "moved-from", "moved-to", "removed", "added", "virtual"];
const sideOf: Record<Fate, Side> = {
  kept: "both", "moved-from": "before", removed: "before", "moved-to": "after", added: "after", virtual: "after",
};
const widths: Record<Fate, number> = { kept: 1.1, "moved-from": 1.6, "moved-to": 1.8, removed: 2.6, added: 2.6, virtual: 2.6 };
const dashes: Partial<Record<Fate, number[]>> = { "moved-from": [6, 5], virtual: [8, 6] };
const manyLines = 3000; // more make kept lines thinner
const mostMarkers = 150; // of more, dots are drawn
const dot = 3.5; // pixels
const flash = 1200; // milliseconds
const mostRatio = 2;

export class Stage {
  side: Side = "both";
  showMarks = true;
  markers: Marker<Item>[] = [];
  private places: Places<Item>;
  private chosen?: { item: Item; edit?: number; face?: Face };
  private flashed = -Infinity;
  private scheduled = false;
  private readonly context: CanvasRenderingContext2D;
  private theme = currentTheme();

  constructor(
    private readonly canvas: HTMLCanvasElement,
    readonly view: View,
    private readonly data: RepairData,
  ) {
    this.context = canvas.getContext("2d")!;
    this.places = new Places([], data);
    view.onMove(() => this.refresh());
  }

  refresh(): void {
    if (this.scheduled) return;
    this.scheduled = true;
    requestAnimationFrame(() => {
      this.scheduled = false;
      this.draw();
    });
  }

  recolour(): void {
    this.theme = currentTheme();
    this.draw();
  }

  setItems(items: Item[]): void {
    this.places = new Places(items, this.data);
    this.refresh();
  }

  /// Marks an item; an edit with its lines, a face with its border.
  choose(item: Item | undefined, edit?: number, face?: Face): void {
    this.chosen = item && { item, edit, face };
    this.flashed = matchMedia("(prefers-reduced-motion: reduce)").matches ? -Infinity : performance.now();
    document.documentElement.dataset.flashing = item ? String(item.number) : "";
    this.refresh();
  }

  isShown(face: Face): boolean {
    return this.side === "both" || (this.side === "after") === face.item.is_after;
  }

  draw(): void {
    const { width, height } = this.view;
    const ratio = Math.min(devicePixelRatio || 1, mostRatio);
    const on = this.context;
    this.canvas.width = Math.round(width * ratio);
    this.canvas.height = Math.round(height * ratio);
    on.setTransform(ratio, 0, 0, ratio, 0, 0);
    this.drawFaces(on);
    this.drawChosen(on);
    const thin = Math.min(1, Math.max(0.4, Math.sqrt((4 * manyLines) / this.data.lines.kept.length)));
    for (const fate of order) {
      if (this.side !== "both" && sideOf[fate] !== "both" && sideOf[fate] !== this.side) continue;
      const isDashed = fate === "virtual" || this.side === "both";
      on.setLineDash((isDashed && dashes[fate]) || []);
      this.stroke(on, this.data.lines[fate], fate, fate === "kept" ? widths.kept * thin : widths[fate]);
    }
    on.setLineDash([]);
    this.markers = this.showMarks ? markersOf(this.places, this.view) : [];
    const colours = { mark: this.theme.css("mark"), paper: this.theme.css("paper") };
    if (this.markers.length > mostMarkers) this.drawDots(on);
    else drawMarkers(on, this.markers, this.view, this.chosen?.item, colours);
    this.drawFlash(on);
  }

  private stroke(on: CanvasRenderingContext2D, ends: Ends, colour: string, width: number): void {
    if (ends.length === 0) return;
    const { k, x, y } = this.view.transform;
    const box = this.view.visible(16);
    const seen: number[] = [];
    for (let i = 0; i < ends.length; i += 4)
      clipSegment(box, ends[i], ends[i + 1], ends[i + 2], ends[i + 3], seen);
    on.beginPath();
    for (let i = 0; i < seen.length; i += 4) {
      on.moveTo(seen[i] * k + x, seen[i + 1] * k + y);
      on.lineTo(seen[i + 2] * k + x, seen[i + 3] * k + y);
    }
    on.strokeStyle = this.theme.css(colour);
    on.lineWidth = width;
    on.stroke();
  }

  private path(face: Face): Path2D {
    const path = new Path2D();
    const { k, x, y } = this.view.transform;
    const box = this.view.visible(16);
    for (const ring of face.rings) {
      clipRing(box, ring).forEach(([px, py], i) =>
        i === 0 ? path.moveTo(px * k + x, py * k + y) : path.lineTo(px * k + x, py * k + y),
      );
      path.closePath();
    }
    return path;
  }

  /// What went into a face lies upon it.
  private drawFaces(on: CanvasRenderingContext2D): void {
    for (const after of [true, false])
      for (const face of this.data.faces) {
        if (face.item.is_after !== after || !this.isShown(face)) continue;
        on.fillStyle = this.theme.css(`face-${face.item.kind}${face.item.is_other ? "-other" : ""}`);
        on.fill(this.path(face), "evenodd");
      }
  }

  /// Below the lines.
  private drawChosen(on: CanvasRenderingContext2D): void {
    const { edit, face } = this.chosen ?? {};
    if (edit !== undefined) {
      on.globalAlpha = 0.25;
      if (this.side !== "after") this.stroke(on, this.data.before[edit], "focus", 9);
      if (this.side !== "before") this.stroke(on, this.data.after[edit], "focus", 9);
      on.globalAlpha = 1;
    }
    if (!face) return;
    on.strokeStyle = this.theme.css("focus");
    on.lineWidth = 5;
    on.stroke(this.path(face));
  }

  /// So many that rings would hide the drawing.
  private drawDots(on: CanvasRenderingContext2D): void {
    const { k, x, y } = this.view.transform;
    on.fillStyle = this.theme.css("mark");
    for (let i = 0; i < this.places.x.length; ++i)
      on.fillRect(this.places.x[i] * k + x - dot / 2, this.places.y[i] * k + y - dot / 2, dot, dot);
  }

  /// A ring that closes in on the chosen place.
  private drawFlash(on: CanvasRenderingContext2D): void {
    if (!this.chosen) return;
    const [px, py] = this.data.local(this.chosen.item.where.nearest);
    const { k, x, y } = this.view.transform;
    const gone = (performance.now() - this.flashed) / flash;
    const left = Math.max(0, 1 - gone);
    on.beginPath();
    on.arc(px * k + x, py * k + y, 13 + 60 * left * left, 0, 2 * Math.PI);
    on.strokeStyle = this.theme.css("mark");
    on.lineWidth = 3 + 3 * left;
    on.stroke();
    if (left > 0) this.refresh();
    else document.documentElement.dataset.flashing = "";
  }
}
