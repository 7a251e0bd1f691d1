#include "postproc/cldata/rewriting/change_table.h"

#include <algorithm>

#include "postproc/cldata/language/text.h"

namespace gouge {

std::string_view ReplacedStatements::bytes_of(std::size_t statement) const {
  const SourceStatement& span = path_.statements[statement];
  return std::string_view(path_.source).substr(span.first_byte, span.last_byte - span.first_byte);
}

bool ReplacedStatements::begins_with(std::size_t statement, std::string_view word) const {
  return starts_with_ignoring_case(trim(bytes_of(statement)), word);
}

void ReplacedStatements::append_edits(Edits& edits, std::size_t from, std::size_t to) const {
  const auto first =
      std::lower_bound(path_.statements.begin(), path_.statements.end(), from,
                       [](const SourceStatement& statement, std::size_t byte) { return statement.first_byte < byte; });
  auto next = text_of_.lower_bound(static_cast<std::size_t>(first - path_.statements.begin()));
  for (; next != text_of_.end() && path_.statements[next->first].first_byte < to; ++next) {
    const SourceStatement& span = path_.statements[next->first];
    edits.push_back({span.first_byte, span.last_byte, next->second});
  }
}

}  // namespace gouge
