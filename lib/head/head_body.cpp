#include "lib/head/head_body.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "lib/check/mesh_reach.h"
#include "lib/head/revolved_cover.h"
#include "lib/mesh/union_find.h"

namespace gouge {
namespace {

constexpr std::size_t kTries = 200;

/// Piece of surface each triangle belongs to, numbered from 0 as they come.
std::vector<std::uint32_t> pieces_of(const IndexedMesh& mesh) {
  UnionFind joined(mesh.vertices.size());
  for (const TriangleCorners& t : mesh.triangles) {
    joined.join(t[0], t[1]);
    joined.join(t[0], t[2]);
  }
  constexpr std::uint32_t kNew = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> number(mesh.vertices.size(), kNew), piece;
  piece.reserve(mesh.triangles.size());
  std::uint32_t count = 0;
  for (const TriangleCorners& t : mesh.triangles) {
    std::uint32_t& own = number[joined.root(t[0])];
    if (own == kNew) own = count++;
    piece.push_back(own);
  }
  return piece;
}

}  // namespace

Result<HeadBody> build_head_body(IndexedMesh of) {
  if (auto error = find_too_far(of, "head", "--stl-units")) return *std::move(error);
  HeadBody head{Surface(std::move(of)), {}, {}, {}, {}, {}};
  const IndexedMesh& mesh = head.surface.mesh();
  if (!head.surface.is_solid()) {
    return make_error("mesh-head-open",
                      "is not a closed solid facing outward; expected one, since what is inside the head must be "
                      "known; 'gougecheck mesh FILE --repair OUT.stl' reports what is wrong",
                      mesh.name);
  }
  head.box = mesh.box();
  head.cover = make_revolved_cover(mesh);
  head.supports = SupportPlanes(head.surface);
  const std::vector<std::uint32_t> piece = pieces_of(mesh);
  const std::uint32_t pieces = *std::max_element(piece.begin(), piece.end()) + 1;
  head.cores.resize(pieces, Vec3::Zero());
  head.core_depths_mm.resize(pieces, 0);
  const double size = head.box.diagonal().norm();
  const std::size_t step = std::max<std::size_t>(1, mesh.triangles.size() / (kTries * pieces));
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (t % step != 0 && head.core_depths_mm[piece[t]] > 0) continue;
    const Vec3 centre = (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3.0;
    for (double depth = 0.5 * size; depth > 1e-4 * size; depth *= 0.5) {
      const Vec3 core = centre - depth * head.surface.face_normal(t);
      const auto foot = head.surface.closest_point(core);
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
