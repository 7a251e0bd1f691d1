#include "lib/validate/outward_pieces.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "lib/mesh/opposite_half_edges.h"
#include "lib/mesh/union_find.h"

namespace gouge::detail {
namespace {

/// Per triangle: the lowest triangle of its piece. Empty where edges have not two triangles each.
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

/// A piece's box, six times its volume, and the sum of the absolute values of all products in it.
struct MeasuredPiece {
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
      pieces.emplace_back();
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

}  // namespace

std::optional<bool> face_all_pieces_outward(const IndexedMesh& mesh, std::size_t pieces) {
  if (pieces == 0) return std::nullopt;
  const std::vector<MeasuredPiece> measured = measure(mesh, find_lowest_triangles(mesh, pieces));
  if (measured.size() != pieces || has_box_in_another(measured)) return std::nullopt;
  // Eight roundings a product and one for each sum on its way, doubled for the rounding of the magnitude.
  const double share = 2.3e-16 * (static_cast<double>(mesh.triangles.size()) + 8);
  bool is_outward = true;
  for (const MeasuredPiece& piece : measured) {
    if (!(std::abs(piece.six_volumes) > share * piece.magnitude + 1e-200)) return std::nullopt;
    is_outward = is_outward && piece.six_volumes > 0;
  }
  return is_outward;
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
