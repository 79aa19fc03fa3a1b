// @velipso/polybool: regions united, or combined by symmetric difference, one by one.

import {GeometryEpsilon, PolyBool} from '@velipso/polybool';
import {modelOfRings, serve, versionOf} from './serve.mjs';

function withEpsilon(epsilon) {
  const polybool = new PolyBool(new GeometryEpsilon(epsilon));
  return async ({rings, rule}, clock) => {
    if (rings.length === 0) return modelOfRings([]);
    const select = rule === 'nonzero' ? 'selectUnion' : 'selectXor';
    const found = await clock.time(() => {
      const each = rings.map((ring) => polybool.segments({regions: [ring], inverted: false}));
      return polybool.polygon(each.reduce((a, b) => polybool[select](polybool.combine(a, b))));
    });
    return modelOfRings(found.regions);
  };
}

serve({
  engine: 'polybool',
  input: 'rings',
  takes: ['simple evenodd', 'simple nonzero'],
  title: '@velipso/polybool',
  version: versionOf('@velipso/polybool'),
  algorithm: '@velipso/polybool',
  licence: '0BSD',
  configurations: [
    {
      name: 'epsilon-1e-10',
      title: 'selectUnion or selectXor, epsilon 1e-10',
      tolerance: {kind: 'snap', value: 1e-10},
      source: "README, Advanced Example 1: union of a list by combine and selectUnion; 'The default epsilon value is 0.0000000001'",
      run: withEpsilon(1e-10),
    },
  ],
});
