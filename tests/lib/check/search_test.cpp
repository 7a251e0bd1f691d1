// The search against brute force, and the cases that sampling gets wrong.
#include "lib/check/search.h"

#include <gtest/gtest.h>

#include <cmath>

#include "lib/check/check_move.h"
#include "lib/tool/evaluate.h"
#include "tests/support/brute_force.h"
#include "tests/support/motions.h"
#include "tests/support/scatter.h"
#include "tests/support/shapes.h"
#include "tests/support/tools.h"

namespace gouge::search_test {
namespace {

const CheckOptions kOptions{};

MoveVerdict check(const Motion& motion, const ToolVariants& tool, const std::vector<IndexedMesh>& parts,
                  std::uint64_t* bounds = nullptr, const CheckOptions& options = kOptions) {
  const Scene scene{parts, {}};
  const PreparedScene prepared = prepare_scene(scene);
  return check_move(motion, MoveKind::feed, tool, prepared, options, bounds);
}

Pose upright(double x, double y, double z) { return {Vec3(x, y, z), Vec3::UnitZ()}; }

double depth_of(const Witness& w, const Motion& motion, const CompiledTool& tool) {
  const Pose pose = motion.at(w.t);
  const Vec3 d = w.point - pose.tip;
  const double z = d.dot(pose.axis);
  return -evaluate_brute_force(tool, (d - z * pose.axis).norm(), z).signed_distance_mm;
}

void expect_guarantee(const MoveVerdict& v, const Motion& motion, const ToolVariants& tool,
                      const CheckOptions& options) {
  EXPECT_LE(v.depth_mm, v.depth_upper_mm);
  if (v.state == MoveState::gouge) {
    EXPECT_LE(v.depth_upper_mm - v.depth_mm, options.resolution_mm);
    EXPECT_GT(v.depth_mm, options.tolerance_mm);
  }
  if (v.state == MoveState::clean) {
    EXPECT_LE(v.depth_upper_mm, options.tolerance_mm + options.resolution_mm);
  }
  if (v.depth_mm > 0) {
    ASSERT_TRUE(v.witness.has_value());
    EXPECT_NEAR(depth_of(*v.witness, motion, tool.against_part), v.depth_mm, 1e-6);
    EXPECT_NEAR(v.witness->normal.norm(), 1, 1e-12);
  }
}

TEST(Search, NeverBelowBruteForceOnRandomScenes) {
  test::Scatter random(77);
  const auto in = [&](double a, double b) { return random.in(a, b); };
  const auto tools = tools::all();
  std::size_t gouges = 0, cleans = 0;
  for (int i = 0; i < 250; ++i) {
    const ToolVariants& tool = tools[static_cast<std::size_t>(i) % tools.size()];
    IndexedMesh mesh;
    const double nearest = in(0, 1) < 0.5 ? 3 : 19;
    for (int k = 0; k < 6; ++k) {
      const double angle = in(0, 2 * M_PI), far = nearest + in(0, 8);
      const Vec3 at(far * std::cos(angle), far * std::sin(angle), in(-6, 110));
      for (int c = 0; c < 3; ++c) mesh.vertices.push_back(at + random.point(4));
      shapes::add_triangle(mesh, mesh.vertices.size() - 3, mesh.vertices.size() - 2, mesh.vertices.size() - 1);
    }
    const Pose from{random.point(1), random.axis(0.1)};
    const Pose to{from.tip + random.point(2), random.axis(0.1)};
    const Motion motion = test::straight(from, to);
    const Scene scene{{mesh}, {}};
    const MoveVerdict v = check(motion, tool, scene.parts);
    expect_guarantee(v, motion, tool, kOptions);
    const BruteForceDepth brute = brute_force_depth(motion, tool, scene, 40, 0.01);
    EXPECT_LE(brute.depth_mm, v.depth_upper_mm + 1e-9) << "scene " << i;
    EXPECT_NE(v.state, MoveState::not_certified);
    ++(v.state == MoveState::gouge ? gouges : cleans);
  }
  EXPECT_GT(gouges, 50U);
  EXPECT_GT(cleans, 10U);
}

TEST(Search, LargeTrianglesWithAllVerticesFarAwayAreMet) {
  const IndexedMesh block = shapes::box(Vec3(-500, -500, -100), Vec3(500, 500, 0));
  const Motion motion = test::straight(upright(-1, 0.3, -0.2), upright(1, 0.3, -0.2));
  for (const ToolVariants& tool : tools::all()) {
    std::uint64_t bounds = 0;
    const MoveVerdict v = check(motion, tool, {block}, &bounds);
    EXPECT_EQ(v.state, MoveState::gouge);
    EXPECT_NEAR(v.depth_mm, 0.2, 0.001);
    EXPECT_GT(v.witness->normal.z(), 0.99);
    expect_guarantee(v, motion, tool, kOptions);
    EXPECT_LT(bounds, 2000U);
  }
}

TEST(Search, AThinWallBetweenTwoClearPositionsIsMet) {
  const IndexedMesh wall = shapes::box(Vec3(-0.02, -50, 0), Vec3(0.02, 50, 8));
  const Motion motion = test::straight(upright(-20, 0, 5), upright(20, 0, 5));
  for (const ToolVariants& tool : tools::all()) {
    EXPECT_EQ(check(MotionLaw::tool_at(motion.start()), tool, {wall}).state, MoveState::clean);
    EXPECT_EQ(check(MotionLaw::tool_at(motion.end()), tool, {wall}).state, MoveState::clean);
    const MoveVerdict v = check(motion, tool, {wall});
    EXPECT_EQ(v.state, MoveState::gouge);
    expect_guarantee(v, motion, tool, kOptions);
  }
}

TEST(Search, APostThinnerThanAnyStepIsMet) {
  const IndexedMesh post = shapes::box(Vec3(-0.02, 1.98, 0), Vec3(0.02, 2.02, 8));
  const Motion motion = test::straight(upright(-60, 0, 5), upright(60, 0, 5));
  const ToolVariants tool = tools::ball();
  const MoveVerdict v = check(motion, tool, {post});
  EXPECT_EQ(v.state, MoveState::gouge);
  expect_guarantee(v, motion, tool, kOptions);
  const Motion beside = test::straight(upright(-60, 10, 5), upright(60, 10, 5));
  EXPECT_EQ(check(beside, tool, {post}).state, MoveState::clean);
}

TEST(Search, ARotationAboutARestingTipSwingsTheHolderIntoAPost) {
  // The post stands where the holder passes half way; both ends are clear.
  const IndexedMesh post = shapes::box(Vec3(-0.5, -0.5, 60), Vec3(0.5, 0.5, 140));
  const ToolVariants tool = tools::ball(6);
  const auto leaning = [](double degrees) {
    const double a = degrees * M_PI / 180;
    return Pose{Vec3(0, -40, 0), Vec3(std::sin(a), 0.35, std::cos(a)).normalized()};
  };
  const Motion motion = test::straight(leaning(-40), leaning(40));
  EXPECT_EQ(check(MotionLaw::tool_at(motion.start()), tool, {post}).state, MoveState::clean);
  EXPECT_EQ(check(MotionLaw::tool_at(motion.end()), tool, {post}).state, MoveState::clean);
  const MoveVerdict v = check(motion, tool, {post});
  EXPECT_EQ(v.state, MoveState::gouge);
  EXPECT_EQ(v.witness->body, Body::holder);
  expect_guarantee(v, motion, tool, kOptions);
}

TEST(Search, AFlatSlidingExactlyOnAPlaneIsCleanAndFast) {
  const IndexedMesh floor = shapes::sheet(100, 100, 0, 60, 60);
  const Motion motion = test::straight(upright(-10, 3, 0), upright(12, -5, 0));
  std::uint64_t bounds = 0;
  const MoveVerdict v = check(motion, tools::flat(), {floor}, &bounds);
  EXPECT_EQ(v.state, MoveState::clean);
  EXPECT_LT(bounds, 20000U);
}

TEST(Search, AFlankOnAWallIsCleanAndFast) {
  const IndexedMesh wall = shapes::box(Vec3(5, -50, -10), Vec3(30, 50, 25));
  std::uint64_t bounds = 0;
  const MoveVerdict v = check(test::straight(upright(0, -20, 0), upright(0, 20, 0)), tools::flat(), {wall}, &bounds);
  EXPECT_EQ(v.state, MoveState::clean);
  EXPECT_LT(bounds, 20000U);
}

TEST(Search, AFanOfNeedlesIsAsGoodAsAPlane) {
  const IndexedMesh fan = shapes::needle_fan();
  double top = -1e300;
  for (const Vec3& v : fan.vertices) top = std::max(top, v.z());
  const Motion motion = test::straight(upright(-2, 0, top), upright(2, 1, top));
  EXPECT_EQ(check(motion, tools::flat(), {fan}).state, MoveState::clean);
  const Motion deeper = test::straight(upright(-2, 0, top - 0.05), upright(2, 1, top - 0.05));
  const MoveVerdict v = check(deeper, tools::flat(), {fan});
  EXPECT_EQ(v.state, MoveState::gouge);
  expect_guarantee(v, deeper, tools::flat(), kOptions);
}

TEST(Search, ABudgetTooSmallIsNeverDecided) {
  const IndexedMesh ring = shapes::torus(20, 5, 60, 40);
  const BlockTree tree = build_block_tree({&ring, 1}, 1);
  const ToolVariants tool = tools::ball();
  SearchStart start;
  for (std::uint32_t t = 0; t < ring.triangles.size(); ++t) start.seeds.push_back({0, t});
  const Motion motion = test::straight(upright(18, 0, 4.9), upright(20, 1, 4.95));
  const std::vector<SearchTarget> targets{{&tool.against_part, &tree, Against::part}};
  const SearchResult small = search_move(motion, targets, {{0.01, 0.001, 1e-7, 3}, 0}, start);
  const SearchResult large = search_move(motion, targets, {{0.01, 0.001, 1e-7, 2'000'000}, 0}, start);
  EXPECT_FALSE(small.is_decided);
  EXPECT_TRUE(large.is_decided);
  EXPECT_GE(small.value_upper_mm, large.value_mm);
}

TEST(Search, ClearancesGrowRoundedAndAnyEntryIsAGouge) {
  CheckOptions options;
  options.holder_clearance_mm = 1;
  const ToolVariants tool = tools::variants(tools::assembly(BallCutter{10, 30}), 0, 0, 1);
  // The holder's lower corner is at (16, 50). A corner of a box 0.6 mm away from it along the diagonal is
  // within the clearance, one 1.1 mm away is not, although a grown cylinder with sharp corners would reach
  // it.
  const auto corner_at = [](double away) {
    const double d = away / std::sqrt(2);
    return shapes::box(Vec3(16 + d, -5, 0), Vec3(40, 5, 50 - d));
  };
  const Motion alone = MotionLaw::tool_at(upright(0, 0, 0));
  EXPECT_EQ(check(alone, tool, {corner_at(0.6)}, nullptr, options).state, MoveState::gouge);
  EXPECT_EQ(check(alone, tool, {corner_at(1.1)}, nullptr, options).state, MoveState::clean);
  const MoveVerdict grazing = check(alone, tool, {corner_at(0.995)}, nullptr, options);
  EXPECT_EQ(grazing.state, MoveState::gouge);
  EXPECT_NEAR(grazing.depth_mm, 0.005, 0.001);
  EXPECT_EQ(grazing.witness->body, Body::holder);
}

// A contact within the tolerance, which is no gouge: a near miss states how deep its witness is.
TEST(Search, ANearMissWithinTheToleranceSaysItsDepth) {
  CheckOptions options;
  options.near_miss_mm = 0.5;
  const Scene scene{{}, {shapes::box(Vec3(-50, -50, -10), Vec3(50, 50, 0))}};
  const PreparedScene prepared = prepare_scene(scene);
  const Motion motion = test::straight(upright(-5, 0, -0.005), upright(5, 0, -0.005));
  const MoveVerdict v = check_move(motion, MoveKind::feed, tools::flat(10), prepared, options);
  ASSERT_EQ(v.state, MoveState::near_miss);
  EXPECT_NEAR(v.depth_mm, 0.005, 1e-9);
  EXPECT_GE(v.depth_upper_mm, v.depth_mm);
  EXPECT_EQ(v.clearance_mm.optional(), 0);
  ASSERT_TRUE(v.witness.has_value());
}

TEST(Search, NearMissShowsTheClosestApproachOfTheHolder) {
  CheckOptions options;
  options.near_miss_mm = 2;
  const IndexedMesh wall = shapes::box(Vec3(17.5, -5, 0), Vec3(40, 5, 80));
  const MoveVerdict v =
      check(test::straight(upright(0, 0, 0), upright(0.5, 0, 0)), tools::ball(), {wall}, nullptr, options);
  EXPECT_EQ(v.state, MoveState::near_miss);
  ASSERT_TRUE(v.clearance_mm.has_value());
  EXPECT_NEAR(*v.clearance_mm, 1.0, 0.001);
  EXPECT_EQ(v.witness->body, Body::holder);
  EXPECT_EQ(v.depth_mm, 0);
}

// Beside a wall, cutter and shank of one diameter are equally deep, and the corners of the wall lie beside the shank. The
// cutter makes the surface, so it is named, with a witness of its own.
TEST(Search, OfBodiesThatAreEquallyDeepTheCutterIsNamed) {
  const std::vector<IndexedMesh> wall = {shapes::box(Vec3(4, -50, -10), Vec3(40, 50, 45))};
  const Motion motion = test::straight(upright(0, -5, 0), upright(0, 5, 0));
  for (const ToolVariants& tool : {tools::flat(), tools::ball(), tools::bull(10, 2)}) {
    const MoveVerdict v = check(motion, tool, wall);
    ASSERT_EQ(v.state, MoveState::gouge);
    EXPECT_EQ(v.witness->body, Body::cutter);
    EXPECT_NEAR(v.depth_mm, 1, 1e-6);
    expect_guarantee(v, motion, tool, kOptions);
  }
}

// A shank that is deeper is named, and so is a shank of the same diameter where the cutter is free.
TEST(Search, ADeeperShankIsNamedBeforeTheCutter) {
  const IndexedMesh wall = shapes::box(Vec3(4, -50, -10), Vec3(40, 50, 45));
  const Motion motion = test::straight(upright(0, -5, 0), upright(0, 5, 0));
  const MoveVerdict wider = check(motion, tools::variants(tools::assembly(FlatCutter{10, 30}, 10.01)), {wall});
  EXPECT_EQ(wider.witness->body, Body::shank);
  EXPECT_NEAR(wider.depth_mm, 1.005, 1e-6);
  const IndexedMesh above = shapes::box(Vec3(4, -50, 35), Vec3(40, 50, 45));
  EXPECT_EQ(check(motion, tools::flat(), {above}).witness->body, Body::shank);
}

ToolVariants narrowing_below_its_holder() {
  ToolAssembly tool = tools::assembly(TaperedCutter{10.8, 5.4, 4.8, 13});
  tool.shank = {{14, 10.8, 7}};
  tool.holder = {{47, 28, 28}};
  return tools::variants(tool);
}

// The face of the holder is 20 mm over the tip. A shank that is wider farther down does not keep its plane from bounding
// what lies outside of the shank.
TEST(Search, AHolderFaceOverANarrowingShankThatGrazesIsDecidedSoon) {
  const IndexedMesh block = shapes::box(Vec3(9, -40, -10), Vec3(60, 40, 50));
  std::uint64_t bounds = 0;
  const double z = 50 - 20 - 0.004;
  const MoveVerdict v =
      check(test::straight(upright(0, -5, z), upright(0, 5, z)), narrowing_below_its_holder(), {block}, &bounds);
  EXPECT_EQ(v.state, MoveState::clean);
  EXPECT_LT(bounds, 5'000U);
}

// Half as deep as the holder is high, all along its middle: there the planes of both its faces bound together.
TEST(Search, AWallThroughTheWholeHolderIsMeasuredSoon) {
  const IndexedMesh wall = shapes::box(Vec3(9, -40, -10), Vec3(10, 40, 90));
  std::uint64_t bounds = 0;
  CheckOptions options;
  options.tolerance_mm = 0.01;
  const Motion motion = test::straight(upright(0, -5, 0), upright(0, 5, 0));
  const ToolVariants tool = narrowing_below_its_holder();
  const MoveVerdict v = check(motion, tool, {wall}, &bounds, options);
  expect_guarantee(v, motion, tool, options);
  EXPECT_EQ(v.state, MoveState::gouge);
  EXPECT_LT(bounds, 20'000U);
}

// The corner of a tool with a hollow underside on a plane, the axis tilted: outside of the rim it is as round as any.
TEST(Search, AHollowToolOnAPlaneIsDecidedSoonAtTolerance0) {
  const ToolVariants tool = tools::variants(tools::assembly(AptCutter{6, 1.4, 0, 0, -4.5, 0, 16}, 6));
  const IndexedMesh block = shapes::box(Vec3(-60, -60, -10), Vec3(60, 60, 0));
  const Vec3 axis(std::sin(0.3), 0, std::cos(0.3));
  CheckOptions options;
  options.tolerance_mm = 0;
  const auto depth_at = [&](double z) {
    return check(MotionLaw::tool_at({Vec3(0, 0, z), axis}), tool, {block}).depth_mm;
  };
  double high = 2, low = 0;
  for (int k = 0; k < 30; ++k) (depth_at(0.5 * (low + high)) > 0.0005 ? low : high) = 0.5 * (low + high);
  const Motion motion = test::straight({Vec3(-2, 0, high), axis}, {Vec3(2, 0.5, high), axis});
  std::uint64_t bounds = 0;
  const MoveVerdict v = check(motion, tool, {block}, &bounds, options);
  expect_guarantee(v, motion, tool, options);
  EXPECT_NE(v.state, MoveState::not_certified);
  EXPECT_LT(bounds, 20'000U);
}

}  // namespace
}  // namespace gouge::search_test
