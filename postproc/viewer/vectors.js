// Vectors are arrays of three numbers.
const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const sub = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const times = (a, s) => [a[0] * s, a[1] * s, a[2] * s];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const length = a => Math.hypot(a[0], a[1], a[2]);
const unit = a => { const l = length(a); return l > 0 ? times(a, 1 / l) : [0, 0, 1]; };
const mix = (a, b, t) => [0, 1, 2].map(k => a[k] + (b[k] - a[k]) * t);

// A unit vector turned about a unit axis, and about any axis the rotation's columns.
const turned = (v, axis, angle) => {
  const c = Math.cos(angle), s = Math.sin(angle);
  return add(add(times(v, c), times(cross(axis, v), s)), times(axis, dot(axis, v) * (1 - c)));
};

// On the great circle between two unit directions, evenly in t.
const between = (a, b, t) => {
  const axis = cross(a, b), s = length(axis), angle = Math.atan2(s, dot(a, b));
  return s < 1e-12 ? (t < 1 ? a : b) : turned(a, times(axis, 1 / s), angle * t);
};

// Some unit vector square to another.
const squareTo = a => unit(cross(a, Math.abs(a[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0]));

// Columns of the rotation that turns z the shortest way to `axis`, about x where that is -z: as heads stand.
const frameOf = axis => {
  const turn = cross([0, 0, 1], axis), s = length(turn), angle = Math.atan2(s, axis[2]);
  const about = s < 1e-12 ? [1, 0, 0] : times(turn, 1 / s);
  return [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map(column => turned(column, about, angle));
};
