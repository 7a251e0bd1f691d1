#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "lib/check/scene.h"
#include "lib/geom/vec.h"
#include "lib/head/head_body.h"

namespace gouge {

/// Parts and fixtures, or heads, as one list of faces ready to be shaded.
struct PictureScene {
  struct Face {
    std::array<std::uint32_t, 3> corners{};
    std::array<Eigen::Vector3f, 3> normals{
        Eigen::Vector3f::Zero(), Eigen::Vector3f::Zero(),
        Eigen::Vector3f::Zero()};  ///< smooth across edges that bend less than 35 degrees
    bool is_fixture = false;
    std::uint32_t mesh = 0;  ///< among the parts, then the fixtures
  };
  struct Edge {
    std::uint32_t a = 0, b = 0;
  };
  std::vector<Vec3> vertices;
  std::vector<Face> faces;  ///< parts first
  std::vector<Edge> edges;  ///< sharp edges and borders
  std::size_t part_vertices = 0;
  Box3 part_box;

  /// Vertices of the parts: what a picture should show whole.
  [[nodiscard]] std::span<const Vec3> part_points() const { return std::span(vertices).first(part_vertices); }
  /// Across the parts, mm; 10 without any.
  [[nodiscard]] double part_size_mm() const { return part_box.isEmpty() ? 10 : part_box.diagonal().norm(); }
};

/// Cost     O(n log n) for n triangles.
[[nodiscard]] PictureScene build_picture_scene(const Scene& scene);

/// The heads, as parts, in the tool's frame.
[[nodiscard]] PictureScene build_picture_heads(std::span<const HeadBody> heads);

}  // namespace gouge
