// The check against remaining stock where the answer is known in closed form.
#include <gtest/gtest.h>

#include "lib/stock/check_stock.h"
#include "lib/stock/stock_search.h"
#include "lib/tool/evaluate.h"
#include "tests/lib/stock/block.h"
#include "tests/support/scatter.h"
#include "tests/support/shapes.h"

namespace gouge::stock_test {
namespace {

constexpr double kTolerance_mm = 0.1, kResolution_mm = 0.05;

using block::flat;
using block::kFeed;
using block::kRapid;
using block::path_of;
using block::run;
using block::Step;
using paths::upright;

TEST(Stock, ARapidThroughTheBlockIsFoundWithItsFirstContact) {
  const StockResult result =
      run(path_of({{kRapid, upright(-80, 0, -5)}, {kRapid, upright(80, 0, -5)}}), {flat(10, 30, 10)});
  ASSERT_EQ(result.findings.size(), 1U);
  const StockFinding& finding = result.findings.front();
  EXPECT_GT(finding.witness->depth_mm, 4.4);
  EXPECT_GE(finding.depth_upper_mm, finding.witness->depth_mm);
  EXPECT_LT(finding.depth_upper_mm, 5.6);
  // The tolerance is exceeded where the tool is 0.1 mm beyond the face at x = -50: its tip is at -54.9 then.
  const double exact = (80 - 54.9) / 160;
  EXPECT_LE(finding.contact.clear_until, exact + 2 * kResolution_mm / 160);
  EXPECT_GE(finding.contact.contact_at, exact - 1e-9);
  EXPECT_LT(finding.contact.contact_at - finding.contact.clear_until, 2 * kResolution_mm / 160);
  EXPECT_FALSE(finding.nearest_cut.has_value());
}

TEST(Stock, AStepOfACycleOrAnArcInRapidIsARapid) {
  for (const MoveKind kind : {MoveKind::cycle, MoveKind::arc}) {
    Toolpath path = path_of({{kRapid, upright(-80, 0, -5)}, {kind, upright(80, 0, -5)}, {kRapid, upright(-80, 0, -5)}});
    EXPECT_TRUE(run(path, {flat(10, 30, 10)}).findings.empty()) << "at feed it cuts the way of the rapid";
    path.moves[1].feed_unit = FeedUnit::rapid;
    const StockResult result = run(path, {flat(10, 30, 10)});
    ASSERT_EQ(result.findings.size(), 2U) << "it meets the block, and removes nothing";
    EXPECT_GT(result.findings[0].witness->depth_mm, 4.4);
  }
}

TEST(Stock, ARapidAboveTheBlockIsClear) {
  for (const double height : {0.0, 1.0, -0.09}) {
    const StockResult result =
        run(path_of({{kRapid, upright(-80, 0, height)}, {kRapid, upright(80, 0, height)}}), {flat(10, 30, 10)});
    EXPECT_TRUE(result.findings.empty()) << height;
    EXPECT_EQ(result.proved, 2U);
  }
}

TEST(Stock, ARapidThroughItsOwnSlotIsClearAndOneBesideItIsNot) {
  const auto slot = [](double shift, double deeper) {
    return path_of({{kRapid, upright(-80, 0, -5)},
                    {kFeed, upright(80, 0, -5)},
                    {kRapid, upright(80, 0, 20)},
                    {kRapid, upright(-80, shift, 20)},
                    {kRapid, upright(-80, shift, -5 - deeper)},
                    {kRapid, upright(80, shift, -5 - deeper)}});
  };
  const std::vector<ToolVariants> tool{flat(10, 30, 10)};
  EXPECT_TRUE(run(slot(0, 0), tool).findings.empty());
  EXPECT_TRUE(run(slot(0.05, 0), tool).findings.empty());
  for (const auto& [shift, deeper] : {std::pair(0.3, 0.0), std::pair(0.0, 0.3), std::pair(-0.5, 0.0)}) {
    const StockResult result = run(slot(shift, deeper), tool);
    ASSERT_EQ(result.findings.size(), 1U) << shift << " " << deeper;
    const StockFinding& finding = result.findings.front();
    const double exact = std::max(std::abs(shift), deeper);
    EXPECT_LE(finding.witness->depth_mm, exact + 1e-9);
    EXPECT_GE(finding.depth_upper_mm, exact - 3 * kResolution_mm);
    EXPECT_LT(finding.depth_upper_mm, exact + 3 * kResolution_mm);
    ASSERT_TRUE(finding.nearest_cut.has_value());
    EXPECT_EQ(finding.nearest_cut->cut.move, 1U);
    EXPECT_LE(finding.nearest_cut->distance_mm, exact);
  }
}

TEST(Stock, APlungeDeeperThanTheFlutesIsClearUnlessTheShankIsWider) {
  const auto plunge = [](double depth) {
    return path_of({{kRapid, upright(0, 0, 10)}, {kFeed, upright(0, 0, -depth)}});
  };
  EXPECT_TRUE(run(plunge(25), {flat(10, 12, 10)}).findings.empty());
  EXPECT_TRUE(run(plunge(25), {flat(10, 12, 8)}).findings.empty());
  EXPECT_TRUE(run(plunge(11), {flat(10, 12, 14)}).findings.empty());
  const StockResult result = run(plunge(25), {flat(10, 12, 14)});
  ASSERT_EQ(result.findings.size(), 1U);
  EXPECT_EQ(result.findings.front().body, Body::shank);
  EXPECT_LE(result.findings.front().witness->depth_mm, 2 + 1e-9);
  EXPECT_GE(result.findings.front().depth_upper_mm, 2 - kResolution_mm);
  // The shank reaches the face after 10 + 12 mm of 35, and is deeper than the tolerance 0.1 mm later.
  EXPECT_LE(result.findings.front().contact.clear_until, (22.1 + 2 * kResolution_mm) / 35);
  EXPECT_GE(result.findings.front().contact.contact_at, 22.1 / 35 - 1e-9);
}

// On the axis of a wide holder the end of the slim shank is nearer than the surface of the holder.
TEST(Stock, FindingsNameTheBodyThatContainsTheirPoint) {
  ToolAssembly tool = tools::assembly(FlatCutter{6, 12}, 6);
  tool.shank = {{6, 6, 8}};
  tool.holder = {{30, 30, 50}};
  const ToolVariants made = tools::variants(tool);
  const StockResult result = run(path_of({{kRapid, upright(-90, 0, -26)}, {kFeed, upright(90, 0, -26)}}), {made});
  ASSERT_EQ(result.findings.size(), 1U);
  const StockFinding& found = result.findings.front();
  const double height = found.witness->point.z() + 26;
  EXPECT_EQ(found.body, height > 20 ? Body::holder : Body::shank) << height;
  const auto body = [&](double r, double z) {
    return body_at(made.bare, made.non_cutting, {Vec3::Zero(), Vec3::UnitZ()}, {0, r, z});
  };
  for (const double r : {0.0, 1.0, 2.9}) {
    EXPECT_EQ(body(r, 11.9), Body::cutter);
    EXPECT_EQ(body(r, 12.1), Body::shank);
    EXPECT_EQ(body(r, 19.9), Body::shank);
    EXPECT_EQ(body(r, 20.1), Body::holder);
    EXPECT_EQ(body(r, 69.9), Body::holder);
  }
  const ToolVariants cleared = tools::variants(tool, 0, 0.5, 2);
  EXPECT_EQ(body_at(cleared.bare, cleared.non_cutting, {Vec3::Zero(), Vec3::UnitZ()}, {0, 10, 18.5}), Body::holder)
      << "in the clearance of the holder alone";
}

TEST(Stock, AShankAsWideAsItsFlutesMayFollowItsOwnLevels) {
  std::vector<Step> steps{{kRapid, upright(-80, 0, 20)}};
  for (int level = 1; level <= 5; ++level) {
    steps.push_back({kRapid, upright(-80, 0, -4.0 * level)});
    steps.push_back({kFeed, upright(60, 0, -4.0 * level)});
    steps.push_back({kRapid, upright(60, 0, 20)});
    steps.push_back({kRapid, upright(-80, 0, 20)});
  }
  const StockResult result = run(path_of(steps), {flat(16, 10, 16)});
  EXPECT_TRUE(result.findings.empty());
  // One level deeper at once: the shank cuts what the flutes left.
  const StockResult deep =
      run(path_of({{kRapid, upright(-80, 0, -14)}, {kFeed, upright(60, 0, -14)}}), {flat(16, 10, 16)});
  ASSERT_EQ(deep.findings.size(), 1U);
  EXPECT_EQ(deep.findings.front().body, Body::shank);
}

TEST(Stock, PassesThatJustAbutLeaveNothing) {
  std::vector<Step> steps{{kRapid, upright(-80, -45, 20)}};
  for (int pass = 0; pass <= 9; ++pass) {
    steps.push_back({kRapid, upright(-80, -45 + 10.0 * pass, -5)});
    steps.push_back({kFeed, upright(80, -45 + 10.0 * pass, -5)});
    steps.push_back({kRapid, upright(80, -45 + 10.0 * pass, 20)});
    steps.push_back({kRapid, upright(-80, -45 + 10.0 * pass, 20)});
  }
  // A wide tool then crosses all seams in rapid motion.
  Toolpath path = path_of(steps);
  for (const Pose& pose : {upright(0, -90, 20), upright(0, -90, -5), upright(0, 80, -5)}) {
    Move move = path.moves.back();
    move.kind = kRapid;
    move.end = pose;
    move.line = path.moves.size() + 1;
    path.moves.push_back(move);
  }
  const StockResult result = run(path, {flat(10, 30, 10)});
  for (const StockFinding& finding : result.findings)
    ADD_FAILURE() << "move " << finding.move << ", witness " << finding.witness.has_value();
}

TEST(Stock, AHoleWithANeckIsEntered) {
  // The neck of 4 mm follows flutes of 8 mm: the hole is wider than the neck and the shank stays above.
  ToolAssembly tool = tools::assembly(FlatCutter{8, 6}, 4);
  tool.shank = {{4, 4, 30}};
  EXPECT_TRUE(run(path_of({{kRapid, upright(0, 0, 10)}, {kFeed, upright(0, 0, -30)}}), {tools::variants(tool)})
                  .findings.empty());
}

TEST(Stock, ATiltedSlotIsFollowedByItsOwnTool) {
  const Vec3 axis = Vec3(0.3, 0.2, 1).normalized();
  const auto at = [&](double x, double up) { return Pose{Vec3(Vec3(x, 0, -6) + up * axis), axis}; };
  const Toolpath path = path_of({{kRapid, at(-90, 0)}, {kFeed, at(20, 0)}, {kRapid, at(20, 60)}});
  EXPECT_TRUE(run(path, {flat(10, 30, 10)}).findings.empty());
  // Out along Z, the tool meets the wall of its tilted slot.
  Toolpath upward = path;
  upward.moves[2].end = {Vec3(20, 0, 60), axis};
  const StockResult result = run(upward, {flat(10, 30, 10)});
  ASSERT_EQ(result.findings.size(), 1U);
  EXPECT_EQ(result.findings.front().move, 2U);
}

TEST(Stock, EveryToolMayGoBackInItsOwnGroove) {
  const std::vector<Vec3> axes{Vec3::UnitZ(), Vec3(0.3, 0.2, 1).normalized()};
  for (const ToolVariants& tool : tools::all()) {
    for (const Vec3& axis : axes) {
      const Pose from{Vec3(-90, 3, -6), axis}, to{Vec3(90, -3, -8), axis};
      const StockResult back = run(path_of({{kRapid, from}, {kFeed, to}, {kRapid, from}}), {tool});
      EXPECT_TRUE(back.findings.empty()) << tool.bare.r_max_mm << " " << axis.transpose();
      const Pose beside{Vec3(-90, 3.6, -6), axis};
      EXPECT_FALSE(run(path_of({{kRapid, from}, {kFeed, to}, {kRapid, beside}}), {tool}).findings.empty());
    }
  }
}

TEST(Stock, AnUndercutIsLeftTheWayItWasEntered) {
  // A slot for the neck, then the T-slot below it. Out the same way is clear, straight up is not.
  ToolAssembly undercutter = tools::assembly(TSlotCutter{25, 1, 1, 8}, 8);
  undercutter.shank = {{8, 8, 40}};
  const std::vector<ToolVariants> tools{flat(10, 30, 10), tools::variants(undercutter)};
  const auto program = [](const Pose& out) {
    Toolpath path = path_of({{kRapid, upright(-80, 0, -22)},
                             {kFeed, upright(-20, 0, -22)},
                             {kRapid, upright(-20, 0, 60)},
                             {kRapid, upright(-80, 0, -22)},
                             {kFeed, upright(-25, 0, -22)},
                             {kRapid, out}});
    path.tools.resize(2);
    path.moves[3].has_start = false;
    for (std::size_t i = 3; i < path.moves.size(); ++i) path.moves[i].tool = 1;
    return path;
  };
  EXPECT_TRUE(run(program(upright(-90, 0, -22)), tools).findings.empty());
  const StockResult up = run(program(upright(-25, 0, 60)), tools);
  ASSERT_EQ(up.findings.size(), 1U);
  EXPECT_EQ(up.findings.front().move, 5U);
  EXPECT_GT(up.findings.front().witness->depth_mm, 3);
  ASSERT_TRUE(up.findings.front().nearest_cut.has_value());
}

TEST(Stock, AnUnknownMotionLeavesTheMaterialOpen) {
  Toolpath path = path_of({{kRapid, upright(-80, 0, 20)},
                           {kFeed, upright(-40, 0, -10)},
                           {kRapid, upright(80, 0, -5)},
                           {kRapid, upright(80, 0, 40)}});
  path.moves[1].not_checked_reason = "the tool radius compensation is on";
  const StockResult result = run(path, {flat(10, 30, 10)});
  ASSERT_EQ(result.findings.size(), 1U);
  EXPECT_FALSE(result.is_examined[1]);
  // Far from the unknown motion the material is surely there; so the finding has a witness.
  EXPECT_EQ(result.findings.front().move, 2U);
}

TEST(Stock, AToolThatDoesNotCutRemovesNothing) {
  const Toolpath path =
      path_of({{kRapid, upright(-80, 0, -5)}, {kFeed, upright(80, 0, -5)}, {kRapid, upright(-80, 0, -5)}});
  const ToolVariants probe = flat(10, 30, 10);
  const MotionLaw law;
  const StockOptions options;
  for (const bool cuts : {true, false}) {
    const std::vector<StockTool> tools{{&probe, cuts}};
    const CutHistory history(path, law, tools, options);
    const StockResult result = check_stock(history, block::solid(), options, 1);
    EXPECT_EQ(result.findings.empty(), cuts);
  }
}

// A box is in one frame about the axis. A proof for a group of moves must not be taken for boxes of another frame.
TEST(Stock, TurningRapidsBesideAWallAreFound) {
  const ToolVariants tool = flat(10, 16, 10);
  test::Scatter scatter(9);
  std::size_t deep = 0;
  for (int k = 0; k < 60; ++k) {
    // Short moves, so that a group is small beside the tool.
    std::vector<Step> steps;
    Vec3 tip(scatter.in(-30, 30), scatter.in(-58, -54), scatter.in(-20, -2));
    for (int n = 0; n < 8; ++n) {
      steps.push_back({kRapid, {tip, scatter.axis(0.1)}});
      tip += scatter.point(0.8);
    }
    const Toolpath path = path_of(steps);
    const StockResult result = run(path, {tool});
    std::vector<bool> is_found(steps.size(), false);
    for (const StockFinding& finding : result.findings) is_found[finding.move] = true;
    for (std::size_t i = 1; i < steps.size(); ++i) {
      const Motion motion = MotionLaw().of(path, i);
      double depth = 0;
      for (int n = 0; n <= 40; ++n) {
        const Pose pose = motion.at(n / 40.0);
        for (double x = -5; x <= 5; x += 0.5)
          for (double z = -20; z < 0; z += 0.5) {
            const Vec3 point(pose.tip.x() + x, -50 + 0.1, z);
            depth = std::max(depth, -signed_distance_mm(tool.bare, pose, point));
          }
      }
      if (depth > 0.3) ++deep;
      if (depth > 0.3) {
        EXPECT_TRUE(is_found[i]) << "path " << k << ", move " << i << ", depth " << depth;
      }
    }
  }
  EXPECT_GT(deep, 50U);
}

TEST(Stock, ResultsAreTheSameAtAnyNumberOfThreads) {
  std::vector<Step> steps{{kRapid, upright(-80, 0, 20)}};
  for (int k = 0; k < 300; ++k)
    steps.push_back({k % 7 == 3 ? kRapid : kFeed, upright(-60 + 0.17 * k, 20 * std::sin(0.1 * k), -3 - 0.01 * k)});
  const Toolpath path = path_of(steps);
  const std::vector<ToolVariants> tools{flat(10, 6, 12)};
  const std::vector<StockTool> all{{&tools.front(), true}};
  const MotionLaw law;
  const StockOptions options;
  const CutHistory history(path, law, all, options);
  const StockResult one = check_stock(history, block::solid(), options, 1),
                    three = check_stock(history, block::solid(), options, 3);
  ASSERT_EQ(one.findings.size(), three.findings.size());
  EXPECT_FALSE(one.findings.empty());
  for (std::size_t k = 0; k < one.findings.size(); ++k) {
    EXPECT_EQ(one.findings[k].move, three.findings[k].move);
    ASSERT_EQ(one.findings[k].witness.has_value(), three.findings[k].witness.has_value());
    if (one.findings[k].witness) {
      EXPECT_EQ(one.findings[k].witness->depth_mm, three.findings[k].witness->depth_mm);
    }
    EXPECT_EQ(one.findings[k].depth_upper_mm, three.findings[k].depth_upper_mm);
    EXPECT_EQ(one.findings[k].contact.contact_at, three.findings[k].contact.contact_at);
  }
}

// A mesh in the form of a box is held as a box; other meshes may have the corners of a box too.
TEST(StockSolid, OnlyAMeshThatFillsItsBoxIsTheBox) {
  const std::vector<IndexedMesh> box{shapes::box({-1, -2, -3}, {7, 8, 9})}, corner{shapes::tetrahedron(10)};
  const Result<StockSolid> whole = StockSolid::meshes(box, 0), sixth = StockSolid::meshes(corner, 0);
  ASSERT_TRUE(whole.has_value() && sixth.has_value());
  EXPECT_TRUE(whole->contains(Vec3(6.9, 7.9, 8.9)));
  EXPECT_FALSE(whole->contains(Vec3(7.1, 7.9, 8.9)));
  EXPECT_TRUE(sixth->contains(Vec3(1, 1, 1)));
  EXPECT_FALSE(sixth->contains(Vec3(8, 8, 8)));
  EXPECT_TRUE(sixth->is_clear_of(std::vector<Disc>{{Vec3(8, 8, 8)}}, 1));
  EXPECT_FALSE(whole->is_clear_of(std::vector<Disc>{{Vec3(8, 7, 8)}}, 1.5));
}

}  // namespace
}  // namespace gouge::stock_test
