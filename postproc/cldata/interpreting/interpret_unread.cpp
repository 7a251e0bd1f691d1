#include <algorithm>
#include <array>
#include <cstddef>

#include "lib/base/number_text.h"
#include "postproc/cldata/interpreting/interpreter.h"
#include "postproc/cldata/language/text.h"
#include "postproc/cldata/language/unit_words.h"

// Statements that are not understood: counted by word, and where they could have moved the tool, the moves
// they could have changed are not checked.

namespace gouge {
namespace {

// A word with this many numbers may be a motion.
constexpr std::size_t kNumbersOfMotion = 3;

bool is_sign(char c) {
  return c == '+' || c == '-' || c == '.';
}

bool begins_with_number(std::string_view text) {
  while (!text.empty() && (is_blank(text.front()) || text.front() == '(' || text.front() == ','))
    text.remove_prefix(1);
  return !text.empty() && (is_digit(text.front()) ||
                           (text.size() > 1 && is_sign(text[0]) && (is_digit(text[1]) || is_sign(text[1]))));
}

// Characters of the width of Chinese ones, and the minus of books, as those of ASCII; other ones beyond it as
// blanks.
std::string in_ascii(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = [&](std::size_t at) {
      return at < text.size() ? static_cast<unsigned char>(text[at]) : 0U;
    };
    const unsigned code = ((byte(i) & 0x0fU) << 12U) | ((byte(i + 1) & 0x3fU) << 6U) | (byte(i + 2) & 0x3fU);
    if (byte(i) < 0x80) {
      plain += text[i];
    } else if (byte(i) == 0xef && code > 0xff00 && code < 0xff5f) {
      plain += static_cast<char>(code - 0xff00 + 0x20);
      i += 2;
    } else if (code == 0x2212) {
      plain += '-';
      i += 2;
    } else {
      plain += ' ';
    }
  }
  return plain;
}

// What follows a `/` that deletes blocks, a sequence number or a label: "N10 X5", "20 FOO/1", "LAB1) -50."
std::string_view without_label(std::string_view text) {
  while (!text.empty() && (is_blank(text.front()) || text.front() == '/')) text.remove_prefix(1);
  std::size_t at = !text.empty() && (text[0] == 'N' || text[0] == 'n') ? 1 : 0;
  while (at < text.size() && is_digit(text[at])) ++at;
  if (at > 1 && at == text.size() && !is_digit(text[0])) return {};
  if (at < text.size() && at > 0 && is_digit(text[at - 1]) && (is_blank(text[at]) || is_letter(text[at])))
    return trim(text.substr(at));
  std::size_t word = 0;
  while (word < text.size() && is_word_character(text[word])) ++word;
  const std::string_view rest = trim(text.substr(word));
  return word > 0 && rest.size() > 1 && rest.front() == ')' ? trim(rest.substr(1)) : text;
}

// The known word that the beginning of `text` was meant to be.
Word intended_word(std::string_view text) {
  constexpr std::size_t kLongest = 24;
  std::string_view word = text.substr(0, text.find_first_of(" \t,/"));
  if (const Word known = find_word(word); changes_motion(known)) return known;
  if (const Word intended = find_intended_word(word); intended != Word::unknown) return intended;
  std::string squeezed;
  for (const char c : text.substr(0, text.find('/'))) {
    if (!is_blank(c) && squeezed.size() < kLongest) squeezed += c;
  }
  return find_intended_word(squeezed);
}

// "Z: -50": the letter of an axis, then something else and a number.
bool is_axis_alone(std::string_view text) {
  constexpr std::string_view kAxes = "XYZxyz";
  return text.size() > 1 && kAxes.find(text[0]) != std::string_view::npos && !is_letter(text[1]) &&
         text[1] != '_' && text.find_first_of("0123456789") != std::string_view::npos &&
         text.find('/') == std::string_view::npos;
}

// "DOWN-50.": a word and a negative number at it, and nothing else.
bool is_step_alone(std::string_view text) {
  const auto letters =
      static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), is_letter) - text.begin());
  return letters > 0 && letters < text.size() && text[letters] == '-' &&
         parse_number(trim(text.substr(letters)));
}

