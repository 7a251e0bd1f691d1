#pragma once

#include <cstddef>
#include <string>

#include "postproc/report/report_model.h"

namespace gouge {

/// Numbers of gouging moves that are known less closely than is searched for: depths to the resolution, overcuts to
/// overcut_gap_mm.
struct Gaps {
  std::size_t known = 0;  ///< gouging moves with such a number
  std::size_t wide = 0;   ///< those of them whose upper bound exceeds it by more
  std::size_t widest_move = 0;
  double widest_mm = 0;
};
[[nodiscard]] bool has_wide_depth(const ReportModel& model, const MoveVerdict& verdict);
[[nodiscard]] Gaps depth_gaps(const ReportModel& model);
[[nodiscard]] Gaps overcut_gaps(const ReportModel& model);
/// Returns the maximum overcut of all gouges; 0 without any.
[[nodiscard]] double worst_overcut_upper_mm(const CheckResult& result);

/// Reports gouges whose depth is not as close as requested: "the depth of 1 of 30 gouging moves is certified to 0.0206
/// mm only, ...". It names the first: "... not to the resolution of 0.001 mm: move 18, line 20, is between 4.0951 and
/// 4.1156 mm deep". Empty when there are none.
[[nodiscard]] std::string depth_gaps_text(const ReportModel& model);
/// Returns "12.193 mm", "12.193 to 12.301 mm": the worst overcut of all, which lies between the two where they differ.
[[nodiscard]] std::string overcut_range_text(const ReportModel& model);
/// Returns "a lower bound in 22 of 30 gouging moves; the true one may be up to 0.31 mm larger (move 18)". Empty as
/// above.
[[nodiscard]] std::string overcut_gaps_text(const ReportModel& model);

}  // namespace gouge
