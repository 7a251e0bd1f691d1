#include "postproc/cldata/lexing/lexer.h"

#include <algorithm>
#include <iterator>
#include <string>

#include "postproc/cldata/language/arguments.h"
#include "postproc/cldata/language/text.h"

namespace gouge {
namespace {

constexpr std::size_t kLongestLabel = 12;
constexpr std::size_t kLongestMajor = 24;

std::size_t length_of(std::string_view text, bool (*belongs)(char)) {
  return static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), belongs) - text.begin());
}

// Removes from `text` its comment and the `$` that continues it, after which APT ignores the rest of the line. Returns
// whether there was such a `$`. A comment with data, `$$->`, is continued only by a `$` at its end.
bool strip_line(std::string_view& text, bool is_comment) {
  const std::size_t dollar = text.find('$');
  if (dollar == std::string_view::npos) {
    text = trim(text);
    return false;
  }
  const bool ends_here = text.substr(dollar, 2) != "$$" && !is_comment;
  const std::size_t comment = text.find("$$", dollar);
  text = trim(text.substr(0, ends_here ? dollar : comment));
  if (ends_here || text.empty() || text.back() != '$') return ends_here;
  text = trim(text.substr(0, text.size() - 1));
  return true;
}

// Finds a word without its blanks, which APT ignores: CUT COM/LEFT is a CUTCOM. Characters beyond ASCII, such as the
// no-break space, are ignored too.
Word word_without_blanks(std::string_view words) {
  if (words.size() > kLongestMajor) return Word::unknown;
  std::string squeezed;
  std::copy_if(words.begin(), words.end(), std::back_inserter(squeezed),
               [](char c) { return !is_blank(c) && static_cast<unsigned char>(c) < 0x80; });
  return find_word(squeezed);
}

bool begins_with_word(std::string_view text) {
  return free_text_word_length(text) > 0 ||
         find_word(text.substr(0, length_of(text, is_word_character))) != Word::unknown ||
         word_without_blanks(text.substr(0, text.find('/'))) != Word::unknown;
}

// Returns the length of a sequence number or label before a known word: "N10 ", "20 ", "LAB1) ".
std::size_t label_length(std::string_view line) {
  const std::size_t letter = line.front() == 'N' || line.front() == 'n' ? 1 : 0;
  std::size_t length = letter + length_of(line.substr(letter), is_digit);
  if (length == letter) {
    length = length_of(line, is_word_character);
    if (length > kLongestLabel) return 0;
    const std::string_view rest = trim(line.substr(length));
    if (length == 0 || rest.empty() || rest.front() != ')') return 0;
    length = static_cast<std::size_t>(rest.data() - line.data());
  }
  if (length < line.size() && line[length] == ')') ++length;
  const std::string_view rest = trim(line.substr(length));
  return begins_with_word(rest) ? static_cast<std::size_t>(rest.data() - line.data()) : 0;
}

// Cuts the major word off `text`: up to the slash, or up to the first blank if a blank delimits it.
std::string_view take_major(std::string_view& text) {
  const std::size_t slash = text.find('/');
  std::string_view major = trim(text.substr(0, slash));
  std::size_t cut = slash == std::string_view::npos ? text.size() : slash + 1;
  const std::size_t blank = major.find_first_of(" \t,");
  if (blank != std::string_view::npos && major.find('=') == std::string_view::npos) {
    major = major.substr(0, blank);
    cut = static_cast<std::size_t>(major.data() - text.data()) + blank + 1;
  }
  text = text.substr(cut);
  return major;
}

constexpr std::size_t kColumns = 72, kCard = 80;

std::string_view first_line(std::string_view bytes) {
  bytes = without_byte_order_mark(bytes);
  const std::string_view line = bytes.substr(0, bytes.find('\n'));
  return line.ends_with('\r') ? line.substr(0, line.size() - 1) : line;
}

// Returns whether columns 73 to 80 are a sequence number: digits up to column 80, possibly after blanks or letters of a
// name.
bool is_sequence(std::string_view columns) {
  const std::string_view text = trim(columns);
  const std::size_t letters = length_of(text, is_letter);
  return columns.size() == kCard - kColumns && !text.empty() && is_digit(columns.back()) && letters < text.size() &&
         length_of(text.substr(letters), is_digit) == text.size() - letters;
}

bool is_card(std::string_view line) {
  return line.size() == kCard && !trim(line.substr(0, kColumns)).empty() && is_sequence(line.substr(kColumns));
}

