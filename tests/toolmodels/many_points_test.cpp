#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "lib/tool/evaluate.h"
#include "lib/tool/reach_bound.h"
#include "tests/support/drawn_cutters.h"
#include "tests/support/random_tools.h"
#include "tests/support/tool_points.h"
#include "tests/support/verify_tool.h"
#include "toolmodels/bsp.h"
#include "toolmodels/compile_tool.h"
#include "toolmodels/elements.h"
#include "toolmodels/trace_regions.h"

// Cutters of many points: traced ones, and ones of many teeth. What they take grows with their points, and what they
// result is what every element together results.

namespace gouge::many_points_test {
namespace {

using test::Drawn;
using test::profile_of;
using test::random_teeth;
using test::scalloped;
using test::Scatter;
using test::toothed;
using test::traced;

void expect_brute_force(const CompiledTool& tool, int points) {
  Scatter random(11);
  double worst = 0, worst_element = 0;
  for (int i = 0; i < points; ++i) {
    const Vec2 q = test::random_tool_point(random, tool);
    const ToolDistance fast = evaluate(tool, q.x(), q.y());
    const double slow = evaluate_brute_force(tool, q.x(), q.y()).signed_distance_mm;
    const double scale = test::extent_mm(tool) + q.norm();
    worst = std::max(worst, std::abs(fast.signed_distance_mm - slow) / scale);
    worst_element = std::max(worst_element, (distance_to(tool.elements[fast.element], q) - std::abs(slow)) / scale);
  }
  EXPECT_LE(worst, 1e-12) << tool.name;
  EXPECT_LE(worst_element, 1e-12) << tool.name;
}

class ManyPoints : public testing::TestWithParam<std::size_t> {};

INSTANTIATE_TEST_SUITE_P(Counts, ManyPoints, testing::Values(20, 39, 51, 200, 2000));

TEST_P(ManyPoints, TreesAreNoLargerThanAFewTimesTheContour) {
  for (const Drawn& drawn : test::drawn_cutters(GetParam())) {
    const CompiledTool tool = compile_tool(drawn.name, profile_of(drawn));
    EXPECT_LE(tool.nodes.size(), (kMaxBspNodes + 1) * tool.elements.size()) << drawn.name;
    EXPECT_LE(tool.stretches.size(), tool.elements.size()) << drawn.name;
    EXPECT_EQ(test::verify_tool(tool), std::vector<std::string>{}) << drawn.name;
  }
}

TEST_P(ManyPoints, DistancesAreThoseOfAllElements) {
  const int points = GetParam() > 1000 ? 4'000 : 20'000;
  for (const Drawn& drawn : test::drawn_cutters(GetParam()))
    expect_brute_force(compile_tool(drawn.name, profile_of(drawn)), points);
}

TEST_P(ManyPoints, GrownVariantsAreDistancesOfTheBareOneLessTheGrowth) {
  if (GetParam() > 200) return;
  const double growth = 0.25;
  for (const Drawn& drawn : test::drawn_cutters(GetParam())) {
    const Result<ToolVariants> variants =
        make_tool_variants({1, drawn.name, ProfileCutter{drawn.points}, {}, {}}, growth, 0, 0);
    ASSERT_TRUE(variants.has_value()) << drawn.name;
    expect_brute_force(variants->against_part, 5'000);
    // Outside of both, a point as far from the grown tool as from the bare one less the growth.
    Scatter random(13);
    for (int i = 0; i < 5'000; ++i) {
      const Vec2 q = test::random_tool_point(random, variants->bare);
      const double bare = evaluate(variants->bare, q.x(), q.y()).signed_distance_mm;
      const double grown = evaluate(variants->against_part, q.x(), q.y()).signed_distance_mm;
      if (!(grown > 0)) continue;
      EXPECT_NEAR(grown, bare - growth, 1e-8 * (test::extent_mm(variants->bare) + q.norm())) << drawn.name;
    }
  }
}

// A tangent plane's range ends where the contour first comes before it: by examining all of it.
TEST(ManyPointsSupport, RangesAreThoseOfALookAtEveryElement) {
  for (const Drawn& drawn : {traced(400, 0), toothed("rougher", 400, 4.4, 5, 0.75), random_teeth(400)}) {
    const Profile profile = profile_of(drawn);
    std::vector<BoundaryElement> elements = make_elements(profile);
    set_support_ranges(profile, elements);
    for (std::size_t i = 0; i < elements.size(); ++i) {
      const BoundaryElement& e = elements[i];
      if (e.kind != ElementKind::segment || e.normal.x() < 1e-6) continue;
      const auto is_ahead = [&](const Vec2& p) { return e.normal.dot(p - e.a) > 1e-12 * size_of(profile); };
      std::size_t first = i, last = i;
      while (first > 0 && !is_ahead(elements[first - 1].a)) --first;
      while (last + 1 < elements.size() && !is_ahead(elements[last + 1].b)) ++last;
      // Within the first element that is not all behind: where it crosses the plane.
      const auto crossing = [&](const Vec2& behind, const Vec2& ahead) {
        const double from = std::min(0.0, e.normal.dot(behind - e.a)), to = e.normal.dot(ahead - e.a);
        return behind.y() + from / (from - to) * (ahead.y() - behind.y());
      };
      const double low = first == 0 ? -1e300 : crossing(elements[first - 1].b, elements[first - 1].a);
      const double high = last + 1 == elements.size() ? 1e300 : crossing(elements[last + 1].a, elements[last + 1].b);
      EXPECT_NEAR(e.support.z_lo_mm, low, 1e-7) << drawn.name << " " << i;
      EXPECT_NEAR(e.support.z_hi_mm, high, 1e-7) << drawn.name << " " << i;
    }
  }
}

TEST(ContourTree, BoxesHoldTheirElements) {
  for (const Drawn& drawn : {traced(200, 0.003), scalloped(60), toothed("zigzag", 51, 3, 8, 0.3)}) {
    const std::vector<BoundaryElement> elements = make_elements(profile_of(drawn));
    const std::vector<ContourStretch> tree = make_contour_tree(elements);
    for (const ContourStretch& stretch : tree)
      for (std::size_t k = stretch.first; k < stretch.last; ++k) {
        const BoundaryElement& e = elements[k];
        std::vector<Vec2> points{e.a, e.b};
        if (e.kind == ElementKind::arc) points.emplace_back(e.center + e.radius_mm * e.normal);
        for (const Vec2& p : points) {
          const Vec2 away = p - stretch.origin;
          const Vec2 place(stretch.along.dot(away), stretch.along.x() * away.y() - stretch.along.y() * away.x());
          EXPECT_TRUE((place.array() >= stretch.low.array() - 1e-12).all() &&
                      (place.array() <= stretch.high.array() + 1e-12).all())
              << drawn.name;
        }
      }
  }
}

// On tools that have a BSP the tree of stretches states the same.
TEST(ContourTree, AgreesWithTheBspOnOrdinaryTools) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const test::RandomTool made = test::random_tool(seed);
    const CompiledTool tool = compile_tool(made.name, made.profile);
    CompiledTool other = tool;
    other.nodes.clear();
    other.stretches = make_contour_tree(tool.elements);
    Scatter random(seed);
    for (int i = 0; i < 2'000; ++i) {
      const Vec2 q = test::random_tool_point(random, tool);
      EXPECT_NEAR(evaluate(tool, q.x(), q.y()).signed_distance_mm, evaluate(other, q.x(), q.y()).signed_distance_mm,
                  1e-12 * (test::extent_mm(tool) + q.norm()))
          << made.name << " at " << q.transpose();
    }
  }
}

// A thousand teeth: the search for a reach ends, with a bound that may be larger than the truth.
TEST(ManyPointsReach, IsBoundedForATraceAndEndsForAThousandTeeth) {
  const CompiledTool smooth = compile_tool("traced", profile_of(traced(2000, 0)));
  EXPECT_LE(bound_reach(smooth, smooth, 0.01, 0.03), 0.03);
  const CompiledTool rough = compile_tool("zigzag", profile_of(toothed("zigzag", 2000, 3, 8, 0.3)));
  EXPECT_GE(bound_reach(rough, rough, 0.01, 0.03), 0.01);
}

// A million pairs cross, a hundred are named.
TEST(ManyPointsRefused, AContourThatCrossesItselfEverywhereIsAnError) {
  std::vector<ProfilePoint> points{test::at(0, 0)};
  for (int i = 0; i < 2000; ++i) points.push_back(test::at(i % 2 == 0 ? 8 : 3, 10 + 5 * std::sin(0.7 * i)));
  points.push_back(test::at(0, 30));
  EXPECT_EQ(make_cutter_profile(ProfileCutter{points}).error().code, "tool-profile-broken");
}

}  // namespace
}  // namespace gouge::many_points_test
