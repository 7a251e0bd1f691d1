#include "postproc/cldata/lexing/statement_at.h"

#include <string_view>

namespace gouge {

Statement statement_at(const Toolpath& path, std::size_t index, OpenStatements open) {
  const SourceStatement& span = path.statements[index];
  const auto source = open(std::string_view(path.source).substr(0, span.last_byte), span.first_byte, span.line);
  Statement statement;
  bool is_found = source->next(statement);
  while (is_found && statement.first_byte == statement.last_byte) is_found = source->next(statement);
  if (!is_found) statement.pieces.clear();
  return statement;
}

}  // namespace gouge
