#include "lib/surface/surface_sign.h"

#include <algorithm>
#include <array>
#include <span>

#include "lib/base/tolerance.h"
#include "lib/mesh/indexed_mesh.h"

namespace gouge {
namespace {

bool runs_along(const IndexedMesh& mesh, std::uint32_t triangle, Corner from, Corner to) {
  const TriangleCorners& t = mesh.triangles[triangle];
  return (t[0] == from && t[1] == to) || (t[1] == from && t[2] == to) || (t[2] == from && t[0] == to);
}

}  // namespace

SurfaceSign::SurfaceSign(const IndexedMesh& mesh, const VertexTriangles& around) : mesh_(&mesh), around_(&around) {
  for (Corner v = 0; v < mesh.vertices.size(); ++v) {
    if (around_->at(v).size() > kMaxAround) kept_.emplace_back(v, at_vertex(v));
  }
}

Vec3 SurfaceSign::outward(std::uint32_t triangle, TriangleFeature feature, std::size_t index) const {
  if (feature == TriangleFeature::face) return face_normal(*mesh_, triangle);
  const Corner corner = mesh_->triangles[triangle][index];
  if (feature == TriangleFeature::edge) return at_edge(corner, mesh_->triangles[triangle][(index + 1) % 3]);
  if (around_->at(corner).size() <= kMaxAround) return at_vertex(corner);
  const auto after = [](const std::pair<Corner, Vec3>& kept, Corner vertex) { return kept.first < vertex; };
  return std::lower_bound(kept_.begin(), kept_.end(), corner, after)->second;
}

/// Returns the sum of the edge's two face normals, if the faces run along the edge in opposite directions; otherwise
/// zero.
Vec3 SurfaceSign::at_edge(Corner from, Corner to) const {
  const EdgeTriangles edge = around_->at_edge(*mesh_, from, to);
  if (edge.count != 2 || runs_along(*mesh_, edge.first[0], from, to) == runs_along(*mesh_, edge.first[1], from, to)) {
    return Vec3::Zero();
  }
  const Vec3 one = face_normal(*mesh_, edge.first[0]), other = face_normal(*mesh_, edge.first[1]);
  return one.squaredNorm() > 0 && other.squaredNorm() > 0 ? Vec3(one + other) : Vec3(Vec3::Zero());
}

/// Returns a unit vector; zero if the normals cancel or the theorem does not hold.
Vec3 SurfaceSign::at_vertex(Corner vertex) const {
  if (!is_plain(vertex)) return Vec3::Zero();
  Vec3 sum = Vec3::Zero();
  for (const std::uint32_t t : around_->at(vertex)) {
    const Vec3 normal = face_normal(*mesh_, t);
    if (!(normal.squaredNorm() > 0)) return Vec3::Zero();
    sum += angle_at(*mesh_, t, vertex) * normal;
  }
  const double length = sum.norm();
  return length > Tolerance::kNoDirection ? Vec3(sum / length) : Vec3(Vec3::Zero());
}

/// Returns whether each edge at the vertex has two triangles, one in either direction. Then each other end of such an
/// edge follows the vertex in one triangle, and precedes it in one.
bool SurfaceSign::is_plain(Corner vertex) const {
  const std::span<const std::uint32_t> around = around_->at(vertex);
  std::array<Corner, kMaxAround> few_next, few_last;
  std::vector<Corner> many_next, many_last;
  if (around.size() > kMaxAround) {
    many_next.resize(around.size());
    many_last.resize(around.size());
  }
  const std::span<Corner> next = many_next.empty() ? std::span(few_next).first(around.size()) : std::span(many_next);
  const std::span<Corner> last = many_last.empty() ? std::span(few_last).first(around.size()) : std::span(many_last);
  for (std::size_t i = 0; i < around.size(); ++i) {
    const TriangleCorners& t = mesh_->triangles[around[i]];
    const std::size_t k = t[0] == vertex ? 0 : t[1] == vertex ? 1 : 2;
    next[i] = t[(k + 1) % 3];
    last[i] = t[(k + 2) % 3];
  }
  std::sort(next.begin(), next.end());
  std::sort(last.begin(), last.end());
  return std::adjacent_find(next.begin(), next.end()) == next.end() &&
         std::equal(next.begin(), next.end(), last.begin(), last.end());
}

}  // namespace gouge
