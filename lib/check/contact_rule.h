#pragma once

#include <array>
#include <utility>
#include <vector>

#include "lib/check/scene.h"
#include "lib/tool/tool_variants.h"

// The contact table states the parts of a tool that may touch an obstacle. All code that examines a scene follows it.
// The kinds of obstacles are named only here.

namespace gouge {

/// A form of the tool, with the offset for the obstacle that it is compared with.
using ToolForm = CompiledTool ToolVariants::*;

/// The bodies of a form, each alone.
using FormAlone = BodiesAlone AloneVariants::*;

/// Contact that an obstacle permits.
struct ContactRule {
  Against against;
  const char* name;                                 ///< name in messages and results
  ToolForm form;                                    ///< form that the obstacle may enter at most by the tolerance
  ToolForm form_beside_cuts;                        ///< form that keeps the near-miss distance while the tool cuts
  FormAlone alone;                                  ///< the bodies of `form`
  CertifiedDepths ToolVariants::*certified_depths;  ///< certified depths of `form`
  bool is_workpiece;  ///< true: the cutter makes its surface, so positions fit it and contact with it is intended
};

/// The contact rules, in the order of Against.
inline constexpr std::array<ContactRule, 3> kContactRules{{
    {Against::part, "part", &ToolVariants::against_part, &ToolVariants::non_cutting, &AloneVariants::against_part,
     &ToolVariants::part_depths, true},
    {Against::fixture, "fixture", &ToolVariants::against_fixture, &ToolVariants::against_fixture,
     &AloneVariants::against_fixture, &ToolVariants::fixture_depths, false},
    {Against::stock, "stock", &ToolVariants::bare, &ToolVariants::bare, &AloneVariants::bare,
     &ToolVariants::part_depths, false},
}};

[[nodiscard]] inline const ContactRule& rule_of(Against against) {
  return kContactRules[static_cast<std::size_t>(against)];
}

[[nodiscard]] inline const char* against_name(Against against) { return rule_of(against).name; }

/// The meshes of a scene that follow the same rule.
struct ObstacleMeshes {
  const ContactRule& rule;
  const std::vector<IndexedMesh>& meshes;
};

/// Returns one entry for each row of the table, in its order. The scene must outlive it.
[[nodiscard]] inline std::vector<ObstacleMeshes> obstacles_of(const Scene& scene) {
  return {{kContactRules[0], scene.parts}, {kContactRules[1], scene.fixtures}};
}

/// Returns the obstacle of each mesh, counted through all obstacles.
[[nodiscard]] inline std::vector<Against> obstacle_of_meshes(const Scene& scene) {
  std::vector<Against> all;
  for (const ObstacleMeshes& obstacle : obstacles_of(scene))
    all.insert(all.end(), obstacle.meshes.size(), obstacle.rule.against);
  return all;
}

/// Returns the clearance of each mesh, counted through all obstacles; 0 if it has none.
[[nodiscard]] inline std::vector<double> clearance_of_meshes(const Scene& scene) {
  std::vector<double> all;
  for (const ObstacleMeshes& obstacle : obstacles_of(scene)) {
    const std::size_t first = all.size();
    all.resize(first + obstacle.meshes.size(), 0);
    for (const MeshLimit& limit : scene.limits)
      if (limit.against == obstacle.rule.against) all[first + limit.mesh] = limit.clearance_mm;
  }
  return all;
}

/// Returns the meshes whose surface the cutter makes.
[[nodiscard]] inline const std::vector<IndexedMesh>& workpiece_of(const Scene& scene) { return scene.parts; }

/// Returns a scene of a workpiece alone.
[[nodiscard]] inline Scene scene_of_workpiece(std::vector<IndexedMesh> meshes) { return {std::move(meshes), {}}; }

}  // namespace gouge
