#include "lib/tool/reach_bound.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <optional>
#include <vector>

#include "lib/tool/certified_depth.h"
#include "lib/tool/evaluate.h"
#include "tests/support/random_tools.h"
#include "tests/support/tools.h"

namespace gouge::reach_bound_test {
namespace {

/// The holder of these tools widens by 3 mm over 30: its upper corner has 84.3 degrees.
constexpr double kHolderCorner = 1.4905;

double reach_at(const CompiledTool& tool, double depth, double enough) {
  return bound_reach(tool, tool, depth, enough);
}

/// The reach by looking: places of a grid, those deeper than the given depth by all but half a step that are joined with the axis
/// by neighbours (so no fewer than truly are), and the farthest point of the tool from them.
class GridReach {
 public:
  static constexpr int kRows = 420, kColumns = 260;

  GridReach(const CompiledTool& tool, double depth) : tool_(tool), depth_(depth) {
    dr_ = tool.r_max_mm / kColumns;
    dz_ = (tool.z_max_mm - tool.z_min_mm) / kRows;
    flood();
  }
  [[nodiscard]] double step() const { return std::hypot(dr_, dz_); }
  [[nodiscard]] bool is_empty() const { return rim_.empty(); }
  /// Truly no less than this less a step.
  [[nodiscard]] double largest() const {
    double largest = 0;
    const auto look = [&](const Vec2& q) {
      double nearest = kNoReach_mm;
      for (const Vec2& e : rim_) nearest = std::min(nearest, (e - q).squaredNorm());
      largest = std::max(largest, nearest);
    };
    for (int i = 0; i <= kRows; i += 2) {
      for (int j = 0; j <= kColumns; j += 2) {
        const double d = depth_at(point(i, j));
        if (d > 0 && is_deep_[index(i, j)] == 0) look(point(i, j));
      }
    }
    for (const BoundaryElement& e : tool_.elements) look(e.a), look(e.b);
    return std::sqrt(largest);
  }

 private:
  static std::size_t index(int i, int j) { return static_cast<std::size_t>(i * (kColumns + 1) + j); }
  [[nodiscard]] Vec2 point(int i, int j) const { return {dr_ * j, tool_.z_min_mm + dz_ * i}; }
  [[nodiscard]] double depth_at(const Vec2& q) const { return -evaluate(tool_, q.x(), q.y()).signed_distance_mm; }

  void flood() {
    std::vector<char> is_free(index(kRows, kColumns) + 1, 0);
    is_deep_.assign(is_free.size(), 0);
    std::vector<std::pair<int, int>> open;
    for (int i = 0; i <= kRows; ++i) {
      for (int j = 0; j <= kColumns; ++j) is_free[index(i, j)] = depth_at(point(i, j)) > depth_ - 0.5 * step() ? 1 : 0;
      if (is_free[index(i, 0)] != 0) open.emplace_back(i, 0), is_deep_[index(i, 0)] = 1;
    }
    while (!open.empty()) {
      const auto [i, j] = open.back();
      open.pop_back();
      bool is_rim = false;
      for (int k = std::max(0, i - 1); k <= std::min(kRows, i + 1); ++k) {
        for (int l = std::max(0, j - 1); l <= std::min(kColumns, j + 1); ++l) {
          is_rim = is_rim || is_free[index(k, l)] == 0;
          if (is_free[index(k, l)] == 0 || is_deep_[index(k, l)] != 0) continue;
          is_deep_[index(k, l)] = 1;
          open.emplace_back(k, l);
        }
      }
      if (is_rim) rim_.push_back(point(i, j));
    }
  }

