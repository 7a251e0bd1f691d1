#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// The statements of APT-like text for the mutation law's own reader. It shares no code with the readers of
// the product, and is written from docs/formats alone, so that the two can prove each other wrong.

namespace gouge::laws {

struct LooseArgument {
  std::string text;  ///< upper case, without blanks around it; empty between two commas
  std::optional<double> number;
};

struct LooseStatement {
  std::size_t line = 0;       ///< first physical line, counted from 1
  std::size_t last_line = 0;  ///< last physical line
  std::string word;           ///< upper case without blanks: what stands before the slash, or the whole text
  std::string rest;           ///< upper case: what stands after the slash
  std::string whole;          ///< upper case: the statement without its label
  std::vector<LooseArgument> arguments;
  bool is_comment = false;  ///< `$$`: `rest` is its text
  bool is_text = false;     ///< PPRINT and its like: `rest` is text
  bool is_cut_off = false;  ///< the file ends after a `$`, or data in a comment follow it
};

[[nodiscard]] std::vector<LooseStatement> loose_statements(std::string_view bytes);

[[nodiscard]] std::vector<LooseArgument> loose_arguments(std::string_view text);

/// A number as the formats write it, nothing else.
[[nodiscard]] std::optional<double> loose_number(std::string_view text);

/// Upper case, without blanks.
[[nodiscard]] std::string squeezed(std::string_view text);

/// The physical lines without their ends.
[[nodiscard]] std::vector<std::string_view> physical_lines(std::string_view bytes);

}  // namespace gouge::laws
