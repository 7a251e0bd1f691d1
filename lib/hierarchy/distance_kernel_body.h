#pragma once

// This file is included once for every instruction set; GOUGE_KERNEL names the namespace. It must not use an inline
// function from another header: that function would be compiled for this instruction set and linked into the other
// code.
#include "lib/hierarchy/distance_kernel.h"
#include "lib/hierarchy/kernel_lanes.h"

namespace gouge::GOUGE_KERNEL {
namespace {

// Bound on the rounding in single precision, relative to the distance of the point from a node's center.
constexpr float kNodeRounding = 1.0F / (1 << 19);
// The squared distance across a node's normal is a difference; it may be too large by this share of |t|^2.
constexpr float kAcross = 1.0F / (1 << 19);
// The square of a shorter vector may be 0, and a quotient by its length is arbitrary.
constexpr float kMinSquare = 1e-30F;

GOUGE_INLINE V not_negative(const V& a) { return select(0 < a, a, V{}); }  // 0 for NaN

/// Stores the bounds. Up to `slack`, each point of a lane is at least `least` away, and some point of it is at most
/// `most` away.
GOUGE_INLINE std::uint32_t finish(const V& least, const V& most, const V& slack, std::uint32_t count, float& within_mm,
                                  Lanes& min_mm) {
  const V bound = not_negative(least - slack);
  store(bound, min_mm);
  const float nearest = min_of(most + slack);
  within_mm = nearest < within_mm ? nearest : within_mm;
  return bits_of(~(within_mm < bound)) & ((1U << count) - 1U);
}

std::uint32_t nodes(const NodeBlock& block, const DistanceQuery& query, float& within_mm, Lanes& min_mm) {
  V3 center, normal;
  V half, disc, radius;
  load(block.center, center);
  load(block.normal, normal);
  load(block.half_thickness_mm, half);
  load(block.disc_radius_mm, disc);
  load(block.radius_mm, radius);
  const V3 t = minus(broadcast(query.point), center);
  const V height = dot(normal, t), away2 = dot(t, t), away = sqrt(away2);
  const V over = not_negative(abs(height) - half);
  const V beyond = not_negative(sqrt(not_negative(away2 * (1 - kAcross) - height * height)) - disc);
  const V outside = max(sqrt(over * over + beyond * beyond), away - radius);
  return finish(outside, away + radius, away * kNodeRounding + query.node_slack_mm, block.count, within_mm, min_mm);
}

GOUGE_INLINE V clamped(const V& part, const V& whole) {
  const V share = part / max(whole, broadcast(kMinSquare));
  return min(not_negative(share), broadcast(1.0F));
}

/// Returns the approximate point of the triangle a, b, c nearest to the origin. Up to rounding it is a point of the
/// triangle, or it is NaN.
GOUGE_INLINE V3 about_nearest(const V3& a, const V3& b, const V3& c) {
  const V3 ab = minus(b, a), ac = minus(c, a), bc = minus(c, b);
  const V d1 = -dot(ab, a), d2 = -dot(ac, a), d3 = -dot(ab, b), d4 = -dot(ac, b), d5 = -dot(ab, c), d6 = -dot(ac, c);
  const V3 on_ab = plus(a, times(ab, clamped(d1, d1 - d3)));
  const V3 on_ac = plus(a, times(ac, clamped(d2, d2 - d6)));
  const V3 on_bc = plus(b, times(bc, clamped(d4 - d3, (d4 - d3) + (d5 - d6))));
  V3 best = select(dot(on_ac, on_ac) < dot(on_ab, on_ab), on_ac, on_ab);
  best = select(dot(on_bc, on_bc) < dot(best, best), on_bc, best);
  const V va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
  const V scale = 1.0F / (va + vb + vc);
  const V3 within = plus(a, plus(times(ab, vb * scale), times(ac, vc * scale)));
  return select((0 < va) & (0 < vb) & (0 < vc), within, best);
}

std::uint32_t triangles(const TriangleBlock& block, const DistanceQuery& query, float& within_mm, Lanes& min_mm) {
  V3 corner[3];
  const V3 point = broadcast(query.point);
  for (unsigned k = 0; k < 3; ++k) {
    load(block.corner[k], corner[k]);
    corner[k] = minus(corner[k], point);
  }
  const V3 &a = corner[0], &b = corner[1], &c = corner[2];
  const V3 foot = about_nearest(a, b, c);
  const V foot2 = dot(foot, foot), length = sqrt(foot2);
  const V along = min(dot(foot, a), min(dot(foot, b), dot(foot, c)));
  const V least = select(kMinSquare < foot2, along / length, V{});
  return finish(least, length, broadcast(query.triangle_slack_mm), block.count, within_mm, min_mm);
}

#undef GOUGE_INLINE

}  // namespace

extern const DistanceKernel kKernel;
const DistanceKernel kKernel{GOUGE_KERNEL_NAME, nodes, triangles};

}  // namespace gouge::GOUGE_KERNEL
