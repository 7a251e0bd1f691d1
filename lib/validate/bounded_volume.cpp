#include "lib/validate/bounded_volume.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "lib/mesh/opposite_half_edges.h"
#include "lib/mesh/union_find.h"
#include "lib/validate/near_triangles.h"
#include "lib/validate/triangle_filter.h"

namespace gouge::detail {
namespace {

/// Returns, for each triangle, the lowest triangle of its piece. Empty if an edge does not have exactly two triangles.
std::vector<std::uint32_t> find_lowest_triangles(const IndexedMesh& mesh, std::size_t pieces) {
  std::vector<std::uint32_t> lowest(mesh.triangles.size(), 0);
  if (pieces == 1) return lowest;
  const auto opposites = find_opposite_half_edges(mesh);
  if (!opposites) return {};
  UnionFind joined(mesh.triangles.size());
  for (std::uint32_t side = 0; side < opposites->size(); ++side) {
    if ((*opposites)[side] < side) joined.join((*opposites)[side] / 3, side / 3);
  }
  for (std::uint32_t t = 0; t < lowest.size(); ++t) lowest[t] = joined.root(t);
  return lowest;
}

/// The box of a piece, six times its volume, and the sum of the absolute values of all products in that volume.
struct MeasuredPiece {
  std::uint32_t lowest = 0;  // index of its lowest triangle
  Box3 box;
  double six_volumes = 0, magnitude = 0;
};

std::vector<MeasuredPiece> measure(const IndexedMesh& mesh, const std::vector<std::uint32_t>& lowest) {
  const Vec3 middle = mesh.box().center();
  std::vector<MeasuredPiece> pieces;
  std::vector<std::uint32_t> number(lowest.size());
  for (std::uint32_t t = 0; t < lowest.size(); ++t) {
    if (lowest[t] == t) {
      number[t] = static_cast<std::uint32_t>(pieces.size());
      pieces.emplace_back().lowest = t;
    }
    MeasuredPiece& piece = pieces[number[lowest[t]]];
    for (std::size_t k = 0; k < 3; ++k) piece.box.extend(mesh.corner(t, k));
    const Vec3 a = mesh.corner(t, 0) - middle, b = mesh.corner(t, 1) - middle, c = mesh.corner(t, 2) - middle;
    piece.six_volumes += a.dot(b.cross(c));
    const Vec3 size_a = a.cwiseAbs(), size_b = b.cwiseAbs(), size_c = c.cwiseAbs();
    piece.magnitude += size_a.x() * (size_b.y() * size_c.z() + size_b.z() * size_c.y()) +
                       size_a.y() * (size_b.z() * size_c.x() + size_b.x() * size_c.z()) +
                       size_a.z() * (size_b.x() * size_c.y() + size_b.y() * size_c.x());
  }
  return pieces;
}

bool has_box_in_another(std::vector<MeasuredPiece> pieces) {
  std::sort(pieces.begin(), pieces.end(),
            [](const auto& a, const auto& b) { return a.box.min().x() < b.box.min().x(); });
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (std::size_t k = i + 1; k < pieces.size() && pieces[k].box.min().x() <= pieces[i].box.max().x(); ++k) {
      if (pieces[i].box.contains(pieces[k].box) || pieces[k].box.contains(pieces[i].box)) return true;
    }
  }
  return false;
}

/// A counter of the pieces that contain a given piece.
class Nesting {
 public:
  Nesting(const IndexedMesh& mesh, const std::vector<std::uint32_t>& lowest)
      : mesh_(mesh), lowest_(lowest), near_(mesh, all_triangles(mesh)), crossings_(lowest.size(), 0) {}

  /// Returns the number of other pieces that contain a piece. Returns nothing if no ray along the axes from its first
  /// corners decides it.
  std::optional<std::size_t> depth(std::uint32_t piece) {
    std::size_t tried = 0;
    for (std::uint32_t t = piece; t < lowest_.size() && tried < kMaxCorners; ++t) {
      if (lowest_[t] != piece) continue;
      for (int axis = 0; axis < 3; ++axis) {
        if (const auto depth = count(piece, mesh_.corner(t, tried % 3), axis)) return depth;
      }
      ++tried;
    }
    return std::nullopt;
  }

