#include "postproc/report/remedies.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "lib/base/number_text.h"
#include "lib/base/tolerance.h"
#include "postproc/cldata/interpreting/reasons.h"
#include "postproc/report/report_text.h"

namespace gouge {

namespace {

struct Remedy {
  bool (*settles)(const Reason& reason);
  const char* option;
  const char* claim;
};

constexpr std::array<Remedy, 4> kRemedies = {{
    {[](const Reason& reason) {
       return reason.is(Reason::Kind::of_path) && kind_of(reason.detail()) == ReasonKind::compensated;
     },
     "--cutcom centre", "it states that positions under CUTCOM are the cutter's centre"},
    {[](const Reason& reason) {
       return reason.is(Reason::Kind::of_path) && kind_of(reason.detail()) == ReasonKind::around_hole;
     },
     "--retract-plane Z", "it states the height to which drilling cycles retract that name none"},
    {[](const Reason& reason) { return reason.is(Reason::Kind::no_tool); }, "--tool NAME",
     "it states which tool of the library (--tools) cuts where the file names none"},
    {[](const Reason& reason) { return reason.is(Reason::Kind::tool_undefined); }, "--tools LIBRARY",
     "it defines the tools that the file only numbers or names"},
}};

}  // namespace

std::vector<std::string> remedies(const ReportModel& model) {
  std::array<std::size_t, kRemedies.size()> settled{};
  std::size_t open = 0;
  for (const MoveVerdict& verdict : model.result->verdicts) {
    if (verdict.state != MoveState::not_checked || verdict.reason.is(Reason::Kind::rapid_skipped)) continue;
    ++open;
    for (std::size_t k = 0; k < kRemedies.size(); ++k) settled[k] += kRemedies[k].settles(verdict.reason) ? 1U : 0U;
  }
  std::array<std::size_t, kRemedies.size()> order{};
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return settled[a] > settled[b]; });
  std::vector<std::string> all;
  for (const std::size_t k : order) {
    if (settled[k] == 0) break;
    const std::string those = settled[k] < open ? std::to_string(settled[k]) + " of the " + count_text(open, "move")
                              : open == 1       ? "the move"
                                                : "all " + count_text(open, "move");
    all.push_back(std::string(kRemedies[k].option) + " settles the reason of " + those + " that " +
                  (open == 1 ? "is" : "are") + " not checked: " + kRemedies[k].claim);
  }
  return all;
}

namespace {

constexpr double kDegree = std::numbers::pi / 180;

std::string tilt_words(const ReportModel& model, const TiltCure& tilt) {
  // The angle is rounded up, because the machine must be able to reach it.
  constexpr double kDecimals = 100;
  if (tilt.tilt_rad) {
    const double degrees = std::ceil(*tilt.tilt_rad / kDegree * kDecimals - Tolerance::kRounding) / kDecimals;
    const bool has_axes = !model.cure_options || model.cure_options->has_axes;
    return "a tilt of up to " + display_text(degrees, 2) + " deg" +
           (has_axes ? "" : " (the file states no tool axes: 'correct' tilts it only with --allow-multax)");
  }
  return "no tilt (" + tilt.reason + ")";
}

std::string lift_words(const ReportModel& model, const LiftCure& lift) {
  const LengthUnit unit = model.toolpath->unit;
  if (lift.lift_mm) {
    return "a lift of " + short_length_text(*lift.lift_mm, unit) + " along the tool axis" +
           (lift.is_least() ? ""
                            : ", proved; whether less is enough, from " +
                                  short_length_text(lift.not_free_below_mm, unit) + " on, is not certified");
  }
  const std::string where = "line " + std::to_string(std::size_t{model.toolpath->moves[lift.move].line});
  return "no lift up to " + length_text(model.cure_options->max_lift_mm, unit) + " along the tool axis (the " +
         body_name(lift.body) + ", " + where + ")";
}

}  // namespace

Diagnostics describe_unused(const std::vector<Vouched>& vouched, const Assumptions& facts,
                            const std::string& path_file) {
  Diagnostics notes;
  for (const Vouched& one : vouched) {
    if (one.object.empty()) continue;
    const std::string subject = subject_name(one.subject);
    std::vector<std::string> there;
    for (const Assumption& fact : facts)
      if (fact.subject == one.subject && !fact.object.empty()) there.push_back(subject + "=" + fact.object);
    if (std::ranges::find(there, subject + "=" + one.object) != there.end()) continue;
    notes.push_back(
        make_note(kOptionUnused,
                  "--assume " + subject + "=" + one.object + " has no effect: " +
                      (there.empty() ? "the verdict rests on no such fact" : "there is " + listed(there, " and ")),
                  path_file));
  }
  return notes;
}

const FindingCures* cures_of(const ReportModel& model, std::size_t event) {
  const auto found = std::ranges::lower_bound(model.cures, event, {}, &FindingCures::event);
  return found != model.cures.end() && found->event == event ? &*found : nullptr;
}

std::string cure_text(const ReportModel& model, const FindingCures& cures) {
  return tilt_words(model, cures.tilt) + "; " + lift_words(model, cures.lift);
}

}  // namespace gouge
