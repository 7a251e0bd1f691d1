#include "toolmodels/unite.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <utility>

#include "lib/tool/evaluate.h"
#include "tests/support/random_tools.h"
#include "tests/toolmodels/sample_tools.h"
#include "toolmodels/compile_tool.h"
#include "toolmodels/elements.h"

namespace gouge::unite_test {
namespace {

using test::Scatter;
using Strings = std::vector<std::string>;

constexpr double kGrowths[3] = {0.3, 0.5, 2};

// Signed distance to the union, from the bodies one by one: exact outside, and inside only as a sign.
double outside_distance(const std::vector<CompiledTool>& bodies, const double (&growths)[3], const Vec2& q) {
  double nearest = 1e300;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (!bodies[i].elements.empty())
      nearest = std::min(nearest, evaluate_brute_force(bodies[i], q.x(), q.y()).signed_distance_mm - growths[i]);
  return nearest;
}

TEST(Unite, IsTheUnionOfTheOffsetBodies) {
  Scatter random(3);
  for (const ToolAssembly& tool : test::sample_tools()) {
    const Result<BodyProfiles> profiles = make_body_profiles(tool);
    ASSERT_TRUE(profiles.has_value());
    std::vector<CompiledTool> bodies;
    std::vector<OffsetBody> grown;
    for (std::size_t i = 0; i < 3; ++i) {
      bodies.push_back(compile_tool("", (*profiles)[i]));
      grown.push_back({&(*profiles)[i], kGrowths[i]});
    }
    const Profile profile = unite(grown).value();
    EXPECT_EQ(verify_profile(profile), Strings{}) << tool.name;
    const CompiledTool whole = compile_tool("", profile);
    const double slack = 1e-9 * whole.z_max_mm;
    for (int k = 0; k < 20000; ++k) {
      const Vec2 q(random.in(0, 1.3 * whole.r_max_mm), random.in(whole.z_min_mm - 5, whole.z_max_mm + 5));
      const double expected = outside_distance(bodies, kGrowths, q);
      const double found = evaluate_brute_force(whole, q.x(), q.y()).signed_distance_mm;
      if (expected > 0)
        EXPECT_NEAR(found, expected, slack) << tool.name << " at " << q.transpose();
      else
        EXPECT_LE(found, slack) << tool.name << " at " << q.transpose();
    }
  }
}

TEST(Unite, WithoutGrowthTheCornersAreTheGivenOnes) {
  const Result<Profile> profile = make_profile(test::assembly("", FlatCutter{10, 30}, {{10, 10, 20}}, {{32, 40, 40}}));
  const std::vector<Vec2> expected{{0, 0}, {5, 0}, {5, 30}, {5, 50}, {16, 50}, {20, 90}, {0, 90}};
  ASSERT_EQ(profile->elements.size(), expected.size() - 1);
  for (std::size_t i = 0; i + 1 < expected.size(); ++i) {
    EXPECT_EQ(profile->elements[i].a, expected[i]) << i;
    EXPECT_EQ(profile->elements[i].b, expected[i + 1]) << i;
  }
  const std::vector<Body> bodies{Body::cutter, Body::cutter, Body::shank, Body::holder, Body::holder, Body::holder};
  for (std::size_t i = 0; i < bodies.size(); ++i) EXPECT_EQ(profile->elements[i].body, bodies[i]) << i;
}

TEST(Unite, SegmentsInOneLineAreOneElement) {
  const Result<Profile> split =
      make_profile(test::assembly("", FlatCutter{10, 30}, {{10, 10, 7}, {10, 10, 13}}, {{20, 30, 10}, {30, 40, 10}}));
  const Result<Profile> whole = make_profile(test::assembly("", FlatCutter{10, 30}, {{10, 10, 20}}, {{20, 40, 20}}));
  EXPECT_EQ(split->elements.size(), whole->elements.size());
}

TEST(Unite, OffsetCylinderIsRoundedAtBothEnds) {
  Profile cylinder;
  cylinder.elements = {make_segment(Body::holder, {0, 10}, {8, 10}), make_segment(Body::holder, {8, 10}, {8, 20}),
                       make_segment(Body::holder, {8, 20}, {0, 20})};
  const Profile grown = unite({{&cylinder, 1.5}}).value();
  ASSERT_EQ(grown.elements.size(), 5u);
  EXPECT_EQ(grown.elements[0].b, Vec2(8, 8.5));
  EXPECT_TRUE(grown.elements[1].is_arc);
  EXPECT_EQ(grown.elements[1].center, Vec2(8, 10));
  EXPECT_EQ(grown.elements[1].radius_mm, 1.5);
  EXPECT_EQ(grown.elements[2].a, Vec2(9.5, 10));
  EXPECT_EQ(grown.elements[2].b, Vec2(9.5, 20));
  EXPECT_EQ(grown.elements[3].b, Vec2(8, 21.5));
}

TEST(Unite, AHolderOffsetOverTheCutterTakesItsPlace) {
  const ToolAssembly tool = test::assembly("", FlatCutter{10, 5}, {}, {{30, 30, 20}});
  const Result<ToolVariants> variants = make_tool_variants(tool, 0, 0, 6);
  EXPECT_EQ(variants->against_part.z_min_mm, -1);
  for (const BoundaryElement& e : variants->against_part.elements) EXPECT_EQ(e.body, Body::holder);
  EXPECT_EQ(variants->bare.z_min_mm, 0);
}

TEST(Unite, ConcaveFilletShrinksByTheGrowthAndThenVanishes) {
  // Radius 4 below, radius 10 above, a fillet of radius 3 between.
  Profile body;
  body.elements = {make_segment(Body::shank, {0, 0}, {4, 0}),
                   make_segment(Body::shank, {4, 0}, {4, 7}),
                   make_concave_arc(Body::shank, {4, 7}, {7, 10}, {7, 7}, 3),
                   make_segment(Body::shank, {7, 10}, {10, 10}),
                   make_segment(Body::shank, {10, 10}, {10, 20}),
                   make_segment(Body::shank, {10, 20}, {0, 20})};
  ASSERT_EQ(verify_profile(body), Strings{});
  const CompiledTool bare = compile_tool("", body);
  Scatter random(5);
  for (const double growth : {1.0, 2.9, 3.0, 3.5}) {
    const Profile grown = unite({{&body, growth}}).value();
    EXPECT_EQ(verify_profile(grown), Strings{}) << growth;
    const CompiledTool tool = compile_tool("", grown);
    for (int k = 0; k < 5000; ++k) {
      const Vec2 q(random.in(0, 16), random.in(-5, 25));
      const double expected = evaluate_brute_force(bare, q.x(), q.y()).signed_distance_mm - growth;
      if (expected < 1e-9) continue;
      EXPECT_NEAR(evaluate(tool, q.x(), q.y()).signed_distance_mm, expected, 1e-9) << growth << " " << q.transpose();
    }
  }
}

// Cells of a grid that a point can reach from outside the offset bodies without coming nearer than `margin`.
class Outside {
 public:
  Outside(const CompiledTool& body, double growth, double margin) : low_(0, body.z_min_mm - growth - 1) {
    step_ = (Vec2(body.r_max_mm + growth + 1, body.z_max_mm + growth + 1) - low_) / kCells;
    for (int i = 0; i <= kCells; ++i)
      for (int k = 0; k <= kCells; ++k) {
        const Vec2 q = at(i, k);
        is_free_[i][k] = evaluate_brute_force(body, q.x(), q.y()).signed_distance_mm > growth + margin;
      }
    reach(kCells, 0);
  }
  [[nodiscard]] Vec2 at(int i, int k) const { return low_ + Vec2(i * step_.x(), k * step_.y()); }
  [[nodiscard]] bool is_reached(int i, int k) const { return is_reached_[i][k]; }
  static constexpr int kCells = 60;

