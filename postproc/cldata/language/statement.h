#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "postproc/cldata/language/words.h"

// One statement of CL data, whatever way its file writes it: text, pairs of lines, binary records.

namespace gouge {

/// One argument of a statement: a number or a word. Its `text` is a view into the file's bytes, so that a writer knows
/// which bytes to replace. It is empty where a comma follows a comma.
struct Argument {
  std::string_view text;
  std::optional<double> number;
};

/// One logical statement. All views are into the bytes given to its reader.
struct Statement {
  std::size_t line = 0;        ///< physical line it begins on, counted from 1; of a binary file the record
  std::size_t first_byte = 0;  ///< [first, last): its physical lines whole, line ends included
  std::size_t last_byte = 0;
  Word word = Word::unknown;
  std::string_view major;        ///< as written, without blanks around it
  bool is_unterminated = false;  ///< the file ends after a `$`
  bool hides_comment = false;    ///< a comment with data, such as `$$*CATIA0`, stands between its lines
  /// The text after the major word, one piece for each physical line, without `$` and comments. A comment has
  /// one piece: what follows `$$` (and for Creo's `$$->`, its continuation lines).
  std::vector<std::string_view> pieces;
  bool is_decoded = false;        ///< `decoded` holds the arguments; `pieces` has one piece, of text or empty
  std::vector<Argument> decoded;  ///< arguments of a file that does not write them as APT text
  bool has_axes = false;          ///< every position has its axis, whatever MULTAX states
  bool is_continuation = false;   ///< its positions continue the path of those of the statement before

  /// As new, with the memory it has.
  void clear() {
    line = first_byte = last_byte = 0;
    word = Word::unknown;
    major = {};
    is_unterminated = hides_comment = is_decoded = has_axes = is_continuation = false;
    pieces.clear();
    decoded.clear();
  }
};

/// The statements of a file one after another, independent of the format. The consumer need not know the format.
class StatementSource {
 public:
  StatementSource() = default;
  StatementSource(const StatementSource&) = delete;
  StatementSource& operator=(const StatementSource&) = delete;
  virtual ~StatementSource() = default;

  /// Reads the next statement into `statement` (whose memory is used again); false at the end.
  [[nodiscard]] virtual bool next(Statement& statement) = 0;
};

/// The statements of `bytes`, which must outlive them, from that of line `line` on, which begins at `first_byte`.
using OpenStatements = std::unique_ptr<StatementSource> (*)(std::string_view bytes, std::size_t first_byte,
                                                            std::size_t line);

}  // namespace gouge
