#include "postproc/cldata/lexer.h"

#include "postproc/cldata/arguments.h"
#include "postproc/cldata/text.h"

namespace gouge {
namespace {

constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

// `text` without its comment and without a continuing `$`; tells whether there was one.
bool strip_line(std::string_view& text) {
  const std::size_t dollar = text.find('$');
  if (dollar != std::string_view::npos) {
    const std::size_t comment = text.find("$$", dollar);
    if (comment != std::string_view::npos) text = text.substr(0, comment);
  }
  text = trim(text);
  if (text.empty() || text.back() != '$') return false;
  text.remove_suffix(1);
  text = trim(text);
  return true;
}

// Cuts the major word off `text`: up to the slash, or up to the first blank where a blank delimits it.
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

}  // namespace

Lexer::Lexer(std::string_view bytes, std::size_t first_byte, std::size_t line)
    : bytes_(bytes), at_(first_byte), line_(line) {
  if (at_ == 0 && bytes_.starts_with(kByteOrderMark)) at_ = kByteOrderMark.size();
}

std::string_view Lexer::take_line() {
  const std::size_t end = bytes_.find('\n', at_);
  const std::string_view text = bytes_.substr(at_, end - at_);
  at_ = end == std::string_view::npos ? bytes_.size() : end + 1;
  ++line_;
  return trim(text);
}

void Lexer::take_pieces(Statement& statement, std::string_view text) {
  bool is_continued = strip_line(text);
  statement.pieces.push_back(text);
  while (is_continued) {
    if (at_ >= bytes_.size()) {
      statement.is_unterminated = true;
      return;
    }
    std::string_view more = take_line();
    const bool is_continued_again = strip_line(more);
    if (more.empty() && !is_continued_again) continue;  // a comment or an empty line amid a statement
    if (!more.empty() && statement.pieces.size() < kMostArguments) statement.pieces.push_back(more);
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

bool Lexer::next(Statement& statement) {
  statement.clear();
  while (at_ < bytes_.size()) {
    statement.first_byte = at_;
    statement.line = line_;
    std::string_view text = take_line();
    if (text.empty()) continue;
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
      statement.word = find_word(statement.major);
      text = trim(text.substr(length));
      if (!text.empty() && text.front() == '/') text = trim(text.substr(1));
      statement.pieces.push_back(text);
    } else {
      take_pieces(statement, text);
      statement.major = take_major(statement.pieces.front());
      statement.word = word_of(statement.major);
    }
    statement.last_byte = at_;
    return true;
  }
  return false;
}

}  // namespace gouge
