#include "lib/surface/solid_boundary.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "lib/base/parallel.h"
#include "lib/mesh/indexed_mesh.h"
#include "lib/mesh/union_find.h"
#include "lib/surface/facet_cuts.h"
#include "lib/surface/sheet_sides.h"
#include "lib/surface/triangle_meetings.h"

namespace gouge {
namespace {

/// Role of a part of the surface for the body.
enum class Role : std::uint8_t { unknown, boundary, turned, inside };

double area2_of(const IndexedMesh& mesh, std::size_t triangle) {
  return (mesh.corner(triangle, 1) - mesh.corner(triangle, 0))
      .cross(mesh.corner(triangle, 2) - mesh.corner(triangle, 0))
      .norm();
}

/// Returns the area centroid of a convex polygon.
Vec3 middle_of(const FacetPieces& pieces, const std::vector<std::size_t>& polygon) {
  const Vec3& first = pieces.points[polygon[0]];
  Vec3 sum = Vec3::Zero();
  double all = 0;
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
    const Vec3 &a = pieces.points[polygon[k]], &b = pieces.points[polygon[k + 1]];
    const double area = (a - first).cross(b - first).norm();
    sum += area * (first + a + b) / 3;
    all += area;
  }
  return sum / all;
}

class BoundaryFinder {
 public:
  BoundaryFinder(const IndexedMesh& mesh, const BlockTree& tree, const VertexTriangles& around, unsigned threads)
      : mesh_(mesh),
        tree_(tree),
        around_(around),
        threads_(threads),
        rounding_mm_(rounding_of(mesh)),
        patches_(mesh.triangles.size()) {}

  std::optional<SolidBoundary> run() {
    meetings_ = find_triangle_meetings(tree_, threads_);
    find_met();
    join_patches();
    find_roles();
    if (meetings_.empty() && is_all(Role::boundary)) return std::nullopt;
    result_.mesh.name = mesh_.name;
    add_whole();
    add_cut();
    return finished();
  }

 private:
  /// Finds the meetings of each triangle that has any.
  void find_met() {
    is_met_.assign(mesh_.triangles.size(), false);
    for (std::size_t m = 0; m < meetings_.size(); ++m) {
      for (const std::uint32_t t : {meetings_[m].a, meetings_[m].b}) {
        is_met_[t] = true;
        met_.emplace_back(t, m);
      }
    }
    std::sort(met_.begin(), met_.end());
  }

  /// Joins triangles into patches. Triangles that meet no others have the same sides across edges of two triangles.
  void join_patches() {
    around_.for_each_edge(mesh_, [&](Corner, Corner, const EdgeTriangles& edge) {
      if (edge.count == 2 && !is_met_[edge.first[0]] && !is_met_[edge.first[1]])
        patches_.join(edge.first[0], edge.first[1]);
    });
  }

