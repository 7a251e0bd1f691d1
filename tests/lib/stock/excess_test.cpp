// The material left on a part where the answer is known in closed form.
#include <gtest/gtest.h>

#include <chrono>
#include <iostream>
#include <numbers>

#include "lib/stock/excess.h"
#include "tests/support/paths.h"
#include "tests/support/shapes.h"
#include "tests/support/tools.h"

namespace gouge {
namespace {

using paths::upright;
constexpr MoveKind kFeed = MoveKind::feed, kRapid = MoveKind::rapid;

StockOptions fine() {
  StockOptions options;
  options.resolution_mm = 0.025;
  return options;
}

struct Step {
  MoveKind kind;
  Pose to;
};

Toolpath path_of(const std::vector<Step>& steps) {
  std::vector<Pose> poses;
  for (const Step& step : steps) poses.push_back(step.to);
  Toolpath path = paths::through(poses);
  for (std::size_t i = 0; i < steps.size(); ++i) path.moves[i].kind = steps[i].kind;
  return path;
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
  const Result<PartColumns> columns = PartColumns::of(parts);
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
  EXPECT_LE(place.highest.height_upper_mm, 0.36);
  EXPECT_NEAR(place.highest.point.z(), 0, 1e-9);
  EXPECT_LE(place.area_mm2, 3600 + 1e-6);
  EXPECT_GE(place.area_mm2, 3600 * 0.9);
  EXPECT_GE(place.area_upper_mm2, 3600 - 1e-6);
  EXPECT_NEAR(found.surface_mm2, 2 * 3600 + 4 * 600, 1e-6);
  EXPECT_TRUE(run(path, {flat(10)}, {plate()}, plate_stock(5), 0.31).places.empty());
}

}  // namespace
}  // namespace gouge
