#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "lib/mesh/edge_faults.h"
#include "lib/mesh/indexed_mesh.h"

// Inside and outside of all surfaces of one kind together. A side is decided only if it is proved
// (docs/method/inside_outside.md).

namespace gouge {

enum class Side { outside, inside, unknown };

/// Points that the caller knows to be on one side: no surface separates them.
struct ConnectedPoints {
  std::vector<Vec3> points;      ///< mm, part coordinates; at least one, off the surface; the most certain first
  std::vector<Vec3> directions;  ///< directions in which a way out is searched, besides those along the coordinate axes
};

class Enclosure {
 public:
  /// Prepares the enclosure. The meshes must outlive it. Cost O(vertices); everything else is done when it is first
  /// needed.
  explicit Enclosure(std::span<const IndexedMesh> meshes);
  ~Enclosure();
  Enclosure(const Enclosure&) = delete;
  Enclosure& operator=(const Enclosure&) = delete;

  /// Returns whether a point is beyond the box of all surfaces, and therefore outside, even of broken surfaces. O(1).
  [[nodiscard]] bool is_beyond(const Vec3& point) const;

  /// Returns the side on which the points are.
  ///
  /// Ensures  (1) The result is outside only in three cases. A point is beyond the box. Or all pieces bound bodies
  ///          (BodyPieces), and a straight line from a point to infinity meets none. Or all pieces bound bodies, all
  ///          edges are balanced, and the points are in a cavity of one file. If points are beyond the box of the other
  ///          pieces, these need not be examined. (2) The result is inside for points that the surfaces enclose, in
  ///          whatever way their gaps are closed within reach of their rims. Then the winding number is odd or, if all
  ///          edges are balanced, not 0; or a file without open edges encloses the points alone. (3) The result is the
  ///          same for the same points, from any number of threads.
  /// Cost     O(n) for points within the box; the first of them O(n log n).
  [[nodiscard]] Side side_of(const ConnectedPoints& joined) const;

  /// Returns why a side is not known, with the names of the files: "part.stl has 3 open edges, so ...".
  [[nodiscard]] std::string why_unknown() const;

 private:
  struct Surface;
  [[nodiscard]] const Surface& surface() const;

  std::span<const IndexedMesh> meshes_;
  Box3 box_, beyond_;
  std::unique_ptr<Surface> surface_;  // made when first requested
};

/// Test for cavities that can be proved: a shell that faces inward and stands alone in solid material.
class Cavities {
 public:
  /// Prepares the test. `file_of` has, for each triangle, the index of its file; empty: all are from one file.
  /// Requires that every edge of the mesh runs equally often both ways. The mesh must outlive the object. Cost O(n).
  explicit Cavities(const IndexedMesh& mesh, std::span<const std::uint32_t> file_of = {});

  /// Returns whether the point is in a cavity, so that the shell is cut out of material. It is true only if all of
  /// these conditions hold. (1) Exactly one shell with two triangles at each edge winds around the point inward. (2)
  /// Other shells of the same file wind around it once outward, and those of other files not at all. (3) No shell whose
  /// box contains the point comes near the first shell. Cost O(n).
  [[nodiscard]] bool contain(const Vec3& point) const;

 private:
  struct Shell {
    Box3 box;
    bool is_manifold = true;  ///< there are two triangles at every edge
    std::uint32_t file = 0;
    bool is_of_one_file = true;
  };
  [[nodiscard]] bool stands_alone(std::uint32_t shell, const Vec3& point) const;

  const IndexedMesh& mesh_;
  std::vector<std::uint32_t> shell_of_;  // for each triangle
  std::vector<Shell> shells_;
};

}  // namespace gouge
