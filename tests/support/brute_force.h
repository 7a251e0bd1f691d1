#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "lib/check/scene.h"
#include "lib/motion/motion.h"
#include "lib/tool/evaluate.h"

// A slow and simple reference. It tests every triangle at many instants, without a tree and without planes. It uses
// only that the signed distance changes by no more than the distance moved.

namespace gouge {
namespace brute_force {

inline double depth_at(const CompiledTool& tool, const Pose& pose, const Vec3& p) {
  const Vec3 d = p - pose.tip;
  const double z = d.dot(pose.axis);
  return -evaluate_brute_force(tool, (d - z * pose.axis).norm(), z).signed_distance_mm;
}

inline void search(const CompiledTool& tool, const Pose& pose, const std::array<Vec3, 3>& t, double accuracy,
                   double& best) {
  const Vec3 middle = (t[0] + t[1] + t[2]) / 3.0;
  const double radius = std::max({(t[0] - middle).norm(), (t[1] - middle).norm(), (t[2] - middle).norm()});
  const double depth = depth_at(tool, pose, middle);
  best = std::max(best, depth);
  if (depth + radius <= best + accuracy) return;
  for (const Vec3& corner : t) best = std::max(best, depth_at(tool, pose, corner));
  const Vec3 ab = 0.5 * (t[0] + t[1]);
  const Vec3 bc = 0.5 * (t[1] + t[2]);
  const Vec3 ca = 0.5 * (t[2] + t[0]);
  search(tool, pose, {ab, bc, ca}, accuracy, best);
  search(tool, pose, {t[0], ab, ca}, accuracy, best);
  search(tool, pose, {ab, t[1], bc}, accuracy, best);
  search(tool, pose, {ca, bc, t[2]}, accuracy, best);
}

inline double mesh_depth(const CompiledTool& tool, const Pose& pose, const std::vector<IndexedMesh>& meshes,
                         double accuracy) {
  double best = 0;
  for (const IndexedMesh& mesh : meshes) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      search(tool, pose, {mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)}, accuracy, best);
    }
  }
  return best;
}

}  // namespace brute_force

/// Returns the largest depth over a triangle at one pose. The result is at most `accuracy_mm` too small, and never too
/// large.
[[nodiscard]] inline double triangle_depth(const CompiledTool& tool, const Pose& pose,
                                           const std::array<Vec3, 3>& triangle, double accuracy_mm) {
  double best = 0;
  brute_force::search(tool, pose, triangle, accuracy_mm, best);
  return best;
}

struct BruteForceDepth {
  double depth_mm = 0;  ///< a lower bound of the true depth, closer to it with more steps
  double t = 0;
};

/// Returns the largest depth of the move at `steps` + 1 evenly spread instants, against parts and fixtures.
[[nodiscard]] inline BruteForceDepth brute_force_depth(const Motion& motion, const ToolVariants& tool,
                                                       const Scene& scene, std::size_t steps, double accuracy_mm) {
  BruteForceDepth result;
  for (std::size_t k = 0; k <= steps; ++k) {
    const double t = steps == 0 ? 0.0 : static_cast<double>(k) / static_cast<double>(steps);
    const Pose pose = motion.at(t);
    const double depth = std::max(brute_force::mesh_depth(tool.against_part, pose, scene.parts, accuracy_mm),
                                  brute_force::mesh_depth(tool.against_fixture, pose, scene.fixtures, accuracy_mm));
    if (depth > result.depth_mm) result = {depth, t};
  }
  return result;
}

}  // namespace gouge
