#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "postproc/image/colour_scale.h"
#include "postproc/image/picture_scene.h"
#include "postproc/image/section.h"
#include "postproc/image/surface_buffer.h"
#include "postproc/image/tool_outline.h"
#include "tests/postproc/image/small_scene.h"
#include "tests/support/scatter.h"

namespace gouge::rasteriser_test {
namespace {

Scene block_scene() {
  Scene scene;
  scene.parts = {box_mesh("block.stl", {0, 0, 0}, {40, 30, 10})};
  return scene;
}

struct PreparedBlock {
  Scene scene = block_scene();
  PreparedScene prepared{scene};
};

TEST(View, UnprojectsWhatItProjects) {
  View view = make_view({1, -2, 1.5}, Vec3::UnitZ(), 300, 200);
  const std::vector<Vec3> ends{{0, 0, 0}, {40, 30, 10}};
  fit_view(view, {{ends}}, 0.1);
  const Vec3 p(12, 7, 3);
  const Vec3 q = view.project(p);
  EXPECT_LT((view.unproject(q.x(), q.y(), q.z()) - p).norm(), 1e-12);
  EXPECT_NEAR(view.right.dot(view.toward), 0, 1e-15);
  EXPECT_GT(view.up.z(), 0);
}

TEST(View, LooksAlongItsHintWithoutLosingItself) {
  const View view = make_view(Vec3::UnitZ(), Vec3::UnitZ(), 10, 10);
  EXPECT_NEAR(view.right.norm(), 1, 1e-12);
  EXPECT_NEAR(view.up.y(), 1, 1e-12);
}

TEST(View, FitsEveryPointInsideItsMargin) {
  View view = make_view({1, 1, 1}, Vec3::UnitZ(), 300, 200);
  const std::vector<Vec3> points = block_scene().parts[0].vertices;
  fit_view(view, {{points}}, 0.1);
  for (const Vec3& p : points) {
    const Vec3 q = view.project(p);
    EXPECT_GE(q.x(), 30 - 1e-9);
    EXPECT_LE(q.x(), 270 + 1e-9);
    EXPECT_GE(q.y(), 20 - 1e-9);
    EXPECT_LE(q.y(), 180 + 1e-9);
  }
}

TEST(SurfaceBuffer, ShowsTheNearestFaceAndNoGaps) {
  const PreparedBlock block;
  const PictureScene scene(block.prepared);
  View view = make_view(Vec3::UnitZ(), Vec3::UnitY(), 400, 300);
  fit_view(view, scene.part_points(), 0.1);
  const SurfaceBuffer buffer = draw_surface(scene, view);
  for (int y = 0; y < 300; ++y) {
    for (int x = 0; x < 400; ++x) {
      const Vec3 p = view.unproject(x + 0.5, y + 0.5, 0);
      const bool is_over = p.x() > 0.01 && p.x() < 39.99 && p.y() > 0.01 && p.y() < 29.99;
      if (!is_over) continue;
      ASSERT_NE(buffer.face[buffer.index(x, y)], kNoFace) << x << " " << y;
      ASSERT_NEAR(buffer.point(x, y).z(), 10, 1e-4);
    }
  }
  EXPECT_EQ(buffer.face[buffer.index(2, 2)], kNoFace);
  EXPECT_NEAR(NormalsAt(scene, view)(buffer.face[buffer.index(200, 150)], 200, 150).z(), 1, 1e-6);
  EXPECT_TRUE(is_visible(buffer, {20, 15, 10}, 0.01));
  EXPECT_FALSE(is_visible(buffer, {20, 15, 9}, 0.01));
}

// Content of the pixel in the middle of (x, y) for these triangles, one by one.
std::uint32_t face_by_hand(const std::vector<Vec3>& vertices, const std::vector<FaceCorners>& faces, const View& view,
                           int x, int y, double& nearest, double& edge_gap) {
  std::uint32_t seen = kNoFace;
  nearest = std::numeric_limits<float>::lowest();
  edge_gap = 1;
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    std::array<Vec3, 3> p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = view.project(vertices[faces[f][k]]);
    const Vec2 at(x + 0.5, y + 0.5);
    const auto side = [&](const Vec3& a, const Vec3& b) {
      return (b.x() - a.x()) * (at.y() - a.y()) - (b.y() - a.y()) * (at.x() - a.x());
    };
    const double area = (p[1].x() - p[0].x()) * (p[2].y() - p[0].y()) - (p[1].y() - p[0].y()) * (p[2].x() - p[0].x());
    if (!(std::abs(area) > 0)) continue;
    const double u = side(p[1], p[2]) / area, v = side(p[2], p[0]) / area, w = 1 - u - v;
    edge_gap = std::min({edge_gap, std::abs(u), std::abs(v), std::abs(w)});
    if (u < 0 || v < 0 || w < 0) continue;
    const double z = u * p[0].z() + v * p[1].z() + w * p[2].z();
    edge_gap = std::min(edge_gap, std::abs(z - nearest));
    if (z > nearest) seen = f;
    nearest = std::max(nearest, z);
  }
  return seen;
}

TEST(SurfaceBuffer, ShowsOfAnyTrianglesWhatEachPixelShows) {
  test::Scatter scatter(7);
  for (const int width : {5, 8, 13, 90}) {
    std::vector<Vec3> vertices;
    std::vector<FaceCorners> faces;
    for (std::uint32_t f = 0; f < 60; ++f) {
      const Vec3 middle = scatter.point(12);
      const double reach = scatter.in(0.05, 9);
      for (int k = 0; k < 3; ++k) vertices.push_back(middle + scatter.point(reach));
      faces.push_back({3 * f, 3 * f + 1, 3 * f + 2});
    }
    View view = make_view(Vec3(0.3, -0.4, 1), Vec3::UnitY(), width, 70);
    view.mm_per_pixel = 0.3;
    const SurfaceBuffer buffer = draw_surface(vertices, faces, view);
    std::size_t seen = 0;
    for (int y = 0; y < view.height; ++y) {
      for (int x = 0; x < width; ++x) {
        double nearest = 0, edge_gap = 0;
        const std::uint32_t face = face_by_hand(vertices, faces, view, x, y, nearest, edge_gap);
        if (edge_gap < 1e-5) continue;  // either may be right
        ASSERT_EQ(buffer.face[buffer.index(x, y)], face) << x << " " << y << " of " << width;
        if (face == kNoFace) continue;
        ++seen;
        ASSERT_NEAR(static_cast<double>(buffer.z[buffer.index(x, y)]), nearest, 1e-4);
      }
    }
    EXPECT_GT(seen, 50U);
  }
}

TEST(PictureScene, FindsTheTwelveEdgesOfABlock) {
  const PreparedBlock block;
  EXPECT_EQ(PictureScene(block.prepared).edges().size(), 12U);
}

TEST(PictureScene, KnowsWhoseEachFaceIs) {
  Scene scene;
  scene.parts = {box_mesh("a.stl", {0, 0, 0}, {40, 30, 10}), box_mesh("b.stl", {50, 0, 0}, {90, 30, 10})};
  scene.fixtures = {box_mesh("jaw.stl", {0, -20, 0}, {40, 0, 10})};
  const PreparedScene prepared(scene);
  const PictureScene pictured(prepared);
  ASSERT_EQ(pictured.face_count(), 36U);
  for (std::uint32_t f = 0; f < 36; ++f) {
    EXPECT_EQ(pictured.mesh_of(f), f / 12);
    EXPECT_EQ(pictured.is_of_workpiece(f), f < 24);
    const IndexedMesh& mesh = f < 24 ? scene.parts[f / 12] : scene.fixtures[0];
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(pictured.corners(f)[k], mesh.corner(f % 12, k));
  }
  EXPECT_EQ(pictured.vertex(17), scene.fixtures[0].vertices[1]);
  EXPECT_EQ(pictured.part_points().size(), 2U);
}

TEST(ColourScale, GrowsSteadilyDarker) {
  for (const bool is_root : {false, true}) {
    const ColourScale scale{0.01, 2, is_root};
    double last = 1e9;
    for (double depth = 0.01; depth <= 2; depth += 0.005) {
      const Colour c = scale.at(depth);
      const double lightness = 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;
      EXPECT_LE(lightness, last + 0.8) << depth;
      last = lightness;
    }
    EXPECT_NEAR(scale.depth_at(scale.place(0.37)), 0.37, 1e-12);
  }
}

TEST(ColourScale, TicksAreRoundInTheUnitOfThePath) {
  const ColourScale scale = make_colour_scale(0.0254, 0.43, LengthUnit::inch);
  EXPECT_NEAR(scale.high_mm / 25.4, 0.02, 1e-12);
  const std::vector<Tick> ticks = make_ticks(scale, LengthUnit::inch, 0.1);
  ASSERT_EQ(ticks.size(), 5U);
  EXPECT_EQ(ticks[1].text, "0.005");
  EXPECT_NEAR(ticks[1].depth_mm, 0.127, 1e-12);
}

TEST(RoundNumbers, AreRoundAndOnTheRightSide) {
  for (const double value : {0.00031, 0.7, 1.0, 1.01, 37.0, 999.0}) {
    EXPECT_GE(round_up(value), value * (1 - 1e-9));
    EXPECT_LE(round_up(value), value * 1.35);
    EXPECT_LE(round_down(value), value);
    EXPECT_GT(round_down(value), value / 2.6);
  }
}

TEST(Section, OfABlockIsARectangle) {
  const Pose pose{{20, 15, 8}, Vec3::UnitZ()};
  const Section section = make_section(PreparedBlock().prepared, pose, {23, 15, 10}, 30);
  double length = 0;
  for (const SectionLine& line : section.lines) {
    length += (line.b - line.a).norm();
    EXPECT_NEAR(std::abs(line.a.x()) > 19.9 || line.a.y() > 1.9 || line.a.y() < -7.9, 1, 0);
  }
  EXPECT_NEAR(length, 2 * (40 + 10), 1e-9);
  EXPECT_NEAR(section.plane.flat({23, 15, 10}).x(), 3, 1e-12);
}

TEST(Section, StillShowsAPartWhoseFaceItRunsAlong) {
  const Pose pose{{20, 0, 8}, Vec3::UnitZ()};
  EXPECT_GT(make_section(PreparedBlock().prepared, pose, {25, 0, 10}, 10).lines.size(), 3U);
  // A point on the axis leaves the plane open.
  EXPECT_GT(make_section(PreparedBlock().prepared, pose, {20, 0, 10}, 10).lines.size(), 3U);
}

TEST(ToolOutline, ReachesFromTheTipToTheTopAndClosesTheSurface) {
  const ToolVariants tool = ball_with_holder();
  const std::vector<OutlineRun> runs = tool_outline(tool.bare);
  ASSERT_EQ(runs.size(), 3U);
  EXPECT_LT(runs.front().points.front().norm(), 1e-9);
  EXPECT_NEAR(runs.back().points.back().y(), 45, 1e-9);
  EXPECT_NEAR(body_range(tool.bare, Body::holder).low_mm, 25, 1e-9);
  const ToolSurface surface = tool_surface(tool.bare, {{1, 2, 3}, Vec3::UnitX()});
  EXPECT_EQ(surface.faces.size(), surface.bodies.size());
  for (const Vec3& v : surface.vertices) EXPECT_LE((v - Vec3(1, 2, 3)).tail<2>().norm(), 10 + 1e-9);
}

}  // namespace
}  // namespace gouge::rasteriser_test
