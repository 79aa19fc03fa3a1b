// clean-pslg: iterated snap rounding with rational crossings; faces by planar-dual, which walks around them.

import cleanPSLG from 'clean-pslg';
import planarDual from 'planar-dual';
import {polygonsOfLoops} from './loops.mjs';
import {Numbering, eachOnce, serve, versionOf} from './serve.mjs';

async function run(segments, clock) {
  const number = new Numbering();
  const edges = segments.map(([ax, ay, bx, by]) => [number.of(ax, ay), number.of(bx, by)]);
  const points = number.points;
  if (!edges.length) return {V: [], EV: [], polygons: []};
  const [noded, walks] = await clock.time(() => {
    cleanPSLG(points, edges);
    const noded = eachOnce(edges); // it leaves edges from a vertex to itself
    return [noded, planarDual(noded, points)];
  });
  const faces = walks.filter((walk) => walk.length > 1).map((walk) => walk.reverse()); // planar-dual's go clockwise
  return {V: points, EV: noded, polygons: polygonsOfLoops(faces, points)};
}

serve({
  engine: 'clean_pslg',
  title: 'clean-pslg, planar-dual',
  version: `${versionOf('clean-pslg')}, planar-dual ${versionOf('planar-dual')}`,
  algorithm: 'clean-pslg',
  licence: 'MIT',
  configurations: [
    {
      name: 'clean',
      title: 'cleanPSLG',
      tolerance: {kind: 'none', value: 0},
      source: 'README of clean-pslg: cleanPSLG(points, edges), the only way to call it',
      run,
    },
  ],
});
