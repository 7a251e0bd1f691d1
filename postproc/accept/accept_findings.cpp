#include "postproc/accept/accept_findings.h"

#include <algorithm>
#include <set>

#include "postproc/accept/apply_baseline.h"
#include "postproc/accept/checked_findings.h"

namespace gouge {
namespace {

std::vector<UnacceptedFinding> unaccepted_of(const StoredResult& result, const CheckedFindings& checked,
                                             const std::vector<std::size_t>& numbers,
                                             const std::vector<Acceptance>& accepted) {
  const BaselineFacts facts = apply_acceptances(accepted, checked);
  std::vector<UnacceptedFinding> all;
  for (std::size_t k = 0; k < result.findings.size(); ++k) {
    const std::size_t number = *result.findings[k].number;
    if (!facts.is_accepted(k) && std::ranges::binary_search(numbers, number))
      all.push_back({number, facts.events[k].why_not});
  }
  std::ranges::sort(all, {}, &UnacceptedFinding::number);
  return all;
}

// Returns whether the same entry is there already, which a file must not have twice.
bool is_there(const Acceptance& made, const std::vector<Acceptance>& accepted) {
  return std::ranges::any_of(accepted, [&](const Acceptance& other) {
    return other.finding == made.finding && other.toolpath == made.toolpath && write_entry(other) == write_entry(made);
  });
}

}  // namespace

AcceptedFindings accept_findings(const StoredResult& result, std::vector<std::size_t> numbers,
                                 const AcceptanceNote& note, const std::vector<Acceptance>& accepted) {
  std::ranges::sort(numbers);
  AcceptedFindings outcome;
  const CheckedFindings checked = checked_findings(result);
  std::vector<Acceptance> all = accepted;
  std::set<std::size_t> tried, refused;
  const auto refuse = [&](std::size_t number, const Diagnostic& error) {
    outcome.refused.push_back(error);
    refused.insert(number);
    tried.insert(number);
  };
  for (const std::size_t number : numbers) {
    if (std::ranges::find(result.findings, number, &EventRecord::number) != result.findings.end()) continue;
    refuse(number, accept_finding(result, number, note).error());
  }
  // A new entry counts first in its own line, which can take an entry from another finding. So the rest is judged again
  // until it needs no more entries.
  for (bool has_more = true; has_more;) {
    has_more = false;
    for (const UnacceptedFinding& open : unaccepted_of(result, checked, numbers, all)) {
      if (!tried.insert(open.number).second) continue;
      has_more = true;
      Result<Acceptance> made = accept_finding(result, open.number, note);
      if (!made) {
        refuse(open.number, made.error());
      } else if (!is_there(*made, all)) {
        all.push_back(std::move(*made));
      }
    }
  }
  outcome.made.assign(all.begin() + static_cast<std::ptrdiff_t>(accepted.size()), all.end());
  for (const std::size_t number : numbers) {
    if (!refused.contains(number)) outcome.kept.push_back(number);
    if (!tried.contains(number)) outcome.known.push_back(number);
  }
  return outcome;
}

std::vector<UnacceptedFinding> find_unaccepted(const StoredResult& result, const std::vector<std::size_t>& numbers,
                                               const std::vector<Acceptance>& accepted) {
  return unaccepted_of(result, checked_findings(result), numbers, accepted);
}

}  // namespace gouge
