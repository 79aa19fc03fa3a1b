// Clipper2, compiled to WebAssembly: paths on a grid of decimals, united under a fill rule into a tree of rings.

import Clipper2 from 'clipper2-wasm';
import {modelOfPolygons, serve, versionOf} from './serve.mjs';

const engine = await Clipper2();
const RULES = {evenodd: engine.FillRule.EvenOdd, nonzero: engine.FillRule.NonZero};

function pathsOf(rings) {
  const paths = new engine.PathsD();
  for (const ring of rings) {
    const path = new engine.PathD();
    for (const [x, y] of ring) {
      const point = new engine.PointD(x, y, 0);
      path.push_back(point);
      point.delete();
    }
    paths.push_back(path);
    path.delete();
  }
  return paths;
}

function ringOf(node) {
  const path = node.polygon();
  const ring = Array.from({length: path.size()}, (_, i) => path.get(i)).map(({x, y}) => [x, y]);
  path.delete();
  return ring;
}

const childrenOf = (node) => Array.from({length: node.count()}, (_, i) => node.child(i));

/** Polygons of a tree whose levels are outer rings, holes, outer rings within these, and so on. */
function polygonsBelow(node) {
  return childrenOf(node).flatMap((outer) => {
    const holes = childrenOf(outer);
    return [[ringOf(outer), ...holes.map(ringOf)], ...holes.flatMap(polygonsBelow)];
  });
}

function onDecimals(decimals) {
  return async ({rings, rule}, clock) => {
    const [paths, none, tree] = [pathsOf(rings), new engine.PathsD(), new engine.PolyPathD()];
    await clock.time(() =>
      engine.BooleanOpOutD(engine.ClipType.Union, RULES[rule], paths, none, tree, decimals));
    const model = modelOfPolygons(polygonsBelow(tree));
    for (const of of [paths, none, tree]) of.delete();
    return model;
  };
}

// ClipperD scales by the least power of two above that of ten, so its grid is finer than the decimals.
const BITS = {2: 7, 6: 20, 8: 27};
const SOURCES = {
  2: 'clipper.engine.h: ClipperD(int precision = 2), the default',
  6: 'clipper.engine.h, ClipperD: the precision is a number of decimals, for the user to choose',
  8: 'clipper.core.h: CLIPPER2_MAX_DEC_PRECISION = 8',
};

serve({
  engine: 'clipper2',
  input: 'rings',
  takes: ['simple evenodd', 'simple nonzero', 'crossing evenodd', 'crossing nonzero'],
  title: 'Clipper2 (clipper2-wasm)',
  version: versionOf('clipper2-wasm'),
  algorithm: 'Clipper2',
  licence: 'BSL-1.0',
  configurations: [2, 6, 8].map((decimals) => ({
    name: `decimals-${decimals}`,
    title: `Union, ${decimals} decimals`,
    tolerance: {kind: 'grid', value: 2 ** -BITS[decimals]},
    source: SOURCES[decimals],
    run: onDecimals(decimals),
  })),
});
