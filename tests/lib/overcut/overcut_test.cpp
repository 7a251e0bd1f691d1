#include <gtest/gtest.h>

#include "lib/check/overcut_gap.h"
#include "lib/overcut/overcut_search.h"
#include "lib/overcut/swept_tool.h"
#include "lib/surface/surface.h"
#include "tests/support/motions.h"
#include "tests/support/paths.h"
#include "tests/support/revolved_heads.h"
#include "tests/support/scatter.h"
#include "tests/support/shapes.h"
#include "tests/support/tools.h"
#include "tests/support/whole_check.h"

namespace gouge::overcut_test {
namespace {

CheckResult check(const std::vector<Pose>& poses, const ToolVariants& tool, const IndexedMesh& part) {
  const Toolpath path = paths::through(poses);
  Scene scene;
  scene.parts = {part};
  CheckOptions options;
  options.threads = 1;
  return whole_check(path, &tool, scene, options);
}

const IndexedMesh kBlock = shapes::box(Vec3(-50, -50, -60), Vec3(50, 50, 0));

TEST(Overcut, OfAPlunge20mmDeepIs20mmWhereDepthSaturatesAtTheRadius) {
  for (const ToolVariants& tool : {tools::flat(10), tools::ball(10)}) {
    const CheckResult result = check({paths::upright(0, 0, 10), paths::upright(0, 0, -20)}, tool, kBlock);
    ASSERT_EQ(result.verdicts[1].state, MoveState::gouge);
    EXPECT_NEAR(result.verdicts[1].depth_mm, 5, 1e-3);
    ASSERT_TRUE(result.verdicts[1].overcut.has_value());
    EXPECT_NEAR(result.verdicts[1].overcut_mm(), 20, 1e-3);
    EXPECT_NEAR(result.worst_overcut_mm, 20, 1e-3);
  }
}

TEST(Overcut, OfAShallowGougeIsItsDepthToSecondOrder) {
  for (const double depth : {0.4, 0.2, 0.1, 0.05}) {
    const CheckResult result = check(
        {paths::upright(-20, 0, 5), paths::upright(0, 0, -depth), paths::upright(20, 0, 5)}, tools::ball(10), kBlock);
    EXPECT_NEAR(result.verdicts[1].depth_mm, depth, 1e-3);
    EXPECT_NEAR(result.verdicts[1].overcut_mm(), depth, 1e-3 + depth * depth);
  }
}

TEST(Overcut, IsMeasuredOnTheCurvedPartAsWell) {
  const IndexedMesh part = shapes::sphere(30, 60, 120);
  const CheckResult result = check({paths::upright(0, 0, 40), paths::upright(0, 0, 29.8)}, tools::ball(10), part);
  EXPECT_NEAR(result.verdicts[1].overcut_mm(), 0.2, 0.005);
}

// A box in the material of another one, and one across its face: 6 mm below the face above, and nearer to a face of the
// other box, which ends nothing there.
TEST(Overcut, IsTrueWhereShellsLieInOneAnotherOrCross) {
  for (const double top : {-4.0, 4.0}) {
    const IndexedMesh part = shapes::joined(shapes::box(Vec3(-20, -20, -20), Vec3(20, 20, 0)),
                                            shapes::box(Vec3(-5, -5, -12), Vec3(5, 5, top)));
    const CheckResult result =
        check({paths::upright(0, 8, 10), paths::upright(0, 8, -6), paths::upright(0, 8, 10)}, tools::ball(2), part);
    for (const std::size_t move : {std::size_t{1}, std::size_t{2}}) {
      ASSERT_TRUE(result.verdicts[move].overcut.has_value());
      EXPECT_LE(result.verdicts[move].overcut_mm(), 6 + 1e-3);
      EXPECT_GE(result.verdicts[move].overcut_mm(), 6 - overcut_gap_mm(6));
      EXPECT_GE(result.verdicts[move].overcut->upper_mm, 6);
      EXPECT_LE(result.verdicts[move].overcut->upper_mm, 6.061);
    }
  }
}

/// Calls `see(y, t)` for random points centre + y in the ball that are in the solid at the instant t.
template <typename See>
void for_random_points_in(const SweptSolid& solid, const Vec3& centre, double radius, test::Scatter& random,
                          const See& see) {
  for (int n = 0; n < 400; ++n) {
    const double at = random.in(0, 1);
    const Vec3 y = radius * random.in(0, 1) * random.direction();
    if (solid.distance_at(centre + y, at) <= 0) see(y, at);
  }
}

/// Returns how far the plane of a half-space is above the point centre + y at the instant `at`.
double room_below(const DriftingHalfSpace& half, const Vec3& y, double at) {
  return half.offset_mm + (at - 0.5) * half.drift_mm - half.normal.dot(y);
}

TEST(Overcut, PlanesOfATurningToolHoldAllOfItThatComesIntoTheCell) {
  test::Scatter random(11);
  std::size_t in_both = 0, tight = 0;
  for (int k = 0; k < 400; ++k) {
    const ToolVariants tool = random.is(0.5) ? tools::ball(10) : tools::flat(10);
    const double lean = random.in(0, 0.4);
    const Motion motion = test::straight({random.point(2), random.axis(lean)}, {random.point(2), random.axis(lean)});
    SweptTool swept(motion, tool.bare);
    const double t = random.in(0, 1), radius = random.in(0.2, 3);
    const Vec3 centre = motion.at(t).tip + random.point(6);
    const auto half = swept.half_space(centre + radius * random.direction(), t - 0.5, centre, radius, 0);
    ASSERT_TRUE(half.has_value());
    double least = 1e300;
    for_random_points_in(swept, centre, radius, random, [&](const Vec3& y, double at) {
      ++in_both;
      least = std::min(least, room_below(*half, y, at));
    });
    EXPECT_GE(least, 0) << k;
    tight += least < 0.1 * radius ? 1U : 0U;
  }
  EXPECT_GT(in_both, 10000U);
  EXPECT_GT(tight, 50U);
}

TEST(Overcut, PlanesOfATurningHeadHoldAllOfItThatComesIntoTheCell) {
  // The rounded head and the box have planes over the whole head everywhere. The others have a neck or a hole.
  test::Scatter random(12);
  std::size_t in_both = 0, tight = 0, missed = 0;
  for (const IndexedMesh& mesh : test::heads_around_the_axis()) {
    const HeadBody head = *build_head_body(mesh);
    for (int k = 0; k < 60; ++k) {
      const double lean = random.in(0, 0.4);
      const Motion motion = test::straight({random.point(2), random.axis(lean)}, {random.point(2), random.axis(lean)});
      SweptHead swept(motion, head);
      const double t = random.in(0, 1), radius = random.in(0.2, 3);
      const Vec3 beside = mesh.vertices[random.below(mesh.vertices.size())] + random.point(4);
      const Vec3 centre = BodyMotion(motion).at(t).point(beside);
      const SweptBound bound = swept.bound(centre, radius, 0);
      const auto half = swept.half_space(centre + radius * random.direction(), t - 0.5, centre, radius, 0);
      double least = 1e300;
      for_random_points_in(swept, centre, radius, random, [&](const Vec3& y, double at) {
        ++in_both;
        EXPECT_TRUE(bound.is_reached) << mesh.name << k;
        for (const auto& plane : {half, bound.half}) {
          if (plane) least = std::min(least, room_below(*plane, y, at));
        }
      });
      EXPECT_GE(least, 0) << mesh.name << k;
      tight += least < 0.1 * radius ? 1U : 0U;
      missed += bound.is_reached ? 0U : 1U;
    }
  }
  EXPECT_GT(in_both, 10000U);
  EXPECT_GT(tight, 20U);
  EXPECT_GT(missed, 10U);
}

TEST(Overcut, OfARibCutThroughIsHalfItsThickness) {
  const IndexedMesh rib = shapes::box(Vec3(-1, -50, -20), Vec3(1, 50, 0));
  const CheckResult result = check({paths::upright(-30, 0, -10), paths::upright(30, 0, -10)}, tools::flat(10), rib);
  EXPECT_NEAR(result.verdicts[1].overcut_mm(), 1, 1e-2);
}

TEST(Overcut, OfEveryMoveOfALongFindingIsFound) {
  // A wide tool 2 mm below the top of a wall and 4 mm over its side: little of the tool's box is in the part,
  // which cells of space alone would be long in finding.
  const ToolVariants tool = tools::flat(46);
  std::vector<Pose> poses;
  for (int k = 0; k <= 60; ++k) poses.push_back(paths::upright(-69 - 0.001 * k, -30 + k, -2));
  const CheckResult result = check(poses, tool, kBlock);
  for (std::size_t i = 1; i < result.verdicts.size(); ++i) {
    ASSERT_EQ(result.verdicts[i].state, MoveState::gouge) << i;
    EXPECT_NEAR(result.verdicts[i].overcut_mm(), 2, 0.02) << i;
  }
}

TEST(Overcut, IsClosedToItsGapInEveryMove) {
  const ToolVariants tool = tools::bull(16, 2);
  const IndexedMesh mesh = shapes::torus(40, 12, 48, 24);
  std::vector<Pose> poses;
  for (int k = 0; k <= 24; ++k) {
    const double angle = 0.25 * k;
    poses.push_back({Vec3(43 * std::cos(angle), 43 * std::sin(angle), 9 - 0.5 * (k % 7)),
                     Vec3(0.3 * std::sin(3 * angle), 0.2, 1).normalized()});
  }
  const CheckResult result = check(poses, tool, mesh);
  std::size_t gouges = 0;
  for (std::size_t i = 1; i < result.verdicts.size(); ++i) {
    const MoveVerdict& v = result.verdicts[i];
    if (!v.overcut) continue;
    ++gouges;
    EXPECT_GE(v.overcut->upper_mm, v.overcut->lower_mm) << i;
    EXPECT_LE(v.overcut->upper_mm - v.overcut->lower_mm, overcut_gap_mm(v.overcut->lower_mm) + 1e-9) << i;
  }
  EXPECT_GT(gouges, 10U);
}

TEST(Overcut, OfASharpCornerIsMoreThanItsDepth) {
  // A flat end mill leaning by 45 degrees: its corner of 90 degrees stands 1 mm below the surface.
  const double lean = std::sqrt(0.5);
  const Vec3 axis(lean, 0, lean);
  const Vec3 corner = Vec3(0, 0, -1);
  const Vec3 tip = corner + 5 * Vec3(lean, 0, -lean) * -1;
  const CheckResult result = check({{tip + Vec3(0, 0, 20), axis}, {tip, axis}}, tools::flat(10), kBlock);
  ASSERT_EQ(result.verdicts[1].state, MoveState::gouge);
  EXPECT_NEAR(result.verdicts[1].depth_mm, lean, 0.02);
  EXPECT_NEAR(result.verdicts[1].overcut_mm(), 1, 0.01);
  EXPECT_GE(result.verdicts[1].overcut->upper_mm, 1 - 1e-9);
}

TEST(Overcut, OfAHeadIsHowFarTheHeadReachedBelowTheSurface) {
  // A bar 6 mm wide beside the tool, its end 15 mm deep in the block: depth states 3.
  const ToolVariants tool = tools::ball(10);
  const Toolpath path = paths::through({paths::upright(80, 0, 30), paths::upright(80, 0, 5)});
  Scene scene;
  scene.parts = {kBlock};
  const std::vector<HeadBody> heads = {*build_head_body(shapes::box(Vec3(-63, -3, -20), Vec3(-57, 3, 60)))};
  CheckOptions options;
  EXPECT_EQ(whole_check(path, &tool, scene, options).counts.clean, 2U);
  const CheckResult result = whole_check(path, &tool, scene, options, heads);
  ASSERT_EQ(result.verdicts[1].state, MoveState::gouge);
  EXPECT_NEAR(result.verdicts[1].depth_mm, 3, 2e-3);
  ASSERT_TRUE(result.verdicts[1].overcut.has_value());
  EXPECT_NEAR(result.verdicts[1].overcut_mm(), 15, 0.01);
  EXPECT_NEAR(result.worst_overcut_mm, 15, 0.01);
}

TEST(Overcut, IsNotReportedForAnOpenSurface) {
  const IndexedMesh sheet = shapes::moved(shapes::sheet(100, 100, 0), Vec3(-50, -50, 0));
  const CheckResult result = check({paths::upright(0, 0, 10), paths::upright(0, 0, -2)}, tools::ball(10), sheet);
  ASSERT_EQ(result.verdicts[1].state, MoveState::gouge);
  EXPECT_FALSE(result.verdicts[1].overcut.has_value());
}

TEST(Overcut, IsBracketedByASampledReference) {
  const ToolVariants tool = tools::bull(16, 2);
  Scene scene;
  scene.parts = {shapes::torus(40, 12, 48, 24)};
  const PreparedScene prepared(scene);
  const Surface& part = prepared.surface(Against::part, 0);
  const Motion motion = test::straight(Pose{Vec3(20, -30, 4), Vec3(0, 0.3, 1).normalized()},
                                       Pose{Vec3(45, 5, 2), Vec3(0.4, 0, 1).normalized()});
  SweptTool swept(motion, tool.bare);
  OvercutOptions fine;
  fine.max_cells = 20000;
  const Overcut reported = find_overcut(swept, part, Vec3(0, 0, 0), 0, fine);
  double sampled = 0;
  for (double x = -55; x < 55; x += 2) {
    for (double y = -55; y < 55; y += 2) {
      for (double z = -12; z < 12; z += 2) {
        const Vec3 p(x, y, z);
        const auto foot = part.closest_point(p);
        if (!foot->is_inside || foot->distance_mm <= sampled) continue;
        for (int k = 0; k <= 100; ++k) {
          if (swept.distance_at(p, 0.01 * k) <= 0) sampled = foot->distance_mm;
        }
      }
    }
  }
  EXPECT_GT(sampled, 1);
  EXPECT_GE(reported.depth_mm, sampled - 1e-9);
  EXPECT_LE(reported.depth_mm, reported.depth_upper_mm + 1e-12);
  EXPECT_LE(swept.distance_at(reported.point, reported.t), 1e-8);
  EXPECT_NEAR(-part.closest_point(reported.point)->signed_mm(), reported.depth_mm, 1e-9);
}

}  // namespace
}  // namespace gouge::overcut_test
