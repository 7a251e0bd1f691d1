#pragma once

#include <string>

namespace gouge {

// Returns the folder of the checkout, without a slash at its end. The function has a source file of its own. If the
// path were on the command line of every test, ccache could not serve two checkouts.
[[nodiscard]] std::string source_folder();

}  // namespace gouge
