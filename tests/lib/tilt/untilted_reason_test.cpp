// The reason why no tilt frees a run: its numbers are those of geometry and of checks.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>

#include "tests/lib/tilt/tilt_bench.h"

namespace gouge::untilted_reason_test {
namespace {

using namespace tilt_bench;

/// The numbers of a message.
struct Told {
  std::size_t line = 0;
  double missing_mm = 0;
  double free_deg = 0;  ///< 0: not stated
};

Told told_by(const TiltPlan& plan) {
  if (plan.failed.size() != 1) return {};
  const std::string& text = plan.failed[0].reason;
  std::smatch found;
  Told told;
  if (std::regex_search(text, found,
                        std::regex("frees line (\\d+): at the best one looked at the holder is ([0-9.]+)")))
    told = {std::stoul(found[1]), std::stod(found[2]), 0};
  EXPECT_GT(told.line, 0U) << text;
  if (std::regex_search(text, found, std::regex("; ([0-9.]+) degrees would free it")))
    told.free_deg = std::stod(found[1]);
  return told;
}

/// Depth of the holder in a wall at a distance of the ball's centre, tilted away from it. The deepest point of the wall
/// is as far from the side of the holder as from its lower end.
double depth_at(double distance_mm, double tilt_rad) {
  const double sine = std::sin(tilt_rad), cosine = std::cos(tilt_rad);
  return (15 * cosine - 35 * sine - distance_mm) / (cosine + sine);
}

TiltOptions up_to(double tilt_rad) {
  TiltOptions options;
  options.max_tilt_rad = tilt_rad;
  return options;
}

/// A wall that comes nearer from y = 4 to y = 16: there the holder is deepest.
Bench beside_step() {
  return {row(-60, 60, 4),
          {floor_plate(), shapes::box(Vec3(14, -30, -5), Vec3(60, 30, 90)),
           shapes::box(Vec3(13, 4, -5), Vec3(60, 16, 90))}};
}

TEST(UntiltedReason, HasTheDistanceAtTheWorstPositionOfTheRun) {
  const Bench bench = beside_step();
  double before = 10;
  for (const double tilt_deg : {0.3, 1.0, 1.7, 2.4, 3.0}) {
    const Told told = told_by(bench.plan(up_to(tilt_deg * kDegree)));
    EXPECT_NEAR(told.missing_mm, depth_at(13, tilt_deg * kDegree), 0.002) << tilt_deg;
    EXPECT_LT(told.missing_mm, before);
    before = told.missing_mm;
    const auto at =
        std::ranges::find(bench.path.moves, told.line, [](const Move& move) { return std::size_t{move.line}; });
    ASSERT_NE(at, bench.path.moves.end());
    EXPECT_GE(at->end.tip.y(), 4 - 15);
    EXPECT_LE(at->end.tip.y() - 4, 16 + 15) << "a move of 4 mm";
  }
}

TEST(UntiltedReason, StatesNoLessThanACheckFindsAtTheBestTilt) {
  const Bench bench = beside_step();
  for (const double tilt_deg : {0.5, 1.3, 2.9}) {
    const Told told = told_by(bench.plan(up_to(tilt_deg * kDegree)));
    const double tilt = tilt_deg * kDegree;
    // About the centre of the ball, away from the wall, where the wall is nearest.
    const Vec3 axis(-std::sin(tilt), 0, std::cos(tilt));
    const Toolpath path = paths::through({{Vec3(0, 10, 5) - 5 * axis, axis}});
    const CheckResult found = check(path, bench.own.setup);
    ASSERT_EQ(found.verdicts[0].state, MoveState::gouge);
    EXPECT_GE(told.missing_mm, found.verdicts[0].depth_mm) << tilt_deg;
  }
}

TEST(UntiltedReason, OfAConeIsThatOfItsAngle) {
  const Bench bench = beside_step();
  for (const double tilt_deg : {0.6, 1.9}) {
    TiltOptions options;
    options.cone = AxisCone{Vec3::UnitZ(), tilt_deg * kDegree};
    const TiltPlan plan = bench.plan(options);
    EXPECT_NEAR(told_by(plan).missing_mm, depth_at(13, tilt_deg * kDegree), 0.002) << tilt_deg;
    EXPECT_NE(plan.failed[0].reason.find(" degrees would free it, outside --axis-cone"), std::string::npos)
        << plan.failed[0].reason;
  }
}

TEST(UntiltedReason, NamesAnAngleThatSuffices) {
  const Bench bench = beside_step();
  const double needed_deg = min_tilt(13) / kDegree;
  const Told told = told_by(bench.plan(up_to(1 * kDegree)));
  EXPECT_GE(told.free_deg, needed_deg);
  EXPECT_LE(told.free_deg, needed_deg + 0.05);
  EXPECT_TRUE(bench.plan(up_to(told.free_deg * kDegree)).failed.empty());
}

TEST(UntiltedReason, OfAWellNamesNoAngle) {
  const std::vector<IndexedMesh> well{floor_plate(), shapes::box(Vec3(10, -60, -5), Vec3(60, 60, 200)),
                                      shapes::box(Vec3(-60, -60, -5), Vec3(-10, 60, 200)),
                                      shapes::box(Vec3(-10, 10, -5), Vec3(10, 60, 200)),
                                      shapes::box(Vec3(-10, -60, -5), Vec3(10, -10, 200))};
  const Bench bench({upright(0, 0, 220), upright(0, 0, 0), upright(0, 0, 220)}, well);
  const TiltPlan plan = bench.plan();
  ASSERT_EQ(plan.failed.size(), 1U);
  EXPECT_EQ(plan.failed[0].reason.find("would free it"), std::string::npos) << plan.failed[0].reason;
}

/// A machine whose joint T is the angle of the axis to Z, up to a limit, and which leans to one side only.
class OneJoint : public PoseReach {
 public:
  explicit OneJoint(double limit_rad, double min_y = -1) : limit_rad_(limit_rad), min_y_(min_y) {}
  [[nodiscard]] bool can_reach(std::size_t /*move*/, const Vec3& /*programmed*/, const Pose& pose) const override {
    return std::acos(std::min(1.0, pose.axis.z())) <= limit_rad_ && pose.axis.y() >= min_y_;
  }
  [[nodiscard]] std::string why_not(std::size_t move, const Vec3& programmed, const Pose& pose) const override {
    return can_reach(move, programmed, pose) ? "" : "joint T would be beyond its limit";
  }