 private:
  static constexpr std::size_t kMaxCorners = 12;

  /// Returns the number of other pieces that contain `point`. A piece contains it if the ray crosses the piece an odd
  /// number of times.
  std::optional<std::size_t> count(std::uint32_t piece, const Vec3& point, int axis) {
    Box3 ray(point);
    ray.max()[axis] = std::numeric_limits<double>::infinity();
    bool is_known = true;
    std::vector<std::uint32_t> crossed;
    near_.for_each_at(ray, [&](std::uint32_t t) {
      if (lowest_[t] == piece || !is_known) return;
      const RayMeeting meeting = meet_ray({mesh_.corner(t, 0), mesh_.corner(t, 1), mesh_.corner(t, 2)}, point, axis);
      is_known = meeting != RayMeeting::unknown;
      if (meeting == RayMeeting::once) crossed.push_back(lowest_[t]);
    });
    if (!is_known) return std::nullopt;
    for (const std::uint32_t other : crossed) crossings_[other] ^= 1U;
    std::size_t depth = 0;
    for (const std::uint32_t other : crossed) {
      depth += crossings_[other];
      crossings_[other] = 0;
    }
    return depth;
  }

  const IndexedMesh& mesh_;
  const std::vector<std::uint32_t>& lowest_;
  NearTriangles near_;
  std::vector<std::uint8_t> crossings_;  // by lowest triangle: 1 if the number of crossings is odd
};

/// Returns, for each piece, whether it faces outward. Returns nothing if rounding decides the sign of a volume.
std::optional<std::vector<bool>> facings(const IndexedMesh& mesh, const std::vector<MeasuredPiece>& pieces) {
  // Eight roundings for each product and one for each later sum, doubled because the magnitude is rounded too.
  constexpr double kTwoRoundings = 2.3e-16, kUnderflow = 1e-200;
  const double share = kTwoRoundings * (static_cast<double>(mesh.triangles.size()) + 8);
  std::vector<bool> are_outward;
  for (const MeasuredPiece& piece : pieces) {
    if (!(std::abs(piece.six_volumes) > share * piece.magnitude + kUnderflow)) return std::nullopt;
    are_outward.push_back(piece.six_volumes > 0);
  }
  return are_outward;
}

}  // namespace

std::optional<bool> does_bound_volume(const IndexedMesh& mesh, std::size_t pieces) {
  const std::vector<std::uint32_t> lowest = find_lowest_triangles(mesh, pieces);
  const std::vector<MeasuredPiece> measured = measure(mesh, lowest);
  if (measured.empty() || measured.size() != pieces) return std::nullopt;
  const auto are_outward = facings(mesh, measured);
  if (!are_outward) return std::nullopt;
  if (!has_box_in_another(measured))
    return std::all_of(are_outward->begin(), are_outward->end(), [](bool is_outward) { return is_outward; });
  Nesting nesting(mesh, lowest);
  bool is_alternating = true;
  for (std::size_t i = 0; i < measured.size(); ++i) {
    const auto depth = nesting.depth(measured[i].lowest);
    if (!depth) return std::nullopt;
    is_alternating = is_alternating && (*depth % 2 == 0) == (*are_outward)[i];
  }
  return is_alternating;
}

double signed_volume(const IndexedMesh& mesh) {
  double sum = 0;
  for (const TriangleCorners& t : mesh.triangles) {
    const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
    const double ab = a.x() * b.y() - b.x() * a.y();
    const double ac = a.x() * c.y() - c.x() * a.y();
    const double bc = b.x() * c.y() - c.x() * b.y();
    sum += (ab * c.z() - ac * b.z() + bc * a.z()) / 6;
  }
  return sum;
}

}  // namespace gouge::detail
