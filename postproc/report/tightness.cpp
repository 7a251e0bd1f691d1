#include "postproc/report/tightness.h"

#include <algorithm>
#include <optional>

#include "lib/base/number_text.h"
#include "lib/base/tolerance.h"
#include "lib/check/overcut_gap.h"
#include "postproc/report/report_text.h"

namespace gouge {
namespace {

/// The difference of two bounds, and its requested maximum.
struct Gap {
  double mm = 0, asked_mm = 0;
};

// Summarises the gaps of all verdicts. `gap_of` returns the gap of a verdict, if it has one.
template <class GapOf>
Gaps gaps_of(const ReportModel& model, const GapOf& gap_of) {
  Gaps gaps;
  for (std::size_t i = 0; i < model.result->verdicts.size(); ++i) {
    const std::optional<Gap> gap = gap_of(model.result->verdicts[i]);
    if (!gap) continue;
    ++gaps.known;
    if (gap->mm <= gap->asked_mm + Tolerance::kRounding_mm) continue;
    ++gaps.wide;
    if (gap->mm <= gaps.widest_mm) continue;
    gaps.widest_mm = gap->mm;
    gaps.widest_move = i;
  }
  return gaps;
}

}  // namespace

bool has_wide_depth(const ReportModel& model, const MoveVerdict& verdict) {
  return verdict.state == MoveState::gouge &&
         verdict.depth_upper_mm - verdict.depth_mm > model.options.resolution_mm + Tolerance::kRounding_mm;
}

Gaps depth_gaps(const ReportModel& model) {
  const double asked_mm = model.options.resolution_mm;
  return gaps_of(model, [&](const MoveVerdict& v) {
    return v.state == MoveState::gouge && !v.is_in_stock() ? std::optional(Gap{v.depth_upper_mm - v.depth_mm, asked_mm})
                                                           : std::nullopt;
  });
}

Gaps overcut_gaps(const ReportModel& model) {
  return gaps_of(model, [](const MoveVerdict& v) {
    if (!v.overcut) return std::optional<Gap>();
    return std::optional(Gap{v.overcut->upper_mm - v.overcut->lower_mm, overcut_gap_mm(v.overcut->lower_mm)});
  });
}

double worst_overcut_upper_mm(const CheckResult& result) {
  double worst = 0;
  for (const MoveVerdict& v : result.verdicts) {
    if (v.overcut) worst = std::max(worst, v.overcut->upper_mm);
  }
  return worst;
}

std::string depth_gaps_text(const ReportModel& model) {
  const Gaps gaps = depth_gaps(model);
  if (gaps.wide == 0) return {};
  const LengthUnit unit = model.toolpath->unit;
  const MoveVerdict& widest = model.result->verdicts[gaps.widest_move];
  return "the depth of " + std::to_string(gaps.wide) + " of " + count_text(gaps.known, "gouging move") +
         (gaps.wide == 1 ? " is" : " are") + " certified to " + length_text(gaps.widest_mm, unit) +
         " only, not to the resolution of " + length_text(model.options.resolution_mm, unit) + ": move " +
         std::to_string(gaps.widest_move) + ", line " + std::to_string(model.toolpath->moves[gaps.widest_move].line) +
         ", is at least " + depth_text(widest.depth_mm, unit) + " and at most " +
         depth_text(widest.depth_upper_mm, unit) + " deep";
}

std::string overcut_range_text(const ReportModel& model) {
  const LengthUnit unit = model.toolpath->unit;
  const std::string least = depth_text(model.result->worst_overcut_mm, unit);
  const std::string most = depth_text(worst_overcut_upper_mm(*model.result), unit);
  return least == most ? least : least.substr(0, least.find(' ')) + " to " + most;
}

std::string overcut_gaps_text(const ReportModel& model) {
  const Gaps gaps = overcut_gaps(model);
  if (gaps.wide == 0) return {};
  return "a lower bound in " + std::to_string(gaps.wide) + " of " + count_text(gaps.known, "gouging move") +
         "; the true one may be up to " + length_text(gaps.widest_mm, model.toolpath->unit) + " larger (move " +
         std::to_string(gaps.widest_move) + ")";
}

}  // namespace gouge
