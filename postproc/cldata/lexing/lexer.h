#pragma once

#include <cstddef>
#include <string_view>

#include "postproc/cldata/language/statement.h"

// Bytes to logical statements. A `$` ends a line and continues the statement on the next one. Two, `$$`, begin a
// comment, except that the text of PPRINT and its like is taken as it stands. Sequence numbers and labels before a
// known word do not belong to it. Nor do the numbers of points and of cards in columns 73 to 80. Bytes are not decoded.

namespace gouge {

class Lexer final : public StatementSource {
 public:
  /// `bytes` must outlive the statements.
  explicit Lexer(std::string_view bytes, std::size_t first_byte = 0, std::size_t line = 1);

  /// Reads the next statement that is not blank into `statement` (whose memory is used again); false at the end.
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
  std::string_view last_major_;  // statements repeat the word of the one before them
  Word last_word_ = Word::unknown;
};

/// Returns a Lexer of its own.
[[nodiscard]] std::unique_ptr<StatementSource> open_text(std::string_view bytes, std::size_t first_byte,
                                                         std::size_t line);

}  // namespace gouge
