#include "lib/certify/settle_ways.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/support/paths.h"
#include "tests/support/shapes.h"
#include "tests/support/tools.h"
#include "tests/support/whole_check.h"

// The ways to the first position of a tool and from its last one, which CL data do not state.

namespace gouge::settle_ways_test {
namespace {

/// A T-slot of 26 mm with a neck of 10 mm, open at both ends, along Y.
Scene slot() {
  return {{shapes::box({-50, 0, -40}, {50, 100, -27}), shapes::box({-50, 0, -27}, {-13, 100, 0}),
           shapes::box({13, 0, -27}, {50, 100, 0}), shapes::box({-13, 0, -14}, {-5, 100, 0}),
           shapes::box({5, 0, -14}, {13, 100, 0})},
          {}};
}

ToolVariants cutter_of_slot() { return tools::variants(tools::assembly(TSlotCutter{22, 0, 0, 9}, 8)); }

Toolpath of_file(const std::vector<Pose>& poses) {
  Toolpath path = paths::through(poses);
  path.moves.front().begins_stretch = true;
  path.assumptions.push_back({.subject = Subject::completeness, .basis = Basis::derived, .value = "whole file"});
  return path;
}

Assumption complete_of(const Toolpath& path, const ToolVariants& tool, const Scene& scene) {
  for (const Assumption& fact : whole_check(path, &tool, scene).assumptions) {
    if (fact.subject == Subject::completeness) return fact;
  }
  throw std::logic_error("no fact complete");
}

const Pose kOutside = paths::upright(0, -30, -25), kInside = paths::upright(0, 50, -25);

TEST(Ways, ThatAreFreeAlongTheAxisAreADefault) {
  const Assumption fact =
      complete_of(of_file({kOutside, kInside, paths::upright(0, 130, -25)}), cutter_of_slot(), slot());
  EXPECT_EQ(fact.basis, Basis::by_default);
  EXPECT_EQ(fact.value, "whole file without 2 ways to and from the part");
  EXPECT_FALSE(fact.is_open);
}

TEST(Ways, FromAnUndercutAreUnknown) {
  const Assumption fact = complete_of(of_file({kOutside, kInside}), cutter_of_slot(), slot());
  EXPECT_EQ(fact.basis, Basis::unknown);
  EXPECT_EQ(fact.code, "path-ways");
  EXPECT_EQ(fact.line, 2U);
  EXPECT_TRUE(fact.evidence.starts_with("the tool cannot leave line 2 along its axis without a gouge of "))
      << fact.evidence;
}

TEST(Ways, IntoAnUndercutAreUnknown) {
  const Assumption fact = complete_of(of_file({kInside, kOutside}), cutter_of_slot(), slot());
  EXPECT_EQ(fact.basis, Basis::unknown);
  EXPECT_EQ(fact.line, 1U);
  EXPECT_TRUE(fact.evidence.starts_with("the tool cannot come to line 1 along its axis")) << fact.evidence;
}

TEST(Ways, BetweenTwoStretchesAreThoseFromTheFirstAndToTheSecond) {
  Toolpath path = of_file({kOutside, kInside, kOutside, paths::upright(0, -40, -25)});
  path.moves[2].has_start = false;
  EXPECT_EQ(complete_of(path, cutter_of_slot(), slot()).basis, Basis::by_default) << "no way is missing there";
  path.moves[2].begins_stretch = true;
  const Assumption fact = complete_of(path, cutter_of_slot(), slot());
  EXPECT_EQ(fact.basis, Basis::unknown);
  EXPECT_EQ(fact.line, 2U);
}

TEST(Ways, FromPositionsThatAreNotCleanAreLeftOut) {
  Toolpath path = of_file({kOutside, kInside});
  path.moves[1].not_checked_reason = "not understood";
  EXPECT_EQ(complete_of(path, cutter_of_slot(), slot()).basis, Basis::by_default);
}

TEST(Ways, UnderCutterCompensationAreThoseOfTheWiderTool) {
  const ToolVariants tool = make_tool_variants({1, "short", FlatCutter{8, 15}, {}, {}}, 0, 0, 0, true).value();
  const Scene overhang{{shapes::box({6, -50, 60}, {40, 50, 70})}, {}};
  Toolpath path = of_file({paths::upright(0, -20, 0), paths::upright(0, 20, 0)});
  EXPECT_EQ(complete_of(path, tool, overhang).basis, Basis::by_default);
  for (Move& move : path.moves) {
    move.not_checked_reason = "compensated";
    move.cover = Cover::wide;
  }
  EXPECT_EQ(complete_of(path, tool, overhang).basis, Basis::unknown);
}

TEST(Ways, OfEveryShapeLeaveAWallThatTheyTouch) {
  for (const ToolVariants& tool : tools::all()) {
    const double radius = tool.bare.r_max_mm;
    const Scene wall{
        {shapes::box({radius, -50, -10}, {radius + 20, 50, 30}), shapes::box({-50, -50, -20}, {50, 50, -10})}, {}};
    const Assumption fact = complete_of(of_file({paths::upright(0, -20, -10), paths::upright(0, 20, -10)}), tool, wall);
    EXPECT_EQ(fact.basis, Basis::by_default) << fact.evidence;
  }
}

TEST(Ways, OfAFileThatIsCutShortAddNothing) {
  Toolpath path = of_file({kOutside, kInside});
  path.assumptions.front().basis = Basis::unknown;
  EXPECT_EQ(complete_of(path, cutter_of_slot(), slot()).value, "whole file");
}

}  // namespace
}  // namespace gouge::settle_ways_test
