#include "cli/commands/chosen_findings.h"

#include <algorithm>
#include <limits>

#include "lib/base/number_text.h"

namespace gouge {
namespace {

/// Numbers of findings, from `first` to `last`.
struct NumberRange {
  std::uint32_t first = 0, last = 0;
};

std::optional<NumberRange> parse_range(const std::string& text) {
  constexpr std::int64_t kMost = 1'000'000;
  const std::size_t dash = text.find('-');
  const auto number = [](std::string_view typed) { return parse_integer(trim_blanks(typed)); };
  const auto first = number(std::string_view(text).substr(0, dash));
  const auto last = dash == std::string::npos ? first : number(std::string_view(text).substr(dash + 1));
  if (!first || !last || *first < 0 || *last < *first || *last - *first >= kMost ||
      *last > std::numeric_limits<std::uint32_t>::max() - 1)
    return std::nullopt;
  return NumberRange{static_cast<std::uint32_t>(*first), static_cast<std::uint32_t>(*last)};
}

}  // namespace

std::string ChosenFinding::text() const { return (job.empty() ? "" : job + ":") + std::to_string(number); }

std::optional<std::vector<ChosenFinding>> parse_findings(const std::string& text) {
  std::vector<ChosenFinding> findings;
  std::string job, item;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(',', at), text.size());
    item += text.substr(at, end - at);
    at = end + 1;
    const std::size_t colon = item.rfind(':');
    const std::optional<NumberRange> range = parse_range(colon == std::string::npos ? item : item.substr(colon + 1));
    if (!range && at <= text.size()) {
      item += ',';  // a comma in the name of a job
      continue;
    }
    if (!range || colon == 0) return std::nullopt;
    if (colon != std::string::npos) job = item.substr(0, colon);
    for (std::uint32_t number = range->first; number <= range->last; ++number) findings.push_back({job, number});
    item.clear();
  }
  return findings;
}

std::optional<Diagnostic> find_wrong_choice(const std::vector<ChosenFinding>& findings,
                                            const std::vector<ListedJob>& results) {
  for (const ChosenFinding& finding : findings) {
    if (finding.job.empty()) {
      if (results.size() == 1) continue;
      return make_error("usage",
                        "accept takes --finding for one result, as each result has its own numbers; expected JOB:" +
                            finding.text() + " for a job of a batch, one RESULT, or --all");
    }
    const auto count = std::ranges::count(results, finding.job, &ListedJob::name);
    if (count == 1) continue;
    const std::string found = count == 0 ? "there is no result of a job '" : "there are several results of a job '";
    return make_error("usage", "--finding " + finding.text() + ": " + found + finding.job +
                                   "'; expected the name of a job of one batch, as accept without --finding lists it");
  }
  return std::nullopt;
}

}  // namespace gouge
