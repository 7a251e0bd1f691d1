// The check against remaining stock beside random points at many instants of random programs.
#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>

#include "lib/stock/check_stock.h"
#include "lib/tool/evaluate.h"
#include "tests/lib/stock/block.h"
#include "tests/support/paths.h"
#include "tests/support/scatter.h"
#include "tests/support/tools.h"

namespace gouge::stock_brute_force_test {
namespace {

constexpr int kInstants = 60;

std::size_t wanted_points() {
  const char* const given = std::getenv("GOUGE_STOCK_POINTS");
  return given == nullptr ? 1200 : static_cast<std::size_t>(std::strtoull(given, nullptr, 10));
}

/// Few programs with many points each where many points are wanted, as the points cost less than the check.
std::size_t points_of_a_program() { return std::max<std::size_t>(400, wanted_points() / 1000); }

/// The whole tool must be clear in a rapid and in a position without a motion to it, shank and holder in other moves.
bool is_whole_tool_examined(const Move& move) { return move.kind == MoveKind::rapid || !move.has_start; }

/// What happens to one point while the program runs, at many instants of each move.
class PointHistory {
 public:
  PointHistory(const Toolpath& path, const MotionLaw& law, const ToolVariants& tool, const Vec3& point)
      : path_(path), law_(law), tool_(tool), point_(point) {}

  /// Returns, for each move, how deep the point is in the examined body while it is farther than `apart_mm` from every
  /// place that the cutter took before.
  [[nodiscard]] std::vector<double> depths(double apart_mm) const {
    std::vector<double> all(path_.moves.size(), 0);
    double nearest = 1e9;
    for (std::size_t i = 1; i < path_.moves.size(); ++i) {
      const Motion motion = law_.of(path_, i);
      const bool is_rapid = is_whole_tool_examined(path_.moves[i]);
      const CompiledTool& body = is_rapid ? tool_.bare : tool_.non_cutting;
      const double way = motion.path_length_mm(0, 1, 0) + motion.turn_rad() * 80;
      for (int n = 0; n <= kInstants; ++n) {
        const Pose pose = motion.at(static_cast<double>(n) / kInstants);
        if (nearest > apart_mm) all[i] = std::max(all[i], -signed_distance_mm(body, pose, point_));
        // Between two instants the cutter may be nearer by half of the way between them.
        if (!is_rapid)
          nearest = std::min(nearest, signed_distance_mm(tool_.cutting, pose, point_) - 0.5 * way / kInstants);
      }
    }
    return all;
  }

 private:
  const Toolpath& path_;
  const MotionLaw& law_;
  const ToolVariants& tool_;
  Vec3 point_;
};

/// Checks random programs with this share of rapids along the axis (block::random_program).
void expect_true_bounds(std::uint64_t seed, double axial_share) {
  const MotionLaw law;
  const StockOptions options;
  const Vec3 low(-15, -15, -15), high(15, 15, 0);
  const StockSolid stock = StockSolid::box(low, high);
  const std::vector<ToolVariants> tools = block::small_tools();
  test::Scatter scatter(seed);
  std::size_t points = 0, deep = 0, findings = 0, proved = 0, open = 0, touched = 0;
  for (int program = 0; points < wanted_points(); ++program) {
    const ToolVariants& tool = tools[scatter.below(tools.size())];
    const Toolpath path = block::random_program(scatter, program % 2 == 1, 24, 0.15, axial_share);
    const std::vector<StockTool> all{{&tool, true}};
    const CutHistory history(path, law, all, options);
    const StockResult result = check_stock(history, stock, options, 1);
    std::vector<double> upper(path.moves.size(), options.tolerance_mm + options.resolution_mm);
    std::vector<bool> is_open(path.moves.size(), false);
    for (const StockFinding& finding : result.findings) {
      upper[finding.move] = finding.depth_upper_mm;
      is_open[finding.move] = !finding.witness;
      if (is_open[finding.move]) ++open;
      if (is_open[finding.move]) continue;
      ++findings;
      // The witness is stock, in the body at its instant, and no cutter was there before.
      const Motion motion = law.of(path, finding.move);
      const bool is_rapid = is_whole_tool_examined(path.moves[finding.move]);
      const CompiledTool& body = is_rapid ? tool.bare : tool.non_cutting;
      const Vec3& p = finding.witness->point;
      EXPECT_NEAR(-signed_distance_mm(body, motion.at(finding.witness->t), p), finding.witness->depth_mm, 1e-6);
      EXPECT_TRUE((p.array() > low.array()).all() && (p.array() < high.array()).all());
      for (std::size_t k = 1; k <= finding.move; ++k) {
        if (path.moves[k].kind == MoveKind::rapid) continue;
        const Motion earlier = law.of(path, k);
        const double until = k == finding.move ? finding.witness->t : 1;
        for (int n = 0; n <= kInstants; ++n)
          EXPECT_GT(signed_distance_mm(tool.cutting, earlier.at(until * n / kInstants), p), -1e-6);
      }
    }
    proved += result.proved;
    for (std::size_t k = 0; k < points_of_a_program(); ++k, ++points) {
      Vec3 point = scatter.point(15);
      point.z() = scatter.in(-15, 0);
      // The stock counts as smaller by the resolution.
      const Vec3 inset = Vec3::Constant(options.resolution_mm);
      point = point.cwiseMax(low + inset).cwiseMin(high - inset);
      const std::vector<double> depths = PointHistory(path, law, tool, point).depths(options.resolution_mm);
      for (std::size_t i = 1; i < depths.size(); ++i) {
        if (depths[i] > 0) ++touched;
        if (depths[i] > options.tolerance_mm) ++deep;
        if (!is_open[i]) {
          EXPECT_LE(depths[i], upper[i] + 1e-7) << "program " << program << ", move " << i;
        }
      }
    }
  }
  std::cout << points << " points, " << deep << " deep, " << findings << " findings, " << proved << " clear moves, "
            << open << " open\n";
  EXPECT_GT(deep, points / 40);
  EXPECT_GT(findings, 10U);
  // A rapid along the axis passes again what a finding touched before, so many of them are open.
  if (!(axial_share > 0)) {
    EXPECT_LT(open, findings);
  }
}

TEST(StockBruteForce, NoPointThatRemainsIsDeeperThanItsBound) { expect_true_bounds(44, 0); }

TEST(StockBruteForce, NoPointIsDeeperAfterRapidsAlongTheAxis) { expect_true_bounds(45, 0.5); }

}  // namespace
}  // namespace gouge::stock_brute_force_test
