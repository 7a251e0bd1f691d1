#include "toolmodels/bsp.h"
#include "tests/support/verify_tool.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lib/tool/evaluate.h"
#include "tests/toolmodels/sample_tools.h"
#include "toolmodels/compile_tool.h"

namespace gouge::bsp_test {
namespace {

using test::Scatter;

double extent(const CompiledTool& tool) { return std::max({tool.r_max_mm, tool.z_max_mm, -tool.z_min_mm}); }

std::vector<CompiledTool> variants_of(const ToolAssembly& tool) {
  std::vector<CompiledTool> all;
  const Result<ToolVariants> variants = make_tool_variants(tool, 0.3, 0.5, 2);
  EXPECT_TRUE(variants.has_value());
  for (const CompiledTool* form : {&variants->bare, &variants->against_part, &variants->against_fixture,
                                   &variants->with_clearance, &variants->non_cutting})
    if (!form->elements.empty()) all.push_back(*form);
  return all;
}

// Around the tool, far away, on the axis, and at every scale about the boundary and its corners.
Vec2 random_point(Scatter& random, const CompiledTool& tool, std::size_t i) {
  const double size = extent(tool);
  if (i % 16 == 0) return {0, random.in(tool.z_min_mm - size, tool.z_max_mm + size)};
  if (i % 16 == 1) return {random.in(0, 50 * size), random.in(-50 * size, 50 * size)};
  if (i % 4 == 2) {
    const BoundaryElement& e = tool.elements[random.next() % tool.elements.size()];
    const double spread = size * std::pow(10.0, random.in(-12, -1));
    const double t = std::min(1.0, std::max(0.0, random.in(-0.5, 1.5)));
    const Vec2 p = e.a + t * (e.b - e.a);
    return {std::abs(p.x() + random.in(-spread, spread)), p.y() + random.in(-spread, spread)};
  }
  return {random.in(0, 1.5 * tool.r_max_mm), random.in(tool.z_min_mm - 0.3 * size, tool.z_max_mm + 0.3 * size)};
}

void expect_brute_force(const CompiledTool& tool, std::size_t points, std::uint64_t seed) {
  Scatter random(seed);
  double worst = 0;
  Vec2 where = Vec2::Zero();
  for (std::size_t i = 0; i < points; ++i) {
    const Vec2 q = random_point(random, tool, i);
    const double fast = signed_distance_mm(tool, q.x(), q.y());
    const double slow = evaluate_brute_force(tool, q.x(), q.y()).signed_distance_mm;
    const double error = std::abs(fast - slow) / (extent(tool) + q.norm());
    if (error <= worst) continue;
    worst = error;
    where = q;
  }
  EXPECT_LE(worst, 1e-12) << tool.name << " at " << where.transpose();
}

class BspOfSample : public testing::TestWithParam<std::size_t> {
 protected:
  ToolAssembly tool() const { return test::sample_tools()[GetParam()]; }
};

INSTANTIATE_TEST_SUITE_P(Tools, BspOfSample, testing::Range<std::size_t>(0, 12));

TEST(Bsp, EverySampleToolIsTested) { EXPECT_EQ(test::sample_tools().size(), 12u); }

TEST_P(BspOfSample, GivesTheDistanceOfTheBruteForceOnAMillionPoints) {
  expect_brute_force(variants_of(tool()).front(), 1'000'000, 1);
}

TEST_P(BspOfSample, GivesTheDistanceOfTheBruteForceForOffsetVariantToo) {
  for (const CompiledTool& form : variants_of(tool())) expect_brute_force(form, 200'000, 2);
}

TEST_P(BspOfSample, ToolIsSound) {
  for (const CompiledTool& form : variants_of(tool())) EXPECT_EQ(test::verify_tool(form), std::vector<std::string>{});
}

// Nearest of a dense set of boundary points: independent of every formula of the elements.
TEST_P(BspOfSample, BruteForceAgreesWithASampledBoundary) {
  const Result<Profile> profile = make_profile(tool());
  const CompiledTool compiled = compile_tool("", *profile);
  std::vector<Vec2> boundary;
  for (const ProfileElement& e : profile->elements) {
    const std::vector<Vec2> coarse = sample(e, 200);
    for (std::size_t k = 0; k + 1 < coarse.size(); ++k)
      for (int i = 0; i <= (e.is_arc ? 10 : 2000); ++i)
        boundary.emplace_back(coarse[k] + (e.is_arc ? i / 10.0 : i / 2000.0) * (coarse[k + 1] - coarse[k]));
  }
  Scatter random(4);
  const double size = extent(compiled);
  for (int k = 0; k < 200; ++k) {
    const Vec2 q(random.in(0, 1.5 * compiled.r_max_mm), random.in(-0.3 * size, 1.3 * size));
    double nearest = 1e300;
    for (const Vec2& p : boundary) nearest = std::min(nearest, (p - q).norm());
    const double found = std::abs(evaluate_brute_force(compiled, q.x(), q.y()).signed_distance_mm);
    EXPECT_NEAR(found, nearest, 1e-3 * size) << q.transpose();
    EXPECT_LE(found, nearest + 1e-4) << q.transpose();
  }
}

// The crossing number of a ray to the right decides the side.
TEST_P(BspOfSample, SignAgreesWithAPolygonTest) {
  const Result<Profile> profile = make_profile(tool());
  const CompiledTool compiled = compile_tool("", *profile);
  std::vector<Vec2> outline;
  for (const ProfileElement& e : profile->elements)
    for (const Vec2& p : sample(e, 2000)) outline.push_back(p);
  Scatter random(5);
  for (int k = 0; k < 500; ++k) {
    const Vec2 q(random.in(0, 1.2 * compiled.r_max_mm), random.in(-1, compiled.z_max_mm + 1));
    bool is_inside = false;
    for (std::size_t i = 0; i + 1 < outline.size(); ++i) {
      const Vec2 &a = outline[i], &b = outline[i + 1];
      if ((a.y() > q.y()) == (b.y() > q.y())) continue;
      if (a.x() + (q.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()) > q.x()) is_inside = !is_inside;
    }
    const double found = evaluate(compiled, q.x(), q.y()).signed_distance_mm;
    if (std::abs(found) > 1e-3) {
      EXPECT_EQ(found < 0, is_inside) << q.transpose();
    }
  }
}

TEST_P(BspOfSample, DistanceIsOneLipschitzAcrossEveryBisector) {
  Scatter random(6);
  for (const CompiledTool& form : variants_of(tool())) {
    for (std::size_t i = 0; i < 100'000; ++i) {
      const Vec2 p = random_point(random, form, i);
      const double step = extent(form) * std::pow(10.0, random.in(-13, 0));
      Vec2 q = p + step * Vec2(random.in(-1, 1), random.in(-1, 1));
      q.x() = std::abs(q.x());
      const double change =
          std::abs(evaluate(form, p.x(), p.y()).signed_distance_mm - evaluate(form, q.x(), q.y()).signed_distance_mm);
      ASSERT_LE(change, (p - q).norm() + 1e-13 * (extent(form) + p.norm())) << p.transpose() << " to " << q.transpose();
    }
  }
}

TEST_P(BspOfSample, NormalIsTheGradientOfTheDistanceAndLeadsToTheFoot) {
  Scatter random(7);
  const CompiledTool form = variants_of(tool()).front();
  const double h = 1e-6;
  int smooth = 0;
  for (std::size_t i = 0; i < 20'000; ++i) {
    const Vec2 q = random_point(random, form, i) + Vec2(2 * h, 0);
    const ToolDistance a = evaluate(form, q.x(), q.y());
    EXPECT_NEAR(a.normal.norm(), 1, 1e-12);
    EXPECT_LE((q - a.signed_distance_mm * a.normal - a.foot).norm(), 1e-12 * (extent(form) + q.norm()));
    const auto at = [&](double dr, double dz) { return evaluate(form, q.x() + dr, q.y() + dz); };
    const ToolDistance east = at(h, 0), west = at(-h, 0), north = at(0, h), south = at(0, -h);
    const bool is_one_region = east.element == a.element && west.element == a.element && north.element == a.element &&
                               south.element == a.element;
    if (!is_one_region || std::abs(a.signed_distance_mm) < 1e-2 || q.norm() > 3 * extent(form)) continue;
    const Vec2 gradient(east.signed_distance_mm - west.signed_distance_mm,
                        north.signed_distance_mm - south.signed_distance_mm);
    EXPECT_TRUE((gradient / (2 * h)).isApprox(a.normal, 1e-4)) << q.transpose();
    ++smooth;
  }
  EXPECT_GT(smooth, 1000);
}

// Profiles no assembly makes yet: undercuts, concave arcs, a ring-shaped bottom, a tip off the axis plane.
TEST(Bsp, FreeProfilesWithConcaveArcsAndUndercuts) {
  Profile cup;  // hollow bottom, concave neck, lollipop-like bulge of more than a half circle
  cup.elements = {make_segment(Body::cutter, {0, 3}, {2, 3}),
                  make_concave_arc(Body::cutter, {2, 3}, {4, 1}, {2, 1}, 2),
                  make_segment(Body::cutter, {4, 1}, {4, 0}),
                  make_segment(Body::cutter, {4, 0}, {6, 0}),
                  make_convex_arc(Body::cutter, {6, 0}, {6, 8}, {6, 4}, 4),
                  make_concave_arc(Body::shank, {6, 8}, {4, 10}, {6, 10}, 2),
                  make_segment(Body::shank, {4, 10}, {4, 20}),
                  make_convex_arc(Body::holder, {4, 20}, {4, 28}, {5, 24}, std::sqrt(17.0)),
                  make_segment(Body::holder, {4, 28}, {0, 28})};
  ASSERT_EQ(verify_profile(cup), std::vector<std::string>{});
  const CompiledTool tool = compile_tool("cup", cup);
  EXPECT_EQ(test::verify_tool(tool), std::vector<std::string>{});
  expect_brute_force(tool, 2'000'000, 8);
}

ToolAssembly random_assembly(Scatter& random) {
  const auto segments = [&](std::uint64_t most) {
    std::vector<ToolSegment> list;
    for (std::uint64_t k = random.next() % (most + 1); k > 0; --k) {
      const double lower = random.in(1, 40);
      const double upper = random.next() % 2 == 0 ? lower : random.in(1, 40);
      list.push_back({lower, upper, random.in(0.5, 40)});
    }
    return list;
  };
  const double d = random.in(0.5, 40), length = random.in(20, 60);
  const double corner = random.next() % 3 == 0 ? d / 2 : random.in(0, d / 2);
  switch (random.next() % 3) {
    case 0:
      return test::assembly("random", TaperedCutter{d, corner, random.in(-8, 40), length}, segments(3), segments(4));
    case 1:
      return test::assembly("random", BullNoseCutter{d, corner, length}, segments(3), segments(4));
    default:
      return test::assembly("random", AptCutter{d, 0.4 * corner, 0, 0, random.in(0, 50), random.in(-8, 30), length},
                            segments(3), segments(4));
  }
}

TEST(Bsp, RandomAssembliesGiveTheDistanceOfTheBruteForce) {
  Scatter random(9);
  int built = 0;
  for (int k = 0; built < 200 && k < 1000; ++k) {
    const ToolAssembly tool = random_assembly(random);
    const Result<ToolVariants> variants = make_tool_variants(tool, random.in(0, 1), random.in(0, 2), random.in(0, 5));
    if (!variants) continue;
    ++built;
    for (const CompiledTool* form : {&variants->bare, &variants->against_part}) {
      EXPECT_EQ(test::verify_tool(*form), std::vector<std::string>{}) << k;
      expect_brute_force(*form, 20'000, static_cast<std::uint64_t>(k));
    }
  }
  EXPECT_EQ(built, 200);
}

// A rounded head under a wider shank: arc and face touch at a cusp, where the rounding of the turn has no
// state.
TEST(Bsp, ACrackBetweenAnArcAndAFaceIsReflex) {
  for (const double shift : {0.0, 1e-16, -1e-16, 3e-9, -3e-9}) {
    Profile profile;
    profile.elements = {make_segment(Body::cutter, {0, 0}, {6, 0}),
                        make_convex_arc(Body::cutter, {6, 0}, {5 + shift, 2}, {5, 1}, 1),
                        make_segment(Body::shank, {5 + shift, 2}, {9, 2}), make_segment(Body::shank, {9, 2}, {9, 30}),
                        make_segment(Body::shank, {9, 30}, {0, 30})};
    profile.elements[0].b = profile.elements[1].a = {5, 0};
    const CompiledTool tool = compile_tool("crack", profile);
    EXPECT_LT(evaluate(tool, 4, 3).signed_distance_mm, 0) << shift;
    EXPECT_LT(evaluate(tool, 4, 1.5).signed_distance_mm, 0) << shift;
    EXPECT_GT(evaluate(tool, 7, 1.5).signed_distance_mm, 0) << shift;
    expect_brute_force(tool, 20'000, 4);
  }
}

TEST(Bsp, IsShallow) {
  for (const ToolAssembly& tool : test::sample_tools()) {
    const CompiledTool form = variants_of(tool).front();
    EXPECT_LE(bsp_depth(form.nodes), 14u) << tool.name;
    EXPECT_LE(form.nodes.size(), 8 * form.elements.size()) << tool.name;
  }
}

// An arc grown about a corner begins within rounding of an axis direction, so the lines that bound its domain
// are nearly parallel to others and meet them some 1e14 mm away.
TEST(Bsp, LinesThatMeetFarAwayDropNoElementThatIsNear) {
  const ToolAssembly necked =
      test::assembly("necked", BullNoseCutter{3.4854438134566714, 0.54693938380695839, 10.9047977},
                     {{3.4854438134566714, 0.88606952362035774, 0.29383585006212254}},
                     {{20.684865881953211, 20.684865881953211, 0.50450899697678997},
                      {4.7186420391100832, 4.7186420391100832, 0.08198941408060724}});
  const ToolAssembly flat = test::assembly("flat", FlatCutter{20.2, 39.063925}, {},
                                           {{50.13187335134046, 18.19846650671014, 51.000337830380253},
                                            {18.258618465717582, 18.258618465717582, 0.41692612182345279}});
  Scatter random(17);
  for (int i = 0; i < 30; ++i) {
    const double cutter = i == 0 ? 0 : random.in(0.01, 1);
    const double shank = i == 0 ? 0.0155006333 : random.in(0.01, 1);
    const double holder = i == 0 ? 0 : random.in(0.01, 3);
    for (const ToolAssembly* tool : {&necked, &flat})
      expect_brute_force(make_tool_variants(*tool, cutter, shank, holder)->against_part, 4000, 18);
  }
}

}  // namespace
}  // namespace gouge::bsp_test
