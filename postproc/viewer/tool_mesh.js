// The tool's profile turned about its axis: x, y, z, then the normal, then the body, by vertex; in the tool's frame.
const toolMesh = runs => {
  const sides = 72, sharp = Math.cos(35 * Math.PI / 180), data = [], corners = [];
  for (const { body, points } of runs) {
    const count = points.length / 2 - 1, normals = [];
    for (let i = 0; i < count; ++i) {
      const dr = points[2 * i + 2] - points[2 * i], dz = points[2 * i + 3] - points[2 * i + 1], l = Math.hypot(dr, dz);
      normals.push(l > 0 ? [dz / l, -dr / l] : [1, 0]);
    }
    const joined = (own, other) => {
      if (!other || own[0] * other[0] + own[1] * other[1] < sharp) return own;
      const sum = [own[0] + other[0], own[1] + other[1]], l = Math.hypot(sum[0], sum[1]);
      return [sum[0] / l, sum[1] / l];
    };
    for (let i = 0; i < count; ++i) {
      const first = data.length / 7;
      const ends = [joined(normals[i], normals[i - 1]), joined(normals[i], normals[i + 1])];
      for (let end = 0; end < 2; ++end) {
        const r = points[2 * (i + end)], z = points[2 * (i + end) + 1], n = ends[end];
        for (let k = 0; k <= sides; ++k) {
          const angle = 2 * Math.PI * k / sides, c = Math.cos(angle), s = Math.sin(angle);
          data.push(r * c, r * s, z, n[0] * c, n[0] * s, n[1], body);
        }
      }
      for (let k = 0; k < sides; ++k) {
        const a = first + k, b = a + sides + 1;
        corners.push(a, a + 1, b + 1, a, b + 1, b);
      }
    }
  }
  return { data: new Float32Array(data), corners: new Uint32Array(corners) };
};
