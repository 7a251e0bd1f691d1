#pragma once

#include <optional>
#include <string>
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
    unwind,       ///< the nearest turn is beyond a limit, so that a joint turns back by a whole turn
    in_plane      ///< the linear joints lie nearly in one plane, so that their values are not determined
  };
  Kind kind = Kind::limit;
  std::size_t move = 0;
  std::size_t joint = 0;  ///< of Machine::joints
  double value = 0;       ///< rad: the angle, or by how much the joint turns; of a linear joint mm
  double limit = 0;       ///< rad or mm: the limit; of a flip the turn of the tool axis
};

/// Returns a value of a joint as text: "31 degrees", "250 mm".
[[nodiscard]] std::string joint_value_text(const Joint& joint, double value, int decimals = 3);
/// Returns a problem of one position as text: "joint A would be at 31 degrees; its limit is 30 degrees". Requires a
/// kind of a position: unreachable, limit, undecided or in_plane.
[[nodiscard]] std::string problem_text(const Machine& machine, const JointProblem& problem);

struct JointChoice {
  JointPath path;
  std::vector<JointProblem> problems;  ///< in path order
  std::size_t breaks = 0;              ///< moves with a flip, with a joint that turns back, or undecided
};

/// Returns the turn of `angle` within the limits of a rotary joint that is nearest to `to`; none: no turn is within them.
[[nodiscard]] std::optional<double> turn_within_limits(const Joint& joint, double angle, double to);

/// Angles of a tool axis within the limits.
struct NearAngles {
  std::optional<RotaryAngles> best, other;  ///< those that turn least, and those of the other solution
};

/// Returns the angles of `solutions` that are nearest to `from`. If `is_first`, there are no angles before, and the
/// preferred sign of a joint decides.
[[nodiscard]] NearAngles angles_near(const Machine& machine, const RotarySolutions& solutions, const RotaryAngles& from,
                                     bool is_first);
/// Returns the rotary joint, 0 or 1, that may as well turn otherwise: half a turn either way, or to the other solution.
/// None: the nearest turn is unique, even if angles are wrong by `same_rad`. Requires near.best.
[[nodiscard]] std::optional<std::size_t> undecided_joint(const Machine& machine, const NearAngles& near,
                                                         const RotaryAngles& from, double same_rad);
/// Returns the limit that prevents all solutions. It is the one that is exceeded least.
[[nodiscard]] JointProblem exceeded_limit(const Machine& machine, const RotarySolutions& solutions,
                                          const RotaryAngles& from, std::size_t move);

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
