#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "lib/machine/joint_path.h"

namespace gouge {

struct LinearLimits {
  std::vector<JointProblem> problems;  ///< kind `limit` in mm, or `in_plane`; in path order
  /// Joints of Machine::joints whose limits are not checked. Their values depend on the tool length or on the point of a rotary
  /// joint, which is not known.
  std::vector<std::size_t> open;
};

/// Compares the linear joints of a machine with their limits, a position at a time.
class LinearLimitTest {
 public:
  explicit LinearLimitTest(const Machine& machine);

  /// Returns whether a joint has limits that can be compared.
  [[nodiscard]] bool is_any() const { return is_any_; }
  /// Adds what it finds at the end of a move. `length_mm`: from the gauge point to the tip; none: it is not known.
  void examine(std::size_t move, const Vec3& tip, const RotaryAngles& angles, const std::optional<double>& length_mm,
               LinearLimits& limits) const;

 private:
  Machine machine_;
  std::vector<Machine> others_;  // machines that differ in a fact that is not known
  bool is_any_ = false;
};

/// Compares the linear joints at the positions of a path with their limits. Between positions they are not compared.
/// `tool_length_mm`: from the gauge point to the tip, as in gauge_length_of_move. Requires Toolpath::joints. Without Machine::is_placed there are no
/// problems, as the values then count from the part zero.
[[nodiscard]] LinearLimits check_linear_limits(const Machine& machine, const Toolpath& path,
                                               const std::optional<double>& tool_length_mm);

}  // namespace gouge