 private:
  double limit_rad_, min_y_;
};

TEST(UntiltedReason, NamesTheJointOfTheMachine) {
  const Bench bench = beside_step();
  TiltOptions options;
  options.reach = std::make_shared<OneJoint>(1.5 * kDegree);
  const TiltPlan plan = bench.plan(options);
  EXPECT_NEAR(told_by(plan).missing_mm, depth_at(13, 1.5 * kDegree), 0.002);
  const std::string& reason = plan.failed.at(0).reason;
  EXPECT_NE(reason.find("within --max-tilt 30 degrees and the limits of the machine's joints"), std::string::npos)
      << reason;
  EXPECT_NE(reason.find(" degrees would free it, but joint T would be beyond its limit"), std::string::npos) << reason;
}

TEST(Reach, OfTheMachineIsKeptByAllTilts) {
  const Bench bench = beside_step();
  TiltOptions options;
  const auto check_with = [&](const OneJoint& reach) {
    options.reach = std::make_shared<OneJoint>(reach);
    const TiltPlan plan = bench.plan(options);
    expect_clean(bench, plan);
    for (const TiltedPosition& p : positions_of(plan)) EXPECT_TRUE(reach.can_reach(0, Vec3::UnitZ(), p.pose));
  };
  check_with(OneJoint(min_tilt(13) + 0.1 * kDegree));
  // The tool leans away from the wall and forward.
  check_with(OneJoint(1, 0));
}

}  // namespace
}  // namespace gouge::untilted_reason_test
