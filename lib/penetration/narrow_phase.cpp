#include "lib/penetration/narrow_phase.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "lib/base/parallel.h"
#include "lib/base/tolerance.h"
#include "lib/geom/half_space.h"
#include "lib/kdop/float4.h"

namespace gouge {

namespace {

constexpr std::size_t kFloatsPerPairBlock = 32;
// Factor of the slack in the filters, which compare squares of single-precision distances: a few roundings of the
// largest coordinate.
constexpr float kFilterSlack = 8;

}  // namespace

NarrowPhase::NarrowPhase(const DepthBody& body)
    : body_(body), reach_(static_cast<float>(body.options.depth_mm) + kFilterSlack * body.slack_mm) {}

void NarrowPhase::set_leaves(std::span<const std::uint32_t> leaves) {
  slots_.clear();
  for (const std::uint32_t leaf : leaves) {
    const KdopNode& node = body_.tree.nodes[leaf];
    for (std::uint32_t k = 0; k < node.item_count; ++k) slots_.push_back(node.first + k);
  }
  const std::size_t blocks = (slots_.size() + 3) / 4;
  blocks_.resize(blocks * kFloatsPerPairBlock);
  for (std::size_t i = 0; i < 4 * blocks; ++i) {
    float* const to = blocks_.data() + i / 4 * kFloatsPerPairBlock + i % 4;
    const FacetRecord& f = body_.facets[slots_[std::min(i, slots_.size() - 1)]];
    const std::array<float, 8> numbers = {f.n[0], f.n[1], f.n[2], f.o, f.c[0], f.c[1], f.c[2], f.r};
    for (std::size_t k = 0; k < numbers.size(); ++k) to[4 * k] = numbers[k];
  }
}

bool NarrowPhase::filter(const Vec3& point) {
  hits_.clear();
  const Float4 x = all4(static_cast<float>(point.x())), y = all4(static_cast<float>(point.y())),
               z = all4(static_cast<float>(point.z()));
  const Float4 reach = all4(reach_);
  bool is_behind = false;
  for (std::size_t i = 0; i < slots_.size(); i += 4) {
    const float* const f = blocks_.data() + i / 4 * kFloatsPerPairBlock;
    const Float4 h = load4(f) * x + load4(f + 4) * y + load4(f + 8) * z - load4(f + 12);
    const Float4 dx = x - load4(f + 16), dy = y - load4(f + 20), dz = z - load4(f + 24), r = load4(f + 28);
    const Float4 d2 = dx * dx + dy * dy + dz * dz, far = r + reach;
    const Int4 is_hit = (h <= reach) & (-h <= reach) & (d2 <= far * far);
    if (!any4(is_hit)) continue;
    const std::size_t lanes = std::min<std::size_t>(4, slots_.size() - i);
    for (std::size_t k = 0; k < lanes; ++k) {
      if (is_hit[k] == 0) continue;
      const float least = FacetRecord::min_distance(h[k], d2[k], r[k]);
      if (least > reach_) continue;
      hits_.push_back({static_cast<std::uint32_t>(i + k), least});
      is_behind = is_behind || h[k] <= kFilterSlack * body_.slack_mm;
    }
  }
  return is_behind;
}

NarrowResult NarrowPhase::test(const Vec3& point, PenetrationCounters& counters) {
  counters.primitive_pairs += slots_.size();
  // A point within the depth below the surface is behind one of the facets that contain its nearest surface point.
  if (!filter(point)) return {};
  return nearest(point, counters);
}

NarrowResult NarrowPhase::nearest(const Vec3& point, PenetrationCounters& counters) const {
  const float slack = kFilterSlack * body_.slack_mm;
  const Hit* first = hits_.data();
  for (const Hit& hit : hits_) {
    if (hit.least < first->least) first = &hit;
  }
  std::uint32_t slot = slots_[first->slot];
  TrianglePoint best = closest_on_triangle(point, body_.corners[slot]);
  ++counters.exact_pairs;
  float within = static_cast<float>(std::sqrt(best.distance2_mm2)) + slack;
  for (const Hit& hit : hits_) {
    if (hit.least > within || &hit == first) continue;
    ++counters.exact_pairs;
    const std::uint32_t other = slots_[hit.slot];
    const TrianglePoint foot = closest_on_triangle(point, body_.corners[other]);
    if (foot.distance2_mm2 > best.distance2_mm2) continue;
    const bool is_tie = !(foot.distance2_mm2 < best.distance2_mm2);
    if (is_tie && body_.tree.order[other] > body_.tree.order[slot]) continue;
    best = foot;
    slot = other;
    within = static_cast<float>(std::sqrt(best.distance2_mm2)) + slack;
  }
  return judge(point, slot, best, counters);
}

/// Decides the side of a point. The nearest of the given facets is the nearest of all if the point is inside. The face
/// decides if nothing else lies between; for edges and vertices the whole surface is searched.
NarrowResult NarrowPhase::judge(const Vec3& point, std::uint32_t slot, const TrianglePoint& nearest,
                                PenetrationCounters& counters) const {
  ClosestPoint foot = body_.surface.signed_closest_point(point, body_.tree.order[slot], nearest);
  if (!foot.is_inside || foot.distance_mm > body_.options.depth_mm) {
    ++counters.false_positives;
    return {};
  }
  const bool is_sure = nearest.min_weight > kFaceRim && body_.is_clear_below[slot] != 0;
  if (!is_sure) {
    ++counters.inside_tests;
    if (const auto other = body_.surface.closest_point(point, foot.distance_mm)) foot = *other;
    if (!foot.is_inside) {
      ++counters.false_positives;
      return {};
    }
  }
  return {true, foot.distance_mm, foot.normal, foot.triangle};
}

namespace {

constexpr std::size_t kChunk = 1024;

class Prism {
 public:
  Prism(const DepthBody& body, std::uint32_t slot) : body_(body), slot_(slot) {
    const std::array<Vec3, 3>& facet = body.corners[slot];
    const Vec3 up = body.surface.face_normal(body.tree.order[slot]);
    const double depth = body.options.depth_mm;
    for (std::size_t k = 0; k < 3; ++k) {
      box_.extend(facet[k]);
      box_.extend(Vec3(facet[k] - depth * up));
      const Vec3& opposite = facet[(k + 2) % 3];
      const Vec3 inward = up.cross(facet[(k + 1) % 3] - facet[k]).normalized();
      const double rim = inward.dot(facet[k]);
      // The side is slightly inside the rim, like the feet on the face, so that neighbours at right angles are
      // excluded.
      prism_[k] = {inward, rim + 0.5 * kFaceRim * (inward.dot(opposite) - rim)};
    }
    const double top = up.dot(facet[0]);
    prism_[3] = {-up, -(top - Tolerance::kRounding * depth)};
    prism_[4] = {up, top - depth};
  }

