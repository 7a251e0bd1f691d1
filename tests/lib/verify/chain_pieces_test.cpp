#include <gtest/gtest.h>

#include <cmath>

#include "lib/verify/moving_pose.h"
#include "tests/lib/machine/machines.h"
#include "tests/support/machine_reference.h"
#include "tests/support/paths.h"
#include "tests/support/scatter.h"

// Interval arithmetic of the joints of a machine, against matrices of the test's own.

namespace gouge::chain_pieces_test {
namespace {

constexpr double kLength_mm = 70;

ClaimedJoints claimed(const Machine& machine) {
  ClaimedJoints joints;
  for (const Joint& joint : machine.joints)
    joints.chain.push_back({joint.type == JointType::rotary, joint.direction, joint.point, joint.rate});
  joints.rotary = machine.rotary;
  joints.rest = machine.rest;
  joints.tool_length_mm = kLength_mm;
  return joints;
}

/// How far the middle of an enclosure may be from what it encloses.
double width(const Bounds3& bounds) {
  double most = 0;
  for (std::size_t k = 0; k < 3; ++k) most = std::max(most, bounds[k].sup() - bounds[k].inf());
  return most;
}

bool holds(const Bounds3& bounds, const Vec3& v, double slack) {
  for (std::size_t k = 0; k < 3; ++k) {
    const double x = v[static_cast<Eigen::Index>(k)];
    if (x < bounds[k].inf() - slack || x > bounds[k].sup() + slack) return false;
  }
  return true;
}

struct RandomRun {
  RandomRun(const Machine& machine, test::Scatter& scatter) : reference(machine, kLength_mm) {
    const auto vector = [&] {
      const double x = scatter.in(-60, 60), y = scatter.in(-60, 60), z = scatter.in(-60, 60);
      return Vec3(x, y, z);
    };
    // Far turns are those of a table that has been winding.
    const double wound = std::floor(scatter.in(-20, 20)) * 2 * std::numbers::pi;
    ends.angles0 = {wound + scatter.in(-3, 3), scatter.in(-3, 3)};
    ends.angles1 = {wound + scatter.in(-3, 3), scatter.in(-3, 3)};
    ends.from.tip = vector();
    ends.to.tip = vector();
    ends = reference.with_joints(ends);
    ends.from.axis = reference.at(TurnLaw::axis, ends, 0).axis;
    ends.to.axis = reference.at(TurnLaw::axis, ends, 1).axis;
    path = paths::through({ends.from, ends.to});
  }

