#include "postproc/report/baseline_text.h"

#include <algorithm>

#include "lib/base/number_text.h"
#include "lib/base/printable_text.h"

namespace gouge {

std::string accepted_words(const ReportModel& model) {
  return count_text(model.baseline.accepted_findings(), "accepted gouge");
}

namespace {

std::string words_of_other(const ReportModel& model, const BaselineEntry& entry) {
  if (!is_of_other_program(entry.toolpath, model.toolpath->file)) return {};
  return kThroughEntry + entry.toolpath + ", line " + std::to_string(entry.line);
}

}  // namespace

bool is_same_program(const std::string& accepted, const std::string& checked) {
  const auto ends_with = [](const std::string& longer, const std::string& name) {
    return longer == name || longer.ends_with("/" + name);
  };
  return ends_with(accepted, checked) || ends_with(checked, accepted);
}

bool is_of_other_program(const std::string& accepted, const std::string& checked) {
  return !accepted.empty() && !is_same_program(accepted, checked);
}

std::size_t accepted_through_others(const ReportModel& model) {
  return static_cast<std::size_t>(std::ranges::count_if(model.baseline.events, [&](const EventAcceptance& event) {
    return event.is_accepted && std::ranges::any_of(event.entries, [&](std::size_t entry) {
             return is_of_other_program(model.baseline.entries[entry].toolpath, model.toolpath->file);
           });
  }));
}

std::vector<std::string> acceptance_remarks(const ReportModel& model, std::size_t event) {
  std::vector<std::string> remarks;
  if (event >= model.baseline.events.size()) return remarks;
  const EventAcceptance& acceptance = model.baseline.events[event];
  if (!acceptance.why_not.empty()) remarks.push_back("not accepted: " + acceptance.why_not);
  if (!acceptance.is_accepted) return remarks;
  for (const std::size_t k : acceptance.entries) {
    const BaselineEntry& entry = model.baseline.entries[k];
    remarks.push_back("accepted by " + entry.by + (entry.date.empty() ? "" : " on " + entry.date) +
                      words_of_other(model, entry) + ": " + entry.reason);
  }
  return remarks;
}

std::string baseline_counts(const ReportModel& model) {
  if (!model.baseline.is_given()) return {};
  const auto count = [&](BaselineEntry::Use use) {
    return std::to_string(std::ranges::count(model.baseline.entries, use, &BaselineEntry::use));
  };
  const std::size_t others = accepted_through_others(model);
  const std::string through =
      others == 0 ? "" : "; " + count_text(others, "finding") + " accepted" + kThroughEntry + "another program";
  const std::string elsewhere = count(BaselineEntry::Use::elsewhere), partly = count(BaselineEntry::Use::partly);
  return count(BaselineEntry::Use::applied) + " applied, " + count(BaselineEntry::Use::unused) +
         " with nothing left to accept, " + count(BaselineEntry::Use::voided) + " void" +
         (partly == "0" ? "" : ", " + partly + " in part") +
         (elsewhere == "0" ? "" : ", " + elsewhere + " of other programs") + through;
}

std::string baseline_lines(const ReportModel& model) {
  if (!model.baseline.is_given()) return {};
  std::string text = printable("acceptances of " + model.baseline.file + ": " + baseline_counts(model)) + "\n";
  for (const BaselineEntry& entry : model.baseline.entries) {
    if (entry.use == BaselineEntry::Use::voided) text += printable("void: " + entry.finding + ": " + entry.why) + "\n";
    if (entry.use == BaselineEntry::Use::partly)
      text += printable("in part: " + entry.finding + ": " + entry.why) + "\n";
  }
  return text;
}

}  // namespace gouge