// Returns whether columns are a point number of CATIA: "PT     1" or "CIR    1".
bool is_point_number(std::string_view columns) {
  const std::string_view text = trim(columns);
  const std::size_t word = starts_with_ignoring_case(text, "PT") ? 2 : starts_with_ignoring_case(text, "CIR") ? 3 : 0;
  const std::string_view number = trim(text.substr(word));
  return word > 0 && columns.size() <= kCard - kColumns && !is_blank(columns.front()) && !number.empty() &&
         length_of(number, is_digit) == number.size();
}

}  // namespace

Lexer::Lexer(std::string_view bytes, std::size_t first_byte, std::size_t line)
    : bytes_(bytes), at_(first_byte), line_(line), has_cards_(is_card(first_line(bytes))) {
  if (at_ == 0 && bytes_.starts_with(kByteOrderMark)) at_ = kByteOrderMark.size();
}

std::string_view Lexer::take_line() {
  const std::size_t end = bytes_.find('\n', at_);
  const std::string_view text = bytes_.substr(at_, end - at_);
  at_ = end == std::string_view::npos ? bytes_.size() : end + 1;
  ++line_;
  return trim(text.size() > kColumns ? without_columns(text) : text);
}

std::string_view Lexer::without_columns(std::string_view line) const {
  if (line.ends_with('\r')) line.remove_suffix(1);
  if (line.size() <= kColumns) return line;
  const bool is_numbered = (has_cards_ && is_card(line)) || is_point_number(line.substr(kColumns));
  return is_numbered ? line.substr(0, kColumns) : line;
}

void Lexer::take_pieces(Statement& statement, std::string_view text) {
  const bool is_comment = statement.word == Word::comment;
  bool is_continued = strip_line(text, is_comment);
  statement.pieces.push_back(text);
  while (is_continued) {
    if (at_ >= bytes_.size()) {
      statement.is_unterminated = true;
      return;
    }
    std::string_view more = take_line();
    statement.hides_comment = statement.hides_comment || more.starts_with("$$->") || more.starts_with("$$*");
    const bool is_continued_again = strip_line(more, is_comment);
    if (more.empty() && !is_continued_again) continue;  // a comment or an empty line within a statement
    if (!more.empty() && statement.pieces.size() < kMaxArguments) statement.pieces.push_back(more);
    is_continued = is_continued_again;
  }
}

Word Lexer::word_of(std::string_view major) {
  if (major != last_major_) {
    last_major_ = major;
    last_word_ = find_word(major);
  }
  return last_word_;
}

void Lexer::take_words(Statement& statement, std::string_view text) {
  take_pieces(statement, text);
  std::string_view& first = statement.pieces.front();
  const std::string_view all = first;
  statement.major = take_major(first);
  statement.word = word_of(statement.major);
  if (statement.word != Word::unknown && statement.word != Word::part_program) return;
  const std::size_t slash = all.find('/');
  const std::string_view words = trim(all.substr(0, slash));
  const Word word = word_without_blanks(words);
  if (word == Word::unknown || word == statement.word) return;
  statement.major = words;
  statement.word = word;
  first = all.substr(std::min(slash, all.size() - 1) + 1);
}

bool Lexer::next(Statement& statement) {
  statement.clear();
  while (at_ < bytes_.size()) {
    statement.first_byte = at_;
    statement.line = line_;
    std::string_view text = take_line();
    if (text.empty()) continue;
    if (!starts_with_ignoring_case(text, "GO")) text.remove_prefix(label_length(text));
    if (text.starts_with("$$")) {
      statement.major = text.substr(0, 2);
      statement.word = Word::comment;
      text.remove_prefix(2);
      if (text.starts_with("->")) {
        take_pieces(statement, text);
      } else {
        statement.pieces.push_back(text);
      }
    } else if (const std::size_t length = free_text_word_length(text); length > 0) {
      statement.major = text.substr(0, length);
      statement.word = word_without_blanks(statement.major);
      text = trim(text.substr(length));
      if (!text.empty() && text.front() == '/') text = trim(text.substr(1));
      statement.pieces.push_back(text);
    } else {
      take_words(statement, text);
    }
    statement.last_byte = at_;
    return true;
  }
  return false;
}

std::unique_ptr<StatementSource> open_text(std::string_view bytes, std::size_t first_byte, std::size_t line) {
  return std::make_unique<Lexer>(bytes, first_byte, line);
}

}  // namespace gouge