// Between these a line of numbers is a position, or part of one.
bool is_among_positions(Word word) {
  return word == Word::go_to || word == Word::godlta || word == Word::from || word == Word::circle ||
         word == Word::movarc || word == Word::rapid || word == Word::fedrat || word == Word::unknown ||
         word == Word::cntrl;
}

// Words that say nothing without an argument.
bool needs_arguments(Word word) {
  switch (word) {
    case Word::cycle:
    case Word::load:
    case Word::loadtl:
    case Word::mode:
    case Word::rotabl:
    case Word::select:
    case Word::setup:
    case Word::tldata:
    case Word::toolno:
    case Word::trans:
      return true;
    default:
      return false;
  }
}

// A comma at the end goes on to something; but CAMWorks writes one after the seven numbers of a CUTTER.
bool is_cut_short(const Statement& statement, std::size_t arguments) {
  constexpr std::size_t kNumbersOfCutter = 7;
  if (statement.is_decoded || !changes_motion(statement.word) || statement.pieces.empty()) return false;
  if (arguments == 0 && needs_arguments(statement.word)) return true;
  if (statement.word == Word::cutter && arguments == kNumbersOfCutter) return false;
  return statement.pieces.back().ends_with(',');
}

bool moves_tool(Word word) {
  switch (word) {
    case Word::go_to:
    case Word::godlta:
    case Word::from:
    case Word::gohome:
    case Word::unread_motion:
    case Word::circle:
    case Word::movarc:
    case Word::curve:
    case Word::tlon:
    case Word::nurbs:
    case Word::cntrl:
    case Word::knot:
    case Word::indirv:
    case Word::retrct:
    case Word::repeat:
    case Word::auxfun:
      return true;
    default:
      return false;
  }
}

bool has_effect(const MachineEffect& e) {
  return e.moves || e.shifts || e.changes_length || e.begins_cycle || e.begins_steps || e.changes_tool ||
         e.unit;
}

// Words of no dialect that is read here, which elsewhere choose an offset, a datum or a head, or turn or shift what follows:
// OFFSET/5, ZSHIFT/5, HEADTILT/30, BAXIS/45.
bool is_shifting_word(std::string_view word) {
  constexpr std::array<std::string_view, 3> kWords = {"ADJUST", "FIXOFF", "HEAD"};
  constexpr std::array<std::string_view, 8> kParts = {"AXIS", "DATUM", "OFFSET", "OFSET", "OFST", "SHIFT", "TILT", "TURN"};
  constexpr std::size_t kLongest = 24;
  std::string large;
  for (const char c : word.substr(0, kLongest)) large += static_cast<char>(is_letter(c) ? c & ~0x20 : c);
  return std::find(kWords.begin(), kWords.end(), large) != kWords.end() ||
         std::any_of(kParts.begin(), kParts.end(),
                     [&](std::string_view part) { return large.find(part) != std::string::npos; });
}

std::string_view without_quotes(std::string_view text) {
  while (!text.empty() && text.front() == '\'') text.remove_prefix(1);
  while (!text.empty() && text.back() == '\'') text.remove_suffix(1);
  return text;
}

}  // namespace

// CAMplete: SYN/'TLAXIS','$$*TLAXIS' makes comments of TLAXIS. Other names of words would have to be read as
// these.
void Interpreter::take_syn() {
  for (const Argument& argument : arguments_) {
    if (equals_ignoring_case(argument.text, "'TLAXIS'")) {
      is_tlaxis_ignored_ = true;
    } else if (find_word(without_quotes(argument.text)) != Word::unknown) {
      return fail("path-statement",
                  "SYN: a synonym of " + quoted_text(argument.text) +
                      "; expected the words themselves: write them in place of their synonyms");
    }
  }
}

