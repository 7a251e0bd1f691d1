#pragma once

#include <array>
#include <optional>
#include <string>

#include "lib/certify/motion_checker.h"
#include "lib/contact/contacts.h"

// Strategies that bring one pose out of the surface by moving the tip; the tool axis stays as it is. Tilts are of runs
// of positions (lib/tilt); a position that no tilt frees is lifted along the axis. A trimmed stretch is left out
// (plan_trims.h).

namespace gouge {

enum class Strategy { weighted, axis, tilt, normal, direction, trim };
[[nodiscard]] const char* strategy_name(Strategy strategy);

/// Strategies for gouges of each body.
struct BodyStrategies {
  /// The least change that works: a cutter is shifted out of the surface, and the bodies above it are tilted away.
  static constexpr Strategy kOfCutter = Strategy::normal;
  std::array<Strategy, 4> of = {kOfCutter, Strategy::tilt, Strategy::tilt, Strategy::tilt};

  Vec3 direction = Vec3::UnitZ();  ///< of Strategy::direction, unit

  [[nodiscard]] Strategy operator[](Body body) const { return of[static_cast<std::size_t>(body)]; }
  [[nodiscard]] static BodyStrategies all(Strategy strategy) {
    return {{strategy, strategy, strategy, strategy}, Vec3::UnitZ()};
  }
};

struct PoseLimits {
  CorrectionAim aim;             ///< requirements at the end
  double largest_shift_mm = 20;  ///< a tip further from where it was is not a correction
  int largest_iterations = 60;
  Vec3 direction = Vec3::UnitZ();  ///< of Strategy::direction, unit
};

struct CorrectedPose {
  Pose pose;
  Strategy strategy = Strategy::weighted;
  double shift_mm = 0;
  int iterations = 0;
};

/// Applies the thesis's correction: a shift by sum(d_i^2 n_i) / sum(d_i) over all contacts, again and again (5.3). Here
/// d_i is the excess over half of the aim's margin, so that the mean does not creep towards its goal forever. Returns
/// nothing when it does not converge within the limits. Source thesis 5.3, figure 35.
[[nodiscard]] std::optional<CorrectedPose> correct_weighted(const Pose& pose, const ToolVariants& tool,
                                                            const MotionChecker& checker, const PoseLimits& limits);

/// Shifts by the excess of the deepest contact along its normal, again and again: on a smooth surface the shortest way
/// out. Nothing when it does not converge within the limits.
[[nodiscard]] std::optional<CorrectedPose> correct_along_normal(const Pose& pose, const ToolVariants& tool,
                                                                const MotionChecker& checker, const PoseLimits& limits);

/// Returns how much deeper than the aim heads are at a pose; infinite when one is buried or that is not decided.
[[nodiscard]] double head_excess(const Pose& pose, const MotionChecker& checker, const PoseLimits& limits);

/// Lifts the tip along the tool axis to the first place where tool and heads meet the aim. The excess is the minimum
/// distance that the tool must still move, so a step by it never passes a good position. Returns nothing beyond the
/// limit.
[[nodiscard]] std::optional<CorrectedPose> correct_along_axis(const Pose& pose, const ToolVariants& tool,
                                                              const MotionChecker& checker, const PoseLimits& limits);

/// Returns the same along limits.direction.
[[nodiscard]] std::optional<CorrectedPose> correct_along_direction(const Pose& pose, const ToolVariants& tool,
                                                                   const MotionChecker& checker,
                                                                   const PoseLimits& limits);

/// Corrects by `wanted` alone. Nothing where it finds no place, or leaves a head too deep, or is to tilt or to trim.
[[nodiscard]] std::optional<CorrectedPose> correct_as(Strategy wanted, const Pose& pose, const ToolVariants& tool,
                                                      const MotionChecker& checker, const PoseLimits& limits);

/// Returns check_shift in words: why the tool may not be shifted straight from `from` to `to`; null where it may.
[[nodiscard]] const char* why_not_shift(const Pose& from, const Pose& to, MoveKind kind, const ToolVariants& tool,
                                        const MotionChecker& checker);

/// A pose freed by a shift that may be made, or the reason there is none.
struct FreedPose {
  std::optional<CorrectedPose> corrected;
  const char* reason = nullptr;
};

/// The largest sideways shift where the command line names none: this many times the depth at the pose.
inline constexpr double kSideShiftsPerDepth = 2;

/// Returns how far a shift leads away from the tool axis: along the axis the tool keeps to the programmed cut.
[[nodiscard]] double side_shift_mm(const Vec3& shift, const Vec3& axis);

/// Does correct_as under the laws of a shift: `wanted` first, then along the axis.
///
/// `largest_side_mm`: none allows kSideShiftsPerDepth times the depth.
[[nodiscard]] FreedPose free_pose(Strategy wanted, const Pose& pose, double depth_mm, MoveKind kind,
                                  const ToolVariants& tool, const MotionChecker& checker, const PoseLimits& limits,
                                  const std::optional<double>& largest_side_mm);

}  // namespace gouge