  const CompiledTool& tool_;
  double depth_, dr_ = 0, dz_ = 0;
  std::vector<char> is_deep_;
  std::vector<Vec2> rim_;
};

TEST(ReachBound, OfACylinderIsItsCorner) {
  const CompiledTool tool = tools::flat(10).bare;
  for (const double depth : {0.001, 0.011, 0.5}) {
    EXPECT_LE(reach_at(tool, depth, 3 * depth), 3 * depth);
    const double exact = reach_at(tool, depth, 1.2 * depth);
    EXPECT_GE(exact, std::numbers::sqrt2 * depth - 1e-9);
    EXPECT_LE(exact, 1.03 * kHolderCorner * depth);
  }
}

TEST(ReachBound, OfAPointIsTheDepthOverTheSineOfHalfItsAngle) {
  for (const double half_deg : {2.0, 5.0, 10.0, 15.0, 30.0, 60.0}) {
    const CompiledTool tool = tools::variants(tools::assembly(ChamferCutter{1, 0, half_deg, 0}, 1)).bare;
    const double depth = 0.011, truth = depth / std::sin(half_deg * std::numbers::pi / 180);
    const double bound = reach_at(tool, depth, 1.02 * depth);
    EXPECT_GE(bound, truth - 1e-9) << half_deg;
    EXPECT_LE(bound, 1.03 * std::max(truth, kHolderCorner * depth)) << half_deg;
  }
}

TEST(ReachBound, OfASawIsAllOfItsBladeOnceTheBladeIsThinnerThanTwiceTheDepth) {
  const CompiledTool tool = tools::variants(tools::assembly(SlittingSawCutter{63, 0.5, 16, 4}, 6)).bare;
  EXPECT_LT(reach_at(tool, 0.2, 0.6), 0.6);
  EXPECT_GT(reach_at(tool, 0.26, 0.78), 23.0);
  EXPECT_LT(reach_at(tool, 0.26, 0.78), 24.2);
}

TEST(ReachBound, IsEndlessWhereNoPlaceOfTheAxisIsThatDeep) {
  const CompiledTool tool = tools::flat(10).bare;
  EXPECT_TRUE(std::isinf(reach_at(tool, 30, 90)));
}

TEST(ReachBound, OfUsualCuttersIsLessThanThreeTimesTheDepth) {
  std::vector<ToolVariants> usual = tools::all();
  for (const ToolVariants& tool : tools::shapes()) usual.push_back(tool);
  for (const double angle : {30.0, 60.0})
    usual.push_back(tools::variants(tools::assembly(ChamferCutter{12, 0, angle, 14}, 6)));
  for (const double angle : {30.0, 45.0})  // from the axis: corners of 60 and 45 degrees
    usual.push_back(tools::variants(tools::assembly(DovetailCutter{20, 0, angle, 6}, 6)));
  for (const ToolVariants& tool : usual) {
    for (const double depth : {0.001, 0.011, 0.06}) {
      const CertifiedDepth sure = find_certified_depth(tool.bare, tool.bare, depth);
      EXPECT_EQ(sure.halvings, 0) << "cutter of " << tool.bare.elements[1].a.transpose() << ", "
                                  << tool.bare.elements[3].a.transpose() << " at " << depth << ": " << sure.reach_mm;
    }
  }
}

TEST(ReachBound, IsNeverLessThanWhatIsSeenOnAGridInEveryShape) {
  const char* more = std::getenv("GOUGE_REACH_TOOLS");
  const std::uint64_t count = more != nullptr ? std::strtoull(more, nullptr, 10) : 160;
  std::size_t finite = 0, thin = 0;
  for (std::uint64_t seed = 0; seed < count; ++seed) {
    const test::RandomTool random = test::random_tool(seed);
    const CompiledTool tool = compile_tool(random.name, random.profile);
    test::Scatter numbers(seed + 77);
    const double depth = tool.core_depth_mm * std::pow(10.0, numbers.in(-1.6, -0.05));
    const GridReach grid(tool, depth);
    const double enough = numbers.next() % 2 == 0 ? 1.1 * depth : 3 * depth;
    const double bound = reach_at(tool, depth, enough);
    ASSERT_GE(bound, depth) << random.name;
    if (grid.is_empty()) continue;
    const double seen = grid.largest();
    ASSERT_GE(bound, seen - grid.step()) << random.name << " depth " << depth << " size " << tool.r_max_mm << " x "
                                         << tool.z_max_mm;
    if (std::isinf(bound)) continue;
    ++finite;
    if (bound > 3 * depth) ++thin;
  }
  EXPECT_GT(finite, count / 2);
  EXPECT_GT(thin, count / 10);
}

TEST(CertifiedDepth, OfAPointIsTheDepthThatItsAngleLeaves) {
  const CompiledTool tool = tools::variants(tools::assembly(ChamferCutter{1, 0, 2, 0}, 1)).bare;
  const CertifiedDepth sure = find_certified_depth(tool, tool, 0.011);
  const double largest = kReachPerDepth * 0.011 * std::sin(2 * std::numbers::pi / 180);
  EXPECT_LE(sure.depth_mm, largest);
  EXPECT_GT(sure.depth_mm, 0.7 * largest);
  EXPECT_NEAR(sure.reach_mm, 0.011 / std::sin(2 * std::numbers::pi / 180), 0.01);
}

TEST(CertifiedDepth, OfAnOffsetToolIsThatOfItsOffsetVariant) {
  const ToolAssembly saw = tools::assembly(SlittingSawCutter{63, 0.5, 16, 4}, 6);
  const ToolVariants grown = tools::variants(saw, 1);
  EXPECT_EQ(find_certified_depth(grown.against_part, grown.bare, 0.26).halvings, 0);
  EXPECT_GT(find_certified_depth(grown.against_fixture, grown.bare, 0.26).halvings, 0);
}

}  // namespace
}  // namespace gouge::reach_bound_test
