#include "lib/machine/joint_law.h"

#include <gtest/gtest.h>

#include <cmath>

#include "lib/machine/kinematics.h"
#include "lib/machine/rotary_law.h"
#include "lib/motion/chord_instants.h"
#include "lib/motion/motion_law.h"
#include "lib/path/toolpath.h"
#include "tests/lib/machine/machines.h"
#include "tests/support/machine_reference.h"
#include "tests/support/scatter.h"

// All joints of a machine run, together or each at its own rate, against matrices of the test's own.

namespace gouge::joint_law_test {
namespace {

constexpr double kLength_mm = 80;

/// A random move on a machine: a path of two positions with their angles.
struct RandomMove {
  RandomMove(const Machine& machine, test::Scatter& scatter) {
    const auto angles = [&] { return RotaryAngles{scatter.in(-3, 3), scatter.in(-3, 3)}; };
    ends.angles0 = angles();
    ends.angles1 = angles();
    const auto pose = [&](const RotaryAngles& at) {
      return Pose{{scatter.in(-100, 100), scatter.in(-100, 100), scatter.in(-100, 100)}, tool_axes(machine, at).col(2)};
    };
    ends.from = pose(ends.angles0);
    ends.to = pose(ends.angles1);
    ends = test::MachineReference(machine, kLength_mm).with_joints(ends);
    path.moves.resize(2);
    path.moves[0].end = ends.from;
    path.moves[1].end = ends.to;
    path.moves[1].has_start = true;
    JointPath joints;
    joints.start = {std::nullopt, ends.angles0};
    joints.end = {ends.angles0, ends.angles1};
    path.joints = std::make_shared<const JointPath>(joints);
  }

