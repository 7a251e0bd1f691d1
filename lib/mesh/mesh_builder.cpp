#include "lib/mesh/mesh_builder.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace gouge {
namespace {

constexpr double kLargest_mm = 1e9;
constexpr Corner kNoCorner = std::numeric_limits<Corner>::max();

// Open-addressed table from coordinates to vertex numbers. Only looked up, never walked, so its layout cannot
// reach the result.
class WeldTable {
 public:
  explicit WeldTable(std::size_t expected_vertices)
      : slots_(std::bit_ceil(expected_vertices * 2 + 16), kNoCorner) {}

  // The number of the vertex at `point`, which is added to `vertices` when new.
  Corner corner(std::vector<Vec3>& vertices, const Vec3& point) {
    if (vertices.size() * 2 >= slots_.size()) grow(vertices);
    const std::size_t slot = slot_of(vertices, point);
    if (slots_[slot] == kNoCorner) {
      slots_[slot] = static_cast<Corner>(vertices.size());
      vertices.push_back(point + Vec3::Zero());  // -0 becomes +0
    }
    return slots_[slot];
  }

 private:
  static std::size_t hash(const Vec3& point) {
    std::uint64_t mixed = 0;
    for (int k = 0; k < 3; ++k) {
      mixed ^= std::bit_cast<std::uint64_t>(point[k] + 0.0);  // -0 becomes +0
      mixed = (mixed ^ (mixed >> 30)) * 0xbf58476d1ce4e5b9ULL;
      mixed = (mixed ^ (mixed >> 27)) * 0x94d049bb133111ebULL;
      mixed ^= mixed >> 31;
    }
    return static_cast<std::size_t>(mixed);
  }

  // Where the vertex at `point` is, or the empty slot where it belongs.
  [[nodiscard]] std::size_t slot_of(const std::vector<Vec3>& vertices, const Vec3& point) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = hash(point) & mask;
    while (slots_[slot] != kNoCorner && vertices[slots_[slot]] != point) slot = (slot + 1) & mask;
    return slot;
  }

  void grow(const std::vector<Vec3>& vertices) {
    slots_.assign(slots_.size() * 2, kNoCorner);
    for (std::size_t i = 0; i < vertices.size(); ++i)
      slots_[slot_of(vertices, vertices[i])] = static_cast<Corner>(i);
  }

  std::vector<Corner> slots_;
};

// Zero in exact arithmetic too for nearly all single-precision files; a sliver that rounds to zero is told
// with them and kept all the same.
bool is_collinear(const std::array<Vec3, 3>& t) {
  return (t[1] - t[0]).cross(t[2] - t[0]).squaredNorm() <= 0;
}

bool is_degenerate(const std::array<Vec3, 3>& t) {
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

bool is_in_range(const std::array<Vec3, 3>& t, double scale) {
  return std::all_of(t.begin(), t.end(),
                     [&](const Vec3& point) { return point.cwiseAbs().maxCoeff() * scale <= kLargest_mm; });
}

}  // namespace

Result<BuiltMesh> build_mesh(const TriangleSoup& soup, const MeshPlacement& placement) {
  BuiltMesh built;
  IndexedMesh& mesh = built.mesh;
  mesh.name = soup.name;
  mesh.triangles.reserve(soup.triangles.size());
  mesh.file_triangle.reserve(soup.triangles.size());
  mesh.vertices.reserve(soup.triangles.size() / 2 + 2);
  WeldTable table(soup.triangles.size());
  const double scale = mm_per(placement.unit);
  const auto centre = [&](const std::array<Vec3, 3>& t) {
    return placement.place.point((t[0] + t[1] + t[2]) * (scale / 3));
  };
  for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
    const std::array<Vec3, 3>& triangle = soup.triangles[i];
    if (!is_in_range(triangle, scale)) {
      return make_error(
          "stl-coordinate-too-large",
          "triangle " + std::to_string(i + 1) +
              " has a coordinate beyond 1e9 mm; expected a machine part, check the file and its unit",
          soup.name);
    }
    if (is_degenerate(triangle)) {
      built.degenerate.add(centre(triangle), i);
      continue;
    }
    if (is_collinear(triangle)) built.collinear.add(centre(triangle), i);
    TriangleCorners corners{};
    for (std::size_t k = 0; k < 3; ++k) corners[k] = table.corner(mesh.vertices, triangle[k]);
    mesh.triangles.push_back(corners);
    mesh.file_triangle.push_back(static_cast<std::uint32_t>(i));
  }
  if (mesh.triangles.empty()) {
    return make_error("stl-no-surface",
                      "every triangle of " + std::to_string(soup.triangles.size()) +
                          " has two identical corners; expected a surface",
                      soup.name);
  }
  for (Vec3& vertex : mesh.vertices) vertex = placement.place.point(vertex * scale);
  if (soup.opposite_normals > 0) {
    built.opposite_normals = {soup.opposite_normals, centre(soup.triangles[soup.first_opposite_normal]),
                              soup.first_opposite_normal};
  }
  return built;
}

}  // namespace gouge
