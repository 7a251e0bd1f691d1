#include "lib/machine/tip_slack.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "tests/lib/machine/machines.h"
#include "tests/support/machine_reference.h"

// The bound of the tip for intervals of points and of the tool length, against random true values at dense instants.
// GOUGE_SLACK_MOVES sets the number of moves of each machine by each law.

namespace gouge::tip_slack_test {
namespace {

using test::MachineReference;

constexpr double kLength_mm = 110, kHalf_mm = 2;

std::size_t wanted_moves() {
  const char* const given = std::getenv("GOUGE_SLACK_MOVES");
  return given == nullptr ? 300 : std::strtoull(given, nullptr, 10);
}

/// Machines of all arrangements, some with linear joints that are not square, or with a part zero.
std::vector<Machine> machines_with_slack() {
  std::vector<Machine> all = test::machines_and_placed();
  Machine skew = test::machines()[1];
  skew.name = "skew";
  skew.joints[skew.linear[0]].direction = Vec3(1, 0.4, 0).normalized();
  skew.joints[skew.linear[2]].direction = Vec3(0.3, 0, 1).normalized();
  all.push_back(skew);
  for (Machine& machine : all) {
    for (Joint& joint : machine.joints) joint.rate = is_rotary(joint) ? 20 : 3000;
    machine.joints[machine.linear[1]].rate = 5000;
  }
  return all;
}

/// A machine with true values in the intervals, and its tool length.
struct Truth {
  Machine machine;
  double length_mm = 0;
};

Truth random_truth(const Machine& machine, double half_mm, test::Scatter& scatter) {
  Truth truth{machine, kLength_mm + half_mm * (scatter.in(0, 1) < 0.5 ? -1 : 1)};
  for (const std::size_t k : machine.rotary) {
    Joint& joint = truth.machine.joints[k];
    Vec3 off(scatter.in(-1, 1), scatter.in(-1, 1), scatter.in(-1, 1));
    off -= joint.direction.dot(off) * joint.direction;
    joint.point += joint.point_slack_mm * off.normalized() + scatter.in(-9, 9) * joint.direction;
  }
  return truth;
}

MachineReference::Ends random_ends(const MachineReference& reference, test::Scatter& scatter) {
  MachineReference::Ends ends;
  for (Pose* const pose : {&ends.from, &ends.to})
    pose->tip = Vec3(scatter.in(-80, 80), scatter.in(-80, 80), scatter.in(-80, 80));
  for (RotaryAngles* const angles : {&ends.angles0, &ends.angles1}) *angles = {scatter.in(-3, 3), scatter.in(-3, 3)};
  return reference.with_joints(ends);
}

/// Minutes of a move in which each joint runs at its own rate.
double minutes_of(const Machine& machine, const MachineReference::Ends& ends) {
  double longest = 0;
  for (std::size_t k = 0; k < 5; ++k)
    longest = std::max(longest, std::abs(ends.joints1[k] - ends.joints0[k]) / *machine.joints[k].rate);
  return longest;
}

/// Returns the farthest that the true tip is from the tip by the law, at the same instant of the clock.
double farthest(const Machine& machine, TurnLaw law, const MachineReference& by_law, const MachineReference::Ends& ends,
                const MachineReference& truly, const MachineReference::Ends& true_ends) {
  constexpr int kInstants = 60;
  const double minutes = law == TurnLaw::independent ? minutes_of(machine, ends) : 1;
  const double true_minutes = law == TurnLaw::independent ? minutes_of(machine, true_ends) : 1;
  double most = 0;
  for (int n = 0; n <= kInstants; ++n) {
    const double t = static_cast<double>(n) / kInstants;
    const Vec3 tip = by_law.frame(law, ends, std::min(1.0, t * true_minutes / minutes)).shift;
    most = std::max(most, (truly.frame(law, true_ends, t).shift - tip).norm());
  }
  return most;
}

TEST(TipSlack, BoundsTheTipForAllTrueValues) {
  test::Scatter scatter(71);
  double closest = 0;
  for (Machine machine : machines_with_slack()) {
    for (const std::size_t k : machine.rotary) machine.joints[k].point_slack_mm = scatter.in(0, 3);
    for (const TurnLaw law : {TurnLaw::joint, TurnLaw::independent}) {
      const double bound = tip_slack_mm(machine, {law, law}, kHalf_mm).value();
      for (std::size_t n = 0; n < wanted_moves(); ++n) {
        const Truth truth = random_truth(machine, kHalf_mm, scatter);
        const MachineReference by_law(machine, kLength_mm), truly(truth.machine, truth.length_mm);
        const MachineReference::Ends ends = random_ends(by_law, scatter);
        // The control knows the true values: its tip is right at both ends.
        const double known = farthest(machine, law, by_law, ends, truly, truly.with_joints(ends));
        // The control uses the middles: its joints are those of the law.
        const double assumed = farthest(machine, law, by_law, ends, truly, ends);
        ASSERT_LE(std::max(known, assumed), bound) << machine.name << " " << turn_law_name(law) << ", move " << n;
        closest = std::max(closest, std::max(known, assumed) / bound);
      }
    }
  }
  std::cout << "largest share of the bound: " << closest << "\n";
  EXPECT_GT(closest, 0.4) << "the bound is of use";
}

TEST(TipSlack, WithTheTipOnItsLineOnlyTheMiddlesOfTheControlMatter) {
  test::Scatter scatter(72);
  for (Machine machine : machines_with_slack()) {
    for (const std::size_t k : machine.rotary) machine.joints[k].point_slack_mm = scatter.in(0, 3);
    const double bound = tip_slack_mm(machine, {TurnLaw::axis, TurnLaw::vector}, kHalf_mm).value();
    for (std::size_t n = 0; n < wanted_moves(); ++n) {
      const Truth truth = random_truth(machine, kHalf_mm, scatter);
      const MachineReference by_law(machine, kLength_mm), truly(truth.machine, truth.length_mm);
      const MachineReference::Ends ends = random_ends(by_law, scatter);
      // Any pose of the law stands for both ends.
      const double off = farthest(machine, TurnLaw::joint, by_law, ends, truly, ends);
      ASSERT_LE(off, bound) << machine.name;
    }
  }
}

TEST(TipSlack, IsZeroWithoutIntervalsAndUnboundedForSplitLinearJoints) {
  Machine machine = test::machines()[0];
  EXPECT_EQ(tip_slack_mm(machine, {TurnLaw::joint, TurnLaw::joint}, 0), 0.0);
  EXPECT_NEAR(tip_slack_mm(machine, {TurnLaw::joint, TurnLaw::joint}, 0.5).value(), 1, 1e-8);
  EXPECT_NEAR(tip_slack_mm(machine, {TurnLaw::axis, TurnLaw::vector}, 0.5).value(), 0.5, 1e-8);
  machine.joints[machine.rotary[0]].point_slack_mm = 0.1;
  EXPECT_NEAR(tip_slack_mm(machine, {TurnLaw::vector, TurnLaw::joint}, 0.5).value(), 1.4, 1e-8);
  std::swap(machine.joints[1], machine.joints[2]);
  machine.joints[1].side = JointSide::table;
  const Machine split = make_machine(machine).value();
  EXPECT_FALSE(tip_slack_mm(split, {TurnLaw::joint, TurnLaw::joint}, 0.5));
  EXPECT_TRUE(tip_slack_mm(split, {TurnLaw::axis, TurnLaw::axis}, 0.5));
}

}  // namespace
}  // namespace gouge::tip_slack_test