  test::MachineReference::Ends ends;
  Toolpath path;
};

std::vector<Machine> machines_with_rates() {
  std::vector<Machine> all = test::machines();
  for (Machine& machine : all)
    for (std::size_t k = 0; k < 5; ++k) machine.joints[k].rate = k % 2 == 0 ? 30.0 : 4000.0;
  return all;
}

class JointLaws : public testing::TestWithParam<TurnLaw> {
 protected:
  static JointTiming timing() {
    return GetParam() == TurnLaw::joint ? JointTiming::together : JointTiming::independent;
  }
  static MotionLaw law_of(const Machine& machine) {
    return {RapidMode::straight, std::make_shared<JointLaw>(machine, timing(), kLength_mm)};
  }
};

TEST_P(JointLaws, MovesTheToolAsTheMatricesDo) {
  test::Scatter scatter(21);
  for (const Machine& machine : machines_with_rates()) {
    const MotionLaw law = law_of(machine);
    const test::MachineReference reference(machine, kLength_mm);
    for (int n = 0; n < 300; ++n) {
      const RandomMove move(machine, scatter);
      const Motion motion = law.of(move.path, 1);
      ASSERT_TRUE(motion.is_defined());
      for (double t = 0; t <= 1; t += 1.0 / 64) {
        const Pose is = motion.at(t), expected = reference.at(GetParam(), move.ends, t);
        ASSERT_LT((is.tip - expected.tip).norm(), 1e-9) << machine.name << " at " << t;
        ASSERT_LT((is.axis - expected.axis).norm(), 1e-11) << machine.name << " at " << t;
      }
    }
  }
}

TEST_P(JointLaws, ItsBoundsHoldOnEveryInterval) {
  test::Scatter scatter(22);
  for (const Machine& machine : machines_with_rates()) {
    const MotionLaw law = law_of(machine);
    const test::MachineReference reference(machine, kLength_mm);
    for (int n = 0; n < 100; ++n) {
      const RandomMove move(machine, scatter);
      const Motion motion = law.of(move.path, 1);
      const auto segment =
          static_cast<std::uint32_t>(scatter.in(0, 0.999) * static_cast<double>(motion.segments().size()));
      const MotionSegment& whole = motion.segments()[segment];
      const double share = std::pow(0.5, std::floor(scatter.in(0, 6)));
      const double t0 = whole.t0 + scatter.in(0, 1 - share) * (whole.t1 - whole.t0);
      const double t1 = t0 + share * (whole.t1 - whole.t0);
      const MotionRates rates = motion.rates(t0, t1, segment);
      const auto at = [&](double t) { return reference.at(GetParam(), move.ends, t); };
      const Pose a = at(t0), b = at(t1);
      double way = 0, turned = 0;
      Pose last = a;
      constexpr int kSteps = 100;
      for (int k = 1; k <= kSteps; ++k) {
        const double s = static_cast<double>(k) / kSteps;
        const Pose here = at(t0 + s * (t1 - t0));
        way += (here.tip - last.tip).norm();
        turned += (here.axis - last.axis).norm();
        last = here;
        ASSERT_LE((here.tip - (1 - s) * a.tip - s * b.tip).norm(), rates.tip_sag_mm + 1e-9) << machine.name;
        ASSERT_LE((here.axis - (1 - s) * a.axis - s * b.axis).norm(), rates.axis_acceleration_rad() / 8 + 1e-11);
      }
      ASSERT_LE(way, rates.tip_path_mm + 1e-9) << machine.name;
      ASSERT_LE(turned, rates.turn_rad + 1e-11) << machine.name;
      // And they are no idle ones: over a short interval they are nearly met.
      if (share < 1.0 / 16) {
        ASSERT_LE(rates.tip_path_mm, 1.1 * way + 1e-6) << machine.name;
      }
    }
  }
}

TEST_P(JointLaws, ChordsOfTheTipAreWithinTheirError) {
  test::Scatter scatter(23);
  for (const Machine& machine : machines_with_rates()) {
    const MotionLaw law = law_of(machine);
    const RandomMove move(machine, scatter);
    const Motion motion = law.of(move.path, 1);
    const std::vector<double> instants = chord_instants(motion, 0.1, 100'000);
    ASSERT_EQ(instants.back(), 1);
    double t0 = 0;
    for (const double t1 : instants) {
      const Vec3 a = motion.at(t0).tip, b = motion.at(t1).tip, middle = motion.at(0.5 * (t0 + t1)).tip;
      ASSERT_LE((middle - 0.5 * (a + b)).norm(), 0.1) << machine.name;
      t0 = t1;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, JointLaws, testing::Values(TurnLaw::joint, TurnLaw::independent),
                         [](const auto& tested) { return std::string(turn_law_name(tested.param)); });

Machine table_of(double x_rate, std::optional<double> y_rate) {
  Machine machine = test::machines()[1];
  for (Joint& joint : machine.joints) joint.rate = 1;
  machine.joints[machine.linear[0]].rate = x_rate;
  machine.joints[machine.linear[1]].rate = y_rate;
  return machine;
}

Toolpath straight_path(const Vec3& to) {
  Toolpath path;
  path.moves.resize(2);
  path.moves[1].end.tip = to;
  path.moves[1].has_start = true;
  path.moves[1].kind = MoveKind::rapid;
  return path;
}

TEST(IndependentJoints, EachArrivesInItsOwnTime) {
  // 30 mm at 60 mm/min and 40 mm at 40 mm/min: X arrives after half of the time.
  const JointLaw law(table_of(60, 40), JointTiming::independent, 0);
  const auto run = law.between({}, {{30, 40, 0}, Vec3::UnitZ()});
  ASSERT_NE(run, nullptr);
  ASSERT_NE(run->tip_path(), nullptr);
  ASSERT_EQ(run->tip_path()->kinks().size(), 1U);
  EXPECT_NEAR(run->tip_path()->kinks()[0], 0.5, 1e-15);
  EXPECT_LT((run->tip_path()->tip_at(0.25) - Vec3(15, 10, 0)).norm(), 1e-12);
  EXPECT_LT((run->tip_path()->tip_at(0.75) - Vec3(30, 30, 0)).norm(), 1e-12);
  EXPECT_NEAR(run->tip_path()->bounds(0, 0.5).length_mm, std::hypot(30, 20), 1e-9);
  EXPECT_NEAR(run->tip_path()->bounds(0.5, 1).length_mm, 20, 1e-9);
  EXPECT_EQ(run->tip_path()->bounds(0, 0.5).acceleration_mm, 0);
}

TEST(IndependentJoints, OneWithoutARateLeavesTheMotionOpenBesideOthersAlone) {
  const auto law = std::make_shared<JointLaw>(table_of(60, std::nullopt), JointTiming::independent, 0);
  EXPECT_EQ(law->between({}, {{30, 40, 0}, Vec3::UnitZ()}), nullptr);
  EXPECT_EQ(law->why_open(straight_path({30, 40, 0}), 1), "the rate of joint Y is not in the machine file");
  EXPECT_NE(law->between({}, {{30, 0, 0}, Vec3::UnitZ()}), nullptr) << "Y stands";
  EXPECT_NE(law->between({}, {{0, 40, 0}, Vec3::UnitZ()}), nullptr) << "Y runs alone";
  EXPECT_TRUE(law->why_open(straight_path({0, 40, 0}), 1).empty());
  EXPECT_FALSE(MotionLaw(RapidMode::straight, law).of(straight_path({30, 40, 0}), 1).is_defined());
}

TEST(JointLaw, AStandingAxisKeepsTheTipOnItsLineOrArc) {
  const auto law = std::make_shared<JointLaw>(test::machines()[0], JointTiming::together, 0);
  const MotionLaw motions(RapidMode::straight, law);
  EXPECT_TRUE(motions.straight({}, {{30, 40, 0}, Vec3::UnitZ()}).is_straight());
  const PathArc arc{.center = {15, 0, 0}, .axis = Vec3::UnitZ(), .sweep_rad = std::numbers::pi};
  EXPECT_TRUE(motions.along({}, {{30, 0, 0}, Vec3::UnitZ()}, arc).is_defined());
  const Vec3 leaning = Vec3(0.1, 0.2, 1).normalized();
  EXPECT_FALSE(motions.along({}, {{30, 0, 0}, leaning}, arc).is_defined()) << "no manual states this motion";
  EXPECT_FALSE(motions.straight({}, {{30, 0, 0}, leaning}).is_straight());
}

// A head is not round: at a position alone it stands as the joints chosen for the path turn it, not as another solution does.
TEST(JointLaw, APositionAloneHasTheJointsOfThePath) {
  const Machine machine = test::machines()[0];
  const RotaryAngles first{0.3, 0.4}, second{0.3 + std::numbers::pi, -0.4};
  for (const RotaryAngles& chosen : {first, second}) {
    Toolpath path;
    path.moves.resize(1);
    path.moves[0].end = {{1, 2, 3}, tool_axes(machine, chosen).col(2)};
    JointPath joints;
    joints.start = {std::nullopt};
    joints.end = {chosen};
    path.joints = std::make_shared<const JointPath>(joints);
    const std::array<std::shared_ptr<const AxisLaw>, 2> laws = {
        std::make_shared<RotaryLaw>(machine), std::make_shared<JointLaw>(machine, JointTiming::together, kLength_mm)};
    for (const auto& law : laws) {
      const Motion motion = MotionLaw(RapidMode::straight, law).of(path, 0);
      EXPECT_TRUE(motion.is_alone());
      EXPECT_LT((motion.axes_at(0) - tool_axes(machine, chosen)).norm(), 1e-12) << law->name();
    }
  }
}

TEST(JointLaw, CurvesAreOpenWhereJointsTurnOrRunIndependently) {
  Toolpath path = straight_path({30, 0, 0});
  path.moves[1].curve_kind = CurveKind::arc;
  path.arcs.push_back({.center = {15, 0, 0}, .axis = Vec3::UnitZ(), .sweep_rad = std::numbers::pi});
  const Machine machine = test::machines()[0];
  EXPECT_TRUE(JointLaw(machine, JointTiming::together, 0).why_open(path, 1).empty());
  EXPECT_NE(JointLaw(machine, JointTiming::independent, 0).why_open(path, 1).find("at their own rates"),
            std::string::npos);
  path.moves[1].end.axis = Vec3(0.1, 0.2, 1).normalized();
  EXPECT_NE(JointLaw(machine, JointTiming::together, 0).why_open(path, 1).find("rotary joints turn"),
            std::string::npos);
}

TEST(JointLaw, AHeadTakesOneToolLength) {
  Toolpath path = straight_path({30, 0, 0});
  path.tools.resize(2);
  EXPECT_NE(JointLaw(test::machines()[3], JointTiming::together, 100).why_open(path, 1).find("the path has 2"),
            std::string::npos);
  EXPECT_TRUE(JointLaw(test::machines()[0], JointTiming::together, 100).why_open(path, 1).empty());
}

TEST(JointLaw, AHeadTakesTheLengthOfEachTool) {
  const Machine machine = test::machines()[3];
  Toolpath path = straight_path({30, 0, 0});
  path.moves[1].end.axis = tool_axes(machine, {0.3, 0.4}).col(2);
  path.tools.resize(2);
  path.moves[1].tool = 1;
  const Pose &from = path.moves[0].end, &to = path.moves[1].end;
  const auto middle = [&](const JointLaw& law) { return law.of_move(&path, 1, from, to)->tip_path()->tip_at(0.5); };
  const JointLaw unknown(machine, JointTiming::together, std::nullopt);
  EXPECT_EQ(unknown.of_move(&path, 1, from, to), nullptr);
  EXPECT_NE(unknown.why_open(path, 1).find("is not stated"), std::string::npos);
  for (const double length_mm : {20.0, 150.0}) {
    path.tools[1].gauge_length_mm = length_mm;
    EXPECT_TRUE(unknown.why_open(path, 1).empty());
    const auto alone = JointLaw(machine, JointTiming::together, length_mm).between(from, to);
    EXPECT_LT((middle(unknown) - alone->tip_path()->tip_at(0.5)).norm(), 1e-9) << length_mm;
    EXPECT_GT((middle(unknown) - 0.5 * (from.tip + to.tip)).norm(), 0.01) << length_mm;
  }
}

TEST(JointLaw, ATableKeepsAPointThatTurnsWithItInReach) {
  // C turns by 90 degrees about the origin of the part, 100 mm from the tip: relative to the part the tip runs on the
  // circle about it, 100 (1 - cos 45) off the chord's middle.
  const Machine machine = test::machines()[1];
  RotaryAngles from{0, 0.5}, to{std::numbers::pi / 2, 0.5};
  Toolpath path = straight_path({30, 0, 0});
  path.joints = std::make_shared<const JointPath>(JointPath{{from}, {to}});
  const JointLaw law(machine, JointTiming::together, 0);
  const auto run = law.of_move(&path, 0, {{100, 0, 0}, tool_axes(machine, from).col(2)},
                               {{0, 100, 0}, tool_axes(machine, to).col(2)});
  ASSERT_NE(run, nullptr);
  ASSERT_NE(run->tip_path(), nullptr);
  EXPECT_NEAR(run->tip_path()->tip_at(0.5).norm(), 100, 1e-9);
  EXPECT_NEAR(run->tip_path()->bounds(0, 1).length_mm, 50 * std::numbers::pi, 2);
}

}  // namespace
}  // namespace gouge::joint_law_test
