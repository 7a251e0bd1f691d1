#pragma once

// Bounds of one piece of the tool's cover for sixteen points. Only sweep_kernel_body.h includes this file. The rule
// stated there holds here too: no inline function from another header.
#include "lib/check/sweep_kernel.h"
#include "lib/hierarchy/kernel_lanes.h"

namespace gouge::GOUGE_KERNEL {
namespace {

/// The frame, with a copy in every lane.
struct Frame {
  V3 tip, axis, displacement, turn;
  V3 ends[2];  ///< the tool axis at s = 1/2 and at s = -1/2
};

GOUGE_INLINE Frame spread(const SweepFrame& f) {
  Frame frame{broadcast(f.tip), broadcast(f.axis), broadcast(f.displacement), broadcast(f.turn), {}};
  const V3 tilt = times(cross(frame.turn, frame.axis), broadcast(0.5F));
  frame.ends[0] = plus(frame.axis, tilt);
  frame.ends[1] = minus(frame.axis, tilt);
  return frame;
}

/// The signed distance of u from a piece, with a subgradient.
struct Touch {
  V distance, z;
  V r, r_lo;  ///< upper and lower bound of the distance from the tool axis
  V3 gradient;
};

/// Computes the signed distance from a piece whose core is only a stretch of the axis: a ball below a cylinder.
GOUGE_INLINE void touch_pin(const KernelPiece& piece, const V3& u, const V3& axis, Touch& out) {
  out.z = dot(axis, u);
  const M is_beside = out.z >= piece.lines[1].z;
  const V3 nearly = minus(u, times(axis, select(is_beside, out.z, broadcast(piece.lines[1].z))));
  const V3 across = minus(nearly, times(axis, select(is_beside, dot(axis, nearly), V{})));
  const V length = sqrt(dot(across, across));
  out.distance = length - piece.radius_mm;
  out.r = length;
  out.r_lo = select(is_beside, length, V{});
  out.gradient = times(across, 1.0F / max(length, broadcast(1e-20F)));
}

GOUGE_INLINE void touch(const KernelPiece& piece, const V3& u, const V3& axis, Touch& out) {
  if (piece.is_pin) return touch_pin(piece, u, axis, out);
  const V z = dot(axis, u);
  // Close to the axis the remainder is rounding and may point along the axis, which would tilt the gradient. So its
  // part along the axis is removed twice.
  const V3 nearly = minus(u, times(axis, z));
  const V3 across = minus(nearly, times(axis, dot(axis, nearly)));
  const V r = sqrt(dot(across, across));
  V distance = broadcast(-3e38F);
  V gr = V{}, gz = V{}, length = broadcast(1.0F);
  M is_at_corner = M{};
  for (std::uint32_t k = 0; k < piece.count; ++k) {
    const KernelPiece::Line& line = piece.lines[k];
    const V pr = r - line.r;
    const V pz = z - line.z;
    const V side = pr * line.dz - pz * line.dr;
    if (k > 0) {
      // Before the line that starts at a corner, and past the line that ends there, the corner itself is nearest.
      const KernelPiece::Line& last = piece.lines[k - 1];
      const M here = (pr * last.dr + pz * last.dz > 0) & (pr * line.dr + pz * line.dz < 0);
      const V away = sqrt(pr * pr + pz * pz);
      distance = select(here, away, distance);
      gr = select(here, pr, gr);
      gz = select(here, pz, gz);
      length = select(here, away, length);
      is_at_corner = is_at_corner | here;
    }
    const M next = (side > distance) & ~is_at_corner;
    distance = select(next, side, distance);
    gr = select(next, broadcast(line.dz), gr);
    gz = select(next, broadcast(-line.dr), gz);
  }
  out.distance = distance - piece.radius_mm;
  out.r = out.r_lo = r;
  out.z = z;
  // One division serves both: by the length of the direction and by r.
  const V off_axis = max(r, broadcast(1e-20F));
  const V scale = 1.0F / (max(length, broadcast(1e-15F)) * off_axis);
  out.gradient = plus(times(across, gr * scale), times(axis, gz * (scale * off_axis)));
}

/// The range of heights and the smallest radius of the points to bound.
struct Range {
  V z_lo, z_hi, r_lo;
};

/// Finds the second largest of the distances from the lines of a sharp piece.
GOUGE_INLINE void touch_next(const KernelPiece& piece, const V3& u, const V3& axis, const Touch& first, Touch& out) {
  V largest = broadcast(-3e38F), distance = broadcast(-3e38F);
  V gr = V{}, gz = V{}, next_gr = V{}, next_gz = V{};
  for (std::uint32_t k = 0; k < piece.count; ++k) {
    const KernelPiece::Line& line = piece.lines[k];
    const V side = (first.r - line.r) * line.dz - (first.z - line.z) * line.dr;
    const M is_largest = side > largest;
    const M is_next = is_largest | (side > distance);
    next_gr = select(is_largest, gr, select(is_next, broadcast(line.dz), next_gr));
    next_gz = select(is_largest, gz, select(is_next, broadcast(-line.dr), next_gz));
    distance = select(is_largest, largest, select(is_next, side, distance));
    largest = select(is_largest, side, largest);
    gr = select(is_largest, broadcast(line.dz), gr);
    gz = select(is_largest, broadcast(-line.dr), gz);
  }
  out.distance = distance - piece.radius_mm;
  const V3 nearly = minus(u, times(axis, first.z));
  const V3 across = minus(nearly, times(axis, dot(axis, nearly)));
  out.gradient = plus(times(across, next_gr / max(first.r, broadcast(1e-20F))), times(axis, next_gz));
}

/// Returns whether the nearest boundary of the tool is one of the piece's lines for every point in the range.
GOUGE_INLINE M has_closest_point(const KernelPiece& piece, float need, const Range& range) {
  const float depth = need < 0 ? -need : 0.0F;
  return ((range.z_lo - depth > piece.foot_lo_mm) | (range.r_lo >= piece.r_closed_mm)) &
         (range.z_hi + depth < piece.foot_hi_mm);
}

GOUGE_INLINE V combine(const KernelPiece& piece, const M& has_closest_point, const V& by_plane, const Range& range) {
  const V never = broadcast(-3e38F);
  V bound = select(has_closest_point | (by_plane >= 0), by_plane, never);
  const V below = piece.z_lo_mm - range.z_hi;
  const V above = range.z_lo - piece.z_hi_mm;
  const M is_below = (below >= 0) | (range.r_lo >= piece.r_below_mm);
  const M is_above = (above >= 0) | (range.r_lo >= piece.r_above_mm);
  bound = max(bound, select(is_below, below, never));
  return max(bound, select(is_above, above, never));
}

/// Returns a lower bound of the signed distance of points, from a direction that does not turn with the tool. It uses
/// two values along the direction: `farthest_back` of the points, and how far the core reaches at both ends of the
/// motion.
GOUGE_INLINE V min_along(const KernelPiece& piece, const V3& g, const V& farthest_back, const SweepFrame& frame,
                         const Frame& f) {
  if (!piece.is_steady) return broadcast(-3e38F);
  const KernelPiece::Line& first = piece.lines[0];
  const KernelPiece::Line& last = piece.lines[piece.count - 1];
  // Between the ends of the motion the core reaches less far than at one of the ends. But a line that leans towards the
  // axis may rise.
  const float unsure = 4 * frame.rest_per_mm, slack = 2 * frame.half_turn + unsure;
  const float slack_up = (last.dr < 0 ? -last.dr * slack : 0.0F) + unsure;
  const float slack_down = (first.dr > 0 ? first.dr * slack : 0.0F) + unsure;
  const V still = 0.5F * dot(g, f.displacement);
  V bound = broadcast(3e38F);
  // On the axis of a cone the gradient is shorter than 1; inside the core it would then give too large a bound.
  M is_endless = dot(g, g) < 0.99999F;
  for (int end = 0; end < 2; ++end) {
    const V gz = dot(g, f.ends[end]);
    V gr = V{};
    if (!piece.is_pin) {
      const V3 across = cross(g, f.ends[end]);
      gr = sqrt(dot(across, across));
    }
    V reach = piece.is_level_below ? gz * first.z : broadcast(-3e38F);
    if (piece.is_level_above) reach = max(reach, gz * last.z);
    for (std::uint32_t k = 1; k < piece.count; ++k) {
      reach = max(reach, gr * piece.lines[k].r + gz * piece.lines[k].z);
    }
    if (!piece.is_level_above) is_endless = is_endless | (gr * last.dr + gz * last.dz > -slack_up);
    if (!piece.is_level_below) is_endless = is_endless | (gr * first.dr + gz * first.dz < slack_down);
    bound = min(bound, farthest_back - (end == 0 ? still : -still) - reach);
  }
  const float rest = frame.beside_mm + frame.rest_per_mm * piece.core_mm + piece.rounding_mm + piece.radius_mm;
  return select(is_endless, broadcast(-3e38F), bound - rest);
}

/// Returns a point of the core that is approximately nearest to u. Any point gives a valid bound.
GOUGE_INLINE V3 near_core(const KernelPiece& piece, const V3& u, const V3& axis) {
  const V z = dot(axis, u);
  const V3 on_axis = times(axis, piece.count > 1 ? max(z, broadcast(piece.lines[1].z)) : z);
  if (!(piece.core_r_mm > 0)) return on_axis;
  const V3 across = minus(u, times(axis, z));
  const V share = piece.core_r_mm / max(sqrt(dot(across, across)), broadcast(piece.core_r_mm));
  return plus(on_axis, times(across, share));
}

}  // namespace
}  // namespace gouge::GOUGE_KERNEL
