#include "lib/mesh/cavity.h"

#include <array>
#include <cmath>
#include <numbers>

#include "lib/mesh/adjacency.h"
#include "lib/mesh/union_find.h"
#include "lib/mesh/winding.h"

namespace gouge {
namespace {

// Material around a cavity is at least this share of the cavity's size: two shells closer to each other than that are
// rather one wall written twice.
constexpr double kLeastCavityWall = 0.01;
constexpr double kWholeCavity = 1e-6;

bool is_about(double value, double whole) { return std::abs(value - whole) <= kWholeCavity; }

/// False only when the triangle and the box are apart.
bool may_meet(const std::array<Vec3, 3>& triangle, const Box3& box) {
  Box3 own;
  for (const Vec3& corner : triangle) own.extend(corner);
  if (!own.intersects(box)) return false;
  const Vec3 normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
  const double height = normal.dot(box.center() - triangle[0]);
  const double reach = normal.cwiseAbs().dot(0.5 * box.diagonal());
  return std::abs(height) <= reach;
}

}  // namespace

Cavities::Cavities(const IndexedMesh& mesh, std::span<const std::uint32_t> file_of)
    : mesh_(mesh), shell_of_(mesh.triangles.size()) {
  const MeshAdjacency adjacency(mesh);
  UnionFind roots(mesh.triangles.size());
  for (const MeshEdge& edge : adjacency.edges()) {
    for (const EdgeUse& use : adjacency.uses(edge)) roots.join(adjacency.uses(edge)[0].triangle, use.triangle);
  }
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::uint32_t root = roots.root(t);
    if (root == t) {
      shell_of_[t] = static_cast<std::uint32_t>(shells_.size());
      shells_.emplace_back();
    }
    shell_of_[t] = shell_of_[root];
    Shell& shell = shells_[shell_of_[t]];
    const std::uint32_t file = file_of.empty() ? 0 : file_of[t];
    if (root == t) shell.file = file;
    shell.is_of_one_file = shell.is_of_one_file && shell.file == file;
    for (std::size_t k = 0; k < 3; ++k) shell.box.extend(mesh.corner(t, k));
  }
  for (const MeshEdge& edge : adjacency.edges()) {
    if (edge.use_count != 2) shells_[shell_of_[adjacency.uses(edge)[0].triangle]].is_manifold = false;
  }
}

bool Cavities::contain(const Vec3& point) const {
  std::vector<double> windings(shells_.size(), 0);
  for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
    windings[shell_of_[t]] +=
        solid_angle(mesh_.corner(t, 0), mesh_.corner(t, 1), mesh_.corner(t, 2), point) / (4 * std::numbers::pi);
  }
  double others = 0;
  std::vector<std::uint32_t> inward;
  for (std::uint32_t k = 0; k < shells_.size(); ++k) {
    if (is_about(windings[k], -1) && shells_[k].is_manifold)
      inward.push_back(k);
    else
      others += windings[k];
  }
  if (inward.size() != 1) return false;
  const Shell& cavity = shells_[inward[0]];
  // What another file winds about is a part of its own: it neither holds this file's cavity nor leaves it empty.
  for (std::uint32_t k = 0; k < shells_.size(); ++k) {
    const bool is_same_file = shells_[k].is_of_one_file && shells_[k].file == cavity.file;
    if (!is_same_file && !is_about(windings[k], 0)) return false;
  }
  return cavity.is_of_one_file && is_about(others, 1) && stands_alone(inward[0], point);
}

bool Cavities::stands_alone(std::uint32_t shell, const Vec3& point) const {
  Box3 box = shells_[shell].box;
  const Vec3 wall = Vec3::Constant(kLeastCavityWall * box.diagonal().norm());
  box = Box3(box.min() - wall, box.max() + wall);
  for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
    if (shell_of_[t] == shell || !shells_[shell_of_[t]].box.contains(point)) continue;
    if (may_meet({mesh_.corner(t, 0), mesh_.corner(t, 1), mesh_.corner(t, 2)}, box)) return false;
  }
  return true;
}

}  // namespace gouge
