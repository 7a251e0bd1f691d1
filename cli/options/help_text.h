#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/number_text.h"

namespace CLI {
class FormatterBase;
}

namespace CLI {
class App;
}

namespace gouge {

/// The columns of a help page: names on the left, descriptions on the right, or below the names where there is no room.
class HelpColumns {
 public:
  static constexpr std::size_t kUsual = 80, kMin = 30;

  /// Fits a page to the width of a terminal. A page is never wider than kUsual. 0: the width is not known, and the page has
  /// the usual width.
  explicit HelpColumns(std::size_t terminal = 0) : all_(terminal == 0 ? kUsual : std::clamp(terminal, kMin, kUsual)) {}

  /// Returns the lines of an option or command, where descriptions begin in column `names`.
  [[nodiscard]] std::string row(const std::string& name, const std::string& description, std::size_t names = 30) const;
  [[nodiscard]] std::string paragraph(const std::string& text) const;

 private:
  std::size_t all_;
};

/// Lays out --help in these columns, whatever the length of the texts.
[[nodiscard]] std::shared_ptr<CLI::FormatterBase> make_help_formatter(const HelpColumns& columns);

/// Returns the command line of a parsed command as it can be typed again. It is the command's name, then the given
/// options in the order of its help, quoted for a shell. Options that change no result are left out: outputs, threads,
/// progress, how much is printed, and the words of a report's head. So it is the same for one check however it was
/// started.
[[nodiscard]] std::string repeatable_command(const CLI::App& command);
/// Returns a command line of these words, quoted for a shell where necessary.
[[nodiscard]] std::string repeatable_words(const std::string& command, const std::vector<std::string>& words);

}  // namespace gouge
