#include "toolmodels/draw_profile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lib/tool/evaluate.h"
#include "tests/toolmodels/sample_tools.h"
#include "toolmodels/compile_tool.h"
#include "toolmodels/trace_regions.h"

namespace gouge::draw_profile_test {
namespace {

double area(const std::vector<Vec2>& points) {
  double doubled = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2 &p = points[i], &q = points[(i + 1) % points.size()];
    doubled += p.x() * q.y() - p.y() * q.x();
  }
  return std::abs(doubled) / 2;
}

double area(const Profile& profile) {
  std::vector<Vec2> points;
  for (const ProfileElement& e : profile.elements)
    for (const Vec2& p : sample(e, 500)) points.push_back(p);
  return area(points);
}

std::vector<Vec2> points_of(const Drawing& drawing) {
  std::vector<Vec2> all;
  for (const auto& item : drawing.items) {
    if (const auto* line = std::get_if<DrawnLine>(&item))
      all.insert(all.end(), line->points.begin(), line->points.end());
    if (const auto* shape = std::get_if<DrawnShape>(&item))
      all.insert(all.end(), shape->points.begin(), shape->points.end());
    if (const auto* text = std::get_if<DrawnText>(&item)) all.push_back(text->at);
  }
  return all;
}

std::vector<std::string> texts_of(const Drawing& drawing) {
  std::vector<std::string> all;
  for (const auto& item : drawing.items)
    if (const auto* text = std::get_if<DrawnText>(&item)) all.push_back(text->text);
  return all;
}

bool has(const std::vector<std::string>& texts, const std::string& wanted) {
  return std::find(texts.begin(), texts.end(), wanted) != texts.end();
}

TEST(TraceRegions, FillTheToolWithoutGapOrOverlap) {
  for (const ToolAssembly& assembly : test::sample_tools()) {
    const Result<Profile> profile = make_profile(assembly);
    const CompiledTool tool = compile_tool("", *profile);
    double sum = 0;
    for (const TracedRegion& r : trace_regions(tool, {0, tool.z_min_mm}, {tool.r_max_mm, tool.z_max_mm})) {
      if (!r.is_inside) continue;
      std::vector<Vec2> outline = r.near_points;
      outline.insert(outline.end(), r.far_points.rbegin(), r.far_points.rend());
      sum += area(outline);
    }
    EXPECT_NEAR(sum, area(*profile), 2e-3 * area(*profile)) << assembly.name;
  }
}

TEST(TraceRegions, BisectorsLieAtTheDistanceOfTwoElements) {
  const Result<Profile> profile = make_profile(test::sample_tools()[5]);
  const CompiledTool tool = compile_tool("", *profile);
  int seen = 0;
  for (const TracedRegion& r : trace_regions(tool, {0, tool.z_min_mm}, {tool.r_max_mm, tool.z_max_mm}))
    for (std::size_t i = 0; i < r.far_points.size(); ++i) {
      if (!r.is_bisector[i]) continue;
      ++seen;
      const Vec2 far = r.far_points[i];
      const double here = std::abs(evaluate_brute_force(tool, far.x(), far.y()).signed_distance_mm);
      EXPECT_NEAR(here, (far - r.near_points[i]).norm(), 1e-6);
      const Vec2 beyond = far + 1e-3 * (far - r.near_points[i]).normalized();
      const double there =
          std::abs(evaluate_brute_force(tool, std::max(0.0, beyond.x()), beyond.y()).signed_distance_mm);
      EXPECT_LT(there, (beyond - r.near_points[i]).norm()) << "another element is nearer beyond";
    }
  EXPECT_GT(seen, 100);
}

TEST(DrawProfile, EverythingIsOnTheSheetAndFinite) {
  for (const ToolAssembly& tool : test::sample_tools()) {
    const Result<Drawing> drawing = draw_profile(tool, LengthUnit::mm);
    ASSERT_TRUE(drawing.has_value()) << tool.name;
    for (const Vec2& p : points_of(*drawing)) {
      ASSERT_TRUE(p.allFinite()) << tool.name;
      ASSERT_GE(p.minCoeff(), 0) << tool.name << " " << p.transpose();
      ASSERT_LE(p.x(), drawing->width) << tool.name;
      ASSERT_LE(p.y(), drawing->height) << tool.name;
    }
  }
}

TEST(DrawProfile, DimensionsAreWrittenInTheUnitAsked) {
  const ToolAssembly tool =
      test::assembly("t", BullNoseCutter{25.4, 2.54, 50.8}, {{25.4, 25.4, 25.4}}, {{50.8, 76.2, 25.4}});
  const std::vector<std::string> texts = texts_of(*draw_profile(tool, LengthUnit::inch));
  for (const char* wanted : {"T1 \"t\"", "bull-nose D 1 R 0.1, length 2, assembly 4 in", "cutter 2", "shank 1",
                             "holder 1", "D 1", "D 2 to 3", "R 0.1", "dimensions in inches"})
    EXPECT_TRUE(has(texts, wanted)) << wanted;
}

TEST(DrawProfile, TheWidestRadiusIsNamedSoWhereItIsNotTheNominalOne) {
  const auto has_radius = [](const ToolAssembly& tool, const std::string& words) {
    const std::vector<std::string> texts = texts_of(*draw_profile(tool, LengthUnit::mm));
    return std::any_of(texts.begin(), texts.end(), [&](const std::string& text) { return text.starts_with(words); });
  };
  EXPECT_TRUE(has_radius(test::assembly("t", FlatCutter{10, 20}), "D/2 = 5"));
  EXPECT_TRUE(has_radius(test::assembly("t", TaperedCutter{2, 1, 5, 20}), "widest D/2 = "));
  EXPECT_FALSE(has_radius(test::assembly("t", TaperedCutter{2, 1, 5, 20}), "D/2 = "));
}

TEST(DrawProfile, StickOutAndGaugeLengthAreReported) {
  ToolAssembly tool = test::assembly("t", FlatCutter{10, 20}, {{10, 10, 60}}, {{32, 32, 40}});
  tool.stickout_mm = 50;
  tool.gauge_length_mm = 85;
  EXPECT_TRUE(has(texts_of(*draw_profile(tool, LengthUnit::mm)),
                  "flat D 10, length 20, assembly 90 mm, stick-out 50, gauge length 85"));
}

TEST(DrawProfile, TheSameToolGivesTheSameDrawing) {
  const ToolAssembly tool = test::sample_tools()[7];
  EXPECT_EQ(points_of(*draw_profile(tool, LengthUnit::mm)), points_of(*draw_profile(tool, LengthUnit::mm)));
}

TEST(DrawProfile, AToolThatCannotBeBuiltIsAnError) {
  const Result<Drawing> drawing = draw_profile(test::assembly("t", BallCutter{-1, 3}), LengthUnit::mm);
  ASSERT_FALSE(drawing.has_value());
  EXPECT_EQ(drawing.error().code, "tool-dimension-not-positive");
}

TEST(DrawSheet, HoldsEveryToolInARowAndColumnOfItsOwn) {
  const std::vector<ToolAssembly> tools = test::sample_tools();
  std::vector<const ToolAssembly*> chosen;
  for (const ToolAssembly& tool : tools) chosen.push_back(&tool);
  const Drawing sheet = *draw_sheet(chosen, LengthUnit::mm);
  for (const Vec2& p : points_of(sheet)) {
    ASSERT_TRUE(p.allFinite());
    ASSERT_GE(p.minCoeff(), 0);
    ASSERT_LE(p.x(), sheet.width);
    ASSERT_LE(p.y(), sheet.height);
  }
  const std::vector<std::string> texts = texts_of(sheet);
  for (const ToolAssembly& tool : tools) EXPECT_TRUE(has(texts, label(tool))) << tool.name;
  chosen.resize(2);
  EXPECT_EQ(3 * draw_sheet(chosen, LengthUnit::mm)->height, sheet.height) << "one row instead of three";
}

}  // namespace
}  // namespace gouge::draw_profile_test