  test::MachineReference reference;
  test::MachineReference::Ends ends;
  Toolpath path;
};

/// Every instant is off the chord of its piece by no more than the piece states.
void expect_bounded(const RandomRun& run, TurnLaw law, const MotionPiece& piece, double t0, double t1, int level) {
  for (const auto& [t, pose] : {std::pair(t0, piece.start()), std::pair(t1, piece.end())}) {
    const Pose at = run.reference.at(law, run.ends, t);
    EXPECT_TRUE(holds(pose.tip, at.tip, 1e-9)) << t;
    EXPECT_TRUE(holds(pose.axis, at.axis, 1e-11)) << t;
    // A break is known only as well as the way of its joint is, relative to that way: far below any resolution still.
    EXPECT_LT(width(pose.tip), 5e-6);
    EXPECT_LT(width(pose.axis), 1e-8);
  }
  for (double s = 0.1; s < 1; s += 0.2) {
    const Pose at = run.reference.at(law, run.ends, t0 + s * (t1 - t0));
    const Vec3 tip = (1 - s) * piece.start().tip.middle() + s * piece.end().tip.middle();
    const Vec3 axis = (1 - s) * piece.start().axis.middle() + s * piece.end().axis.middle();
    EXPECT_LE((at.tip - tip).norm(), piece.sag_mm() + 1e-9 + width(piece.start().tip) + width(piece.end().tip));
    EXPECT_LE((at.axis - axis).norm(), piece.bend() + 1e-11 + width(piece.start().axis) + width(piece.end().axis));
  }
  if (level == 0) return;
  const auto halves = piece.halves();
  expect_bounded(run, law, halves[0], t0, 0.5 * (t0 + t1), level - 1);
  expect_bounded(run, law, halves[1], 0.5 * (t0 + t1), t1, level - 1);
}

std::vector<Machine> machines_with_rates() {
  std::vector<Machine> all = test::machines_and_placed();
  for (Machine& machine : all)
    for (std::size_t k = 0; k < 5; ++k) machine.joints[k].rate = k % 2 == 0 ? 30.0 : 4000.0;
  return all;
}

TEST(ChainPieces, HoldThePoseAtEveryInstant) {
  test::Scatter scatter(31);
  for (const Machine& machine : machines_with_rates()) {
    const ClaimedJoints joints = claimed(machine);
    for (int n = 0; n < 60; ++n) {
      const RandomRun run(machine, scatter);
      for (const auto& [law, by] :
           {std::pair(TurnLaw::axis, ClaimedRun::rotary), std::pair(TurnLaw::joint, ClaimedRun::together)}) {
        const RoundsUpward upward;
        const auto pieces = motion_pieces(run.path, 1, {&joints, by, run.ends.angles0, run.ends.angles1});
        ASSERT_TRUE(pieces.has_value());
        ASSERT_EQ(pieces->size(), 1U);
        expect_bounded(run, law, pieces->front(), 0, 1, 4);
      }
      if (HasFailure()) FAIL() << machine.name << ", trial " << n;
    }
  }
}

TEST(ChainPieces, AreCutWhereJointsArrive) {
  test::Scatter scatter(32);
  for (const Machine& machine : machines_with_rates()) {
    const ClaimedJoints joints = claimed(machine);
    for (int n = 0; n < 60; ++n) {
      const RandomRun run(machine, scatter);
      std::vector<double> breaks{0, 1};
      double slowest = 0;
      std::vector<double> minutes;
      for (std::size_t k = 0; k < 5; ++k)
        minutes.push_back(std::abs(run.ends.joints1[k] - run.ends.joints0[k]) / *machine.joints[k].rate);
      for (const double one : minutes) slowest = std::max(slowest, one);
      for (const double one : minutes)
        if (one < slowest) breaks.push_back(one / slowest);
      std::sort(breaks.begin(), breaks.end());
      const RoundsUpward upward;
      const auto pieces =
          motion_pieces(run.path, 1, {&joints, ClaimedRun::independent, run.ends.angles0, run.ends.angles1});
      ASSERT_TRUE(pieces.has_value());
      ASSERT_EQ(pieces->size(), 5U);
      for (std::size_t k = 0; k < 5; ++k)
        expect_bounded(run, TurnLaw::independent, (*pieces)[k], breaks[k], breaks[k + 1], 3);
      if (HasFailure()) FAIL() << machine.name << ", trial " << n;
    }
  }
}

TEST(ChainPieces, JointsThatArriveTogetherShareABreak) {
  // X and Y run 30 mm at one rate, Z 60 mm: X and Y arrive half way.
  Machine machine = test::machines()[0];
  for (Joint& joint : machine.joints) joint.rate = 100;
  const ClaimedJoints joints = claimed(machine);
  const Toolpath path = paths::through({{Vec3::Zero(), Vec3::UnitZ()}, {{30, 30, 60}, Vec3::UnitZ()}});
  const RoundsUpward upward;
  const auto pieces = motion_pieces(path, 1, {&joints, ClaimedRun::independent, {0, 0}, {0, 0}});
  ASSERT_TRUE(pieces.has_value());
  ASSERT_EQ(pieces->size(), 2U);
  EXPECT_TRUE(holds(pieces->front().end().tip, {30, 30, 30}, 1e-11));
  EXPECT_LT(pieces->front().sag_mm(), 1e-9);
}

TEST(ChainPieces, WithoutARateThereAreNone) {
  Machine machine = test::machines()[0];
  ClaimedJoints joints = claimed(machine);
  const Toolpath path = paths::through({{Vec3::Zero(), Vec3::UnitZ()}, {{30, 20, 0}, Vec3::UnitZ()}});
  const RoundsUpward upward;
  const ChainMotion chain{&joints, ClaimedRun::independent, {0, 0}, {0, 0}};
  EXPECT_FALSE(motion_pieces(path, 1, chain).has_value());
  for (ClaimedJoint& joint : joints.chain) joint.rate = 10;
  EXPECT_TRUE(motion_pieces(path, 1, chain).has_value());
}

TEST(ChainPieces, AnAxisByJointsRunsAlongArcsAndSplines) {
  test::Scatter scatter(33);
  const Machine machine = test::machines()[1];
  const ClaimedJoints joints = claimed(machine);
  for (int n = 0; n < 40; ++n) {
    RandomRun run(machine, scatter);
    Move& move = run.path.moves[1];
    move.curve_kind = CurveKind::arc;
    run.path.arcs.push_back({{scatter.in(-40, 40), 3, 4}, Vec3::UnitZ(), scatter.in(-6, 6)});
    const RoundsUpward upward;
    const auto pieces = motion_pieces(run.path, 1, {&joints, ClaimedRun::rotary, run.ends.angles0, run.ends.angles1});
    ASSERT_TRUE(pieces.has_value());
    const double count = static_cast<double>(pieces->size());
    for (std::size_t k = 0; k < pieces->size(); ++k) {
      const double t0 = static_cast<double>(k) / count, t1 = static_cast<double>(k + 1) / count;
      const MotionPiece half = (*pieces)[k].halves()[0];
      const auto axis = [&](double t) { return run.reference.at(TurnLaw::axis, run.ends, t).axis; };
      EXPECT_TRUE(holds(half.start().axis, axis(t0), 1e-11));
      EXPECT_TRUE(holds(half.end().axis, axis(0.5 * (t0 + t1)), 1e-11));
      EXPECT_TRUE(holds(half.end().tip, pose_at(run.path, 1, 0.5 * (t0 + t1), false).tip, 1e-9));
    }
    if (HasFailure()) FAIL() << "trial " << n;
  }
}

}  // namespace
}  // namespace gouge::chain_pieces_test
