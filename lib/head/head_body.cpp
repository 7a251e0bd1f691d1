#include "lib/head/head_body.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "lib/check/reach.h"
#include "lib/penetration/closest_point.h"

namespace gouge {
namespace {

constexpr std::size_t kTries = 200;

/// Piece of surface each triangle belongs to, numbered from 0.
std::vector<std::uint32_t> pieces_of(const IndexedMesh& mesh) {
  std::vector<std::uint32_t> vertex_piece(mesh.vertices.size());
  std::iota(vertex_piece.begin(), vertex_piece.end(), 0U);
  const auto root = [&](std::uint32_t v) {
    while (vertex_piece[v] != v) v = vertex_piece[v] = vertex_piece[vertex_piece[v]];
    return v;
  };
  for (const TriangleCorners& t : mesh.triangles) {
    for (std::size_t k = 1; k < 3; ++k) {
      const std::uint32_t a = root(t[0]), b = root(t[k]);
      vertex_piece[std::max(a, b)] = std::min(a, b);
    }
  }
  std::vector<std::uint32_t> names, piece;
  for (const TriangleCorners& t : mesh.triangles) {
    const std::uint32_t name = root(t[0]);
    const auto known = std::find(names.begin(), names.end(), name);
    piece.push_back(static_cast<std::uint32_t>(known - names.begin()));
    if (known == names.end()) names.push_back(name);
  }
  return piece;
}

}  // namespace

Result<HeadBody> build_head_body(const IndexedMesh& mesh) {
  if (!std::all_of(mesh.vertices.begin(), mesh.vertices.end(), is_within_reach)) {
    return make_error("mesh-too-far",
                      "reaches more than 100 m from the origin; expected a head within that; check --stl-units",
                      mesh.name);
  }
  HeadBody head{build_distance_body(mesh), {}, {}, find_flat_patches(mesh)};
  if (!head.surface.is_solid) {
    return make_error("mesh-head-open",
                      "is not a closed solid facing outward; expected one, since what is inside the head must be "
                      "known; 'gougecheck mesh FILE --repair OUT.stl' reports what is wrong",
                      mesh.name);
  }
  measure_clear_above(head.surface, head.flat);
  const std::vector<std::uint32_t> piece = pieces_of(mesh);
  const std::uint32_t pieces = *std::max_element(piece.begin(), piece.end()) + 1;
  head.cores.resize(pieces, Vec3::Zero());
  head.core_depths_mm.resize(pieces, 0);
  const double size = mesh.box().diagonal().norm();
  const std::size_t step = std::max<std::size_t>(1, mesh.triangles.size() / (kTries * pieces));
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (t % step != 0 && head.core_depths_mm[piece[t]] > 0) continue;
    const Vec3 centre = (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3.0;
    for (double depth = 0.5 * size; depth > 1e-4 * size; depth *= 0.5) {
      const Vec3 core = centre - depth * head.surface.sign.face(static_cast<std::uint32_t>(t));
      const auto foot = closest_point(head.surface, core);
      if (!foot || !foot->is_inside || piece[foot->triangle] != piece[t]) continue;
      if (foot->distance_mm <= head.core_depths_mm[piece[t]]) continue;
      head.core_depths_mm[piece[t]] = foot->distance_mm;
      head.cores[piece[t]] = core;
    }
  }
  return head;
}

std::vector<IndexedMesh> head_pieces(const IndexedMesh& mesh) {
  if (find_mesh_findings(mesh).cavities > 0) return {mesh};
  const std::vector<std::uint32_t> piece = pieces_of(mesh);
  std::vector<IndexedMesh> all(piece.empty() ? 0 : *std::max_element(piece.begin(), piece.end()) + 1);
  constexpr Corner kNew = std::numeric_limits<Corner>::max();
  std::vector<Corner> slot(mesh.vertices.size(), kNew);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    IndexedMesh& own = all[piece[t]];
    TriangleCorners corners = mesh.triangles[t];
    for (Corner& c : corners) {
      if (slot[c] == kNew) {
        slot[c] = static_cast<Corner>(own.vertices.size());
        own.vertices.push_back(mesh.vertices[c]);
      }
      c = slot[c];
    }
    own.triangles.push_back(corners);
    own.file_triangle.push_back(mesh.file_triangle[t]);
  }
  for (IndexedMesh& own : all) own.name = mesh.name;
  return all;
}

}  // namespace gouge
