// Heads beside remaining stock where the answer is known in closed form.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "lib/motion/body_motion.h"
#include "lib/stock/check_stock.h"
#include "lib/stock/stock_head.h"
#include "lib/surface/surface.h"
#include "tests/lib/stock/block.h"
#include "tests/support/shapes.h"

namespace gouge::head_forms_test {
namespace {

constexpr double kTolerance_mm = 0.1, kResolution_mm = 0.05;

using block::kFeed;
using block::kRapid;
using block::path_of;
using block::Step;
using paths::upright;

StockHead head_of(const IndexedMesh& mesh) { return StockHead(Surface(IndexedMesh(mesh)).boundary()); }

/// A flat cutter with a shank as wide, and no holder.
ToolVariants flat(double diameter, double flutes) {
  ToolAssembly tool = tools::assembly(FlatCutter{diameter, flutes}, diameter);
  tool.holder.clear();
  return tools::variants(tool);
}

/// Runs a program with one tool and heads.
StockResult run(const Toolpath& path, const ToolVariants& tool, const std::vector<StockHead>& heads,
                const StockSolid& stock, const Toolpath* before = nullptr) {
  const std::vector<StockTool> tools{{&tool, true}};
  const MotionLaw law;
  const StockOptions options;
  const Toolpath none;
  const CutHistory earlier(before != nullptr ? *before : none, law, tools, options);
  const CutHistory history(path, law, tools, options, &earlier, heads);
  return check_stock(history, stock, options, 1);
}

/// A wall whose face is x = 0.
StockSolid wall() { return StockSolid::box(Vec3(0, -50, -100), Vec3(50, 50, 200)); }

void expect_depth(const StockFinding& finding, double exact) {
  ASSERT_TRUE(finding.witness.has_value());
  EXPECT_EQ(finding.body, Body::head);
  EXPECT_LE(finding.witness->depth_mm, exact + 1e-9);
  EXPECT_GE(finding.depth_upper_mm, exact - kResolution_mm);
  EXPECT_LE(finding.depth_upper_mm - finding.witness->depth_mm, std::max(3 * kResolution_mm, 0.15 * exact));
}

TEST(HeadBesideStock, IsClearOfAWallUntilItIsDeeperThanTheTolerance) {
  const std::vector<StockHead> heads{head_of(shapes::box(Vec3(-20, -20, 40), Vec3(20, 20, 80)))};
  const ToolVariants tool = flat(10, 30);
  for (const auto kind : {kRapid, kFeed}) {
    for (const double depth : {-1.0, 0.0, 0.09, 2.0}) {
      const double x = depth - 20;
      const StockResult result =
          run(path_of({{kRapid, upright(x, -90, 0)}, {kind, upright(x, 90, 0)}}), tool, heads, wall());
      if (depth < kTolerance_mm) {
        EXPECT_TRUE(result.findings.empty()) << depth;
        EXPECT_EQ(result.proved, 2U);
        continue;
      }
      ASSERT_EQ(result.findings.size(), 1U) << depth;
      expect_depth(result.findings.front(), depth);
      EXPECT_EQ(result.findings.front().head, 0U);
      // The corner of the head is deeper than the tolerance once it is so much beyond the face y = -50.
      const double exact = (90 - 50 - 20 + kTolerance_mm) / 180;
      EXPECT_LE(result.findings.front().contact.clear_until, exact + 2 * kResolution_mm / 180);
      EXPECT_GE(result.findings.front().contact.contact_at, exact - 1e-9);
    }
  }
}

TEST(HeadBesideStock, CountsWithItsTurnAboutTheAxis) {
  // The head is 40 mm long in x and 10 mm wide in y. Upright it is turned as its file states.
  const std::vector<StockHead> heads{head_of(shapes::box(Vec3(-20, -5, 40), Vec3(20, 5, 80)))};
  const ToolVariants tool = flat(8, 30);
  const StockSolid behind = StockSolid::box(Vec3(-50, 6, -100), Vec3(50, 50, 200));
  EXPECT_TRUE(
      run(path_of({{kRapid, upright(-90, 0, 0)}, {kRapid, upright(90, 0, 0)}}), tool, heads, behind).findings.empty());
  const StockSolid beside = StockSolid::box(Vec3(6, -50, -100), Vec3(50, 50, 200));
  const StockResult result =
      run(path_of({{kRapid, upright(0, -90, 0)}, {kRapid, upright(0, 90, 0)}}), tool, heads, beside);
  ASSERT_EQ(result.findings.size(), 1U);
  expect_depth(result.findings.front(), 5);
}

TEST(HeadBesideStock, IsFoundBesideASlotAsItGoesDeeper) {
  const std::vector<StockHead> heads{head_of(shapes::box(Vec3(-20, -20, 35), Vec3(20, 20, 60)))};
  const auto levels = [](int count) {
    std::vector<Step> steps{{kRapid, upright(-90, 0, 60)}};
    for (int level = 1; level <= count; ++level) {
      steps.push_back({kRapid, upright(-90, 0, -10.0 * level)});
      steps.push_back({kFeed, upright(0, 0, -10.0 * level)});
      steps.push_back({kRapid, upright(0, 0, 60)});
      steps.push_back({kRapid, upright(-90, 0, 60)});
    }
    return path_of(steps);
  };
  const ToolVariants tool = flat(10, 30);
  EXPECT_TRUE(run(levels(3), tool, heads, block::solid()).findings.empty());
  // On the fourth level the lower face of the head is 5 mm below that of the stock, on the way in and up again.
  const StockResult result = run(levels(4), tool, heads, block::solid());
  ASSERT_GE(result.findings.size(), 1U);
  EXPECT_EQ(result.findings.front().move, 14U);
  expect_depth(result.findings.front(), 5);
  for (const StockFinding& finding : result.findings) EXPECT_GE(finding.move, 14U);

  // An earlier program cleared the upper 6 mm about the slot: the tool is the same, at many steps.
  std::vector<Step> clearing{{kRapid, upright(-90, -30, 60)}};
  for (int pass = 0; pass <= 60; pass += 8) {
    clearing.push_back({kRapid, upright(-90, -30.0 + pass, -6)});
    clearing.push_back({kFeed, upright(40, -30.0 + pass, -6)});
    clearing.push_back({kRapid, upright(40, -30.0 + pass, 60)});
  }
  const Toolpath before = path_of(clearing);
  EXPECT_TRUE(run(levels(4), tool, heads, block::solid(), &before).findings.empty());
}

TEST(HeadBesideStock, LeavesMaterialOpenThatItTouchedBefore) {
  const std::vector<StockHead> heads{head_of(shapes::box(Vec3(-20, -20, 40), Vec3(20, 20, 80)))};
  const ToolVariants tool = flat(10, 30);
  // The head is 2 mm deep in the wall, twice.
  const Toolpath path = path_of({{kRapid, upright(-18, -90, 0)},
                                 {kRapid, upright(-18, 90, 0)},
                                 {kRapid, upright(-18, -90, 0)},
                                 {kRapid, upright(-60, -90, 0)},
                                 {kRapid, upright(-60, -90, 50)},
                                 {kRapid, upright(-3.5, -90, 50)},
                                 {kRapid, upright(-3.5, 90, 50)}});
  const StockResult result = run(path, tool, heads, wall());
  ASSERT_EQ(result.findings.size(), 3U);
  EXPECT_EQ(result.findings[0].move, 1U);
  EXPECT_TRUE(result.findings[0].witness.has_value());
  EXPECT_EQ(result.findings[1].move, 2U);
  EXPECT_FALSE(result.findings[1].witness.has_value());
  EXPECT_EQ(result.findings[1].body, Body::head);
  // Later the cutter and the head are in the wall at once, higher and deeper: the deepest place is reported.
  EXPECT_EQ(result.findings[2].move, 6U);
  EXPECT_TRUE(result.findings[2].witness.has_value());
  EXPECT_EQ(result.findings[2].body, Body::head);
}

TEST(HeadBesideStock, MayHaveAPostBetweenItAndTheTool) {
  const std::vector<StockHead> heads{head_of(shapes::box(Vec3(25, -8, 20), Vec3(40, 8, 60)))};
  const ToolVariants tool = flat(6, 40);
  const StockSolid post = StockSolid::box(Vec3(10, -4, 0), Vec3(24, 4, 100));
  const StockResult result =
      run(path_of({{kRapid, upright(0, 0, 150)}, {kRapid, upright(0, 0, 10)}, {kRapid, upright(2, 0, 10)}}), tool,
          heads, post);
  EXPECT_TRUE(result.findings.empty());
  const StockResult met =
      run(path_of({{kRapid, upright(0, 0, 150)}, {kRapid, upright(0, 0, 10)}, {kRapid, upright(-4, 0, 10)}}), tool,
          heads, post);
  ASSERT_EQ(met.findings.size(), 1U);
  EXPECT_EQ(met.findings.front().move, 2U);
  expect_depth(met.findings.front(), 3);
}

TEST(HeadBesideStock, IsFoundWhereItPassesAPlateAlongTheAxis) {
  const std::vector<StockHead> heads{head_of(shapes::box(Vec3(-30, -5, 40), Vec3(0, 5, 50)))};
  const ToolVariants tool = flat(6, 30);
  const StockSolid plate = StockSolid::box(Vec3(30, -50, 0), Vec3(50, 50, 4));
  const Pose above = upright(60, 0, 60), below = upright(60, 0, -60);
  for (const auto& [from, to] : {std::pair(above, below), std::pair(below, above)}) {
    const StockResult result = run(path_of({{kRapid, from}, {kRapid, to}}), tool, heads, plate);
    ASSERT_EQ(result.findings.size(), 1U);
    expect_depth(result.findings.front(), 5);
  }
  EXPECT_TRUE(run(path_of({{kRapid, above}, {kRapid, upright(60, 0, -36)}}), tool, heads, plate).findings.empty());
  EXPECT_TRUE(run(path_of({{kRapid, below}, {kRapid, upright(60, 0, -50)}}), tool, heads, plate).findings.empty());
}

TEST(HeadBesideStock, IsFoundWhereItSwingsAboutAnAxisThatHardlyTurns) {
  // Near -z the directions that a tool axis states turn fast. The head swings by 120 degrees past a post.
  const std::vector<StockHead> heads{head_of(shapes::box(Vec3(10, -2, 5), Vec3(20, 2, 15)))};
  const ToolVariants tool = flat(2, 20);
  const double tilt = 0.01, angle = std::numbers::pi / 3;
  const Pose from{Vec3::Zero(), Vec3(tilt, 0, -1).normalized()};
  const Pose to{Vec3::Zero(), Vec3(tilt * std::cos(angle), tilt * std::sin(angle), -1).normalized()};
  const Toolpath path = path_of({{kRapid, from}, {kRapid, to}});
  const Motion motion = MotionLaw().of(path, 1);
  const auto head_at = [&](double t) { return BodyMotion(motion).at(t).point(Vec3(15, 0, 10)); };
  const Vec3 half = Vec3::Constant(0.5);
  for (int k = 4; k <= 12; ++k) {
    const Vec3 at = head_at(k / 16.0);
    const StockResult met = run(path, tool, heads, StockSolid::box(at - half, at + half));
    ASSERT_EQ(met.findings.size(), 1U) << k;
    expect_depth(met.findings.front(), 2);
  }
  const Vec3 at = head_at(0.5);
  const Vec3 inward = 0.3 * at, beside(inward.x(), inward.y(), at.z());
  EXPECT_TRUE(run(path, tool, heads, StockSolid::box(beside - half, beside + half)).findings.empty());
}

TEST(HeadBesideStock, TouchesWhatItPasses) {
  const std::vector<StockHead> heads{head_of(shapes::box(Vec3(-20, -20, 40), Vec3(20, 20, 80)))};
  const ToolVariants tool = flat(10, 30);
  const std::vector<StockTool> tools{{&tool, true}};
  const Toolpath path = path_of({{kRapid, upright(-18, -90, 0)}, {kRapid, upright(-18, 90, 0)}});
  const MotionLaw law;
  const CutHistory history(path, law, tools, {}, nullptr, heads), without(path, law, tools, {});
  CutMove hint;
  const auto is_left = [&](const CutHistory& of, double x, double z) {
    return of.is_untouched(HullRegion::box(Vec3(x, -1, z), Vec3(x + 0.5, 1, z + 1)), 0, 2, hint);
  };
  EXPECT_FALSE(is_left(history, 1, 50));
  EXPECT_TRUE(is_left(without, 1, 50));
  EXPECT_TRUE(is_left(history, 1, 81));
  EXPECT_TRUE(is_left(history, 11, 50));
  // A region meets the cylinder about the head, a point only the head itself.
  EXPECT_FALSE(is_left(history, 5, 50));
  EXPECT_TRUE(history.is_untouched(Vec3(2.001, 0, 50), 2, hint));
  EXPECT_FALSE(history.is_untouched(Vec3(1.999, 0, 50), 2, hint));
  EXPECT_TRUE(history.is_untouched(CutBall{Vec3(1, 0, 39), 2, Vec3::UnitZ(), 0.9}, 2, hint));
  EXPECT_FALSE(history.is_untouched(CutBall{Vec3(1, 0, 39), 2, Vec3::UnitZ(), 1.1}, 2, hint));
  const auto nearest = history.nearest_place(Vec3(15, 0, 50), 2, 100, PlacesOf::tools);
  ASSERT_TRUE(nearest.has_value());
  EXPECT_NEAR(nearest->distance_mm, 33 - 20 * std::numbers::sqrt2, 0.01);
}

TEST(StockHead, MovedOutIsDeeper) {
  const StockHead head = head_of(shapes::box(Vec3(-20, -20, 40), Vec3(20, 20, 80))), wide = head.grown(2);
  const Vec3 point(21, 0, 50);
  EXPECT_NEAR(head.signed_distance_mm(point), 1, 1e-9);
  EXPECT_NEAR(wide.signed_distance_mm(point), -1, 1e-9);
  EXPECT_NEAR(wide.around().r_max_mm, 20 * std::numbers::sqrt2 + 2, 1e-6);
  EXPECT_NEAR(wide.around().z_min_mm, 38, 1e-6);
  EXPECT_NEAR(wide.around().z_max_mm, 82, 1e-6);
  const Disc disc{point};
  EXPECT_TRUE(wide.is_no_deeper({&disc, 1}, 1.01));
  EXPECT_FALSE(wide.is_no_deeper({&disc, 1}, 0.99));
}

TEST(CylindersAround, ContainTheMesh) {
  const IndexedMesh block = shapes::box(Vec3(-3, 4, 10), Vec3(5, 12, 30));
  const CompiledTool around = cylinders_around(block);
  EXPECT_NEAR(around.r_max_mm, 13, 1e-6);
  EXPECT_NEAR(around.z_min_mm, 10, 1e-6);
  EXPECT_NEAR(around.z_max_mm, 30, 1e-6);
}

}  // namespace
}  // namespace gouge::head_forms_test
