#pragma once

#include <cstddef>
#include <string>

#include "postproc/report/report_model.h"

namespace gouge {

/// Numbers of gouging moves whose bounds have a wider gap than requested. The limit is the resolution for depths, and
/// overcut_gap_mm for overcuts.
struct Gaps {
  std::size_t known = 0;  ///< number of gouging moves with such a gap
  std::size_t wide = 0;   ///< number of these whose gap is wider than requested
  std::size_t widest_move = 0;
  double widest_mm = 0;
};
[[nodiscard]] bool has_wide_depth(const ReportModel& model, const MoveVerdict& verdict);
[[nodiscard]] Gaps depth_gaps(const ReportModel& model);
[[nodiscard]] Gaps overcut_gaps(const ReportModel& model);
/// Returns the maximum overcut of all gouges; 0 without any.
[[nodiscard]] double worst_overcut_upper_mm(const CheckResult& result);

/// Returns a text about gouges whose depth is not known as closely as requested: "the depth of 1 of 30 gouging moves is
/// certified to 0.0206 mm only, ...". It names the first one: "... not to the resolution of 0.001 mm: move 18, line 20,
/// is between 4.0951 and 4.1156 mm deep". Empty if there are none.
[[nodiscard]] std::string depth_gaps_text(const ReportModel& model);
/// Returns the worst overcut: "12.193 mm", or "12.193 to 12.301 mm" if its bounds differ.
[[nodiscard]] std::string overcut_range_text(const ReportModel& model);
/// Returns "a lower bound in 22 of 30 gouging moves; the true one may be up to 0.31 mm larger (move 18)". Empty if
/// there are none.
[[nodiscard]] std::string overcut_gaps_text(const ReportModel& model);

}  // namespace gouge
