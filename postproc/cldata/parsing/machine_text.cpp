#include "postproc/cldata/parsing/machine_text.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "lib/base/number_text.h"
#include "postproc/cldata/language/text.h"
#include "postproc/cldata/parsing/control_list.h"
#include "postproc/cldata/parsing/machine_tokens.h"

namespace gouge {
namespace {

using Token = MachineToken;
using Tokens = std::span<const Token>;

bool is(const Token& token, std::string_view word) { return equals_ignoring_case(token.letters, word); }

// Returns whether a token is one letter with its number.
bool is_address(const Token& t) { return t.letters.size() == 1 && t.number.has_value(); }

bool is_address_of(const Token& t, std::string_view letters) {
  return is_address(t) && letters.find(static_cast<char>(t.letters[0] & ~0x20)) != std::string_view::npos;
}

// Returns the token without the I for a step: IX+5 of Heidenhain is a step along X.
Token without_step(const Token& t) {
  const bool is_step = t.letters.size() == 2 && (t.letters[0] == 'I' || t.letters[0] == 'i') && t.number;
  return is_step ? Token{t.letters.substr(1), t.number, t.is_glued, t.other} : t;
}

bool is_axis(const Token& t) { return is_address_of(without_step(t), "XYZUVWABC"); }

bool turns_something(const Token& t) { return is_address_of(without_step(t), "ABC") && std::abs(*t.number) > 0; }

void move(Tokens tokens, MachineEffect& effect) {
  effect.moves = true;
  effect.shifts = effect.shifts || std::ranges::any_of(tokens, turns_something);
}

void take_meaning(ControlMeaning meaning, Tokens tokens, bool has_axes, MachineEffect& effect) {
  using enum ControlMeaning;
  switch (meaning) {
    case harmless:
    case smooths:  // its values decide
      return;
    case length:
      effect.changes_length = true;
      return;
    case path:
      if (has_axes) move(tokens, effect);
      return;
    case moves:
      return move(tokens, effect);
    case shifts:
      effect.shifts = true;
      return;
    case shifts_with_axes: {
      // With only an S it limits the speed of the spindle.
      const bool has_speed = std::ranges::any_of(tokens, [](const Token& t) { return is_address_of(t, "S"); });
      effect.shifts = effect.shifts || has_axes || !has_speed;
      return;
    }
    case begins_cycle:
      effect.begins_cycle = true;
      return;
    case ends_cycle:
      effect.ends_cycle = true;
      return;
    case offset:  // its code or its values name the offset
      return;
    case begins_steps:
      effect.begins_steps = true;
      return;
    case ends_steps:
      effect.begins_steps = false;
      effect.ends_steps = true;
      return;
    case inch:
      effect.unit = LengthUnit::inch;
      return;
    case mm:
      effect.unit = LengthUnit::mm;
      return;
    case changes_tool:
      effect.changes_tool = true;
      return;
    case ends_program:
      effect.ends_program = true;
      return;
  }
}

bool has_meaning(Tokens codes, std::initializer_list<ControlMeaning> meanings) {
  return std::ranges::any_of(codes, [&](const Token& code) {
    const auto rows = find_control_code(static_cast<char>(code.letters[0] & ~0x20), *code.number);
    return std::ranges::any_of(
        rows, [&](const ControlCode* row) { return std::ranges::find(meanings, row->meaning) != meanings.end(); });
  });
}

// Returns whether a code uses the numbers of axes, which are then not a position to move to.
bool takes_axes(Tokens codes) { return has_meaning(codes, {ControlMeaning::shifts, ControlMeaning::shifts_with_axes}); }

// Notes a code of the group of G0 to G3. Of two codes the control may keep either.
void note_motion_code(double number, MachineEffect& effect) {
  constexpr double kLastArc = 3, kFirstThread = 32, kEndOfThreads = 34;
  if (number > kLastArc && (number < kFirstThread || number >= kEndOfThreads)) return;
  const bool is_line = !effect.motion_code && number <= 1 && std::floor(number) >= number;
  effect.motion_code = !is_line ? MotionCode::other : number > 0 ? MotionCode::straight : MotionCode::rapid;
}

// Notes a code that starts or stops the spindle. Of two codes the stop counts.
void note_spindle(double number, MachineEffect& effect) {
  constexpr auto kStarts = std::to_array<double>({3, 4, 13, 14});
  constexpr auto kStops = std::to_array<double>({5, 19});
  const auto is_code = [&](double code) { return std::abs(number - code) <= 0; };
  if (std::ranges::any_of(kStarts, is_code)) effect.stops_spindle = effect.stops_spindle.value_or(false);
  if (std::ranges::any_of(kStops, is_code)) effect.stops_spindle = true;
}

// Returns the name of an offset, with the tokens beside the code that belong to it.
std::string offset_of(const Token& code, const ControlCode& row, Tokens tokens) {
  std::string name = "G" + exact_text(*code.number);
  for (const Token& t : tokens) {
    if (is_address_of(t, row.addresses)) name += std::string(t.letters) + exact_text(*t.number);
  }
  return name;
}

std::string offset_of(Tokens values) {
  std::string name = "CYCL DEF";
  for (const Token& t : values) {
    if (t.number) name += " " + exact_text(*t.number);
  }
  return name;
}

// Returns whether a code smooths the path. A code without addresses always does, another one by values that are not 0.
bool is_smoothing(const ControlCode& row, Tokens tokens) {
  if (row.meaning != ControlMeaning::smooths) return false;
  const auto has_value = [&](const Token& t) { return is_address_of(t, row.addresses) && std::abs(*t.number) > 0; };
  return row.addresses.empty() || std::ranges::any_of(tokens, has_value);
}

// Takes a block of addresses. Every code must be in the list, and every other address must be known or belong to a
// code.
void take_addresses(Tokens tokens, MachineEffect& effect) {
  constexpr std::string_view kAlways = "NSFTDH";
  std::vector<Token> codes;
  std::string allowed(kAlways);
  for (const Token& t : tokens) {
    if (!is_address_of(t, "GM")) continue;
    codes.push_back(t);
    const auto rows = find_control_code(static_cast<char>(t.letters[0] & ~0x20), *t.number);
    if (rows.empty()) effect.is_unknown = true;
    is_address_of(t, "G") ? note_motion_code(*t.number, effect) : note_spindle(*t.number, effect);
    for (const ControlCode* row : rows) allowed += row->addresses;
  }
  const auto is_taken = [&](const Token& t) { return is_address_of(without_step(t), allowed); };
  bool has_axes = false;
  for (const Token& t : tokens) {
    const bool is_code = is_address_of(t, "GM");
    const bool is_place = !is_code && !is_taken(t) && (is_axis(t) || (!codes.empty() && is_address_of(t, "IJK")));
    has_axes = has_axes || is_place;
    if (!is_code && !is_place && !is_taken(t)) effect.is_unknown = true;
    if (is_address_of(t, "DH") && !is_address_of(t, allowed.substr(kAlways.size()))) effect.changes_length = true;
    if (is_address_of(t, "T")) effect.changes_tool = true;
  }
  for (const Token& code : codes) {
    for (const ControlCode* row : find_control_code(static_cast<char>(code.letters[0] & ~0x20), *code.number)) {
      take_meaning(row->meaning, tokens, has_axes, effect);
      effect.smooths = effect.smooths || is_smoothing(*row, tokens);
      if (row->meaning == ControlMeaning::offset) effect.work_offset = offset_of(code, *row, tokens);
    }
  }
  if (has_axes && !takes_axes(codes)) move(tokens, effect);
}

MachineEffect unknown() {
  MachineEffect effect;
  effect.is_unknown = true;
  return effect;
}

bool are_addresses(Tokens tokens) {
  return std::ranges::all_of(tokens, [](const Token& t) { return is_address(t) || is_axis(t); });
}

MachineEffect read_addresses(Tokens tokens) {
  if (!are_addresses(tokens)) return unknown();
  MachineEffect effect;
  take_addresses(tokens, effect);
  return effect;
}

// Reads a path word of Heidenhain: "L Z-50 FMAX", "CC X+0 Y+0".
std::optional<MachineEffect> read_path_word(Tokens tokens) {
  constexpr std::array<std::string_view, 14> kPathWords = {"L",  "C",   "CC",  "CR", "CT", "CP",  "LP",
                                                           "LN", "CTP", "RND", "FL", "FC", "FLT", "FCT"};
  constexpr std::array<std::string_view, 5> kBeside = {"FMAX", "F", "MAX", "AUTO", "FAUTO"};
  const Token& first = tokens.front();
  if (first.number || !is_one_of(first.letters, kPathWords)) return std::nullopt;
  std::vector<Token> rest;
  for (const Token& t : tokens.subspan(1)) {
    const bool is_uncompensated = is_address_of(t, "R") && std::abs(*t.number) <= 0;
    if (!is_one_of(t.letters, kBeside) && !is_uncompensated) rest.push_back(t);
  }
  if (!are_addresses(rest)) return unknown();
  MachineEffect effect;
  take_addresses(rest, effect);
  if (!is(first, "L") && !effect.moves) effect.is_unknown = true;
  return effect;
}

std::optional<MachineEffect> read_phrase(Tokens tokens) {
  const auto is_begun = [&](const ControlPhrase& p) {
    return is(tokens[0], p.first) && (p.second.empty() || (tokens.size() > 1 && is(tokens[1], p.second)));
  };
  if (std::ranges::none_of(control_phrases(), is_begun)) return std::nullopt;
  for (const ControlPhrase& phrase : control_phrases()) {
    if (!is_begun(phrase)) continue;
    const Tokens rest = tokens.subspan(phrase.second.empty() ? 1 : 2);
    const Token number = rest.empty() ? Token{} : rest.front();
    const bool is_number = number.letters.empty() && number.number.has_value();
    if (phrase.number >= 0 && (!is_number || std::abs(std::floor(*number.number) - phrase.number) > 0)) continue;
    if (phrase.number == ControlPhrase::kNoNumber && is_number) continue;
    const bool is_whole = std::ranges::all_of(rest, [&](const Token& t) {
      constexpr std::string_view kMarks = ":-=~.";
      return t.letters.empty() ? t.number || kMarks.find(t.other) != std::string_view::npos
                               : is_among_words(t.letters, phrase.rest);
    });
    if (!is_whole) continue;
    MachineEffect effect;
    take_meaning(phrase.meaning, rest, false, effect);
    if (phrase.meaning == ControlMeaning::smooths)
      effect.smooths =
          std::ranges::any_of(rest, [](const Token& t) { return is_address_of(t, "T") && std::abs(*t.number) > 0; });
    if (phrase.meaning == ControlMeaning::offset) effect.work_offset = offset_of(rest);
    return effect;
  }
  MachineEffect effect = unknown();
  effect.changes_tool = is(tokens[0], "TOOL");
  return effect;
}

// Returns the text after the brackets or the value of a word; nothing if the brackets are not closed.
std::optional<std::string_view> behind_values(std::string_view after) {
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
  return std::nullopt;
}

// Returns whether the brackets after a word hold a value that is not 0: CYCLE832(0.1), not CYCLE832() or CYCLE832(0,0,1).
bool has_value_in_brackets(std::string_view after) {
  if (!after.starts_with('(')) return true;
  const std::string_view values = after.substr(1);
  const auto first = parse_number(trim(values.substr(0, values.find_first_of(",)"))));
  return first && std::abs(*first) > 0;
}

// Reads a word of the list, and the arguments that its row allows.
std::optional<MachineEffect> read_word(std::string_view text) {
  std::size_t length = 0;
  while (length < text.size() && (is_letter(text[length]) || is_digit(text[length]) || text[length] == '_')) ++length;
  const std::string_view after = trim(text.substr(length));
  if (equals_ignoring_case(text.substr(0, length), "MCALL")) {
    MachineEffect effect;
    (after.empty() ? effect.ends_cycle : effect.begins_cycle) = true;
    return effect;
  }
  const ControlWord* const word = find_control_word(text.substr(0, length));
  if (word == nullptr) return std::nullopt;
  std::optional<std::string_view> rest = after;
  if (word->form == ControlForm::message) rest = after.starts_with('(') ? behind_values(after) : std::nullopt;
  if (word->form == ControlForm::values) rest = behind_values(after);
  if (!rest || (word->form == ControlForm::alone && !after.empty())) return unknown();
  const std::vector<Token> tokens = machine_tokens(*rest);
  MachineEffect effect = tokens.empty() ? MachineEffect{} : read_addresses(tokens);
  effect.smooths = effect.smooths || (word->meaning == ControlMeaning::smooths && has_value_in_brackets(after));
  return effect;
}

// Returns whether text in brackets is a function of an Osai control, not a comment: (UAO,2), (MIR,X), (ERP).
bool has_function_in_brackets(std::string_view text) {
  constexpr std::size_t kLetters = 3;
  for (std::size_t open = text.find('('); open != std::string_view::npos; open = text.find('(', open + 1)) {
    const std::string_view inner = trim(text.substr(open + 1));
    const auto letters = static_cast<std::size_t>(std::ranges::find_if_not(inner, is_letter) - inner.begin());
    const std::string_view after = trim(inner.substr(letters));
    if (letters == kLetters && (after.starts_with(',') || after.starts_with(')'))) return true;
  }
  return false;
}

// Returns whether the text after a semicolon may be a block. On some controls it is a comment, on others the next
// block.
bool may_be_block(std::string_view comment) {
  constexpr std::string_view kMacroLetters = "#=[]<>";
  if (comment.find_first_of(kMacroLetters) != std::string_view::npos) return true;
  const std::vector<Token> tokens = machine_tokens(comment);
  return !tokens.empty() && is_address(tokens.front()) && tokens.front().is_glued;
}

// Returns the text without quotes and percent signs around it, and without the mark for a block skip.
std::string_view without_marks(std::string_view text) {
  text = trim(text);
  while (!text.empty() && std::string_view("/%'\"").find(text.front()) != std::string_view::npos)
    text = trim(text.substr(1));
  while (!text.empty() && std::string_view("%'\"").find(text.back()) != std::string_view::npos)
    text = trim(text.substr(0, text.size() - 1));
  return text;
}

// Returns whether the block only names the program: O1234.
bool is_program_name(Tokens tokens) { return tokens.size() == 1 && is_address_of(tokens.front(), "ON"); }

}  // namespace

MachineEffect read_machine_text(std::string_view text) {
  text = without_marks(text);
  if (const std::size_t semicolon = text.find(';'); semicolon != std::string_view::npos) {
    if (may_be_block(text.substr(semicolon + 1))) return unknown();
    text = trim(text.substr(0, semicolon));
  }
  const std::vector<Token> all = machine_tokens(text);
  Tokens tokens(all);
  if (tokens.empty()) return has_function_in_brackets(text) ? unknown() : MachineEffect{};
  if (is_program_name(tokens)) return {};
  const bool is_numbered = tokens.size() > 1 && (is_address_of(tokens.front(), "N") ||
                                                 (tokens.front().letters.empty() && tokens.front().number));
  if (is_numbered) {
    tokens = tokens.subspan(1);
    const std::string_view next = tokens.front().letters;
    if (!next.empty()) text = text.substr(static_cast<std::size_t>(next.data() - text.data()));
  }
  if (const auto effect = read_word(text)) return *effect;
  if (has_function_in_brackets(text)) return unknown();
  if (const auto effect = read_phrase(tokens)) return *effect;
  if (const auto effect = read_path_word(tokens)) return *effect;
  return read_addresses(tokens);
}

}  // namespace gouge
