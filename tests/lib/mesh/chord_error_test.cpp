#include "lib/mesh/chord_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

namespace gouge::chord_error_test {
namespace {

/// A part of a cylinder of `facets` flat strips along Y, each of two triangles, over `angle` of a circle of radius 50.
/// Its normals point to the axis if it is hollow.
IndexedMesh cylinder(int facets, double angle, bool is_hollow) {
  constexpr double kRadius_mm = 50, kLength_mm = 80;
  IndexedMesh mesh;
  for (int i = 0; i <= facets; ++i) {
    const double at = angle * i / facets;
    for (const double y : {0.0, kLength_mm})
      mesh.vertices.emplace_back(kRadius_mm * std::cos(at), y, kRadius_mm * std::sin(at));
  }
  for (Corner i = 0; i < static_cast<Corner>(facets); ++i) {
    const Corner a = 2 * i, b = a + 1, c = a + 2, d = a + 3;
    for (TriangleCorners one : {TriangleCorners{a, b, c}, TriangleCorners{c, b, d}}) {
      if (is_hollow) std::swap(one[1], one[2]);
      mesh.triangles.push_back(one);
    }
  }
  mesh.file_triangle.resize(mesh.triangles.size());
  std::iota(mesh.file_triangle.begin(), mesh.file_triangle.end(), 0U);
  return mesh;
}

TEST(ChordError, OfAHollowCylinderIsTheSagOfItsFacets) {
  for (const int facets : {8, 20, 90}) {
    constexpr double kAngle = std::numbers::pi / 2;
    const IndexedMesh hollow = cylinder(facets, kAngle, true), round = cylinder(facets, kAngle, false);
    const double sag_mm = 50 * (1 - std::cos(kAngle / facets / 2));
    const auto middle = static_cast<std::size_t>(facets);
    EXPECT_NEAR(estimate_chord_errors_mm(hollow, hollow.file_triangle)[middle], sag_mm, 0.02 * sag_mm) << facets;
    EXPECT_EQ(estimate_chord_errors_mm(round, round.file_triangle)[middle], 0) << "a surface that bulges";
  }
}

TEST(ChordError, IsNothingAtFlatFacesAndEdgesOfThePart) {
  const IndexedMesh flat = cylinder(1, 0.1, true), sharp = cylinder(2, 2 * std::numbers::pi / 2.5, true);
  for (const IndexedMesh* mesh : {&flat, &sharp})
    for (const double error : estimate_chord_errors_mm(*mesh, mesh->file_triangle)) EXPECT_LE(error, 1e-12);
}

TEST(ChordError, CountsTrianglesByTheirIndexInTheFile) {
  IndexedMesh mesh = cylinder(8, std::numbers::pi / 2, true);
  for (std::uint32_t& index : mesh.file_triangle) index = 3 * index + 1;
  EXPECT_GT(estimate_chord_errors_mm(mesh, std::vector<std::uint32_t>{3 * 8 + 1}).front(), 0.1);
  EXPECT_LE(estimate_chord_errors_mm(mesh, std::vector<std::uint32_t>{8}).front(), 0) << "no such triangle is left";
}

}  // namespace
}  // namespace gouge::chord_error_test
