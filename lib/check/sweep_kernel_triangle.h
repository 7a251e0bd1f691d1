#pragma once

// Operations on sixteen triangles, and linear bounds (planes) over them. Only sweep_kernel_body.h includes this file.
// The rule stated there holds here too: no inline function from another header.
#include "lib/check/sweep_kernel_piece.h"

namespace gouge::GOUGE_KERNEL {
namespace {

GOUGE_INLINE void nearer(const V3& p, const V3& candidate, V& best2, V3& best) {
  const V3 d = minus(p, candidate);
  const V d2 = dot(d, d);
  const M is_nearer = d2 < best2;
  best2 = select(is_nearer, d2, best2);
  best = select(is_nearer, candidate, best);
}

struct Triangle {
  V3 a, b, c, ab, bc, ca, normal;
  V ab_scale, bc_scale, ca_scale, normal_scale;
};

GOUGE_INLINE V3 on_edge(const V3& p, const V3& from, const V3& displacement, const V& scale) {
  const V t = min(max(dot(minus(p, from), displacement) * scale, V{}), broadcast(1.0F));
  return plus(from, times(displacement, t));
}

GOUGE_INLINE V inverse(const V& x) { return 1.0F / max(x, broadcast(1e-30F)); }

GOUGE_INLINE V3 closest(const V3& p, const Triangle& t) {
  V3 best = on_edge(p, t.a, t.ab, t.ab_scale);
  const V3 first = minus(p, best);
  V best2 = dot(first, first);
  nearer(p, on_edge(p, t.b, t.bc, t.bc_scale), best2, best);
  nearer(p, on_edge(p, t.c, t.ca, t.ca_scale), best2, best);
  const V3 pa = minus(p, t.a);
  const M is_over = (dot(cross(t.ab, pa), t.normal) >= 0) & (dot(cross(t.bc, minus(p, t.b)), t.normal) >= 0) &
                    (dot(cross(t.ca, minus(p, t.c)), t.normal) >= 0) & (t.normal_scale < 1e29F);
  const V3 foot = minus(p, times(t.normal, dot(pa, t.normal) * t.normal_scale));
  return select(is_over, foot, best);
}

GOUGE_INLINE void corner(const TriangleBlock& block, std::size_t c, const V3& tip, V3& out) {
  load(block.corner[c], out);
  out = minus(out, tip);
}

GOUGE_INLINE void prepare(const TriangleBlock& block, const V3& tip, Triangle& t) {
  corner(block, 0, tip, t.a);
  corner(block, 1, tip, t.b);
  corner(block, 2, tip, t.c);
  t.ab = minus(t.b, t.a);
  t.bc = minus(t.c, t.b);
  t.ca = minus(t.a, t.c);
  t.normal = cross(t.ab, minus(t.c, t.a));
  t.ab_scale = inverse(dot(t.ab, t.ab));
  t.bc_scale = inverse(dot(t.bc, t.bc));
  t.ca_scale = inverse(dot(t.ca, t.ca));
  t.normal_scale = inverse(dot(t.normal, t.normal));
}

/// A lower bound of the distance that is linear in the point and in the instant. It is given by its values at the
/// corners of the triangle at both ends of the motion. No value in between is below the smallest of these values.
struct Plane {
  V value[6];
};

GOUGE_INLINE void lay_plane(const V& distance, const V3& point, const V3& g, const Triangle& t, const Frame& f,
                            Plane& out) {
  const V still = dot(g, f.displacement);
  const V3 lever = cross(g, f.turn);
  const V offset = distance - dot(g, point);
  const V3* corners[3] = {&t.a, &t.b, &t.c};
  for (int c = 0; c < 3; ++c) {
    const V here = offset + dot(g, *corners[c]);
    const V swing = 0.5F * (still + dot(lever, *corners[c]));
    out.value[2 * c] = here - swing;
    out.value[2 * c + 1] = here + swing;
  }
}

GOUGE_INLINE V least(const Plane& p) {
  V low = p.value[0];
  for (int k = 1; k < 6; ++k) low = min(low, p.value[k]);
  return low;
}

GOUGE_INLINE V min_blended(const Plane& p, const Plane& q, const V& share) {
  V low = broadcast(3e38F);
  for (int k = 0; k < 6; ++k) low = min(low, share * p.value[k] + (1.0F - share) * q.value[k]);
  return low;
}

/// Returns the minimum of the best blend of two planes. Any blend of two lower bounds is a lower bound. At an edge of
/// the tool one plane rises as the other falls. There the best blend is equal at the lowest corners of both.
GOUGE_INLINE V min_blended(const Plane& p, const Plane& q) {
  V low_p = p.value[0], low_q = q.value[0], q_at_p = q.value[0], p_at_q = p.value[0];
  for (int k = 1; k < 6; ++k) {
    const M is_p = p.value[k] < low_p;
    q_at_p = select(is_p, q.value[k], q_at_p);
    low_p = select(is_p, p.value[k], low_p);
    const M is_q = q.value[k] < low_q;
    p_at_q = select(is_q, p.value[k], p_at_q);
    low_q = select(is_q, q.value[k], low_q);
  }
  const V slope = (q_at_p - low_p) + (p_at_q - low_q);
  const V share = min(max((q_at_p - low_q) / max(slope, broadcast(1e-30F)), V{}), broadcast(1.0F));
  return min_blended(p, q, share);
}

/// The point of the triangle at which the larger of two planes has its minimum. The minimum is taken over both ends of
/// the motion. `share` is the weight of the first plane in the blend that is constant along the edge with this point.
struct Crossing {
  V3 point;
  V share;
};

GOUGE_INLINE void lowest_crossing(const Plane& p, const Plane& q, const Triangle& t, Crossing& out) {
  const V3* corners[3] = {&t.a, &t.b, &t.c};
  V lowest = broadcast(3e38F);
  for (int end = 0; end < 2; ++end) {
    for (int c = 0; c < 3; ++c) {
      const int d = (c + 1) % 3;
      const V pc = p.value[2 * c + end], qc = q.value[2 * c + end];
      const V pd = p.value[2 * d + end], qd = q.value[2 * d + end];
      const V at_corner = max(pc, qc);
      const M is_corner = at_corner < lowest;
      lowest = select(is_corner, at_corner, lowest);
      out.share = select(is_corner, select(pc < qc, V{}, broadcast(1.0F)), out.share);
      out.point = select(is_corner, *corners[c], out.point);
      const V over_c = pc - qc, over_d = pd - qd;
      const V along = over_c / (over_c - over_d);
      const V on_edge = pc + along * (pd - pc);
      const M is_edge = (over_c * over_d < 0) & (on_edge < lowest);
      lowest = select(is_edge, on_edge, lowest);
      const V share = (qd - qc) / ((pc - pd) + (qd - qc));
      out.share = select(is_edge, min(max(share, V{}), broadcast(1.0F)), out.share);
      out.point = select(is_edge, plus(*corners[c], times(minus(*corners[d], *corners[c]), along)), out.point);
    }
  }
}

}  // namespace
}  // namespace gouge::GOUGE_KERNEL
