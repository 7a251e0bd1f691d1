#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "lib/field/checked_toolpath.h"
#include "lib/motion/motion.h"

namespace gouge {

/// Instants at which a field samples a gouging move.
struct FieldInstants {
  std::size_t move = 0;
  std::vector<double> t;  ///< that of the witness first
};

/// Picks the instants that show how deep a path gouges, about `most` of them. The function `wanted` returns how many
/// steps show a move as well as can be seen. Where these are too many in all, every move gets fewer. At last only the
/// worst move of each group of neighbours is examined.
[[nodiscard]] std::vector<FieldInstants> pick_instants(
    const CheckedToolpath& input, std::size_t most,
    const std::function<std::size_t(const Motion& motion, std::size_t move)>& wanted);

/// Returns how far the tip goes.
[[nodiscard]] double path_length_mm(const Motion& motion);

}  // namespace gouge
