#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/diagnostic.h"

namespace gouge {

/// A line of text as grey values: rows from the top, 0 (nothing) to 255 (covered).
struct TextMask {
  int left = 0,
      top = 0;  ///< position of the first value, in pixels from the pen's first position on the base line, y down
  int width = 0, height = 0;
  std::vector<std::uint8_t> grey;
};

/// The letters of a list of font files. A letter comes from the first file that has it. It is drawn without hinting, so
/// that its shape does not depend on its position. Letters of right-to-left scripts are not reordered, and those of
/// joined scripts are not joined. Text is made printable first (lib/base/printable_text.h). A character that no file
/// has is drawn as a box. May be used from several threads.
class Font {
 public:
  /// Opens the files. Missing files, and files that are not fonts, are ignored.
  Font(const std::vector<std::string>& regular_files, const std::vector<std::string>& bold_files);
  ~Font();
  Font(const Font&) = delete;
  Font& operator=(const Font&) = delete;

  /// Returns why texts that were drawn or measured so far may lack letters: memory ran out, or an existing file cannot
  /// be read. Codes: out-of-memory, file-unreadable.
  [[nodiscard]] std::optional<Diagnostic> trouble() const;

  /// Returns whether any file could be read. Otherwise every letter is a box.
  [[nodiscard]] bool has_letters() const;
  [[nodiscard]] bool has_letter(char32_t letter) const;

  /// Returns the width of the text in units of the size, which is the height of the font's em square.
  [[nodiscard]] double width(std::string_view text, bool is_bold) const;

  /// Returns the text with an em square of `size` pixels; the pen begins at `shift` (0 to 1) pixels. Requires 0 < size
  /// <= 4096.
  [[nodiscard]] TextMask draw(std::string_view text, double size, bool is_bold, double shift) const;

 private:
  class Files;
  std::unique_ptr<Files> files_;
};

/// Returns the fonts of the system: DejaVu Sans, then one with Chinese, Japanese and Korean letters. They are opened in
/// the first call.
[[nodiscard]] const Font& installed_font();

/// Returns one note ("picture-letters") if characters of these texts are drawn as boxes. It has the first of them and
/// the package to install. Returns nothing if all characters are available, or no font is.
[[nodiscard]] Diagnostics find_missing_letters(const std::vector<std::string>& texts,
                                               const Font& font = installed_font());

}  // namespace gouge
