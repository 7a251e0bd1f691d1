#include "postproc/compare/setup_differences.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include "lib/base/number_text.h"
#include "postproc/report/report_text.h"

namespace gouge {
namespace {

// Returns the identities of the tools by their keys. Several tools may have one key, for example no number.
std::map<std::string, std::set<std::string>> tools_by_key(const StoredResult& result) {
  std::map<std::string, std::set<std::string>> tools;
  for (const ToolRecord& tool : result.record.tools) tools[tool.key].insert(tool.identity.value_or(""));
  return tools;
}

std::size_t count_accepted(const StoredResult& result) {
  return static_cast<std::size_t>(std::ranges::count_if(result.findings, [](const EventRecord& finding) {
    return finding.acceptance && finding.acceptance->is_accepted;
  }));
}

// Options that have sentences of their own.
constexpr std::array kOwnSentences = {"part", "fixture", "head", "place", "stl-units"};

bool has_own_sentence(const std::string& option) {
  return std::ranges::find(kOwnSentences, option) != kOwnSentences.end() ||
         std::ranges::find(kLawOptions, option) != kLawOptions.end();
}

std::string value_of(const OptionTexts& options, const std::string& name) {
  const auto found = std::ranges::find_if(options, [&](const auto& option) { return option.first == name; });
  return found == options.end() ? "not given" : listed(found->second);
}

// Adds the options that differ, in the order of the new run, then those of the old run alone.
void add_options(const OptionTexts& before, const OptionTexts& after, std::vector<std::string>& all) {
  std::set<std::string> seen;
  for (const OptionTexts* options : {&after, &before}) {
    for (const auto& [name, texts] : *options) {
      if (has_own_sentence(name) || !seen.insert(name).second) continue;
      const std::string old = value_of(before, name), now = value_of(after, name);
      if (old != now) all.push_back("--" + name + " is " + now + ", " + old + " before");
    }
  }
}

}  // namespace

std::vector<std::string> setup_differences(const StoredResult& before, const StoredResult& after) {
  std::vector<std::string> all;
  for (const auto& [role, words] : {std::pair("part", "the parts are"),
                                    {"fixture", "the fixtures are"},
                                    {"head", "the heads are"},
                                    {"stock", "the files of the stock are"},
                                    {"before", "the programs before this one are"},
                                    {"before-tools", "the tools of the programs before this one are"}}) {
    const std::string old = before.contents_of(role), now = after.contents_of(role);
    const bool has_option = std::string_view(role).starts_with("before") || role == std::string_view("stock");
    if (old != now && !(has_option && (old.empty() || now.empty()))) all.push_back(std::string(words) + " other files");
  }
  if (before.record.placement != after.record.placement)
    all.push_back("the STL files are placed elsewhere, or in another unit");
  const auto then = tools_by_key(before), now = tools_by_key(after);
  for (const auto& [key, identities] : then) {
    const auto same = now.find(key);
    if (same != now.end() && same->second != identities)
      all.push_back(stored_tool_label(key) + " has other dimensions");
  }
  const auto lengths = [&](const char* what, double a_mm, double b_mm) {
    if (a_mm < b_mm || a_mm > b_mm)
      all.push_back(std::string(what) + " is " + length_text(b_mm, after.record.unit) + ", " +
                    length_text(a_mm, after.record.unit) + " before");
  };
  const StoredOptions &a = before.options, &b = after.options;
  lengths("the tolerance", a.tolerance_mm, b.tolerance_mm);
  lengths("the resolution", a.resolution_mm, b.resolution_mm);
  lengths("the stock to leave", a.stock_to_leave_mm, b.stock_to_leave_mm);
  lengths("the shank's clearance", a.shank_clearance_mm, b.shank_clearance_mm);
  lengths("the holder's clearance", a.holder_clearance_mm, b.holder_clearance_mm);
  lengths("the near-miss distance", before.record.options.near_miss_mm, after.record.options.near_miss_mm);
  add_options(before.record.options.more, after.record.options.more, all);
  if (a.limits != b.limits) all.push_back("the limits of single files are others");
  if (a.law != b.law) all.push_back("the machine, or its law of motion, is another one");
  if (a.rapid != b.rapid) all.push_back("rapids are checked as " + b.rapid + ", " + a.rapid + " before");
  if (const auto accepted = count_accepted(after), old = count_accepted(before); accepted != old)
    all.push_back(std::to_string(accepted) + " of the findings accepted, " + std::to_string(old) + " before");
  if (const std::size_t moves = after.record.toolpath.moves, old = before.record.toolpath.moves; moves != old)
    all.push_back("the toolpath has " + count_text(moves, "move") + ", " + std::to_string(old) + " before");
  if (before.record.program.version != after.record.program.version)
    all.push_back("gougecheck " + after.record.program.version + ", " + before.record.program.version + " before");
  return all;
}

}  // namespace gouge
