#include "lib/verify/solid_depth.h"

#include <gtest/gtest.h>

#include "tests/support/lattice_boxes.h"

namespace gouge::solid_depth_test {
namespace {

TEST(SolidDepth, OfRandomBoxesIsThatOfCountedCells) {
  test::Scatter random(21);
  std::size_t inside = 0, bodies = 0;
  for (int i = 0; i < 40; ++i) {
    SCOPED_TRACE(i);
    const test::LatticeBoxes boxes(random, 1 + random.below(4), i % 3 == 2);
    const Eigen::Matrix3d turn = i % 2 == 0
                                     ? Eigen::Matrix3d(Eigen::Matrix3d::Identity())
                                     : Eigen::AngleAxisd(random.in(-3, 3), random.direction()).toRotationMatrix();
    IndexedMesh mesh = boxes.mesh();
    for (Vec3& vertex : mesh.vertices) vertex = turn * vertex;
    const SolidDepth depth(mesh);
    ++bodies;
    for (int k = 0; k < 12; ++k) {
      const Vec3 at = Vec3::Constant(6) + random.point(6);
      EXPECT_NEAR(depth.at(turn * at), boxes.depth_mm(at), 1e-6) << at.transpose();
      inside += boxes.depth_mm(at) > 0 ? 1U : 0U;
    }
  }
  EXPECT_GT(inside, 10 * bodies / 3);
}

TEST(SolidDepth, IsMeasuredThroughShellsInside) {
  const IndexedMesh casing = shapes::box(Vec3::Constant(-10), Vec3::Constant(10));
  const IndexedMesh motor = shapes::box(Vec3::Constant(-4), Vec3::Constant(4));
  const IndexedMesh nested = shapes::joined(casing, motor);
  EXPECT_NEAR(SolidDepth(nested).at(Vec3(3, 0, 0)), 7, 1e-9);
  const IndexedMesh hollow = shapes::joined(casing, shapes::inside_out(motor));
  EXPECT_NEAR(SolidDepth(hollow).at(Vec3(5, 0, 0)), 1, 1e-9);
  EXPECT_NEAR(SolidDepth(hollow).at(Vec3(3, 0, 0)), 0, 1e-9);
}

}  // namespace
}  // namespace gouge::solid_depth_test