 private:
  void reach(int i0, int k0) {
    std::vector<std::pair<int, int>> open{{i0, k0}};
    while (!open.empty()) {
      const auto [i, k] = open.back();
      open.pop_back();
      if (i < 0 || k < 0 || i > kCells || k > kCells || is_reached_[i][k] || !is_free_[i][k]) continue;
      is_reached_[i][k] = true;
      for (const auto& [di, dk] : {std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)})
        open.emplace_back(i + di, k + dk);
    }
  }
  Vec2 low_, step_;
  bool is_free_[kCells + 1][kCells + 1] = {}, is_reached_[kCells + 1][kCells + 1] = {};
};

// Undercuts, hollow bottoms, concave arcs, slots that close: nothing is lost, nothing outside is filled.
TEST(Unite, GrowsProfilesOfAnyFormAsTheDistanceSays) {
  const char* count = std::getenv("GOUGE_UNITE_TOOLS");
  const std::uint64_t tools = count == nullptr ? 60 : std::strtoull(count, nullptr, 10);
  for (std::uint64_t seed = 0; seed < tools; ++seed) {
    Scatter random(seed);
    const Profile body =
        test::random_free_profile(random, {true, true, seed % 2 == 0, seed % 5 == 0, seed % 3 == 0 ? 1e-3 : 0.05});
    const double size = size_of(body);
    const double growth = seed % 7 == 0 ? 1.0 : size * std::pow(10.0, random.in(-5, 0));
    const Result<Profile> grown = unite({{&body, growth}});
    ASSERT_TRUE(grown.has_value()) << seed;
    ASSERT_EQ(verify_profile(*grown), Strings{}) << seed;
    CompiledTool bare, whole;
    bare = compile_tool("", body);
    whole.elements = make_elements(*grown);
    const double slack = 1e-8 * (size + growth);
    for (int k = 0; k < 2000; ++k) {
      const Vec2 q(random.in(0, size + growth), random.in(-size - growth, size + growth));
      const double expected = evaluate_brute_force(bare, q.x(), q.y()).signed_distance_mm - growth;
      const double found = evaluate_brute_force(whole, q.x(), q.y()).signed_distance_mm;
      ASSERT_LE(found, std::max(expected, 0.0) + slack) << seed << " at " << q.transpose();
      if (found > 0) {
        ASSERT_NEAR(found, expected, slack) << seed << " at " << q.transpose();
      }
    }
    const Outside surely(bare, growth, 0.025 * (size + growth));
    for (int i = 0; i <= Outside::kCells; ++i)
      for (int k = 0; k <= Outside::kCells; ++k)
        if (surely.is_reached(i, k)) {
          const Vec2 q = surely.at(i, k);
          ASSERT_GT(evaluate_brute_force(whole, q.x(), q.y()).signed_distance_mm, 0)
              << seed << " growth " << growth << " at " << q.transpose();
        }
  }
}

TEST(ToolVariants, OnlyBodiesWithAClearanceAreInTheFormOfTheirOwn) {
  const ToolAssembly tool = test::assembly("", FlatCutter{10, 30}, {{12, 12, 20}}, {{32, 32, 40}});
  const Result<ToolVariants> none = make_tool_variants(tool, 0.5, 0, 0);
  EXPECT_TRUE(none->with_clearance.elements.empty());
  EXPECT_EQ(none->against_part.z_min_mm, -0.5);
  EXPECT_EQ(none->against_fixture.z_min_mm, 0) << "stock to leave is against the part alone";
  const Result<ToolVariants> holder = make_tool_variants(tool, 0, 0, 2);
  EXPECT_EQ(holder->with_clearance.z_min_mm, 48);
  EXPECT_EQ(holder->with_clearance.r_max_mm, 18);
  EXPECT_EQ(holder->non_cutting.z_min_mm, 30) << "the shank stays as it is";
  const Result<ToolVariants> bare = make_tool_variants(test::assembly("", FlatCutter{10, 30}), 0, 1, 1);
  EXPECT_TRUE(bare->with_clearance.elements.empty()) << "there is nothing to grow";
  EXPECT_TRUE(bare->non_cutting.elements.empty());
}

TEST(ToolVariants, TheCoreIsTheDeepestPointOfTheCutterOnTheAxis) {
  const Result<ToolVariants> variants =
      make_tool_variants(test::assembly("", FlatCutter{10, 30}, {{20, 20, 40}}), 0, 0, 0);
  EXPECT_EQ(variants->bare.core.x(), 0);
  EXPECT_LE(variants->bare.core.y(), 30);
  EXPECT_GE(variants->bare.core_depth_mm, 5);
}

}  // namespace
}  // namespace gouge::unite_test
