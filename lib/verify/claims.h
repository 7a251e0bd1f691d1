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

// The claims of a result and their subject. They are all inputs of a verification.

namespace gouge {

enum class ClaimedState : std::uint8_t { clean, near, gouge, buried, not_checked, not_certified };

struct ClaimedWitness {
  double t = 0;
  Vec3 point = Vec3::Zero(), normal = Vec3::UnitZ();  ///< mm, part coordinates; unit
  Body body = Body::cutter;
  bool is_fixture = false;
  std::size_t mesh = 0;              ///< index among the parts or the fixtures
  std::size_t triangle = 0;          ///< index in the file, from 0
  std::optional<TurnShares> turn{};  ///< shares of the rotary joints' ways; none: as the law states at `t`
  bool is_stock = false;             ///< a point of remaining stock, which has neither mesh nor triangle
};

/// A body that gouges an obstacle in a move whose witness is of another body or obstacle. Its depth is that in the body
/// alone.
struct FurtherClaim {
  Body body = Body::cutter;
  bool is_fixture = false, is_stock = false;
  double depth_mm = 0;
  std::optional<double> depth_upper_mm;   ///< nothing: unbounded
  std::optional<ClaimedWitness> witness;  ///< nothing: it is open whether the body gouges
};

struct MoveClaim {
  ClaimedState state = ClaimedState::clean;
  double depth_mm = 0;
  std::optional<double> depth_upper_mm;  ///< nothing: unbounded, or bounded by the state alone (clean)
  std::optional<double> clearance_mm;
  std::optional<ClaimedWitness> witness;
  std::vector<FurtherClaim> further;
};

/// Claims about one mesh.
struct ClaimedLimit {
  bool is_fixture = true;
  std::size_t mesh = 0;
  double clearance_mm = 0;  ///< required distance of the bare tool and of the heads from the mesh
  double tolerance_mm = 0;  ///< allowed depth of the mesh in the tool, or within the clearance
};

/// The law of motion for which this module has proofs.
inline constexpr const char* kGreatCircle = "great-circle";

/// The subject of the claims. Referenced objects must outlive it. Lengths in mm.
struct ClaimedScene {
  const Toolpath& path;
  std::vector<const ToolVariants*> tools;  ///< one for each entry of Toolpath::tools; null: not defined
  std::span<const IndexedMesh> parts, fixtures;
  std::vector<SolidDepth> heads;  ///< bodies that move with the tool, in the tool's frame
  /// law of the tool; nothing is proved of a law that neither this nor `joints` states
  std::string axis_law = kGreatCircle;
  bool is_dogleg = false;  ///< each axis of a rapid moves at full speed until it arrives
  double tolerance_mm = 0.01, resolution_mm = 0.001;
  unsigned threads = 0;
  std::vector<ClaimedLimit> limits{};
  std::optional<ClaimedJoints> joints{};        ///< used with the angles of Toolpath::joints; nothing: the great circle
  std::vector<ClaimedJoints> joints_of_tool{};  ///< one for each entry of Toolpath::tools; empty: `joints` for all

  /// Returns the joints with the tool of a move. Requires `joints`.
  [[nodiscard]] const ClaimedJoints& joints_of(std::size_t move) const {
    const std::size_t tool = path.moves[move].tool;
    return tool < joints_of_tool.size() ? joints_of_tool[tool] : *joints;
  }
  [[nodiscard]] double largest_clean_mm() const { return tolerance_mm + resolution_mm; }
};

/// Returns whether a move with this claim has no depth larger than tolerance + resolution.
[[nodiscard]] inline bool claims_clean(const MoveClaim& claim) {
  return claim.state == ClaimedState::clean || claim.state == ClaimedState::near;
}

}  // namespace gouge
