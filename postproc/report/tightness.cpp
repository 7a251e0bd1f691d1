#include "postproc/report/tightness.h"

#include <algorithm>

#include "postproc/report/report_text.h"

namespace gouge {
namespace {

// Bounds are sums of many doubles; the resolution itself was asked of them.
constexpr double kRounding_mm = 1e-9;

void add(Gaps& gaps, std::size_t move, double gap_mm, double resolution_mm) {
  ++gaps.known;
  if (gap_mm <= resolution_mm + kRounding_mm) return;
  ++gaps.wide;
  if (gap_mm <= gaps.widest_mm) return;
  gaps.widest_mm = gap_mm;
  gaps.widest_move = move;
}

}  // namespace

bool has_wide_depth(const ReportModel& model, const MoveVerdict& verdict) {
  return verdict.state == MoveState::gouge &&
         verdict.depth_upper_mm - verdict.depth_mm > model.options.resolution_mm + kRounding_mm;
}

Gaps depth_gaps(const ReportModel& model) {
  Gaps gaps;
  const std::vector<MoveVerdict>& verdicts = model.result->verdicts;
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    if (verdicts[i].state == MoveState::gouge)
      add(gaps, i, verdicts[i].depth_upper_mm - verdicts[i].depth_mm, model.options.resolution_mm);
  }
  return gaps;
}

Gaps overcut_gaps(const ReportModel& model) {
  Gaps gaps;
  const std::vector<MoveVerdict>& verdicts = model.result->verdicts;
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    if (verdicts[i].overcut_mm)
      add(gaps, i, verdicts[i].overcut_upper_mm - *verdicts[i].overcut_mm, model.options.resolution_mm);
  }
  return gaps;
}

double worst_overcut_upper_mm(const CheckResult& result) {
  double worst = 0;
  for (const MoveVerdict& v : result.verdicts) {
    if (v.overcut_mm) worst = std::max(worst, v.overcut_upper_mm);
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
