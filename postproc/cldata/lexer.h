#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "postproc/cldata/words.h"

// Bytes to logical statements. A `$` that ends a line continues the statement on the next one; `$$` begins a
// comment, except that the text of PPRINT and its like is taken as it stands. Bytes are not decoded.

namespace gouge {

/// One logical statement. All views are into the bytes given to the lexer.
struct Statement {
  std::size_t line = 0;        ///< physical line it begins on, counted from 1
  std::size_t first_byte = 0;  ///< [first, last): its physical lines whole, line ends included
  std::size_t last_byte = 0;
  Word word = Word::unknown;
  std::string_view major;        ///< as written, without blanks around it
  bool is_unterminated = false;  ///< the file ends after a `$`
  /// What follows the major word, one piece for each physical line, without `$` and comments. A comment has
  /// one piece: what follows `$$` (and for Creo's `$$->`, its continuation lines).
  std::vector<std::string_view> pieces;
};

class Lexer {
 public:
  /// `bytes` must outlive the statements.
  explicit Lexer(std::string_view bytes, std::size_t first_byte = 0, std::size_t line = 1);

  /// The next statement that is not blank, into `statement` (whose memory is used again); false at the end.
  [[nodiscard]] bool next(Statement& statement);

 private:
  [[nodiscard]] std::string_view take_line();
  void take_pieces(Statement& statement, std::string_view text);

  std::string_view bytes_;
  std::size_t at_;
  std::size_t line_;
};

}  // namespace gouge
