#include "lib/penetration/below_facets.h"

#include <array>

#include "lib/base/parallel.h"
#include "lib/base/tolerance.h"
#include "lib/geom/half_space.h"

namespace gouge {
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
      // A little inside the rim, as feet on the face are: neighbours at right angles stay out.
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