// A word with one or two numbers switches something; with a negative one, with three or where the word says
// so it may go somewhere, and unless the word says so it may as well be a shift.
void Interpreter::take_unknown() {
  count_unknown();
  if (!statement_->is_decoded) {
    const std::string_view end = statement_->pieces.front();
    const auto length = static_cast<std::size_t>(end.data() + end.size() - statement_->major.data());
    const std::string text = in_ascii({statement_->major.data(), length});
    bool is_misread = false;
    for (std::size_t at = 0; at <= text.size(); at = std::min(text.find(';', at), text.size()) + 1) {
      is_misread = take_misread(std::string_view(text).substr(at, text.find(';', at) - at)) || is_misread;
    }
    if (is_misread) return;
  }
  distrust_arguments();
  const NumberCount numbers = count_numbers(arguments_);
  const bool is_motion = starts_with_ignoring_case(statement_->major, "GO") ||
                         starts_with_ignoring_case(statement_->major, "MOV");
  if (!(numbers.count >= kNumbersOfMotion || numbers.has_negative || (is_motion && numbers.count > 0))) return;
  // Before the first position it can only be a shift that matters.
  if (is_motion || !path_.moves.empty()) emit_unread();
  if (!is_motion) unread_frame_reason_ = because(Reasons::kUnreadFrame);
}

// LOAAD/TOOL,2 and UINT/MM: whatever the word is, its arguments are those of one that matters.
void Interpreter::distrust_arguments() {
  for (const char* glued : {"UNITSMM", "UNITSINCH", "UNITMM", "UNITINCH"}) {
    if (starts_with_ignoring_case(statement_->major, glued)) unread_frame_reason_ = because(Reasons::kUnreadFrame);
  }
  if (starts_with_ignoring_case(statement_->major, "INCREM")) unread_frame_reason_ = because(Reasons::kUnreadFrame);
  if (arguments_.empty()) return;
  const bool is_load = arguments_.size() > 1 && arguments_[1].number && equals_ignoring_case(arguments_[0].text, "TOOL");
  const bool is_tool = starts_with_ignoring_case(statement_->major, "LOADTOOL") ||
                       (starts_with_ignoring_case(statement_->major, "TOOL") && count_numbers(arguments_).count > 0);
  if (is_load || is_tool) loading_reason_ = because(Reasons::kUnreadTool);
  if (is_shifting_word(statement_->major) && count_numbers(arguments_).count > 0)
    unread_frame_reason_ = because(Reasons::kUnreadFrame);
  if (has_argument(arguments_, "LEFT") || has_argument(arguments_, "RIGHT")) distrust(Word::cutcom);
  const bool is_unit = arguments_.size() == 1 && unit_of_word(arguments_[0].text);
  if (is_unit) unread_frame_reason_ = because(Reasons::kUnreadFrame);
}

// True where `text` is a line of numbers, a word that something was glued to or that is misspelt, or a block
// of a control that does something.
bool Interpreter::take_misread(std::string_view text) {
  text = without_label(text);
  if (begins_with_number(text)) {
    take_rest_of_statement(is_among_positions(previous_word_));
    return true;
  }
  if (is_axis_alone(text) || is_step_alone(text)) {
    emit_unread();
    return true;
  }
  if (is_minor_word(text.substr(0, text.find_first_of(" \t,")))) {
    take_rest_of_statement(false);
    return true;
  }
  const std::size_t slash = text.find('/');
  const bool is_block = slash == std::string_view::npos;
  MachineEffect effect = read_machine_text(is_block ? text : text.substr(slash + 1), !is_block);
  effect.is_unknown = false;
  if (has_effect(effect)) take_machine_text(effect);
  const Word word = intended_word(text);
  distrust(word);
  if (moves_tool(word) && !effect.moves) emit_unread();
  if (statement_->major.empty() && !has_effect(effect) && word == Word::unknown && !text.empty())
    take_rest_of_statement(false);  // "/LEFT" without its word
  return has_effect(effect) || word != Word::unknown;
}

