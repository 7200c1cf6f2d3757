// The booleans of the leaves that csgscope_boolean writes, by manifold-3d:  node benchmark_manifold.mjs DIR LEAVES.json
// DIR holds node_modules/manifold-3d. Prints processor time (the least of three) and the result's volume as JSON.
import { readFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import { join, resolve } from 'node:path';

const [folder, file] = process.argv.slice(2);
const path = join(resolve(folder), 'node_modules', 'manifold-3d', 'manifold.js');
const wasm = await (await import(pathToFileURL(path))).default();
wasm.setup();
const { Manifold, Mesh } = wasm;
const { leaves, expressions } = JSON.parse(readFileSync(file, 'utf8'));

const solids = leaves.map(({ points, triangles }) => {
  if (triangles.length === 0) return Manifold.union([]);
  const mesh = new Mesh({ numProp: 3, vertProperties: Float32Array.from(points), triVerts: Uint32Array.from(triangles) });
  mesh.merge();
  return new Manifold(mesh);
});

function combine() {
  const values = [];
  for (const { kind, leaf, children } of expressions) {
    const operands = children.map((child) => values[child]);
    values.push(kind === 'leaf' ? solids[leaf] : Manifold[kind](operands));
  }
  return values.at(-1);
}

let least = Infinity;
let result;
for (let i = 0; i < 3; ++i) {
  const start = process.cpuUsage();
  result = combine();
  result.getMesh(); // Until somebody asks, only the tree has been built.
  const used = process.cpuUsage(start);
  least = Math.min(least, (used.user + used.system) / 1000);
}
console.log(JSON.stringify({ cpu_ms: least, triangles: result.numTri(), volume: result.volume() }));
