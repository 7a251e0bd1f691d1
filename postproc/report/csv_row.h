#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>

#include "lib/base/number_text.h"

namespace gouge {

/// Returns text from a file, which a stranger may have written for the spreadsheet that opens ours. Puts an apostrophe
/// in front of a possible formula (docs/formats/csv.md).
[[nodiscard]] std::string without_formula(std::string_view text);

/// Appends one row of RFC 4180 to a text.
class CsvRow {
 public:
  explicit CsvRow(std::string& out) : out_(out) {}
  ~CsvRow() { out_ += '\n'; }
  CsvRow(const CsvRow&) = delete;
  CsvRow& operator=(const CsvRow&) = delete;

  /// A word of our own, which needs no quotes.
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
  // A bound that was never reached is not a number, and a row cannot state it.
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
