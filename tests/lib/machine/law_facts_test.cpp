#include "lib/machine/law_facts.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "lib/base/units.h"
#include "tests/lib/machine/machines.h"

// Facts that laws need, doubts about machines, and the tool axes that machines reach.

namespace gouge::law_facts_test {
namespace {

using Kind = MissingFact::Kind;
using Doubt = MachineDoubt::Kind;

constexpr std::size_t kTrunnion = 0, kTableHead = 2, kNutating = 4;

std::vector<Kind> kinds_of(const std::vector<MissingFact>& facts) {
  std::vector<Kind> kinds;
  for (const MissingFact& fact : facts) kinds.push_back(fact.kind);
  return kinds;
}

bool has_doubt(const Machine& machine, Doubt kind, const std::vector<std::size_t>& joints) {
  const std::vector<MachineDoubt> doubts = find_doubts(machine);
  const auto found = std::ranges::find(doubts, kind, &MachineDoubt::kind);
  return found != doubts.end() && found->joints == joints;
}

TEST(LawFacts, LawsThatKeepTheTipOnItsLineNeedNone) {
  Machine machine = test::machines()[kTableHead];
  for (Joint& joint : machine.joints) joint.has_point = false;
  EXPECT_TRUE(missing_facts(machine, TurnLaw::vector, false).empty());
  EXPECT_TRUE(missing_facts(machine, TurnLaw::axis, false).empty());
}

TEST(LawFacts, LawsOfAllJointsNeedPointsTheToolLengthAndRates) {
  Machine machine = test::machines()[kTableHead];
  EXPECT_EQ(kinds_of(missing_facts(machine, TurnLaw::joint, false)), (std::vector{Kind::tool_length}));
  EXPECT_TRUE(missing_facts(machine, TurnLaw::joint, true).empty());
  EXPECT_TRUE(missing_facts(test::machines()[kTrunnion], TurnLaw::joint, false).empty()) << "no rotary head";
  machine.joints[machine.rotary[0]].has_point = false;
  EXPECT_EQ(kinds_of(missing_facts(machine, TurnLaw::joint, false)), (std::vector{Kind::point, Kind::tool_length}));
  for (std::size_t k = 0; k < 4; ++k) machine.joints[k].rate = 1;
  const std::vector<MissingFact> missing = missing_facts(machine, TurnLaw::independent, true);
  EXPECT_EQ(kinds_of(missing), (std::vector{Kind::point, Kind::rate}));
  EXPECT_EQ(missing[1].joint, 4U);
}

TEST(LawFacts, DoubtsNameTheirJoints) {
  Machine machine = test::machines()[kTrunnion];
  EXPECT_TRUE(has_doubt(machine, Doubt::no_linear_limits, {2, 3, 4}));
  EXPECT_TRUE(has_doubt(machine, Doubt::no_rate, {0, 1, 2, 3, 4}));
  EXPECT_FALSE(has_doubt(machine, Doubt::no_limits, {1})) << "it turns without end";
  machine.joints[1].is_continuous = false;
  EXPECT_TRUE(has_doubt(machine, Doubt::no_limits, {1}));
  machine.joints[1].min = machine.joints[1].max = 0.5;
  machine.joints[1].preference = -1;
  EXPECT_TRUE(has_doubt(machine, Doubt::fixed, {1}));
  EXPECT_TRUE(has_doubt(machine, Doubt::not_at_zero, {1}));
  EXPECT_TRUE(has_doubt(machine, Doubt::preference, {1}));
  machine.joints[1].direction = Vec3::UnitZ();
  EXPECT_TRUE(has_doubt(machine, Doubt::idle, {1}));
}

TEST(LawFacts, TheReachFollowsFromTheArrangementAndTheLimits) {
  Machine trunnion = test::machines()[kTrunnion];
  EXPECT_NEAR(measure_reach(trunnion).whole, 180 * kDegree_rad, 1e-9);
  trunnion.joints[1].is_continuous = false;
  trunnion.joints[1].min = -30 * kDegree_rad;
  trunnion.joints[1].max = 100 * kDegree_rad;
  AxisReach reach = measure_reach(trunnion);
  EXPECT_NEAR(reach.whole, 100 * kDegree_rad, 1e-9) << "C turns every direction to the side of the larger tilt";
  EXPECT_NEAR(reach.most, 100 * kDegree_rad, 1e-9);
  trunnion.joints[1].min = 10 * kDegree_rad;
  reach = measure_reach(trunnion);
  EXPECT_LT(reach.whole, 0);
  EXPECT_NEAR(reach.least, 10 * kDegree_rad, 1e-9);
  trunnion.joints[1].min = -30 * kDegree_rad;
  trunnion.joints[0].is_continuous = false;
  trunnion.joints[0].min = -90 * kDegree_rad;
  trunnion.joints[0].max = 90 * kDegree_rad;
  reach = measure_reach(trunnion);
  EXPECT_NEAR(reach.whole, 30 * kDegree_rad, 1e-9) << "beyond it C would have to turn";
  EXPECT_NEAR(reach.most, 100 * kDegree_rad, 1e-9);
  EXPECT_NEAR(measure_reach(test::machines()[kNutating]).whole, 90 * kDegree_rad, 1e-9);
}

}  // namespace
}  // namespace gouge::law_facts_test
