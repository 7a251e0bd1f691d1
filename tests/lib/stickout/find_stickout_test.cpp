#include "lib/stickout/find_stickout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/paths.h"
#include "tests/support/scatter.h"
#include "tests/support/shapes.h"
#include "tests/support/whole_check.h"
#include "toolmodels/assembly.h"
#include "toolmodels/compile_tool.h"

namespace gouge::find_stickout_test {
namespace {

using test::Scatter;

/// A cutter D10 with a holder D40 that stands 40 mm above the tip.
ToolAssembly held_tool() {
  ToolAssembly tool;
  tool.number = 1;
  tool.cutter = FlatCutter{10, 25};
  tool.shank = {{10, 10, 15}};
  tool.holder = {{40, 40, 50}};
  return tool;
}

/// A path of one tool over a scene, and the options for both.
struct Problem {
  ToolAssembly tool = held_tool();
  Scene scene;
  Toolpath path;
  StickoutOptions options{1, 60};
  CheckOptions check_options;
  std::vector<IndexedMesh> heads;

  [[nodiscard]] LongerTool longer(double longer_mm) const {
    LongerTool made{*make_non_cutting_variants(with_longer_stickout(tool, longer_mm), check_options.shank_clearance_mm,
                                               check_options.holder_clearance_mm),
                    {}};
    for (const IndexedMesh& head : heads)
      made.heads.push_back(*build_head_body(shapes::moved(head, {0, 0, longer_mm})));
    return made;
  }

  [[nodiscard]] ToolStickout solve() const {
    const ToolVariants whole =
        *make_tool_variants(tool, 0, check_options.shank_clearance_mm, check_options.holder_clearance_mm);
    std::vector<HeadBody> bodies;
    for (const IndexedMesh& head : heads) bodies.push_back(*build_head_body(head));
    const OwnSetup own(&whole, scene, check_options, bodies);
    const CheckResult result = check(path, own.setup);
    const auto found = find_stickouts(
        path, result, own.setup, {stickout_mm(tool)}, [&](std::size_t, double by) { return Result(longer(by)); },
        options);
    EXPECT_TRUE(found.has_value());
    EXPECT_EQ(found->size(), 1U);
    return found->front();
  }

