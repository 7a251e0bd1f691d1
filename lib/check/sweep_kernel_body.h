#pragma once

// This file is included once for every instruction set; GOUGE_KERNEL names the namespace. It must not use an inline
// function from another header: that function would be compiled for this instruction set and linked into the other
// code.
#include "lib/check/sweep_kernel.h"
#include "lib/check/sweep_kernel_piece.h"
#include "lib/check/sweep_kernel_triangle.h"
#include "lib/hierarchy/kernel_lanes.h"

namespace gouge::GOUGE_KERNEL {
namespace {

GOUGE_INLINE void finish(const V& bound, float need, std::uint32_t count, KernelResult& result) {
  store(bound, result.bound);
  const M is_open = bound < need;
  result.open = bits_of(is_open) & ((1U << count) - 1U);
  result.min_pruned = min_of(select(is_open, broadcast(3e38F), bound));
}

void nodes(const NodeBlock& block, const SweepFrame& frame, const KernelPiece& piece, float need,
           KernelResult& result) {
  const Frame f = spread(frame);
  V3 center, normal;
  V thickness, disc, ball;
  load(block.center, center);
  load(block.normal, normal);
  load(block.half_thickness_mm, thickness);
  load(block.disc_radius_mm, disc);
  load(block.radius_mm, ball);
  const V3 u = minus(center, f.tip);
  // The strongest plane touches the tool at the point of the disc that is nearest to the core.
  const V3 to_core = minus(near_core(piece, u, f.axis), u);
  const V3 lateral = minus(to_core, times(normal, dot(normal, to_core)));
  const V length = sqrt(dot(lateral, lateral));
  const V3 nearest = plus(u, times(lateral, disc / max(length, max(disc, broadcast(1e-30F)))));
  Touch at;
  touch(piece, nearest, f.axis, at);
  const V3 lean = cross(at.gradient, normal);
  const V extent = abs(dot(at.gradient, normal)) * thickness + sqrt(dot(lean, lean)) * disc;
  const V3 speed = plus(f.displacement, cross(f.turn, u));
  const V far = at.r + abs(at.z) + ball + disc;
  const V rest = frame.half_turn * ball + frame.rest_mm + frame.rest_per_mm * far + piece.rounding_mm;
  V by_plane = at.distance + dot(at.gradient, minus(u, nearest)) - extent - 0.5F * abs(dot(at.gradient, speed)) - rest;
  by_plane =
      max(by_plane, min_along(piece, at.gradient, dot(at.gradient, u) - extent, frame, f) - frame.rest_per_mm * far);
  const V z = dot(f.axis, u);
  V height = ball;
  // A cylinder has no lower face in its chain, so only the range of heights bounds it there. Any other chain contains
  // its lower face.
  if (piece.count == 1) {
    const V3 tilt = cross(f.axis, normal);
    height = min(abs(dot(f.axis, normal)) * thickness + sqrt(dot(tilt, tilt)) * disc, ball);
  }
  height += 0.5F * abs(dot(f.axis, speed)) + rest;
  const V reach = ball + disc + 0.5F * frame.displacement_mm + frame.half_turn * far + rest;
  const Range range{z - height, z + height, at.r_lo - reach};
  const V bound = combine(piece, has_closest_point(piece, need, range), by_plane, range);
  store(at.distance, result.distance);
  finish(bound, need, block.count, result);
}

// Returns the normal of the triangle that points away from the core's lower end. If the inside of a triangle meets the
// tool, the triangle's own plane gives the best bound.
GOUGE_INLINE V3 away_from_core(const KernelPiece& piece, const Triangle& t, const V3& axis) {
  const float z = piece.count > 1 ? piece.lines[1].z : 0.5F * (piece.z_lo_mm + piece.z_hi_mm);
  const V3 unit = times(t.normal, sqrt(t.normal_scale));
  const M is_away = dot(unit, minus(t.a, times(axis, broadcast(z)))) >= 0;
  return select(is_away, unit, {-unit.x, -unit.y, -unit.z});
}

/// Returns the point of the core that is farthest in a direction. If the corner there is sharp, it is the deepest point
/// on the plane through a corner of the triangle. If the core has no end in that direction, it is the core's lower end.
GOUGE_INLINE V3 first_look(const KernelPiece& piece, const Triangle& t, const V3& g, const V3& axis) {
  const V z0 = broadcast(piece.count > 1 ? piece.lines[1].z : 0.5F * (piece.z_lo_mm + piece.z_hi_mm));
  const V gz = dot(g, axis);
  const V3 across = minus(g, times(axis, gz));
  const V gr = sqrt(dot(across, across));
  V reach = broadcast(-3e38F), r = V{}, z = z0, in_r = V{}, in_z = V{};
  for (std::uint32_t k = 1; k < piece.count; ++k) {
    const KernelPiece::Line& line = piece.lines[k];
    const V here = gr * line.r + gz * line.z;
    const M is_farther = here > reach;
    reach = select(is_farther, here, reach);
    r = select(is_farther, broadcast(line.r), r);
    z = select(is_farther, broadcast(line.z), z);
    in_r = select(is_farther, broadcast(line.in_r), in_r);
    in_z = select(is_farther, broadcast(line.in_z), in_z);
  }
  if (piece.is_sharp) {
    // This direction stays equally far from both lines of the corner.
    const V along = gr * in_r + gz * in_z;
    const V height = dot(g, t.a) - (gr * r + gz * z);
    const V displacement = select(along < -0.1F, height / along, V{});
    r = max(r + displacement * in_r, V{});
    z = z + displacement * in_z;
  }
  const KernelPiece::Line& last = piece.lines[piece.count - 1];
  const KernelPiece::Line& first = piece.lines[0];
  const M is_endless =
      (gr * last.dr + gz * last.dz > 0) | (gr * first.dr + gz * first.dz < 0) | (t.normal_scale >= 1e29F);
  const V3 at_ring = plus(times(axis, z), times(across, r * inverse(gr)));
  return select(is_endless, times(axis, z0), at_ring);
}

GOUGE_INLINE V min_of_corners(const V3& g, const Triangle& t) {
  return min(dot(g, t.a), min(dot(g, t.b), dot(g, t.c)));
}

/// Returns the range of a triangle during the motion. `rest` covers everything that is not linear.
GOUGE_INLINE Range range_of(const Triangle& t, const SweepFrame& frame, const Frame& f, const V& far, const V& rest) {
  Range range{broadcast(3e38F), broadcast(-3e38F), V{}};
  const V still = dot(f.axis, f.displacement);
  const V3 lever = cross(f.axis, f.turn);
  const V3* corners[3] = {&t.a, &t.b, &t.c};
  for (const V3* corner : corners) {
    const V here = dot(f.axis, *corner);
    const V swing = 0.5F * abs(still + dot(lever, *corner));
    range.z_lo = min(range.z_lo, here - swing);
    range.z_hi = max(range.z_hi, here + swing);
  }
  range.z_lo -= rest;
  range.z_hi += rest;
  // No point of the triangle is farther from a corner than the length of the longest edge.
  const V edge2 = max(dot(t.ab, t.ab), max(dot(t.bc, t.bc), dot(t.ca, t.ca)));
  const V3 across = minus(t.a, times(f.axis, dot(f.axis, t.a)));
  range.r_lo =
      sqrt(dot(across, across)) - sqrt(edge2) * 1.000001F - 0.5F * frame.displacement_mm - frame.half_turn * far - rest;
  return range;
}

/// The deepest examined point, with its smallest signed distance over both ends of the motion.
struct Deepest {
  V distance;
  V3 point;
};

/// Combines the two nearest lines inside a sharp corner. Each gives a bound, and at the deepest point the two are
/// equal. Returns the bound that follows from both, records the depth of `point`, and moves `point` to the deepest
/// place.
GOUGE_INLINE V meet_in_corner(const KernelPiece& piece, const Touch& at, const Plane& plane, const Triangle& t,
                              const Frame& f, V3& point, Deepest& deepest) {
  Touch also;
  touch_next(piece, point, f.axis, at, also);
  Plane also_plane;
  lay_plane(also.distance, point, also.gradient, t, f, also_plane);
  const V3 speed = plus(f.displacement, cross(f.turn, point));
  const V swing = 0.5F * dot(at.gradient, speed), also_swing = 0.5F * dot(also.gradient, speed);
  const V at_ends =
      min(max(at.distance - swing, also.distance - also_swing), max(at.distance + swing, also.distance + also_swing));
  const M is_deeper = at_ends < deepest.distance;
  deepest.distance = select(is_deeper, at_ends, deepest.distance);
  deepest.point = select(is_deeper, point, deepest.point);
  Crossing ridge{point, V{}};
  lowest_crossing(plane, also_plane, t, ridge);
  point = ridge.point;
  return max(min_blended(plane, also_plane, ridge.share), least(also_plane));
}

/// Returns the corner of a triangle that is lowest in direction g.
GOUGE_INLINE V3 lowest_corner(const V3& g, const Triangle& t) {
  const V a = dot(g, t.a), b = dot(g, t.b), c = dot(g, t.c);
  return select((a <= b) & (a <= c), t.a, select(b <= c, t.b, t.c));
}

/// Returns a point below the flat face of a disc-shaped core: the point of the rim on the line down the triangle.
GOUGE_INLINE V3 rim_ahead(const KernelPiece& piece, const Touch& at, const Triangle& t, const V3& point,
                          const V3& axis) {
  const V3 displacement = minus(lowest_corner(at.gradient, t), point);
  const V3 from = minus(point, times(axis, at.z));
  const V3 along = minus(displacement, times(axis, dot(axis, displacement)));
  const V a = max(dot(along, along), broadcast(1e-20F)), b = dot(from, along);
  const V inside = max(piece.core_r_mm * piece.core_r_mm - at.r * at.r, V{});
  const V share = min((sqrt(b * b + a * inside) - b) / a, broadcast(1.0F));
  return plus(plus(from, times(along, share)), times(axis, broadcast(piece.lines[1].z)));
}

/// The place that the last round examined, its gradient, and the step that led to it.
struct Look {
  V3 point, gradient, displacement;
};

// Steps from the core of the piece straight to the triangle; inside the core, deeper. These steps shrink by a constant
// factor, so two of them predict the limit.
GOUGE_INLINE V3 step_to_core(const KernelPiece& piece, const Touch& at, const Triangle& t, const V3& point,
                             Look& last) {
  const V3 next = closest(minus(point, times(at.gradient, abs(at.distance + piece.radius_mm))), t);
  const V3 displacement = minus(next, point);
  const V rate =
      min(dot(displacement, last.displacement) * inverse(dot(last.displacement, last.displacement)), broadcast(0.98F));
  const M leads = rate > 0.2F;
  last.displacement = select(leads, V3{}, displacement);
  return select(leads, closest(plus(next, times(displacement, rate / (1.0F - rate))), t), next);
}

constexpr float kFarthest = 16;  // maximum factor by which a step is extended

// Steps along the rim. If a large tool lies almost flat on its triangle, the factor of step_to_core is close to 1.
// Under the flat face, the descent leads to the rim. Beyond the rim, the slopes along the last step show where it
// should have ended.
GOUGE_INLINE V3 step_round_rim(const KernelPiece& piece, const Touch& at, const Triangle& t, const V3& point,
                               const V3& axis, Look& last) {
  const M is_under = (at.r < piece.core_r_mm) & (at.z < piece.lines[1].z);
  const V3 straight = minus(point, times(at.gradient, abs(at.distance + piece.radius_mm)));
  const V3 core = select(is_under, rim_ahead(piece, at, t, point, axis), straight);
  const V3 displacement = minus(point, last.point);
  const V slope = dot(at.gradient, displacement), rise = slope - dot(last.gradient, displacement);
  const V back = max(min(slope / max(rise, broadcast(1e-30F)), broadcast(1.0F)), broadcast(-kFarthest));
  const M leads = (rise > 1e-6F * dot(displacement, displacement)) & ~is_under;
  last.point = point;
  last.gradient = at.gradient;
  return closest(select(leads, minus(point, times(displacement, back)), core), t);
}

constexpr int kRounds = 6;
constexpr float kWorthwhile = 0.25F;

void triangles(const TriangleBlock& block, const SweepFrame& frame, const KernelPiece& piece, float need,
               KernelResult& result) {
  const Frame f = spread(frame);
  Triangle t;
  prepare(block, f.tip, t);
  const V far = sqrt(max(dot(t.a, t.a), max(dot(t.b, t.b), dot(t.c, t.c)))) * 1.000001F;
  const V rest = frame.rest_mm + frame.rest_per_mm * far + piece.rounding_mm;
  const V rest_along = frame.rest_per_mm * far;
  const Range range = range_of(t, frame, f, far, rest);
  const M on_side = has_closest_point(piece, need, range);
  const V3 normal = away_from_core(piece, t, f.axis);
  const V along = min_along(piece, normal, min_of_corners(normal, t), frame, f) - rest_along;
  V bound = combine(piece, on_side, select(t.normal_scale < 1e29F, along, broadcast(-3e38F)), range);
  if (!any_of(bound < need)) {
    store(bound, result.distance);
    result.point = {};
    return finish(bound, need, block.count, result);
  }
  V3 point = closest(first_look(piece, t, normal, f.axis), t);
  Look last{point, {}, {}};
  Plane last_plane, plane;
  Touch at;
  Deepest deepest{broadcast(3e38F), point};
  for (int round = 0;; ++round) {
    touch(piece, point, f.axis, at);
    lay_plane(at.distance, point, at.gradient, t, f, plane);
    V by_plane = least(plane);
    if (round > 0) by_plane = max(by_plane, min_blended(last_plane, plane));
    last_plane = plane;
    V3 on_ridge = point;
    if (piece.is_sharp) by_plane = max(by_plane, meet_in_corner(piece, at, plane, t, f, on_ridge, deepest));
    const V along_g = min_along(piece, at.gradient, min_of_corners(at.gradient, t), frame, f) - rest_along;
    const V better = max(bound, combine(piece, on_side, max(along_g, by_plane - rest), range));
    // A lane that the last rounds brought hardly nearer to the goal is left to smaller triangles and shorter intervals.
    M is_open = better < need;
    if (round > (piece.is_disc ? 2 : 1)) is_open = is_open & (better - bound > kWorthwhile * (need - better));
    bound = better;
    if (!piece.is_sharp) deepest = {at.distance, point};
    if (!any_of(is_open) || round + 1 == kRounds) break;
    const V3 next =
        piece.is_disc ? step_round_rim(piece, at, t, point, f.axis, last) : step_to_core(piece, at, t, point, last);
    point = piece.is_sharp ? select(at.distance < 0, on_ridge, next) : next;
  }
  store(deepest.distance, result.distance);
  store(deepest.point.x, result.point[0]);
  store(deepest.point.y, result.point[1]);
  store(deepest.point.z, result.point[2]);
  finish(bound, need, block.count, result);
}

#undef GOUGE_INLINE

}  // namespace

extern const SweepKernel kKernel;
const SweepKernel kKernel{GOUGE_KERNEL_NAME, nodes, triangles};

}  // namespace gouge::GOUGE_KERNEL
