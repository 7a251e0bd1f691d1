#include "toolmodels/tilt_sweep.h"

#include <gtest/gtest.h>

#include <cmath>

#include "lib/tool/evaluate.h"
#include "tests/support/random_tools.h"
#include "tests/toolmodels/sample_tools.h"
#include "toolmodels/assembly.h"
#include "toolmodels/compile_tool.h"

namespace gouge::tilt_sweep_test {
namespace {

using test::Scatter;
using Strings = std::vector<std::string>;

double distance_to(const CompiledTool& tool, const Vec2& q) {
  return evaluate_brute_force(tool, std::abs(q.x()), q.y()).signed_distance_mm;
}

/// Returns the least signed distance of the point from the body over many tilts.
double least_over_tilts(const CompiledTool& body, const Vec2& q, double max_tilt_rad, int steps) {
  double least = 1e300;
  for (int k = -steps; k <= steps; ++k) {
    const double angle = max_tilt_rad * k / steps, c = std::cos(angle), s = std::sin(angle);
    least = std::min(least, distance_to(body, {q.x() * c + q.y() * s, q.y() * c - q.x() * s}));
  }
  return least;
}

void expect_union(const Profile& body, double max_tilt_rad, const std::string& name, Scatter& random) {
  const Result<Profile> swept = sweep_tilts(body, max_tilt_rad);
  ASSERT_TRUE(swept.has_value()) << name << " " << max_tilt_rad << ": " << swept.error().message;
  EXPECT_EQ(verify_profile(*swept), Strings{}) << name;
  const CompiledTool bare = compile_tool("", body), whole = compile_tool("", *swept);
  const double reach = whole.z_max_mm + whole.r_max_mm;
  constexpr int kSteps = 40;
  const double step_mm = max_tilt_rad * reach / kSteps;  // no point moves farther from one tilt to the next
  for (int k = 0; k < 300; ++k) {
    const Vec2 q(random.in(0, 1.3 * whole.r_max_mm), random.in(whole.z_min_mm - 2, whole.z_max_mm + 2));
    const double tilted = least_over_tilts(bare, q, max_tilt_rad, kSteps), found = distance_to(whole, q);
    const double rounding = 1e-9 * reach;
    const bool is_below = q.y() < body.elements.front().a.y();  // where a hollow is filled
    if (is_below && q.x() < whole.r_max_mm) continue;
    if (tilted < -rounding) {
      EXPECT_LT(found, rounding) << name << " misses " << q.transpose();
    } else if (tilted > step_mm) {
      // Outside, the distance from the union is that from the nearest tilt.
      EXPECT_LE(found, tilted + rounding) << name << " at " << q.transpose();
      EXPECT_GE(found, tilted - step_mm - rounding) << name << " at " << q.transpose();
    }
  }
}

TEST(SweepTilts, IsTheUnionOfTheTiltedBodies) {
  Scatter random(11);
  for (const ToolAssembly& tool : test::sample_tools()) {
    const Result<BodyProfiles> bodies = make_body_profiles(tool);
    ASSERT_TRUE(bodies.has_value());
    for (const Profile& body : *bodies) {
      if (body.elements.empty()) continue;
      for (const double degrees : {0.01, 0.5, 3.0, 20.0})
        expect_union(body, degrees * 3.14159 / 180, tool.name, random);
    }
  }
}

TEST(SweepTilts, ACylinderGetsArcsAboutTheTip) {
  Profile cylinder;
  cylinder.elements = {make_segment(Body::holder, {0, 30}, {40, 30}), make_segment(Body::holder, {40, 30}, {40, 60}),
                       make_segment(Body::holder, {40, 60}, {0, 60})};
  const double tilt = 0.1;
  const Profile swept = sweep_tilts(cylinder, tilt).value();
  // The underside is level with the rim that turned down. The wall, the upper corner's arc and the upper face follow.
  ASSERT_GE(swept.elements.size(), 4U);
  const double rim = 30 * std::cos(tilt) - 40 * std::sin(tilt);
  EXPECT_NEAR(swept.elements.front().a.y(), rim, 1e-9);
  EXPECT_NEAR(swept.elements.front().b.x(), 40 * std::cos(tilt) + 30 * std::sin(tilt), 1e-9);
  EXPECT_NEAR(swept.elements.back().b.y(), 60 / std::cos(tilt), 1e-9);
  double r_max = 0;
  for (const ProfileElement& e : swept.elements) r_max = std::max(r_max, e.b.x());
  EXPECT_NEAR(r_max, 40 * std::cos(tilt) + 60 * std::sin(tilt), 1e-9);
}

TEST(SweepTilts, NoTiltReturnsTheBody) {
  Profile cylinder;
  cylinder.elements = {make_segment(Body::holder, {0, 30}, {40, 30}), make_segment(Body::holder, {40, 30}, {40, 60}),
                       make_segment(Body::holder, {40, 60}, {0, 60})};
  EXPECT_EQ(sweep_tilts(cylinder, 0)->elements.size(), 3U);
  EXPECT_TRUE(sweep_tilts({}, 0.1)->elements.empty());
}

}  // namespace
}  // namespace gouge::tilt_sweep_test
