// Clips to a box in doubles, so that what is drawn stays sharp however far the view is zoomed in:
// float32 would move lines whose ends are far outside.

import type { Box } from "./box";

/// Appends the part of the segment within the box to `out`: 4 numbers, or nothing.
export function clipSegment(
  box: Box, ax: number, ay: number, bx: number, by: number, out: number[],
): void {
  const dx = bx - ax;
  const dy = by - ay;
  let first = 0;
  let last = 1;
  // Liang and Barsky: where the segment passes each side.
  const passes = (step: number, room: number): boolean => {
    if (step === 0) return room >= 0;
    const t = room / step;
    if (step < 0) first = Math.max(first, t);
    else last = Math.min(last, t);
    return first <= last;
  };
  if (
    !passes(-dx, ax - box.left) ||
    !passes(dx, box.right - ax) ||
    !passes(-dy, ay - box.top) ||
    !passes(dy, box.bottom - ay)
  )
    return;
  out.push(
    first === 0 ? ax : ax + first * dx,
    first === 0 ? ay : ay + first * dy,
    last === 1 ? bx : ax + last * dx,
    last === 1 ? by : ay + last * dy,
  );
}

type Ring = [number, number][];

/// The ring within the box, as Sutherland and Hodgman clip it: even-odd filling of what is left
/// is right within the box.
export function clipRing(box: Box, ring: Ring): Ring {
  const sides: [0 | 1, number, number][] = [
    [0, box.left, 1],
    [0, box.right, -1],
    [1, box.top, 1],
    [1, box.bottom, -1],
  ];
  for (const [axis, limit, sign] of sides) {
    const kept: Ring = [];
    for (let i = 0; i < ring.length; ++i) {
      const p = ring[i];
      const q = ring[(i + 1) % ring.length];
      const pIn = (p[axis] - limit) * sign >= 0;
      const qIn = (q[axis] - limit) * sign >= 0;
      if (pIn) kept.push(p);
      if (pIn === qIn) continue;
      const t = (limit - p[axis]) / (q[axis] - p[axis]);
      const cut: [number, number] = [p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])];
      cut[axis] = limit;
      kept.push(cut);
    }
    ring = kept;
  }
  return ring;
}
