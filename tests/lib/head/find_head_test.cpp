#include <gtest/gtest.h>

#include "lib/head/find_head.h"
#include "tests/support/shapes.h"

namespace gouge::find_head_test {
namespace {

const std::vector<HeadBody> kHeads = {*build_head_body(shapes::box(Vec3(60, -20, 100), Vec3(120, 20, 160))),
                                      *build_head_body(shapes::box(Vec3(-120, -20, 100), Vec3(-60, 20, 160)))};

TEST(FindHead, TheDeepestIsTheOneThePointIsInOrClosestTo) {
  EXPECT_EQ(deepest_head(kHeads, Vec3(65, 0, 130)), 0U);
  EXPECT_EQ(deepest_head(kHeads, Vec3(-65, 0, 130)), 1U);
  EXPECT_EQ(deepest_head(kHeads, Vec3(-5, 0, 0)), 1U);
}

TEST(FindHead, ABuriedCoreIsInAPartOrAFixture) {
  const IndexedMesh block = shapes::box(Vec3(-200, -100, 0), Vec3(0, 100, 300));
  const RigidTransform down{Eigen::Matrix3d::Identity(), Vec3(0, 0, -10)};
  for (const Scene& scene : {Scene{{block}, {}}, Scene{{}, {block}}}) {
    const auto buried = find_buried_core(kHeads, down, scene);
    ASSERT_TRUE(buried);
    EXPECT_EQ(buried->head, 1U);
    EXPECT_TRUE(block.box().contains(buried->at));
  }
  EXPECT_FALSE(find_buried_core(kHeads, down, Scene{}));
}

}  // namespace
}  // namespace gouge::find_head_test
