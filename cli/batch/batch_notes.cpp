#include "cli/batch/batch_notes.h"

#include <algorithm>
#include <ostream>
#include <set>

#include "cli/terminal/print_diagnostics.h"
#include "lib/base/number_text.h"

namespace gouge {

void note_left_baseline(const std::vector<BatchJob>& jobs, const std::string& list, std::ostream& err) {
  const auto count = std::ranges::count_if(jobs, &BatchJob::leaves_baseline);
  if (count == 0) return;
  print(err, {make_note("jobs-baseline",
                        "\"baseline\" of the defaults does not hold for " +
                            count_text(static_cast<std::size_t>(count), "job") + " with the command correct",
                        list)});
}

void note_replaced(ResultStore& store, const BatchIdentity& identity, const std::string& folder, std::ostream& err) {
  const std::set<std::string> names(identity.names.begin(), identity.names.end());
  const auto replaced =
      std::ranges::count_if(store.stored(), [&](const StoredJob& job) { return !names.contains(job.name); });
  if (replaced == 0) return;
  print(err, {make_note("batch-replaced",
                        "holds the results of " + count_text(static_cast<std::size_t>(replaced), "other job") +
                            ", which this batch replaces",
                        folder)});
}

void note_running(const std::vector<std::string>& names, const std::string& folder, std::ostream& err) {
  constexpr std::size_t kMaxNames = 8;
  if (names.empty()) return;
  const std::size_t shown = std::min(names.size(), kMaxNames);
  std::string text = listed({names.begin(), names.begin() + static_cast<std::ptrdiff_t>(shown)}, " and ");
  if (names.size() > shown) text += " and " + std::to_string(names.size() - shown) + " more";
  print(err,
        {make_note("jobs-running",
                   "an earlier run ended while it ran " + text +
                       "; they run last, so that a job which ends the program does not keep the others from running",
                   folder)});
}

}  // namespace gouge
