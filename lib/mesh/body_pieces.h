#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "lib/mesh/indexed_mesh.h"

// Finds the pieces of a surface that bound bodies (docs/method/inside_outside.md, section 2).

namespace gouge {

/// The sides of triangles, joined in pairs into pieces of surface. Half-edge 3 t + k runs from corner k of triangle t
/// to the next corner. At an edge with two sides, these are mates. At an edge with more sides, two sides are mates if
/// there is material between them, as their orientation shows. If the orientation does not show that, neighbours in
/// angle are mates. At an edge with an odd number of sides, no side has a mate.
struct SurfacePieces {
  std::vector<std::uint32_t> piece_of;  ///< for each triangle: the lowest triangle of its piece
  std::vector<bool> is_open;            ///< for each triangle that names a piece: the piece has an edge with an odd
                                        ///< number of sides
  /// For each triangle that names a piece: the piece, connected by edges, has an edge with more than two triangles or a
  /// vertex in more than one fan.
  std::vector<bool> is_pinched;
};

/// Finds the pieces. Requires triangles with three distinct corners.
/// Cost     O(n); O(n log n) if some edges do not have two triangles.
[[nodiscard]] SurfacePieces find_pieces(const IndexedMesh& mesh);

/// The pieces that bound bodies, and the place of all other pieces.
struct BodyPieces {
  IndexedMesh sound;  ///< over the same vertices: the pieces without an open edge that nowhere lie on themselves
  std::vector<std::uint32_t> origin;  ///< for each triangle of `sound`: its index in the mesh
  Box3 doubtful_box;                  ///< box of all other pieces; empty: there are none
  std::size_t double_walls = 0;       ///< number of pieces that are closed but lie on themselves
  std::size_t double_at = 0;          ///< the lowest triangle of the first such piece
};

/// Finds the pieces that bound bodies. Requires triangles with three distinct corners, no two of them with the same
/// corners and orientation.
/// Cost     O(n log n).
[[nodiscard]] BodyPieces find_body_pieces(const IndexedMesh& mesh);

}  // namespace gouge
