#include "cli/commands/acceptor.h"

#include <ostream>
#include <string>
#include <utility>

#include "lib/base/number_text.h"
#include "lib/base/printable_text.h"

namespace gouge {

Acceptor::Acceptor(AcceptanceNote note, std::vector<Acceptance> existing)
    : note_(std::move(note)), existing_(std::move(existing)), entries_(existing_) {}

Outcome Acceptor::accept_named(const std::vector<std::size_t>& numbers, const StoredResult& result) {
  if (numbers.empty()) return Done{};
  AcceptedFindings found = accept_findings(result, numbers, note_, entries_);
  if (!found.refused.empty()) return found.refused.front();
  const std::vector<UnacceptedFinding> same = find_unaccepted(result, found.known, existing_);
  for (std::size_t k = 0; k < found.known.size(); ++k) {
    if (k < same.size() && same[k].number == found.known[k]) continue;
    return make_error("accept-twice",
                      "finding " + std::to_string(found.known[k]) +
                          " has only motions that are accepted already; expected one that is not accepted",
                      result.file);
  }
  take(result, std::move(found));
  return Done{};
}

void Acceptor::accept_all(const StoredResult& result) {
  std::vector<std::size_t> numbers;
  for (const EventRecord& finding : result.findings) numbers.push_back(*finding.number);
  take(result, accept_findings(result, std::move(numbers), note_, entries_));
}

void Acceptor::take(const StoredResult& result, AcceptedFindings found) {
  const std::size_t same = has_new() ? find_unaccepted(result, found.known, existing_).size() : 0;
  same_ += same;
  known_ += found.known.size() - same;
  entries_.insert(entries_.end(), std::make_move_iterator(found.made.begin()),
                  std::make_move_iterator(found.made.end()));
  refused_.insert(refused_.end(), found.refused.begin(), found.refused.end());
  taken_.push_back({&result, std::move(found.kept)});
}

void Acceptor::test_outcome() {
  for (const Taken& taken : taken_) {
    for (const UnacceptedFinding& open : find_unaccepted(*taken.result, taken.kept, entries_))
      refused_.push_back(make_error("accept-impossible",
                                    "finding " + std::to_string(open.number) + " is still not accepted" +
                                        (open.why.empty() ? "" : ": " + open.why) + "; it stays a gouge",
                                    taken.result->file));
  }
}

void Acceptor::tell(std::ostream& out) const {
  for (std::size_t k = existing_.size(); k < entries_.size(); ++k) {
    const Acceptance& made = entries_[k];
    out << printable("accepted: " + made.toolpath + ":" + std::to_string(made.line) + ": " + made.finding) << "\n";
  }
  if (same_ > 0)
    out << count_text(same_, "finding") << (same_ == 1 ? " has" : " have")
        << " the motions of these, so the new entries accept " << (same_ == 1 ? "it" : "them") << " too\n";
  if (known_ > 0) out << count_text(known_, "finding") << " accepted before\n";
  if (!has_new() && same_ + known_ == 0 && refused_.empty()) out << "nothing to accept\n";
}

}  // namespace gouge