  /// Returns whether shank, holder and heads gouge in no move with this stick-out.
  [[nodiscard]] bool is_free(double at_mm) const {
    const LongerTool made = longer(at_mm - stickout_mm(tool));
    const OwnSetup own(&made.bodies, scene, check_options, made.heads);
    const CheckResult result = check(path, own.setup);
    return result.counts.gouge == 0 && result.counts.buried == 0 && result.counts.not_certified == 0;
  }
};

/// The tip runs along a wall `wall_mm` high, 10 mm beside it: the cutter passes, the holder does not.
Problem along_wall(double wall_mm) {
  Problem problem;
  problem.scene.parts = {shapes::box(Vec3(10, -50, -10), Vec3(60, 50, wall_mm))};
  problem.path = paths::through({paths::upright(0, -30, 100), paths::upright(0, -30, 0), paths::upright(0, 30, 0)});
  return problem;
}

TEST(FindStickout, TheHolderClearsAWallWhenItIsAsHighAsTheWall) {
  for (const auto& [wall_mm, step_mm, needed_mm] :
       {std::array{55.0, 1.0, 55.0}, {55.3, 1.0, 56.0}, {55.3, 0.25, 55.5}, {40.005, 1.0, 40.0}, {40.02, 5.0, 45.0}}) {
    Problem problem = along_wall(wall_mm);
    problem.options.step_mm = step_mm;
    const ToolStickout found = problem.solve();
    ASSERT_TRUE(found.all.stickout_mm) << wall_mm;
    EXPECT_NEAR(*found.all.stickout_mm, needed_mm, 1e-9) << wall_mm << " step " << step_mm;
    EXPECT_EQ(found.all.is_enough(), needed_mm <= 40);
    if (found.all.is_enough()) continue;
    EXPECT_EQ(found.all.body, Body::holder);
    EXPECT_GE(found.all.move, 1U);
    EXPECT_TRUE(problem.is_free(needed_mm));
    EXPECT_FALSE(problem.is_free(std::max(40.0, needed_mm - step_mm)));
  }
}

TEST(FindStickout, ClearancesCount) {
  Problem problem = along_wall(55);
  problem.check_options.holder_clearance_mm = 2;
  EXPECT_NEAR(*problem.solve().all.stickout_mm, 57, 1e-9);
}

TEST(FindStickout, TheHeadGoesUpWithTheHolder) {
  Problem problem = along_wall(70);
  problem.heads = {shapes::box(Vec3(-30, -30, 60), Vec3(30, 30, 120))};
  const ToolStickout found = problem.solve();
  EXPECT_NEAR(*found.all.stickout_mm, 70, 1e-9) << "the holder asks for more than the head, 50";
  problem.tool.holder = {{15, 15, 20}};
  const ToolStickout thin = problem.solve();
  EXPECT_NEAR(*thin.all.stickout_mm, 50, 1e-9);
  EXPECT_EQ(thin.all.body, Body::head);
}

TEST(FindStickout, AToolOfFlutesAloneRisesWithItsHead) {
  Problem problem = along_wall(70);
  problem.tool.shank.clear();
  problem.tool.holder.clear();
  problem.heads = {shapes::box(Vec3(-30, -30, 60), Vec3(30, 30, 120))};
  const ToolStickout found = problem.solve();
  EXPECT_NEAR(*found.all.stickout_mm, 25 + 10, 1e-9);
  EXPECT_EQ(found.all.body, Body::head);
}

TEST(FindStickout, SaysWhatIsInTheWayWhereNoneHelps) {
  Problem problem = along_wall(150);
  const ToolStickout found = problem.solve();
  EXPECT_FALSE(found.all.stickout_mm);
  EXPECT_FALSE(found.all.is_enough());
  EXPECT_EQ(found.all.body, Body::holder);
  EXPECT_FALSE(problem.is_free(100));
}

TEST(FindStickout, WhatTheCutterCutsIsNoMatterOfTheStickout) {
  Problem problem;
  problem.scene.parts = {shapes::box(Vec3(-50, -50, -10), Vec3(50, 50, 2))};
  problem.path = paths::through({paths::upright(0, -30, 0), paths::upright(0, 30, 0)});
  EXPECT_TRUE(problem.solve().all.is_enough());
}

TEST(FindStickout, EachOperationHasItsOwn) {
  Problem problem = along_wall(55);
  problem.scene.parts.push_back(shapes::box(Vec3(10, 100, -10), Vec3(60, 200, 47)));
  problem.path = paths::through({paths::upright(0, -30, 100), paths::upright(0, -30, 0), paths::upright(0, 30, 0),
                                 paths::upright(0, 30, 100), paths::upright(0, 130, 100), paths::upright(0, 130, 0),
                                 paths::upright(0, 170, 0), paths::upright(0, 170, 100), paths::upright(-90, 0, 100)});
  problem.path.operations.resize(3);
  for (std::size_t i = 0; i < 9; ++i) problem.path.moves[i].operation = i < 4 ? 0 : i < 8 ? 1 : 2;
  const ToolStickout found = problem.solve();
  ASSERT_EQ(found.operations.size(), 3U);
  EXPECT_NEAR(*found.operations[0].need.stickout_mm, 55, 1e-9);
  EXPECT_NEAR(*found.operations[1].need.stickout_mm, 47, 1e-9);
  EXPECT_TRUE(found.operations[2].need.is_enough());
  EXPECT_NEAR(*found.all.stickout_mm, 55, 1e-9);
}

// The holder has a groove that a rib fits into: longer is not always freer, and the result is free all the same.
TEST(FindStickout, ALongerToolThatMeetsWhatTheShorterOneMissedGoesOn) {
  Problem problem;
  problem.tool.holder = {{40, 40, 5}, {12, 12, 10}, {40, 40, 30}};
  // Two ribs from the side: one at the height of the lower collar, the other in the groove.
  problem.scene.parts = {shapes::box(Vec3(10, -50, 41), Vec3(60, 50, 44)),
                         shapes::box(Vec3(-60, -50, 47), Vec3(-10, 50, 52))};
  problem.path = paths::through({paths::upright(0, -30, 0), paths::upright(0, 30, 0)});
  const ToolStickout found = problem.solve();
  ASSERT_TRUE(found.all.stickout_mm);
  EXPECT_TRUE(problem.is_free(*found.all.stickout_mm)) << *found.all.stickout_mm;
  EXPECT_NEAR(*found.all.stickout_mm, 52, 1e-9);
}

// Boxes and tilted positions at random: as an exhaustive search states.
TEST(FindStickout, IsTheLeastOfAllForToolsThatGetWiderUpwards) {
  Scatter random(71);
  int needing = 0, none = 0;
  for (int i = 0; i < 60; ++i) {
    Problem problem;
    const double wide = random.in(20, 40);
    problem.tool.holder = {{wide, wide + random.in(0, 20), random.in(20, 120)}};
    problem.tool.shank = {{random.in(8, 10), random.in(10, 16), 15}};
    problem.options = {random.in(0.5, 4), 40};
    for (std::size_t k = 1 + random.below(3); k > 0; --k) {
      const Vec3 low(random.in(8, 25), random.in(-40, 20), -20);
      problem.scene.parts.push_back(shapes::box(low, low + Vec3(20, random.in(5, 60), random.in(20, 100))));
    }
    std::vector<Pose> poses;
    for (int k = 0; k < 4; ++k)
      poses.push_back({Vec3(random.in(-10, 0), random.in(-30, 30), random.in(0, 10)),
                       Vec3(random.in(-0.2, 0.2), random.in(-0.2, 0.2), 1).normalized()});
    problem.path = paths::through(poses);
    const ToolStickout found = problem.solve();
    std::optional<double> least;
    const double step = problem.options.step_mm, now = stickout_mm(problem.tool);
    if (problem.is_free(now)) least = now;
    for (double k = 1; !least && k <= std::floor(problem.options.max_longer_mm / step); ++k) {
      const double at = (std::floor(now / step + 1e-9) + k) * step;
      if (problem.is_free(at)) least = at;
    }
    ASSERT_EQ(found.all.stickout_mm.has_value(), least.has_value()) << i;
    EXPECT_NEAR(found.all.stickout_mm.value_or(0), least.value_or(0), 1e-9) << i;
    needing += least && *least > now ? 1 : 0;
    none += least ? 0 : 1;
  }
  EXPECT_GT(needing, 10);
  EXPECT_GT(none, 3);
}

}  // namespace
}  // namespace gouge::find_stickout_test
