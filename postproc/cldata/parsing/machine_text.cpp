#include "postproc/cldata/parsing/machine_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "lib/base/number_text.h"
#include "postproc/cldata/language/text.h"
#include "postproc/cldata/parsing/machine_tokens.h"

namespace gouge {
namespace {

using Token = MachineToken;
using Tokens = std::span<const Token>;

bool is(const Token& token, std::string_view word) { return equals_ignoring_case(token.letters, word); }

bool is_word_of(const Token& token, std::string_view letters) {
  return token.letters.size() == 1 && token.number &&
         letters.find(static_cast<char>(token.letters[0] & ~0x20)) != std::string_view::npos;
}

bool is_linear_axis(const Token& t) {
  const bool is_step = t.letters.size() == 2 && (t.letters[0] == 'I' || t.letters[0] == 'i') && t.number;  // Heidenhain
  return is_word_of(is_step ? Token{t.letters.substr(1), t.number} : t, "XYZUVW");
}

bool turns_something(const Token& t) {
  const bool is_step = t.letters.size() == 2 && (t.letters[0] == 'I' || t.letters[0] == 'i');
  return is_word_of(is_step ? Token{t.letters.substr(1), t.number} : t, "ABC") && std::abs(*t.number) > 0;
}

bool has_position(Tokens tokens) {
  return std::ranges::any_of(tokens, [](const Token& t) {
    return is_linear_axis(t) || is_word_of(t, "ABCIJK") || turns_something(t) ||
           (t.number && (is(t, "PR") || is(t, "PA")));
  });
}

void move(Tokens tokens, MachineEffect& effect) {
  effect.moves = true;
  effect.shifts = effect.shifts || std::ranges::any_of(tokens, turns_something);
}

// Words that may stand in a block beside its addresses.
constexpr std::array<std::string_view, 8> kBesideAddresses = {"FMAX", "F", "MAX", "RL", "RR", "AUTO", "FAUTO", "DR"};

// A block of addresses, and nothing that makes it a sentence.
bool is_block(Tokens tokens) {
  return std::ranges::all_of(tokens, [](const Token& t) {
    const bool is_address = !t.letters.empty() && t.letters.size() <= 2 && t.number;
    return is_address || (t.letters.size() == 1 && !t.number) || is_one_of(t.letters, kBesideAddresses);
  });
}

// Heidenhain: "L Z-50 FMAX", "CC X+0 Y+0", "APPR LCT X+10".
bool take_path_word(Tokens tokens, MachineEffect& effect) {
  constexpr std::array<std::string_view, 14> kPathWords = {"L",  "C",   "CC",  "CR", "CT", "CP",  "LP",
                                                           "LN", "CTP", "RND", "FL", "FC", "FLT", "FCT"};
  const Token& first = tokens.front();
  const Tokens rest = tokens.subspan(1);
  if ((is(first, "APPR") || is(first, "DEP")) && !rest.empty()) {
    move(rest, effect);
    return true;
  }
  if (first.number || !is_one_of(first.letters, kPathWords) || !is_block(rest)) return false;
  if (has_position(rest)) move(rest, effect);
  return true;
}

// What a call names: PGM and LBL of Heidenhain with theirs, else one word; more make a sentence (CALL THE OPERATOR
// NOW).
bool is_name_alone(Tokens tokens) {
  return tokens.empty() || is(tokens.front(), "PGM") || is(tokens.front(), "LBL") || tokens.size() == 1;
}

constexpr std::string_view kAddresses = "GMTDHXYZUVWABC";

// Behind the brackets or the value that belong to a word which does nothing.
std::string_view behind_arguments(std::string_view after) {
  if (after.starts_with('=')) {
    const std::string_view value = trim(after.substr(1));
    return trim(value.substr(std::min(value.find(' '), value.size())));
  }
  if (!after.starts_with('(')) return after;
  bool is_quoted = false;
  for (std::size_t i = 1; i < after.size(); ++i) {
    is_quoted = is_quoted != (after[i] == '"');
    if (after[i] == ')' && !is_quoted) return trim(after.substr(i + 1));
  }
  return {};
}

// What stands in a block behind such a word. A sentence may ("STOP FOR INSPECTION"); an address does something.
void take_rest(std::string_view rest, std::string_view addresses, MachineEffect& effect) {
  const std::vector<Token> tokens = machine_tokens(rest);
  const auto is_address = [&](const Token& t) { return t.is_glued && is_word_of(t, addresses); };
  effect.is_unknown = effect.is_unknown || std::ranges::any_of(tokens, is_address) ||
                      std::ranges::any_of(tokens, [](const Token& t) { return is(t, "CYCL") || is(t, "TRANS"); });
}

bool take_heidenhain(Tokens tokens, std::string_view text, MachineEffect& effect) {
  const Token& first = tokens.front();
  const Token second = tokens.size() > 1 ? tokens[1] : Token{};
  const double given = second.number.value_or(tokens.size() > 2 ? tokens[2].number.value_or(-1) : -1);
  const auto number = static_cast<int>(std::clamp(given, -1.0, 10000.0));
  if (is(first, "CYCL")) {
    constexpr std::array<int, 6> kShifting = {7, 8, 10, 11, 19, 26};
    constexpr std::array<int, 4> kHarmless = {9, 13, 32, 14};
    effect.chooses_offset = number == 247;
    effect.shifts = std::ranges::find(kShifting, number) != kShifting.end();
    const bool is_harmless = std::ranges::find(kHarmless, number) != kHarmless.end();
    effect.moves = is(second, "CALL") || (!effect.chooses_offset && !effect.shifts && !is_harmless);
    if ((effect.chooses_offset || is_harmless) && !second.letters.empty())
      take_rest(text.substr(static_cast<std::size_t>(second.letters.data() - text.data()) + second.letters.size()),
                "GMXYZ", effect);
    return true;
  }
  if (is(first, "PLANE") && !second.letters.empty()) {
    constexpr std::array<std::string_view, 8> kPlanes = {"SPATIAL", "PROJECTED", "EULER", "VECTOR",
                                                         "POINTS",  "RELATIVE",  "AXIAL", "RESET"};
    effect.shifts = is_one_of(second.letters, kPlanes);
    return effect.shifts;
  }
  if (is(first, "FUNCTION")) {
    effect.shifts = is(second, "RESET");
    return true;
  }
  if (is(first, "TOOL") && is(second, "CALL")) {
    effect.changes_tool = tokens.size() < 3 || !is(tokens[2], "S");
    return true;
  }
  if ((is(first, "CALL") && is_name_alone(tokens.subspan(1))) || (is(first, "SEL") && is(second, "PGM"))) {
    effect.moves = true;
    return true;
  }
  return is(first, "BLK") || is(first, "LBL") || (is(first, "TOOL") && is(second, "DEF"));
}

bool take_siemens(Tokens tokens, std::string_view text, MachineEffect& effect) {
  constexpr std::array<std::string_view, 22> kShifts = {
      "TRANS",   "ATRANS",   "ROT",    "AROT",   "ROTS",  "AROTS",   "CROTS", "SCALE",   "ASCALE",  "MIRROR", "AMIRROR",
      "TRAFOOF", "TRANSMIT", "TRACYL", "TRAANG", "TOROT", "TOFRAME", "PAROT", "TOROTOF", "PAROTOF", "RTRANS", "TRACON"};
  constexpr std::array<std::string_view, 6> kCycles = {"CYCLE", "POCKET", "SLOT", "HOLES", "LONGHOLE", "POSITION"};
  constexpr std::array<std::string_view, 29> kHarmless = {
      "TRAORI",  "MSG",     "STOPRE", "SOFT",   "BRISK",    "FFWON",     "FFWOF",  "ORIWKS", "ORIMKS", "ORIAXES",
      "ORIVECT", "COMPCAD", "COMPON", "COMPOF", "COMPCURV", "COMPSURF",  "UPATH",  "SPATH",  "CFC",    "CFTCP",
      "CFIN",    "FGROUP",  "SPOS",   "LIMS",   "SETMS",    "WORKPIECE", "DIAMOF", "STOP",   "NORM"};
  const Token& first = tokens.front();
  const Token second = tokens.size() > 1 ? tokens[1] : Token{};
  const std::string_view after =
      trim(text.substr(static_cast<std::size_t>(first.letters.data() - text.data()) + first.letters.size()));
  // Before other words ("ROT AND CLAMP THE PART") they begin a sentence.
  const bool is_sentence = second.letters.size() > 1 && !second.number && !is(second, "DATUM") && !is(second, "RPL");
  // Okuma's CALL and MODIN, Siemens's EXTCALL, PCALL and REPEAT: a subprogram, or blocks that stand elsewhere.
  constexpr std::array<std::string_view, 7> kCalls = {"CALL",  "EXTCALL", "ICALL",  "MODIN",
                                                      "PCALL", "REPEAT",  "REPEATB"};
  if (is_one_of(first.letters, kCalls) && !first.is_glued && tokens.size() <= 3) {
    effect.moves = true;
    return true;
  }
  if (is(first, "SUPA") && tokens.size() > 1 && !is_sentence) {
    effect.moves = true;
    return true;
  }
  if (is(first, "MCALL")) {
    (after.empty() ? effect.ends_cycle : effect.begins_cycle) = true;
    return true;
  }
  if (is(first, "CYCLE") && first.is_glued) {
    effect.shifts = std::abs(*first.number - 800) < 1;
    effect.moves = !effect.shifts && !(std::abs(*first.number - 832) < 1);
    if (!effect.moves)
      take_rest(behind_arguments(trim(after.substr(std::min(after.find_first_not_of("0123456789."), after.size())))),
                kAddresses, effect);
    return true;
  }
  if (is_one_of(first.letters, kShifts) && !first.is_glued && !is_sentence) {
    effect.shifts = true;
    return true;
  }
  if (is_one_of(first.letters, kCycles) && (first.is_glued || after.starts_with('('))) {
    effect.moves = true;
    return true;
  }
  if (!is_one_of(first.letters, kHarmless)) return false;
  const std::string_view rest = behind_arguments(after);
  take_rest(rest, kAddresses, effect);
  return effect.is_unknown || rest.size() < after.size() || after.empty();
}

enum class Code { harmless, length, path, moves, shifts, shifts_with_axes, begins_cycle, ends_cycle, offset, unknown };

struct CodeRange {
  int first, last;  // ten times the number of G
  Code code;
};

// What a number of G does on Fanuc, Haas, LinuxCNC and Siemens controls; of two meanings the one that
// matters.
constexpr auto kCodes = std::to_array<CodeRange>({
    {0, 30, Code::path},
    {40, 40, Code::harmless},
    {50, 63, Code::path},
    {70, 70, Code::shifts},
    {71, 71, Code::shifts},
    {80, 90, Code::harmless},
    {100, 100, Code::shifts},
    {110, 110, Code::harmless},
    {120, 120, Code::path},
    {121, 121, Code::shifts},
    {130, 130, Code::path},
    {131, 131, Code::harmless},
    {150, 150, Code::harmless},
    {160, 160, Code::shifts},
    {170, 190, Code::harmless},
    {200, 210, Code::harmless},
    {220, 260, Code::harmless},
    {270, 319, Code::moves},
    {320, 339, Code::path},
    {400, 400, Code::harmless},
    {401, 429, Code::shifts},
    {430, 449, Code::length},
    {490, 490, Code::length},
    {500, 500, Code::shifts_with_axes},
    {501, 501, Code::harmless},
    {510, 529, Code::shifts},
    {530, 531, Code::moves},
    {540, 541, Code::offset},
    {542, 542, Code::shifts},
    {550, 599, Code::offset},
    {600, 649, Code::harmless},
    {650, 650, Code::moves},
    {660, 661, Code::begins_cycle},
    {670, 670, Code::ends_cycle},
    {680, 689, Code::shifts},
    {690, 691, Code::harmless},
    {700, 710, Code::harmless},
    {730, 769, Code::begins_cycle},
    {800, 800, Code::ends_cycle},
    {810, 899, Code::begins_cycle},
    {900, 910, Code::harmless},
    {920, 929, Code::shifts_with_axes},
    {930, 990, Code::harmless},
    {1070, 1071, Code::shifts},
    {1120, 1120, Code::shifts},
    {1130, 1130, Code::harmless},
    {1530, 1530, Code::moves},
    {1540, 1549, Code::offset},
    {1870, 1870, Code::harmless},
    {2340, 2340, Code::length},
    {2540, 2540, Code::shifts},
    {2550, 2550, Code::harmless},
    {5000, 5000, Code::offset},
    {5050, 5990, Code::offset},
    {7000, 7100, Code::harmless},
});

Code code_of(double number) {
  const auto tenfold = static_cast<int>(std::lround(std::clamp(number, -1.0, 10000.0) * 10));
  for (const CodeRange& range : kCodes) {
    if (tenfold >= range.first && tenfold <= range.last) return range.code;
  }
  return Code::unknown;
}

void take_code(double number, Tokens tokens, MachineEffect& effect) {
  const bool has_axes = has_position(tokens);
  const auto is_code = [&](double code) { return std::abs(number - code) < 0.05; };
  if (is_code(20) || is_code(70) || is_code(700)) effect.unit = LengthUnit::inch;
  if (is_code(21) || is_code(71) || is_code(710)) effect.unit = LengthUnit::mm;
  if (is_code(91)) effect.begins_steps = true;
  if (is_code(90)) {
    effect.begins_steps = false;
    effect.ends_steps = true;
  }
  const Code code = code_of(number);
  if (code == Code::moves || (code == Code::path && has_axes)) move(tokens, effect);
  // G92 with an S alone limits the spindle's speed, G50 alone ends scaling.
  const auto has_no_speed = [&] {
    return std::ranges::none_of(tokens, [](const Token& t) { return is_word_of(t, "S"); });
  };
  const bool shifts_axes = code == Code::shifts_with_axes && (has_axes || (number > 90 && has_no_speed()));
  effect.shifts = effect.shifts || code == Code::shifts || shifts_axes;
  effect.changes_length = effect.changes_length || code == Code::length;
  effect.begins_cycle = effect.begins_cycle || code == Code::begins_cycle;
  effect.ends_cycle = effect.ends_cycle || code == Code::ends_cycle;
  effect.chooses_offset = effect.chooses_offset || code == Code::offset;
  effect.is_unknown = effect.is_unknown || code == Code::unknown;
}

// The numbers of axes beside these are no position to go to.
bool takes_axes(double number) {
  constexpr std::array<double, 12> kTakers = {4, 10, 51, 51.1, 52, 65, 66, 68, 68.2, 68.3, 92, 5.1};
  return std::ranges::any_of(kTakers, [&](double code) { return std::abs(number - code) < 0.05; });
}

void take_auxiliary(double number, MachineEffect& effect) {
  constexpr std::array<double, 6> kCalls = {89, 97, 98, 99, 140, 198};
  const auto is_code = [&](double code) { return std::abs(number - code) < 0.05; };
  effect.moves = effect.moves || std::ranges::any_of(kCalls, is_code);
  effect.shifts = effect.shifts || is_code(129);
  effect.changes_tool = effect.changes_tool || is_code(6);
}

// "MOVE THE CLAMP": words, not addresses, and no macro.
bool is_sentence(Tokens tokens) {
  constexpr std::array<std::string_view, 4> kJumps = {"GOTO", "GOTOF", "GOTOB", "WHILE"};
  if (is_one_of(tokens.front().letters, kJumps)) return false;
  const bool has_macro = std::ranges::any_of(tokens, [](const Token& t) {
    return t.other != '\0' && std::string_view("#[]=*<>{}$").find(t.other) != std::string_view::npos;
  });
  return !has_macro && tokens.size() > 1 && std::ranges::any_of(tokens, [](const Token& t) {
    return t.letters.size() > 1 && (!t.number || t.letters.size() > 2) && !is_one_of(t.letters, kBesideAddresses);
  });
}

// Where nothing else stands beside it the name of a subprogram, whose arguments in brackets look like a
// comment.
bool is_call(Tokens tokens) {
  const Token& first = tokens.front();
  return tokens.size() == 1 && (first.letters.size() > 2 || (is(first, "L") && first.is_glued));
}

void take_addresses(Tokens tokens, bool is_whole, MachineEffect& effect) {
  bool has_code = false, are_axes_taken = false;
  for (const Token& token : tokens) {
    if (!is_word_of(token, "G")) continue;
    has_code = true;
    are_axes_taken = are_axes_taken || takes_axes(*token.number);
    take_code(*token.number, tokens, effect);
  }
  for (const Token& token : tokens) {
    if (!is_word_of(token, "M")) continue;
    const bool is_call =
        token.is_glued && (std::abs(*token.number - 98) < 0.05 || std::abs(*token.number - 198) < 0.05);
    if (is_whole || is_call) take_auxiliary(*token.number, effect);
  }
  if (is_whole) {
    const bool has_axis =
        std::ranges::any_of(tokens, [](const Token& t) { return is_linear_axis(t) || is_word_of(t, "ABC"); });
    if (has_axis && !are_axes_taken) move(tokens, effect);
  }
  const bool is_odd = !is_whole || (!has_code && is_call(tokens));
  effect.is_unknown = effect.is_unknown || (is_odd && !is_sentence(tokens));
}

}  // namespace

MachineEffect read_machine_text(std::string_view text, bool may_be_name) {
  MachineEffect effect;
  text = trim(text);
  while (!text.empty() && (text.front() == '/' || text.front() == '%' || text.front() == '\'' || text.front() == '"'))
    text = trim(text.substr(1));
  while (!text.empty() && (text.back() == '\'' || text.back() == '%' || text.back() == '"'))
    text = trim(text.substr(0, text.size() - 1));
  const std::vector<Token> all = machine_tokens(text);
  Tokens tokens(all);
  const bool is_numbered = tokens.size() > 1 && (is_word_of(tokens.front(), "N") ||
                                                 (tokens.front().letters.empty() && tokens.front().number));
  if (is_numbered) tokens = tokens.subspan(1);
  if (tokens.empty()) return effect;
  if (take_path_word(tokens, effect) || take_heidenhain(tokens, text, effect) || take_siemens(tokens, text, effect))
    return effect;
  effect = {};
  const bool is_whole = is_block(tokens) && std::ranges::all_of(tokens, [&](const Token& t) {
                          return !may_be_name || t.is_glued || !t.number;
                        });
  if (is_whole || !may_be_name) take_addresses(tokens, is_whole, effect);
  // The number of a tool length or an offset, whichever code it belongs to.
  const bool has_offset = std::ranges::any_of(tokens, [](const Token& t) { return is_word_of(t, "DH"); });
  if (is_whole && !may_be_name && has_offset) effect.changes_length = true;
  if (may_be_name) effect.is_unknown = false;
  return effect;
}

}  // namespace gouge
