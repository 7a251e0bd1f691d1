#include "postproc/compare/compare_results.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "postproc/compare/judge_absence.h"
#include "postproc/compare/judge_finding.h"
#include "postproc/compare/match_findings.h"
#include "postproc/compare/setup_differences.h"
#include "postproc/result/stored_result.h"

namespace gouge {
namespace {

// Returns the facts that are open in the new run and not in the old one, a sentence each.
std::vector<std::string> newly_open_facts(const StoredResult& before, const StoredResult& after) {
  std::vector<std::string> all;
  for (const Assumption& fact : after.record.assumptions) {
    const auto was_open = [&](const Assumption& then) {
      return then.is_open && then.subject == fact.subject && then.object == fact.object;
    };
    if (!fact.is_open || std::ranges::any_of(before.record.assumptions, was_open)) continue;
    all.push_back("not established any more: " + std::string(subject_name(fact.subject)) +
                  (fact.object.empty() ? "" : " " + fact.object) + " (" + basis_name(fact.basis) +
                  "): " + fact.evidence);
  }
  return all;
}

class Comparer {
 public:
  Comparer(const StoredResult& before, const StoredResult& after, const CompareOptions& options)
      : before_(before),
        after_(after),
        options_(options),
        motions_(align_motions(before.record.motion_list(), after.record.motion_list())) {}

  Comparison run() {
    Comparison made;
    made.before = &before_;
    made.after = &after_;
    const auto matched = match_findings(before_, after_, motions_);
    std::vector<bool> is_matched(before_.findings.size(), false);
    for (std::size_t n = 0; n < matched.size(); ++n) {
      made.findings.push_back(judge_finding(before_, after_, motions_, options_, n, matched[n]));
      for (const std::size_t k : matched[n])
        if (is_alike(before_.findings[k], after_.findings[n])) is_matched[k] = true;
    }
    for (std::size_t k = 0; k < before_.findings.size(); ++k) {
      if (is_matched[k]) continue;
      const auto why = why_not_gone(before_, after_, motions_, before_.findings[k]);
      made.findings.push_back({why ? Change::not_checked : Change::gone, {k}, {}, why.value_or("")});
    }
    made.differences = setup_differences(before_, after_);
    std::size_t open = 0;
    for (const MoveRecord& move : after_.record.moves)
      open += move.state == MoveState::not_checked || move.state == MoveState::not_certified ? 1U : 0U;
    made.open_moves = open - std::min(open, after_.record.totals.left_out_as_asked);
    made.open_facts = newly_open_facts(before_, after_);
    made.excess = compare_excess(before_, after_, options_.same_within_mm);
    return made;
  }

 private:
  const StoredResult& before_;
  const StoredResult& after_;
  const CompareOptions& options_;
  MotionAlignment motions_;
};

}  // namespace

const char* change_name(Change change) {
  static constexpr std::array<const char*, kChanges> kNames = {"new",  "deeper",    "not-checked-any-more",
                                                               "gone", "shallower", "same"};
  return kNames.at(static_cast<std::size_t>(change));
}

std::size_t Comparison::count(Change change) const {
  return static_cast<std::size_t>(
      std::ranges::count_if(findings, [&](const ComparedFinding& one) { return one.change == change; }));
}

ExitCode Comparison::exit_status() const {
  const auto has = [&](Change change) { return count(change) > 0 || (excess && excess->change == change); };
  if (has(Change::fresh) || has(Change::deeper)) return kExitGouges;
  return has(Change::not_checked) || open_moves + open_facts.size() > 0 ? kExitNotChecked : kExitClean;
}

Comparison compare_results(const StoredResult& before, const StoredResult& after, const CompareOptions& options) {
  return Comparer(before, after, options).run();
}

}  // namespace gouge
