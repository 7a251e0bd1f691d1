#include "lib/tool/inscribed_balls.h"

#include <gtest/gtest.h>

#include "lib/tool/evaluate.h"
#include "tests/support/random_tools.h"
#include "tests/support/tools.h"

namespace gouge::inscribed_balls_test {
namespace {

constexpr double kSlack_mm = 2e-4;

bool is_in(const std::vector<Box2>& zones, const Vec2& q) {
  return std::any_of(zones.begin(), zones.end(), [&](const Box2& zone) { return zone.contains(q); });
}

TEST(InscribedBalls, RollOverABallNoseAndStopAtCorners) {
  const CompiledTool ball = tools::ball(10).bare;
  const std::vector<Box2> of_ball = InscribedBalls(ball, kSlack_mm).sharp_zones(1);
  EXPECT_FALSE(is_in(of_ball, Vec2(0, 0))) << "the tip";
  EXPECT_FALSE(is_in(of_ball, Vec2(5, 6))) << "the side";
  EXPECT_TRUE(is_in(of_ball, Vec2(16, 50))) << "the holder's lower edge";
  const std::vector<Box2> of_bull = InscribedBalls(tools::bull(16, 2).bare, kSlack_mm).sharp_zones(1.9);
  EXPECT_FALSE(is_in(of_bull, Vec2(6 + 2 * std::sqrt(0.5), 2 - 2 * std::sqrt(0.5))));
  const std::vector<Box2> deeper = InscribedBalls(tools::bull(16, 2).bare, kSlack_mm).sharp_zones(2.1);
  EXPECT_TRUE(is_in(deeper, Vec2(6 + 2 * std::sqrt(0.5), 2 - 2 * std::sqrt(0.5)))) << "the corner's radius is 2";
  const std::vector<Box2> of_flat = InscribedBalls(tools::flat(10).bare, kSlack_mm).sharp_zones(0.1);
  EXPECT_TRUE(is_in(of_flat, Vec2(5, 0)));
  EXPECT_FALSE(is_in(of_flat, Vec2(4, 0)));
}

// Outside of the zones a ball as large as requested is in the tool, as near as the slack: looked for by brute force among
// centres along the ray through the point's own foot, where the largest such ball has its centre.
TEST(InscribedBalls, ReachEveryPointOutsideOfTheZones) {
  test::Scatter random(5);
  std::size_t tried = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const test::RandomTool shape = test::random_tool(seed);
    const CompiledTool tool = compile_tool("random", shape.profile);
    if (tool.elements.size() < 2) continue;
    const double depth = random.in(0.005, 0.2) * tool.r_max_mm;
    const std::vector<Box2> zones = InscribedBalls(tool, kSlack_mm).sharp_zones(depth);
    for (int k = 0; k < 400; ++k) {
      const Vec2 q(random.in(0, tool.r_max_mm), random.in(tool.z_min_mm, tool.z_max_mm));
      const ToolDistance at = evaluate(tool, q.x(), q.y());
      if (at.signed_distance_mm >= 0 || -at.signed_distance_mm >= depth || is_in(zones, q)) continue;
      ++tried;
      double best = 1e300;
      for (int n = 1; n <= 400 && best > kSlack_mm; ++n) {
        const double t = depth + (n - 1) * (tool.r_max_mm + depth) / 400;
        const Vec2 centre = at.foot - t * at.normal;
        const double inside = -evaluate(tool, std::abs(centre.x()), centre.y()).signed_distance_mm;
        if (inside >= depth - 1e-9) best = std::min(best, (q - centre).norm() - inside);
      }
      EXPECT_LE(best, 2 * kSlack_mm) << shape.name << " " << q.transpose() << " depth " << depth;
    }
  }
  EXPECT_GT(tried, 500U);
}

}  // namespace
}  // namespace gouge::inscribed_balls_test
