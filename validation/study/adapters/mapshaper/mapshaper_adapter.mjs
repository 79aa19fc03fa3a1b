// mapshaper: lines to polygons by its command -polygons, which cuts lines where they cross. It says no edges.

import mapshaper from 'mapshaper';
import {withoutBridges} from './loops.mjs';
import {BadTolerance, EngineError, Numbering, serve, versionOf} from './serve.mjs';

function withCommands(commands) {
  return async (segments, clock, tolerance) => {
    if (!segments.length) return {V: [], polygons: []};
    const lines = segments.map(([ax, ay, bx, by]) => ({type: 'LineString', coordinates: [[ax, ay], [bx, by]]}));
    const input = JSON.stringify({type: 'GeometryCollection', geometries: lines});
    const output = await clock.time(() =>
      mapshaper.applyCommands(`-quiet -i in.json ${commands(tolerance)} -o out.json format=geojson`, {'in.json': input}));
    if (!output['out.json']) throw new EngineError('NoOutput', 'mapshaper wrote no file');
    return modelOf(JSON.parse(output['out.json']));
  };
}

function snapWithin(tolerance) {
  if (!tolerance) throw new BadTolerance('0 is its automatic interval');
  return `snap snap-interval=${tolerance} -polygons`;
}

function repairWithin(tolerance) {
  return `snap snap-interval=${tolerance} -polygons gap-tolerance=${tolerance} -clean gap-width=${tolerance}`;
}

function modelOf({geometries = [], features = []}) {
  const number = new Numbering();
  const polygons = [...geometries, ...features.map(({geometry}) => geometry)]
    .filter((geometry) => geometry)
    .flatMap(({type, coordinates}) => (type === 'Polygon' ? [coordinates] : coordinates))
    .map((rings) => rings.map((ring) => ring.slice(0, -1).map(([x, y]) => number.of(x, y))));
  return {V: number.points, polygons: polygons.map((rings) => withoutBridges(rings, number.points))};
}

serve({
  engine: 'mapshaper',
  title: 'mapshaper',
  version: versionOf('mapshaper'),
  algorithm: 'mapshaper',
  licence: 'MPL-2.0',
  configurations: [
    {
      name: 'polygons',
      title: '-polygons',
      tolerance: {kind: 'none', value: 0},
      source: 'help of -polygons: "convert polylines to polygons"; no gap tolerance',
      run: withCommands(() => '-polygons'),
    },
    {
      name: 'snap-1e-9-polygons',
      title: '-i snap-interval=1e-9, -polygons',
      tolerance: {kind: 'snap', value: 1e-9, way: '-i snap-interval, -polygons', promise: 'some'}, // vertices, no crossings
      source: 'help of -i: snap, snap-interval, whose "default is tiny"',
      run: withCommands(snapWithin),
    },
  ],
  repairs: [
    {
      name: 'clean',
      title: 'snap, -polygons with a gap tolerance, -clean',
      tolerance: {kind: 'snap', value: 1e-9, way: 'snap, -polygons with a gap tolerance, -clean'},
      source: 'help of -polygons: "specify gap tolerance in source units"; of -clean: "fill gaps narrower than this width"',
      run: withCommands(repairWithin),
    },
  ],
});
