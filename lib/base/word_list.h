#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace gouge {

/// "a, b and c" with `last` = " and ".
[[nodiscard]] std::string listed(const std::vector<std::string>& words, std::string_view last = ", ");

}  // namespace gouge
