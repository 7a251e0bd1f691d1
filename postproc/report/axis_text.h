#pragma once

#include <string>

#include "postproc/report/report_model.h"

// Texts about AxisFacts.

namespace gouge {

/// Format of angles: " deg", or "°" without a blank before it.
enum class DegreeSign { word, sign };

/// Returns an angle with three digits: "12.3 deg", "0.0457 deg".
[[nodiscard]] std::string angle_text(double angle_rad, DegreeSign sign);
/// Returns "0.412 deg/mm" or "10.5 deg/in".
[[nodiscard]] std::string turn_rate_text(double turn_rad_per_mm, LengthUnit unit, DegreeSign sign);
/// Returns J in radians and `unit`, without its unit, with three digits: "0.0123", "3.21e-05".
[[nodiscard]] std::string bending_text(double bending, LengthUnit unit);
/// Returns "4.21 s", "12 min 4 s" or "3 h 5 min".
[[nodiscard]] std::string feed_time_text(double seconds);
/// Returns "line 31"; empty for kNone.
[[nodiscard]] std::string line_of_move(const Toolpath& path, std::size_t move);

/// Returns the lines of the summary about the turn of the axis, its tilt, and the time of the feeds. There are none if
/// nothing is of interest. Requires model.correction.axes.
[[nodiscard]] std::string axis_lines(const ReportModel& model);

}  // namespace gouge
