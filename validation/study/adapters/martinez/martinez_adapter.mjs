// martinez-polygon-clipping: Martinez, Rueda and Feito's algorithm in doubles, folded over the rings.

import {union, xor} from 'martinez-polygon-clipping';
import {modelOfPolygons, opened, serve, versionOf} from './serve.mjs';

const closed = (ring) => [...ring, ring[0]];

async function run({rings, rule}, clock) {
  const [first, ...others] = rings.map((ring) => [closed(ring)]);
  if (!first) return modelOfPolygons([]);
  const combine = rule === 'nonzero' ? union : xor;
  const found = await clock.time(() => others.reduce((all, polygon) => combine(all, polygon) ?? [], first));
  const isPolygon = typeof found[0]?.[0]?.[0] === 'number';
  const polygons = found.length === 0 ? [] : isPolygon ? [found] : found;
  return modelOfPolygons(polygons.map((polygon) => polygon.map(opened)));
}

serve({
  engine: 'martinez',
  input: 'rings',
  takes: ['simple evenodd', 'simple nonzero'],
  title: 'martinez-polygon-clipping',
  version: versionOf('martinez-polygon-clipping'),
  algorithm: 'martinez-polygon-clipping',
  licence: 'MIT',
  configurations: [
    {
      name: 'fold',
      title: 'union or xor, one by one',
      tolerance: {kind: 'none', value: 0},
      source: 'README: union and xor take two geometries, so that many are folded',
      run,
    },
  ],
});
