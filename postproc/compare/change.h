#pragma once

#include <cstddef>

namespace gouge {

/// Change of a finding from one run to another.
enum class Change { fresh, deeper, not_checked, gone, shallower, same };
inline constexpr std::size_t kChanges = 6;
/// Returns "new", "deeper", "not-checked-any-more", "gone", "shallower" or "same".
[[nodiscard]] const char* change_name(Change change);

}  // namespace gouge
