#include "lib/hierarchy/column_height.h"

#include <gtest/gtest.h>

#include "tests/support/scatter.h"
#include "tests/support/shapes.h"

namespace gouge::column_height_test {
namespace {

std::optional<double> highest(const std::vector<IndexedMesh>& meshes, const Column& column, double enough) {
  return highest_in_column(build_block_tree(meshes), column, enough, enough);
}

TEST(ColumnHeight, OfAPlaneFaceIsExact) {
  const std::vector<IndexedMesh> block = {shapes::box(Vec3(-50, -50, -60), Vec3(50, 50, 0))};
  const Column upright{Vec3(1, 2, -3), Vec3::UnitZ(), 4, -4, 10};
  EXPECT_NEAR(highest(block, upright, 3 + 1e-7).value_or(-1), 3, 1e-8);
  EXPECT_NEAR(highest(block, upright, 5).value_or(-1), 3, 1e-3) << "a node of the tree is enough";
  EXPECT_FALSE(highest(block, upright, 2.9).has_value()) << "more than enough";
  const Vec3 leaning = Vec3(0.6, 0, 0.8);
  const Column across{Vec3(0, 0, -1), leaning, 2, -3, 10};
  // The plane is 1 / 0.8 along the axis, and rises from there by 0.75 for each mm across.
  EXPECT_NEAR(highest(block, across, 2.75 + 1e-7).value_or(-1), 1.25 + 1.5, 1e-8);
}

TEST(ColumnHeight, LeavesOutWhatIsBelowAboveAndBeside) {
  const std::vector<IndexedMesh> meshes = {shapes::box(Vec3(-5, -5, -6), Vec3(5, 5, 0)),
                                           shapes::box(Vec3(-5, -5, 2), Vec3(5, 5, 3))};
  const Column column{Vec3(0, 0, 0), Vec3::UnitZ(), 1, -1, 1};
  EXPECT_NEAR(highest(meshes, column, 1).value_or(-1), 0, 1e-3);
  Column high = column;
  high.high_mm = 2.5;
  EXPECT_NEAR(highest(meshes, high, 2 + 1e-7).value_or(-1), 2, 1e-8);
  EXPECT_FALSE(highest(meshes, high, 1).has_value());
  Column beside = column;
  beside.through = Vec3(6.5, 0, 0);
  EXPECT_DOUBLE_EQ(highest(meshes, beside, 1).value_or(0), -1) << "nothing: the column's lower end";
}

TEST(ColumnHeight, IsExceededByNoPointOfTheSurface) {
  test::Scatter random(11);
  std::size_t proved = 0, tight = 0;
  for (int k = 0; k < 400; ++k) {
    std::vector<IndexedMesh> meshes = {k % 3 == 0   ? shapes::torus(20, 7, 24, 12)
                                       : k % 3 == 1 ? shapes::sphere(15, 12, 24)
                                                    : shapes::box(Vec3(-9, -8, -7), Vec3(9, 8, 7))};
    const IndexedMesh& mesh = meshes[0];
    Column column;
    const std::size_t near = random.below(mesh.triangles.size());
    column.through = mesh.corner(near, 0) + random.point(2);
    column.direction = random.direction();
    column.radius_mm = random.in(0.01, 3);
    column.low_mm = -random.in(0, 6);
    column.high_mm = random.in(0, 6);
    const double enough = random.in(column.low_mm, column.high_mm);
    const std::optional<double> height = highest(meshes, column, enough);
    double seen = -1e300;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      for (int n = 0; n < 40; ++n) {
        double u = random.in(0, 1), v = random.in(0, 1);
        if (u + v > 1) u = 1 - u, v = 1 - v;
        const Vec3 x = mesh.corner(t, 0) + u * (mesh.corner(t, 1) - mesh.corner(t, 0)) +
                       v * (mesh.corner(t, 2) - mesh.corner(t, 0)) - column.through;
        const double at = column.direction.dot(x);
        const bool is_in =
            at >= column.low_mm && at <= column.high_mm && (x - at * column.direction).norm() <= column.radius_mm;
        if (is_in) seen = std::max(seen, at);
      }
    }
    if (!height) continue;
    ++proved;
    EXPECT_LE(*height, enough);
    EXPECT_LE(seen, *height + 1e-9) << k;
    tight += seen > *height - 0.3 ? 1U : 0U;
  }
  EXPECT_GT(proved, 100U);
  EXPECT_GT(tight, 20U);
}

}  // namespace
}  // namespace gouge::column_height_test
