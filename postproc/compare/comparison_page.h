#pragma once

#include <string>
#include <string_view>

#include "lib/base/exit_code.h"

// Parts of the pages of comparisons.

namespace gouge {

/// Returns the page up to its heading. The `title` is escaped; `style` is added to that of reports.
[[nodiscard]] std::string comparison_page_begin(const std::string& title, std::string_view style);
/// Returns the banner: whether the new run is worse, and the `counts`, which are escaped.
[[nodiscard]] std::string comparison_banner(ExitCode status, const std::string& counts);
/// Returns a box with a number of the row of numbers. Only a number above 0 has the colour of the class `css`.
[[nodiscard]] std::string comparison_number(std::size_t count, const std::string& title, const std::string& css);
[[nodiscard]] std::string comparison_page_end();

}  // namespace gouge
