#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace gouge {

struct HtmlColumn {
  std::string title;
  const char* css = "";  ///< "n": right-aligned numbers; "k": no line breaks
};

/// Returns a cell with escaped text. A long text breaks even in a cell of class "k", so that it pushes no column out.
[[nodiscard]] std::string html_cell(const std::string& text, const char* css = "");

/// A table of rows in pages, of which the first is open. The others are folded and open with a click, without a script.
/// A browser does not lay out a folded page. Rows beyond the last page are counted; CSV and JSON have them.
class HtmlTable {
 public:
  static constexpr std::size_t kRowsOfPage = 200;
  static constexpr std::size_t kMaxRows = 20'000;  ///< about 8 MB

  explicit HtmlTable(std::vector<HtmlColumn> columns) : columns_(std::move(columns)) {}

  /// Returns whether the last page has room for the next row. A row without room must be counted with skip().
  [[nodiscard]] bool has_room() const { return rows_ < kMaxRows; }
  /// Adds a row. Each of its `attributes` has a blank before it.
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
