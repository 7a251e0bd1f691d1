#include "lib/machine/rotary_law.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/lib/machine/machines.h"
#include "tests/support/scatter.h"

// The path of the tool axis of two rotary joints, against the machine's own formula.

namespace gouge::rotary_law_test {
namespace {

/// A path of one move with these angles at its ends.
Toolpath path_with(const RotaryAngles& from, const RotaryAngles& to) {
  Toolpath path;
  path.moves.resize(1);
  path.joints = std::make_shared<const JointPath>(JointPath{{from}, {to}});
  return path;
}

TEST(RotaryLaw, RunsEvenlyBetweenTheNearestAngles) {
  test::Scatter scatter(11);
  for (const Machine& machine : test::machines()) {
    const RotaryLaw law(machine);
    for (int n = 0; n < 5000; ++n) {
      const RotaryAngles from = {scatter.in(-3, 3), scatter.in(-1.5, 1.5)};
      const RotaryAngles to = {from[0] + scatter.in(-0.3, 0.3), from[1] + scatter.in(-0.3, 0.3)};
      const Vec3 a = tool_axes(machine, from).col(2), b = tool_axes(machine, to).col(2);
      const auto path = law.between({Vec3::Zero(), a}, {Vec3::Zero(), b});
      ASSERT_NE(path, nullptr);
      ASSERT_LT((path->axes_at(0).col(2) - a).norm(), 1e-9) << machine.name;
      ASSERT_LT((path->axes_at(1).col(2) - b).norm(), 1e-9) << machine.name;
      // Near the rim of a cone another pair of solutions may be nearer; never is a farther one taken.
      ASSERT_LE(path->turn_rate_rad(0, 1), std::abs(to[0] - from[0]) + std::abs(to[1] - from[1]) + 1e-5)
          << machine.name;
    }
  }
}

TEST(RotaryLaw, ItsRatesBoundTheMotion) {
  test::Scatter scatter(12);
  for (const Machine& machine : test::machines()) {
    const RotaryLaw law(machine);
    for (int n = 0; n < 500; ++n) {
      const RotaryAngles from = {scatter.in(-3, 3), scatter.in(-3, 3)};
      const RotaryAngles to = {scatter.in(-3, 3), scatter.in(-3, 3)};
      const Toolpath stated = path_with(from, to);
      const auto path = law.of_move(&stated, 0, {Vec3::Zero(), tool_axes(machine, from).col(2)},
                                    {Vec3::Zero(), tool_axes(machine, to).col(2)});
      constexpr double kStep = 1e-4;
      for (double t = 0; t < 1 - 2 * kStep; t += 0.1) {
        const auto velocity = [&](double at) {
          const Eigen::AngleAxisd turn(path->axes_at(at + kStep) * path->axes_at(at).transpose());
          return Vec3(turn.angle() / kStep * turn.axis());
        };
        ASSERT_LE(velocity(t).norm(), path->turn_rate_rad(0, 1) * (1 + 1e-4) + 1e-6) << machine.name;
        ASSERT_LE((velocity(t + kStep) - velocity(t)).norm() / kStep, path->turn_acceleration_rad(0, 1) * 1.01 + 1e-3);
      }
    }
  }
}

TEST(RotaryLaw, FollowsTheAnglesOfThePathWhereTheyAreKnown) {
  const Machine machine = test::machines()[0];
  const RotaryAngles end{std::numbers::pi / 2, 0.1};
  const Toolpath stated = path_with({0, 0}, end);  // at the pole, where C stood at 0
  const Pose up{Vec3::Zero(), Vec3::UnitZ()}, leaning{Vec3::Zero(), tool_axes(machine, end).col(2)};
  const RotaryLaw law(machine);
  EXPECT_GT(law.of_move(&stated, 0, up, leaning)->turn_rate_rad(0, 1), 1.5);
  EXPECT_LT(law.between(up, leaning)->turn_rate_rad(0, 1), 0.11);
}

TEST(RotaryLaw, AnAxisThatIsNotReachedHasNoPathButStands) {
  const RotaryLaw law(test::machines()[4]);
  const Pose up{Vec3::Zero(), Vec3::UnitZ()}, below{Vec3::Zero(), -Vec3::UnitZ()};
  EXPECT_EQ(law.between(up, below), nullptr);
  ASSERT_NE(law.between(below, below), nullptr);
  EXPECT_LT((law.between(below, below)->axes_at(0.5).col(2) - below.axis).norm(), 1e-15);
}

TEST(LargestGap, OfAQuarterTurnAtThirtyDegreesIsItsFormula) {
  // Both ends lean by s; C turns by 2h. In the middle the axis of C leans by s still, the great circle by
  // atan(tan s cos h).
  const Machine machine = test::machines()[0];
  const double s = std::numbers::pi / 6, h = std::numbers::pi / 4;
  const double expected = s - std::atan(std::tan(s) * std::cos(h));
  EXPECT_NEAR(largest_gap_rad(machine, {0, s}, {2 * h, s}), expected, 1e-6);
  EXPECT_NEAR(largest_gap_rad(machine, {0, 0.1}, {0, 0.7}), 0, 1e-9) << "one joint alone turns on a great circle";
}

}  // namespace
}  // namespace gouge::rotary_law_test
