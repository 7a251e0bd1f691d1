// The meshes of the remaining stock where their volume is known in closed form.
#include <gtest/gtest.h>

#include <numbers>

#include "lib/mesh/mesh_findings.h"
#include "lib/mesh/write_stl.h"
#include "lib/remains/remaining_stock.h"
#include "lib/stock/check_stock.h"
#include "lib/surface/surface.h"
#include "lib/validate/validate_mesh.h"
#include "tests/support/paths.h"
#include "tests/support/tools.h"

namespace gouge::remaining_stock_test {
namespace {

using paths::upright;

constexpr double kResolution_mm = 0.05;

/// A program and the stock that it cuts.
struct Cut {
  Toolpath path;
  std::vector<ToolVariants> tools;
  StockSolid stock;
  MotionLaw law = {};

  [[nodiscard]] std::vector<StockTool> all_tools() const {
    std::vector<StockTool> all;
    for (const ToolVariants& tool : tools) all.push_back({&tool, true});
    return all;
  }
  [[nodiscard]] Result<RemainingStock> remaining(const RemainsOptions& options = {}, unsigned threads = 0) const {
    const std::vector<StockTool> all = all_tools();
    const CutHistory history(path, law, all, StockOptions{});
    return remaining_stock(history, stock, path.moves.size(), kResolution_mm, options, {threads, {}});
  }
};

StockSolid block() { return StockSolid::box(Vec3(-25, -20, -12), Vec3(25, 20, 0)); }

void expect_sound(const IndexedMesh& mesh) {
  const MeshValidation judged = validate_mesh(mesh, find_mesh_findings(mesh));
  EXPECT_TRUE(judged.is_sound()) << judged.defects() << " defects, " << judged.self_intersections.pairs
                                 << " pairs of triangles that meet";
}

/// Both volumes are at most the area times the given distance from the exact one, and both meshes are sound.
void expect_about(const RemainingStock& found, double exact_mm3, double area_mm2, double apart_mm) {
  EXPECT_GE(found.perhaps_mm3, exact_mm3);
  EXPECT_LE(found.surely_mm3, exact_mm3);
  EXPECT_LT(found.perhaps_mm3, exact_mm3 + area_mm2 * apart_mm);
  EXPECT_GT(found.surely_mm3, exact_mm3 - area_mm2 * apart_mm);
  expect_sound(found.perhaps);
  expect_sound(found.surely);
}

constexpr double kBlock_mm3 = 50.0 * 40 * 12, kBlock_mm2 = 2 * (50.0 * 40 + 50 * 12 + 40 * 12);

TEST(RemainingStock, ABlockWithASlotLiesBetweenBothMeshes) {
  const Cut cut{paths::through({upright(-40, 1.3, -5), upright(40, 1.3, -5)}), {tools::flat(10)}, block()};
  const RemainingStock found = cut.remaining().value();
  expect_about(found, kBlock_mm3 - 50.0 * 10 * 5, kBlock_mm2 + 500, 1.2 * kResolution_mm);
  // Corners of three planes are cut off by the mesh.
  EXPECT_LT(*found.apart_mm, 4 * kResolution_mm);
  EXPECT_EQ(found.sliver_cells, 0U);
}

TEST(RemainingStock, ABallGrooveLiesBetweenBothMeshes) {
  const Cut cut{paths::through({upright(-40, 0.7, -4), upright(40, 0.7, -4)}), {tools::ball(10)}, block()};
  const double half = std::sqrt(5.0 * 5 - 1), angle = 2 * std::atan2(half, 1.0);
  const double groove_mm2 = 0.5 * 25 * angle - half * 1;
  expect_about(cut.remaining().value(), kBlock_mm3 - 50 * groove_mm2, kBlock_mm2 + 500, 1.4 * kResolution_mm);
}

TEST(RemainingStock, APocketLiesBetweenBothMeshes) {
  std::vector<Pose> poses{upright(-10, -6, 10), upright(-10, -6, -6)};
  for (int row = -3; row <= 3; ++row) {
    poses.push_back(upright(row % 2 == 0 ? 10 : -10, 2.0 * row, -6));
    poses.push_back(upright(row % 2 == 0 ? -10 : 10, 2.0 * row, -6));
  }
  const Cut cut{paths::through(poses), {tools::flat(10)}, block()};
  const double corners_mm2 = (4 - std::numbers::pi) * 25;
  expect_about(cut.remaining().value(), kBlock_mm3 - 6 * (30.0 * 22 - corners_mm2), kBlock_mm2 + 1000,
               1.4 * kResolution_mm);
}

TEST(RemainingStock, ATiltedSlotLiesBetweenBothMeshes) {
  const Vec3 axis = Vec3(0, 0.3, 1).normalized();
  const Cut cut{paths::through({{Vec3(-40, 0, -4), axis}, {Vec3(40, 0, -4), axis}}), {tools::flat(8)}, block()};
  // The slot's section is a strip 8 mm wide between its lowest edge and the plane z = 0; that edge's middle is 4 mm deep.
  const double depth = 4 / axis.z();
  expect_about(cut.remaining().value(), kBlock_mm3 - 50 * 8 * depth, kBlock_mm2 + 800, 1.4 * kResolution_mm);
}

TEST(RemainingStock, PassesThatAbutLeaveNoSheetBetweenThem) {
  std::vector<Pose> poses{upright(-40, -10, -3)};
  for (int row = -1; row <= 1; ++row) {
    poses.push_back(upright(row % 2 == 0 ? 40 : -40, 10.0 * row, -3));
    poses.push_back(upright(row % 2 == 0 ? -40 : 40, 10.0 * row, -3));
  }
  const Cut cut{paths::through(poses), {tools::flat(10)}, block()};
  const RemainingStock found = cut.remaining().value();
  expect_about(found, kBlock_mm3 - 50.0 * 30 * 3, kBlock_mm2 + 400, 1.4 * kResolution_mm);
  EXPECT_GT(found.sliver_cells, 0U);
}

TEST(RemainingStock, AThinWallIsPerhapsThere) {
  // A wall of 0.3 mm between two slots is thinner than the cells.
  for (const double y : {0.0, 0.11, 0.23}) {
    const Cut cut{paths::through({upright(-40, y - 5.15, -5), upright(40, y - 5.15, -5), upright(40, y + 5.15, -5),
                                  upright(-40, y + 5.15, -5)}),
                  {tools::flat(10)},
                  block()};
    const RemainingStock found = cut.remaining().value();
    expect_sound(found.perhaps);
    expect_sound(found.surely);
    const Surface outer(found.perhaps);
    for (double x = -24; x < 25; x += 0.37)
      for (const double side : {-0.14, 0.0, 0.14})
        EXPECT_TRUE(outer.winds_around(Vec3(x, y + side, -0.02))) << x << " " << y;
  }
}

TEST(RemainingStock, NearAnUnknownMotionNothingIsSure) {
  Toolpath path = paths::through({upright(-40, 0, -5), upright(40, 0, -5), upright(40, 0, 60), upright(15, 0, -3)});
  path.moves[3].not_checked_reason = "cutter compensation";
  const Cut cut{path, {tools::flat(10)}, block()};
  const RemainingStock found = cut.remaining().value();
  EXPECT_GE(found.perhaps_mm3, kBlock_mm3 - 50.0 * 10 * 5);
  EXPECT_TRUE(found.surely.triangles.empty());
  EXPECT_FALSE(found.apart_mm.has_value());
}

TEST(RemainingStock, ABlockThatIsCutAwayLeavesNothing) {
  const Cut cut{paths::through({upright(-80, 0, -13), upright(80, 0, -13)}), {tools::flat(60)}, block()};
  const RemainingStock found = cut.remaining().value();
  EXPECT_TRUE(found.perhaps.triangles.empty());
  EXPECT_TRUE(found.surely.triangles.empty());
}

TEST(RemainingStock, TooManyCellsAreRefused) {
  const Cut cut{paths::through({upright(-40, 0, -5), upright(40, 0, -5)}), {tools::flat(10)}, block()};
  const Result<RemainingStock> found = cut.remaining({1e-5, 0});
  ASSERT_FALSE(found.has_value());
  EXPECT_EQ(found.error().code, "stock-cells-too-many");
}

TEST(RemainingStock, TheMeshesAreTheSameAtAnyNumberOfThreads) {
  const Cut cut{
      paths::through({upright(-40, 3, -5), upright(0, -2, -4), upright(40, 5, -6)}), {tools::bull(10)}, block()};
  const RemainingStock one = cut.remaining({}, 1).value(), three = cut.remaining({}, 3).value();
  EXPECT_EQ(binary_stl_bytes(one.perhaps, LengthUnit::mm), binary_stl_bytes(three.perhaps, LengthUnit::mm));
  EXPECT_EQ(binary_stl_bytes(one.surely, LengthUnit::mm), binary_stl_bytes(three.surely, LengthUnit::mm));
}

TEST(RemainingStock, APartWithAnAllowanceLiesBetweenBothMeshes) {
  const Cut made{paths::through({upright(-80, 0, 30), upright(80, 0, 30)}), {tools::flat(10)}, block()};
  const IndexedMesh part = made.remaining({2, 0}).value().perhaps;
  const Cut cut{made.path, made.tools, StockSolid::meshes({&part, 1}, 3).value()};
  // The part is the block moved out by 0.05 mm; the allowance has round edges.
  const Vec3 size(50.1, 40.1, 12.1);
  const double area = 2 * (size.x() * size.y() + size.x() * size.z() + size.y() * size.z());
  const double exact = size.prod() + 3 * area + std::numbers::pi * 9 * size.sum() + 4.0 / 3 * std::numbers::pi * 27;
  expect_about(cut.remaining().value(), exact, area + 3 * 6 * size.sum(), 2.5 * kResolution_mm);
}

TEST(RemainingStock, TheOuterMeshIsTheStockOfTheNextSetUp) {
  const std::vector<Pose> first{upright(-40, 0, 10), upright(-40, 0, -5), upright(40, 0, -5), upright(40, 0, 20)};
  const auto second = [](double y, double z) {
    return std::vector<Pose>{upright(-40, y, 20), upright(-40, y, z), upright(40, y, z)};
  };
  const Cut cut{paths::through(first), {tools::flat(10)}, block()};
  const RemainingStock between = cut.remaining().value();
  const StockSolid next = StockSolid::meshes({&between.perhaps, 1}, 0).value();
  const auto has_findings = [&](std::vector<Pose> poses, std::size_t rapids, const StockSolid& stock) {
    Cut all{paths::through(poses), cut.tools, stock};
    for (std::size_t i = 0; i < poses.size(); ++i)
      if (i == 0 || i + rapids >= poses.size()) all.path.moves[i].kind = MoveKind::rapid;
    const std::vector<StockTool> tools = all.all_tools();
    const CutHistory history(all.path, all.law, tools, StockOptions{});
    return !check_stock(history, stock, StockOptions{}, 1).findings.empty();
  };
  // Rapids through the slot, beside it by more than the distance of the meshes, and deeper.
  for (const auto& [y, z, meets] : {std::tuple(0.0, -4.9, false), std::tuple(0.0, -1.0, false),
                                    std::tuple(0.6, -4.9, true), std::tuple(0.0, -5.6, true)}) {
    std::vector<Pose> both = first;
    for (const Pose& pose : second(y, z)) both.push_back(pose);
    EXPECT_EQ(has_findings(both, 3, block()), meets) << y << " " << z;
    EXPECT_EQ(has_findings(second(y, z), 3, next), meets) << y << " " << z;
  }
}

}  // namespace
}  // namespace gouge::remaining_stock_test
