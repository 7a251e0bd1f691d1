#include "postproc/image/picture_scene.h"

#include <algorithm>
#include <array>
#include <functional>
#include <numeric>

#include "lib/base/parallel.h"
#include "lib/hierarchy/triangles_within.h"
#include "lib/mesh/vertex_triangles.h"

namespace gouge {
namespace {

constexpr double kSmoothCosine = 0.819;  // cosine of 35 degrees
constexpr std::size_t kLargestFan = 64;  // maximum number of triangles at a vertex for its smooth normal

using Normal = Eigen::Vector3f;

Normal unit(const Vec3& v) {
  const double length = v.norm();
  return length > 0 ? Normal((v / length).cast<float>()) : Normal(0, 0, 1);
}

}  // namespace

template <class AreaNormals>
std::array<Normal, 3> PictureScene::Mesh::normals(std::uint32_t triangle, const AreaNormals& area) const {
  const Vec3 own = area(triangle);
  std::array<Normal, 3> out;
  out.fill(unit(own));
  for (std::size_t k = 0; k < 3; ++k) {
    const std::span<const std::uint32_t> fan = around->at(triangles[triangle][k]);
    Vec3 sum = Vec3::Zero();
    for (const std::uint32_t t : fan.first(std::min(fan.size(), kLargestFan))) {
      const Vec3 other = area(t);
      if (is_smooth_between(other, own, kSmoothCosine)) sum += other;
    }
    if (sum.norm() > 0) out[k] = unit(sum);
  }
  return out;
}

void PictureScene::keep_normals() {
  if (face_count() > kMaxKeptNormals) return;
  normals_.resize(face_count());
  for (const Mesh& mesh : meshes_) {
    std::vector<Vec3> area(mesh.triangles.size());
    const auto each = [&](const std::function<void(std::uint32_t)>& at) {
      for_each_chunk(area.size(), 4096, 0, [&](std::size_t first, std::size_t last) {
        for (std::size_t t = first; t < last; ++t) at(static_cast<std::uint32_t>(t));
      });
    };
    each([&](std::uint32_t t) { area[t] = mesh.area_normal(t); });
    const auto kept = [&area](std::uint32_t t) -> const Vec3& { return area[t]; };
    each([&](std::uint32_t t) { normals_[mesh.first_face + t] = mesh.normals(t, kept); });
  }
}

std::array<Normal, 3> PictureScene::normals(std::uint32_t face) const {
  if (!normals_.empty()) return normals_[face];
  const Mesh& mesh = owner_of(face);
  return mesh.normals(face - mesh.first_face, [&mesh](std::uint32_t t) { return mesh.area_normal(t); });
}

PictureScene::PictureScene(const PreparedScene& scene)
    : prepared_(&scene), clearances_mm_(clearance_of_meshes(*scene.scene)) {
  for (const PreparedObstacle& obstacle : scene.obstacles()) {
    first_faces_.push_back(face_count());
    for (std::size_t m = 0; m < obstacle.meshes.size(); ++m) {
      add(obstacle.surfaces[m], obstacle.meshes[m].vertices);
      if (!obstacle.rule.is_workpiece) continue;
      part_points_.emplace_back(obstacle.meshes[m].vertices);
      for (const Vec3& p : part_points_.back()) part_box_.extend(p);
    }
  }
  keep_normals();
}

PictureScene::PictureScene(std::span<const HeadBody> heads, const RigidTransform& to_part) {
  for (const HeadBody& head : heads) {
    std::vector<Vec3>& moved = moved_.emplace_back(head.surface.mesh().vertices);
    for (Vec3& v : moved) v = to_part.point(v);
    add(head.surface, moved);
  }
  keep_normals();
}

PictureScene::PictureScene(const Surface& surface) {
  add(surface, surface.mesh().vertices);
  keep_normals();
}

void PictureScene::add(const Surface& surface, std::span<const Vec3> vertices) {
  const std::uint32_t first_face = face_count();
  const std::uint32_t first_vertex = vertex_count();
  meshes_.push_back({vertices, surface.mesh().triangles, &surface.triangles_at_vertices(), first_vertex, first_face});
  find_edges(meshes_.back(), surface.mesh());
}

void PictureScene::find_edges(const Mesh& mesh, const IndexedMesh& indices) {
  mesh.around->for_each_edge(indices, [&](Corner a, Corner b, const EdgeTriangles& edge) {
    const bool is_smooth = edge.count == 2 && is_smooth_between(mesh.area_normal(edge.first[0]),
                                                                mesh.area_normal(edge.first[1]), kSmoothCosine);
    if (!is_smooth) edges_.push_back({mesh.first_vertex + a, mesh.first_vertex + b});
  });
}

std::uint32_t PictureScene::face_count() const {
  return meshes_.empty() ? 0 : meshes_.back().first_face + static_cast<std::uint32_t>(meshes_.back().triangles.size());
}

std::uint32_t PictureScene::mesh_of(std::uint32_t face) const {
  const auto after = std::upper_bound(meshes_.begin(), meshes_.end(), face,
                                      [](std::uint32_t f, const Mesh& mesh) { return f < mesh.first_face; });
  return static_cast<std::uint32_t>(after - meshes_.begin() - 1);
}

const PictureScene::Mesh& PictureScene::owner_of(std::uint32_t face) const { return meshes_[mesh_of(face)]; }

std::array<Vec3, 3> PictureScene::corners(std::uint32_t face) const {
  const Mesh& mesh = owner_of(face);
  const TriangleCorners& c = mesh.triangles[face - mesh.first_face];
  return {mesh.vertices[c[0]], mesh.vertices[c[1]], mesh.vertices[c[2]]};
}

Vec3 PictureScene::area_normal(std::uint32_t face) const {
  const Mesh& mesh = owner_of(face);
  return mesh.area_normal(face - mesh.first_face);
}

std::vector<std::uint32_t> PictureScene::faces_in(const View& view) const {
  const double across = view.right.dot(view.centre), along = view.up.dot(view.centre);
  const double half_width = 0.5 * view.width * view.mm_per_pixel, half_height = 0.5 * view.height * view.mm_per_pixel;
  const std::array<HalfSpace, 4> seen{{{view.right, across - half_width},
                                       {-view.right, -across - half_width},
                                       {view.up, along - half_height},
                                       {-view.up, -along - half_height}}};
  const auto shows_all = [&](const BlockTree& tree) {
    return std::ranges::all_of(
        seen, [&](const HalfSpace& half) { return half.direction.dot(tree.origin) - tree.radius_mm >= half.min_mm; });
  };
  if (prepared_ == nullptr || !prepared_->is_within_reach || shows_all(prepared_->workpiece_tree())) {
    std::vector<std::uint32_t> all(face_count());
    std::iota(all.begin(), all.end(), 0U);
    return all;
  }
  std::vector<std::uint32_t> faces;
  for (std::size_t k = 0; k < first_faces_.size(); ++k) {
    for (const std::uint32_t t : triangles_within(prepared_->obstacles()[k].tree, seen))
      faces.push_back(first_faces_[k] + t);
  }
  return faces;
}

std::uint32_t PictureScene::vertex_count() const {
  return meshes_.empty() ? 0 : meshes_.back().first_vertex + static_cast<std::uint32_t>(meshes_.back().vertices.size());
}

std::array<std::uint32_t, 3> PictureScene::corner_vertices(std::uint32_t face) const {
  const Mesh& mesh = owner_of(face);
  const TriangleCorners& c = mesh.triangles[face - mesh.first_face];
  return {mesh.first_vertex + c[0], mesh.first_vertex + c[1], mesh.first_vertex + c[2]};
}

const Vec3& PictureScene::vertex(std::uint32_t index) const {
  const auto after = std::upper_bound(meshes_.begin(), meshes_.end(), index,
                                      [](std::uint32_t v, const Mesh& mesh) { return v < mesh.first_vertex; });
  const Mesh& mesh = *(after - 1);
  return mesh.vertices[index - mesh.first_vertex];
}

}  // namespace gouge
