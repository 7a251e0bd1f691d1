#include "lib/machine/kinematics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "lib/machine/joint_path.h"
#include "tests/lib/machine/machines.h"
#include "tests/support/scatter.h"

// Forward and inverse kinematics of every arrangement, at poles too.

namespace gouge::kinematics_test {
namespace {

constexpr double kHalfTurn = std::numbers::pi;

std::size_t trials() {
  const char* const many = std::getenv("GOUGE_MACHINE_POSES");
  return many != nullptr ? std::strtoull(many, nullptr, 10) : 20'000;
}

TEST(Kinematics, InverseOfForwardIsTheSamePose) {
  test::Scatter scatter(20261128);
  for (const Machine& machine : test::machines_and_presets()) {
    for (std::size_t n = 0; n < trials(); ++n) {
      JointValues joints(5);
      for (std::size_t k = 0; k < 5; ++k) joints[k] = scatter.in(-300, 300);
      // One in ten at a pole of some machine, or next to it.
      for (const std::size_t k : machine.rotary)
        joints[k] = scatter.in(0, 1) < 0.1 ? (scatter.in(0, 1) < 0.5 ? 0 : scatter.in(-1e-9, 1e-9))
                                           : scatter.in(-kHalfTurn, kHalfTurn);
      const double length = scatter.in(0, 200);
      const Pose pose = forward(machine, joints, length);
      const RotarySolutions solutions = rotary_angles(machine, pose.axis);
      ASSERT_FALSE(solutions.all.empty()) << machine.name;
      for (const RotaryAngles& angles : solutions.all) {
        const JointValues found = inverse(machine, pose.tip, angles, length);
        const Pose again = forward(machine, found, length);
        ASSERT_LT((again.tip - pose.tip).norm(), 1e-9) << machine.name;
        ASSERT_LT((again.axis - pose.axis).norm(), 1e-9) << machine.name << " " << joints[machine.rotary[1]];
      }
    }
  }
}

TEST(Kinematics, TheAnglesOfAPoseAreAmongTheSolutions) {
  test::Scatter scatter(7);
  for (const Machine& machine : test::machines_and_presets()) {
    for (std::size_t n = 0; n < trials() / 4; ++n) {
      const RotaryAngles angles = {scatter.in(-3, 3), scatter.in(-3, 3)};
      const RotarySolutions solutions = rotary_angles(machine, tool_axes(machine, angles).col(2));
      if (solutions.is_pole) continue;
      double nearest = 10;
      for (const RotaryAngles& found : solutions.all) {
        double off = 0;
        for (std::size_t k = 0; k < 2; ++k)
          off = std::max(off, std::abs(std::remainder(found[k] - angles[k], 2 * kHalfTurn)));
        nearest = std::min(nearest, off);
      }
      // Near a pole, or where both solutions meet, angles are known to the root of the rounding.
      ASSERT_LT(nearest, 1e-5) << machine.name << " " << angles[0] << " " << angles[1];
    }
  }
}

TEST(Kinematics, APlacedPartSeesTheSameMachineFromItsZero) {
  test::Scatter scatter(62);
  for (const Machine& machine : test::machines()) {
    for (std::size_t n = 0; n < trials() / 4; ++n) {
      const RigidTransform zero = test::random_zero(scatter);
      const Machine placed = place_part(machine, zero);
      JointValues joints(5);
      for (std::size_t k = 0; k < 5; ++k)
        joints[k] = is_rotary(machine.joints[k]) ? scatter.in(-7, 7) : scatter.in(-300, 300);
      const double length = scatter.in(0, 200);
      const Pose on_machine = forward(machine, joints, length), on_part = forward(placed, joints, length);
      ASSERT_LT((zero.point(on_part.tip) - on_machine.tip).norm(), 1e-9) << machine.name;
      ASSERT_LT((zero.direction(on_part.axis) - on_machine.axis).norm(), 1e-12) << machine.name;
      const RotaryAngles angles = {joints[machine.rotary[0]], joints[machine.rotary[1]]};
      const JointValues found = inverse(placed, on_part.tip, angles, length);
      for (std::size_t k = 0; k < 5; ++k) ASSERT_NEAR(found[k], joints[k], 1e-9) << machine.name;
    }
  }
}

TEST(Kinematics, AClosedFormOfATrunnion) {
  // A by 90 degrees tilts the tool from +z to -y; C by 90 then turns it to +x.
  const Machine trunnion = test::machines()[0];
  EXPECT_LT((tool_axes(trunnion, {0, kHalfTurn / 2}).col(2) - Vec3(0, -1, 0)).norm(), 1e-15);
  EXPECT_LT((tool_axes(trunnion, {kHalfTurn / 2, kHalfTurn / 2}).col(2) - Vec3(1, 0, 0)).norm(), 1e-15);
}

TEST(Kinematics, AnAxisBeyondANutatingHeadIsNotReached) {
  const Machine head = test::machines()[4];
  EXPECT_FALSE(rotary_angles(head, Vec3(1, 0, 0)).all.empty());
  EXPECT_TRUE(rotary_angles(head, Vec3(0.1, 0, -1).normalized()).all.empty());
}

TEST(Machine, WrongJointsAreRefused) {
  Machine machine = test::machines()[0];
  machine.joints[1].direction = machine.joints[0].direction;
  EXPECT_EQ(make_machine(machine).error().code, "machine-joints");
  machine = test::machines()[0];
  machine.joints[3].direction = machine.joints[2].direction;
  EXPECT_EQ(make_machine(machine).error().code, "machine-joints");
  machine = test::machines()[0];
  machine.joints[4].name = "C";
  EXPECT_EQ(make_machine(machine).error().message,
            "two joints have the name 'C'; expected a different name for each joint");
  machine = test::machines()[0];
  machine.joints.pop_back();
  EXPECT_EQ(make_machine(machine).error().code, "machine-joints");
}

Toolpath path_of(const std::vector<Vec3>& axes) {
  Toolpath path;
  path.moves.resize(axes.size());
  for (std::size_t i = 0; i < axes.size(); ++i) {
    path.moves[i].end = {Vec3(static_cast<double>(i), 0, 0), axes[i].normalized()};
    path.moves[i].has_start = i > 0;
  }
  return path;
}

Vec3 leaning(double a_deg, double c_deg) {
  const double a = a_deg * kHalfTurn / 180, c = c_deg * kHalfTurn / 180;
  return {std::sin(a) * std::sin(c), -std::sin(a) * std::cos(c), std::cos(a)};
}

TEST(JointPath, TurnsOnWithoutAnUnwindingWhereTheJointIsContinuous) {
  std::vector<Vec3> axes;
  for (int k = 0; k <= 72; ++k) axes.push_back(leaning(20, 10.0 * k));
  const JointChoice choice = choose_joints(test::machines()[0], path_of(axes));
  EXPECT_TRUE(choice.problems.empty());
  EXPECT_NEAR((*choice.path.end.back())[0] - (*choice.path.end.front())[0], 4 * kHalfTurn, 1e-9);
}

TEST(JointPath, AtAPoleTheFirstJointStaysAndThenFlips) {
  const JointChoice choice =
      choose_joints(test::machines()[0], path_of({leaning(5, 0), leaning(0, 0), leaning(1, 80), leaning(2, 80)}));
  ASSERT_EQ(choice.problems.size(), 1U);
  EXPECT_EQ(choice.problems[0].kind, JointProblem::Kind::flip);
  EXPECT_EQ(choice.problems[0].move, 2U);
  EXPECT_NEAR(std::abs(choice.problems[0].value), kHalfTurn * 80 / 180, 1e-9);
}

TEST(JointPath, OfTwoTurnsEquallyNearNoneIsChosen) {
  // Out of a pole by 90 degrees either way, and half a turn of a continuous joint.
  Machine machine = test::machines()[0];
  machine.joints[1].is_continuous = false;
  machine.joints[1].min = -5 * kHalfTurn / 180;
  machine.joints[1].max = 120 * kHalfTurn / 180;
  for (const std::vector<Vec3>& axes :
       {std::vector<Vec3>{leaning(0, 0), leaning(1, 90)}, std::vector<Vec3>{leaning(100, 0), leaning(100, 180)}}) {
    const JointChoice choice = choose_joints(machine, path_of(axes));
    ASSERT_EQ(choice.problems.size(), 1U);
    EXPECT_EQ(choice.problems[0].kind, JointProblem::Kind::undecided);
    EXPECT_FALSE(choice.path.end[1]);
  }
}

TEST(JointPath, ALimitIsNamedWithItsJoint) {
  Machine machine = test::machines()[0];
  Joint& a = machine.joints[1];
  a.is_continuous = false;
  a.min = -30 * kHalfTurn / 180;
  a.max = 30 * kHalfTurn / 180;
  const JointChoice choice = choose_joints(machine, path_of({leaning(10, 0), leaning(31, 0), leaning(20, 0)}));
  ASSERT_EQ(choice.problems.size(), 1U);
  EXPECT_EQ(choice.problems[0].kind, JointProblem::Kind::limit);
  EXPECT_EQ(choice.problems[0].move, 1U);
  EXPECT_EQ(machine.joints[choice.problems[0].joint].name, "A");
  EXPECT_FALSE(choice.path.end[1]);
  EXPECT_TRUE(choice.path.end[2]);
}

}  // namespace
}  // namespace gouge::kinematics_test
