#pragma once

#include <array>
#include <optional>
#include <string>

#include "lib/certify/motion_checker.h"
#include "lib/contact/contacts.h"

// Strategies that bring one pose out of the surface by moving the tip; the tool axis stays unchanged. Tilts concern
// runs of positions (lib/tilt). A position that no tilt frees is lifted along the axis. A stretch to be trimmed is left
// out (plan_trims.h).

namespace gouge {

enum class Strategy { weighted, axis, tilt, normal, direction, trim };
[[nodiscard]] const char* strategy_name(Strategy strategy);

/// The strategies for gouges of each body.
struct BodyStrategies {
  /// Default strategies, the smallest change that works: a cutter is shifted out of the surface, the bodies above it
  /// are tilted.
  static constexpr Strategy kOfCutter = Strategy::normal;
  std::array<Strategy, 4> of = {kOfCutter, Strategy::tilt, Strategy::tilt, Strategy::tilt};

  Vec3 direction = Vec3::UnitZ();  ///< unit direction for Strategy::direction

  [[nodiscard]] Strategy operator[](Body body) const { return of[static_cast<std::size_t>(body)]; }
  [[nodiscard]] static BodyStrategies all(Strategy strategy) {
    return {{strategy, strategy, strategy, strategy}, Vec3::UnitZ()};
  }
};

struct PoseLimits {
  CorrectionAim aim;             ///< requirements on the corrected pose
  double largest_shift_mm = 20;  ///< maximum shift of the tip; a longer one is not a correction
  int largest_iterations = 60;
  Vec3 direction = Vec3::UnitZ();  ///< unit direction for Strategy::direction
  /// The strategy of the cutter if it shifts. A pose that no tilt freed is shifted by it, or lifted.
  std::optional<Strategy> of_cutter;
};

struct CorrectedPose {
  Pose pose;
  Strategy strategy = Strategy::weighted;
  double shift_mm = 0;
  int iterations = 0;
};

/// Applies the correction of the thesis: repeats a shift by sum(d_i^2 n_i) / sum(d_i) over all contacts (5.3). Here d_i
/// is the excess over half of the aim's margin, so that the mean does not approach its goal in ever smaller steps.
/// Returns nothing if it does not converge within the limits. Source: thesis 5.3, figure 35.
[[nodiscard]] std::optional<CorrectedPose> correct_weighted(const Pose& pose, const ToolVariants& tool,
                                                            const MotionChecker& checker, const PoseLimits& limits);

/// Repeats a shift by the excess of the deepest contact along its normal. On a smooth surface this is the shortest way
/// out. Returns nothing if it does not converge within the limits.
[[nodiscard]] std::optional<CorrectedPose> correct_along_normal(const Pose& pose, const ToolVariants& tool,
                                                                const MotionChecker& checker, const PoseLimits& limits);

/// Returns how much deeper than the aim heads are at a pose; infinite if one is buried or this is not decided.
[[nodiscard]] double head_excess(const Pose& pose, const MotionChecker& checker, const PoseLimits& limits);

/// Lifts the tip along the tool axis to the first place at which tool and heads meet the aim. The excess is the minimum
/// distance that the tool must still move, so a step by it never skips a good position. Returns nothing beyond the
/// limit.
[[nodiscard]] std::optional<CorrectedPose> correct_along_axis(const Pose& pose, const ToolVariants& tool,
                                                              const MotionChecker& checker, const PoseLimits& limits);

/// Does the same along limits.direction.
[[nodiscard]] std::optional<CorrectedPose> correct_along_direction(const Pose& pose, const ToolVariants& tool,
                                                                   const MotionChecker& checker,
                                                                   const PoseLimits& limits);

/// Corrects a pose only by the strategy `wanted`. Returns nothing if it finds no place, if a head stays too deep, or if
/// the strategy is to tilt or to trim.
[[nodiscard]] std::optional<CorrectedPose> correct_as(Strategy wanted, const Pose& pose, const ToolVariants& tool,
                                                      const MotionChecker& checker, const PoseLimits& limits);

/// Returns the result of check_shift in words: why the tool may not be shifted straight from `from` to `to`. Returns
/// null if it may.
[[nodiscard]] const char* why_not_shift(const Pose& from, const Pose& to, MoveKind kind, const ToolVariants& tool,
                                        const MotionChecker& checker);

/// A pose that is freed by a permitted shift, or the reason why there is none.
struct FreedPose {
  std::optional<CorrectedPose> corrected;
  std::string reason;
};

/// Maximum sideways shift, in depths at the pose, if the command line states none.
inline constexpr double kSideShiftsPerDepth = 2;

/// Returns the part of a shift across the tool axis: a shift along the axis stays on the programmed cut.
[[nodiscard]] double side_shift_mm(const Vec3& shift, const Vec3& axis);

/// Corrects a pose by a permitted shift: first by the strategy `wanted`, then along the axis. If `wanted` is to tilt,
/// the pose is lifted along the axis, and then shifted by limits.of_cutter. Where the cutter itself is too deep, the
/// shortest of these shifts is taken.
///
/// `largest_side_mm`: none permits kSideShiftsPerDepth times the depth.
[[nodiscard]] FreedPose free_pose(Strategy wanted, const Pose& pose, double depth_mm, MoveKind kind,
                                  const ToolVariants& tool, const MotionChecker& checker, const PoseLimits& limits,
                                  const std::optional<double>& largest_side_mm);

/// Returns the part of a reason that states which --max-shift would allow a lift that frees a pose, after "; ". Returns
/// an empty text if no lift of up to ten times the limit does.
[[nodiscard]] std::string longer_lift(const Pose& pose, MoveKind kind, const ToolVariants& tool,
                                      const MotionChecker& checker, const PoseLimits& limits);

/// Returns "--max-shift 20 mm", the limit as reasons name it.
[[nodiscard]] std::string max_shift_text(double max_shift_mm);

}  // namespace gouge
