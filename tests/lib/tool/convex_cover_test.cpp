// What the cover says of a point is held against the tool itself.
#include "lib/tool/convex_cover.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "lib/tool/evaluate.h"
#include "tests/support/tools.h"

namespace gouge {
namespace {

double signed_distance(const CompiledTool& tool, const Vec2& q) {
  return evaluate(tool, q.x(), q.y()).signed_distance_mm;
}

/// How many of the four claims spoke, so that a cover that never claims anything is seen.
struct Claims {
  std::size_t feet = 0, ends = 0, outside = 0, distance = 0;
};

void expect_claims_hold(const CompiledTool& tool, std::mt19937_64& random, int points, Claims& claims) {
  const ConvexCover cover = make_convex_cover(tool);
  ASSERT_FALSE(cover.pieces.empty());
  EXPECT_DOUBLE_EQ(cover.pieces.front().z_lo_mm, tool.z_min_mm);
  EXPECT_DOUBLE_EQ(cover.pieces.back().z_hi_mm, tool.z_max_mm);
  const auto in = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
  for (int i = 0; i < points; ++i) {
    const Vec2 q(in(0, 1.2 * tool.r_max_mm), in(tool.z_min_mm - 5, tool.z_max_mm + 5));
    const double depth = -signed_distance(tool, q);
    double nearest = 1e300;
    for (const CoverPiece& piece : cover.pieces) {
      const double f = cover_distance(piece, q);
      nearest = std::min(nearest, std::max({f, piece.z_lo_mm - q.y(), q.y() - piece.z_hi_mm}));
      if (q.y() < piece.z_lo_mm || q.y() > piece.z_hi_mm) continue;
      const auto where = [&] { return ::testing::Message() << tool.name << " at " << q.x() << ", " << q.y(); };
      if (f >= 0) {
        ++claims.outside;
        ASSERT_LE(depth, 1e-9) << where();
      } else if ((q.y() + f > piece.foot_lo_mm || q.x() >= piece.r_closed_mm) && q.y() - f < piece.foot_hi_mm) {
        ++claims.feet;
        ASSERT_LE(depth, -f + 1e-9) << where();
      }
      const bool has_below = q.x() >= piece.r_below_mm, has_above = q.x() >= piece.r_above_mm;
      ASSERT_LE(depth, (has_below ? q.y() - piece.z_lo_mm : 1e300) + 1e-9) << where();
      ASSERT_LE(depth, (has_above ? piece.z_hi_mm - q.y() : 1e300) + 1e-9) << where();
      if (has_below || has_above) ++claims.ends;
    }
    if (nearest > 0) {
      ++claims.distance;
      ASSERT_LE(nearest, -depth + 1e-9) << tool.name << " at " << q.x() << ", " << q.y();
    }
  }
}

TEST(ConvexCover, NeverSaysLessThanTheTool) {
  std::mt19937_64 random(5);
  Claims claims;
  for (const ToolForms& forms : tools::all()) {
    for (const CompiledTool* tool : {&forms.bare, &forms.against_part, &forms.with_clearance, &forms.non_cutting}) {
      if (!tool->elements.empty()) expect_claims_hold(*tool, random, 4000, claims);
    }
  }
  EXPECT_GT(claims.feet, 10000U);
  EXPECT_GT(claims.ends, 10000U);
  EXPECT_GT(claims.outside, 10000U);
  EXPECT_GT(claims.distance, 10000U);
}

TEST(ConvexCover, TheCutterOfABallIsExact) {
  const ToolForms ball = tools::ball();
  const CoverPiece piece = make_convex_cover(ball.bare).pieces.front();
  for (const double angle : {0.1, 0.7, 1.4}) {
    for (const double off : {-1.0, 0.3}) {
      const Vec2 q((5 + off) * std::sin(angle), 5 - (5 + off) * std::cos(angle));
      EXPECT_NEAR(cover_distance(piece, q), signed_distance(ball.bare, q), 1e-8);
    }
  }
}

}  // namespace
}  // namespace gouge
