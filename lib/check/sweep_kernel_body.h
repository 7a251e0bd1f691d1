#pragma once

// Included once for every instruction set, with GOUGE_KERNEL naming the namespace. Nothing here may come from
// another header as an inline function: it would be compiled for this instruction set and linked into the rest.
#include "lib/check/sweep_kernel.h"

namespace gouge::GOUGE_KERNEL {
namespace {

using V = float __attribute__((vector_size(64)));
using M = int __attribute__((vector_size(64)));

#define GOUGE_INLINE inline __attribute__((always_inline))

struct V3 {
  V x, y, z;
};

GOUGE_INLINE void load(const Lanes& from, V& to) { __builtin_memcpy(&to, &from, sizeof(V)); }
GOUGE_INLINE void store(const V& from, Lanes& to) { __builtin_memcpy(&to, &from, sizeof(V)); }
GOUGE_INLINE V all(float x) { return x - V{}; }
GOUGE_INLINE V larger(const V& a, const V& b) { return a > b ? a : b; }
GOUGE_INLINE V smaller(const V& a, const V& b) { return a < b ? a : b; }
GOUGE_INLINE V size(const V& a) { return a < 0 ? -a : a; }
GOUGE_INLINE V root(const V& a) {
  V result;
  for (int i = 0; i < 16; ++i) result[i] = __builtin_sqrtf(a[i]);
  return result;
}
GOUGE_INLINE V dot(const V3& a, const V3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
GOUGE_INLINE V3 cross(const V3& a, const V3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
GOUGE_INLINE V3 minus(const V3& a, const V3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
GOUGE_INLINE V3 plus(const V3& a, const V3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
GOUGE_INLINE V3 times(const V3& a, const V& s) { return {a.x * s, a.y * s, a.z * s}; }
GOUGE_INLINE V3 all(const std::array<float, 3>& a) { return {all(a[0]), all(a[1]), all(a[2])}; }
GOUGE_INLINE V3 chosen(const M& which, const V3& a, const V3& b) {
  return {which ? a.x : b.x, which ? a.y : b.y, which ? a.z : b.z};
}

/// The frame, a copy in every lane.
struct Frame {
  V3 tip, axis, way, turn;
};

GOUGE_INLINE Frame spread(const SweepFrame& f) { return {all(f.tip), all(f.axis), all(f.way), all(f.turn)}; }

/// The signed distance of a piece at u, with a subgradient.
struct Touch {
  V distance, r, z;
  V3 gradient;
};

GOUGE_INLINE void touch(const KernelPiece& piece, const V3& u, const V3& axis, Touch& out) {
  const V z = dot(axis, u);
  // Close to the axis what is left is rounding and may point along it, which would tilt the gradient: taken off twice.
  const V3 nearly = minus(u, times(axis, z));
  const V3 across = minus(nearly, times(axis, dot(axis, nearly)));
  const V r = root(dot(across, across));
  V distance = all(-3e38F);
  V gr = V{}, gz = V{};
  M is_at_corner = M{};
  for (std::uint32_t k = 0; k < piece.count; ++k) {
    const KernelPiece::Line& line = piece.lines[k];
    const V pr = r - line.r;
    const V pz = z - line.z;
    const V side = pr * line.dz - pz * line.dr;
    if (k > 0) {
      // Before a corner's line and past the one that ends there: nearest to the corner itself.
      const KernelPiece::Line& last = piece.lines[k - 1];
      const M here = (pr * last.dr + pz * last.dz > 0) & (pr * line.dr + pz * line.dz < 0);
      const V away = root(pr * pr + pz * pz);
      const V shrink = 1.0F / larger(away, all(1e-30F));
      distance = here ? away : distance;
      gr = here ? pr * shrink : gr;
      gz = here ? pz * shrink : gz;
      is_at_corner = is_at_corner | here;
    }
    const M next = (side > distance) & ~is_at_corner;
    distance = next ? side : distance;
    gr = next ? all(line.dz) : gr;
    gz = next ? all(-line.dr) : gz;
  }
  out.distance = distance - piece.radius_mm;
  out.r = r;
  out.z = z;
  const V out_share = gr / larger(r, all(1e-30F));
  out.gradient = plus(times(across, out_share), times(axis, gz));
}

/// The larger of what each face of the piece proves, given the range of heights and the least radius.
struct Range {
  V z_lo, z_hi, r_lo;
};

GOUGE_INLINE V settle(const KernelPiece& piece, float need, const V& by_plane, const Range& range) {
  const float depth = need < 0 ? -need : 0.0F;
  const M has_foot = ((range.z_lo - depth > piece.foot_lo_mm) | (range.r_lo >= piece.r_closed_mm)) &
                     (range.z_hi + depth < piece.foot_hi_mm);
  const V never = all(-3e38F);
  V bound = (has_foot | (by_plane >= 0)) ? by_plane : never;
  const V below = piece.z_lo_mm - range.z_hi;
  const V above = range.z_lo - piece.z_hi_mm;
  const M is_below = (below >= 0) | (range.r_lo >= piece.r_below_mm);
  const M is_above = (above >= 0) | (range.r_lo >= piece.r_above_mm);
  bound = larger(bound, is_below ? below : never);
  return larger(bound, is_above ? above : never);
}

GOUGE_INLINE void finish(const V& bound, float need, std::uint32_t count, KernelAnswer& answer) {
  store(bound, answer.bound);
  std::uint32_t open = 0;
  float least = 3e38F;
  for (std::uint32_t i = 0; i < 16; ++i) {
    const bool is_open = answer.bound[i] < need;
    open |= (is_open ? 1U : 0U) << i;
    const float settled = is_open ? 3e38F : answer.bound[i];
    least = settled < least ? settled : least;
  }
  answer.open = open & ((1U << count) - 1U);
  answer.least_settled = least;
}

void nodes(const NodeBlock& block, const SweepFrame& frame, const KernelPiece& piece, float need,
           KernelAnswer& answer) {
  const Frame f = spread(frame);
  V3 center, normal;
  V thickness, disc, ball;
  load(block.center[0], center.x);
  load(block.center[1], center.y);
  load(block.center[2], center.z);
  load(block.normal[0], normal.x);
  load(block.normal[1], normal.y);
  load(block.normal[2], normal.z);
  load(block.half_thickness_mm, thickness);
  load(block.disc_radius_mm, disc);
  load(block.radius_mm, ball);
  const V3 u = minus(center, f.tip);
  Touch at;
  touch(piece, u, f.axis, at);
  const V3 speed = plus(f.way, cross(f.turn, u));
  const V far = at.r + size(at.z) + ball;
  const V rest = frame.half_turn * ball + frame.rest_mm + frame.rest_per_mm * far + piece.rounding_mm;
  const V3 lean = cross(at.gradient, normal);
  const V extent = size(dot(at.gradient, normal)) * thickness + root(dot(lean, lean)) * disc;
  const V by_plane = at.distance - 0.5F * size(dot(at.gradient, speed)) - extent - rest;
  const V3 tilt = cross(f.axis, normal);
  const V height = smaller(size(dot(f.axis, normal)) * thickness + root(dot(tilt, tilt)) * disc, ball) +
                   0.5F * size(dot(f.axis, speed)) + rest;
  const V reach = ball + 0.5F * frame.way_mm + frame.half_turn * far + rest;
  const V bound = settle(piece, need, by_plane, {at.z - height, at.z + height, at.r - reach});
  store(at.distance, answer.distance);
  finish(bound, need, block.count, answer);
}

GOUGE_INLINE void nearer(const V3& p, const V3& candidate, V& best2, V3& best) {
  const V3 d = minus(p, candidate);
  const V d2 = dot(d, d);
  const M is_nearer = d2 < best2;
  best2 = is_nearer ? d2 : best2;
  best = chosen(is_nearer, candidate, best);
}

struct Triangle {
  V3 a, b, c, ab, bc, ca, normal;
  V ab_scale, bc_scale, ca_scale, normal_scale;
};

GOUGE_INLINE V3 on_edge(const V3& p, const V3& from, const V3& way, const V& scale) {
  const V t = smaller(larger(dot(minus(p, from), way) * scale, V{}), all(1.0F));
  return plus(from, times(way, t));
}

GOUGE_INLINE V inverse(const V& x) { return 1.0F / larger(x, all(1e-30F)); }

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
  return chosen(is_over, foot, best);
}

GOUGE_INLINE void corner(const TriangleBlock& block, std::size_t c, const V3& tip, V3& out) {
  load(block.corner[c][0], out.x);
  load(block.corner[c][1], out.y);
  load(block.corner[c][2], out.z);
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

/// A lower bound of the distance that is linear in the point and in the instant, by its values at the corners of
/// the triangle at both ends of the motion: nothing in between is smaller than the smallest.
struct Plane {
  V value[6];
};

GOUGE_INLINE void lay_plane(const V& distance, const V3& point, const V3& g, const Triangle& t, const Frame& f,
                            Plane& out) {
  const V still = dot(g, f.way);
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
  for (int k = 1; k < 6; ++k) low = smaller(low, p.value[k]);
  return low;
}

/// Two lower bounds are bounds in any blend. At an edge of the tool, where one rises as the other falls, the blend in
/// which their lowest corners balance is the best.
GOUGE_INLINE V least_blended(const Plane& p, const Plane& q) {
  V low_p = p.value[0], low_q = q.value[0], q_at_p = q.value[0], p_at_q = p.value[0];
  for (int k = 1; k < 6; ++k) {
    const M is_p = p.value[k] < low_p;
    q_at_p = is_p ? q.value[k] : q_at_p;
    low_p = is_p ? p.value[k] : low_p;
    const M is_q = q.value[k] < low_q;
    p_at_q = is_q ? p.value[k] : p_at_q;
    low_q = is_q ? q.value[k] : low_q;
  }
  const V slope = (q_at_p - low_p) + (p_at_q - low_q);
  const V share = smaller(larger((q_at_p - low_q) / larger(slope, all(1e-30F)), V{}), all(1.0F));
  V low = all(3e38F);
  for (int k = 0; k < 6; ++k) low = smaller(low, share * p.value[k] + (1.0F - share) * q.value[k]);
  return low;
}

/// Smallest of g.u - |g.(way + turn x u)| / 2 over the corners: linear in the point for every instant and in the
/// instant for every point, so nothing in between is smaller.
GOUGE_INLINE V least_at_corners(const Triangle& t, const V3& g, const Frame& f) {
  const V still = dot(g, f.way);
  const V3 lever = cross(g, f.turn);
  const V at_a = dot(g, t.a) - 0.5F * size(still + dot(lever, t.a));
  const V at_b = dot(g, t.b) - 0.5F * size(still + dot(lever, t.b));
  const V at_c = dot(g, t.c) - 0.5F * size(still + dot(lever, t.c));
  return smaller(at_a, smaller(at_b, at_c));
}

/// A direction, and how far the piece's core reaches in it: no point of the core is beyond.
struct Support {
  V3 direction, point;
  V reach;
};

// A triangle that meets the tool with its inside is bounded best by its own plane. Directions in which the core
// goes on without end prove nothing; the first look is then at the core's lower end.
GOUGE_INLINE void support_along_normal(const KernelPiece& piece, const Triangle& t, const V3& axis, Support& out) {
  const KernelPiece::Line& start = piece.lines[piece.count > 1 ? 1 : 0];
  const V z0 = all(piece.count > 1 ? start.z : 0.5F * (piece.z_lo_mm + piece.z_hi_mm));
  const V3 unit = times(t.normal, root(t.normal_scale));
  const V3 lowest = times(axis, z0);
  const M is_away = dot(unit, minus(t.a, lowest)) >= 0;
  const V3 g = chosen(is_away, unit, {-unit.x, -unit.y, -unit.z});
  const V gz = dot(g, axis);
  const V3 across = minus(g, times(axis, gz));
  const V gr = root(dot(across, across));
  V reach = all(-3e38F), r = V{}, z = z0;
  for (std::uint32_t k = 1; k < piece.count; ++k) {
    const KernelPiece::Line& line = piece.lines[k];
    const V here = gr * line.r + gz * line.z;
    const M is_farther = here > reach;
    reach = is_farther ? here : reach;
    r = is_farther ? all(line.r) : r;
    z = is_farther ? all(line.z) : z;
  }
  const KernelPiece::Line& last = piece.lines[piece.count - 1];
  const KernelPiece::Line& first = piece.lines[0];
  const M is_endless = (gr * last.dr + gz * last.dz > 0) | (gr * first.dr + gz * first.dz < 0) |
                       (t.normal_scale >= 1e29F);
  out.direction = g;
  out.reach = (is_endless | (reach < -1e38F)) ? all(3e38F) : reach;
  const V3 at_ring = plus(times(axis, z), times(across, r * inverse(gr)));
  out.point = chosen(is_endless, lowest, at_ring);
}

constexpr int kRounds = 6;
constexpr float kWorthwhile = 0.25F;

void triangles(const TriangleBlock& block, const SweepFrame& frame, const KernelPiece& piece, float need,
               KernelAnswer& answer) {
  const Frame f = spread(frame);
  Triangle t;
  prepare(block, f.tip, t);
  const V far = root(larger(dot(t.a, t.a), larger(dot(t.b, t.b), dot(t.c, t.c)))) * 1.000001F;
  const V rest = frame.rest_mm + frame.rest_per_mm * far + piece.rounding_mm;
  Range range;
  range.z_lo = least_at_corners(t, f.axis, f) - rest;
  const V3 down{-f.axis.x, -f.axis.y, -f.axis.z};
  range.z_hi = rest - least_at_corners(t, down, f);
  // From a corner no point of the triangle is farther than the longest edge.
  const V edge2 = larger(dot(t.ab, t.ab), larger(dot(t.bc, t.bc), dot(t.ca, t.ca)));
  const V3 across = minus(t.a, times(f.axis, dot(f.axis, t.a)));
  range.r_lo = root(dot(across, across)) - root(edge2) * 1.000001F - 0.5F * frame.way_mm - frame.half_turn * far - rest;
  Support support;
  support_along_normal(piece, t, f.axis, support);
  const V flat = least_at_corners(t, support.direction, f) - support.reach - piece.radius_mm - rest;
  V bound = settle(piece, need, flat, range);
  const M is_left = bound < need;
  int left = 0;
  for (int i = 0; i < 16; ++i) left |= is_left[i];
  if (left == 0) {
    store(flat, answer.distance);
    answer.point = {};
    return finish(bound, need, block.count, answer);
  }
  V3 point = closest(support.point, t);
  V3 last_way{V{}, V{}, V{}};
  Plane last_plane, plane;
  Touch at;
  for (int round = 0;; ++round) {
    touch(piece, point, f.axis, at);
    lay_plane(at.distance, point, at.gradient, t, f, plane);
    V by_plane = least(plane);
    if (round > 0) by_plane = larger(by_plane, least_blended(last_plane, plane));
    last_plane = plane;
    const V better = larger(bound, settle(piece, need, by_plane - rest, range));
    // Lanes that the last rounds brought no nearer to the goal are left to smaller triangles and shorter spans.
    M is_open = better < need;
    if (round > 1) is_open = is_open & (better - bound > kWorthwhile * (need - better));
    bound = better;
    int any = 0;
    for (int i = 0; i < 16; ++i) any |= is_open[i];
    if (any == 0 || round + 1 == kRounds) break;
    // From the piece's core straight to the triangle again; inside the core, deeper. These steps shrink by a
    // constant factor, close to 1 for a large tool nearly flat on its triangle; two of them tell where they lead.
    const V3 next = closest(minus(point, times(at.gradient, size(at.distance + piece.radius_mm))), t);
    const V3 way = minus(next, point);
    const V rate = smaller(dot(way, last_way) * inverse(dot(last_way, last_way)), all(0.98F));
    const M leads = rate > 0.2F;
    point = chosen(leads, closest(plus(next, times(way, rate / (1.0F - rate))), t), next);
    last_way = {leads ? V{} : way.x, leads ? V{} : way.y, leads ? V{} : way.z};
  }
  store(at.distance, answer.distance);
  store(point.x, answer.point[0]);
  store(point.y, answer.point[1]);
  store(point.z, answer.point[2]);
  finish(bound, need, block.count, answer);
}

#undef GOUGE_INLINE

}  // namespace

extern const SweepKernel kKernel;
const SweepKernel kKernel{GOUGE_KERNEL_NAME, nodes, triangles};

}  // namespace gouge::GOUGE_KERNEL
