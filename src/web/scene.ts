// The stage: a canvas of WebGL2 with faces and lines, one below it for faces seen from very near,
// one above it for what is pointed at.

import { zoomIdentity, ZoomTransform } from "d3-zoom";
import { extent } from "./box";
import { clipRing } from "./clip";
import type { Complex, Drawing } from "./drawing";
import { faceCentres, FaceLayer, makeFaceProgram, outlines } from "./faces";
import { Frame, LineBuffer, LineLayer, makeLineProgram, Pen } from "./lines";
import type { ComplexName } from "./report";
import { currentTheme, Theme } from "./theme";
import type { View } from "./view";

export type LineName = "input" | ComplexName;
/// From the lowest to the topmost: where all agree, one sees a thin line on wider ones.
const lineOrder: LineName[] = ["float", "doubles", "input", "authored"];
const fullWidth: Record<LineName, number> = { float: 4.4, doubles: 2.8, input: 2, authored: 1.3 };
const roomyEdge = 14; // pixels; with shorter edges on average, lines become thinner
const staticZoom = 3; // beyond this zoom of the whole drawing, only what is in view is drawn
const sharpPixels = 1e5; // up to this extent, float32 places are good to 1/100 pixel
const slowFrame = 30; // milliseconds; slower drawing is left out while the view moves
const rest = 140; // milliseconds without movement, after which it is drawn again
const mostRatio = 2;
const mostNearFaces = 5000;

export class Scene {
  readonly lines = new Set<LineName>(["authored", "float"]);
  faces: ComplexName | "none" = "authored";
  size = 1; // of each face; below 1 they are pulled apart
  theme: Theme = currentTheme();
  onDraw: () => void = () => {};

  private readonly gl: WebGL2RenderingContext;
  private readonly below: CanvasRenderingContext2D;
  private readonly lineProgram;
  private readonly faceProgram;
  private readonly lineLayers = new Map<LineName, LineLayer>();
  private readonly faceLayers = new Map<ComplexName, FaceLayer>();
  private readonly centresOf = new Map<ComplexName, Float64Array>();
  private apart?: { name: ComplexName; size: number; buffer: LineBuffer };
  private drawn: ZoomTransform = zoomIdentity;
  private drawnAt = 0;
  private lastCost = 0; // milliseconds
  private scheduled = false;
  private moving = false;
  private restTimer = 0;

  constructor(
    private readonly canvas: HTMLCanvasElement,
    belowCanvas: HTMLCanvasElement,
    private readonly view: View,
    private readonly drawing: Drawing,
  ) {
    const gl = canvas.getContext("webgl2", {
      alpha: true,
      antialias: false,
      depth: false,
      preserveDrawingBuffer: true, // a page is printed with what was drawn
    });
    if (!gl) throw new Error("this browser shows no WebGL2, which the picture needs");
    this.gl = gl;
    this.below = belowCanvas.getContext("2d")!;
    this.lineProgram = makeLineProgram(gl);
    this.faceProgram = makeFaceProgram(gl);
    view.onMove((moving) => this.follow(moving));
  }

  /// Draws with the next frame of the screen.
  refresh(): void {
    if (this.scheduled) return;
    this.scheduled = true;
    requestAnimationFrame(() => {
      this.scheduled = false;
      this.drawNow();
    });
  }

  recolour(): void {
    this.theme = currentTheme();
    this.drawNow();
  }

  centres(name: ComplexName): Float64Array {
    let centres = this.centresOf.get(name);
    if (!centres) this.centresOf.set(name, (centres = faceCentres(this.drawing.complexes[name])));
    return centres;
  }

  drawNow(): void {
    if (this.moving && this.lastCost > slowFrame && !this.mayRedraw()) {
      this.carryAlong();
    } else {
      this.drawAll();
    }
    this.onDraw();
  }

  private follow(moving: boolean): void {
    this.moving = moving;
    clearTimeout(this.restTimer);
    if (moving)
      this.restTimer = window.setTimeout(() => {
        this.moving = false;
        this.refresh();
      }, rest);
    this.refresh();
  }

  private mayRedraw(): boolean {
    return performance.now() - this.drawnAt > Math.max(300, 6 * this.lastCost);
  }

  /// Moves the last picture to where it belongs now: cheap, and exact but for the lines' width.
  private carryAlong(): void {
    const now = this.view.transform;
    const scale = now.k / this.drawn.k;
    const x = now.x - this.drawn.x * scale;
    const y = now.y - this.drawn.y * scale;
    const style = `translate(${x}px, ${y}px) scale(${scale})`;
    for (const canvas of [this.canvas, this.below.canvas]) canvas.style.transform = style;
  }

  private drawAll(): void {
    const begin = performance.now();
    const frame = this.prepare();
    this.drawFaces(frame);
    if (this.size < 1) this.drawApart(frame);
    else this.drawLines(frame);
    this.drawn = this.view.transform;
    for (const canvas of [this.canvas, this.below.canvas]) canvas.style.transform = "";
    this.drawnAt = begin;
    this.measure(begin);
  }

