#pragma once

#include <cstddef>
#include <string_view>

#include "postproc/cldata/language/statement.h"

// Divides bytes into logical statements. A `$` ends a line and continues the statement on the next one. Two, `$$`,
// begin a comment, except in the text of PPRINT and similar words. Sequence numbers and labels before a known word do
// not belong to it. Numbers of points and cards in columns 73 to 80 do not either. Bytes are not decoded.

namespace gouge {

class Lexer final : public StatementSource {
 public:
  /// `bytes` must outlive the statements.
  explicit Lexer(std::string_view bytes, std::size_t first_byte = 0, std::size_t line = 1);

  /// Reads the next statement that is not blank into `statement`, whose memory is reused. Returns false at the end.
  [[nodiscard]] bool next(Statement& statement) override;

 private:
  [[nodiscard]] std::string_view take_line();
  [[nodiscard]] std::string_view without_columns(std::string_view line) const;
  void take_pieces(Statement& statement, std::string_view text);
  void take_words(Statement& statement, std::string_view text);
  [[nodiscard]] Word word_of(std::string_view major);

  std::string_view bytes_;
  std::size_t at_;
  std::size_t line_;
  bool has_cards_ = false;       // lines are card images
  std::string_view last_major_;  // the last word, because statements often repeat the word of the previous one
  Word last_word_ = Word::unknown;
};

/// Returns a new Lexer.
[[nodiscard]] std::unique_ptr<StatementSource> open_text(std::string_view bytes, std::size_t first_byte,
                                                         std::size_t line);

}  // namespace gouge
