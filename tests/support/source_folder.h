#pragma once

#include <string>

namespace gouge {

// The folder of the checkout, without a slash at its end.
// In a source of its own: the name on every test's command line would keep ccache from serving two checkouts.
[[nodiscard]] std::string source_folder();

}  // namespace gouge
