#include "postproc/image/plot_panel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace gouge::plot_panel_test {
namespace {

PlotPanel panel_from_above() {
  PlotPanel panel;
  panel.width = 800;
  panel.height = 400;
  panel.name = "from above";
  return panel;
}

// A square of 10 mm in the plane z.
IndexedMesh square(double z, double low = 0, double high = 10) {
  IndexedMesh mesh;
  mesh.vertices = {{low, low, z}, {high, low, z}, {high, high, z}, {low, high, z}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

std::vector<std::string> texts_of(const Drawing& drawing) {
  std::vector<std::string> texts;
  for (const auto& item : drawing.items) {
    if (const auto* text = std::get_if<DrawnText>(&item)) texts.push_back(text->text);
  }
  return texts;
}

double area_of(const Drawing& drawing) {
  double area = 0;
  for (const auto& item : drawing.items) {
    if (const auto* shape = std::get_if<DrawnShape>(&item))
      area += (shape->points[1] - shape->points[0]).norm() * (shape->points[2] - shape->points[1]).norm();
  }
  return area;
}

TEST(PlotPanel, RoundLengthsAreOneTwoAndFive) {
  EXPECT_DOUBLE_EQ(round_length(1), 1);
  EXPECT_DOUBLE_EQ(round_length(4.9), 2);
  EXPECT_DOUBLE_EQ(round_length(73), 50);
  EXPECT_DOUBLE_EQ(round_length(0.03), 0.02);
}

TEST(PlotPanel, TicksStandAtTheirCoordinates) {
  PlotPanel panel = panel_from_above();
  panel.fit(Box3(Vec3(0, 0, 0), Vec3(100, 50, 0)));
  Drawing drawing;
  draw_frame(panel, LengthUnit::mm, drawing);
  std::size_t found = 0;
  for (const auto& item : drawing.items) {
    const auto* text = std::get_if<DrawnText>(&item);
    if (text == nullptr || text->anchor != TextAnchor::middle || text->text.find("mm") != std::string::npos) continue;
    EXPECT_NEAR(text->at.x(), panel.at({std::stod(text->text), 0, 0}).x(), 1e-6) << text->text;
    ++found;
  }
  EXPECT_GE(found, 4U);
  const std::vector<std::string> texts = texts_of(drawing);
  EXPECT_EQ(std::ranges::count(texts, "20 mm"), 1) << "the scale";
}

TEST(PlotPanel, CoordinatesAreInTheUnitOfThePath) {
  PlotPanel panel = panel_from_above();
  panel.fit(Box3(Vec3(0, 0, 0), Vec3(254, 127, 0)));
  Drawing drawing;
  draw_frame(panel, LengthUnit::inch, drawing);
  const std::vector<std::string> texts = texts_of(drawing);
  EXPECT_EQ(std::ranges::count(texts, "2 in"), 1);
}

TEST(PlotPanel, APartCoversWhatItIsWide) {
  PlotPanel panel = panel_from_above();
  panel.fit(square(0).box());
  Drawing drawing;
  draw_parts(panel, {square(0)}, drawing);
  const double side = 10 * panel.scale;
  EXPECT_NEAR(area_of(drawing), side * side, 6 * side) << "to the cells at its edge";
  Drawing empty;
  draw_parts(panel, {}, empty);
  EXPECT_TRUE(empty.items.empty());
}

TEST(PlotPanel, TheNearestSurfaceIsSeen) {
  PlotPanel panel = panel_from_above();
  panel.fit(square(0).box());
  IndexedMesh tilted = square(0);  // below, and of another shade
  tilted.vertices[0].z() = tilted.vertices[1].z() = -30;
  const auto shades = [&](const std::vector<IndexedMesh>& parts) {
    Drawing drawing;
    draw_parts(panel, parts, drawing);
    std::set<int> greys;
    for (const auto& item : drawing.items) greys.insert(std::get<DrawnShape>(item).fill.r);
    return greys;
  };
  EXPECT_EQ(shades({square(1)}).size(), 1U);
  EXPECT_EQ(shades({tilted, square(1)}), shades({square(1)}));
  EXPECT_EQ(shades({square(1), tilted}), shades({square(1)})) << "in any order";
  EXPECT_NE(shades({tilted}), shades({square(1)}));
}

}  // namespace
}  // namespace gouge::plot_panel_test
