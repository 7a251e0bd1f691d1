#include "postproc/accept/review_data.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "lib/base/printable_text.h"
#include "lib/base/sha256.h"
#include "postproc/accept/accepted.h"

namespace gouge {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMaxResultBytes = 24'000'000;  // of a result whose findings the page can export
constexpr std::size_t kMaxEntryBytes = 3'000'000;    // of all entries in the page

// Returns the pieces of an entry around the words of the reviewer: `by`, `date` and `reason`, in this order.
Json pieces_of(const Acceptance& acceptance) {
  std::array<std::string, 4> pieces;
  std::size_t piece = 0;
  pieces[0] = "{";
  const nlohmann::json entry = nlohmann::json::parse(write_entry(acceptance));
  for (const auto& [key, value] : entry.items()) {
    if (key == "seal") continue;
    pieces[piece] += (pieces[piece] == "{" ? "\"" : ",\"") + key + "\":";
    if (key == "by" || key == "date" || key == "reason") {
      ++piece;
    } else {
      pieces[piece] += value.dump();
    }
  }
  pieces[3] += "}";
  return pieces;
}

// Returns an entry for each finding that can be accepted, and the reason for each that cannot.
Json entries_of(const StoredResult& result) {
  Json entries = Json::object();
  std::size_t bytes = 0;
  std::vector<std::size_t> numbers;
  for (const EventRecord& finding : result.findings) numbers.push_back(*finding.number);
  std::ranges::sort(numbers);
  const AcceptanceNote note{"?", "?", "?"};
  for (const std::size_t number : numbers) {
    const Result<Acceptance> made = accept_finding(result, number, note);
    Json entry = made ? pieces_of(*made) : Json{{"no", valid_utf8(made.error().message)}};
    bytes += entry.dump().size();
    if (bytes > kMaxEntryBytes) break;
    entries[std::to_string(number)] = std::move(entry);
  }
  return entries;
}

// Returns JSON that ends no script element. The sign < stands only in its texts.
std::string for_script(const Json& json) {
  std::string text;
  for (const char c : json.dump()) text += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return text;
}

}  // namespace

std::string review_data(const ReportModel& model, const std::string& name, std::string_view result) {
  if (model.result->events.empty()) return {};
  Json entries = Json::object();
  if (result.size() <= kMaxResultBytes) {
    if (const Result<StoredResult> stored = read_result(name, result)) entries = entries_of(*stored);
  }
  Json kept = Json::array();
  for (const BaselineEntry& entry : model.baseline.entries) kept.push_back(entry.text);
  return for_script({{"key", "gougecheck:" + sha256_of(result)},
                     {"reviewer", valid_utf8(model.sign_off.reviewer)},
                     {"program", {{"name", kProgramName}, {"version", kProgramVersion}}},
                     {"command", valid_utf8("gougecheck accept " + name)},
                     {"kept", std::move(kept)},
                     {"entries", std::move(entries)}});
}

}  // namespace gouge
