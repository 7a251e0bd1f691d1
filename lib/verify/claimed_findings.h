#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "lib/path/toolpath.h"
#include "lib/tool/compiled_tool.h"
#include "lib/verify/claims.h"

// The findings that follow from the moves of a result, gathered by this module's own rules. Definition of a finding:
// docs/formats/report_json.md.

namespace gouge {

enum class ClaimedObstacle : std::uint8_t { part, fixture, stock };

/// A move that a result lists because it is not clean.
struct ListedMove {
  std::size_t move = 0;
  ClaimedState state = ClaimedState::not_checked;
  double depth_mm = 0;
  std::optional<double> clearance_mm = {};
  bool has_witness = false;
  Body body = Body::cutter;  ///< of the witness; of a buried move: the body that is inside
  ClaimedObstacle obstacle = ClaimedObstacle::part;
  std::string_view reason = {};  ///< must outlive it
};

/// Neighbouring moves with the same state, tool, operation, body and obstacle.
struct GatheredFinding {
  ClaimedState state = ClaimedState::gouge;
  std::size_t first_move = 0, last_move = 0, worst_move = 0, moves = 0;
  std::size_t tool = 0;  ///< index into Toolpath::tools
  Body body = Body::cutter;
  ClaimedObstacle obstacle = ClaimedObstacle::part;
  std::size_t number = 0;  ///< worst first, from 1; 0: no finding, but a run of moves that are not certified
};

/// Values that a result states of a finding. They count where its listed moves leave a choice.
struct StatedChoice {
  std::size_t worst_move = 0, number = 0;
};

/// Returns the findings of the listed moves, in path order. `listed` is in path order too. If lengths in the file are
/// rounded, several moves may be listed as equally deep. Then `stated`, one for each finding, chooses among them. It may
/// be empty. In a buried finding whose moves also touch a surface it chooses among these, because no depth is listed.
/// Requires: each listed move is in `path`.
[[nodiscard]] std::vector<GatheredFinding> gather_findings(const Toolpath& path, std::span<const ListedMove> listed,
                                                           std::span<const StatedChoice> stated, bool is_rounded);

}  // namespace gouge
