#include "lib/machine/joint_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lib/machine/joint_path.h"
#include "tests/lib/machine/machines.h"
#include "tests/support/scatter.h"

namespace gouge::joint_plan_test {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// A trunnion: C on A, both of the table.
Machine trunnion(double a_min, double a_max, double c_max) {
  Machine machine = test::machines()[0];
  for (const std::size_t k : machine.rotary) machine.joints[k].preference = 0;
  Joint &c = machine.joints[machine.rotary[0]], &a = machine.joints[machine.rotary[1]];
  a.is_continuous = c.is_continuous = false;
  a.min = a_min * kDegree;
  a.max = a_max * kDegree;
  c.min = -c_max * kDegree;
  c.max = c_max * kDegree;
  return machine;
}

Toolpath path_of(const std::vector<Vec3>& axes) {
  Toolpath path;
  for (const Vec3& axis : axes) {
    Move move;
    move.has_start = !path.moves.empty();
    move.end = {Vec3::Zero(), axis.normalized()};
    path.moves.push_back(move);
  }
  return path;
}

/// The fewest breaks of all choices, by trying each.
std::size_t fewest_breaks(const Machine& machine, const Toolpath& path, std::size_t move,
                          const std::optional<RotaryAngles>& before) {
  if (move == path.moves.size()) return 0;
  std::size_t fewest = 1000;
  for (RotaryAngles angles : rotary_angles(machine, path.moves[move].end.axis).all) {
    for (int m = -2; m <= 2; ++m) {
      for (int n = -2; n <= 2; ++n) {
        const RotaryAngles turned{angles[0] + m * kWholeTurn_rad, angles[1] + n * kWholeTurn_rad};
        bool is_within = true;
        for (std::size_t k = 0; k < 2; ++k) {
          const Joint& joint = machine.joints[machine.rotary[k]];
          is_within = is_within && turned[k] >= *joint.min && turned[k] <= *joint.max;
        }
        if (!is_within) continue;
        const std::size_t here = before && breaks_off(machine, *before, turned) ? 1 : 0;
        fewest = std::min(fewest, here + fewest_breaks(machine, path, move + 1, turned));
      }
    }
  }
  return fewest;
}

TEST(JointPlan, AvoidsALimitThatTheNearestAnglesRunInto) {
  const Machine machine = trunnion(-5, 120, 360);
  std::vector<Vec3> axes;
  for (int k = 3; k <= 20; ++k) {
    const RotaryAngles angles{0, -k * kDegree};
    axes.emplace_back(tool_axes(machine, angles).col(2));
  }
  const JointChoice choice = choose_joints(machine, path_of(axes));
  EXPECT_EQ(choice.breaks, 0U);
  EXPECT_TRUE(choice.problems.empty());
  for (std::size_t i = 0; i < axes.size(); ++i) {
    ASSERT_TRUE(choice.path.end[i].has_value());
    EXPECT_NEAR((*choice.path.end[i])[1], (3.0 + static_cast<double>(i)) * kDegree, 1e-9) << "the other solution";
  }
}

TEST(JointPlan, KeepsTheNearestAnglesWhereTheyAreContinuous) {
  const Machine machine = trunnion(-120, 120, 360);
  std::vector<Vec3> axes;
  for (int k = 3; k <= 20; ++k) axes.emplace_back(tool_axes(machine, {0, -k * kDegree}).col(2));
  const JointChoice choice = choose_joints(machine, path_of(axes));
  EXPECT_NEAR((*choice.path.end.front())[1], -3 * kDegree, 1e-9);
}

// On a machine that is not square both solutions move the tool axis differently.
TEST(JointChoice, AfterATieOfTwoSolutionsNoAnglesAreChosenUntilBothMeet) {
  const Machine machine = test::machines()[4];
  const RotaryAngles pole{0, 0};
  // Both solutions of the next position are equally far from the pole.
  std::vector<Vec3> axes{tool_axes(machine, pole).col(2)};
  const RotarySolutions tie = rotary_angles(machine, tool_axes(machine, {0, 1}).col(2));
  ASSERT_EQ(tie.all.size(), 2U);
  const double middle = 0.5 * (tie.all[0][0] + tie.all[1][0]);
  const RotaryAngles turned{-middle, 1};
  axes.emplace_back(tool_axes(machine, turned).col(2));
  axes.emplace_back(tool_axes(machine, {turned[0] + 0.1, 1.1}).col(2));
  axes.emplace_back(tool_axes(machine, {turned[0] + 0.2, 1.2}).col(2));
  const JointChoice choice = choose_joints(machine, path_of(axes));
  EXPECT_TRUE(choice.path.end[0].has_value());
  for (std::size_t i = 1; i < axes.size(); ++i) EXPECT_FALSE(choice.path.end[i].has_value()) << i;
  EXPECT_EQ(choice.problems.size(), 3U);
}

TEST(JointChoice, ATieOnASquareMachineLeavesOneMoveOpenUnlessHeadsMatter) {
  const Machine machine = test::machines()[0];
  const std::vector<Vec3> axes{tool_axes(machine, {0, 0}).col(2),
                               tool_axes(machine, {0.5 * std::numbers::pi, 0.2}).col(2),
                               tool_axes(machine, {0.5 * std::numbers::pi, 0.3}).col(2)};
  EXPECT_TRUE(choose_joints(machine, path_of(axes)).path.end[2].has_value());
  EXPECT_FALSE(choose_joints(machine, path_of(axes), true).path.end[2].has_value());
}

// A table that winds up beyond its limit starts a turn earlier.
TEST(JointPlan, StartsAWindingWhereItHasRoom) {
  const Machine machine = trunnion(-120, 120, 400);
  std::vector<Vec3> axes;
  for (int k = 0; k <= 700; k += 10) axes.emplace_back(tool_axes(machine, {(k + 20) * kDegree, 30 * kDegree}).col(2));
  EXPECT_EQ(choose_joints(machine, path_of(axes)).breaks, 0U);
}

TEST(JointPlan, HasNoMoreBreaksThanTheBestOfAllChoices) {
  test::Scatter random(43);
  std::size_t planned = 0;
  for (int run = 0; run < 400; ++run) {
    const Machine machine = trunnion(-random.in(5, 60), random.in(5, 120), random.in(100, 400));
    std::vector<Vec3> axes;
    Vec3 axis = random.axis(0.4);
    for (int k = 0; k < 4; ++k) {
      axes.push_back(axis);
      axis = (axis + 0.4 * random.point(1)).normalized();
    }
    const Toolpath path = path_of(axes);
    const std::size_t fewest = fewest_breaks(machine, path, 0, std::nullopt);
    if (fewest >= 1000) continue;  // some position is beyond a limit
    const JointChoice choice = choose_joints(machine, path);
    const bool is_decided = std::ranges::none_of(choice.path.end, [](const auto& end) { return !end; });
    if (!is_decided) continue;
    ++planned;
    EXPECT_EQ(choice.breaks, fewest) << run;
  }
  EXPECT_GT(planned, 100U);
}

}  // namespace
}  // namespace gouge::joint_plan_test
