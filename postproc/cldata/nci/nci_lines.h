#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "postproc/cldata/language/statement.h"
#include "postproc/cldata/language/text.h"

// The container of Mastercam NCI files: pairs of lines, first a code alone, then its parameters separated by
// blanks.

namespace gouge {

struct NciPair {
  std::size_t line = 0;  ///< of the code
  std::size_t first_byte = 0, last_byte = 0;
  std::optional<int> code;      ///< nothing where the line is not one whole number
  std::string_view code_text;   ///< its line, trimmed
  std::string_view parameters;  ///< trimmed
  bool is_whole = false;        ///< the file does not end between code and parameters
};

class NciLines {
 public:
  NciLines(std::string_view bytes, std::size_t first_byte, std::size_t line)
      : bytes_(bytes), at_(first_byte), line_(line) {
    if (at_ == 0 && bytes_.starts_with(kByteOrderMark)) at_ = kByteOrderMark.size();
  }

  [[nodiscard]] bool next(NciPair& pair);

 private:
  [[nodiscard]] bool take_line(std::string_view& text);

  std::string_view bytes_;
  std::size_t at_;
  std::size_t line_;
};

/// The fields of a line of parameters into `fields` (whose memory is used again). Blanks alone separate them:
/// a comma makes a field no number. Stops at a hundred, of which none but the first twenty mean anything
/// here.
void split_nci_fields(std::string_view parameters, std::vector<Argument>& fields);

/// True where the first pairs of lines are codes and parameters, with a motion among them.
[[nodiscard]] bool is_nci(std::string_view bytes);

}  // namespace gouge
