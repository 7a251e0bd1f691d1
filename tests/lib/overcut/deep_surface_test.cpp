#include <array>

#include <gtest/gtest.h>

#include "lib/overcut/deep_surface.h"
#include "lib/tool/convex_cover.h"
#include "lib/tool/evaluate.h"
#include "tests/support/motions.h"
#include "tests/support/scatter.h"
#include "tests/support/shapes.h"
#include "tests/support/tools.h"

namespace gouge::deep_surface_test {
namespace {

/// Returns axes that are turned at random.
Eigen::Matrix3d random_frame(test::Scatter& random) {
  Eigen::Matrix3d frame;
  frame.row(0) = random.direction();
  frame.row(1) = Vec3(frame.row(0)).unitOrthogonal();
  frame.row(2) = Vec3(frame.row(0)).cross(Vec3(frame.row(1)));
  return frame;
}

Box3 whole(const std::vector<Box3>& boxes) {
  Box3 all;
  for (const Box3& box : boxes) all.extend(box);
  return all;
}

struct Scene {
  IndexedMesh part = shapes::moved(shapes::sphere(30, 20, 40), Vec3(0, 0, -30));
  BlockTree tree = build_block_tree({&part, 1}, 1);
};

TEST(DeepSurface, HasAllPointsThatAreDeeperAtSomeInstant) {
  const Scene scene;
  test::Scatter random(47);
  const std::array<ToolVariants, 4> all = {tools::ball(10), tools::flat(10), tools::bull(16, 2), tools::necked()};
  std::size_t deep = 0;
  for (int k = 0; k < 200; ++k) {
    const CompiledTool& tool = all[random.below(all.size())].bare;
    const double lean = random.in(0, 0.4);
    const Motion motion = test::straight({random.point(3), random.axis(lean)}, {random.point(3), random.axis(lean)});
    const double depth = random.in(0.05, 2);
    const Eigen::Matrix3d frame = random_frame(random);
    const Box3 box = whole(deep_surface(motion, make_convex_cover(tool), scene.tree, frame, depth, random.in(0.05, 1)));
    for (int n = 0; n < 4000; ++n) {
      const std::array<Vec3, 3> corners =
          scene.tree.corners(static_cast<std::uint32_t>(random.below(scene.part.triangles.size())));
      const double a = random.in(0, 1), b = random.in(0, 1 - a);
      const Vec3 point = corners[0] + a * (corners[1] - corners[0]) + b * (corners[2] - corners[0]);
      if (!(-signed_distance_mm(tool, motion.at(random.in(0, 1)), point) > depth)) continue;
      ++deep;
      EXPECT_TRUE(box.contains(Vec3(frame * point))) << "in trial " << k;
    }
  }
  EXPECT_GT(deep, 2000U);
}

TEST(DeepSurface, IsLittleMoreThanTheDeepPoints) {
  // A ball of radius 5 dips 0.5 mm into a plane. The points deeper than 0.4 mm lie within a disc of radius r, where
  // r^2 = 4.6^2 - 4.5^2.
  const IndexedMesh part = shapes::box(Vec3(-50, -50, -20), Vec3(50, 50, 0));
  const BlockTree tree = build_block_tree({&part, 1}, 1);
  const Pose dip{Vec3(0.3, 0.2, -0.5), Vec3::UnitZ()};
  const ToolVariants tool = tools::ball(10);
  const Box3 box = whole(deep_surface(test::straight(dip, dip), make_convex_cover(tool.bare), tree,
                                      Eigen::Matrix3d::Identity(), 0.4, 0.1));
  const double radius = std::sqrt(4.6 * 4.6 - 4.5 * 4.5);
  EXPECT_NEAR(box.max().x(), 0.3 + radius, 0.15);
  EXPECT_NEAR(box.min().y(), 0.2 - radius, 0.15);
  EXPECT_NEAR(box.min().z(), 0, 1e-3);
}

TEST(DeepSurface, IsEmptyIfNothingIsSoDeep) {
  const Scene scene;
  const Pose pose{Vec3(0, 0, -0.5), Vec3::UnitZ()};
  const ToolVariants tool = tools::ball(10);
  EXPECT_TRUE(whole(deep_surface(test::straight(pose, pose), make_convex_cover(tool.bare), scene.tree,
                                 Eigen::Matrix3d::Identity(), 0.6, 0.1))
                  .isEmpty());
}

}  // namespace
}  // namespace gouge::deep_surface_test
