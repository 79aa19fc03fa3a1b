// Findings on the stage: rings with numbers; those that would overlap are one disc with their count.

import { Box, emptyBox, grow } from "./box";
import type { Drawing } from "./drawing";
import type { Finding } from "./report";
import type { View } from "./view";

const cell = 30; // pixels; findings nearer than this share a marker
const reach = 14; // of the pointer

export interface Marker {
  x: number; // on the stage
  y: number;
  findings: Finding[];
  box: Box; // of the places, in the drawing
}

/// The findings in view.
export function markersOf(findings: Finding[], drawing: Drawing, view: View): Marker[] {
  const markers = new Map<string, Marker>();
  const visible = view.visible(cell);
  const { k, x: shiftX, y: shiftY } = view.transform;
  for (const finding of findings) {
    if (!finding.where) continue;
    const [px, py] = drawing.local(finding.where.nearest);
    if (px < visible.left || px > visible.right || py < visible.top || py > visible.bottom) continue;
    // Cells hold still while the view pans.
    const key = `${Math.floor((px * k) / cell)} ${Math.floor((py * k) / cell)}`;
    let marker = markers.get(key);
    if (!marker) {
      marker = { x: px * k + shiftX, y: py * k + shiftY, findings: [], box: emptyBox() };
      markers.set(key, marker);
    }
    marker.findings.push(finding);
    grow(marker.box, px, py);
  }
  return [...markers.values()];
}

export function markerAt(markers: Marker[], x: number, y: number): Marker | undefined {
  let best: Marker | undefined;
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

export function drawMarker(
  on: CanvasRenderingContext2D, marker: Marker, chosen: boolean, colours: MarkerColours,
): void {
  const count = marker.findings.length;
  const text = String(count === 1 ? marker.findings[0].number : count);
  const radius = count === 1 ? 7 : 9 + Math.min(Math.log2(count), 6);
  on.lineWidth = chosen ? 3 : 2;
  on.strokeStyle = colours.mark;
  on.beginPath();
  on.arc(marker.x, marker.y, radius, 0, 2 * Math.PI);
  on.font = `600 ${count === 1 ? 12 : 11}px system-ui, sans-serif`;
  if (count > 1) {
    on.fillStyle = colours.mark;
    on.fill();
    on.fillStyle = colours.paper;
    on.textAlign = "center";
    on.textBaseline = "middle";
    on.fillText(text, marker.x, marker.y + 0.5);
    return;
  }
  on.stroke();
  on.textAlign = "left";
  on.textBaseline = "middle";
  on.lineWidth = 3.5;
  on.strokeStyle = colours.paper;
  on.lineJoin = "round";
  on.strokeText(text, marker.x + radius + 4, marker.y);
  on.fillStyle = colours.mark;
  on.fillText(text, marker.x + radius + 4, marker.y);
}
