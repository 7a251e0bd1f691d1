// The material left on a part where the answer is known in closed form.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "lib/stock/excess.h"
#include "tests/lib/stock/block.h"
#include "tests/support/paths.h"
#include "tests/support/shapes.h"
#include "tests/support/tools.h"

namespace gouge::excess_test {
namespace {

using block::kFeed;
using block::kRapid;
using block::path_of;
using block::Step;
using paths::upright;

StockOptions fine() {
  StockOptions options;
  options.resolution_mm = 0.025;
  return options;
}

ToolVariants flat(double diameter, double flutes = 40) {
  return tools::variants(tools::assembly(FlatCutter{diameter, flutes}, diameter));
}

ExcessResult run(const Toolpath& path, const std::vector<ToolVariants>& tools, const std::vector<IndexedMesh>& parts,
                 const StockSolid& stock, double height, const StockOptions& options = fine(), unsigned threads = 1) {
  std::vector<StockTool> all;
  for (const ToolVariants& tool : tools) all.push_back({&tool, true});
  const MotionLaw law;
  const CutHistory history(path, law, all, options);
  std::vector<Surface> surfaces;
  for (const IndexedMesh& part : parts) surfaces.emplace_back(part);
  const Result<PartColumns> columns = PartColumns::of(surfaces);
  EXPECT_TRUE(columns);
  return find_excess({history, stock, *columns, options.resolution_mm}, height, threads);
}

/// Rows of a flat cutter over the square of that half side, at height z.
std::vector<Step> rows(double half, double z, double step) {
  std::vector<Step> steps{{kRapid, upright(-half - 20, -half, 60)}, {kRapid, upright(-half - 20, -half, z)}};
  bool is_back = false;
  for (double y = -half; y <= half + 1e-9; y += step, is_back = !is_back) {
    steps.push_back({kFeed, upright(is_back ? half + 20 : -half - 20, y, z)});
    steps.push_back({kFeed, upright(is_back ? -half - 20 : half + 20, y, z)});
  }
  steps.push_back({kFeed, {steps.back().to.tip + Vec3(0, 0, 60), Vec3::UnitZ()}});
  return steps;
}

IndexedMesh plate() { return shapes::box(Vec3(-30, -30, -10), Vec3(30, 30, 0)); }
StockSolid plate_stock(double above) { return StockSolid::box(Vec3(-30, -30, -10), Vec3(30, 30, above)); }

TEST(Excess, RoughingThatLeavesMaterialOnAFloorIsMeasured) {
  const Toolpath path = path_of(rows(30, 0.3, 8));
  const ExcessResult found = run(path, {flat(10)}, {plate()}, plate_stock(5), 0.1);
  ASSERT_EQ(found.places.size(), 1U);
  const ExcessPlace& place = found.places.front();
  EXPECT_LE(place.highest.height_mm, 0.3 + 1e-9);
  EXPECT_GE(place.highest.height_mm, 0.29);
  EXPECT_GE(place.highest.height_upper_mm, 0.3 - fine().resolution_mm);
  EXPECT_LE(place.highest.height_upper_mm, 0.38);
  EXPECT_NEAR(place.highest.point.z(), 0, 1e-9);
  EXPECT_LE(place.area_mm2, 3600 + 1e-6);
  EXPECT_GE(place.area_mm2, 3600 * 0.9);
  EXPECT_GE(place.area_upper_mm2, 3600 - 1e-6);
  EXPECT_NEAR(found.surface_mm2, 2 * 3600 + 4 * 600, 1e-6);
  EXPECT_TRUE(run(path, {flat(10)}, {plate()}, plate_stock(5), 0.31).places.empty());
}

TEST(Excess, AnUncutFaceInABiggerBlockHasTheMaterialAboveIt) {
  const Toolpath path = path_of({{kRapid, upright(0, 0, 60)}, {kFeed, upright(0, 0, 50)}});
  const ExcessResult found = run(path, {flat(10)}, {plate()}, plate_stock(5), 0.1);
  ASSERT_EQ(found.places.size(), 1U);
  const ExcessPlace& place = found.places.front();
  EXPECT_LE(place.highest.height_mm, 5);
  EXPECT_GE(place.highest.height_mm, 4.9);
  EXPECT_LE(place.highest.height_upper_mm, 5.53);
  EXPECT_GE(place.highest.height_upper_mm, 5 - fine().resolution_mm);
  EXPECT_LE(place.area_mm2, 3600 + 1e-6);
  EXPECT_GE(place.area_mm2, 3600 * 0.9);
  EXPECT_LE(place.area_upper_mm2, 3600 + 1e-6);
}

TEST(Excess, FacesFlushWithTheStockHaveNone) {
  const Toolpath path = path_of({{kRapid, upright(0, 0, 60)}, {kFeed, upright(0, 0, 50)}});
  const ExcessResult found = run(path, {flat(10)}, {plate()}, plate_stock(0), 0.06);
  EXPECT_TRUE(found.places.empty());
  EXPECT_EQ(found.left.size(), 0U);
}

// A wall of a pocket that a side cut leaves 0.2 mm from, beside a floor that is finished.
TEST(Excess, AWallThatASideCutLeavesIsMeasured) {
  const IndexedMesh step = shapes::joined(shapes::box(Vec3(-30, -30, -10), Vec3(30, 30, 0)),
                                          shapes::box(Vec3(-30, -30, 0), Vec3(0, 30, 20)));
  std::vector<Step> steps{
      {kRapid, upright(5.2, -60, 60)}, {kRapid, upright(5.2, -60, 0)}, {kFeed, upright(5.2, 60, 0)}};
  for (double at = 13; at < 40; at += 8) {
    steps.push_back({kFeed, upright(at, steps.back().to.tip.y(), 0)});
    steps.push_back({kFeed, upright(at, -steps.back().to.tip.y(), 0)});
  }
  const ExcessResult found =
      run(path_of(steps), {flat(10)}, {step}, StockSolid::box(Vec3(-30, -30, -10), Vec3(30, 30, 20)), 0.1);
  ASSERT_EQ(found.places.size(), 1U);
  const ExcessPlace& place = found.places.front();
  EXPECT_LE(place.highest.height_mm, 0.2 + 1e-9);
  EXPECT_GE(place.highest.height_mm, 0.19);
  EXPECT_LE(place.highest.height_upper_mm, 0.28);
  EXPECT_NEAR(place.highest.point.x(), 0, 1e-9);
  EXPECT_NEAR(place.highest.at.normal.x(), 1, 1e-12);
  EXPECT_LE(place.area_mm2, 1200 + 1e-6);
  EXPECT_GE(place.area_mm2, 1200 * 0.9);
  EXPECT_GE(place.area_upper_mm2, 1200 * 0.98);
}

TEST(Excess, TheCornerOfAPocketKeepsMaterialOfTheToolsRadius) {
  // The pocket is the space x, y >= 0; its walls are two boxes about the corner (0, 0).
  IndexedMesh part = shapes::box(Vec3(-10, -10, -10), Vec3(40, 40, 0));
  part = shapes::joined(part, shapes::box(Vec3(-10, -10, 0), Vec3(0, 40, 15)));
  part = shapes::joined(part, shapes::box(Vec3(0, -10, 0), Vec3(40, 0, 15)));
  std::vector<Step> steps{
      {kRapid, upright(60, 5, 40)}, {kRapid, upright(60, 5, 0)}, {kFeed, upright(5, 5, 0)}, {kFeed, upright(5, 60, 0)}};
  for (double at = 9; at < 50; at += 8) {
    steps.push_back({kFeed, upright(at, 60, 0)});
    steps.push_back({kFeed, upright(at, 5, 0)});
    steps.push_back({kFeed, upright(at, 60, 0)});
  }
  const double r = 5;
  const ExcessResult found =
      run(path_of(steps), {flat(2 * r)}, {part}, StockSolid::box(Vec3(-10, -10, -10), Vec3(40, 40, 15)), 0.1);
  ASSERT_EQ(found.places.size(), 1U);
  const ExcessPlace& place = found.places.front();
  // Material farthest from both walls is where their bisector meets the cutter: (1 - 1 / sqrt(2)) r from each.
  const double exact = (1 - std::sqrt(0.5)) * r;
  EXPECT_LE(place.highest.height_mm, exact + 1e-9);
  EXPECT_GE(place.highest.height_mm, 0.9 * exact);
  EXPECT_GE(place.highest.height_upper_mm, exact - fine().resolution_mm);
  EXPECT_LE(place.highest.height_upper_mm, 1.11 * exact + fine().resolution_mm);
  // Each wall has more than s between s and r - sqrt(2 r s - s^2) from the corner; the floor farther than s from both walls.
  const double s = 0.1, strip = r - std::sqrt(2 * r * s - s * s) - s;
  EXPECT_GE(place.area_upper_mm2, 2 * 15 * strip * 0.98);
  EXPECT_LE(place.area_upper_mm2, 2 * 15 * strip + (1 - std::numbers::pi / 4) * r * r + 10);
  EXPECT_GE(place.area_mm2, 2 * 15 * strip * 0.65);
}

// Material in an uncut slot is at most half of its width from a wall.
TEST(Excess, AnUncutSlotKeepsHalfOfItsWidth) {
  IndexedMesh part = shapes::box(Vec3(-30, -30, -10), Vec3(30, 30, 0));
  part = shapes::joined(part, shapes::box(Vec3(-30, -30, 0), Vec3(-1, 30, 8)));
  part = shapes::joined(part, shapes::box(Vec3(1, -30, 0), Vec3(30, 30, 8)));
  const Toolpath path = path_of({{kRapid, upright(0, 0, 60)}, {kFeed, upright(0, 0, 50)}});
  const StockSolid stock = StockSolid::box(Vec3(-30, -30, -10), Vec3(30, 30, 8));
  EXPECT_TRUE(run(path, {flat(2)}, {part}, stock, 1.01).places.empty());
  const ExcessResult found = run(path, {flat(2)}, {part}, stock, 0.5);
  ASSERT_EQ(found.places.size(), 1U);
  EXPECT_LE(found.places.front().highest.height_mm, 1 + 1e-6);
  EXPECT_GE(found.places.front().highest.height_mm, 0.9);
  EXPECT_LE(found.places.front().highest.height_upper_mm, 1.13);
  EXPECT_GE(found.places.front().area_mm2, 2 * 7.5 * 60 * 0.8);
  EXPECT_LE(found.places.front().area_mm2, 2 * 7.5 * 60 + 60);
}

// A T-slot cutter undercuts a rib: above the floor is an opening, and above it the rib, which is no part.
TEST(Excess, ABridgeAboveACutIsNotOnTheFloor) {
  const IndexedMesh part = plate();
  ToolAssembly undercutter = tools::assembly(TSlotCutter{70, 0.5, 0.5, 3}, 8);
  undercutter.shank = {{8, 8, 40}};
  const Toolpath path = path_of({{kRapid, upright(0, -90, 0)},
                                 {kFeed, upright(0, -36, 0)},
                                 {kFeed, upright(0, 0, 0)},
                                 {kFeed, upright(0, 90, 0)}});
  const ExcessResult found = run(path, {tools::variants(undercutter)}, {part}, plate_stock(10), 5);
  EXPECT_TRUE(found.places.empty());
}

TEST(Excess, AnUnknownMotionLeavesItOpen) {
  Toolpath path = path_of(rows(30, 0.3, 8));
  path.moves[3].not_checked_reason = "the tool radius compensation is on";
  const ExcessResult found = run(path, {flat(10)}, {plate()}, plate_stock(5), 0.1);
  ASSERT_FALSE(found.places.empty());
  bool is_open = false;
  for (const ExcessPlace& place : found.places) {
    if (place.is_proved()) continue;
    is_open = true;
    EXPECT_EQ(place.unknown.move, 3U);
  }
  EXPECT_TRUE(is_open || found.area_upper_mm2() > found.area_mm2() + 300);
  // A cut that is known proves that nothing is left all the same.
  Toolpath deep = path_of(rows(30, 0, 8));
  deep.moves[0].not_checked_reason = "the tool radius compensation is on";
  EXPECT_TRUE(run(deep, {flat(10)}, {plate()}, plate_stock(5), 0.1).places.empty());
}

TEST(Excess, ResultsAreTheSameAtAnyNumberOfThreads) {
  const Toolpath path = path_of(rows(20, 0.3, 8));
  const ExcessResult one = run(path, {flat(10)}, {plate()}, plate_stock(5), 0.1);
  const ExcessResult three = run(path, {flat(10)}, {plate()}, plate_stock(5), 0.1, fine(), 3);
  ASSERT_EQ(one.places.size(), three.places.size());
  ASSERT_EQ(one.left.size(), three.left.size());
  EXPECT_FALSE(one.places.empty());
  for (std::size_t k = 0; k < one.places.size(); ++k) {
    EXPECT_EQ(one.places[k].highest.height_mm, three.places[k].highest.height_mm);
    EXPECT_EQ(one.places[k].highest.height_upper_mm, three.places[k].highest.height_upper_mm);
    EXPECT_EQ(one.places[k].highest.point, three.places[k].highest.point);
    EXPECT_EQ(one.places[k].area_mm2, three.places[k].area_mm2);
  }
}

TEST(Excess, AnOpenPartIsRefused) {
  const std::vector<Surface> parts{Surface(shapes::open_cube())};
  EXPECT_EQ(PartColumns::of(parts).error().code, "excess-open-part");
}

}  // namespace
}  // namespace gouge::excess_test
