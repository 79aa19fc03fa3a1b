// The protocol of adapters, for engines in JavaScript: cases in, models out. ../README.md has it.

import {performance} from 'node:perf_hooks';
import {createInterface} from 'node:readline';
import {readFileSync} from 'node:fs';

/** What an engine says of itself that failed, with the engine's own word for it. */
export class EngineError extends Error {
  constructor(kind, message) {
    super(message);
    this.kind = kind;
  }
}

/** A tolerance that an engine cannot have. */
export class BadTolerance extends EngineError {
  constructor(message) {
    super('BadTolerance', message);
  }
}

/** Of the package that npm installed; this file is linked beside node_modules. */
export function versionOf(name) {
  return JSON.parse(readFileSync(`${process.cwd()}/node_modules/${name}/package.json`, 'utf8')).version;
}

/**
 * Runs an adapter: lists it, or answers the cases of standard input. `engine` has engine, title, version, algorithm,
 * licence and configurations; of each configuration `run` gets segments [ax, ay, bx, by], of which none is of length 0,
 * a clock whose `time(f)` is to be called with what the engine does, and the tolerance: the configuration's, or that of the
 * case. It returns, or promises, a model. Where the engine's `input` is 'rings', `run` gets {rings, rule} instead of
 * segments. `repairs` are, with the argument --repairs, configurations instead of these.
 */
export async function serve({configurations, repairs = [], ...named}) {
  const isRepair = process.argv[2] === '--repairs';
  const wanted = process.argv[isRepair ? 3 : 2];
  const engine = {...named, configurations: isRepair ? repairs : configurations};
  if (wanted === '--list') {
    console.log(JSON.stringify(engine, (key, value) => (key === 'run' ? undefined : value)));
    return;
  }
  const configuration = engine.configurations.find(({name}) => name === wanted);
  if (!configuration) {
    console.error('usage: --list, or one of the configurations that it lists');
    process.exitCode = 2;
    return;
  }
  console.log = console.info = console.error; // standard output is for answers alone
  for await (const line of createInterface({input: process.stdin})) {
    process.stdout.write(JSON.stringify(await answer(configuration, JSON.parse(line))) + '\n');
  }
}

function toleranceOf({tolerance: {kind, value}}, {tolerance: wanted}) {
  if (wanted === undefined) return value;
  if (kind === 'none') throw new BadTolerance('this configuration has no tolerance');
  if (!Number.isFinite(wanted) || wanted < 0) throw new BadTolerance('a tolerance is a number, not below 0');
  if (kind === 'grid' && wanted === 0) throw new BadTolerance('a grid has a distance above 0');
  return wanted;
}

async function answer(configuration, given) {
  const input = given.rings ? ringsOf(given) : segmentsOf(given);
  const clock = {
    seconds: 0,
    async time(work) {
      const began = performance.now();
      try {
        return await work();
      } finally {
        this.seconds += (performance.now() - began) / 1000;
      }
    },
  };
  let said;
  try {
    const model = await configuration.run(input, clock, toleranceOf(configuration, given));
    if (!model.V.every((point) => point.every(Number.isFinite))) {
      throw new EngineError('NotFinite', 'coordinates of the result are not finite');
    }
    said = {model};
  } catch (error) {
    const kind = error.kind ?? error.name ?? error.constructor?.name ?? 'Error';
    said = {error: {class: String(kind), message: String(error.message ?? error).slice(0, 500)}};
  }
  return {case: given.case, seconds: clock.seconds, ...said};
}

function segmentsOf(given) {
  return given.segments
    .map((segment) => segment.map((x) => x + 0)) // no -0
    .filter(([ax, ay, bx, by]) => ax !== bx || ay !== by);
}

function ringsOf({rings, rule}) {
  return {rings: rings.map((ring) => ring.map(([x, y]) => [x + 0, y + 0])), rule};
}

/** A model of polygons: of each its rings of points [x, y], the outer one first, none with its first point again. */
export function modelOfPolygons(polygons) {
  const number = new Numbering();
  const numbered = polygons.map((rings) => rings.map((ring) => ring.map(([x, y]) => number.of(x, y))));
  return {V: number.points, EV: eachOnce(numbered.flat().flatMap(sidesOf)), polygons: numbered};
}

/** A model of rings in no order, which are even-odd. */
export function modelOfRings(rings) {
  const number = new Numbering();
  const numbered = rings.map((ring) => ring.map(([x, y]) => number.of(x, y)));
  return {V: number.points, EV: eachOnce(numbered.flatMap(sidesOf)), rings: numbered};
}

const sidesOf = (ring) => ring.map((v, i) => [v, ring[(i + 1) % ring.length]]);

/** A ring without the first point again at its end. */
export function opened(ring) {
  const last = ring.length - 1;
  const isClosed = last > 0 && ring[0][0] === ring[last][0] && ring[0][1] === ring[last][1];
  return isClosed ? ring.slice(0, last) : ring;
}

/** Numbers points in the order in which they come, equal ones alike. */
export class Numbering {
  points = [];
  #number = new Map();

  of(x, y) {
    const key = `${x + 0},${y + 0}`;
    let number = this.#number.get(key);
    if (number === undefined) {
      number = this.points.length;
      this.#number.set(key, number);
      this.points.push([x + 0, y + 0]);
    }
    return number;
  }
}

/** Pairs of vertices, each once in either direction, without those of one vertex alone. */
export function eachOnce(pairs) {
  const once = new Map();
  for (const [a, b] of pairs) {
    if (a !== b) once.set(a < b ? `${a},${b}` : `${b},${a}`, a < b ? [a, b] : [b, a]);
  }
  return [...once.values()];
}
