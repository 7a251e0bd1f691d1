#include <algorithm>
#include <array>
#include <span>
#include <string_view>

#include "postproc/cldata/language/text.h"
#include "postproc/cldata/parsing/cycle_statement.h"

// CYCLE/ON of NX, which gives other values to some words of the last cycle.

namespace gouge {
namespace {

// The words of NX that have one value each: a number, or AUTO.
constexpr std::array<std::string_view, 14> kNxValues = {"FEDTO", "RAPTO", "CLEAR", "RTRCTO", "STEP", "DWELL", "MMPM",
                                                        "MMPR",  "IPM",   "IPR",   "CAM",    "INCR", "CSINK", "TPI"};

bool is_height_above(std::string_view word) {
  return equals_ignoring_case(word, "RAPTO") || equals_ignoring_case(word, "CLEAR");
}

bool is_feed_unit(std::string_view word) {
  return is_one_of(word, std::array<std::string_view, 5>{"MMPM", "MMPR", "IPM", "IPR", "TPI"});
}

// Returns whether a word replaces the other one.
bool replaces(std::string_view word, std::string_view other) {
  return equals_ignoring_case(word, other) || (is_height_above(word) && is_height_above(other)) ||
         (is_feed_unit(word) && is_feed_unit(other));
}

}  // namespace

std::optional<std::vector<Argument>> changed_cycle(std::span<const Argument> cycle, std::span<const Argument> changes) {
  std::vector<Argument> changed(cycle.begin(), cycle.end());
  for (std::size_t i = 0; i < changes.size(); i += 2) {
    const std::string_view word = changes[i].text;
    const bool has_value =
        i + 1 < changes.size() && (changes[i + 1].number || equals_ignoring_case(changes[i + 1].text, "AUTO"));
    if (!is_one_of(word, kNxValues) || !has_value) return std::nullopt;
    for (std::size_t before = 0; before < i; before += 2) {
      if (replaces(word, changes[before].text)) return std::nullopt;
    }
    const auto old = std::ranges::find_if(changed, [&](const Argument& a) { return replaces(word, a.text); });
    if (old != changed.end()) {
      const bool had_value =
          old + 1 != changed.end() && ((old + 1)->number || equals_ignoring_case((old + 1)->text, "AUTO"));
      changed.erase(old, old + (had_value ? 2 : 1));
    }
    changed.push_back(changes[i]);
    changed.push_back(changes[i + 1]);
  }
  return changed;
}

}  // namespace gouge
