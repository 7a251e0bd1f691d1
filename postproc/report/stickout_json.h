#pragma once

#include <nlohmann/json.hpp>

#include "postproc/report/report_model.h"

namespace gouge {

/// A length in `unit`; null for a bound that was never reached and so has no number.
[[nodiscard]] nlohmann::ordered_json length_json(double length_mm, LengthUnit unit);

/// What --find-stickout found; null where it was not asked.
[[nodiscard]] nlohmann::ordered_json stickout_json(const ReportModel& model);

}  // namespace gouge
