#pragma once

#include <optional>

#include "lib/check/motion.h"

namespace gouge {

/// The motion of a move of `toolpath`, along its arc or spline where it has one; rapids in the mode asked
/// for.
[[nodiscard]] Motion motion_of(const Toolpath& toolpath, std::size_t move, RapidMode rapid);

/// The straight motion to a position alone from where the tool was before it (Move::is_linked); nothing where the path
/// has no link there. It is not what the file says; that it is clean is what the check asks of it.
[[nodiscard]] std::optional<Motion> link_of(const Toolpath& toolpath, std::size_t index);

}  // namespace gouge
