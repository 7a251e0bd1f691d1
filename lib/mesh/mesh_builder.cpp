#include "lib/mesh/mesh_builder.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "lib/base/large_pages.h"
#include "lib/base/stage.h"

namespace gouge {
namespace {

constexpr double kLargest_mm = 1e9;
constexpr Corner kNoCorner = std::numeric_limits<Corner>::max();

std::uint64_t hash_of(const Vec3& point) {
  constexpr std::uint64_t kOdd[3] = {0x9e3779b97f4a7c15ULL, 0xbf58476d1ce4e5b9ULL, 0x94d049bb133111ebULL};
  std::uint64_t mixed = 0;
  for (int k = 0; k < 3; ++k) {  // -0 becomes +0
    mixed = (mixed ^ std::bit_cast<std::uint64_t>(point[k] + 0.0)) * kOdd[k];
    mixed ^= mixed >> 32;
  }
  return mixed;
}

// Open-addressed table from coordinates to vertex numbers. It is only looked up, never traversed, so its layout cannot
// affect the result. A slot keeps half of the hash, so nearly only the matching vertex is examined.
class WeldTable {
 public:
  explicit WeldTable(std::size_t expected_vertices) : mask_(std::bit_ceil(expected_vertices * 2 + 16) - 1) {
    reserve_large(slots_, mask_ + 1);
    slots_.resize(mask_ + 1);
  }

  void prefetch(std::uint64_t hash) const { __builtin_prefetch(&slots_[hash & mask_]); }

  // Returns the number of the vertex at `point`, which is added to `vertices` if it is new.
  Corner corner(std::vector<Vec3>& vertices, const Vec3& point, std::uint64_t hash) {
    if (vertices.size() * 4 >= slots_.size() * 3) grow(vertices);
    Slot& slot = slots_[slot_of(vertices, point, hash)];
    if (slot.vertex == kNoCorner) {
      slot = {static_cast<Corner>(vertices.size()), tag_of(hash)};
      vertices.push_back(point + Vec3::Zero());  // -0 becomes +0
    }
    return slot.vertex;
  }

 private:
  struct Slot {
    Corner vertex = kNoCorner;
    std::uint32_t tag = 0;
  };

  static std::uint32_t tag_of(std::uint64_t hash) { return static_cast<std::uint32_t>(hash >> 32); }

  // Returns the slot of the vertex at `point`, or the empty slot where it belongs.
  [[nodiscard]] std::size_t slot_of(const std::vector<Vec3>& vertices, const Vec3& point, std::uint64_t hash) const {
    std::size_t at = hash & mask_;
    while (slots_[at].vertex != kNoCorner && (slots_[at].tag != tag_of(hash) || vertices[slots_[at].vertex] != point))
      at = (at + 1) & mask_;
    return at;
  }

  void grow(const std::vector<Vec3>& vertices) {
    slots_.assign(slots_.size() * 2, Slot{});
    mask_ = slots_.size() - 1;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const std::uint64_t hash = hash_of(vertices[i]);
      slots_[slot_of(vertices, vertices[i], hash)] = {static_cast<Corner>(i), tag_of(hash)};
    }
  }

  std::vector<Slot> slots_;
  std::size_t mask_;
};

// Corners of the next triangles with their hashes. They are fetched ahead, so that the memory of the table is ready in
// time.
class Ahead {
 public:
  Ahead(const TriangleList& triangles, const WeldTable& table) : triangles_(triangles), table_(table) {
    for (std::size_t i = 0; i + 1 < kAhead && i < triangles.size(); ++i) fetch(i);
  }

  struct Entry {
    TrianglePoints points;
    std::array<std::uint64_t, 3> hashes;
  };

  const Entry& at(std::size_t i) {
    if (i + kAhead - 1 < triangles_.size()) fetch(i + kAhead - 1);
    return entries_[i % kAhead];
  }

 private:
  static constexpr std::size_t kAhead = 16;

  void fetch(std::size_t i) {
    Entry& entry = entries_[i % kAhead];
    entry.points = triangles_[i];
    for (std::size_t k = 0; k < 3; ++k) {
      entry.hashes[k] = hash_of(entry.points[k]);
      table_.prefetch(entry.hashes[k]);
    }
  }

  const TriangleList& triangles_;
  const WeldTable& table_;
  std::array<Entry, kAhead> entries_{};
};

// Returns whether the corners are on one line. For nearly all single-precision files the product is also zero in exact
// arithmetic. A sliver that rounds to zero is reported as collinear, and is kept too.
bool is_collinear(const std::array<Vec3, 3>& t) { return (t[1] - t[0]).cross(t[2] - t[0]).squaredNorm() <= 0; }

bool is_degenerate(const std::array<Vec3, 3>& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

bool is_in_range(const std::array<Vec3, 3>& t, double scale) {
  return std::all_of(t.begin(), t.end(),
                     [&](const Vec3& point) { return point.cwiseAbs().maxCoeff() * scale <= kLargest_mm; });
}

}  // namespace

Result<BuiltMesh> build_mesh(const TriangleSoup& soup, const MeshPlacement& placement, const ProgressCall& progress) {
  BuiltMesh built;
  IndexedMesh& mesh = built.mesh;
  mesh.name = soup.name;
  reserve_large(mesh.triangles, soup.triangles.size());
  reserve_large(mesh.file_triangle, soup.triangles.size());
  reserve_large(mesh.vertices, soup.triangles.size() / 2 + 2);
  WeldTable table(soup.triangles.size() / 2);
  Ahead ahead(soup.triangles, table);
  const double scale = mm_per(placement.unit);
  const auto centre = [&](const std::array<Vec3, 3>& t) {
    return placement.transform.point((t[0] + t[1] + t[2]) * (scale / 3));
  };
  Stage stage(progress, "reading " + soup.name, soup.triangles.size());
  for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
    stage.pass(i);
    const auto& [triangle, hashes] = ahead.at(i);
    if (!is_in_range(triangle, scale)) {
      return make_error("stl-coordinate-too-large",
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
    for (std::size_t k = 0; k < 3; ++k) corners[k] = table.corner(mesh.vertices, triangle[k], hashes[k]);
    mesh.triangles.push_back(corners);
    mesh.file_triangle.push_back(static_cast<std::uint32_t>(i));
  }
  if (mesh.triangles.empty()) {
    return make_error(
        "stl-no-surface",
        "every triangle of " + std::to_string(soup.triangles.size()) + " has two identical corners; expected a surface",
        soup.name);
  }
  for (Vec3& vertex : mesh.vertices) vertex = placement.transform.point(vertex * scale);
  if (soup.opposite_normals > 0) {
    built.opposite_normals = {soup.opposite_normals, centre(soup.triangles[soup.first_opposite_normal]),
                              soup.first_opposite_normal};
  }
  return built;
}

}  // namespace gouge
