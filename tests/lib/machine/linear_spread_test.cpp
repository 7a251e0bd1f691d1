#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lib/machine/joint_law.h"
#include "lib/machine/kinematics.h"
#include "lib/machine/linear_limits.h"
#include "tests/lib/machine/machines.h"

// Positions at which the linear joints lie in one plane, so that a pose does not determine their values.

namespace gouge::linear_spread_test {
namespace {

constexpr double kQuarter_rad = std::numbers::pi / 2;

/// X under both rotary joints of the table: at C = 90 degrees it is parallel to Y.
Machine x_under_rotaries() {
  Joint x = test::kX;
  x.side = JointSide::table;
  return test::machine("X under C", {x, test::rotary("C", Vec3::UnitZ(), JointSide::table),
                                     test::rotary("A", Vec3::UnitX(), JointSide::table), test::kY, test::kZ});
}

/// A move with these angles at both ends.
Toolpath path_between(const Machine& machine, const RotaryAngles& from, const RotaryAngles& to) {
  Toolpath path;
  path.moves.resize(2);
  path.moves[0].end = {Vec3(10, 20, 30), tool_axes(machine, from).col(2)};
  path.moves[1].end = {Vec3(0, 30, 30), tool_axes(machine, to).col(2)};
  path.moves[1].has_start = true;
  path.joints = std::make_shared<const JointPath>(JointPath{{std::nullopt, from}, {from, to}});
  return path;
}

TEST(LinearSpread, IsTheSlopeOfTheTipOverTheLinearJoints) {
  test::Scatter scatter(91);
  for (int n = 0; n < 200; ++n) {
    const Machine machine = test::random_chain(scatter, n % 2 == 1);
    const RotaryAngles angles{scatter.in(-3, 3), scatter.in(-3, 3)};
    JointValues joints(5, 0);
    for (std::size_t k = 0; k < 2; ++k) joints[machine.rotary[k]] = angles[k];
    const Vec3 origin = forward(machine, joints, 0).tip;
    Eigen::Matrix3d slopes;
    for (int k = 0; k < 3; ++k) {
      JointValues one = joints;
      one[machine.linear[static_cast<std::size_t>(k)]] = 1;
      slopes.col(k) = forward(machine, one, 0).tip - origin;
    }
    EXPECT_NEAR(linear_spread(machine, angles), std::abs(slopes.determinant()), 1e-9) << machine.name;
  }
}

TEST(LinearSpread, DoesNotChangeWithNeighbours) {
  for (const Machine& machine : test::machines_and_placed())
    EXPECT_NEAR(linear_spread(machine, {1.1, 0.7}), 1, 1e-12) << machine.name;
}

TEST(LinearSpread, AMoveToOrFromAPlaneIsOpenByTheLawsOfAllJoints) {
  Machine machine = place_part(x_under_rotaries(), {});
  for (Joint& joint : machine.joints) joint.rate = 100;
  const RotaryAngles apart{0, 0.5}, in_plane{kQuarter_rad, 0.5}, near_plane{kQuarter_rad + 0.005, 0.5};
  EXPECT_LT(linear_spread(machine, in_plane), 1e-12);
  for (const JointTiming timing : {JointTiming::together, JointTiming::independent}) {
    const JointLaw law(machine, timing, 100);
    const auto is_open = [&](const RotaryAngles& from, const RotaryAngles& to) {
      const Toolpath path = path_between(machine, from, to);
      const bool has_motion = law.of_move(&path, 1, path.moves[0].end, path.moves[1].end) != nullptr;
      const std::string why = law.why_open(path, 1);
      EXPECT_EQ(has_motion, why.empty()) << why;
      EXPECT_TRUE(why.empty() || why.find("nearly in one plane") != std::string::npos) << why;
      return !has_motion;
    };
    EXPECT_TRUE(is_open(apart, in_plane));
    EXPECT_TRUE(is_open(in_plane, apart));
    EXPECT_TRUE(is_open(in_plane, in_plane)) << "nor does a standing axis determine them";
    EXPECT_TRUE(is_open(apart, near_plane)) << "digits of the file would decide";
    EXPECT_FALSE(is_open(apart, {2, 0.5})) << "the plane is crossed on the way";
  }
}

TEST(LinearSpread, AToolThatStandsInAPlaneIsWhereItIs) {
  const Machine machine = x_under_rotaries();
  const Toolpath path = path_between(machine, {kQuarter_rad, 0.5}, {kQuarter_rad, 0.5});
  const Pose& pose = path.moves[0].end;
  const auto stands = JointLaw(machine, JointTiming::together, 100).of_move(&path, 0, pose, pose);
  ASSERT_NE(stands, nullptr);
  EXPECT_LT((stands->axes_at(0) - tool_axes(machine, {kQuarter_rad, 0.5})).norm(), 1e-12);
}

TEST(LinearSpread, LimitsAreNotComparedInAPlane) {
  Machine machine = x_under_rotaries();
  machine.joints[0].min = -1000;
  machine.joints[0].max = 1000;
  machine = place_part(machine, {});
  const Toolpath path = path_between(machine, {0, 0.5}, {kQuarter_rad, 0.5});
  const LinearLimits limits = check_linear_limits(machine, path, 100.0);
  ASSERT_EQ(limits.problems.size(), 1U);
  EXPECT_EQ(limits.problems[0].kind, JointProblem::Kind::in_plane);
  EXPECT_EQ(limits.problems[0].move, 1U);
  EXPECT_NE(problem_text(machine, limits.problems[0]).find("nearly in one plane"), std::string::npos);
}

}  // namespace
}  // namespace gouge::linear_spread_test
