#include "postproc/cldata/parsing/feed_statement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include "lib/base/units.h"
#include "postproc/cldata/language/text.h"

namespace gouge {
namespace {

using Arguments = std::span<const Argument>;

constexpr Feed kNotUnderstood = {0, FeedUnit::not_understood};
constexpr double kFoot = 12;  // inches

struct UnitWord {
  std::string_view word;
  FeedUnit unit;
  double mm;  // length of the unit in mm; 0: the file's unit of length
};

constexpr double kInch_mm = mm_per(LengthUnit::inch);

constexpr std::array<UnitWord, 10> kUnits = {{{"MMPM", FeedUnit::per_minute, 1},
                                              {"MMPR", FeedUnit::per_revolution, 1},
                                              {"IPM", FeedUnit::per_minute, kInch_mm},
                                              {"IPR", FeedUnit::per_revolution, kInch_mm},
                                              {"FPM", FeedUnit::per_minute, kFoot* kInch_mm},
                                              {"FPR", FeedUnit::per_revolution, kFoot* kInch_mm},
                                              {"PERMIN", FeedUnit::per_minute, 0},
                                              {"PERREV", FeedUnit::per_revolution, 0},
                                              {"INVERS", FeedUnit::not_understood, 0},
                                              {"TPI", FeedUnit::not_understood, 0}}};

const UnitWord* feed_unit_called(std::string_view word) {
  const auto* const it =
      std::ranges::find_if(kUnits, [&](const UnitWord& u) { return equals_ignoring_case(word, u.word); });
  return it == kUnits.end() ? nullptr : it;
}

Feed feed_of(double number, const UnitWord& unit, double mm_per_unit) {
  const double mm = number * (unit.mm > 0 ? unit.mm : mm_per_unit);
  if (unit.unit == FeedUnit::not_understood || !(mm > 0) || !std::isfinite(mm)) return kNotUnderstood;
  return {mm, unit.unit};
}

// Returns the place of the only unit word; nothing if there is none, the end if there are several.
std::optional<std::size_t> find_unit_word(Arguments arguments) {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (feed_unit_called(arguments[i].text) == nullptr) continue;
    if (found) return arguments.size();
    found = i;
  }
  return found;
}

}  // namespace

Feed read_feed(Arguments arguments, double mm_per_unit) {
  const auto is_number = [](const Argument& a) { return a.number.has_value(); };
  if (count_numbers(arguments).count != 1) return kNotUnderstood;
  const double number = *std::ranges::find_if(arguments, is_number)->number;
  const std::optional<std::size_t> at = find_unit_word(arguments);
  if (at == arguments.size()) return kNotUnderstood;
  return feed_of(number, at ? *feed_unit_called(arguments[*at].text) : UnitWord{"", FeedUnit::per_minute, 0},
                 mm_per_unit);
}

bool switches_inverse_time(Arguments arguments) {
  return has_argument(arguments, "INVERS") && count_numbers(arguments).count == 0;
}

bool has_feed_unit(Arguments arguments) {
  return std::ranges::any_of(arguments, [](const Argument& a) { return feed_unit_called(a.text) != nullptr; });
}

Feed read_cycle_feed(Arguments arguments, double mm_per_unit) {
  const std::optional<std::size_t> at = find_unit_word(arguments);
  if (!at) return has_argument(arguments, "FEDRAT") ? kNotUnderstood : Feed{};
  if (*at + 1 >= arguments.size() || !arguments[*at + 1].number) return kNotUnderstood;
  return feed_of(*arguments[*at + 1].number, *feed_unit_called(arguments[*at].text), mm_per_unit);
}

}  // namespace gouge
