#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "lib/machine/joint_law.h"
#include "lib/machine/kinematics.h"
#include "lib/machine/law_facts.h"
#include "lib/motion/motion_law.h"
#include "tests/lib/machine/machines.h"
#include "tests/lib/machine/random_moves.h"

// The tool length in motions of the joints, on chains with joints in any order, against matrices of the test's own.

namespace gouge::tool_length_test {
namespace {

using Ends = test::MachineReference::Ends;

constexpr double kShort_mm = 40, kLong_mm = 140;

/// Returns how far the tips of a short and of a long tool come apart in random moves.
double largest_difference(const Machine& machine, TurnLaw law, test::Scatter& scatter) {
  return test::largest_difference(machine, test::MachineReference(machine, kShort_mm),
                                  test::MachineReference(machine, kLong_mm), law, scatter);
}

TEST(ToolLength, MattersExactlyWhereTheTipDependsOnIt) {
  test::Scatter scatter(81);
  std::size_t free = 0, bound = 0;
  for (int n = 0; n < 400; ++n) {
    const Machine machine = test::random_chain(scatter, n % 4 == 3);
    const bool depends = depends_on_tool_length(machine);
    ++(depends ? bound : free);
    for (const TurnLaw law : {TurnLaw::joint, TurnLaw::independent}) {
      const double difference_mm = largest_difference(machine, law, scatter);
      if (depends)
        EXPECT_GT(difference_mm, 1e-3) << machine.name << " by " << turn_law_name(law);
      else
        EXPECT_LT(difference_mm, 1e-8) << machine.name << " by " << turn_law_name(law);
      EXPECT_EQ(missing_facts(place_part(machine, {}), law, false).size(), depends ? 1U : 0U) << machine.name;
    }
    const Machine placed = place_part(machine, test::random_zero(scatter));
    EXPECT_EQ(depends_on_tool_length(placed), depends) << machine.name << " with a part zero";
  }
  EXPECT_GT(free, 20U);
  EXPECT_GT(bound, 20U);
}

TEST(ToolLength, EveryChainMovesTheToolAsTheMatricesDo) {
  test::Scatter scatter(82);
  int compared = 0;
  for (int n = 0; n < 400; ++n) {
    const Machine machine = place_part(test::random_chain(scatter, n % 4 == 3), {});
    const test::MachineReference reference(machine, kLong_mm);
    const Ends ends = reference.with_joints(test::random_ends(machine, scatter));
    if (!test::is_within_travel(ends)) continue;
    Toolpath path;
    path.joints = std::make_shared<const JointPath>(JointPath{{ends.angles0}, {ends.angles1}});
    path.moves.resize(1);
    for (const TurnLaw law : {TurnLaw::joint, TurnLaw::independent}) {
      const JointTiming timing = law == TurnLaw::joint ? JointTiming::together : JointTiming::independent;
      const JointLaw joints(machine, timing, kLong_mm);
      const auto run = joints.of_move(&path, 0, ends.from, ends.to);
      if (run == nullptr) continue;
      ++compared;
      for (double t = 0; t <= 1; t += 1.0 / 32)
        ASSERT_LT((run->tip_path()->tip_at(t) - reference.at(law, ends, t).tip).norm(), 1e-7) << machine.name;
    }
  }
  EXPECT_GT(compared, 400);
}

/// A slide Z between both rotary joints of the table.
Machine slide_on_trunnion() {
  const auto table = JointSide::table;
  Joint z = test::kZ;
  z.side = table;
  return test::machine("slide", {test::rotary("C", Vec3::UnitZ(), table), z, test::rotary("A", Vec3::UnitX(), table),
                                 test::kY, test::kX});
}

TEST(ToolLength, MattersWithASlideBetweenTwoJointsOfTheTable) {
  const Machine machine = slide_on_trunnion();
  EXPECT_TRUE(depends_on_tool_length(machine));
  Toolpath path;
  path.moves.resize(2);
  path.moves[1].end.axis = tool_axes(machine, {0, -1}).col(2);
  path.moves[1].has_start = true;
  const JointLaw law(machine, JointTiming::together, std::nullopt);
  EXPECT_NE(law.why_open(path, 1).find("is not stated"), std::string::npos);
  EXPECT_EQ(law.between(path.moves[0].end, path.moves[1].end), nullptr);
}

TEST(ToolLength, DoesNotMatterWhereTheSlideRunsAlongTheTool) {
  const auto head = JointSide::head;
  Machine machine = test::machine("Z before C alone", {test::kZ, test::rotary("C", Vec3::UnitZ(), head),
                                                       test::rotary("A", Vec3::UnitX(), head), test::kX, test::kY});
  EXPECT_TRUE(depends_on_tool_length(machine)) << "A turns the tool, and not Z";
  machine = test::machine("Z last", {test::kX, test::kY, test::rotary("C", Vec3::UnitZ(), head),
                                     test::rotary("A", Vec3::UnitX(), head), test::kZ});
  EXPECT_FALSE(depends_on_tool_length(machine)) << "Z is a quill in the head";
}

}  // namespace
}  // namespace gouge::tool_length_test
