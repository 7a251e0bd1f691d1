#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "postproc/cldata/interpreting/emit.h"
#include "postproc/cldata/interpreting/misreading.h"
#include "postproc/cldata/interpreting/word_handlers.h"
#include "postproc/cldata/language/harmless_words.h"
#include "postproc/cldata/language/text.h"
#include "postproc/cldata/parsing/known_arguments.h"

// Handlers for harmless words, and for all words that are not read. The latter may move the tool, change it, its axis
// or compensation, or shift later positions. So after them no earlier statement is certain.

namespace gouge {
namespace {

// Replaces full-width characters and typographic minus signs by those of ASCII, and other characters beyond ASCII by
// blanks.
std::string in_ascii(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = [&](std::size_t at) { return at < text.size() ? static_cast<unsigned char>(text[at]) : 0U; };
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

// Returns whether a word of the source language is a statement: it stands alone, or before a slash or comma. Otherwise
// it begins a sentence.
bool is_statement(const StatementContext& in) {
  const std::string_view rest = trim(in.text_behind_major());
  return rest.empty() || rest.front() == '/' || rest.front() == '(' || rest.front() == ',' || rest.front() == '$';
}

void mark_frame_uncertain(States& s) {
  s.uncertainties.set(Uncertainty::unread_frame, s.in.because(Reasons::kUnreadFrame));
}

// Returns the first line of a statement that is text, with its word.
std::string whole_text(const Statement& statement) {
  const char* const begin = statement.major.data();
  const std::string_view end = statement.pieces.empty() ? statement.major : statement.pieces.front();
  return in_ascii({begin, static_cast<std::size_t>(end.data() + end.size() - begin)});
}

// Returns the parts of a text between semicolons, as in blocks of a control.
std::vector<std::string_view> parts_of(std::string_view text) {
  std::vector<std::string_view> parts;
  for (std::size_t at = 0; at <= text.size(); at = std::min(text.find(';', at), text.size()) + 1)
    parts.push_back(trim(text.substr(at, text.find(';', at) - at)));
  return parts;
}

// Takes a block without a word, such as M8 or G54.
bool take_blocks(States& s, const std::vector<std::string_view>& parts) {
  if (s.in.statement().pieces.size() > 1) return false;
  std::vector<MachineEffect> effects;
  for (const std::string_view part : parts) {
    const bool begins_block = !part.empty() && (is_letter(part.front()) || part.front() == '%');
    if (!begins_block || part.find_first_of("(/") != std::string_view::npos) return false;
    effects.push_back(read_machine_text(part));
    if (effects.back().is_unknown) return false;
  }
  for (const MachineEffect& effect : effects) take_machine_text(s, effect);
  return true;
}

bool is_declared(const States& s) {
  const std::string_view major = s.in.statement().major;
  return std::ranges::any_of(s.in.path.harmless_words,
                             [&](const auto& word) { return equals_ignoring_case(word, major); }) &&
         !hides_statement(s.in.arguments);
}

// Returns whether a word is followed by a comma instead of a slash. Then it is the end of a statement that was cut.
bool is_end_of_another(const StatementContext& in) {
  return !in.statement().is_decoded && in.text_behind_major().starts_with(',');
}

}  // namespace

void mark_all_uncertain(States& s, std::string_view major, std::size_t statement) {
  if (!s.in.path.moves.empty()) emit_unread(s, s.in.named(Reasons::kUnread, major), statement);
  s.is_unknown_in_block = true;
  if (s.uncertainties.has(Uncertainty::unknown)) return;
  s.uncertainties.set(Uncertainty::unknown,
                      s.in.named(Reasons::kAfterUnknown, major, s.in.path.statements[statement].line));
}

void take_unknown_statement(States& s) {
  s.in.count_unknown();
  mark_all_uncertain(s, s.in.statement().major, s.in.index());
}

void take_harmless(States& s) {
  const Statement& statement = s.in.statement();
  const bool is_spindle = equals_ignoring_case(statement.major, "SPINDL");
  if (statement.is_decoded ? !is_spindle : statement.pieces.empty()) return;
  split_arguments(statement, s.in.arguments);
  if (statement.is_decoded || (is_harmless(statement.major, s.in.arguments) && !is_end_of_another(s.in))) {
    if (is_spindle) s.feed.take_spindle();
    return;
  }
  is_declared(s) ? s.in.count_declared() : take_unknown_statement(s);
}

void distrust_arguments(States& s) {
  const Statement& statement = s.in.statement();
  if (!statement.is_decoded && !are_known_arguments(statement.word, s.in.arguments)) take_unknown_statement(s);
}

void take_part_program(States& s) {
  is_statement(s.in) ? s.in.refuse_part_program(s.in.statement().major) : take_unknown(s);
}

void take_unknown(States& s) {
  if (is_declared(s)) return s.in.count_declared();
  if (s.in.statement().is_decoded) return take_unknown_statement(s);
  const std::string text = whole_text(s.in.statement());
  const std::vector<std::string_view> parts = parts_of(text);
  if (take_blocks(s, parts)) return;
  s.in.count_unknown();
  bool is_rest = true;
  for (const std::string_view part : parts) is_rest = take_misread(s, part) && is_rest;
  if (!is_rest) mark_all_uncertain(s, s.in.statement().major, s.in.index());
}

void take_unread_motion(States& s) {
  s.in.count_unknown();
  emit_unread(s);
}

// Takes a repetition. hyperMILL begins and ends its programs with two subprograms of the machine.
void take_repeat(States& s) {
  constexpr std::array<std::string_view, 2> kFrames = {"START_PROG", "END_PROG"};
  const bool is_frame = equals_ignoring_case(s.in.statement().major, "CALSUB") && s.in.arguments.size() == 1 &&
                        is_one_of(s.in.arguments.front().text, kFrames);
  if (is_frame) return;
  take_unread_motion(s);
  mark_frame_uncertain(s);
}

// Takes a frame that is not read. TRACUT/NOMORE and COUPLE/OFF end nothing in a file that has begun nothing of the
// kind.
void take_unread_frame(States& s) {
  const auto ends = [&](std::string_view major, std::string_view end) {
    return equals_ignoring_case(s.in.statement().major, major) && s.in.arguments.size() == 1 &&
           equals_ignoring_case(s.in.arguments.front().text, end);
  };
  if ((ends("TRACUT", "NOMORE") || ends("COUPLE", "OFF")) && !s.uncertainties.was_on(Uncertainty::unread_frame)) return;
  s.in.count_unknown();
  mark_frame_uncertain(s);
}

void take_unread_tool(States& s) {
  s.in.count_unknown();
  s.tool.forget_cutter();
}

}  // namespace gouge
