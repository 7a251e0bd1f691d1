#include "lib/penetration/below_facets.h"

#include <algorithm>
#include <array>

#include "lib/base/parallel.h"

namespace gouge {
namespace {

constexpr std::size_t kChunk = 1024;

struct HalfSpace {
  Vec3 normal;
  double offset;  ///< kept: normal . x <= offset
};

/// Whether anything of `triangle` is left after cutting; a point on a border is.
template <std::size_t N>
bool is_any_left(const std::array<Vec3, 3>& triangle, const std::array<HalfSpace, N>& spaces) {
  std::array<Vec3, 3 + N> now{}, next{};
  std::copy(triangle.begin(), triangle.end(), now.begin());
  std::size_t count = 3;
  for (const HalfSpace& space : spaces) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3 &a = now[i], &b = now[(i + 1) % count];
      const double out_a = space.normal.dot(a) - space.offset, out_b = space.normal.dot(b) - space.offset;
      if (out_a <= 0) next[kept++] = a;
      if ((out_a > 0) != (out_b > 0) && kept < next.size()) next[kept++] = a + (out_a / (out_a - out_b)) * (b - a);
    }
    count = kept;
    if (count == 0) return false;
    std::swap(now, next);
  }
  return true;
}

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
      const Vec3 across = (facet[(k + 1) % 3] - facet[k]).cross(up).normalized();
      const double rim = across.dot(facet[k]);
      // A little inside the rim, as feet on the face are: neighbours at right angles stay out.
      spaces_[k] = {across, rim - 0.5 * kFaceRim * (rim - across.dot(opposite))};
    }
    const double top = up.dot(facet[0]);
    spaces_[3] = {up, top - 1e-9 * depth};
    spaces_[4] = {-up, -(top - depth)};
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
      if (other != slot_ && is_any_left(body_.corners[other], spaces_)) return false;
    }
    return true;
  }

  const DepthBody& body_;
  std::uint32_t slot_;
  Box3 box_;
  std::array<HalfSpace, 5> spaces_;
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
