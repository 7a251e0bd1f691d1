#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "lib/mesh/indexed_mesh.h"

// Finds the pieces of a surface that bound bodies (docs/method/inside_outside.md, section 2).

namespace gouge {

/// The sides of triangles joined two and two into pieces of surface. Half-edge 3 t + k runs from corner k of triangle t
/// to the next. At an edge with two sides these are mates. At an edge with more sides mates are the two that have
/// material between them, as their orientation shows. Where it does not show that, neighbours in angle are mates. At an
/// edge with an odd number of sides none has a mate.
struct SurfacePieces {
  std::vector<std::uint32_t> piece_of;  ///< per triangle: the lowest triangle of its piece
  std::vector<bool> is_open;            ///< per triangle that names a piece: it has an edge with an odd number of sides
  /// One flag per triangle that names a piece. It is set where the piece, connected by edges, has an edge with more
  /// than two triangles, or a vertex in more than one fan.
  std::vector<bool> is_pinched;
};

/// Requires triangles with three distinct corners.
/// Cost     O(n), O(n log n) where edges have not two triangles each.
[[nodiscard]] SurfacePieces find_pieces(const IndexedMesh& mesh);

/// Pieces that bound bodies, and where the others are.
struct BodyPieces {
  IndexedMesh sound;  ///< over the same vertices: pieces without an open edge that nowhere lie on themselves
  std::vector<std::uint32_t> origin;  ///< per triangle of `sound`: which of the mesh it is
  Box3 doubtful_box;                  ///< of all other pieces; empty: there is none
  std::size_t double_walls = 0;       ///< pieces that are closed but lie on themselves
  std::size_t double_at = 0;          ///< the lowest triangle of the first of them
};

/// Requires triangles with three distinct corners, none twice with the same orientation.
/// Cost     O(n log n).
[[nodiscard]] BodyPieces find_body_pieces(const IndexedMesh& mesh);

}  // namespace gouge
