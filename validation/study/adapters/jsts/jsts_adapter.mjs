// JSTS: JTS before its new overlay, in JavaScript. Lines are noded by union or by snap rounding, then polygonized.

import ArrayList from 'jsts/java/util/ArrayList.js';
import Coordinate from 'jsts/org/locationtech/jts/geom/Coordinate.js';
import GeometryFactory from 'jsts/org/locationtech/jts/geom/GeometryFactory.js';
import PrecisionModel from 'jsts/org/locationtech/jts/geom/PrecisionModel.js';
import GeometryNoder from 'jsts/org/locationtech/jts/noding/snapround/GeometryNoder.js';
import Polygonizer from 'jsts/org/locationtech/jts/operation/polygonize/Polygonizer.js';
import UnaryUnionOp from 'jsts/org/locationtech/jts/operation/union/UnaryUnionOp.js';
import {Numbering, eachOnce, serve, versionOf} from './serve.mjs';

const GRID = 1e-9;
const factory = new GeometryFactory();

function union(lines) {
  const noded = UnaryUnionOp.union(factory.createMultiLineString(lines));
  return Array.from({length: noded.getNumGeometries()}, (_, i) => noded.getGeometryN(i));
}

/** GeometryNoder takes lines whose ends are on the grid. */
function snapRound(lines, grid) {
  const precision = new PrecisionModel(scaleOf(grid));
  const given = new ArrayList();
  for (const line of lines) {
    const ends = line.getCoordinates().map(({x, y}) =>
      new Coordinate(precision.makePrecise(x), precision.makePrecise(y)));
    if (!ends[0].equals2D(ends[1])) given.add(factory.createLineString(ends));
  }
  return given.isEmpty() ? [] : new GeometryNoder(precision).node(given).toArray();
}

/** Of grids of powers of ten the integer; 1 / 1e-9 is another double. */
function scaleOf(grid) {
  const integer = Math.round(1 / grid);
  return 1 / integer === grid ? integer : 1 / grid;
}

function nodedBy(node) {
  return async (segments, clock, tolerance) => {
    const lines = segments.map(([ax, ay, bx, by]) =>
      factory.createLineString([new Coordinate(ax, ay), new Coordinate(bx, by)]));
    const [noded, polygons] = await clock.time(() => {
      const noded = node(lines, tolerance);
      const polygonizer = new Polygonizer();
      for (const piece of piecesOf(noded)) polygonizer.add(factory.createLineString(piece));
      return [noded, polygonizer.getPolygons().toArray()];
    });
    const number = new Numbering();
    const numbered = ({x, y}) => number.of(x, y);
    const rings = (polygon) => [
      polygon.getExteriorRing(),
      ...Array.from({length: polygon.getNumInteriorRing()}, (_, i) => polygon.getInteriorRingN(i)),
    ];
    return {
      EV: eachOnce(piecesOf(noded).map((piece) => piece.map(numbered))),
      polygons: polygons.map((polygon) =>
        rings(polygon).map((ring) => ring.getCoordinates().slice(0, -1).map(numbered))),
      V: number.points,
    };
  };
}

/** Noded lines as pieces of two points, each once. */
function piecesOf(lines) {
  const pieces = new Map();
  for (const line of lines) {
    const points = line.getCoordinates();
    for (let i = 1; i < points.length; ++i) {
      const ends = [points[i - 1], points[i]].sort((a, b) => a.compareTo(b));
      if (!ends[0].equals2D(ends[1])) pieces.set(ends.map(({x, y}) => `${x},${y}`).join(), ends);
    }
  }
  return [...pieces.values()];
}

serve({
  engine: 'jsts',
  title: 'JSTS',
  version: versionOf('jsts'),
  algorithm: 'JSTS',
  licence: 'EPL-1.0 or EDL-1.0',
  configurations: [
    {
      name: 'unary-union',
      title: 'UnaryUnionOp',
      tolerance: {kind: 'none', value: 0},
      source: 'API: UnaryUnionOp.union, which nodes lines; then Polygonizer',
      run: nodedBy(union),
    },
    {
      name: 'snap-rounding-1e-9',
      title: 'GeometryNoder 1e-9',
      tolerance: {kind: 'grid', value: GRID, way: 'GeometryNoder'},
      source: 'API: noding/snapround/GeometryNoder with a fixed PrecisionModel',
      run: nodedBy(snapRound),
    },
  ],
});
