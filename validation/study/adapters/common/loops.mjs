// Polygons of the closed walks that go around the faces of a planar graph, one face on the left of each.

import inside from 'robust-point-in-polygon';

/**
 * Polygons as rings of vertices, the outer one first. A walk along a component's outside is a hole of the face that has the
 * component within it; which one that is, exact predicates tell. Edges that a walk passes in both directions bound nothing.
 */
export function polygonsOfLoops(walks, points) {
  const faces = [];
  const outsides = [];
  for (const walk of walks) {
    const rings = withoutTwins(walk);
    const outer = rings.find((ring) => area(ring, points) > 0);
    if (outer) faces.push({outer, area: area(outer, points), holes: rings.filter((ring) => ring !== outer)});
    else outsides.push(...rings);
  }
  faces.sort((a, b) => a.area - b.area);
  const boxes = faces.map(({outer}) => boxOf(outer.map((v) => points[v])));
  for (const ring of outsides) {
    const point = points[ring[0]];
    const around = faces.find(({outer}, i) =>
      isInBox(point, boxes[i]) && inside(outer.map((v) => points[v]), point) < 0);
    if (around) around.holes.push(ring);
  }
  return faces.map(({outer, holes}) => [outer, ...holes]);
}

/** A polygon whose rings may pass edges twice, as bridges to holes: as rings of vertices that pass none, the outer one first. */
export function withoutBridges(rings, points) {
  const size = (ring) => Math.abs(area(ring, points));
  return rings.flatMap(withoutTwins).sort((a, b) => size(b) - size(a));
}

/** The rings that are left of a walk where the edges that it passes twice are taken out. */
function withoutTwins(walk) {
  const rings = [];
  const way = []; // vertices on the way, and for each the edge that led there
  const at = new Map(); // edges on the way, by their ends
  for (let i = 0; i < walk.length; ++i) {
    const from = walk[i];
    const to = walk[(i + 1) % walk.length];
    const twin = at.get(`${to},${from}`);
    if (twin === undefined) {
      at.set(`${from},${to}`, way.length);
      way.push(from);
      continue;
    }
    const between = way.splice(twin);
    for (let k = 0; k < between.length; ++k) at.delete(`${between[k]},${between[k + 1] ?? from}`);
    if (between.length > 1) rings.push(between.slice(1));
  }
  if (way.length) rings.push(way);
  return rings;
}

function boxOf(corners) {
  const box = [Infinity, Infinity, -Infinity, -Infinity];
  for (const [x, y] of corners) {
    box[0] = Math.min(box[0], x);
    box[1] = Math.min(box[1], y);
    box[2] = Math.max(box[2], x);
    box[3] = Math.max(box[3], y);
  }
  return box;
}

function isInBox([x, y], [left, bottom, right, top]) {
  return left <= x && x <= right && bottom <= y && y <= top;
}

/** Twice the signed area. */
function area(ring, points) {
  const [ox, oy] = points[ring[0]];
  return ring.reduce((sum, v, i) => {
    const [ax, ay] = points[v];
    const [bx, by] = points[ring[(i + 1) % ring.length]];
    return sum + (ax - ox) * (by - oy) - (bx - ox) * (ay - oy);
  }, 0);
}
