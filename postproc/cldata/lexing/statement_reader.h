#pragma once

#include <cstddef>
#include <string_view>

#include "lib/path/toolpath.h"
#include "postproc/cldata/language/dialect.h"
#include "postproc/cldata/language/statement.h"
#include "postproc/cldata/lexing/lexer.h"
#include "postproc/cldata/nccs/nccs_statements.h"
#include "postproc/cldata/nci/nci_statements.h"

// The statements of a file one after another, whatever way its dialect writes them: APT text, the pairs of
// lines of Mastercam NCI, the records of a binary NCCS file. What reads statements need not know which.

namespace gouge {

class StatementReader {
 public:
  /// `bytes` must outlive the statements. `first_byte` is where a statement of text begins, on
  /// line `line`; binary files are read from their start.
  StatementReader(std::string_view bytes, FileForm form, std::size_t first_byte = 0, std::size_t line = 1)
      : form_(form), lexer_(bytes, first_byte, line), nci_(bytes, first_byte, line), nccs_(bytes) {}

  /// The next statement into `statement` (whose memory is used again); false at the end.
  [[nodiscard]] bool next(Statement& statement) {
    if (form_ == FileForm::nci_lines) return nci_.next(statement);
    if (form_ == FileForm::nccs_records) return nccs_.next(statement);
    return lexer_.next(statement);
  }

 private:
  FileForm form_;
  Lexer lexer_;
  NciStatements nci_;
  NccsStatements nccs_;
};

/// Statement `index` of Toolpath::statements, read once more from the path's bytes, into which its views
/// point. Of a pair of lines of Mastercam NCI, which says several statements, the position. Without pieces
/// where there is none.
[[nodiscard]] Statement statement_at(const Toolpath& path, std::size_t index);

}  // namespace gouge
