#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lib/base/units.h"
#include "postproc/report/report_model.h"
#include "postproc/result/stored_result.h"

namespace gouge {

/// All data on which the depth of a motion depends, besides the motion. Checksums are those of whole files, sorted.
struct AcceptedSetup {
  std::vector<std::string> parts, fixtures, heads;
  std::string placement;  ///< ReportModel::placement
  std::string tool;       ///< ToolFacts::identity
  double tolerance_mm = 0, resolution_mm = 0, stock_to_leave_mm = 0, shank_clearance_mm = 0, holder_clearance_mm = 0;
  std::string rapid;
  std::vector<std::string> limits{};  ///< StoredOptions::limits
  std::vector<std::string> law{};     ///< StoredOptions::law
};

/// Returns the set-up of a stored result; `tool` is the identity of the finding's tool.
[[nodiscard]] AcceptedSetup setup_of(const StoredResult& result, const std::string& tool);
/// Returns the set-up of a check that was just made.
[[nodiscard]] AcceptedSetup setup_of(const ReportModel& model, const std::string& tool);

/// Returns the first change of the set-up since an acceptance, as a sentence ("the part is another one"); none: no
/// change. The tool is not compared. Lengths in the sentence are in `unit`.
[[nodiscard]] std::optional<std::string> find_change(const AcceptedSetup& accepted, const AcceptedSetup& now,
                                                     LengthUnit unit);

}  // namespace gouge
