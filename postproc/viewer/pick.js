// The nearest point of the shown surface on a line of sight: {at, value, triangle}; coordinates as in renderer.js.
const pickSurface = (mesh, values, ranges, camera, x, y, plane) => {
  const from = camera.unproject(x, y), { places, corners, step } = mesh;
  let best = null;
  // The corner `k` of triangle `t`, seen along the line.
  const u = new Float64Array(3), v = new Float64Array(3), w = new Float64Array(3);
  const origin = sub(mesh.from, from), { right, up, toward } = camera;
  const o = [dot(origin, right), dot(origin, up), dot(origin, toward)];
  for (const { first, count } of ranges) {
    for (let t = first; t < first + count; t += 3) {
      let low = 0, high = 0, below = 0, above = 0;
      for (let k = 0; k < 3; ++k) {
        const i = 4 * corners[t + k], px = places[i] * step, py = places[i + 1] * step, pz = places[i + 2] * step;
        u[k] = o[0] + px * right[0] + py * right[1] + pz * right[2];
        v[k] = o[1] + px * up[0] + py * up[1] + pz * up[2];
        w[k] = o[2] + px * toward[0] + py * toward[1] + pz * toward[2];
        if (u[k] < 0) ++low; else ++high;
        if (v[k] < 0) ++below; else ++above;
      }
      if (low === 3 || high === 3 || below === 3 || above === 3) continue;
      const area = (u[1] - u[0]) * (v[2] - v[0]) - (u[2] - u[0]) * (v[1] - v[0]);
      if (area === 0) continue;
      const b = (u[2] * v[0] - u[0] * v[2]) / area, c = (u[0] * v[1] - u[1] * v[0]) / area, a = 1 - b - c;
      if (a < 0 || b < 0 || c < 0) continue;
      const depth = a * w[0] + b * w[1] + c * w[2];
      if (best && depth <= best.depth) continue;
      const at = add(from, times(toward, depth));
      if (plane && dot(plane.normal, at) > plane.offset) continue;
      best = { depth, at, triangle: t, weights: [a, b, c] };
    }
  }
  if (!best) return null;
  let value = 0, share = 0;
  best.weights.forEach((weight, k) => {
    const one = values[corners[best.triangle + k]];
    value += weight * one;
    share += one > 0 ? weight : 0;
  });
  return { at: best.at, value: share >= 0.5 ? value / share / 65535 : 0 };
};