// The beginning of a statement is missing, or the `$` that would make this part of the one before it.
void Interpreter::take_rest_of_statement(bool is_position) {
  if (previous_statement_ != kNone) distrust_moves(previous_statement_);
  distrust(previous_word_);
  emit_unread();
  if (!is_position) unread_frame_reason_ = because(Reasons::kUnreadFrame);
}

// What a statement of this word would have changed is not known any more.
void Interpreter::distrust(Word word) {
  switch (word) {
    case Word::cutter:
    case Word::tldata:
    case Word::unread_tool:
      tool_.cutter.reset();
      is_tool_changed_ = true;
      cutter_reason_ = because(Reasons::kUnreadTool);
      return;
    case Word::load:
    case Word::loadtl:
    case Word::toolno:
    case Word::turret:
      loading_reason_ = because(Reasons::kUnreadTool);
      return;
    case Word::tool_path:
      loading_reason_ = because(Reasons::kUnreadTool);
      [[fallthrough]];
    case Word::csys:
    case Word::mcs:
    case Word::mcsys:
    case Word::msys:
    case Word::mode:
    case Word::prefun:
    case Word::repeat:
    case Word::rotabl:
    case Word::select:
    case Word::setup:
    case Word::syn:
    case Word::tlaxis:
    case Word::trans:
    case Word::trntyp:
    case Word::units:
    case Word::unread_frame:
      unread_frame_reason_ = because(Reasons::kUnreadFrame);
      return;
    case Word::multax:
      multax_reason_ = because(Reasons::kMultax);
      return;
    case Word::cycle:
      cycle_ = {};
      cycle_.is_on = true;
      cycle_.line = statement_->line;
      cycle_.certain_moves = path_.moves.size();
      cycle_reason_ = because(Reasons::kCycle);
      return;
    case Word::cutcom:
      return begin_cutcom();
    case Word::cntrl:
    case Word::knot:
      if (!path_.moves.empty() && !Reasons::is_unread(path_.moves.back().not_checked_reason)) {
        path_.moves.back().not_checked_reason = Reasons::kSpline;
      }
      return;
    case Word::rapid:
      unknown_start_ = Reasons::kAfterUnread;
      return;
    default:
      return;
  }
}

void Interpreter::distrust_moves(std::size_t statement) {
  for (std::size_t i = path_.moves.size(); i-- > 0 && path_.moves[i].statement == statement;) {
    if (!Reasons::is_unread(path_.moves[i].not_checked_reason))
      path_.moves[i].not_checked_reason = Reasons::kCutShort;
  }
}

// A statement that ends with a comma, or has a word alone that says nothing so.
void Interpreter::distrust_cut_short() {
  if (!is_cut_short(*statement_, arguments_.size())) return;
  distrust_moves(path_.statements.size() - 1);
  distrust(statement_->word);
  if (moves_tool(statement_->word)) unknown_start_ = Reasons::kAfterUnread;
}

// A motion nobody knows the end of stands where the last one ended, so that it is told as a move not checked.
void Interpreter::emit_unread(const char* reason, std::size_t statement) {
  resolve_tool();
  resolve_operation();
  Move move;
  move.line = path_.statements[statement].line;
  move.statement = statement;
  if (last_pose_) {
    move.end = *last_pose_;
  } else if (!path_.moves.empty()) {
    move.end = path_.moves.back().end;
  }
  move.tool = tool_index_;
  move.operation = operation_index_;
  move.not_checked_reason = reason;
  if (move.not_checked_reason == Reasons::kUnread) {
    move.not_checked_reason = reasons_.name(reason, statement_->major);
  }
  if (records_ != nullptr) {
    Position position;
    position.form = PositionForm::unread;
    position.axis_local = implied_axis();
    records_->of_move.push_back(make_record(move, position));
  }
  break_motion();
  can_link_ = false;
  start_tangent_.reset();
  has_indirv_ = false;
  last_pose_ = move.end;
  unknown_start_ = Reasons::kAfterUnread;
  is_rapid_ = false;
  was_from_ = false;
  make_room(path_.moves);
  path_.moves.push_back(move);
}

}  // namespace gouge
