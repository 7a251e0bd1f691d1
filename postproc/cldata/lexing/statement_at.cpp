#include "postproc/cldata/lexing/statement_reader.h"

#include <string_view>

namespace gouge {

Statement statement_at(const Toolpath& path, std::size_t index) {
  const SourceStatement& span = path.statements[index];
  const FileForm form = dialect_or_apt(path.dialect).form;
  StatementReader reader(std::string_view(path.source).substr(0, span.last_byte), form, span.first_byte, span.line);
  Statement statement;
  bool is_found = reader.next(statement);
  while (is_found && statement.first_byte == statement.last_byte) is_found = reader.next(statement);
  if (!is_found) statement.pieces.clear();
  return statement;
}

}  // namespace gouge
