#include "lib/certify/check_shift.h"

#include <algorithm>

#include "lib/check/check_move.h"
#include "lib/head/check_heads.h"

namespace gouge {
namespace {

constexpr double kHeadShare = 0.02;      // share of the depth at the start to which a head's depth is known on the way
constexpr double kMinStretch_mm = 1e-4;  // length of a shift below which the proof of "not buried" fails

bool is_open(const MoveVerdict& verdict) {
  return verdict.state == MoveState::not_certified || verdict.state == MoveState::not_checked;
}

}  // namespace

class ShiftCheck {
 public:
  ShiftCheck(const Pose& from, const Pose& to, MoveKind kind, const ToolVariants& tool, const MotionChecker& checker)
      : from_(from),
        to_(to),
        length_((to.tip - from.tip).norm()),
        kind_(kind),
        tool_(tool),
        checker_(checker),
        options_(checker.options()) {
    options_.near_miss_mm = 0;
    options_.is_depth_alone = true;
  }

  ShiftHazard run() {
    const double resolution = options_.resolution_mm;
    const MoveVerdict start = checker_.measure(from_, kind_, tool_);
    if (is_open(start)) return ShiftHazard::undecided;
    if (start.state == MoveState::buried) return ShiftHazard::into_solid;
    // A later test decides whether the tool is inside, even if the surface reaches its middle.
    CheckOptions options = options_;
    options.tolerance_mm = start.depth_mm;
    options.gouge_gap_mm = resolution;
    const MoveVerdict way = checker_.check_tool(options_.law.straight(from_, to_), kind_, tool_, options);
    if (is_open(way)) return ShiftHazard::undecided;
    if (way.depth_upper_mm > start.depth_mm + 2 * resolution) return ShiftHazard::deeper;
    if (const ShiftHazard hazard = of_heads(start.depth_mm); hazard != ShiftHazard::none) return hazard;
    if (way.depth_upper_mm < tool_.bare.core_depth_mm) return of_side(to_);
    options_.tolerance_mm = 0;
    return of_sides(0, 1);
  }

 private:
  // Checks the heads. Their search does not resolve the depth of a long motion to the resolution.
  [[nodiscard]] ShiftHazard of_heads(double depth_mm) const {
    if (!checker_.heads_) return ShiftHazard::none;
    CheckOptions options = checker_.options();
    options.near_miss_mm = 0;
    options.tolerance_mm = depth_mm + std::max(options.resolution_mm, kHeadShare * depth_mm);
    MoveVerdict way;
    checker_.charge(checker_.heads_->check(options.law.straight(from_, to_), options, way));
    if (way.state == MoveState::clean) return ShiftHazard::none;
    return way.state == MoveState::gouge    ? ShiftHazard::deeper
           : way.state == MoveState::buried ? ShiftHazard::into_solid
                                            : ShiftHazard::undecided;
  }

  [[nodiscard]] ShiftHazard of_side(const Pose& pose) const {
    return checker_.side_of(pose, tool_) == Side::inside ? ShiftHazard::into_solid : ShiftHazard::none;
  }

  /// Proves "never buried" along a shift, stretch by stretch. If a surface stays inside the tool, the tool is not
  /// buried but gouges. If no surface reaches the middle of the cutter, the cutter stays on one side.
  [[nodiscard]] ShiftHazard of_sides(double t0, double t1) const {
    const double half = 0.5 * (t1 - t0) * length_, t = 0.5 * (t0 + t1);
    const Pose middle{from_.tip + t * (to_.tip - from_.tip), from_.axis};
    const MoveVerdict there = checker_.check_tool(options_.law.at(middle), kind_, tool_, options_);
    if (checker_.is_out_of_budget()) return ShiftHazard::undecided;
    if (there.depth_mm > half) return ShiftHazard::none;
    if (there.depth_upper_mm + half < tool_.bare.core_depth_mm) return of_side(middle);
    if (half < kMinStretch_mm) return ShiftHazard::undecided;
    const ShiftHazard first = of_sides(t0, t);
    return first != ShiftHazard::none ? first : of_sides(t, t1);
  }

  const Pose& from_;
  const Pose& to_;
  double length_;
  MoveKind kind_;
  const ToolVariants& tool_;
  const MotionChecker& checker_;
  CheckOptions options_;
};

ShiftHazard check_shift(const Pose& from, const Pose& to, MoveKind kind, const ToolVariants& tool,
                        const MotionChecker& checker) {
  return ShiftCheck(from, to, kind, tool, checker).run();
}

}  // namespace gouge
