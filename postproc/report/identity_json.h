#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "lib/path/toolpath.h"
#include "postproc/report/report_model.h"

// The fields of a report that comparisons with other runs use (docs/formats/report_json.md).

namespace gouge {

/// Returns the first digits of every move's motion_key, as texts of many moves each.
[[nodiscard]] nlohmann::ordered_json motions_json(const Toolpath& path);
/// Returns the runs of moves of one operation and tool, by their first move.
[[nodiscard]] nlohmann::ordered_json runs_json(const Toolpath& path);
/// Returns the statement of a move, as UTF-8, without its line end and text beyond 2000 bytes.
[[nodiscard]] std::string statement_json(const Toolpath& path, const Move& move);

/// Returns the effect of --baseline on the result: its entries and how each was used; null without one.
[[nodiscard]] nlohmann::ordered_json baseline_json(const ReportModel& model);
/// Returns the same of one of CheckResult::events; null where nothing accepts it or anything of it.
[[nodiscard]] nlohmann::ordered_json acceptance_json(const ReportModel& model, std::size_t event);

/// Returns a report's JSON with its digest: `json`, which ends in "\n}\n", and one key more.
[[nodiscard]] std::string with_digest(std::string json);

/// Comparison of the digest at the end of `json` with the bytes before it.
enum class DigestState { right, wrong, missing };
[[nodiscard]] DigestState check_digest(std::string_view json);

}  // namespace gouge