  /// Finds the role of each patch from its largest triangle.
  void find_roles() {
    std::vector<std::uint32_t> largest(mesh_.triangles.size());
    std::vector<double> areas2(mesh_.triangles.size(), -1);
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (is_met_[t]) continue;
      const std::uint32_t root = patches_.root(t);
      const double area2 = area2_of(mesh_, t);
      if (!(area2 > areas2[root])) continue;
      areas2[root] = area2;
      largest[root] = t;
    }
    roles_.assign(mesh_.triangles.size(), Role::inside);
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (!is_met_[t] && patches_.root(t) == t) roots_.push_back(t);
    }
    if (meetings_.empty() && roots_.size() == 1) return roles_.assign(roles_.size(), Role::boundary);
    for_each_chunk(roots_.size(), 16, threads_, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        const std::uint32_t t = largest[roots_[i]];
        const Vec3 middle = (mesh_.corner(t, 0) + mesh_.corner(t, 1) + mesh_.corner(t, 2)) / 3.0;
        // A patch without area bounds nothing, so it keeps the role `inside`.
        if (areas2[roots_[i]] > 0) roles_[roots_[i]] = role_at(t, middle, face_normal(mesh_, t));
      }
    });
    for (const std::uint32_t root : roots_) is_known_ = is_known_ && roles_[root] != Role::unknown;
  }

  /// Returns the role of the part of triangle `t` around one of its points.
  [[nodiscard]] Role role_at(std::uint32_t t, const Vec3& point, const Vec3& normal) const {
    const auto sides = find_sheet_sides(tree_, point, normal, rounding_mm_);
    if (!sides) return Role::unknown;
    if ((sides->front == 0) == (sides->back == 0) || sides->lowest != t) return Role::inside;
    return sides->front == 0 ? Role::boundary : Role::turned;
  }

  [[nodiscard]] bool is_all(Role role) const {
    return std::all_of(roots_.begin(), roots_.end(), [&](std::uint32_t root) { return roles_[root] == role; });
  }

  void add_whole() {
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (!is_met_[t]) add(mesh_.triangles[t], roles_[patches_.root(t)], t);
    }
  }

  /// Adds a triangle with a role. Corners below the number of the mesh's vertices are vertices of the mesh.
  void add(const TriangleCorners& corners, Role role, std::uint32_t of) {
    if (role != Role::boundary && role != Role::turned) return;
    const bool is_turned = role == Role::turned;
    result_.mesh.triangles.push_back({corners[0], corners[is_turned ? 2 : 1], corners[is_turned ? 1 : 2]});
    result_.mesh.file_triangle.push_back(mesh_.file_triangle[of]);
  }

  struct CutFacet {
    FacetPieces pieces;
    std::vector<Role> roles;
  };

  void add_cut() {
    std::vector<std::pair<std::size_t, std::size_t>> facets;  // ranges of met_: from and to
    for (std::size_t i = 0; i < met_.size();) {
      std::size_t end = i;
      while (end < met_.size() && met_[end].first == met_[i].first) ++end;
      facets.emplace_back(i, end);
      i = end;
    }
    std::vector<CutFacet> cut(facets.size());
    for_each_chunk(facets.size(), 1, threads_, [&](std::size_t first, std::size_t last) {
      for (std::size_t f = first; f < last; ++f) cut[f] = cut_and_judge(facets[f].first, facets[f].second);
    });
    new_points_.clear();
    for (std::size_t f = 0; f < facets.size(); ++f) add_pieces(met_[facets[f].first].first, cut[f]);
  }

  [[nodiscard]] CutFacet cut_and_judge(std::size_t first, std::size_t end) const {
    const std::uint32_t t = met_[first].first;
    std::vector<std::array<Vec3, 2>> segments;
    for (std::size_t i = first; i < end; ++i) {
      const TriangleMeeting& meeting = meetings_[met_[i].second];
      if (!meeting.is_coplanar) {
        segments.push_back({meeting.from, meeting.to});
        continue;
      }
      const std::uint32_t other = meeting.a == t ? meeting.b : meeting.a;
      for (std::size_t k = 0; k < 3; ++k)
        segments.push_back({mesh_.corner(other, k), mesh_.corner(other, (k + 1) % 3)});
    }
    CutFacet cut;
    cut.pieces = cut_facet({mesh_.corner(t, 0), mesh_.corner(t, 1), mesh_.corner(t, 2)}, segments, 4 * rounding_mm_);
    const Vec3 normal = face_normal(mesh_, t);
    for (const std::vector<std::size_t>& polygon : cut.pieces.polygons)
      cut.roles.push_back(role_at(t, middle_of(cut.pieces, polygon), normal));
    return cut;
  }

  void add_pieces(std::uint32_t t, const CutFacet& cut) {
    std::vector<Corner> corner_of(cut.pieces.points.size());
    for (std::size_t p = 0; p < corner_of.size(); ++p) {
      if (p < 3) {
        corner_of[p] = mesh_.triangles[t][p];
      } else {
        corner_of[p] = static_cast<Corner>(mesh_.vertices.size() + new_points_.size());
        new_points_.push_back(cut.pieces.points[p]);
      }
    }
    for (std::size_t k = 0; k < cut.roles.size(); ++k) {
      const std::vector<std::size_t>& polygon = cut.pieces.polygons[k];
      is_known_ = is_known_ && cut.roles[k] != Role::unknown;
      result_.is_cut = result_.is_cut || cut.roles[k] == Role::boundary || cut.roles[k] == Role::turned;
      for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
        add({corner_of[polygon[0]], corner_of[polygon[i]], corner_of[polygon[i + 1]]}, cut.roles[k], t);
    }
  }

  /// Returns the boundary with only the vertices that are used, in their order.
  SolidBoundary finished() {
    IndexedMesh& mesh = result_.mesh;
    result_.is_known = is_known_;
    if (!is_known_) {
      mesh.triangles.clear();
      mesh.file_triangle.clear();
      return std::move(result_);
    }
    const std::size_t own = mesh_.vertices.size();
    std::vector<bool> is_used(own + new_points_.size(), false);
    for (const TriangleCorners& triangle : mesh.triangles) {
      for (const Corner corner : triangle) is_used[corner] = true;
    }
    std::vector<Corner> number(is_used.size());
    for (std::size_t v = 0; v < is_used.size(); ++v) {
      if (!is_used[v]) continue;
      number[v] = static_cast<Corner>(mesh.vertices.size());
      mesh.vertices.push_back(v < own ? mesh_.vertices[v] : new_points_[v - own]);
    }
    for (TriangleCorners& triangle : mesh.triangles) {
      for (Corner& corner : triangle) corner = number[corner];
    }
    return std::move(result_);
  }

  const IndexedMesh& mesh_;
  const BlockTree& tree_;
  const VertexTriangles& around_;
  unsigned threads_;
  double rounding_mm_;
  std::vector<TriangleMeeting> meetings_;
  std::vector<bool> is_met_;                                // by triangle
  std::vector<std::pair<std::uint32_t, std::size_t>> met_;  // pairs of triangle and meeting, in order
  UnionFind patches_;
  std::vector<std::uint32_t> roots_;  // roots of the patches
  std::vector<Role> roles_;           // by root
  std::vector<Vec3> new_points_;
  bool is_known_ = true;
  SolidBoundary result_;
};

}  // namespace

std::optional<SolidBoundary> find_solid_boundary(const IndexedMesh& mesh, const BlockTree& tree,
                                                 const VertexTriangles& around, unsigned threads) {
  if (mesh.triangles.empty()) return std::nullopt;
  return BoundaryFinder(mesh, tree, around, threads).run();
}

}  // namespace gouge
