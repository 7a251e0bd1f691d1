#include "lib/check/closest_approach.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/paths.h"
#include "tests/support/shapes.h"
#include "tests/support/tools.h"

namespace gouge::closest_approach_test {
namespace {

using paths::upright;

std::optional<ClosestApproach> closest_approach(const Toolpath& path, const ToolVariants& tool = tools::flat(),
                                                unsigned threads = 1, const MoveVerdicts& verdicts = {}) {
  const Scene scene{{shapes::box(Vec3(-50, -50, -30), Vec3(50, 50, 0))}, {}};
  return measure_closest_approach(path, {&tool}, prepare_scene(scene), verdicts, threads);
}

TEST(ClosestApproach, IsTheDistanceOfTheToolFromThePartAtTheEndsOfCuts) {
  Toolpath path = paths::through({upright(0, 0, 9), upright(0, 0, 3), upright(1, 0, 1), upright(2, 0, 2)});
  path.moves[0].kind = MoveKind::rapid;
  const auto found = closest_approach(path);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->cuts, 3U);
  EXPECT_EQ(found->positions, 3U);
  EXPECT_NEAR(*found->nearest_mm, 1, 0.011);
  EXPECT_NEAR(*found->median_mm, 2, 0.011);
}

TEST(ClosestApproach, ACutFromOneSideOfThePartToTheOtherIsNotApart) {
  const auto found = closest_approach(paths::through({upright(-90, 0, 0), upright(90, 0, 0)}));
  EXPECT_NEAR(*found->nearest_mm, 0, 0.011);
  EXPECT_FALSE(found->is_apart());
  EXPECT_NEAR(*closest_approach(paths::through({upright(-90, 0, 7), upright(90, 0, 7)}))->nearest_mm, 7, 0.011);
}

// The tool is nearest at an instant that no equal division of the cut meets: over the corner of the part.
TEST(ClosestApproach, IsThatOfTheWholeCutIfItsEndsAreApart) {
  const auto slanted = closest_approach(paths::through({upright(-90, 0, 32), upright(90, 0, 8)}));
  EXPECT_NEAR(*slanted->nearest_mm, (8 + 24 * 35 / 180.0) * 180 / std::hypot(180, 24), 0.011);
  const auto deep = closest_approach(paths::through({upright(-90, 0, 31), upright(-54, 0, 1), upright(-90, 0, -29)}));
  EXPECT_FALSE(deep->is_apart());
  const auto found = closest_approach(paths::through({upright(-90, 0, 3), upright(90, 0, 3)}));
  EXPECT_EQ(apart_text(*found),
            "at none of 2 cutting positions is the tool nearer than 20.0 mm to the part, and along the path it is not "
            "seen nearer than 3.0 mm");
}

TEST(ClosestApproach, OfTheWholeCutIsNamedWhereItDiffers) {
  EXPECT_EQ(apart_text({1, 1, 2.5, {}, 14.38}),
            "at the only cutting position the tool is not nearer than 14.3 mm to the part, and along the path it is "
            "not seen nearer than 2.5 mm");
  EXPECT_EQ(apart_text({1, 1, 14.385, {}, 14.38}),
            "at the only cutting position the tool is not nearer than 14.3 mm to the part");
}

TEST(ClosestApproach, TouchingAndDeeperIsNothing) {
  const auto found = closest_approach(paths::through({upright(0, 0, 0), upright(0, 0, -2)}));
  EXPECT_LE(*found->nearest_mm, 0);
  EXPECT_LE(*found->median_mm, 0.011);
}

TEST(ClosestApproach, CountsFromTheStockToLeave) {
  const ToolVariants grown = tools::variants(tools::assembly(FlatCutter{10, 30}), 0.5, 0, 0);
  EXPECT_NEAR(*closest_approach(paths::through({upright(0, 0, 0.75)}), grown)->nearest_mm, 0.25, 0.011);
}

TEST(ClosestApproach, WhatIsFarAwayHasNoNumber) {
  const auto found = closest_approach(paths::through({upright(0, 0, 21), upright(0, 0, 25), upright(0, 0, 19)}));
  EXPECT_NEAR(*found->nearest_mm, 19, 0.011);
  EXPECT_FALSE(found->median_mm.has_value());
}

// Every 25th position of a long path touches; steps of 25 from the 13th on never meet one of them.
TEST(ClosestApproach, APatternOfThePathIsNotMissedByEqualSteps) {
  std::vector<Pose> poses;
  for (int i = 0; i < 10'000; ++i) poses.push_back(upright(0.002 * i, 0, i % 25 == 0 ? 0 : 5));
  const auto found = closest_approach(paths::through(poses));
  ASSERT_EQ(found->positions, 400U);
  EXPECT_NEAR(*found->nearest_mm, 0, 0.011);
}

TEST(ClosestApproach, WhatTheCheckHasSeenCounts) {
  std::vector<Pose> poses;
  for (int i = 0; i < 5000; ++i) poses.push_back(upright(0.002 * i, 0, 5));
  Toolpath path = paths::through(poses);
  MoveVerdicts verdicts(poses.size());
  const auto nearest = [&] { return closest_approach(path, tools::flat(), 1, verdicts)->nearest_mm.value_or(99); };
  EXPECT_NEAR(nearest(), 5, 0.011);
  MoveVerdict& dive = verdicts[7];
  dive.witness = Witness{0.5, {0, 0, -3}, {0, 0, 1}, Body::cutter, Against::part, 0, 0};
  dive.clearance_mm = 1.25;
  EXPECT_DOUBLE_EQ(nearest(), 1.25) << "a near move";
  dive.clearance_mm.reset();
  dive.depth_mm = 3;
  EXPECT_DOUBLE_EQ(nearest(), 0) << "a dive between two positions 5 mm above the part";
  path.moves[7].kind = MoveKind::rapid;
  EXPECT_NEAR(nearest(), 5, 0.011) << "a rapid does not cut";
  path.moves[7].kind = MoveKind::feed;
  dive.witness->against = Against::fixture;
  EXPECT_NEAR(nearest(), 5, 0.011);
  dive.witness->against = Against::part;
  dive.witness->body = Body::head;
  EXPECT_NEAR(nearest(), 5, 0.011);
}

TEST(ClosestApproach, SaysNothingWithoutCutsOrParts) {
  EXPECT_FALSE(closest_approach(paths::through({upright(0, 0, 1)}, MoveKind::rapid)).has_value());
  const ToolVariants tool = tools::flat();
  const Toolpath path = paths::through({upright(0, 0, 1)});
  EXPECT_FALSE(measure_closest_approach(path, {nullptr}, prepare_scene(Scene{}), {}, 1).has_value());
  EXPECT_FALSE(measure_closest_approach(path, {&tool}, prepare_scene(Scene{}), {}, 1).has_value());
}

TEST(ClosestApproach, OfALongPathSomePositionsAreLookedAtWhateverTheThreads) {
  std::vector<Pose> poses;
  for (int i = 0; i < 10'000; ++i) poses.push_back(upright(0.002 * i, 0, 1 + 1e-3 * i));
  const auto one = closest_approach(paths::through(poses));
  const auto four = closest_approach(paths::through(poses), tools::flat(), 4);
  EXPECT_EQ(one->cuts, 10'000U);
  EXPECT_EQ(one->positions, 400U);
  EXPECT_NEAR(*one->median_mm, 6, 0.05);
  EXPECT_EQ(one->nearest_mm, four->nearest_mm);
  EXPECT_EQ(one->median_mm, four->median_mm);
}

}  // namespace
}  // namespace gouge::closest_approach_test
