#include <gtest/gtest.h>

#include "lib/machine/joint_law.h"
#include "lib/machine/kinematics.h"
#include "lib/machine/law_facts.h"
#include "tests/lib/machine/machines.h"
#include "tests/lib/machine/random_moves.h"

// The place of the part in motions of the joints, on chains with joints in any order, against matrices of the test's own.

namespace gouge::part_zero_law_test {
namespace {

constexpr double kLength_mm = 120;

/// Returns the machine with a part elsewhere: the head and the gauge point lie at another place above the table.
Machine shifted(Machine machine, const Vec3& by) {
  for (Joint& joint : machine.joints)
    if (joint.side == JointSide::head) joint.point -= by;
  machine.rest.shift -= by;
  return machine;
}

/// Returns how far the tips come apart in random moves with two places of the part.
double largest_difference(const Machine& machine, TurnLaw law, test::Scatter& scatter) {
  const double x = scatter.in(100, 300), y = scatter.in(-300, -100), z = scatter.in(100, 300);
  return test::largest_difference(machine, test::MachineReference(machine, kLength_mm),
                                  test::MachineReference(shifted(machine, {x, y, z}), kLength_mm), law, scatter);
}

TEST(PlaceOfThePart, MattersExactlyWhereTheTipDependsOnIt) {
  test::Scatter scatter(91);
  std::size_t free = 0, bound = 0;
  for (int n = 0; n < 400; ++n) {
    const Machine machine = test::random_chain(scatter, n % 4 == 3);
    const bool depends = depends_on_part_zero(machine);
    ++(depends ? bound : free);
    for (const TurnLaw law : {TurnLaw::joint, TurnLaw::independent}) {
      const double difference_mm = largest_difference(machine, law, scatter);
      if (depends)
        EXPECT_GT(difference_mm, 1e-3) << machine.name << " by " << turn_law_name(law);
      else
        EXPECT_LT(difference_mm, 1e-8) << machine.name << " by " << turn_law_name(law);
      EXPECT_EQ(missing_facts(machine, law, true).size(), depends ? 1U : 0U) << machine.name;
      EXPECT_TRUE(missing_facts(place_part(machine, test::random_zero(scatter)), law, true).empty()) << machine.name;
    }
  }
  EXPECT_GT(free, 20U);
  EXPECT_GT(bound, 20U);
}

TEST(PlaceOfThePart, IsNeededWithAQuillBehindARotaryHead) {
  const auto table = JointSide::table, head = JointSide::head;
  const Machine machine = test::machine("quill", {test::rotary("C", Vec3::UnitZ(), table), test::kX, test::kY,
                                                  test::rotary("B", Vec3::UnitY(), head), test::kZ});
  ASSERT_TRUE(depends_on_part_zero(machine));
  Toolpath path;
  path.moves.resize(2);
  path.moves[1].end.axis = tool_axes(machine, {0, 1}).col(2);
  path.moves[1].has_start = true;
  const JointLaw law(machine, JointTiming::together, kLength_mm);
  EXPECT_NE(law.why_open(path, 1).find("expected --zero"), std::string::npos);
  EXPECT_EQ(law.between(path.moves[0].end, path.moves[1].end), nullptr);
  const JointLaw placed(place_part(machine, {}), JointTiming::together, kLength_mm);
  EXPECT_EQ(placed.why_open(path, 1), "");
  EXPECT_NE(placed.between(path.moves[0].end, path.moves[1].end), nullptr);
  for (const Machine& usual : test::machines()) EXPECT_FALSE(depends_on_part_zero(usual)) << usual.name;
}

}  // namespace
}  // namespace gouge::part_zero_law_test
