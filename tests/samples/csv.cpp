#include "tests/samples/csv.h"

namespace gouge::testing_samples {

std::vector<std::vector<std::string>> parse_csv(const std::string& text) {
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> row;
  std::string field;
  bool is_quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (is_quoted) {
      if (c != '"') {
        field += c;
      } else if (i + 1 < text.size() && text[i + 1] == '"') {
        field += text[++i];
      } else {
        is_quoted = false;
      }
    } else if (c == '"') {
      is_quoted = true;
    } else if (c == ',' || c == '\n') {
      row.push_back(field);
      field.clear();
      if (c == '\n') {
        rows.push_back(row);
        row.clear();
      }
    } else {
      field += c;
    }
  }
  return rows;
}

std::vector<MoveRow> parse_moves(const std::string& csv) {
  if (csv.rfind(kCsvHeader, 0) != 0) return {};
  std::vector<MoveRow> moves;
  for (const auto& row : parse_csv(csv)) {
    if (row.size() < 16 || row[0] == "move") continue;
    moves.push_back(
        {std::stoul(row[0]), std::stoul(row[1]), row[2], row[3], row[4], row[5], row[6], row[7], row[8], row[9]});
  }
  return moves;
}

}  // namespace gouge::testing_samples
