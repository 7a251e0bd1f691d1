#pragma once

#include <cstdint>
#include <vector>

#include "lib/mesh/indexed_mesh.h"
#include "tests/bench/convex_piece.h"

// The truth the benchmark measures results by: the smallest signed distance of a convex piece over a whole
// mesh. Slow and plain beside the engine; its tree, its bounds and its distance are its own.

namespace gouge::bench {

class ExactDistance {
 public:
  explicit ExactDistance(const IndexedMesh& mesh);

  /// The smallest signed distance, never more than `at_max_mm`, to `accuracy_mm` from above.
  [[nodiscard]] TriangleMinimum minimum(const ConvexPiece& piece, const Pose& pose, double at_max_mm,
                                        double accuracy_mm) const;

  /// Triangles over which the smallest signed distance may be below `below_mm`: the list of those that truly
  /// must be seen, in mesh order. Exact to 1e-6 mm.
  [[nodiscard]] std::vector<std::uint32_t> triangles_below(const ConvexPiece& piece, const Pose& pose,
                                                           double below_mm) const;

 private:
  struct Node {
    Vec3 center = Vec3::Zero(), normal = Vec3::UnitZ();
    double radius = 0, half_thickness = 0, disc_radius = 0;
    std::uint32_t first = 0, count = 0;  ///< leaf: triangles in `order_`; inner: children at first, first + 1
  };
  void split(std::uint32_t node, std::uint32_t first, std::uint32_t last);
  [[nodiscard]] Node bound(std::uint32_t first, std::uint32_t last) const;
  [[nodiscard]] double lower_bound(const ConvexPiece& piece, const Pose& pose, const Node& node) const;
  void descend(const ConvexPiece& piece, const Pose& pose, std::uint32_t node, double accuracy,
               TriangleMinimum& best) const;
  void gather(const ConvexPiece& piece, const Pose& pose, std::uint32_t node, double below,
              std::vector<std::uint32_t>& found) const;
  [[nodiscard]] std::array<Vec3, 3> triangle(std::uint32_t index) const;

  const IndexedMesh& mesh_;
  std::vector<Vec3> middles_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace gouge::bench
