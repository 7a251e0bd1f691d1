#pragma once

#include <optional>
#include <vector>

#include "lib/machine/kinematics.h"
#include "lib/path/toolpath.h"

namespace gouge {

/// A position or move that the machine cannot run as the file states it.
struct JointProblem {
  enum class Kind {
    unreachable,  ///< no angles give the tool axis
    limit,        ///< angles exist, but none within the limits
    flip,         ///< the rotary joints turn by much more than the tool axis
    undecided,    ///< two turns are equally near, so that the control may run either
    unwind        ///< the nearest turn is beyond a limit, so that a joint turns back by a whole turn
  };
  Kind kind = Kind::limit;
  std::size_t move = 0;
  std::size_t joint = 0;  ///< of Machine::joints
  double value = 0;       ///< rad: the angle, or by how much the joint turns; of a linear joint mm
  double limit = 0;       ///< rad or mm: the limit; of a flip the turn of the tool axis
};

struct JointChoice {
  JointPath path;
  std::vector<JointProblem> problems;  ///< in path order
  std::size_t breaks = 0;              ///< moves with a flip, with a joint that turns back, or undecided
};

/// Returns the turn of `angle` within the limits of a rotary joint that is nearest to `to`; none: no turn is within them.
[[nodiscard]] std::optional<double> turn_within_limits(const Joint& joint, double angle, double to);

/// Chooses the rotary angles of a path as a post-processor does. Of both solutions and all turns within the limits it
/// takes those nearest to the angles before. At a pole the first joint stays. If this leads to flips, or to joints that
/// turn back, and another choice for the whole path has fewer of them, it takes that choice (plan_joints). The result
/// `path` is none where no solution is within the limits. Cost O(moves).
///
/// If two solutions are equally near, no angles are chosen until both lead to the same ones. An exception is a machine
/// whose first rotary axis is parallel to the tool axis at rest, and square to the second one. There both solutions move
/// the tool axis alike. The choice goes on with one of them, unless `is_turn_needed` states that more than the axis
/// matters.
[[nodiscard]] JointChoice choose_joints(const Machine& machine, const Toolpath& toolpath, bool is_turn_needed = false);

/// Returns the stated angles of a path, with a problem for each position beyond a limit. Cost O(moves).
[[nodiscard]] JointChoice check_joints(const Machine& machine, const Toolpath& toolpath, const JointPath& stated);

}  // namespace gouge
