// Rapids along the tool axis, out of an own cut and back into it.
#include <gtest/gtest.h>

#include <vector>

#include "tests/lib/stock/block.h"
#include "tests/support/paths.h"
#include "tests/support/scatter.h"
#include "tests/support/tools.h"

namespace gouge::axial_moves_test {
namespace {

using block::kFeed;
using block::kRapid;

/// Tools that widen upwards, each with a shank and a holder.
std::vector<ToolVariants> widening_tools() {
  std::vector<ToolVariants> made = tools::all();
  for (const Cutter& cutter :
       std::vector<Cutter>{BallCutter{10, 30}, BallCutter{2, 8}, BullNoseCutter{16, 3, 40}, BullNoseCutter{16, 0.5, 40},
                           DrillCutter{8.5, 118, 30}, ChamferCutter{12, 0, 45, 10}, TaperedCutter{3, 1, 15, 30},
                           LensCutter{16, 40, 1, 12}, OvalCutter{10, 2, 60, 24}, RadiusCutter{4, 0.5, 2, 8, 15}})
    made.push_back(tools::variants(tools::assembly(cutter, 6)));
  return made;
}

/// A plunge along the axis and a cut across it; at the end a rapid out, back to `down` below the cut, and out again.
Toolpath out_and_back(const Vec3& axis, double depth, double way, double down = 0) {
  const Vec3 first = -depth * axis, last = first + 12 * axis.unitOrthogonal();
  const auto at = [&](const Vec3& tip) { return Pose{tip, axis}; };
  const Pose out = at(last + way * axis);
  return block::path_of({{kRapid, at(first + 60 * axis)},
                         {kFeed, at(first)},
                         {kFeed, at(last)},
                         {kRapid, out},
                         {kRapid, at(last - down * axis)},
                         {kRapid, out}});
}

TEST(AxialMoves, OutOfAnOwnCutAndBackAreClear) {
  test::Scatter scatter(17);
  const std::vector<ToolVariants> tools = widening_tools();
  for (std::size_t k = 0; k < tools.size(); ++k) {
    for (const double lean : {0.0, 0.3}) {
      for (const double way : {0.7, 3.0, 40.0}) {
        const StockResult result = block::run(out_and_back(scatter.axis(lean), scatter.in(1, 4), way), {tools[k]});
        EXPECT_TRUE(result.findings.empty())
            << "tool " << k << ", lean " << lean << ", way " << way << ", move " << result.findings.front().move;
      }
    }
  }
}

TEST(AxialMoves, DownBelowAnOwnCutIsFound) {
  test::Scatter scatter(18);
  constexpr double kDown_mm = 1;
  const std::vector<ToolVariants> tools = widening_tools();
  for (std::size_t k = 0; k < tools.size(); ++k) {
    const Toolpath path = out_and_back(scatter.axis(k % 2 == 0 ? 0 : 0.3), 3, 20, kDown_mm);
    const StockResult result = block::run(path, {tools[k]});
    // The rapid up passes the same material again; the one down touched it without cutting.
    ASSERT_FALSE(result.findings.empty()) << k;
    const StockFinding& finding = result.findings.front();
    EXPECT_EQ(finding.move, 4U) << k;
    ASSERT_TRUE(finding.witness.has_value()) << k;
    EXPECT_LE(finding.witness->depth_mm, kDown_mm + 1e-6) << k;
  }
}

}  // namespace
}  // namespace gouge::axial_moves_test
