#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "lib/base/boxed.h"
#include "lib/base/paged_memory.h"
#include "lib/check/contact_rule.h"
#include "lib/check/reason.h"
#include "lib/geom/vec.h"
#include "lib/path/joint_angles.h"
#include "lib/tool/compiled_tool.h"

// Verdicts of the check for every move, and the findings made of them. The words are those of docs/method/guarantee.md.

namespace gouge {

enum class MoveState : std::uint8_t { clean, near_miss, gouge, buried, not_checked, not_certified };
[[nodiscard]] const char* state_name(MoveState state);  ///< Returns clean, near, gouge, buried, not-checked or
                                                        ///< not-certified

/// The evidence for a depth: at instant t of the move, the surface point `point` is `depth` deep in the tool.
struct Witness {
  double t = 0;                 ///< instant of the move, in [0, 1]
  Vec3 point = Vec3::Zero();    ///< on the triangle, mm, part coordinates
  Vec3 normal = Vec3::UnitZ();  ///< unit direction in which the tool must move away by the depth
  Body body = Body::cutter;     ///< body of the boundary element nearest to the point
  Against against = Against::part;
  std::uint32_t mesh = 0;      ///< index into the meshes of the obstacle
  std::uint32_t triangle = 0;  ///< index in the STL file, counted from 0
  /// Shares of the ways of the rotary joints at which the tool axis is, for a law that admits several motions. None: the
  /// tool axis is that of the law at `t`.
  std::optional<TurnShares> turn{};
};

/// Bounds of the depth that a tool reached below the surface of a closed solid.
struct OvercutBounds {
  double lower_mm = 0, upper_mm = 0;
};

/// A path has millions of verdicts, and most are clean. So all that a clean move has not is boxed.
struct MoveVerdict {
  MoveState state = MoveState::clean;
  double depth_mm = 0;  ///< depth of the witness; depth <= true depth <= depth_upper
  double depth_upper_mm = 0;
  Boxed<Witness> witness;        ///< present if depth > 0; for a near miss: the closest surface point
  Boxed<double> clearance_mm;    ///< for a near miss: distance at the witness
  Boxed<OvercutBounds> overcut;  ///< of a gouge of a closed solid
  Reason reason;  ///< of a move that is not checked, not certified or buried; for a gouge or a near miss a remark

  /// Returns the lower bound of the overcut; 0 if none was measured.
  [[nodiscard]] double overcut_mm() const { return overcut ? overcut->lower_mm : 0; }
  /// Returns whether the witness is in remaining stock, not in a mesh of the scene.
  [[nodiscard]] bool is_in_stock() const { return witness && witness->against == Against::stock; }
};

using MoveVerdicts = PagedVector<MoveVerdict>;  ///< one for each move, in path order

/// Returns the verdict of a move that is not checked.
[[nodiscard]] inline MoveVerdict not_checked(Reason reason) {
  MoveVerdict verdict;
  verdict.state = MoveState::not_checked;
  verdict.reason = std::move(reason);
  return verdict;
}

/// Neighbouring moves with the same state, tool, body and counterpart, reported as one finding.
struct Event {
  MoveState state = MoveState::gouge;
  std::size_t first_move = 0, last_move = 0;  ///< the first and the last move, both inclusive
  std::size_t worst_move = 0;
  std::size_t moves = 0;  ///< number of moves in the interval that have this state
  std::size_t tool = 0;   ///< index into Toolpath::tools
  Body body = Body::cutter;
  Against against = Against::part;
};

struct StateCounts {
  std::size_t clean = 0, near_miss = 0, gouge = 0, buried = 0, not_checked = 0, not_certified = 0;
  std::size_t skipped = 0;  ///< number of not-checked moves that are rapids, left out at the user's request
};

}  // namespace gouge
