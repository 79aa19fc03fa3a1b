// polyclip-ts: Martinez, Rueda and Feito's algorithm in decimal numbers of any length; quotients are rounded.

import {union, xor} from 'polyclip-ts';
import {modelOfPolygons, opened, serve, versionOf} from './serve.mjs';

async function run({rings, rule}, clock) {
  const polygons = rings.map((ring) => [ring]);
  if (polygons.length === 0) return modelOfPolygons([]);
  const found = await clock.time(() => (rule === 'nonzero' ? union : xor)(...polygons));
  return modelOfPolygons(found.map((polygon) => polygon.map(opened)));
}

serve({
  engine: 'polyclip_ts',
  input: 'rings',
  takes: ['simple evenodd', 'simple nonzero', 'crossing nonzero'],
  title: 'polyclip-ts',
  version: versionOf('polyclip-ts'),
  algorithm: 'polyclip-ts',
  licence: 'MIT',
  configurations: [
    {
      name: 'all-at-once',
      title: 'union or xor of all',
      tolerance: {kind: 'none', value: 0},
      source: "README: 'All functions take one or more [multi]polygon(s)'; rings that cross themselves by the non-zero rule",
      run,
    },
  ],
});
