#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace gouge {

struct HtmlColumn {
  std::string title;
  const char* css = "";  ///< "n": numbers, to the right; "k": never broken
};

/// A cell with escaped text.
[[nodiscard]] std::string html_cell(const std::string& text, const char* css = "");

/// A table of rows, the first page of it open. The others fold away and open with a click, without a script; a page
/// that is folded costs a browser nothing to lay out. Rows beyond the last page are counted and left to CSV and JSON.
class HtmlTable {
 public:
  static constexpr std::size_t kRowsOfPage = 200;
  static constexpr std::size_t kMostRows = 20'000;  ///< about 8 MB

  explicit HtmlTable(std::vector<HtmlColumn> columns) : columns_(std::move(columns)) {}

  /// Whether the next row still has a page; what is not wanted need not be made, but must be counted by skip().
  [[nodiscard]] bool has_room() const { return rows_ < kMostRows; }
  /// `attributes`: of the row, each with a blank before it.
  void add(const std::string& cells, const std::string& attributes = {});
  void skip() { ++skipped_; }

  [[nodiscard]] std::string html() const;

 private:
  [[nodiscard]] std::string table(const std::string& rows) const;

  std::vector<HtmlColumn> columns_;
  std::vector<std::string> pages_;
  std::size_t rows_ = 0, skipped_ = 0;
};

}  // namespace gouge
