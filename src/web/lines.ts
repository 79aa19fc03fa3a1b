// Lines of any width with smooth borders: each is a rectangle of two triangles (WebGL's own lines
// are one pixel wide), whose corners the vertex shader makes from the ends, which are in a texture
// (instances, the usual way, are ten times slower where the processor does the drawing). Zoomed
// out, all lines of a layer stay on the graphics card; zoomed in, those in view are clipped in
// doubles and sent anew.

import * as twgl from "twgl.js";
import { Box } from "./box";
import { clipSegment } from "./clip";
import type { Lines } from "./drawing";
import type { Colour } from "./theme";

const vertexShader = `#version 300 es
uniform vec2 viewport;  // pixels
uniform vec2 translate; // pixels
uniform float scale;    // pixels per unit
uniform float width;    // pixels
uniform highp sampler2D lines;
out float across;
const vec2 corners[6] = vec2[](vec2(0, -1), vec2(0, 1), vec2(1, -1), vec2(1, -1), vec2(0, 1), vec2(1, 1));
void main() {
  int line = gl_VertexID / 6;
  vec2 corner = corners[gl_VertexID % 6]; // x: along the line 0..1, y: across -1..1
  int columns = textureSize(lines, 0).x;
  vec4 ends = texelFetch(lines, ivec2(line % columns, line / columns), 0);
  vec2 a = ends.xy * scale + translate;
  vec2 b = ends.zw * scale + translate;
  vec2 along = b - a;
  float size = length(along);
  vec2 direction = size > 1e-6 ? along / size : vec2(1, 0);
  float reach = 0.5 * width + 1.0;
  across = corner.y * reach;
  float cap = 0.35 * width * (2.0 * corner.x - 1.0);
  vec2 p = mix(a, b, corner.x) + direction * cap + vec2(-direction.y, direction.x) * across;
  gl_Position = vec4(p / viewport * vec2(2, -2) + vec2(-1, 1), 0, 1);
}`;

const fragmentShader = `#version 300 es
precision highp float;
uniform vec3 colour;
uniform float opacity;
uniform float width;
in float across;
out vec4 fragment;
void main() {
  float visible = max(width, 1.0);
  float cover = clamp(0.5 * visible + 0.5 - abs(across), 0.0, 1.0) * min(width, 1.0);
  fragment = vec4(colour, 1) * cover * opacity;
}`;

export interface Pen {
  colour: Colour;
  opacity: number;
  width: number; // pixels
}

/// Where the drawing is on the stage: at k * p + (x, y), in CSS pixels, as all lengths here.
export interface Frame {
  width: number;
  height: number;
  k: number;
  x: number;
  y: number;
}

export function makeLineProgram(gl: WebGL2RenderingContext): twgl.ProgramInfo {
  return twgl.createProgramInfo(gl, [vertexShader, fragmentShader]);
}

const columns = 2048; // of the texture; every WebGL2 has that

/// The ends of lines, four numbers each, on the graphics card.
export class LineBuffer {
  private readonly texture: WebGLTexture;
  private readonly nothing: WebGLVertexArrayObject;
  private count = 0;

  constructor(
    private readonly gl: WebGL2RenderingContext,
    private readonly program: twgl.ProgramInfo,
  ) {
    this.texture = gl.createTexture()!;
    this.nothing = gl.createVertexArray()!;
    this.set(new Float32Array(0));
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
  }

  set(ends: Float32Array): void {
    const gl = this.gl;
    this.count = ends.length / 4;
    const rows = Math.max(Math.ceil(this.count / columns), 1);
    const texels = new Float32Array(4 * columns * rows);
    texels.set(ends);
    gl.bindTexture(gl.TEXTURE_2D, this.texture);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, columns, rows, 0, gl.RGBA, gl.FLOAT, texels);
  }

  draw(frame: Frame, pen: Pen): void {
    if (this.count === 0) return;
    const gl = this.gl;
    gl.useProgram(this.program.program);
    gl.bindVertexArray(this.nothing);
    twgl.setUniforms(this.program, {
      viewport: [frame.width, frame.height],
      translate: [frame.x, frame.y],
      scale: frame.k,
      lines: this.texture,
      ...pen,
    });
    gl.drawArrays(gl.TRIANGLES, 0, 6 * this.count);
  }
}

/// The lines of one layer.
export class LineLayer {
  private readonly all: LineBuffer;
  private readonly part: LineBuffer;
  readonly meanLength: number;

  constructor(
    gl: WebGL2RenderingContext,
    program: twgl.ProgramInfo,
    private readonly lines: Lines,
  ) {
    const { complex, from, to } = lines;
    const { x, y } = complex;
    const ends = new Float32Array(4 * from.length);
    let length = 0;
    for (let i = 0; i < from.length; ++i) {
      ends[4 * i] = x[from[i]];
      ends[4 * i + 1] = y[from[i]];
      ends[4 * i + 2] = x[to[i]];
      ends[4 * i + 3] = y[to[i]];
      length += Math.hypot(x[to[i]] - x[from[i]], y[to[i]] - y[from[i]]);
    }
    this.meanLength = length / Math.max(from.length, 1);
    this.all = new LineBuffer(gl, program);
    this.all.set(ends);
    this.part = new LineBuffer(gl, program);
  }

  drawAll(frame: Frame, pen: Pen): void {
    this.all.draw(frame, pen);
  }

  /// Draws what is within the box.
  drawPart(box: Box, frame: Frame, pen: Pen): void {
    this.part.set(new Float32Array(this.clipped(box, frame)));
    this.part.draw({ ...frame, k: 1, x: 0, y: 0 }, pen);
  }

  /// The ends of what is within the box, in pixels.
  private clipped(box: Box, frame: Frame): number[] {
    const { complex, from, to } = this.lines;
    const { x, y } = complex;
    const ends: number[] = [];
    for (let i = 0; i < from.length; ++i) {
      const a = from[i];
      const b = to[i];
      if (Math.min(x[a], x[b]) > box.right || Math.max(x[a], x[b]) < box.left) continue;
      if (Math.min(y[a], y[b]) > box.bottom || Math.max(y[a], y[b]) < box.top) continue;
      clipSegment(box, x[a], y[a], x[b], y[b], ends);
    }
    for (let i = 0; i < ends.length; i += 2) {
      ends[i] = ends[i] * frame.k + frame.x;
      ends[i + 1] = ends[i + 1] * frame.k + frame.y;
    }
    return ends;
  }
}
