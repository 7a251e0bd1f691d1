#include <algorithm>
#include <array>
#include <cstddef>
#include <string>

#include "postproc/cldata/interpreting/emit.h"
#include "postproc/cldata/interpreting/misreading.h"
#include "postproc/cldata/interpreting/word_handlers.h"
#include "postproc/cldata/language/text.h"
#include "postproc/cldata/language/unit_words.h"

// Words that are not understood, or are known to matter in a way that is not read: counted, and where they could have
// moved the tool, reported as moves that are not checked.

namespace gouge {
namespace {

// A word with this many numbers may be a motion.
constexpr std::size_t kNumbersOfMotion = 3;

// Whose own numbers may be as many as those of a position: the stock's box, the planes of clearance, a material.
constexpr std::array<std::string_view, 4> kOfManyNumbers = {"BOX", "CLEARP", "CLRSRF", "MATERL"};

// Characters of the width of Chinese ones, and the minus of books, as those of ASCII; other ones beyond it as
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

// Words of no dialect that is read here, which elsewhere choose an offset, a datum or a head, or turn or shift what
// follows: OFFSET/5, ZSHIFT/5, HEADTILT/30, BAXIS/45.
bool is_shifting_word(std::string_view word) {
  constexpr std::array<std::string_view, 3> kWords = {"ADJUST", "FIXOFF", "HEAD"};
  constexpr std::array<std::string_view, 8> kParts = {"AXIS", "DATUM", "OFFSET", "OFSET",
                                                      "OFST", "SHIFT", "TILT",   "TURN"};
  constexpr std::size_t kLongest = 24;
  std::string large;
  for (const char c : word.substr(0, kLongest)) large += static_cast<char>(is_letter(c) ? c & ~0x20 : c);
  return std::ranges::find(kWords, large) != kWords.end() ||
         std::ranges::any_of(kParts, [&](std::string_view part) { return large.find(part) != std::string::npos; });
}

// A word of the source language makes a statement alone or before a slash or comma; else it only begins a
// sentence.
bool is_statement(const StatementContext& in) {
  const std::string_view all = in.path.source, major = in.statement().major;
  const auto after = static_cast<std::size_t>(major.data() - all.data()) + major.size();
  const std::string_view rest = trim(all.substr(after, all.find('\n', after) - after));
  return rest.empty() || rest.front() == '/' || rest.front() == '(' || rest.front() == ',' || rest.front() == '$';
}

void doubt_frame(States& s) { s.doubts.set(Doubt::unread_frame, s.in.because(Reasons::kUnreadFrame)); }

// LOAAD/TOOL,2 and UINT/MM: whatever the word is, its arguments are those of one that matters.
void distrust_arguments(States& s) {
  const std::string_view major = s.in.statement().major;
  const std::vector<Argument>& arguments = s.in.arguments;
  for (const char* glued : {"UNITSMM", "UNITSINCH", "UNITMM", "UNITINCH", "INCREM"}) {
    if (starts_with_ignoring_case(major, glued)) doubt_frame(s);
  }
  if (arguments.empty()) return;
  const bool has_number = count_numbers(arguments).count > 0;
  const bool is_load = arguments.size() > 1 && arguments[1].number && equals_ignoring_case(arguments[0].text, "TOOL");
  const bool is_tool =
      starts_with_ignoring_case(major, "LOADTOOL") || (starts_with_ignoring_case(major, "TOOL") && has_number);
  if (is_load || is_tool) s.doubts.set(Doubt::loading, s.in.because(Reasons::kUnreadTool));
  if (is_shifting_word(major) && has_number) doubt_frame(s);
  if (s.in.has("LEFT") || s.in.has("RIGHT")) distrust(s, Word::cutcom);
  if (arguments.size() == 1 && unit_of_word(arguments[0].text)) doubt_frame(s);
}

// Its parts, as blocks of a control stand between semicolons.
bool is_misread(States& s) {
  if (s.in.statement().is_decoded) return false;
  const char* const begin = s.in.statement().major.data();
  const std::string_view end = s.in.first_piece();
  const std::string text = in_ascii({begin, static_cast<std::size_t>(end.data() + end.size() - begin)});
  bool is_any = false;
  for (std::size_t at = 0; at <= text.size(); at = std::min(text.find(';', at), text.size()) + 1) {
    is_any = take_misread(s, std::string_view(text).substr(at, text.find(';', at) - at)) || is_any;
  }
  return is_any;
}

}  // namespace

// A word that switches something has one or two numbers; SPINDL alone may have a negative one (the sense of rotation).
// Where a line end or a word was lost, more are the position that stood on the next line (COOLNT/ON,0,0,-5).
void take_harmless(States& s) {
  const Statement& statement = s.in.statement();
  if (statement.is_decoded || statement.pieces.empty()) return;
  if (is_one_of(statement.major, kOfManyNumbers)) return;
  split_arguments(statement, s.in.arguments);
  const NumberCount numbers = count_numbers(s.in.arguments);
  const std::size_t most = numbers.has_negative ? (equals_ignoring_case(statement.major, "SPINDL") ? 1 : 0) : 2;
  if (numbers.count > most) take_unread_motion(s);
}

void take_part_program(States& s) {
  is_statement(s.in) ? s.in.refuse_part_program(s.in.statement().major) : take_unknown(s);
}

// A word with one or two numbers switches something; with a negative one, with three or where the word says
// so it may go somewhere, and unless the word says so it may as well be a shift.
void take_unknown(States& s) {
  s.in.count_unknown();
  if (is_misread(s)) return;
  distrust_arguments(s);
  const std::string_view major = s.in.statement().major;
  const NumberCount numbers = count_numbers(s.in.arguments);
  const bool is_motion = starts_with_ignoring_case(major, "GO") || starts_with_ignoring_case(major, "MOV");
  if (!(numbers.count >= kNumbersOfMotion || numbers.has_negative || (is_motion && numbers.count > 0))) return;
  // Before the first position it can only be a shift that matters.
  if (is_motion || !s.in.path.moves.empty()) emit_unread(s);
  if (!is_motion) doubt_frame(s);
}

void take_unread_motion(States& s) {
  s.in.count_unknown();
  emit_unread(s);
}

void take_repeat(States& s) {
  take_unread_motion(s);
  doubt_frame(s);
}

void take_unread_frame(States& s) {
  s.in.count_unknown();
  doubt_frame(s);
}

void take_unread_tool(States& s) {
  s.in.count_unknown();
  s.tool.forget_cutter();
}

}  // namespace gouge
