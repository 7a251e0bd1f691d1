// Directions from which a finding and a section are seen. Coordinates are those of renderer.js.
const kIso = [1, -1, 1];
const kMaxAlong = 0.94;  // cosine to a coordinate axis above which a view shows no depth
const kMaxSights = 20;  // lines of sight that are tested for one finding
const kMaxTriangles = 500000;  // of a surface whose lines of sight are tested

const isAlongAxis = direction => unit(direction).some(x => Math.abs(x) > kMaxAlong);

// Whether the surface hides a point from a viewer in that direction.
const isHidden = (desk, point, direction) => {
  const eye = new Camera(direction);
  eye.centre = point;
  const found = pickSurface(desk.surface.mesh, desk.values[desk.chosen], desk.shownRanges(), eye, 0.5, 0.5, null);
  return Boolean(found) && found.depth > desk.size() / 2000 + (desk.finding?.depth ?? 0);
};

// Directions around the tool, from a little and from well above its tip.
const directionsAround = axis => {
  const side = squareTo(axis), all = [];
  for (const height of [0.5, 0.9])
    for (let k = 0; k < 12; ++k) all.push(unit(add(turned(side, axis, (2 * k + 1) * Math.PI / 12), times(axis, height))));
  return all;
};

// The direction to a finding: at an angle to the coordinate axes, onto its surface, free of what hides it, and as near
// to the present view as that allows.
const directionTo = (desk, point, axis, normal, now) => {
  const out = normal ?? axis;
  const worth = direction => 1.2 * Math.min(dot(direction, out), 0.75) + 0.35 * dot(direction, now) +
    0.2 * dot(direction, unit(kIso)) - 0.8 * Math.abs(dot(direction, axis) - 0.5) - (isAlongAxis(direction) ? 3 : 0);
  const all = [...directionsAround(axis), unit(kIso)].map(direction => [worth(direction), direction]);
  all.push([worth(now) + 0.3, now]);  // a view that is as good stays
  all.sort((a, b) => b[0] - a[0]);
  if (desk.surface.mesh.corners.length > 3 * kMaxTriangles) return all[0][1];
  const free = all.slice(0, kMaxSights).find(([, direction]) => !isHidden(desk, point, direction));
  return (free ?? all[0])[1];
};