  /// The graphics card works on after the script has said what to draw: a fence tells how long.
  private measure(begin: number): void {
    const gl = this.gl;
    const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0)!;
    gl.flush();
    const look = () => {
      const isDone = gl.getSyncParameter(fence, gl.SYNC_STATUS) === gl.SIGNALED;
      if (!isDone && !gl.isContextLost()) return void setTimeout(look, 4);
      gl.deleteSync(fence);
      this.lastCost = performance.now() - begin;
      document.documentElement.dataset.frameMilliseconds = this.lastCost.toFixed(1);
    };
    setTimeout(look, 0);
  }

  private prepare(): Frame {
    const { width, height, transform } = this.view;
    const ratio = Math.min(devicePixelRatio || 1, mostRatio);
    for (const canvas of [this.canvas, this.below.canvas]) {
      const pixels = [Math.round(width * ratio), Math.round(height * ratio)];
      if (canvas.width !== pixels[0]) canvas.width = pixels[0];
      if (canvas.height !== pixels[1]) canvas.height = pixels[1];
    }
    const gl = this.gl;
    gl.viewport(0, 0, this.canvas.width, this.canvas.height);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    this.below.setTransform(ratio, 0, 0, ratio, 0, 0);
    this.below.clearRect(0, 0, width, height);
    return { width, height, k: transform.k, x: transform.x, y: transform.y };
  }

  private drawFaces(frame: Frame): void {
    if (this.faces === "none") return;
    const complex = this.drawing.complexes[this.faces];
    if (this.size === 1 && frame.k * extent(this.drawing.box) > sharpPixels) {
      this.drawNearFaces(complex);
      return;
    }
    let layer = this.faceLayers.get(this.faces);
    if (!layer) {
      layer = new FaceLayer(this.gl, this.faceProgram, complex, this.centres(this.faces));
      this.faceLayers.set(this.faces, layer);
    }
    layer.draw(frame, this.theme.depth, 1, this.size);
  }

  /// Faces in view, clipped in doubles.
  private drawNearFaces(complex: Complex): void {
    const box = this.view.visible(4);
    const boxes = complex.faceBoxes();
    let count = 0;
    for (let face = 1; face < complex.faceCount && count < mostNearFaces; ++face) {
      const i = 4 * face;
      if (boxes[i] > box.right || boxes[i + 2] < box.left) continue;
      if (boxes[i + 1] > box.bottom || boxes[i + 3] < box.top) continue;
      ++count;
      const depth = Math.min(complex.cells.faceDepth[face], this.theme.depth.length);
      this.below.fillStyle = this.theme.css(`depth-${Math.max(depth, 1)}`);
      this.below.fill(facePath(complex, face, this.view, 4), "evenodd");
    }
  }

  private drawLines(frame: Frame): void {
    const isNear = frame.k > staticZoom * this.view.wholeScale();
    const box = this.view.visible(8);
    for (const name of lineOrder) {
      if (!this.lines.has(name)) continue;
      const layer = this.lineLayer(name);
      const pen = this.pen(name, layer.meanLength * frame.k);
      if (isNear) layer.drawPart(box, frame, pen);
      else layer.drawAll(frame, pen);
    }
  }

  private drawApart(frame: Frame): void {
    if (this.faces === "none") return;
    if (this.apart?.name !== this.faces || this.apart.size !== this.size) {
      const complex = this.drawing.complexes[this.faces];
      const buffer = this.apart?.buffer ?? new LineBuffer(this.gl, this.lineProgram);
      buffer.set(outlines(complex, this.centres(this.faces), this.size));
      this.apart = { name: this.faces, size: this.size, buffer };
    }
    const layer = this.lineLayer(this.faces);
    const pen = this.pen("authored", layer.meanLength * frame.k);
    this.apart.buffer.draw(frame, { ...pen, colour: this.theme.rgb(this.faces) });
  }

  private lineLayer(name: LineName): LineLayer {
    let layer = this.lineLayers.get(name);
    if (!layer) {
      const lines = name === "input" ? this.drawing.segments() : this.drawing.edges(name);
      layer = new LineLayer(this.gl, this.lineProgram, lines);
      this.lineLayers.set(name, layer);
    }
    return layer;
  }

  private pen(name: LineName, edgePixels: number): Pen {
    const room = Math.min(edgePixels / roomyEdge, 1);
    const width = Math.max(fullWidth[name] * Math.sqrt(room), name === "authored" ? 0.35 : 0.7);
    return { colour: this.theme.rgb(name), opacity: 1, width };
  }
}

/// A face on the stage, in pixels, clipped to it.
export function facePath(complex: Complex, face: number, view: View, pixels: number): Path2D {
  const path = new Path2D();
  const box = view.visible(pixels);
  const { k, x, y } = view.transform;
  for (const cycle of complex.cyclesOf(face)) {
    const ring = Array.from(complex.ring(cycle), (v): [number, number] => [
      complex.x[v],
      complex.y[v],
    ]);
    clipRing(box, ring).forEach(([px, py], i) =>
      i === 0 ? path.moveTo(px * k + x, py * k + y) : path.lineTo(px * k + x, py * k + y),
    );
    path.closePath();
  }
  return path;
}
