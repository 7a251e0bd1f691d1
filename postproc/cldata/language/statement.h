#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "postproc/cldata/language/words.h"

// One statement of CL data, independent of its form in the file: text, pairs of lines, binary records.

namespace gouge {

/// One argument of a statement: a number or a word. Its `text` is a view into the file's bytes, so that a writer knows
/// which bytes to replace. It is empty if a comma follows a comma.
struct Argument {
  std::string_view text;
  std::optional<double> number;
};

/// One logical statement. All views point into the bytes given to its reader.
struct Statement {
  std::size_t line = 0;        ///< physical line on which it begins, counted from 1; in a binary file its record
  std::size_t first_byte = 0;  ///< [first, last): all of its physical lines, with line ends
  std::size_t last_byte = 0;
  Word word = Word::unknown;
  std::string_view major;        ///< as in the file, without blanks around it
  bool is_unterminated = false;  ///< the file ends after a `$`
  bool hides_comment = false;    ///< a comment with data, such as `$$*CATIA0`, is between its lines
  /// The text after the major word, one piece for each physical line, without `$` and comments. A comment has one
  /// piece: the text after `$$`. For `$$->` of Creo that includes its continuation lines.
  std::vector<std::string_view> pieces;
  bool is_decoded = false;          ///< `decoded` holds the arguments; `pieces` has one piece, of text or empty
  std::vector<Argument> decoded;    ///< arguments in a file whose format is not APT text
  bool is_split = false;            ///< `arguments` holds what split_arguments finds
  std::vector<Argument> arguments;  ///< of a statement that was split ahead of its use
  bool has_axes = false;            ///< every position has its axis, independent of MULTAX
  bool is_continuation = false;     ///< its positions continue the path of those in the previous statement

  /// Clears the statement, but keeps its memory.
  void clear() {
    line = first_byte = last_byte = 0;
    word = Word::unknown;
    major = {};
    is_unterminated = hides_comment = is_decoded = is_split = has_axes = is_continuation = false;
    pieces.clear();
    decoded.clear();
  }
};

/// The statements of a file, one after another. The consumer need not know the format of the file.
class StatementSource {
 public:
  StatementSource() = default;
  StatementSource(const StatementSource&) = delete;
  StatementSource& operator=(const StatementSource&) = delete;
  virtual ~StatementSource() = default;

  /// Reads the next statement into `statement`, whose memory is reused. Returns false at the end.
  [[nodiscard]] virtual bool next(Statement& statement) = 0;
};

/// Opens the statements of `bytes`, which must outlive them, from line `line` on, which begins at `first_byte`.
using OpenStatements = std::unique_ptr<StatementSource> (*)(std::string_view bytes, std::size_t first_byte,
                                                            std::size_t line);

}  // namespace gouge
