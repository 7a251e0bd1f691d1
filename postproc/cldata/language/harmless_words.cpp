#include "postproc/cldata/language/harmless_words.h"

#include <algorithm>
#include <array>

#include "postproc/cldata/language/text.h"
#include "postproc/cldata/language/words.h"

namespace gouge {
namespace {

using Sign = HarmlessWord::Sign;
using Others = HarmlessWord::Others;

constexpr auto kHarmlessWords = std::to_array<HarmlessWord>({
    {"AIR", "ON OFF", 1, Sign::none, Others::none, "IBM, ICAM"},
    {"APPLY", "MILL", 0, Sign::none, Others::none, "DMG Mori"},
    {"ARCSLP", "ON OFF AUTO", 2, Sign::none, Others::none, "IBM, VERICUT"},
    {"AUTOPS", "", 0, Sign::none, Others::none, "Dassault"},
    {"BEGIN", "", 0, Sign::none, Others::none, "DMG Mori"},
    {"BOX", "", 6, Sign::any, Others::none, "NCCS"},
    {"BREAK", "ON OFF", 0, Sign::none, Others::none, "IBM, ICAM"},
    {"CHECK", "XAXIS YAXIS ZAXIS AAXIS BAXIS CAXIS LENGTH ON OFF TO", 6, Sign::any, Others::none, "IBM, VERICUT"},
    {"CLAMP", "ON OFF AUTO LOCK UNLOCK XAXIS YAXIS ZAXIS AAXIS BAXIS CAXIS", 1, Sign::none, Others::none,
     "IBM, ICAM, VERICUT"},
    {"CLEARP", "ON OFF XYPLAN YZPLAN ZXPLAN XAXIS YAXIS ZAXIS PLANE", 4, Sign::any, Others::none,
     "IBM, ICAM, Frenetec"},
    {"CLPRNT", "ON OFF", 0, Sign::none, Others::none, "APT, VERICUT"},
    {"CLRSRF", "ON OFF START XYPLAN YZPLAN ZXPLAN XAXIS YAXIS ZAXIS PLANE", 8, Sign::any, Others::none,
     "IBM, ICAM, Frenetec"},
    {"COOLNT",
     "ON OFF FLOOD MIST TAP TAPKUL THRU AIR TOOL SPINDL LOW MEDIUM MED HIGH AUTO ALL NOMORE BOTH FLOOD1 FLOOD2 CUSTOM1 CUSTOM2 CUSTOM3",
     2, Sign::none, Others::none, "PTC, ICAM, Autodesk, IBM"},
    {"CSI_PATH_TOLERANCE", "", 1, Sign::none, Others::none, "Autodesk"},
    {"CSI_SET_PATH_PARAM", "TOOL_BREAK=ON TOOL_BREAK=OFF CSI_FORCE_TOOL_CHANGE=1", 0, Sign::none, Others::none,
     "Autodesk"},
    {"DELAY", "DWELL REV REVS SEC SECONDS ON OFF", 2, Sign::none, Others::none, "PTC, IBM, Autodesk"},
    {"DISPLY", "ON OFF ALL AUTO", 2, Sign::none, Others::names, "IBM, ICAM, VERICUT"},
    {"DMIS", "ON OFF", 0, Sign::none, Others::none, "PTC"},
    {"DRAFT", "ON OFF", 0, Sign::none, Others::none, "IBM, VERICUT"},
    {"DWELL", "REV REVS SEC SECONDS ON OFF", 2, Sign::none, Others::none, "IBM, Frenetec"},
    {"FLUSH", "ON OFF", 1, Sign::none, Others::none, "PTC"},
    {"HOMEPT", "XAXIS YAXIS ZAXIS", 6, Sign::any, Others::none, "ICAM"},
    {"INTOL", "", 2, Sign::none, Others::none, "Dassault, VERICUT"},
    {"ISN", "", 2, Sign::none, Others::none, "VERICUT"},
    {"ISTOP", "", 0, Sign::none, Others::none, "IBM"},
    {"LEADER", "ON OFF CM FEET INCHES", 1, Sign::none, Others::none, "IBM, ICAM, VERICUT"},
    {"LIMIT", "XAXIS YAXIS ZAXIS AAXIS BAXIS CAXIS ON OFF TO", 6, Sign::any, Others::none, "ICAM"},
    {"LINTOL", "ON OFF AUTO ADJUST LENGTH", 2, Sign::none, Others::none, "IBM, ICAM, VERICUT"},
    {"LPRINT", "ON OFF", 0, Sign::none, Others::none, "IBM"},
    {"MACHIN", "ON CIRCUL LINEAR OPTION MILL", 6, Sign::none, Others::names, "SPost, PTC, ICAM, Autodesk"},
    {"MATERL", "TYPE", 8, Sign::any, Others::names, "CAMWorks, DMG Mori"},
    {"MAXDP", "ON OFF", 1, Sign::none, Others::none, "IBM"},
    {"MAXDPM", "ON OFF", 1, Sign::none, Others::none, "IBM"},
    {"MAXVEL", "ON OFF", 1, Sign::none, Others::none, "IBM"},
    {"MCHTOL", "", 2, Sign::none, Others::none, "IBM, VERICUT"},
    {"MOVE_ATTRIB", "LEADIN LEADOUT LINK END_ATTRIB", 0, Sign::none, Others::none, "DMG Mori"},
    {"NOPOST", "", 0, Sign::none, Others::none, "APT"},
    {"OPERATION", "END", 0, Sign::none, Others::none, "Autodesk"},
    {"OPSTOP", "", 0, Sign::none, Others::none, "IBM, ICAM, Autodesk"},
    {"OUTTOL", "", 2, Sign::none, Others::none, "Dassault, VERICUT"},
    {"PAINT", "COLOR SPEED PATH TOOL NOMORE FULL ARROW DASH SOLID", 2, Sign::none, Others::none, "Siemens, VERICUT"},
    {"PITCH", "", 1, Sign::none, Others::none, "IBM, VERICUT"},
    {"PLOT", "ON OFF", 2, Sign::none, Others::none, "IBM, VERICUT"},
    {"PPFUN", "OFF", 2, Sign::none, Others::required, "CAMWorks"},
    {"PPLOT", "ON OFF", 2, Sign::none, Others::none, "IBM, VERICUT"},
    {"PPTOL", "", 2, Sign::none, Others::none, "VERICUT"},
    {"PRINT", "ON OFF ALL", 1, Sign::none, Others::names, "APT"},
    {"REWIND", "ON OFF", 1, Sign::none, Others::none, "Dassault, IBM, VERICUT"},
    {"RTCP", "ON", 0, Sign::none, Others::required, "ICAM"},
    {"SELCTL", "TOOL NEXT", 2, Sign::none, Others::none, "IBM, VERICUT"},
    {"SEQNO", "ON OFF INCR START NEXT AUTO NOW NOMORE", 4, Sign::none, Others::none, "IBM, ICAM, VERICUT"},
    {"SET", "MODE ABSOL", 0, Sign::none, Others::required, "Siemens"},
    {"SLOWDN", "ON OFF", 2, Sign::none, Others::none, "IBM, VERICUT"},
    {"SPINDL",
     "ON OFF CLW CCLW RPM SFM SMM RANGE MAXRPM LOW MEDIUM HIGH MED LOCK ORIENT NEUTRL AUTO RADIUS MAIN MAX XAXIS YAXIS ZAXIS",
     3, Sign::one, Others::none, "Dassault, ICAM, Autodesk, IBM"},
    {"START", "OPERATION 'OPERATION'", 0, Sign::none, Others::required, "Autodesk"},
    {"STOP", "", 0, Sign::none, Others::none, "IBM, ICAM, Autodesk"},
    {"TCP", "ON", 0, Sign::none, Others::required, "ICAM"},
    {"TCPM", "ON", 0, Sign::none, Others::required, "Heidenhain"},
    {"TMARK", "ON OFF AUTO", 1, Sign::none, Others::none, "IBM, ICAM, VERICUT"},
    {"TOLER", "", 2, Sign::none, Others::none, "VERICUT"},
    {"UNCLMP", "ON OFF AUTO XAXIS YAXIS ZAXIS AAXIS BAXIS CAXIS", 1, Sign::none, Others::none, "ISO 4343"},
    {"UNLOAD", "TOOL ALL AUTO", 1, Sign::none, Others::none, "IBM, ICAM"},
});
static_assert(std::ranges::is_sorted(kHarmlessWords, {}, &HarmlessWord::word));

bool is_among(std::string_view word, std::string_view words) {
  while (!words.empty()) {
    const std::size_t end = std::min(words.find(' '), words.size());
    if (equals_ignoring_case(word, words.substr(0, end))) return true;
    words.remove_prefix(std::min(end + 1, words.size()));
  }
  return false;
}

// Returns whether a text can be a name: a word unknown in all dialects, of letters, digits and the marks of names.
bool is_name(std::string_view text) {
  constexpr std::string_view kMarks = "._-+'";
  const auto belongs = [&](char c) {
    return is_letter(c) || is_digit(c) || static_cast<unsigned char>(c) >= 0x80 || kMarks.find(c) != kMarks.npos;
  };
  return !text.empty() && std::ranges::all_of(text, belongs) && find_word(text) == Word::unknown &&
         !is_minor_word(text);
}

// Returns whether three numbers follow each other. They may be the position of a line whose line end was lost.
bool has_three_numbers_in_a_row(std::span<const Argument> arguments) {
  constexpr std::size_t kPosition = 3;
  std::size_t run = 0;
  return std::ranges::any_of(arguments, [&](const Argument& argument) {
    run = argument.number ? run + 1 : 0;
    return run >= kPosition;
  });
}

bool fits(const HarmlessWord& row, std::span<const Argument> arguments) {
  const NumberCount numbers = count_numbers(arguments);
  if (numbers.count > row.max_numbers) return false;
  const bool may_be_negative = row.sign == Sign::any || (row.sign == Sign::one && numbers.count == 1);
  if (numbers.negative > 0 && !may_be_negative) return false;
  if (row.sign != Sign::any && has_three_numbers_in_a_row(arguments)) return false;
  std::size_t names = 0;
  bool has_minor = false;
  for (const Argument& argument : arguments) {
    if (argument.number) continue;
    if (is_among(argument.text, row.minors)) {
      has_minor = true;
    } else if (row.others != Others::names || !is_name(argument.text) || ++names > kMaxNames) {
      return false;
    }
  }
  return has_minor || row.others != Others::required;
}

}  // namespace

std::span<const HarmlessWord> harmless_words() { return kHarmlessWords; }

const HarmlessWord* find_harmless_word(std::string_view word) {
  const auto is_before = [](std::string_view a, std::string_view b) { return compare_ignoring_case(a, b) < 0; };
  const auto* const row = std::ranges::lower_bound(kHarmlessWords, word, is_before, &HarmlessWord::word);
  return row == kHarmlessWords.end() || !equals_ignoring_case(row->word, word) ? nullptr : row;
}

bool is_harmless(std::string_view word, std::span<const Argument> arguments) {
  const HarmlessWord* const row = find_harmless_word(word);
  return row != nullptr && fits(*row, arguments);
}

bool hides_statement(std::span<const Argument> arguments) {
  return std::ranges::any_of(arguments, [](const Argument& argument) {
    if (argument.number) return false;
    const Word word = find_word(argument.text);
    return changes_motion(word) || word == Word::insert;
  });
}

}  // namespace gouge