  [[nodiscard]] bool is_clear() const {
    return body_.surface.face_normal(body_.tree.order[slot_]).squaredNorm() > 0 && is_clear_at(0);
  }

 private:
  [[nodiscard]] bool is_clear_at(std::uint32_t index) const {
    const float* const box = body_.boxes.data() + 6 * std::size_t{index};
    for (int i = 0; i < 3; ++i) {
      if (static_cast<double>(box[i]) > box_.max()[i] || static_cast<double>(box[i + 3]) < box_.min()[i]) return true;
    }
    const KdopNode& node = body_.tree.nodes[index];
    for (std::uint32_t k = 0; k < node.children; ++k) {
      if (!is_clear_at(node.first + k)) return false;
    }
    for (std::uint32_t k = 0; node.children == 0 && k < node.item_count; ++k) {
      const std::uint32_t other = node.first + k;
      if (other != slot_ && is_any_within(body_.corners[other], prism_)) return false;
    }
    return true;
  }

  const DepthBody& body_;
  std::uint32_t slot_;
  Box3 box_;
  std::array<HalfSpace, 5> prism_;
};

}  // namespace

std::vector<std::uint8_t> facets_clear_below(const DepthBody& body) {
  std::vector<std::uint8_t> is_clear(body.corners.size(), 0);
  for_each_chunk(is_clear.size(), kChunk, 0, [&](std::size_t first, std::size_t last) {
    for (std::size_t slot = first; slot < last; ++slot)
      is_clear[slot] = Prism(body, static_cast<std::uint32_t>(slot)).is_clear() ? 1 : 0;
  });
  return is_clear;
}

}  // namespace gouge
