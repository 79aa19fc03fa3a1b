// Findings on the stage: rings with numbers; those that would overlap are one disc with their count.

import { Box, emptyBox, extent, grow, overlap } from "./box";
import type { Finding } from "./report";
import type { View } from "./view";

const cell = 30; // pixels; findings nearer than this share a marker
const reach = 14; // of the pointer
const mostNumbers = 4;

/// What has a number and mostly a place.
export interface Located {
  number: number;
  where: { nearest: [number, number] } | null;
}

export interface Marker<T extends Located = Finding> {
  x: number; // on the stage
  y: number;
  findings: T[];
  box: Box; // of the places, in the drawing
}

/// The findings that have a place, with their local coordinates.
export class Places<T extends Located = Finding> {
  readonly findings: T[];
  readonly x: Float64Array;
  readonly y: Float64Array;

  constructor(findings: T[], drawing: { local(place: [number, number]): [number, number] }) {
    this.findings = findings.filter((finding) => finding.where);
    this.x = new Float64Array(this.findings.length);
    this.y = new Float64Array(this.findings.length);
    this.findings.forEach((finding, i) => {
      [this.x[i], this.y[i]] = drawing.local(finding.where!.nearest);
    });
  }
}

/// A marker for each square of the stage that has findings. The squares hold still on the drawing
/// while the view pans.
export function markersOf<T extends Located>({ findings, x, y }: Places<T>, view: View): Marker<T>[] {
  const { k, x: shiftX, y: shiftY } = view.transform;
  const squares = new Map<number, Marker<T>>();
  const columns = Math.ceil(view.width / cell) + 4;
  const left = Math.floor(-shiftX / cell) - 1;
  const top = Math.floor(-shiftY / cell) - 1;
  for (let i = 0; i < findings.length; ++i) {
    const px = x[i] * k;
    const py = y[i] * k;
    if (px + shiftX < -cell || px + shiftX > view.width + cell) continue;
    if (py + shiftY < -cell || py + shiftY > view.height + cell) continue;
    const square = (Math.floor(py / cell) - top) * columns + Math.floor(px / cell) - left;
    let marker = squares.get(square);
    if (!marker) {
      marker = { x: px + shiftX, y: py + shiftY, findings: [], box: emptyBox() };
      squares.set(square, marker);
    }
    marker.findings.push(findings[i]);
    grow(marker.box, x[i], y[i]);
  }
  return [...squares.values()];
}

/// Whether coming nearer does not part its findings.
export function isOnePlace(marker: Marker<Located>, view: View): boolean {
  return extent(marker.box) * view.transform.k < 1e-3;
}

export function markerAt<T extends Located>(
  markers: Marker<T>[], x: number, y: number,
): Marker<T> | undefined {
  let best: Marker<T> | undefined;
  let nearest = reach;
  for (const marker of markers) {
    const distance = Math.hypot(marker.x - x, marker.y - y);
    if (distance <= nearest) [best, nearest] = [marker, distance];
  }
  return best;
}

export interface MarkerColours {
  mark: string;
  paper: string;
}

/// Rings with numbers where findings have one place, discs with their count elsewhere. Numbers
/// that would cover another marker or number are left out: the pointer tells them.
export function drawMarkers(
  on: CanvasRenderingContext2D, markers: Marker<Located>[], view: View, chosen: Located | undefined,
  colours: MarkerColours,
): void {
  const taken: Box[] = markers.map(({ x, y }) => ({ left: x - 8, top: y - 8, right: x + 8, bottom: y + 8 }));
  for (const marker of markers) {
    on.lineWidth = chosen && marker.findings.includes(chosen) ? 3 : 2;
    on.strokeStyle = on.fillStyle = colours.mark;
    on.textBaseline = "middle";
    if (isOnePlace(marker, view)) drawRing(on, marker, taken, colours);
    else drawDisc(on, marker, colours);
  }
}

function drawDisc(on: CanvasRenderingContext2D, marker: Marker<Located>, colours: MarkerColours): void {
  const count = marker.findings.length;
  on.beginPath();
  on.arc(marker.x, marker.y, 9 + Math.min(Math.log2(count), 6), 0, 2 * Math.PI);
  on.fill();
  on.fillStyle = colours.paper;
  on.textAlign = "center";
  const text = count < 1000 ? String(count) : `${Math.round(count / 1000)}k`;
  on.font = `600 ${text.length > 2 ? 10 : 11}px system-ui, sans-serif`;
  on.fillText(text, marker.x, marker.y + 0.5);
}

function drawRing(
  on: CanvasRenderingContext2D, marker: Marker<Located>, taken: Box[], colours: MarkerColours,
): void {
  const radius = 7;
  on.beginPath();
  on.arc(marker.x, marker.y, radius, 0, 2 * Math.PI);
  on.stroke();
  const numbers = marker.findings.map((finding) => finding.number);
  const text = numbers.slice(0, mostNumbers).join(", ") + (numbers.length > mostNumbers ? ", …" : "");
  on.font = "600 12px system-ui, sans-serif";
  on.textAlign = "left";
  const width = on.measureText(text).width;
  const beside: [number, number][] = [
    [marker.x + radius + 4, marker.y],
    [marker.x - width / 2, marker.y - radius - 9],
    [marker.x - width / 2, marker.y + radius + 10],
    [marker.x - radius - 4 - width, marker.y],
  ];
  const boxAt = ([x, y]: [number, number]) => ({ left: x, top: y - 6, right: x + width, bottom: y + 6 });
  const place = beside.find((at) => !taken.some((other) => overlap(boxAt(at), other)));
  if (!place) return;
  taken.push(boxAt(place));
  on.lineWidth = 3.5;
  on.strokeStyle = colours.paper;
  on.lineJoin = "round";
  on.strokeText(text, ...place);
  on.fillText(text, ...place);
}
