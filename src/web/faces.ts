// Faces as triangles, coloured by depth; pulled apart, each shrunk towards its own centre (which is
// the same as moving it away from the drawing's middle and showing all of that smaller).

import earcut from "earcut";
import * as twgl from "twgl.js";
import type { Complex } from "./drawing";
import type { Frame } from "./lines";
import type { Colour } from "./theme";

const vertexShader = `#version 300 es
uniform vec2 viewport;
uniform vec2 translate;
uniform float scale;
uniform float size;      // of each face, 1: as it is
uniform vec3 depths[5];
in vec2 place;
in vec2 centre;
in float depth;
out vec3 colour;
void main() {
  vec2 p = mix(centre, place, size) * scale + translate;
  colour = depths[clamp(int(depth) - 1, 0, 4)];
  gl_Position = vec4(p / viewport * vec2(2, -2) + vec2(-1, 1), 0, 1);
}`;

const fragmentShader = `#version 300 es
precision mediump float;
uniform float opacity;
in vec3 colour;
out vec4 fragment;
void main() {
  fragment = vec4(colour, 1) * opacity;
}`;

export function makeFaceProgram(gl: WebGL2RenderingContext): twgl.ProgramInfo {
  return twgl.createProgramInfo(gl, [vertexShader, fragmentShader]);
}

/// The centre of each face: of area, by its outer boundary; of its box where that has none.
export function faceCentres(complex: Complex): Float64Array {
  const centres = new Float64Array(2 * complex.faceCount);
  const boxes = complex.faceBoxes();
  for (let face = 1; face < complex.faceCount; ++face) {
    const [left, top, right, bottom] = boxes.subarray(4 * face, 4 * face + 4);
    const cx = (left + right) / 2;
    const cy = (top + bottom) / 2;
    const ring = complex.ring(complex.cyclesOf(face)[0]);
    let area = 0;
    let x = 0;
    let y = 0;
    for (let i = 0, j = ring.length - 1; i < ring.length; j = i++) {
      const [px, py] = [complex.x[ring[j]] - cx, complex.y[ring[j]] - cy];
      const [qx, qy] = [complex.x[ring[i]] - cx, complex.y[ring[i]] - cy];
      const cross = px * qy - qx * py;
      area += cross;
      x += (px + qx) * cross;
      y += (py + qy) * cross;
    }
    const tiny = Math.abs(area) <= 1e-12 * (right - left) * (bottom - top);
    centres[2 * face] = cx + (tiny ? 0 : x / (3 * area));
    centres[2 * face + 1] = cy + (tiny ? 0 : y / (3 * area));
  }
  return centres;
}

interface Mesh {
  place: number[];
  centre: number[];
  depth: number[];
  triangles: number[];
}

function addFace(mesh: Mesh, complex: Complex, face: number, centres: Float64Array): void {
  const flat: number[] = [];
  const holes: number[] = [];
  for (const cycle of complex.cyclesOf(face)) {
    if (flat.length > 0) holes.push(flat.length / 2);
    for (const vertex of complex.ring(cycle)) flat.push(complex.x[vertex], complex.y[vertex]);
  }
  const first = mesh.place.length / 2;
  for (const corner of earcut(flat, holes)) mesh.triangles.push(first + corner);
  for (let i = 0; i < flat.length; i += 2) {
    mesh.place.push(flat[i], flat[i + 1]);
    mesh.centre.push(centres[2 * face], centres[2 * face + 1]);
    mesh.depth.push(complex.cells.faceDepth[face]);
  }
}

export class FaceLayer {
  private readonly array: twgl.VertexArrayInfo;
  private readonly count: number;

  constructor(
    private readonly gl: WebGL2RenderingContext,
    private readonly program: twgl.ProgramInfo,
    complex: Complex,
    centres: Float64Array,
  ) {
    const mesh: Mesh = { place: [], centre: [], depth: [], triangles: [] };
    const depth = complex.cells.faceDepth;
    const faces = Array.from({ length: Math.max(complex.faceCount - 1, 0) }, (_, i) => i + 1);
    faces.sort((a, b) => depth[a] - depth[b]); // the deeper ones on top, where faces are apart
    for (const face of faces) addFace(mesh, complex, face, centres);
    this.count = mesh.triangles.length;
    const buffers = twgl.createBufferInfoFromArrays(gl, {
      place: { numComponents: 2, data: new Float32Array(mesh.place) },
      centre: { numComponents: 2, data: new Float32Array(mesh.centre) },
      depth: { numComponents: 1, data: new Float32Array(mesh.depth) },
      indices: { numComponents: 3, data: new Uint32Array(mesh.triangles) },
    });
    this.array = twgl.createVertexArrayInfo(gl, program, buffers);
  }

  draw(frame: Frame, depths: Colour[], opacity: number, size: number): void {
    if (this.count === 0) return;
    const gl = this.gl;
    gl.useProgram(this.program.program);
    gl.bindVertexArray(this.array.vertexArrayObject!);
    twgl.setUniforms(this.program, {
      viewport: [frame.width, frame.height],
      translate: [frame.x, frame.y],
      scale: frame.k,
      size,
      depths: depths.flat(),
      opacity,
    });
    gl.drawElements(gl.TRIANGLES, this.count, gl.UNSIGNED_INT, 0);
  }
}

/// The ends of all boundaries, each face of this size.
export function outlines(complex: Complex, centres: Float64Array, size: number): Float32Array {
  const { begin, values } = complex.cells.cycles;
  const ends = new Float32Array(4 * values.length);
  let filled = 0;
  for (let face = 1; face < complex.faceCount; ++face) {
    const cx = centres[2 * face] * (1 - size);
    const cy = centres[2 * face + 1] * (1 - size);
    for (const cycle of complex.cyclesOf(face))
      for (let i = begin[cycle]; i < begin[cycle + 1]; ++i) {
        const tail = complex.originOf(values[i]);
        const head = complex.originOf(values[i] ^ 1);
        ends[filled++] = complex.x[tail] * size + cx;
        ends[filled++] = complex.y[tail] * size + cy;
        ends[filled++] = complex.x[head] * size + cx;
        ends[filled++] = complex.y[head] * size + cy;
      }
  }
  return ends.subarray(0, filled);
}
