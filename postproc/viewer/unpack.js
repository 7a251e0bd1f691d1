// The scene as C++ wrote it (postproc/viewer/payload.h): base64, deflated, JSON and planes of numbers.
const unpackScene = async text => {
  const letters = atob(text), packed = new Uint8Array(letters.length);
  for (let i = 0; i < packed.length; ++i) packed[i] = letters.charCodeAt(i);
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate'));
  const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
  const head = new DataView(bytes.buffer).getUint32(0, true);
  const json = JSON.parse(new TextDecoder().decode(bytes.subarray(4, 4 + head)));
  return { json, planes: bytes.subarray(4 + head) };
};

const numbersOf = (planes, { at, count, bytes }) => {
  const out = new Uint32Array(count);
  const [a, b, c, d] = [0, 1, 2, 3].map(plane => planes.subarray(at + plane * count, at + (plane + 1) * count));
  if (bytes === 1) out.set(a);
  else if (bytes === 2) for (let i = 0; i < count; ++i) out[i] = a[i] | b[i] << 8;
  else if (bytes === 3) for (let i = 0; i < count; ++i) out[i] = a[i] | b[i] << 8 | c[i] << 16;
  else for (let i = 0; i < count; ++i) out[i] = a[i] | b[i] << 8 | c[i] << 16 | d[i] << 24;
  return out;
};

// Those that were written as folded differences.
const summedOf = (planes, run) => {
  const out = numbersOf(planes, run), mask = run.bytes === 4 ? 0xffffffff : (1 << (8 * run.bytes)) - 1;
  let last = 0;
  for (let i = 0; i < out.length; ++i) {
    const folded = out[i];
    last = (last + (folded & 1 ? ~(folded >>> 1) : folded >>> 1)) & mask;
    out[i] = last;
  }
  return out;
};

const cornersOf = (planes, run) => {
  const out = numbersOf(planes, run);
  let next = 0;
  for (let i = 0; i < out.length; ++i) {
    const back = out[i];
    out[i] = next - back;
    if (back === 0) ++next;
  }
  return out;
};

const meshOf = (planes, json) => {
  const parts = json.positions.map(run => summedOf(planes, run)), count = parts[0].length;
  const places = new Uint16Array(4 * count), normals = new Uint8Array(2 * count);
  for (let axis = 0; axis < 3; ++axis) for (let i = 0; i < count; ++i) places[4 * i + axis] = parts[axis][i];
  json.normals.forEach((run, k) => {
    const part = summedOf(planes, run);
    for (let i = 0; i < count; ++i) normals[2 * i + k] = part[i];
  });
  return { origin: json.origin, step: json.step, count, places, normals,
           corners: cornersOf(planes, json.corners), edges: summedOf(planes, json.edges) };
};

// 1 where the triangles of a closed mesh face outward as a whole, -1 where inward.
const facingOf = ({ corners, places }, { first, count }) => {
  let volume = 0;
  const at = i => [places[4 * corners[i]] - 32768, places[4 * corners[i] + 1] - 32768, places[4 * corners[i] + 2] - 32768];
  for (let i = first; i < first + count; i += 3) {
    const [ax, ay, az] = at(i), [bx, by, bz] = at(i + 1), [cx, cy, cz] = at(i + 2);
    volume += ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx);
  }
  return Math.sign(volume);
};

const fromOctahedron = (u, v, top) => {
  let x = u / top * 2 - 1, y = v / top * 2 - 1;
  const z = 1 - Math.abs(x) - Math.abs(y);
  if (z < 0) [x, y] = [(1 - Math.abs(y)) * (x < 0 ? -1 : 1), (1 - Math.abs(x)) * (y < 0 ? -1 : 1)];
  return unit([x, y, z]);
};

const pathOf = (planes, json) => {
  const tips = json.tips.map(run => summedOf(planes, run)), axes = json.axes.map(run => summedOf(planes, run));
  const count = tips[0].length, states = numbersOf(planes, json.states), t = numbersOf(planes, json.t);
  return {
    name: json.name, count, moveCount: json.moves_of_path,
    tip: i => [0, 1, 2].map(k => json.origin[k] + tips[k][i] * json.step),
    axis: i => fromOctahedron(axes[0][i], axes[1][i], 65534),
    move: summedOf(planes, json.moves), line: summedOf(planes, json.lines), tool: numbersOf(planes, json.tools),
    depth: numbersOf(planes, json.depths),
    t: i => t[i] / 65535, state: i => states[i] & 7, kind: i => states[i] >> 3 & 3, isStart: i => (states[i] & 32) !== 0,
  };
};
