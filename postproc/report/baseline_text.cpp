#include "postproc/report/baseline_text.h"

#include <algorithm>

#include "lib/base/number_text.h"
#include "lib/base/printable_text.h"

namespace gouge {

std::string accepted_words(const ReportModel& model) {
  return count_text(model.baseline.accepted_findings(), "accepted gouge");
}

std::vector<std::string> acceptance_remarks(const ReportModel& model, std::size_t event) {
  std::vector<std::string> remarks;
  if (event >= model.baseline.events.size()) return remarks;
  const EventAcceptance& acceptance = model.baseline.events[event];
  if (!acceptance.why_not.empty()) remarks.push_back("not accepted: " + acceptance.why_not);
  if (!acceptance.is_accepted) return remarks;
  for (const std::size_t k : acceptance.entries) {
    const BaselineEntry& entry = model.baseline.entries[k];
    remarks.push_back("accepted by " + entry.by + (entry.date.empty() ? "" : " on " + entry.date) + ": " +
                      entry.reason);
  }
  return remarks;
}

std::string baseline_counts(const ReportModel& model) {
  if (!model.baseline.is_given()) return {};
  const auto count = [&](BaselineEntry::Use use) {
    return std::to_string(std::ranges::count(model.baseline.entries, use, &BaselineEntry::use));
  };
  return count(BaselineEntry::Use::applied) + " applied, " + count(BaselineEntry::Use::unused) +
         " with nothing left to accept, " + count(BaselineEntry::Use::voided) + " void";
}

std::string baseline_lines(const ReportModel& model) {
  if (!model.baseline.is_given()) return {};
  std::string text = printable("acceptances of " + model.baseline.file + ": " + baseline_counts(model)) + "\n";
  for (const BaselineEntry& entry : model.baseline.entries) {
    if (entry.use == BaselineEntry::Use::voided) text += printable("void: " + entry.finding + ": " + entry.why) + "\n";
  }
  return text;
}

}  // namespace gouge
