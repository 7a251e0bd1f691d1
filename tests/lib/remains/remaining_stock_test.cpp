// The meshes of the remaining stock beside closed forms and random points.
#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <iostream>

#include "lib/mesh/mesh_findings.h"
#include "lib/mesh/write_stl.h"
#include "lib/remains/remaining_stock.h"
#include "lib/surface/surface.h"
#include "lib/tool/evaluate.h"
#include "lib/validate/validate_mesh.h"
#include "tests/support/paths.h"
#include "tests/support/scatter.h"
#include "tests/support/tools.h"

namespace gouge {
namespace {

using paths::upright;

constexpr double kResolution_mm = 0.05;

struct Cut {
  Toolpath path;
  std::vector<ToolVariants> tools;
  StockSolid stock;
  MotionLaw law = {};

  [[nodiscard]] RemainingStock remaining(const RemainsOptions& options = {}, unsigned threads = 0) const {
    std::vector<StockTool> all;
    for (const ToolVariants& tool : tools) all.push_back({&tool, true});
    const CutHistory history(path, law, all, StockOptions{});
    const auto start = std::chrono::steady_clock::now();
    Result<RemainingStock> found =
        remaining_stock(history, stock, path.moves.size(), kResolution_mm, options, {threads, {}});
    EXPECT_TRUE(found.has_value()) << (found ? "" : found.error().message);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    std::cout << "cell " << found->cell_mm << ", triangles " << found->perhaps.triangles.size() << " "
              << found->surely.triangles.size() << ", volumes " << found->perhaps_mm3 << " " << found->surely_mm3
              << ", apart " << found->apart_mm.value_or(-1) << ", slivers " << found->sliver_cells << ", " << seconds
              << " s\n";
    if (const char* const folder = std::getenv("GOUGE_STOCK_MESHES")) {
      const std::string name =
          std::string(folder) + "/" + testing::UnitTest::GetInstance()->current_test_info()->name();
      std::ofstream(name + ".stl", std::ios::binary) << binary_stl_bytes(found->perhaps, LengthUnit::mm);
      std::ofstream(name + ".surely.stl", std::ios::binary) << binary_stl_bytes(found->surely, LengthUnit::mm);
    }
    return std::move(*found);
  }
};

void expect_sound(const IndexedMesh& mesh) {
  const MeshValidation judged = validate_mesh(mesh, find_mesh_findings(mesh));
  EXPECT_TRUE(judged.is_sound()) << judged.self_intersections.pairs << " pairs, " << judged.defects() << " defects at "
                                 << judged.self_intersections.position_mm.transpose();
}

TEST(RemainingStock, ABlockWithASlot) {
  const Cut cut{paths::through({upright(-80, 0, -5), upright(80, 0, -5)}),
                {tools::flat(10)},
                StockSolid::box(Vec3(-50, -50, -40), Vec3(50, 50, 0))};
  const RemainingStock found = cut.remaining();
  const double exact = 100.0 * 100 * 40 - 100.0 * 10 * 5;
  EXPECT_GE(found.perhaps_mm3, exact);
  EXPECT_LE(found.surely_mm3, exact);
  EXPECT_LT(found.perhaps_mm3 - found.surely_mm3, 0.3 * (2 * 100 * 100 + 4 * 100 * 40 + 1000));
  expect_sound(found.perhaps);
  expect_sound(found.surely);
}

TEST(RemainingStock, ABallGroove) {
  const Cut cut{paths::through({upright(-40, 0, -3), upright(40, 0, -3)}),
                {tools::ball(10)},
                StockSolid::box(Vec3(-20, -15, -12), Vec3(20, 15, 0))};
  const RemainingStock found = cut.remaining({0.5, 0});
  expect_sound(found.perhaps);
  expect_sound(found.surely);
}

TEST(RemainingStock, AbuttingPasses) {
  std::vector<Pose> poses{upright(-40, -10, -3)};
  for (int k = -1; k <= 1; ++k) {
    poses.push_back(upright(k % 2 == 0 ? 40 : -40, 10.0 * k, -3));
    poses.push_back(upright(k % 2 == 0 ? -40 : 40, 10.0 * k, -3));
  }
  const Cut cut{paths::through(poses), {tools::flat(10)}, StockSolid::box(Vec3(-20, -25, -12), Vec3(20, 25, 0))};
  const RemainingStock found = cut.remaining();
  expect_sound(found.perhaps);
  expect_sound(found.surely);
}

TEST(RemainingStock, APocketWithThinWalls) {
  std::vector<Pose> poses;
  for (int k = 0; k < 6; ++k) {
    const double x = -25 + 10.3 * k;
    poses.push_back(upright(x, -10, 5));
    poses.push_back(upright(x, -10, -8));
    poses.push_back(upright(x, 10, -8));
    poses.push_back(upright(x, 10, 5));
  }
  const Cut cut{paths::through(poses), {tools::flat(10)}, StockSolid::box(Vec3(-35, -20, -12), Vec3(35, 20, 0))};
  const RemainingStock found = cut.remaining();
  expect_sound(found.perhaps);
  expect_sound(found.surely);
}

TEST(RemainingStock, FiveAxes) {
  std::vector<Pose> poses;
  for (int row = 0; row < 40; ++row) {
    for (int k = 0; k <= 40; ++k) {
      const double x = (row % 2 == 0 ? 1 : -1) * (-20 + k), y = -10 + 0.5 * row;
      const Vec3 axis = Vec3(0.3 * std::sin(0.1 * x), 0.3 * std::cos(0.1 * y + 0.05 * x), 1).normalized();
      poses.push_back({Vec3(x, y, -6 + std::sin(0.3 * x) + std::cos(0.25 * y)), axis});
    }
  }
  const Cut cut{paths::through(poses), {tools::ball(10)}, StockSolid::box(Vec3(-30, -20, -15), Vec3(30, 20, -3))};
  const RemainingStock found = cut.remaining();
  expect_sound(found.perhaps);
  expect_sound(found.surely);
}

}  // namespace
}  // namespace gouge
