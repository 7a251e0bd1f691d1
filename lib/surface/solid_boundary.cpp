#include "lib/surface/solid_boundary.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
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
    find_widths();
    if (meetings_.empty() && is_one_patch()) return std::nullopt;
    join_patches();
    find_roles();
    find_roles_of_slim();
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

  void find_widths() {
    widths_.reserve(mesh_.triangles.size());
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) widths_.push_back(width_of(mesh_, t, rounding_mm_));
  }
  [[nodiscard]] bool is_slim(std::uint32_t t) const { return widths_[t] != TriangleWidth::wide; }

  /// Returns whether edges of two triangles connect all triangles.
  [[nodiscard]] bool is_one_patch() const {
    UnionFind all(mesh_.triangles.size());
    around_.for_each_edge(mesh_, [&](Corner, Corner, const EdgeTriangles& edge) {
      if (edge.count == 2) all.join(edge.first[0], edge.first[1]);
    });
    for (std::uint32_t t = 1; t < mesh_.triangles.size(); ++t) {
      if (all.root(t) != all.root(0)) return false;
    }
    return true;
  }

  /// Joins triangles into patches. Triangles that meet no others have the same sides across edges of two triangles. Slim
  /// triangles connect none, since crossings of two slim ones are not known.
  void join_patches() {
    around_.for_each_edge(mesh_, [&](Corner, Corner, const EdgeTriangles& edge) {
      if (edge.count != 2) return;
      const auto [t, other] = edge.first;
      if (is_slim(t) != is_slim(other)) beside_slim_.push_back(is_slim(t) ? edge.first : std::array{other, t});
      if (!is_met_[t] && !is_met_[other] && is_slim(t) == is_slim(other)) patches_.join(t, other);
    });
  }

  /// Finds the role of each patch from its largest triangle, except for patches of slim triangles.
  void find_roles() {
    std::vector<std::uint32_t> largest(mesh_.triangles.size());
    std::vector<double> areas2(mesh_.triangles.size(), -1);
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (is_met_[t] || is_slim(t)) continue;
      const std::uint32_t root = patches_.root(t);
      if (root == t) roots_.push_back(t);
      const double area2 = area2_of(mesh_, t);
      if (!(area2 > areas2[root])) continue;
      areas2[root] = area2;
      largest[root] = t;
    }
    roles_.assign(mesh_.triangles.size(), Role::inside);
    for_each_chunk(roots_.size(), 16, threads_, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) roles_[roots_[i]] = role_at_middle(largest[roots_[i]]);
    });
    for (const std::uint32_t root : roots_) is_known_ = is_known_ && roles_[root] != Role::unknown;
  }

  /// Finds the roles of slim triangles. Connected ones have the role of the patches around them, if that is one role.
  /// Otherwise each has its own. One without area bounds nothing, so it keeps the role `inside`.
  void find_roles_of_slim() {
    std::map<std::uint32_t, Role> around;  // by root; unknown: several
    for (const auto& [slim, other] : beside_slim_) {
      if (is_met_[slim]) continue;
      const Role role = is_met_[other] ? Role::unknown : roles_[patches_.root(other)];
      const auto [found, is_new] = around.try_emplace(patches_.root(slim), role);
      if (!is_new && found->second != role) found->second = Role::unknown;
    }
    std::vector<std::uint32_t> alone;
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (is_met_[t] || !is_slim(t)) continue;
      const auto found = around.find(patches_.root(t));
      if (found != around.end() && found->second != Role::unknown)
        roles_[t] = found->second;
      else if (widths_[t] == TriangleWidth::slim)
        alone.push_back(t);
    }
    for_each_chunk(alone.size(), 16, threads_, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) roles_[alone[i]] = role_at_middle(alone[i]);
    });
    for (const std::uint32_t t : alone) is_known_ = is_known_ && roles_[t] != Role::unknown;
  }

  [[nodiscard]] Role role_of(std::uint32_t t) { return roles_[is_slim(t) ? t : patches_.root(t)]; }

  [[nodiscard]] Role role_at_middle(std::uint32_t t) const {
    const Vec3 middle = (mesh_.corner(t, 0) + mesh_.corner(t, 1) + mesh_.corner(t, 2)) / 3.0;
    return role_at(t, middle, face_normal(mesh_, t));
  }

  /// Returns the role of the part of triangle `t` around one of its points.
  [[nodiscard]] Role role_at(std::uint32_t t, const Vec3& point, const Vec3& normal) const {
    const auto sides = find_sheet_sides(tree_, point, normal, rounding_mm_);
    if (!sides) return Role::unknown;
    if ((sides->front == 0) == (sides->back == 0) || sides->lowest != t) return Role::inside;
    return sides->front == 0 ? Role::boundary : Role::turned;
  }

  [[nodiscard]] bool is_all(Role role) {
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (role_of(t) != role) return false;
    }
    return true;
  }

  void add_whole() {
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (!is_met_[t]) add(mesh_.triangles[t], role_of(t), t);
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
  std::vector<TriangleWidth> widths_;                       // by triangle
  std::vector<std::array<std::uint32_t, 2>> beside_slim_;   // a slim triangle and one that is not, at one edge
  UnionFind patches_;
  std::vector<std::uint32_t> roots_;  // of the patches that are not slim
  std::vector<Role> roles_;           // by root, and of each slim triangle
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
