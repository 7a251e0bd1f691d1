// The bounds of depths in remaining stock beside exact depths: rapids past raw boxes and edges of cuts.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "lib/check/stock_bounds.h"
#include "lib/stock/check_stock.h"
#include "tests/lib/stock/block.h"
#include "tests/support/paths.h"
#include "tests/support/scatter.h"
#include "tests/support/tools.h"

namespace gouge::stock_exact_test {
namespace {

constexpr double kRounding_mm = 1e-6;
constexpr double kRadius_mm = 5, kTolerance_mm = 0.1, kResolution_mm = 0.05;
constexpr double kClear_mm = largest_clear_stock_mm(kTolerance_mm, kResolution_mm);

using block::kFeed;
using block::kRapid;
using paths::upright;

ToolVariants ball() {
  ToolAssembly tool = tools::assembly(BallCutter{2 * kRadius_mm, 40}, 2 * kRadius_mm);
  tool.shank = {{2 * kRadius_mm, 2 * kRadius_mm, 20}};
  return tools::variants(tool);
}

/// A rapid along x past a stock, with the tip at these coordinates.
Toolpath pass(double y, double z) {
  return block::path_of({{kRapid, upright(-40, y, z)}, {kRapid, upright(40, y, z)}});
}

/// Compares the result of the last move with the exact depth. Returns whether the move is a finding.
bool expect_true_bounds(const StockResult& result, std::size_t move, double exact_mm) {
  for (const StockFinding& finding : result.findings) {
    if (finding.move != move) continue;
    EXPECT_TRUE(finding.witness.has_value()) << exact_mm;
    if (!finding.witness) return false;
    EXPECT_LE(finding.witness->depth_mm, exact_mm + kRounding_mm);
    EXPECT_GE(finding.depth_upper_mm, exact_mm - kRounding_mm);
    return true;
  }
  EXPECT_LE(exact_mm, kClear_mm + kRounding_mm);
  return false;
}

/// The same for a rapid past stock that nothing has cut.
bool expect_true_raw_bounds(const StockSolid& stock, const ToolVariants& tool, double y, double z, double exact_mm) {
  SCOPED_TRACE(testing::Message() << "y " << y << ", z " << z << ", depth " << exact_mm);
  const bool is_finding = expect_true_bounds(block::run(pass(y, z), {tool}, stock), 1, exact_mm);
  EXPECT_TRUE(!is_finding || exact_mm > kTolerance_mm);
  return is_finding;
}

double ball_depth(double aside_mm, double above_mm) {
  return std::max(0.0, kRadius_mm - std::hypot(std::max(0.0, aside_mm), std::max(0.0, above_mm)));
}

TEST(StockExact, ABallAboveABoxIsAsDeepAsItsBoundsSay) {
  const ToolVariants tool = ball();
  test::Scatter scatter(71);
  std::size_t findings = 0;
  for (int k = 0; k < 60; ++k) {
    const double half_width_mm = 8;
    const StockSolid stock = StockSolid::box({-8, -half_width_mm, -10}, {8, half_width_mm, 0});
    const double wanted_mm = scatter.is(0.5) ? scatter.in(0.05, 0.3) : scatter.in(0.1, 3), turn = scatter.in(0, 1.5);
    const double far_mm = kRadius_mm - wanted_mm;
    const double y = half_width_mm + far_mm * std::sin(turn), z = far_mm * std::cos(turn) - kRadius_mm;
    findings += expect_true_raw_bounds(stock, tool, y, z, ball_depth(y - half_width_mm, z + kRadius_mm));
  }
  EXPECT_GT(findings, 30U);
}

TEST(StockExact, AFlatToolInABoxIsAsDeepAsItsBoundsSay) {
  const ToolVariants tool = block::flat(10, 40, 10);
  const StockSolid stock = StockSolid::box({-8, -8, -10}, {8, 8, 0});
  test::Scatter scatter(72);
  for (int k = 0; k < 60; ++k) {
    const double aside_mm = scatter.is(0.5) ? kRadius_mm - scatter.in(0.02, 0.3) : scatter.in(0, 5);
    const double deep_mm = scatter.is(0.5) ? scatter.in(0.05, 0.3) : scatter.in(0.1, 3);
    expect_true_raw_bounds(stock, tool, 8 + aside_mm, -deep_mm, std::min(kRadius_mm - aside_mm, deep_mm));
  }
}

TEST(StockExact, ABallAboveTheEdgeOfTwoCutsIsAsDeepAsItsBoundsSay) {
  const std::vector<ToolVariants> tools{block::flat(40, 60, 40), block::flat(10, 60, 10), ball()};
  test::Scatter scatter(74);
  std::size_t findings = 0;
  for (int k = 0; k < 40; ++k) {
    // The face is cut to z = -1, then a slot from x = 0 to x = 10. The edge between them is at x = 0, z = -1.
    Toolpath path = block::path_of({{kRapid, upright(0, -80, -1)}, {kFeed, upright(0, 80, -1)}});
    block::append({{kRapid, upright(5, -80, -20)}, {kFeed, upright(5, 80, -20)}}, 1, path);
    const double wanted_mm = scatter.is(0.6) ? scatter.in(0.08, 0.4) : scatter.in(0.1, 2), turn = scatter.in(0, 0.8);
    const double far_mm = kRadius_mm - wanted_mm;
    const double x = far_mm * std::sin(turn), z = far_mm * std::cos(turn) - kRadius_mm - 1;
    block::append({{kRapid, upright(x, -80, z)}, {kRapid, upright(x, 80, z)}}, 2, path);
    SCOPED_TRACE(testing::Message() << "x " << x << ", z " << z << ", depth " << wanted_mm);
    findings += expect_true_bounds(block::run(path, tools), path.moves.size() - 1, wanted_mm);
  }
  EXPECT_GT(findings, 10U);
}

}  // namespace
}  // namespace gouge::stock_exact_test
