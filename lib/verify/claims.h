#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lib/mesh/indexed_mesh.h"
#include "lib/path/toolpath.h"
#include "lib/tool/tool_variants.h"
#include "lib/verify/claimed_chain.h"
#include "lib/verify/solid_depth.h"

// The claims of a result and their subject: all inputs of a verification.

namespace gouge {

enum class ClaimedState : std::uint8_t { clean, near, gouge, buried, not_checked, not_certified };

struct ClaimedWitness {
  double t = 0;
  Vec3 point = Vec3::Zero(), normal = Vec3::UnitZ();  ///< mm, part coordinates; unit
  Body body = Body::cutter;
  bool is_fixture = false;
  std::size_t mesh = 0;      ///< of the parts or of the fixtures
  std::size_t triangle = 0;  ///< in the file, counted from 0
};

struct MoveClaim {
  ClaimedState state = ClaimedState::clean;
  double depth_mm = 0;
  std::optional<double> depth_upper_mm;  ///< none: unbounded, or by the state alone (clean)
  std::optional<double> clearance_mm;
  std::optional<ClaimedWitness> witness;
};

/// Further claims about one mesh.
struct ClaimedLimit {
  bool is_fixture = true;
  std::size_t mesh = 0;
  double clearance_mm = 0;  ///< of the bare tool and of the heads from the mesh
  double tolerance_mm = 0;  ///< how deep it may be in the tool, or within the clearance
};

/// The law of motion that is evaluated here.
inline constexpr const char* kGreatCircle = "great-circle";

/// Referenced objects must outlive it. Lengths in mm.
struct ClaimedScene {
  const Toolpath& path;
  std::vector<const ToolVariants*> tools;  ///< one per Toolpath::tools; null: not defined
  std::span<const IndexedMesh> parts, fixtures;
  std::vector<SolidDepth> heads;  ///< bodies that move with the tool, in the tool's frame
  std::string axis_law =
      kGreatCircle;  ///< names how the tool runs; nothing is proved of a law that neither this nor `joints` states
  bool is_dogleg = false;  ///< how rapids run
  double tolerance_mm = 0.01, resolution_mm = 0.001;
  unsigned threads = 0;
  std::vector<ClaimedLimit> limits{};
  std::optional<ClaimedJoints> joints{};  ///< with the angles of Toolpath::joints; none: the great circle

  [[nodiscard]] double largest_clean_mm() const { return tolerance_mm + resolution_mm; }
};

/// Returns whether a move of that state claims that nothing is deeper than tolerance + resolution.
[[nodiscard]] inline bool claims_clean(const MoveClaim& claim) {
  return claim.state == ClaimedState::clean || claim.state == ClaimedState::near;
}

}  // namespace gouge
