#include "lib/mesh/mesh_pieces.h"

#include <cstdint>

#include "lib/mesh/winding.h"

namespace gouge::detail {
namespace {

// Distinguishing a cavity from an inside-out body costs one pass over the mesh; files with more inward pieces than
// this are broken anyway.
constexpr std::size_t kMostInwardPieces = 64;

struct Piece {
  std::uint32_t lowest = 0;  // its lowest triangle
  double volume_mm3 = 0;
};

Vec3 centre(const IndexedMesh& mesh, std::size_t t) {
  return (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3;
}

// A piece that faces inward is a cavity when the other pieces have its surface inside them.
bool is_cavity(const IndexedMesh& mesh, UnionFind& pieces, std::uint32_t piece) {
  const Vec3 point = centre(mesh, piece);
  double angle = 0;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (pieces.root(t) != piece) angle += solid_angle(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2), point);
  }
  constexpr double kHalfSphere = 6.283185307179586;
  return angle > kHalfSphere;
}

/// The pieces in the order of their lowest triangles, measured.
std::vector<Piece> measure_pieces(const IndexedMesh& mesh, UnionFind& roots, MeshFindings& found) {
  const Vec3 middle = found.box_mm.center();
  std::vector<Piece> pieces;
  std::vector<std::uint32_t> number(mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::uint32_t root = roots.root(t);
    if (root == t) {
      number[t] = static_cast<std::uint32_t>(pieces.size());
      pieces.push_back({t, 0});
    }
    const Vec3 a = mesh.corner(t, 0) - middle;
    const Vec3 b = mesh.corner(t, 1) - middle;
    const Vec3 c = mesh.corner(t, 2) - middle;
    const double six = a.dot(b.cross(c));
    pieces[number[root]].volume_mm3 += six / 6;
    found.signed_volume_mm3 += six / 6;
    found.area_mm2 += (b - a).cross(c - a).norm() / 2;
  }
  return pieces;
}

}  // namespace

void find_pieces(const IndexedMesh& mesh, UnionFind& pieces, const std::vector<bool>& is_open, MeshFindings& found) {
  std::size_t looked_at = 0;
  const std::vector<Piece> measured = measure_pieces(mesh, pieces, found);
  found.components = measured.size();
  for (const Piece& piece : measured) {
    if (piece.volume_mm3 >= 0 || (!is_open.empty() && is_open[piece.lowest])) continue;
    if (looked_at++ < kMostInwardPieces && is_cavity(mesh, pieces, piece.lowest)) {
      ++found.cavities;
    } else {
      found.inside_out_components.add(centre(mesh, piece.lowest), mesh.file_triangle[piece.lowest]);
    }
  }
}

}  // namespace gouge::detail
