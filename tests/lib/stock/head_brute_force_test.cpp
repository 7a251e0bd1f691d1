// Heads beside remaining stock, against random points at many instants of random programs.
#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>

#include "lib/motion/body_motion.h"
#include "lib/stock/check_stock.h"
#include "lib/tool/evaluate.h"
#include "tests/lib/stock/block.h"
#include "tests/support/shapes.h"

namespace gouge::head_brute_force_test {
namespace {

constexpr int kInstants = 60;
const Vec3 kLow(-15, -15, -15), kHigh(15, 15, 0);

std::size_t wanted_points() {
  const char* const given = std::getenv("GOUGE_STOCK_POINTS");
  return given == nullptr ? 1200 : static_cast<std::size_t>(std::strtoull(given, nullptr, 10));
}

/// Returns a random box above or beside the cutter, near its tip.
StockHead random_head(test::Scatter& scatter) {
  const Vec3 low(scatter.in(-8, 5), scatter.in(-8, 5), scatter.in(2, 7));
  const Vec3 high = low + Vec3(scatter.in(2, 12), scatter.in(2, 12), scatter.in(4, 15));
  return StockHead(Surface(shapes::box(low, high)).boundary());
}

/// The depth of a point in the bodies that must be clear at an instant.
struct Bodies {
  const ToolVariants& tool;
  const std::vector<StockHead>& heads;

  [[nodiscard]] double depth_in_heads(const BodyMotion& moving, double t, const Vec3& point) const {
    double depth = -1e9;
    for (const StockHead& head : heads)
      depth = std::max(depth, -head.signed_distance_mm(moving.at(t).inverse().point(point)));
    return depth;
  }
  [[nodiscard]] double depth_in_tool(const Motion& motion, double t, bool is_whole, const Vec3& point) const {
    return -signed_distance_mm(is_whole ? tool.bare : tool.non_cutting, motion.at(t), point);
  }
};

bool is_whole_tool_examined(const Move& move) { return move.kind == MoveKind::rapid || !move.has_start; }

/// Returns, for each move, how deep a point is in a body while it is farther than `apart_mm` from all places of the cutter
/// before.
std::vector<double> depths(const Toolpath& path, const Bodies& bodies, const Vec3& point, double apart_mm) {
  const MotionLaw law;
  std::vector<double> all(path.moves.size(), 0);
  double nearest = 1e9;
  for (std::size_t i = 1; i < path.moves.size(); ++i) {
    const Motion motion = law.of(path, i);
    const BodyMotion moving(motion);
    const bool is_whole = is_whole_tool_examined(path.moves[i]);
    const double way = motion.path_length_mm(0, 1, 0) + motion.turn_rad() * 80;
    for (int n = 0; n <= kInstants; ++n) {
      const double t = static_cast<double>(n) / kInstants;
      if (nearest > apart_mm)
        all[i] = std::max(
            {all[i], bodies.depth_in_heads(moving, t, point), bodies.depth_in_tool(motion, t, is_whole, point)});
      // Between two instants the cutter may be nearer by half of the way between them.
      if (!is_whole)
        nearest =
            std::min(nearest, signed_distance_mm(bodies.tool.cutting, motion.at(t), point) - 0.5 * way / kInstants);
    }
  }
  return all;
}

/// The witness is stock, in the body at its instant, and no cutter and no head was there before.
void expect_true_witness(const Toolpath& path, const Bodies& bodies, const StockFinding& finding) {
  const MotionLaw law;
  const Vec3& point = finding.witness->point;
  const Motion motion = law.of(path, finding.move);
  const bool is_whole = is_whole_tool_examined(path.moves[finding.move]);
  if (finding.body == Body::head) {
    const StockHead& head = bodies.heads[finding.head];
    EXPECT_NEAR(-head.signed_distance_mm(BodyMotion(motion).at(finding.witness->t).inverse().point(point)),
                finding.witness->depth_mm, 1e-6);
  } else {
    EXPECT_NEAR(bodies.depth_in_tool(motion, finding.witness->t, is_whole, point), finding.witness->depth_mm, 1e-6);
  }
  EXPECT_TRUE((point.array() > kLow.array()).all() && (point.array() < kHigh.array()).all());
  for (std::size_t k = 1; k <= finding.move; ++k) {
    const Motion earlier = law.of(path, k);
    const BodyMotion moving(earlier);
    const bool is_own = k == finding.move;
    for (int n = 0; n <= kInstants; ++n) {
      const double t = (is_own ? finding.witness->t : 1) * n / kInstants;
      if (!is_own) {
        EXPECT_LT(bodies.depth_in_heads(moving, t, point), 1e-6);
        EXPECT_LT(bodies.depth_in_tool(earlier, t, true, point), 1e-6);
      }
      if (!is_whole_tool_examined(path.moves[k])) {
        EXPECT_GT(signed_distance_mm(bodies.tool.cutting, earlier.at(t), point), -1e-6);
      }
    }
  }
}

TEST(HeadBruteForce, NoPointThatRemainsIsDeeperThanItsBound) {
  const MotionLaw law;
  const StockOptions options;
  const StockSolid stock = StockSolid::box(kLow, kHigh);
  const std::vector<ToolVariants> tools = block::small_tools();
  test::Scatter scatter(45);
  std::size_t points = 0, deep = 0, in_heads = 0, findings = 0, open = 0, proved = 0;
  for (int program = 0; points < wanted_points(); ++program) {
    const ToolVariants& tool = tools[scatter.below(tools.size())];
    const Toolpath path = block::random_program(scatter, program % 2 == 1, 16);
    std::vector<StockHead> heads;
    for (int k = 0; k < 1 + program % 2; ++k) heads.push_back(random_head(scatter));
    const Bodies bodies{tool, heads};
    const std::vector<StockTool> all{{&tool, true}};
    const CutHistory history(path, law, all, options, nullptr, heads);
    const StockResult result = check_stock(history, stock, options, 1);
    std::vector<double> upper(path.moves.size(), options.tolerance_mm + options.resolution_mm);
    for (const StockFinding& finding : result.findings) {
      upper[finding.move] = finding.witness ? finding.depth_upper_mm : 1e9;
      ++(finding.witness ? findings : open);
      if (!finding.witness) continue;
      if (finding.body == Body::head) ++in_heads;
      expect_true_witness(path, bodies, finding);
    }
    proved += result.proved;
    for (std::size_t k = 0; k < 200; ++k, ++points) {
      Vec3 point = scatter.point(15);
      point.z() = scatter.in(-15, 0);
      // The stock counts as smaller by the resolution.
      const Vec3 inset = Vec3::Constant(options.resolution_mm);
      point = point.cwiseMax(kLow + inset).cwiseMin(kHigh - inset);
      const std::vector<double> depth = depths(path, bodies, point, options.resolution_mm);
      for (std::size_t i = 1; i < depth.size(); ++i) {
        if (depth[i] > options.tolerance_mm) ++deep;
        EXPECT_LE(depth[i], upper[i] + 1e-7) << "program " << program << ", move " << i;
      }
    }
  }
  std::cout << points << " points, " << deep << " deep, " << findings << " findings, " << in_heads << " in heads, "
            << proved << " clear moves, " << open << " open\n";
  EXPECT_GT(deep, points / 40);
  EXPECT_GT(in_heads, 3U);
  EXPECT_GT(proved, 10U);
}

}  // namespace
}  // namespace gouge::head_brute_force_test
