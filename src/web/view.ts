// The view: which part of the drawing is on the stage. Gestures are d3-zoom's; k is pixels per unit
// of the drawing, (x, y) where the drawing's middle is on the stage, in pixels.

import { select, Selection } from "d3-selection";
import "d3-transition";
import { zoom, zoomIdentity, ZoomBehavior, ZoomTransform } from "d3-zoom";
import { Box, extent } from "./box";

const margin = 0.06; // around the whole drawing, of the stage
const mostZoom = 1e13; // of the whole drawing; the doubles end there
const leastZoom = 0.1;
const keyStep = 0.15; // of the stage
const keyZoom = 1.5;
const flight = 650; // milliseconds

export class View {
  private readonly behavior: ZoomBehavior<HTMLElement, unknown>;
  private readonly selection: Selection<HTMLElement, unknown, null, undefined>;
  private readonly listeners: ((moving: boolean) => void)[] = [];
  private readonly still = matchMedia("(prefers-reduced-motion: reduce)");
  width = 1;
  height = 1;
  transform: ZoomTransform = zoomIdentity;

  constructor(
    readonly stage: HTMLElement,
    private readonly content: Box,
  ) {
    this.selection = select(stage);
    this.behavior = zoom<HTMLElement, unknown>()
      .on("zoom", (event) => this.moveTo(event.transform, true))
      .on("end", (event) => this.moveTo(event.transform, false));
    this.selection.call(this.behavior).on("dblclick.zoom", null);
    this.resize();
    this.show(content, false);
    new ResizeObserver(() => this.resizeKeepingMiddle()).observe(stage);
    stage.addEventListener("keydown", (event) => this.onKey(event));
  }

  onMove(listener: (moving: boolean) => void): void {
    this.listeners.push(listener);
  }

  /// The part of the drawing on the stage, wider by some pixels.
  visible(pixels = 0): Box {
    const [left, top] = this.transform.invert([-pixels, -pixels]);
    const [right, bottom] = this.transform.invert([this.width + pixels, this.height + pixels]);
    return { left, top, right, bottom };
  }

  /// Pixels per unit at which the whole drawing fills the stage.
  wholeScale(): number {
    return this.scaleFor(this.content);
  }

  /// Flies, or jumps, to a box of the drawing.
  show(box: Box, flying = true): void {
    const k = Math.min(this.scaleFor(box), this.wholeScale() * mostZoom);
    const x = (box.left + box.right) / 2;
    const y = (box.top + box.bottom) / 2;
    const to = zoomIdentity.translate(this.width / 2, this.height / 2).scale(k).translate(-x, -y);
    this.go(to, flying);
  }

  showAll(): void {
    this.show(this.content);
  }

  zoomBy(factor: number): void {
    const middle: [number, number] = [this.width / 2, this.height / 2];
    this.selection.interrupt();
    this.behavior.scaleBy(this.selection, factor, middle);
  }

  private go(to: ZoomTransform, flying: boolean): void {
    this.selection.interrupt();
    if (flying && !this.still.matches)
      this.behavior.transform(this.selection.transition().duration(flight), to);
    else this.behavior.transform(this.selection, to);
  }

  private moveTo(transform: ZoomTransform, moving: boolean): void {
    this.transform = transform;
    for (const listener of this.listeners) listener(moving);
  }

  private scaleFor(box: Box): number {
    const across = (length: number, room: number) =>
      length > 0 ? (room * (1 - 2 * margin)) / length : Infinity;
    const k = Math.min(
      across(box.right - box.left, this.width),
      across(box.bottom - box.top, this.height),
    );
    return Number.isFinite(k) ? k : extent(this.content) > 0 ? this.wholeScale() : 1;
  }

  private resize(): void {
    this.width = Math.max(this.stage.clientWidth, 1);
    this.height = Math.max(this.stage.clientHeight, 1);
    const whole = this.wholeScale();
    this.behavior
      .scaleExtent([whole * leastZoom, whole * mostZoom])
      .extent([
        [0, 0],
        [this.width, this.height],
      ]);
  }

  private resizeKeepingMiddle(): void {
    const { width, height, transform } = this;
    if (width === this.stage.clientWidth && height === this.stage.clientHeight) return;
    const middle = transform.invert([width / 2, height / 2]);
    this.resize();
    const grown = Math.min(this.width / width, this.height / height);
    const to = zoomIdentity
      .translate(this.width / 2, this.height / 2)
      .scale(transform.k * grown)
      .translate(-middle[0], -middle[1]);
    this.go(to, false);
  }

  private onKey(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const pan = (x: number, y: number) => {
      const k = this.transform.k;
      this.selection.interrupt();
      this.behavior.translateBy(
        this.selection,
        (x * keyStep * this.width) / k,
        (y * keyStep * this.height) / k,
      );
    };
    const actions: Record<string, () => void> = {
      ArrowLeft: () => pan(1, 0),
      ArrowRight: () => pan(-1, 0),
      ArrowUp: () => pan(0, 1),
      ArrowDown: () => pan(0, -1),
      "+": () => this.zoomBy(keyZoom),
      "=": () => this.zoomBy(keyZoom),
      "-": () => this.zoomBy(1 / keyZoom),
      "0": () => this.showAll(),
      Home: () => this.showAll(),
    };
    const action = actions[event.key];
    if (!action) return;
    event.preventDefault();
    action();
  }
}
