#include "lib/validate/repair_mesh.h"

#include <gtest/gtest.h>

#include "lib/mesh/load_mesh.h"
#include "tests/support/shapes.h"
#include "tests/support/solids.h"

namespace gouge::repair_mesh_test {
namespace {

MeshRepair repaired(const IndexedMesh& mesh, const RepairOptions& options = {}) {
  const MeshValidation before = validate_mesh(mesh, find_mesh_findings(mesh));
  Result<MeshRepair> repair = repair_mesh(mesh, before, options);
  EXPECT_TRUE(repair.has_value()) << to_text(repair.error());
  return std::move(repair).value();
}

TEST(RepairMesh, ASoundMeshIsNotMadeBetter) {
  const MeshRepair repair = repaired(shapes::cube());
  EXPECT_FALSE(repair.is_better());
  EXPECT_TRUE(repair.after.is_sound());
}

TEST(RepairMesh, InsideOutIsTurned) {
  const MeshRepair repair = repaired(shapes::inside_out(shapes::sphere()));
  EXPECT_TRUE(repair.is_better());
  EXPECT_TRUE(repair.after.is_sound());
  EXPECT_EQ(repair.steps.triangles_turned, shapes::sphere().triangles.size());
}

TEST(RepairMesh, TurnedTrianglesAreTurnedBackAndCounted) {
  IndexedMesh mesh = shapes::cube();
  for (const std::size_t t : {0U, 3U, 7U}) std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
  const MeshRepair repair = repaired(mesh);
  EXPECT_TRUE(repair.after.is_sound());
  EXPECT_EQ(repair.steps.triangles_turned, 3U);
}

TEST(RepairMesh, CavitiesStayInward) {
  IndexedMesh mesh = shapes::hollow_cube();
  std::swap(mesh.triangles[20][0], mesh.triangles[20][1]);
  const MeshRepair repair = repaired(mesh);
  EXPECT_TRUE(repair.after.is_sound());
  EXPECT_EQ(repair.after.findings.cavities, 1U);
  EXPECT_NEAR(repair.after.volume_mm3.value_or(0), 875, 1e-9);
}

TEST(RepairMesh, HolesAreFilledOnlyWhenAsked) {
  const MeshRepair kept = repaired(shapes::open_cube());
  EXPECT_FALSE(kept.is_better());
  EXPECT_EQ(kept.steps.holes_left, 1U);
  EXPECT_EQ(kept.steps.holes_filled, 0U);

  RepairOptions fill;
  fill.fills_holes = true;
  const MeshRepair filled = repaired(shapes::open_cube(), fill);
  EXPECT_TRUE(filled.is_better());
  EXPECT_TRUE(filled.after.is_sound());
  EXPECT_EQ(filled.steps.holes_filled, 1U);
  EXPECT_EQ(filled.steps.hole_triangles_added, 2U);
  EXPECT_NEAR(filled.after.volume_mm3.value_or(0), 1000, 1e-9);
}

TEST(RepairMesh, DuplicatesAreRemoved) {
  IndexedMesh mesh = shapes::cube();
  const TriangleCorners t = mesh.triangles[5];
  shapes::add_triangle(mesh, t[0], t[1], t[2]);
  shapes::add_triangle(mesh, t[2], t[1], t[0]);
  const MeshRepair repair = repaired(mesh);
  EXPECT_TRUE(repair.after.is_sound());
  EXPECT_EQ(repair.steps.duplicates_removed, 2U);
}

TEST(RepairMesh, TrianglesWithoutAreaAreRemoved) {
  IndexedMesh mesh = shapes::cube();  // a vertex on the edge 4-6 splits one of its triangles, a sliver the other
  const std::size_t on_edge = mesh.vertices.size();
  mesh.vertices.emplace_back(0, 5, 10);
  mesh.triangles.pop_back();
  mesh.file_triangle.pop_back();
  shapes::add_triangle(mesh, 4, 7, on_edge);
  shapes::add_triangle(mesh, on_edge, 7, 6);
  shapes::add_triangle(mesh, 4, on_edge, 6);
  ASSERT_TRUE(find_mesh_findings(mesh).is_solid());
  const MeshRepair repair = repaired(mesh);
  EXPECT_EQ(repair.steps.collinear_removed, 1U);
  EXPECT_TRUE(repair.after.is_sound());
}

/// Every coordinate on a grid: triangles fold flat, vanish and lie on each other.
IndexedMesh on_grid(IndexedMesh mesh, double step) {
  TriangleSoup soup;
  soup.name = mesh.name;
  for (Vec3& v : mesh.vertices) v = step * (v / step).array().round().matrix();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    soup.triangles.push_back({mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)});
  Result<BuiltMesh> built = build_mesh(soup);
  return built ? built->mesh : IndexedMesh{};
}

// Slivers without area stopped the removal of such triangles, and pieces folded flat the orientation of all others.
TEST(RepairMesh, SliversAndFlatPiecesDoNotStopIt) {
  std::size_t tried = 0, better = 0;
  for (const IndexedMesh& mesh : {shapes::torus(20, 5), shapes::bumpy_sphere(), shapes::star_prism(9, 20, 3, 2),
                                  shapes::slotted_block(), shapes::needle_fan(200)}) {
    for (const double step : {0.7, 1.3, 2.0, 3.1, 4.5, 6.0, 8.0, 11.0, 15.0}) {
      const IndexedMesh coarse = on_grid(mesh, step);
      if (coarse.triangles.empty()) continue;
      const MeshValidation before = validate_mesh(coarse, find_mesh_findings(coarse));
      EXPECT_EQ(before.trouble, "") << mesh.name << " " << step;
      for (const bool fills_holes : {false, true}) {
        RepairOptions options;
        options.fills_holes = fills_holes;
        const Result<MeshRepair> repair = repair_mesh(coarse, before, options);
        ASSERT_TRUE(repair.has_value()) << mesh.name << " " << step << ": " << to_text(repair.error());
        EXPECT_EQ(repair->after.trouble, "") << mesh.name << " " << step;
        ++tried;
        better += repair->is_better() ? 1U : 0U;
      }
    }
  }
  EXPECT_GT(tried, 60U);
  EXPECT_GT(better, tried / 5);
}

TEST(RepairMesh, WhatIsReportedHoldsForTheBytes) {
  RepairOptions inch;
  inch.unit = LengthUnit::inch;
  const MeshRepair repair = repaired(shapes::inside_out(shapes::cube(25.4)), inch);
  const auto loaded = load_mesh_bytes(repair.stl_bytes, "out.stl", {LengthUnit::inch, {}});
  ASSERT_TRUE(loaded.has_value());
  EXPECT_TRUE(loaded->findings.is_solid());
  EXPECT_NEAR(loaded->findings.signed_volume_mm3, 25.4 * 25.4 * 25.4, 1e-6);
}

TEST(RepairMesh, TouchingSolidsCannotBeMadeSoundInAnStl) {
  const MeshRepair repair = repaired(shapes::cubes_touching_at_edge());
  EXPECT_FALSE(repair.is_better()) << "split vertices weld again when the file is read";
}

TEST(RepairMesh, OddMeshesAreRepairedOrRefusedWithoutAborting) {
  IndexedMesh line;
  line.vertices = {Vec3(0, 0, 0), Vec3(1, 1, 1), Vec3(2, 2, 2)};
  shapes::add_triangle(line, 0, 1, 2);
  const MeshValidation before = validate_mesh(line, find_mesh_findings(line));
  const Result<MeshRepair> repair = repair_mesh(line, before, {});
  if (!repair) {
    EXPECT_EQ(repair.error().code, "mesh-repair-failed");
  } else {
    EXPECT_FALSE(repair->after.is_sound());
  }
}

}  // namespace
}  // namespace gouge::repair_mesh_test
