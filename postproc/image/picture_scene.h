#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "lib/check/prepared_scene.h"
#include "lib/geom/pose.h"
#include "lib/head/head_body.h"
#include "lib/surface/surface.h"
#include "postproc/image/view.h"

namespace gouge {

/// Returns whether the angle between two directions of any length is within the one with this cosine, which is
/// positive.
[[nodiscard]] inline bool is_smooth_between(const Vec3& a, const Vec3& b, double min_cosine) {
  const double dot = a.dot(b);
  return dot > 0 && dot * dot >= min_cosine * min_cosine * a.squaredNorm() * b.squaredNorm();
}

/// Parts and fixtures, or heads, as one list of faces and one list of vertices. The meshes are not copied.
class PictureScene {
 public:
  /// The ends of a sharp edge or a border, as indices of vertices.
  struct Edge {
    std::uint32_t a = 0, b = 0;
  };

  /// Builds the list of a scene, which must outlive it. Cost: O(n), 36 bytes for each triangle up to kMaxKeptNormals
  /// triangles, and 14 that the scene keeps.
  explicit PictureScene(const PreparedScene& scene);
  /// Builds the list of heads at the place to which `to_part` moves them. The heads must outlive it.
  PictureScene(std::span<const HeadBody> heads, const RigidTransform& to_part);
  /// Builds the list of one surface, which must outlive it.
  explicit PictureScene(const Surface& surface);
  PictureScene(const PictureScene&) = delete;
  PictureScene& operator=(const PictureScene&) = delete;

  /// Returns the number of faces, which are in the order of the obstacles.
  [[nodiscard]] std::uint32_t face_count() const;
  [[nodiscard]] std::array<Vec3, 3> corners(std::uint32_t face) const;
  /// Returns the faces that reach into the view, and some that only come near it.
  [[nodiscard]] std::vector<std::uint32_t> faces_in(const View& view) const;
  /// Returns the unit normals at the three corners, smooth across edges that bend less than 35 degrees. They are kept for
  /// all faces, or computed at each call for more than kMaxKeptNormals faces: pictures show a part of them.
  [[nodiscard]] std::array<Eigen::Vector3f, 3> normals(std::uint32_t face) const;
  /// Returns the normal of the face alone; its length is twice the area.
  [[nodiscard]] Vec3 area_normal(std::uint32_t face) const;
  /// Returns the obstacle to which the face belongs. Requires a scene made of obstacles.
  [[nodiscard]] Against against(std::uint32_t face) const {
    const auto next = std::upper_bound(first_faces_.begin(), first_faces_.end(), face);
    return static_cast<Against>(next - first_faces_.begin() - 1);
  }
  /// Returns true for the surface that the cutter machines, and for heads.
  [[nodiscard]] bool is_of_workpiece(std::uint32_t face) const {
    return first_faces_.empty() || rule_of(against(face)).is_workpiece;
  }
  /// Returns the index of the mesh of the face, counted through all obstacles.
  [[nodiscard]] std::uint32_t mesh_of(std::uint32_t face) const;
  /// Returns the clearance of the mesh of the face, mm; 0: none. Requires a scene made of obstacles.
  [[nodiscard]] double clearance_mm(std::uint32_t face) const { return clearances_mm_[mesh_of(face)]; }

  [[nodiscard]] const std::vector<Edge>& edges() const { return edges_; }
  [[nodiscard]] const Vec3& vertex(std::uint32_t index) const;
  [[nodiscard]] std::uint32_t vertex_count() const;
  /// Returns the corners of a face, as indices of vertices.
  [[nodiscard]] std::array<std::uint32_t, 3> corner_vertices(std::uint32_t face) const;

  /// Returns the vertices of each part, which a picture should show whole.
  [[nodiscard]] std::span<const std::span<const Vec3>> part_points() const { return part_points_; }
  /// Returns the diagonal of the parts, mm; 10 if there are no parts.
  [[nodiscard]] double part_size_mm() const { return part_box_.isEmpty() ? 10 : part_box_.diagonal().norm(); }

 private:
  /// 72 MB of normals.
  static constexpr std::uint32_t kMaxKeptNormals = 2'000'000;

  struct Mesh {
    std::span<const Vec3> vertices;
    std::span<const TriangleCorners> triangles;
    const VertexTriangles* around = nullptr;
    std::uint32_t first_vertex = 0, first_face = 0;

    [[nodiscard]] Vec3 area_normal(std::uint32_t triangle) const {
      const TriangleCorners& c = triangles[triangle];
      return (vertices[c[1]] - vertices[c[0]]).cross(vertices[c[2]] - vertices[c[0]]);
    }
    /// Computes the normals of a triangle's corners; `area` returns the area_normal of a triangle.
    template <class AreaNormals>
    [[nodiscard]] std::array<Eigen::Vector3f, 3> normals(std::uint32_t triangle, const AreaNormals& area) const;
  };

  void add(const Surface& surface, std::span<const Vec3> vertices);
  void keep_normals();
  void find_edges(const Mesh& mesh, const IndexedMesh& indices);
  [[nodiscard]] const Mesh& owner_of(std::uint32_t face) const;

  const PreparedScene* prepared_ = nullptr;  ///< null for heads
  std::vector<double> clearances_mm_;        // for each mesh
  std::vector<Mesh> meshes_;
  std::deque<std::vector<Vec3>> moved_;  ///< moved vertices of heads
  std::vector<Edge> edges_;
  std::vector<std::array<Eigen::Vector3f, 3>> normals_;  // empty: there are more faces than kMaxKeptNormals
  std::vector<std::span<const Vec3>> part_points_;
  std::vector<std::uint32_t> first_faces_;  // first face of each obstacle; empty for heads
  Box3 part_box_;
};

}  // namespace gouge
