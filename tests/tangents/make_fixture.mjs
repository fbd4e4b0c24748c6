// Writes fixture.bin: small meshes with hard spots, and for each of their corners the tangent that
// the MikkTSpace reference program gives, by way of the npm package `mikktspace` 1.1.1 (that program
// compiled to WebAssembly). Run it again only to change the meshes:
//
//   npm install --prefix FOLDER mikktspace@1.1.1
//   MIKKTSPACE_HOME=FOLDER node make_fixture.mjs fixture.bin
//
// Layout, little-endian: u32 mesh count; per mesh: u32 length and bytes of its name, u32 vertex
// count, u32 triangle count, vertices (f32: position 3, normal 3, uv 2), triangles (u32: 3), corners
// (f32: tangent 3 and w as glTF means it: the reference's sign turned around).
import { writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { resolve } from "node:path";

const require = createRequire(resolve(process.env.MIKKTSPACE_HOME ?? ".", "package.json"));
const { generateTangents } = require("mikktspace");

// A fixed sequence in [0, 1).
let state = 12345;
const random = () => {
  state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
  return state / 4294967296;
};
const unit = (v) => v.map((x) => x / Math.hypot(...v));

// columns x rows quads over point(s, t) -> {position, normal, uv}, s and t from 0 to 1.
function grid(columns, rows, point) {
  const vertices = [], triangles = [];
  for (let r = 0; r <= rows; ++r)
    for (let c = 0; c <= columns; ++c) vertices.push(point(c / columns, r / rows, c, r));
  for (let r = 0; r < rows; ++r)
    for (let c = 0; c < columns; ++c) {
      const a = r * (columns + 1) + c, b = a + 1, d = a + columns + 1;
      triangles.push([a, d, b], [b, d, d + 1]);
    }
  return { vertices, triangles };
}

// Rows of triangles without extent at the poles, and a seam.
const sphere = () =>
  grid(16, 9, (s, t, c, r) => {
    const ring = r === 0 || r === 9 ? 0 : Math.sin(Math.PI * t);
    const p = [ring * Math.cos(2 * Math.PI * (c % 16) / 16), Math.cos(Math.PI * t),
               ring * Math.sin(2 * Math.PI * (c % 16) / 16)];
    return { position: p, normal: unit(p), uv: [s, t] };
  });

// The texture is mirrored where x = 0, at vertices that both sides share.
const mirrored = () =>
  grid(8, 5, (s, t) => {
    const x = 2 * s - 1, y = 0.15 * Math.sin(3 * x) * Math.cos(4 * t);
    return { position: [x, y, t], normal: unit([-0.4 * Math.cos(3 * x), 1, 0.3 * t]),
             uv: [Math.abs(x), t] };
  });

// Six faces whose normals differ at the edges.
function cube() {
  const vertices = [], triangles = [];
  for (let axis = 0; axis < 3; ++axis)
    for (const side of [-1, 1]) {
      const first = vertices.length;
      for (const [u, v] of [[0, 0], [1, 0], [1, 1], [0, 1]]) {
        const position = [0, 0, 0], normal = [0, 0, 0];
        position[axis] = normal[axis] = side;
        position[(axis + 1) % 3] = (2 * u - 1) * side;
        position[(axis + 2) % 3] = 2 * v - 1;
        vertices.push({ position, normal, uv: axis === 1 ? [v, u] : [u, v] });
      }
      triangles.push([first, first + 1, first + 2], [first, first + 2, first + 3]);
    }
  return { vertices, triangles };
}

// Seams in both directions; vertices share position, normal and (except at seams) coordinates.
const torus = () =>
  grid(18, 9, (s, t, c, r) => {
    const a = 2 * Math.PI * (c % 18) / 18, b = 2 * Math.PI * (r % 9) / 9;
    const n = [Math.cos(a) * Math.cos(b), Math.sin(b), Math.sin(a) * Math.cos(b)];
    const p = [Math.cos(a) + 0.4 * n[0], 0.4 * n[1], Math.sin(a) + 0.4 * n[2]];
    return { position: p, normal: n, uv: [3 * s + 0.2 * t, t] };
  });

// Some vertices take their neighbour's coordinates: triangles that span no area in the texture.
const collapsed = () =>
  grid(10, 8, (s, t) => {
    const p = [s, 0.3 * random(), t];
    const uv = random() < 0.45 ? [Math.floor(3 * s) / 3, Math.floor(3 * t) / 3] : [s, t];
    return { position: p, normal: unit([random() - 0.5, 1, random() - 0.5]), uv };
  });

// One apex for an even number of sides: directions around it are opposed in pairs.
function cone() {
  const vertices = [{ position: [0, 1, 0], normal: [0, 1, 0], uv: [0.5, 0] }], triangles = [];
  for (let i = 0; i <= 12; ++i) {
    const a = 2 * Math.PI * i / 12, x = Math.cos(a), z = Math.sin(a);
    vertices.push({ position: [x, 0, z], normal: unit([x, 1, z]), uv: [i / 12, 1] });
    if (i > 0) triangles.push([0, i + 1, i]);
  }
  return { vertices, triangles };
}

// A card folded back on itself around x = 0, with the normal along the fold's outside.
function folded() {
  const at = (x, y, z, u, n) => ({ position: [x, y, z], normal: n, uv: [u, z] });
  const vertices = [at(0, 0, 0, 0, [0, 1, 0]), at(0, 0, 1, 0, [0, 1, 0]),
                    at(1, 0, 0, 1, [0, 1, 0]), at(1, 0, 1, 1, [0, 1, 0]),
                    at(1, 0, 0, -1, [0, 1, 0]), at(1, 0, 1, -1, [0, 1, 0])];
  return { vertices, triangles: [[0, 1, 2], [2, 1, 3], [0, 4, 1], [4, 5, 1]] };
}

// Fins on shared edges (some with opposite winding), and triangles with few distinct positions and
// coordinates: not modelled by anyone, but found in files. Positions are not collinear or opposite, so
// that no decision depends on rounding.
function soup() {
  const positions = Array.from({ length: 24 }, () => [random(), random(), random()]);
  const normals = positions.map(() => unit([random() - 0.5, random() - 0.5, 1]));
  const corners = positions.map(() => [[random(), random()], [random(), random()]]);
  const vertices = [], triangles = [];
  const pick = () => Math.floor(24 * random());
  for (let t = 0; t < 220; ++t) {
    // Neighbouring positions, so that edges repeat.
    const a = pick(), step = 1 + Math.floor(3 * random());
    const ids = [a, (a + step) % 24, (a + 2) % 24];
    if (random() < 0.3) ids.reverse();
    const flat = random() < 0.12;
    triangles.push(ids.map((i) => {
      vertices.push({ position: positions[i], normal: normals[i],
                      uv: corners[flat ? a : i][random() < 0.2 ? 1 : 0] });
      return vertices.length - 1;
    }));
  }
  return { vertices, triangles };
}

// Three triangles and more on one edge, taken in the file's order.
function fins() {
  const vertices = [{ position: [0, 0, 0], normal: [0, 0, 1], uv: [0, 0] },
                    { position: [0, 1, 0], normal: [0, 0, 1], uv: [0, 1] }];
  const triangles = [];
  for (let i = 0; i < 9; ++i) {
    const a = 0.3 + 0.6 * i;
    vertices.push({ position: [Math.cos(a), 0.5 + 0.1 * i, 0.8 * Math.sin(a)],
                    normal: unit([Math.cos(a), 0, 2]),
                    uv: [(i % 4 === 3 ? -1 : 1) * (0.7 + 0.1 * i), 0.3 + 0.05 * i] });
    triangles.push(i % 3 === 1 ? [1, 0, i + 2] : [0, 1, i + 2]);
  }
  return { vertices, triangles };
}

const meshes = { sphere: sphere(), mirrored: mirrored(), cube: cube(), torus: torus(),
                 collapsed: collapsed(), cone: cone(), folded: folded(), fins: fins(),
                 soup: soup() };
const parts = [];
const u32 = (...values) => parts.push(Buffer.from(Uint32Array.from(values).buffer));
const f32 = (values) => parts.push(Buffer.from(Float32Array.from(values).buffer));
u32(Object.keys(meshes).length);
for (const [name, { vertices, triangles }] of Object.entries(meshes)) {
  const corners = triangles.flat().map((i) => vertices[i]);
  const flat = (key) => Float32Array.from(corners.flatMap((v) => v[key]));
  const tangents = generateTangents(flat("position"), flat("normal"), flat("uv"));
  u32(name.length);
  parts.push(Buffer.from(name));
  u32(vertices.length, triangles.length);
  for (const v of vertices) f32([...v.position, ...v.normal, ...v.uv]);
  u32(...triangles.flat());
  f32(tangents.map((x, i) => (i % 4 === 3 ? -x : x)));
}
const bytes = Buffer.concat(parts);
writeFileSync(process.argv[2], bytes);
console.log(`${Object.keys(meshes).length} meshes, ${bytes.length} bytes`);
