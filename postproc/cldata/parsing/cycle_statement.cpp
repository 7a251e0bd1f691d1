#include "postproc/cldata/parsing/cycle_statement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>

#include "postproc/cldata/language/text.h"
#include "postproc/cldata/parsing/feed_statement.h"

namespace gouge {
namespace {

constexpr double kFarthest_mm = 1e6;

using Arguments = std::span<const Argument>;

// Cycles in which the tool goes straight down and straight up again.
constexpr std::array<std::string_view, 14> kStraight = {"DRILL", "DEEP",  "DEEP2", "BRKCHP", "CHIPBRK",
                                                        "TAP",   "RTAP",  "LTAP",  "RIGID",  "REAM",
                                                        "BORE",  "CSINK", "FACE",  "CBORE"};
// Cycles in which the tool comes up while the spindle is reversed, and cycles in which it may come up at the feed.
constexpr std::array<std::string_view, 4> kTapping = {"TAP", "RTAP", "LTAP", "RIGID"};
constexpr std::array<std::string_view, 5> kFedOut = {"REAM", "BORE", "BORE7", "BORE8", "CBORE"};
// Words that move the tool sideways, or reverse the sense of the heights.
constexpr std::array<std::string_view, 6> kSideways = {"ORIENT", "NODRAG", "BACK", "SHIFT", "MANUAL", "DIAMETR"};

constexpr std::array<std::string_view, 6> kHeightWords = {"FEDTO", "DEPTH", "RAPTO", "CLEAR", "RTRCTO", "RETURN"};
constexpr std::size_t kLongestWord = 24;

// Words that are followed by one number.
constexpr std::array<std::string_view, 11> kHeights = {"FEDTO", "DEPTH", "RAPTO", "CLEAR", "RTRCTO", "RETURN",
                                                       "MMPM",  "IPM",   "MMPR",  "IPR",   "PERMIN"};

std::optional<double> after_either(Arguments arguments, std::string_view first, std::string_view second) {
  const std::optional<double> value = number_after(arguments, first);
  return value ? value : number_after(arguments, second);
}

// A retract height. A word without a number also means a height, which is not stated: RTRCTO,AUTO of NX.
struct Retract {
  std::optional<double> height;
  bool is_known = true;
  bool has_number = false;  ///< a number other than 0 follows RTRCTO or RETURN
};

// Reads the retract height. A statement may have both words; `own` is the one whose number is read. The other one alone
// states only that there is a retract, not its height.
Retract read_retract(Arguments arguments, std::string_view own) {
  Retract retract;
  if (!own.empty()) retract.height = number_after(arguments, own);
  const bool is_named = has_argument(arguments, "RTRCTO") || has_argument(arguments, "RETURN");
  retract.is_known = retract.height.has_value() || !is_named;
  const std::optional<double> rtrcto = number_after(arguments, "RTRCTO"), back = number_after(arguments, "RETURN");
  if (rtrcto && back && std::abs(*rtrcto - *back) > 0) retract = {std::nullopt, false};
  retract.has_number = std::abs(rtrcto.value_or(0)) > 0 || std::abs(back.value_or(0)) > 0;
  return retract;
}

// Reads RETURN. RETURN,0 is the path to the retract plane, whose height Creo's statement does not have.
Retract read_return(Arguments arguments) {
  Retract retract = read_retract(arguments, "RETURN");
  if (retract.height && !(std::abs(*retract.height) > 0)) retract = {std::nullopt, false, retract.has_number};
  return retract;
}

DrillCycle make(double clearance, double bottom, const Retract& retract) {
  DrillCycle cycle;
  cycle.clearance_mm = clearance;
  cycle.bottom_mm = bottom;
  cycle.is_retract_known = retract.is_known;
  cycle.is_retract_left_open = !retract.is_known && !retract.has_number;
  cycle.is_retract_stated = retract.height.has_value() || !retract.is_known;
  cycle.retract_mm = retract.height.value_or(clearance);
  return cycle;
}

bool is_unit_of_feed(std::string_view word) {
  return is_one_of(word, std::array<std::string_view, 6>{"MMPM", "MMPR", "IPM", "IPR", "PERMIN", "PERREV"});
}

bool is_numbers_alone(Arguments arguments) {
  return std::ranges::all_of(arguments, [](const Argument& a) { return a.number.has_value(); });
}

// Returns whether a cycle goes down in steps, with one additional number for their depth.
bool is_pecking(Arguments arguments) {
  return is_one_of(arguments.front().text, std::array<std::string_view, 2>{"DEEP", "BRKCHP"}) && arguments.size() == 4;
}

// Returns whether the arguments have the fixed form of IBM and Creo: kind, depth, feed and its unit in either order,
// and the clearance. For a tap the pitch precedes the clearance; for pecks their depth follows it.
bool is_fixed_form(Arguments arguments) {
  constexpr std::size_t kFewest = 5;
  if (arguments.size() < kFewest || arguments.size() > kFewest + 1 || !arguments[1].number) return false;
  const bool is_unit_first = is_unit_of_feed(arguments[2].text) && arguments[3].number;
  const bool is_feed_first = arguments[2].number && is_unit_of_feed(arguments[3].text);
  if (!is_unit_first && !is_feed_first) return false;
  const std::string_view kind = arguments.front().text;
  const bool has_more = is_one_of(kind, kTapping) || is_one_of(kind, std::array<std::string_view, 2>{"DEEP", "BRKCHP"});
  return is_numbers_alone(arguments.subspan(4)) && (arguments.size() == kFewest || has_more);
}

// Returns whether an argument is the word of a height with a wrong letter, or joined to its number. Its height is lost.
bool is_damaged_height(const Argument& argument) {
  if (argument.number || argument.text.empty()) return false;
  std::string letters;
  for (const char c : argument.text.substr(0, kLongestWord)) {
    if (is_letter(c)) letters += c;
  }
  const bool is_run_in = letters.size() != argument.text.size();
  return std::ranges::any_of(kHeightWords, [&](std::string_view word) {
    return is_one_letter_off(letters, word) || (is_run_in && equals_ignoring_case(letters, word));
  });
}

bool has_both(Arguments arguments, std::string_view one, std::string_view other) {
  return has_argument(arguments, one) && has_argument(arguments, other);
}

// Returns whether a statement contradicts itself: two depths, two different clearances, a height with two numbers. It
// is then unknown which one counts.
bool contradicts_itself(CycleForm form, Arguments arguments) {
  if (has_repeated_word(arguments) || has_both(arguments, "FEDTO", "DEPTH") || has_both(arguments, "G98", "G99") ||
      has_argument(arguments, "OFF") || has_argument(arguments, "NOMORE")) {
    return true;
  }
  if (has_damaged_argument(arguments) || std::ranges::any_of(arguments, is_damaged_height)) return true;
  // In these forms, numbers are read by their place, or one by one.
  if (form == CycleForm::clt || form == CycleForm::ncl || form == CycleForm::unknown || is_fixed_form(arguments))
    return false;
  for (std::size_t i = 0; i + 2 < arguments.size(); ++i) {
    const bool is_height = is_one_of(arguments[i].text, kHeights);
    if (is_height && arguments[i + 1].number && arguments[i + 2].number) return true;
  }
  return false;
}

// A word of a cycle, with the minimum and maximum count of numbers after it.
struct CycleWord {
  std::string_view word;
  std::size_t least, most;
};

// Words that state only facts that are read, or details of feed, pecks and dwell. They do not change the path of the
// tool. THRU, TIP, TOP or OFFSET of other post-processors would move the bottom or the tool.
constexpr auto kCycleWords = std::to_array<CycleWord>(
    {{"FEDTO", 1, 1}, {"DEPTH", 1, 1}, {"RAPTO", 1, 1},   {"CLEAR", 1, 1},  {"RTRCTO", 0, 1},  {"RETURN", 0, 1},
     {"AUTO", 0, 0},  {"STEP", 0, 3},  {"1STPECK", 1, 1}, {"STPECK", 1, 1}, {"SUBPECK", 1, 1}, {"PECK", 1, 2},
     {"INCR", 1, 2},  {"DWELL", 0, 1}, {"REV", 0, 1},     {"FEDRAT", 0, 1}, {"MMPM", 0, 1},    {"IPM", 0, 1},
     {"MMPR", 0, 1},  {"IPR", 0, 1},   {"PERMIN", 0, 1},  {"PERREV", 0, 1}, {"TPI", 1, 1},     {"RPM", 0, 1},
     {"DRAG", 0, 0},  {"TIMES", 1, 1}, {"ON", 0, 0},      {"CSINK", 1, 1}});

// Words of CAMWorks CLT, in which the numbers after them have fixed places.
constexpr auto kCltWords = std::to_array<CycleWord>({{"G98", 1, 1},
                                                     {"G99", 1, 1},
                                                     {"PECKING", 1, 3},
                                                     {"MMPM", 3, 4},
                                                     {"IPM", 3, 4},
                                                     {"MMPR", 3, 4},
                                                     {"IPR", 3, 4},
                                                     {"DWELL", 1, 1}});

constexpr auto kNccsWords = std::to_array<CycleWord>({{"FEDTO", 1, 2},
                                                      {"RAPTO", 1, 1},
                                                      {"RTRCTO", 1, 2},
                                                      {"STEP", 1, 2},
                                                      {"DWELL", 1, 2},
                                                      {"IPM", 1, 2},
                                                      {"IPR", 1, 2},
                                                      {"MMPM", 1, 2},
                                                      {"MMPR", 1, 2},
                                                      {"TPI", 1, 2}});

std::span<const CycleWord> cycle_words(CycleForm form) {
  if (form == CycleForm::clt) return kCltWords;
  if (form == CycleForm::ncl) return kNccsWords;
  return kCycleWords;
}

// Returns how many numbers follow the word at `at`.
std::size_t numbers_after(Arguments arguments, std::size_t at) {
  std::size_t count = 0;
  while (at + 1 + count < arguments.size() && arguments[at + 1 + count].number) ++count;
  return count;
}

// Returns whether every word after the kind of cycle is known, with a possible count of numbers. A second kind may
// follow the first (DRILL,DEEP). The default table of CATIA writes its two numbers without words.
bool has_only_known_words(CycleForm form, Arguments arguments) {
  std::size_t at = 1;
  if (is_fixed_form(arguments)) return true;
  if (form == CycleForm::catia && arguments.size() > 1 && arguments[1].number)
    return arguments.size() == 3 || (is_pecking(arguments) && is_numbers_alone(arguments.subspan(1)));
  const std::span<const CycleWord> words = cycle_words(form);
  while (at < arguments.size()) {
    const std::size_t count = numbers_after(arguments, at);
    const bool is_kind = form != CycleForm::ncl && is_one_of(arguments[at].text, kStraight);
    const auto word = std::ranges::find_if(
        words, [&](const CycleWord& known) { return equals_ignoring_case(arguments[at].text, known.word); });
    if (word == words.end() ? !(is_kind && count == 0) : (count < word->least || count > word->most)) return false;
    at += 1 + count;
  }
  return true;
}

// Reads the fixed form. The depth is below the position, with either sign. The clearance is the last number, except the
// step of pecks.
std::optional<DrillCycle> read_fixed(Arguments arguments) {
  const bool is_tap = is_one_of(arguments.front().text, kTapping);
  const double clearance = is_tap ? *arguments.back().number : *arguments[4].number;
  if (clearance < 0) return std::nullopt;
  return make(clearance, -std::abs(*arguments[1].number), read_retract(arguments, {}));
}

// Reads the cycle of Autodesk's post: kind, depth, unit, feed, clearance, then words. Its kernel gives the bottom of
// the hole, and the clearance as a plane. The standard gives the top, and a height above it.
std::optional<DrillCycle> read_bounds(Arguments arguments) {
  constexpr std::size_t kFixed = 5;
  if (arguments.size() < kFixed || !arguments[1].number || !is_unit_of_feed(arguments[2].text)) return std::nullopt;
  if (!arguments[3].number || !arguments[4].number || *arguments[1].number < 0) return std::nullopt;
  const double depth = *arguments[1].number, clearance = *arguments[4].number;
  double lower = 0;
  for (std::size_t i = kFixed; i < arguments.size(); i += 2) {
    constexpr std::array<std::string_view, 5> kWithNumber = {"RAPTO", "DWELL", "STEP", "INCR", "TPI"};
    if (!is_one_of(arguments[i].text, kWithNumber) || i + 1 >= arguments.size() || !arguments[i + 1].number)
      return std::nullopt;
    if (equals_ignoring_case(arguments[i].text, "RAPTO")) lower = *arguments[i + 1].number;
  }
  if (clearance < 0 || lower < 0) return std::nullopt;
  DrillCycle cycle = make(depth + clearance + lower, -depth, {});
  cycle.is_bounding = true;
  cycle.is_retract_stated = true;
  cycle.levels_mm = {clearance, lower, depth + clearance, depth + lower, depth + clearance + lower};
  cycle.planes_mm = {clearance, clearance - lower};
  return cycle;
}

// Reads a cycle of NX. FEDTO is a height, negative below the position. RAPTO (or CLEAR in its place) and RTRCTO are
// heights above the position.
std::optional<DrillCycle> read_nx(Arguments arguments) {
  if (has_argument(arguments, "RAPTO") && has_argument(arguments, "CLEAR")) return std::nullopt;
  const std::optional<double> bottom = number_after(arguments, "FEDTO"), csink = number_after(arguments, "CSINK");
  const std::optional<double> clearance = after_either(arguments, "RAPTO", "CLEAR");
  if (!(bottom || csink) || (bottom && csink) || !clearance || (csink && !(*csink > 0))) return std::nullopt;
  DrillCycle cycle = make(*clearance, bottom.value_or(0), read_retract(arguments, "RTRCTO"));
  cycle.csink_mm = csink.value_or(0);
  return cycle;
}

// Reads a cycle whose FEDTO is a depth below the position. CAMplete omits a RAPTO of 0, and its CLEAR is not a height
// above the position.
std::optional<DrillCycle> read_depth_words(Arguments arguments, bool is_clearance_optional) {
  const std::optional<double> depth = number_after(arguments, "FEDTO");
  std::optional<double> clearance = number_after(arguments, "RAPTO");
  if (!has_argument(arguments, "RAPTO") && is_clearance_optional) clearance = 0;
  if (!depth || *depth < 0 || !clearance) return std::nullopt;
  return make(*clearance, -*depth, read_retract(arguments, "RTRCTO"));
}

// Reads a cycle of Creo: DEPTH below the position, CLEAR and RETURN above it.
std::optional<DrillCycle> read_creo(Arguments arguments) {
  const std::optional<double> depth = number_after(arguments, "DEPTH"), clearance = number_after(arguments, "CLEAR");
  if (!depth || *depth < 0 || !clearance) return std::nullopt;
  return make(*clearance, -*depth, read_return(arguments));
}

// Reads a cycle of CATIA. The default post table writes depth and clearance as the first two numbers; other tables
// write Creo's words.
std::optional<DrillCycle> read_catia(Arguments arguments) {
  if (has_argument(arguments, "DEPTH")) {
    return arguments[1].number ? std::nullopt : read_creo(arguments);
  }
  for (const std::string_view height : {"FEDTO", "RAPTO", "CLEAR"}) {
    if (has_argument(arguments, height)) return std::nullopt;  // the numbers state this height already
  }
  if (arguments.size() < 3 || !arguments[1].number || !arguments[2].number || *arguments[1].number < 0) {
    return std::nullopt;
  }
  return make(*arguments[2].number, -*arguments[1].number, read_retract(arguments, {}));
}

// Reads DRILL,G98,depth,...,MMPM,feed,clearance,retract. With G99 the tool stays at the clearance.
std::optional<DrillCycle> read_clt(Arguments arguments) {
  const bool is_g98 = has_argument(arguments, "G98");
  const std::optional<double> depth = after_either(arguments, "G98", "G99");
  for (std::size_t i = 0; i + 3 < arguments.size(); ++i) {
    if (!is_one_of(arguments[i].text, std::array<std::string_view, 4>{"MMPM", "IPM", "MMPR", "IPR"})) continue;
    if (!depth || *depth < 0 || !arguments[i + 2].number || !arguments[i + 3].number) return std::nullopt;
    const double clearance = *arguments[i + 2].number;
    return make(clearance, -*depth, {is_g98 ? *arguments[i + 3].number : clearance});
  }
  return std::nullopt;
}

// Reads a cycle of a file without a known dialect by its words. With either sense of FEDTO the bottom is below the
// position.
std::optional<DrillCycle> read_generic(Arguments arguments) {
  const std::optional<double> depth = after_either(arguments, "FEDTO", "DEPTH");
  const std::optional<double> clearance = after_either(arguments, "RAPTO", "CLEAR");
  if (!depth || !clearance) return std::nullopt;
  const std::optional<double> rapto = number_after(arguments, "RAPTO"), clear = number_after(arguments, "CLEAR");
  const bool has_rtrcto = has_argument(arguments, "RTRCTO");
  const Retract retract = has_rtrcto ? read_retract(arguments, "RTRCTO") : read_return(arguments);
  // ISO 4343 has both words. It does not matter which one begins the feed if the tool rises above both.
  const double highest = std::max(*clearance, clear.value_or(*clearance));
  const bool differ = rapto && clear && std::abs(*rapto - *clear) > 0;
  if (differ && !(retract.height && *retract.height >= highest)) return std::nullopt;
  return make(highest, -std::abs(*depth), retract);
}

// The cycles of NCCS in which the tool goes straight down and up, in the manner of its post-processor. BORE9 and SHIFT
// move sideways, and MILL stays below.
constexpr std::array<std::string_view, 10> kNccsStraight = {"DRILL", "FACE", "DEEP",  "THRU",  "TAP",
                                                            "REAM",  "BORE", "BORE7", "BORE8", "REVERS"};

// Reads a cycle of NCCS. FEDTO,depth is below the position. FEDTO,diameter,angle means the depth at which a tip with
// this angle makes a hole of this diameter. RAPTO and RTRCTO are heights above the position; an omitted RAPTO stays in
// force. In DEEP and THRU, RTRCTO is the height to which each peck returns, and the tool ends at the clearance.
std::optional<DrillCycle> read_nccs(Arguments arguments) {
  std::optional<double> depth = number_after(arguments, "FEDTO");
  const std::optional<double> clearance = number_after(arguments, "RAPTO");
  if (!depth || !clearance || *depth < 0) return std::nullopt;
  const auto* const word = std::find_if(arguments.data(), arguments.data() + arguments.size(),
                                        [](const Argument& a) { return equals_ignoring_case(a.text, "FEDTO"); });
  const auto at = static_cast<std::size_t>(word - arguments.data());
  if (numbers_after(arguments, at) == 2) {
    const double angle_deg = *arguments[at + 2].number;
    if (!(angle_deg > 0 && angle_deg < 180)) return std::nullopt;
    depth = *depth / 2 / std::tan(angle_deg / 2 * std::numbers::pi / 180);
  }
  const Retract retract = read_retract(arguments, "RTRCTO");
  const bool is_deep = equals_ignoring_case(arguments.front().text, "DEEP");
  const bool is_pecking = is_deep || equals_ignoring_case(arguments.front().text, "THRU");
  if (!is_pecking || !retract.height) return make(*clearance, -*depth, retract);
  const double highest = is_deep ? std::abs(number_after(arguments, "STEP").value_or(0)) : *clearance;
  if (*retract.height > highest) return std::nullopt;
  return make(*clearance, -*depth, {});
}

std::optional<DrillCycle> read_heights(CycleForm form, Arguments arguments) {
  const bool may_be_fixed = form == CycleForm::any || form == CycleForm::creo;
  if (is_fixed_form(arguments)) return may_be_fixed ? read_fixed(arguments) : std::nullopt;
  switch (form) {
    case CycleForm::any:
      return read_generic(arguments);
    case CycleForm::nx:
      return read_nx(arguments);
    case CycleForm::depths:
      return read_depth_words(arguments, false);
    case CycleForm::depths_without_rapto:
      return read_depth_words(arguments, true);
    case CycleForm::creo:
      return read_creo(arguments);
    case CycleForm::catia:
      return read_catia(arguments);
    case CycleForm::clt:
      return read_clt(arguments);
    case CycleForm::ncl:
      return read_nccs(arguments);
    case CycleForm::unknown:
      break;
  }
  return std::nullopt;
}

}  // namespace

std::optional<DrillCycle> read_cycle(CycleForm form, std::span<const Argument> arguments, double mm_per_unit) {
  if (arguments.empty()) return std::nullopt;
  const std::string_view type = arguments.front().text;
  if (form == CycleForm::ncl ? !is_one_of(type, kNccsStraight) : !is_one_of(type, kStraight)) return std::nullopt;
  for (const Argument& argument : arguments) {
    if (is_one_of(argument.text, kSideways)) return std::nullopt;
  }
  if (contradicts_itself(form, arguments)) return std::nullopt;
  const bool is_bounding = form == CycleForm::unknown;
  if (!is_bounding && !has_only_known_words(form, arguments)) return std::nullopt;
  std::optional<DrillCycle> cycle = is_bounding ? read_bounds(arguments) : read_heights(form, arguments);
  if (!cycle || (cycle->csink_mm > 0 && form != CycleForm::nx)) return std::nullopt;
  cycle->csink_mm *= mm_per_unit;
  for (double& mm : cycle->levels_mm) mm *= mm_per_unit;
  for (double& mm : cycle->planes_mm) mm *= mm_per_unit;
  cycle->feed = read_cycle_feed(arguments, mm_per_unit);
  cycle->is_tapping = is_one_of(type, kTapping) || has_argument(arguments, "TAP");
  cycle->is_fed_out = cycle->is_tapping || is_one_of(type, kFedOut);
  for (double* height : {&cycle->clearance_mm, &cycle->bottom_mm, &cycle->retract_mm}) {
    *height *= mm_per_unit;
    if (!(std::abs(*height) <= kFarthest_mm)) return std::nullopt;
  }
  // A retract below the clearance may be intended, or be a mistake.
  if (cycle->bottom_mm > cycle->clearance_mm || cycle->retract_mm < cycle->clearance_mm) return std::nullopt;
  return cycle;
}

}  // namespace gouge
