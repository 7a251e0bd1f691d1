#pragma once

namespace gouge {

[[nodiscard]] inline bool is_klartext_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace gouge
