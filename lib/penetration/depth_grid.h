#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "lib/geom/vec.h"

namespace gouge {

struct DepthBody;

/// Cells over a solid that tell most points' side at once, and where nothing can be deeper than the depth of
/// its volumes.
///
/// A cell whose centre lies within half its diagonal of the surface has no point farther from the surface
/// than the diagonal; while that is at most the depth, nothing in it is deeper. Any other cell holds no
/// surface and is all inside or all outside, and so are cells that share a face with it.
class DepthGrid {
 public:
  enum class Answer : std::uint8_t {
    outside,  ///< certainly
    inside,   ///< certainly, at any depth
    shallow,  ///< either; if inside, not deeper than the depth
    ask,      ///< either, at any depth: the cells are too coarse here
  };

  DepthGrid() = default;  ///< asks everywhere
  /// Requires a solid. At most about 4 million cells. Cost O(triangles and cells).
  explicit DepthGrid(const DepthBody& body);

  [[nodiscard]] Answer at(const Vec3& point) const;

 private:
  [[nodiscard]] std::size_t index(const std::array<int, 3>& cell) const;
  [[nodiscard]] Vec3 centre(const std::array<int, 3>& cell) const;
  void mark_surface(const DepthBody& body, std::vector<std::uint8_t>& is_near) const;
  void fill(const DepthBody& body, const std::vector<std::uint8_t>& is_near);

  Vec3 low_ = Vec3::Zero();
  double cell_mm_ = 0, per_mm_ = 0;
  std::array<int, 3> counts_{0, 0, 0};
  std::vector<Answer> cells_;
};

}  // namespace gouge
