#include "cli/machine/joint_facts.h"

#include <gtest/gtest.h>

#include "lib/base/units.h"
#include "lib/machine/read_machine.h"

// Facts of joints that the user states in place of those of the machine file.

namespace gouge::joint_facts_test {
namespace {

Machine umc750() { return read_machine("umc", find_preset("haas-umc750")->text).value(); }

constexpr std::size_t kC = 0, kB = 1, kX = 2;

TEST(JointFacts, ReplaceThoseOfTheFile) {
  Machine machine = umc750();
  StatedJoints stated;
  stated.limits = {"C=-180..180", "B=-35..110", "X=0..1in"};
  stated.points = {"C=1,2,3", "B=0,0,-2in"};
  stated.rates = {"B=3600", "X=40in"};
  EXPECT_FALSE(state_joints(stated, {}, machine));
  EXPECT_FALSE(machine.joints[kC].is_continuous);
  EXPECT_DOUBLE_EQ(*machine.joints[kC].max, 180 * kDegree_rad);
  EXPECT_DOUBLE_EQ(*machine.joints[kB].min, -35 * kDegree_rad);
  EXPECT_DOUBLE_EQ(*machine.joints[kX].min, 0);
  EXPECT_DOUBLE_EQ(*machine.joints[kX].max, 25.4);
  EXPECT_TRUE(machine.joints[kC].has_point);
  EXPECT_EQ(machine.joints[kC].point, Vec3(1, 2, 3));
  EXPECT_EQ(machine.joints[kB].point, Vec3(0, 0, -50.8));
  EXPECT_DOUBLE_EQ(*machine.joints[kB].rate, 3600 * kDegree_rad);
  EXPECT_DOUBLE_EQ(*machine.joints[kX].rate, 1016);
}

TEST(JointFacts, ASideThatIsLeftOutHasNoLimit) {
  Machine machine = umc750();
  machine.joints[kB].min = -1;
  StatedJoints stated;
  stated.limits = {"B=..120"};
  EXPECT_FALSE(state_joints(stated, {}, machine));
  EXPECT_FALSE(machine.joints[kB].min);
  EXPECT_DOUBLE_EQ(*machine.joints[kB].max, 120 * kDegree_rad);
  stated.limits = {"B=-1.5.."};
  EXPECT_FALSE(state_joints(stated, {}, machine));
  EXPECT_FALSE(machine.joints[kB].max);
  EXPECT_DOUBLE_EQ(*machine.joints[kB].min, -1.5 * kDegree_rad);
  stated.limits = {"B=free"};
  EXPECT_FALSE(state_joints(stated, {}, machine));
  EXPECT_TRUE(machine.joints[kB].is_continuous);
  EXPECT_FALSE(machine.joints[kB].min);
}

TEST(JointFacts, WrongTextsAreRefusedWithTheirOption) {
  const struct {
    std::vector<std::string> StatedJoints::*field;
    std::vector<std::string> texts;
    std::string expected;
  } kCases[] = {{&StatedJoints::limits,
                 {"Q=0..1"},
                 "--joint-limit 'Q=0..1': expected JOINT=VALUE with one of the joints C, B, X, Y, Z"},
                {&StatedJoints::limits, {"B"}, "one of the joints C, B, X, Y, Z"},
                {&StatedJoints::limits, {"B=5"}, "expected LOW..HIGH in degrees"},
                {&StatedJoints::limits, {"B=.."}, "expected LOW..HIGH in degrees"},
                {&StatedJoints::limits, {"B=2..1"}, "expected LOW..HIGH in degrees"},
                {&StatedJoints::limits, {"B=0..1mm"}, "expected LOW..HIGH in degrees"},
                {&StatedJoints::limits, {"X=free"}, "expected LOW..HIGH in mm"},
                {&StatedJoints::limits, {"B=0..1", "B=0..2"}, "'B=0..2': expected each joint at most once"},
                {&StatedJoints::points, {"X=0,0,0"}, "a linear one has no point"},
                {&StatedJoints::points, {"B=0,0"}, "expected X,Y,Z"},
                {&StatedJoints::points, {"B=0,0,0,0,0,0"}, "expected X,Y,Z"},
                {&StatedJoints::rates, {"B=0"}, "expected a rate above 0"},
                {&StatedJoints::rates, {"X=fast"}, "expected a rate above 0 in mm per minute"}};
  for (const auto& one : kCases) {
    Machine machine = umc750();
    StatedJoints stated;
    stated.*one.field = one.texts;
    const auto error = state_joints(stated, {}, machine);
    ASSERT_TRUE(error) << one.expected;
    EXPECT_EQ(error->code, "usage");
    EXPECT_NE(error->message.find(one.expected), std::string::npos) << error->message;
  }
}

}  // namespace
}  // namespace gouge::joint_facts_test
