#include "cli/job/setup_notes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "lib/clash/clash.h"
#include "lib/mesh/mesh_builder.h"
#include "tests/support/shapes.h"

namespace gouge::setup_notes_test {
namespace {

// A block whose sides at low and high y are grids of n x n squares that are not quite where a coarser body has its
// corners: as a part that a CAM system meshes finely.
IndexedMesh fine_block(const Vec3& low, const Vec3& high, int n) {
  const IndexedMesh coarse = shapes::box(low, high);
  TriangleSoup soup;
  const Vec3 size = high - low;
  for (const double y : {low.y(), high.y()}) {
    const auto at = [&](int i, int k) { return Vec3(low.x() + size.x() * i / n, y, low.z() + size.z() * k / n); };
    for (int i = 0; i < n; ++i) {
      for (int k = 0; k < n; ++k) {
        const Vec3 a = at(i, k), b = at(i + 1, k), c = at(i + 1, k + 1), d = at(i, k + 1);
        if (y > low.y()) {
          soup.triangles.push_back({a, c, b});
          soup.triangles.push_back({a, d, c});
        } else {
          soup.triangles.push_back({a, b, c});
          soup.triangles.push_back({a, c, d});
        }
      }
    }
  }
  // The other sides: fans from the middle of each to the points of the grids along its border.
  const auto fan = [&](const std::vector<Vec3>& border) {
    Vec3 middle = Vec3::Zero();
    for (const Vec3& point : border) middle += point / static_cast<double>(border.size());
    for (std::size_t k = 0; k < border.size(); ++k)
      soup.triangles.push_back({border[k], border[(k + 1) % border.size()], middle});
  };
  for (const bool is_high : {false, true}) {
    std::vector<Vec3> across_x, across_z;
    const double x = is_high ? high.x() : low.x(), z = is_high ? high.z() : low.z();
    for (int k = 0; k <= n; ++k) {
      across_x.emplace_back(x, low.y(), low.z() + size.z() * k / n);
      across_z.emplace_back(low.x() + size.x() * k / n, low.y(), z);
    }
    for (int k = n; k >= 0; --k) {
      across_x.emplace_back(x, high.y(), low.z() + size.z() * k / n);
      across_z.emplace_back(low.x() + size.x() * k / n, high.y(), z);
    }
    if (is_high) std::reverse(across_x.begin(), across_x.end());
    if (!is_high) std::reverse(across_z.begin(), across_z.end());
    fan(across_x);
    fan(across_z);
  }
  return build_mesh(soup)->mesh;
}

// A vise: a bed with a jaw at each side of y from 0 to 80, from x 20 to 80, up to z 12.
IndexedMesh vise() {
  IndexedMesh mesh;
  const std::vector<Vec2> outline = {{-30, -5}, {110, -5}, {110, 12}, {80, 12}, {80, 0}, {0, 0}, {0, 12}, {-30, 12}};
  for (const double x : {20.0, 80.0})
    for (const Vec2& point : outline) mesh.vertices.emplace_back(x, point.x(), point.y());
  const std::size_t n = outline.size();
  for (std::size_t k = 0; k < n; ++k) shapes::add_quad(mesh, k, (k + 1) % n, n + (k + 1) % n, n + k);
  const std::vector<std::array<std::size_t, 3>> cap = {{0, 1, 4}, {0, 4, 5}, {1, 2, 3},
                                                       {1, 3, 4}, {0, 5, 6}, {0, 6, 7}};
  for (const auto& [a, b, c] : cap) {
    shapes::add_triangle(mesh, a, c, b);
    shapes::add_triangle(mesh, n + a, n + b, n + c);
  }
  return mesh;
}

Diagnostics notes_of(IndexedMesh part, IndexedMesh fixture) {
  auto files = std::make_shared<SceneFiles>();
  files->scene.parts.push_back(std::move(part));
  files->scene.fixtures.push_back(std::move(fixture));
  files->parts.emplace_back().name = "part.stl";
  files->fixtures.emplace_back().name = "vise.stl";
  const PreparedScene prepared(files->scene);
  Job job;
  job.files = files;
  return setup_notes(job, {}, prepared);
}

TEST(SetupNotes, AJawThatLiesFlatOnAFinePartIsProvedToTouchIt) {
  const IndexedMesh part = fine_block({0, 0, 0}, {120, 80, 60}, 40);
  const Surface part_surface(part), vise_surface(vise());
  ASSERT_TRUE(part_surface.is_solid() && vise_surface.is_solid());
  ClashOptions few;
  few.budget = 10'000;
  EXPECT_EQ(find_clash(ClashBody(part_surface), ClashBody(vise_surface), Vec3::Zero(), few).state,
            ClashState::not_certified)
      << "too easy to show anything";
  EXPECT_TRUE(notes_of(part, vise()).empty());
}

TEST(SetupNotes, AFixtureThatReachesIntoThePartIsAWarning) {
  const Diagnostics notes = notes_of(shapes::box({0, -1, 0}, {120, 80, 60}), vise());
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0].code, kFixtureOverlap);
  EXPECT_EQ(notes[0].severity, Severity::warning);
}

TEST(SetupNotes, AToleranceAboveTheRadiusOfACutterIsAWarning) {
  Job job;
  job.files = std::make_shared<SceneFiles>();
  ToolAssembly slim;
  slim.number = 3;
  slim.cutter = BallCutter{6, 20};
  job.assemblies = {std::nullopt, slim, ToolAssembly{.cutter = BallCutter{10, 20}}};
  JobArguments arguments;
  arguments.path = "op.apt";
  const PreparedScene prepared(job.files->scene);
  job.options.check.tolerance_mm = 3;
  EXPECT_TRUE(setup_notes(job, arguments, prepared).empty());
  job.options.check.tolerance_mm = 100;
  const Diagnostics notes = setup_notes(job, arguments, prepared);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(
      to_text(notes[0]),
      "op.apt: warning: the tolerance of 100 mm is more than the cutter radius of tool T3, 3 mm: gouges up to this "
      "tolerance count as clean [tolerance-large]");
}

TEST(SetupNotes, WhatStaysUndecidedIsAWarningToo) {
  const Diagnostics notes = notes_of(shapes::moved(shapes::open_cube(40), Vec3(30, 30, -10)),
                                     shapes::moved(shapes::open_cube(40), Vec3(40, 40, 0)));
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0].code, kFixtureUndecided);
  EXPECT_EQ(notes[0].severity, Severity::warning);
  EXPECT_TRUE(notes[0].message.starts_with("whether the fixture penetrates the part part.stl is not certified: "))
      << notes[0].message;
}

}  // namespace
}  // namespace gouge::setup_notes_test
