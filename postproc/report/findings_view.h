#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "postproc/report/report_model.h"

namespace gouge {

/// How findings are listed for people. It changes no verdict, no count and no file.
struct FindingsView {
  static constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();

  bool is_deepest_first = false;  ///< else in the order of the path
  double min_depth_mm = 0;        ///< findings proved shallower are not listed; 0: all are
  std::size_t most = kAll;        ///< no more findings are listed than so many, the deepest
  bool has_statements = false;    ///< quotes the statement of each
  bool is_coloured = false;
};

/// The findings that a view lists.
struct ListedFindings {
  std::vector<std::size_t> events;  ///< of CheckResult::events, in the order of the view
  std::size_t shallower = 0;        ///< not listed by min_depth_mm
  std::size_t more = 0;             ///< not listed by `most` ...
  double deepest_more_mm = 0;       ///< ... and the deepest of them; 0: none gouges
};

/// Gouges, buried tools and near misses. A tool that is buried counts as deepest, a near miss as less deep than any
/// gouge; what may be as deep as min_depth_mm by its upper bound, and what is buried, is listed.
[[nodiscard]] ListedFindings list_events(const ReportModel& model, const FindingsView& view);

}  // namespace gouge
