#include "postproc/report/remedies.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "lib/base/number_text.h"
#include "postproc/cldata/interpreting/reasons.h"

namespace gouge {
namespace {

struct Remedy {
  bool (*settles)(const Reason& reason);
  const char* option;
  const char* claim;
};

constexpr std::array<Remedy, 4> kRemedies = {{
    {[](const Reason& reason) {
       return reason.is(Reason::Kind::of_path) && kind_of(reason.detail) == ReasonKind::compensated;
     },
     "--cutcom centre", "it states that positions under CUTCOM are the cutter's centre"},
    {[](const Reason& reason) {
       return reason.is(Reason::Kind::of_path) && kind_of(reason.detail) == ReasonKind::around_hole;
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

}  // namespace gouge
