#pragma once

#include <string>
#include <vector>

#include "postproc/report/report_model.h"

// Words about a gouge that has more contacts than the deepest one.

namespace gouge {

/// Returns the further contacts of a finding's moves: for each body and obstacle the deepest one, the deepest first.
/// Open ones are last, those with the largest bound first.
[[nodiscard]] std::vector<FurtherContact> further_of(const CheckResult& result, const Event& event);

/// Returns "holder too: 2.1 mm against fixture clamp.stl at (1, 2, 3), move 12 t=0.5" for each further contact of a finding.
[[nodiscard]] std::vector<std::string> further_texts(const ReportModel& model, const Event& event);

/// Returns the names of the other bodies of a finding as " (and cutter)"; empty if there is none.
[[nodiscard]] std::string other_bodies_text(const CheckResult& result, const Event& event);
/// Returns the other obstacle of a finding as " (and part)"; empty if there is none.
[[nodiscard]] std::string other_obstacle_text(const CheckResult& result, const Event& event);

/// Returns "; holder too: 2.1 mm against fixture clamp.stl at (1, 2, 3), move 12 t=0.5" for each further contact of a
/// finding; empty if there is none.
[[nodiscard]] std::string further_text(const ReportModel& model, const Event& event);

/// Returns the remark about stock of the move of a finding that is deepest in it; empty if none has one.
[[nodiscard]] std::string stock_too_text(const CheckResult& result, const Event& event);

}  // namespace gouge
