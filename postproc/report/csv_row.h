#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>

#include "lib/base/number_text.h"

namespace gouge {

/// Returns a text from a file in a form that is safe in a spreadsheet, because its author may be a stranger. A possible
/// formula gets an apostrophe before it (docs/formats/csv.md).
[[nodiscard]] std::string without_formula(std::string_view text);

/// A writer of one row of RFC 4180 that appends it to a text.
class CsvRow {
 public:
  explicit CsvRow(std::string& out) : out_(out) {}
  ~CsvRow() { out_ += '\n'; }
  CsvRow(const CsvRow&) = delete;
  CsvRow& operator=(const CsvRow&) = delete;

  /// Adds a word of this program, which needs no quotes.
  void word(std::string_view value) {
    begin_cell();
    out_ += value;
  }
  void text(std::string_view value) {
    if (value.find_first_of(",\"\r\n") == std::string_view::npos) return word(value);
    begin_cell();
    out_ += '"';
    for (const char c : value) {
      out_ += c;
      if (c == '"') out_ += '"';
    }
    out_ += '"';
  }
  // Adds a number. A bound that was never reached is not finite, and its cell stays empty.
  void number(double value) { std::isfinite(value) ? word(exact_text(value)) : word({}); }
  void count(std::size_t value) {
    std::array<char, 24> digits{};
    const char* const end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    word({digits.data(), static_cast<std::size_t>(end - digits.data())});
  }
  void empty(int count) {
    for (int i = 0; i < count; ++i) word({});
  }

 private:
  void begin_cell() {
    if (!is_first_) out_ += ',';
    is_first_ = false;
  }

  std::string& out_;
  bool is_first_ = true;
};

}  // namespace gouge
