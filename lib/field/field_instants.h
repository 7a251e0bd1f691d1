#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "lib/field/checked_toolpath.h"
#include "lib/motion/motion.h"

namespace gouge {

/// The instants at which a field samples a gouging move.
struct FieldInstants {
  std::size_t move = 0;
  std::vector<double> t;  ///< the instant of the witness comes first
};

/// Picks about `most` instants that show how deep a path gouges. The function `wanted` returns the number of steps at
/// which a move is shown as well as can be seen. If the total is too large, every move gets fewer steps. Finally only
/// the worst move of each group of neighbours is examined.
[[nodiscard]] std::vector<FieldInstants> pick_instants(
    const CheckedToolpath& input, std::size_t most,
    const std::function<std::size_t(const Motion& motion, std::size_t move)>& wanted);

/// Returns the motions that a field samples for a move: those that its law states, and that of the witness.
[[nodiscard]] std::vector<Motion> shown_motions(const Motion& motion, const Boxed<Witness>& witness);

/// Returns the length of the tip's path.
[[nodiscard]] double path_length_mm(const Motion& motion);

}  // namespace gouge
