// Compares the bounds of the cover with the tool itself.
#include "lib/tool/convex_cover.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "lib/tool/evaluate.h"
#include "tests/support/drawn_cutters.h"
#include "tests/support/random_tools.h"
#include "tests/support/scatter.h"
#include "tests/support/tool_points.h"
#include "tests/support/tools.h"
#include "tests/toolmodels/sample_tools.h"
#include "toolmodels/compile_tool.h"

namespace gouge::convex_cover_test {
namespace {

double signed_distance(const CompiledTool& tool, const Vec2& q) {
  return evaluate(tool, q.x(), q.y()).signed_distance_mm;
}

/// How many of the four claims spoke, so that a cover that never claims anything is seen.
struct Claims {
  std::size_t feet = 0, ends = 0, outside = 0, distance = 0;
};

void expect_claims_hold(const CompiledTool& tool, test::Scatter& random, int points, Claims& claims) {
  const ConvexCover cover = make_convex_cover(tool);
  test::Scatter places(random.next());
  ASSERT_FALSE(cover.pieces.empty());
  EXPECT_NEAR(cover.pieces.front().z_lo_mm, tool.z_min_mm, 1e-12 * cover.size_mm);
  EXPECT_NEAR(cover.pieces.back().z_hi_mm, tool.z_max_mm, 1e-12 * cover.size_mm);
  for (int i = 0; i < points; ++i) {
    const Vec2 around(random.in(0, 1.2 * tool.r_max_mm), random.in(tool.z_min_mm - 5, tool.z_max_mm + 5));
    const Vec2 q = i % 2 == 0 ? around : test::random_tool_point(places, tool);
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
  test::Scatter random(5);
  Claims claims;
  for (const ToolVariants& variants : tools::all()) {
    for (const CompiledTool* tool :
         {&variants.bare, &variants.against_part, &variants.with_clearance, &variants.non_cutting}) {
      if (!tool->elements.empty()) expect_claims_hold(*tool, random, 4000, claims);
    }
  }
  EXPECT_GT(claims.feet, 10000U);
  EXPECT_GT(claims.ends, 10000U);
  EXPECT_GT(claims.outside, 10000U);
  EXPECT_GT(claims.distance, 10000U);
}

// Swept over tilts, every step of a tool leans over itself by little.
TEST(ConvexCover, NeverSaysLessThanAToolSweptOverTilts) {
  test::Scatter random(8);
  Claims claims;
  for (const ToolAssembly& assembly : test::sample_tools()) {
    for (const MotionTube& tube : {MotionTube{0, 0.001}, MotionTube{0.02, 0.01}, MotionTube{0, 0.1}}) {
      const Result<ToolVariants> made = make_tool_variants(assembly, 0, 0.3, 0.5, false, tube);
      ASSERT_TRUE(made.has_value()) << assembly.name;
      for (const CompiledTool* tool : {&made->bare, &made->against_part, &made->non_cutting}) {
        if (!tool->elements.empty()) expect_claims_hold(*tool, random, 2000, claims);
      }
    }
  }
  EXPECT_GT(claims.feet, 10000U);
}

// GOUGE_COVER_TOOLS makes it longer.
TEST(ConvexCover, NeverSaysLessThanAnyToolThereIs) {
  const char* wanted = std::getenv("GOUGE_COVER_TOOLS");
  const std::uint64_t count = wanted != nullptr ? std::strtoull(wanted, nullptr, 10) : 400;
  Claims claims;
  for (const ToolVariants& variants : tools::shapes()) {
    test::Scatter random(6);
    for (const CompiledTool* tool :
         {&variants.bare, &variants.against_part, &variants.with_clearance, &variants.non_cutting}) {
      if (!tool->elements.empty()) expect_claims_hold(*tool, random, 1000, claims);
    }
  }
  for (std::uint64_t seed = 0; seed < count; ++seed) {
    const test::RandomTool made = test::random_tool(seed);
    test::Scatter random(seed);
    expect_claims_hold(compile_tool(made.name, made.profile), random, 300, claims);
  }
  EXPECT_GT(claims.feet, 10 * count);
  EXPECT_GT(claims.ends, 10 * count);
  EXPECT_GT(claims.outside, 10 * count);
  EXPECT_GT(claims.distance, 10 * count);
}

// Arcs of 150 degrees and more are halved: their centre comes twice.
TEST(ConvexCover, EveryLineOfAChainHasADirectionAndTurnsLeft) {
  std::vector<CompiledTool> all;
  for (const ToolVariants& variants : tools::shapes()) all.push_back(variants.bare);
  for (std::uint64_t seed = 0; seed < 400; ++seed) all.push_back(compile_tool("", test::random_tool(seed).profile));
  for (const CompiledTool& tool : all) {
    for (const CoverPiece& piece : make_convex_cover(tool).pieces) {
      Vec2 last = Vec2::Zero();
      for (std::size_t k = 0; k + 1 < piece.chain.size(); ++k) {
        const Vec2 axis = (piece.chain[k + 1] - piece.chain[k]).normalized();
        ASSERT_NEAR(axis.norm(), 1, 1e-9) << tool.name;
        ASSERT_GE(axis.y(), -1e-7) << tool.name;
        ASSERT_GE(last.x() * axis.y() - last.y() * axis.x(), -1e-8) << tool.name;
        last = axis;
      }
    }
  }
}

TEST(ConvexCover, TheCutterOfABallIsExact) {
  const ToolVariants ball = tools::ball();
  const CoverPiece piece = make_convex_cover(ball.bare).pieces.front();
  for (const double angle : {0.1, 0.7, 1.4}) {
    for (const double off : {-1.0, 0.3}) {
      const Vec2 q((5 + off) * std::sin(angle), 5 - (5 + off) * std::cos(angle));
      EXPECT_NEAR(cover_distance(piece, q), signed_distance(ball.bare, q), 1e-8);
    }
  }
}

// With many points the cover follows chords.
TEST(ConvexCover, HoldsForCuttersOfManyPointsInFewPieces) {
  test::Scatter random(21);
  Claims claims;
  for (const std::size_t count : {40u, 200u, 2000u}) {
    for (const test::Drawn& drawn : test::drawn_cutters(count)) {
      const CompiledTool tool = compile_tool(drawn.name, test::profile_of(drawn));
      expect_claims_hold(tool, random, 3'000, claims);
      EXPECT_LE(make_convex_cover(tool).pieces.size(), 600u) << drawn.name;
    }
  }
  EXPECT_GT(std::min({claims.feet, claims.ends, claims.outside, claims.distance}), 1000u);
}

}  // namespace
}  // namespace gouge::convex_cover_test
