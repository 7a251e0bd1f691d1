#pragma once

#include <cstdint>
#include <vector>

#include "lib/geom/pose.h"
#include "lib/mesh/indexed_mesh.h"
#include "lib/penetration/find_penetration.h"

// Scenes of the size of thesis chapter 6: a standing body of 2,400 triangles, a moving one of 554 points.
// Neither is convex. Poses are sought, from a seed, until as many points are inside as a line of table 6.a
// states.

namespace gouge::bench {

/// A sphere with hills, hollows and saddles; 2 * sectors * (rings - 1) triangles.
[[nodiscard]] IndexedMesh make_standing_body(std::size_t rings = 25, std::size_t sectors = 50);

/// A dented lens of 554 points.
[[nodiscard]] std::vector<Vec3> make_moving_points();

inline constexpr double kSceneDepth_mm = 3;

struct PoseRange {
  const char* name;
  std::size_t least, most;  ///< points inside
};

/// The lines of table 6.a.
[[nodiscard]] std::vector<PoseRange> table_6a_ranges();

/// `count` poses, each with its own rotation; without points inside the bodies are near each other all the
/// same.
[[nodiscard]] std::vector<RigidTransform> find_poses(const DepthBody& body, const PointBody& points,
                                                     const PoseRange& range, std::size_t count);

}  // namespace gouge::bench
