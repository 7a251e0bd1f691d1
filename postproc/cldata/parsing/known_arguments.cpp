#include "postproc/cldata/parsing/known_arguments.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "postproc/cldata/language/text.h"
#include "postproc/cldata/language/words.h"
#include "postproc/cldata/parsing/control_list.h"
#include "postproc/cldata/parsing/machine_text.h"

namespace gouge {

namespace {

struct KnownArguments {
  Word word;
  std::string_view minors;  ///< separated by blanks
  std::size_t max_numbers;
};

// Words whose reader uses some arguments and ignores the others. The documents are those of
// docs/formats/harmless_words.md.
constexpr auto kRows = std::to_array<KnownArguments>({
    {Word::cutcom,
     "ON OFF LEFT RIGHT LENGTH ADJUST XYPLAN YZPLAN ZXPLAN XAXIS YAXIS ZAXIS NORMDS NORMAL PLUS MINUS 3DC", 6},
    {Word::end_of_path, "", 0},
    {Word::fedrat,
     "MMPM MMPR IPM IPR FPM FPR PERMIN PERREV INVERS TPI AUTO ON OFF CONST LOCK UNLOCK MAXIPM MAXMPM SCALE MPM UPM UPR "
     "NEXT NOW RPM SFM SMM",
     3},
    {Word::load, "TOOL ADJUST LENGTH MANUAL AUTO HOLDER OSETNO NEXTTL", 5},
    {Word::loadtl,
     "TOOL LENGTH ADJUST OSETNO MANUAL AUTO IN NEXT NOW CLW CCLW SMALL MEDIUM LARGE LOW HIGH MILL DRILL TURN NEXTTL",
     6},
    {Word::opskip, "ON OFF ALL", 1},
    {Word::select, "TOOL NEXT HEAD", 2},
    {Word::toolno,
     "MILL DRILL TURN LENGTH OSETNO MANUAL ADJUST AUTO MMPM MMPR IPM IPR RPM SFM SMM CLW CCLW ON OFF NOTE", 12},
});

}  // namespace

bool are_known_arguments(Word word, std::span<const Argument> arguments) {
  if (word == Word::units)
    return std::ranges::all_of(arguments, [](const Argument& a) { return unit_of_word(a.text).has_value(); });
  const auto* const row = std::ranges::find(kRows, word, &KnownArguments::word);
  if (row == kRows.end()) return true;
  // Any other selection shifts later positions; the reader of SELECT handles this uncertainty.
  if (word == Word::select && !has_argument(arguments.first(std::min(arguments.size(), std::size_t{1})), "TOOL"))
    return true;
  // Positions of a turning tool are never checked, whatever the other arguments state.
  if (word == Word::toolno && has_argument(arguments, "TURN")) return true;
  std::size_t numbers = 0;
  bool is_quoted = false;
  for (const Argument& argument : arguments) {
    const bool begins_quoted = argument.text.starts_with('\'');
    if (argument.number && !is_quoted) {
      if (++numbers > row->max_numbers) return false;
    } else if (!is_quoted && !begins_quoted && !argument.text.empty() && !is_among_words(argument.text, row->minors)) {
      return false;
    }
    is_quoted = is_quoted || begins_quoted;
    if (is_quoted && argument.text.ends_with('\'') && (!begins_quoted || argument.text.size() > 1)) is_quoted = false;
  }
  return !is_quoted;
}

namespace {

bool is_number_start(char c) { return is_digit(c) || c == '+' || c == '-' || c == '.'; }

// Returns whether a word never occurs among the arguments of another one, with or without numbers.
bool is_major_only(Word word) {
  return word == Word::go_to || word == Word::godlta || word == Word::gohome || word == Word::multax;
}

bool takes_position(Word word) { return word == Word::go_to || word == Word::godlta || word == Word::from; }

// Returns whether a real statement contains the word of another one: TLON,GOFWD/(CIRCLE/..), CYCLE/ON CYCLE/DRILL.
bool is_part_of(const Statement& statement, Word word, std::string_view before) {
  if (statement.word == Word::tlon) return word == Word::circle;
  return statement.word == Word::cycle && word == Word::cycle && equals_ignoring_case(trim(before), "ON");
}

// Returns the length of "GODLTA" in "GODLTA-50", else that of the whole `token`.
std::size_t glued_length(std::string_view token) {
  const auto letters = static_cast<std::size_t>(std::ranges::find_if_not(token, is_letter) - token.begin());
  return takes_position(find_word(token.substr(0, letters))) ? letters : token.size();
}

// Returns whether a token begins a block of a control: "G1" in "COOLNT/ON G1 Z-50", or "Z-50" and "Z50." alone.
bool is_block_of_control(std::string_view token, std::string_view text) {
  constexpr std::string_view kAxes = "XYZxyz";
  const bool is_place = token.size() > 1 && kAxes.find(token[0]) != std::string_view::npos &&
                        (token[1] == '-' || (is_digit(token[1]) && text.substr(token.size()).starts_with('.')));
  if (is_place) return read_machine_text(token).moves;
  return token.size() > 1 && (token[0] == 'G' || token[0] == 'g') && is_digit(token[1]) &&
         read_machine_text(text).moves;
}

// Returns whether the word at the end of a token begins a statement together with the text after it.
bool begins_statement(Word word, std::string_view rest) {
  rest = trim(rest);
  const char next = rest.empty() ? '\0' : rest.front();
  return next == '/' || (takes_position(word) && is_number_start(next));
}

// Returns whether a line end is missing before a statement: "16GOTO/", "OFFCYCLE/".
bool ends_with_statement(std::string_view token, std::string_view rest) {
  const std::string_view after = trim(rest);
  if (after.empty() || (after.front() != '/' && !is_number_start(after.front()))) return false;
  const Word word = find_word_at_end(token);
  return word != Word::unknown && begins_statement(word, rest);
}

std::string_view find_in(const Statement& statement, std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t begin = i;
    if (!is_word_character(text[i]) && text[i] != '\'') {
      ++i;
      continue;
    }
    ++i;
    while (i < text.size() && is_word_character(text[i])) ++i;
    const std::string_view token = text.substr(begin, i - begin);
    if (statement.word != Word::unknown && ends_with_statement(token, text.substr(i))) return token;
    if (!is_letter(token.front())) continue;  // exponents, "4TH" and "'TLAXIS'" begin no word
    const bool is_known = statement.word != Word::unknown && statement.word != Word::comment;
    if (is_known && is_block_of_control(token, text.substr(begin))) return token;
    const Word word = find_word(token.substr(0, glued_length(token)));
    if (!changes_motion(word) || is_part_of(statement, word, text.substr(0, begin))) continue;
    if (begins_statement(word, text.substr(i)) || glued_length(token) < token.size()) return token;
    if (is_major_only(word) && statement.word != Word::unknown) return token;
  }
  return {};
}

// Finds a joined word, as in "CENTERLOADTL/", in the text of a name, or in a comment of Creo that is a statement.
std::string_view find_glued(std::string_view text) {
  for (std::size_t slash = text.find('/'); slash != std::string_view::npos; slash = text.find('/', slash + 1)) {
    const std::string_view before = trim(text.substr(0, slash));
    const std::string_view token = before.substr(before.find_last_of(" ,/>") + 1);
    if (find_word(token) == Word::unknown && ends_with_statement(token, "/")) return token;
  }
  return {};
}

// Finds a word after a semicolon before the slash: "RAPID;CUTCOM".
std::string_view find_after_semicolon(std::string_view major) {
  const std::size_t semicolon = major.rfind(';');
  if (semicolon == std::string_view::npos) return {};
  const std::string_view token = trim(major.substr(semicolon + 1));
  return changes_motion(find_word(token)) ? token : std::string_view();
}

bool is_text(Word word) {
  return word == Word::free_text || word == Word::pprint || word == Word::insert || word == Word::tprint ||
         word == Word::operation || word == Word::tool_path || word == Word::syn;
}

}  // namespace

std::string_view find_run_on(const Statement& statement) {
  if (statement.word == Word::tool_path && !statement.pieces.empty()) {
    const std::string_view text = statement.pieces.front();
    return find_glued(text.substr(std::min(text.find(",TOOL,"), text.size())));
  }
  // Positions have only numbers, which their readers test; a part program is refused anyway.
  if (statement.is_decoded || is_text(statement.word) || takes_position(statement.word) ||
      statement.word == Word::part_program)
    return {};
  if (statement.word == Word::unknown) {
    const std::string_view hidden = find_after_semicolon(statement.major);
    if (!hidden.empty()) return hidden;
  }
  const std::size_t first = statement.word == Word::comment ? 1 : 0;
  if (first > 0 && !statement.pieces.empty() && statement.pieces.front().starts_with("->")) {
    const std::string_view found = find_glued(statement.pieces.front());
    if (!found.empty()) return found;
  }
  for (std::size_t i = first; i < statement.pieces.size(); ++i) {
    const std::string_view found = find_in(statement, statement.pieces[i]);
    if (!found.empty()) return found;
  }
  return {};
}

}  // namespace gouge
