#include "postproc/cldata/parsing/machine_text.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "lib/base/axis_tolerance.h"
#include "lib/base/number_text.h"
#include "postproc/cldata/language/text.h"
#include "postproc/cldata/parsing/control_list.h"
#include "postproc/cldata/parsing/machine_effects.h"
#include "postproc/cldata/parsing/machine_tokens.h"

namespace gouge {
namespace {

using Token = MachineToken;
using Tokens = MachineTokens;

bool is(const Token& token, std::string_view word) { return equals_ignoring_case(token.letters, word); }

std::string offset_of(Tokens values) {
  std::string name = "CYCL DEF";
  for (const Token& t : values) {
    if (t.number) name += " " + exact_text(*t.number);
  }
  return name;
}

MachineEffect unknown() {
  MachineEffect effect;
  effect.is_unknown = true;
  return effect;
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

// Notes the tolerance of CYCL DEF 32.1.
void note_tolerance(Tokens values, MachineEffect& effect) {
  for (const Token& t : values) {
    if (!is_address_of(t, "T") || !(std::abs(*t.number) > 0)) continue;
    effect.smooths = true;
    note_smoothing(std::abs(*t.number), effect);
  }
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
    const auto is_joint_path = [](const Token& t) { return is(t, "AXIS"); };  // PATHCTRL AXIS, also AXIS POS
    const bool turns_axes = phrase.meaning == ControlMeaning::turns_axes;
    if (!turns_axes || std::ranges::count_if(rest, is_joint_path) > 1)
      take_meaning(phrase.meaning, rest, false, effect);
    if (phrase.meaning == ControlMeaning::smooths) note_tolerance(rest, effect);
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

// Notes the smoothing of a word: CYCLE832(0.1) smooths, CYCLE832() and CYCLE832(0,0,1) do not, COMPCAD does. Only CYCLE832
// has a tolerance in brackets.
void note_smoothing(const ControlWord& word, std::string_view after, MachineEffect& effect) {
  if (word.meaning != ControlMeaning::smooths) return;
  if (!after.starts_with('(')) {
    effect.smooths = true;
    return;
  }
  const std::string_view values = after.substr(1);
  const auto first = parse_number(trim(values.substr(0, values.find_first_of(",)"))));
  if (!first || !(std::abs(*first) > 0)) return;
  effect.smooths = true;
  note_smoothing(std::abs(*first) * kSmoothingCycleShare, effect);
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
  note_smoothing(*word, after, effect);
  if (word->meaning != ControlMeaning::smooths) take_meaning(word->meaning, tokens, false, effect);
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

MachineEffect read_block(std::string_view text) {
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

}  // namespace

MachineEffect read_machine_text(std::string_view text) {
  MachineEffect effect = read_block(text);
  const std::string_view marks = trim(text).substr(0, trim(text).find_first_not_of(" /%'\""));
  if (marks.find('/') == std::string_view::npos) return effect;
  if (has_effect(effect)) return unknown();
  if (effect.stops_spindle == false) effect.stops_spindle.reset();
  return effect;
}

}  // namespace gouge
