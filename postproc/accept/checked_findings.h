#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "lib/base/units.h"
#include "postproc/accept/accepted_setup.h"
#include "postproc/report/report_model.h"
#include "postproc/result/stored_result.h"

// The findings of a check that acceptances are compared with, from a check that was just made or from a stored result.
// So `check --baseline` and `accept` use the same comparison. Lengths are in mm.

namespace gouge {

/// A move of a finding.
struct CheckedMove {
  std::size_t line = 0;
  std::string motion;  ///< motion_key; empty: the motion cannot be accepted
  double depth_mm = 0, depth_upper_mm = 0;
  std::optional<double> overcut_mm;  ///< lower bound; none: it was not measured
  std::string open;                  ///< another question that is open for the move; empty: none
};

struct CheckedFinding {
  bool is_gouge = false;       ///< false: a near miss, a buried tool or a move that is not certified
  std::string tool_key, tool;  ///< the key of the tool and its identity, which is empty if the tool is not defined
  std::string body, against;
  std::size_t line = 0;  ///< of the worst move
  double depth_mm = 0;   ///< of the worst move
  std::size_t first_line = 0, last_line = 0;
  std::vector<CheckedMove> moves;  ///< empty if it is no gouge
};

struct CheckedTool {
  std::string key, identity;
};

struct CheckedFindings {
  std::string toolpath;  ///< the name of its file
  LengthUnit unit = LengthUnit::mm;
  AcceptedSetup setup;  ///< without a tool
  std::vector<CheckedTool> tools;
  std::vector<CheckedFinding> findings;
};

/// Returns one finding for each of CheckResult::events, in their order.
[[nodiscard]] CheckedFindings checked_findings(const ReportModel& model);
/// Returns one finding for each of StoredResult::findings, in their order.
[[nodiscard]] CheckedFindings checked_findings(const StoredResult& result);

}  // namespace gouge
