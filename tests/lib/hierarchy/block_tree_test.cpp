#include "lib/hierarchy/block_tree.h"

#include <gtest/gtest.h>

#include <cstring>

#include "tests/support/scatter.h"
#include "tests/support/shapes.h"
#include "tests/support/verify_block_tree.h"

namespace gouge::block_tree_test {
namespace {

IndexedMesh random_soup(std::size_t triangles, unsigned seed) {
  test::Scatter random(seed);
  IndexedMesh mesh;
  for (std::size_t t = 0; t < triangles; ++t) {
    const Vec3 a = random.point(100);
    for (int k = 0; k < 3; ++k) mesh.vertices.push_back(a + random.point(3));
    const auto first = static_cast<Corner>(3 * t);
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.file_triangle.push_back(static_cast<std::uint32_t>(t));
  }
  return mesh;
}

TEST(BlockTree, BoundsHoldOnShapesAndSoups) {
  for (const IndexedMesh& mesh : {shapes::cube(), shapes::sphere(), shapes::torus(), shapes::needle_fan(),
                                  random_soup(16, 1), random_soup(17, 2), random_soup(257, 3), random_soup(5000, 4)}) {
    const BlockTree tree = build_block_tree({&mesh, 1});
    const auto broken = test::verify_tree(tree);
    EXPECT_TRUE(broken.empty()) << broken.front();
  }
}

TEST(BlockTree, BoundsHoldFarFromTheOrigin) {
  IndexedMesh mesh = random_soup(700, 5);
  for (Vec3& v : mesh.vertices) v = 1e-3 * v + Vec3(1e5, -2e5, 3e4);
  EXPECT_TRUE(test::verify_tree(build_block_tree({&mesh, 1})).empty());
}

TEST(BlockTree, VerifySeesABoundThatDoesNotHold) {
  const IndexedMesh mesh = shapes::sphere();
  BlockTree tree = build_block_tree({&mesh, 1});
  tree.nodes[0].radius_mm[0] *= 0.99F;
  EXPECT_FALSE(test::verify_tree(tree).empty());
}

TEST(BlockTree, VerifySeesATriangleThatIsLeftOut) {
  const IndexedMesh mesh = shapes::sphere();
  BlockTree tree = build_block_tree({&mesh, 1});
  tree.leaves[0].count -= 1;
  EXPECT_FALSE(test::verify_tree(tree).empty());
}

TEST(BlockTree, ManyMeshesAreOneTreeThatRemembersThem) {
  const std::vector<IndexedMesh> meshes{shapes::cube(), shapes::tetrahedron()};
  const BlockTree tree = build_block_tree(meshes);
  EXPECT_EQ(tree.mesh_of(11), 0U);
  EXPECT_EQ(tree.mesh_of(12), 1U);
  EXPECT_EQ(tree.file_triangle(13), 1U);
  EXPECT_EQ(tree.corners(13)[2], meshes[1].corner(1, 2));
}

TEST(BlockTree, NothingMakesAnEmptyTree) { EXPECT_TRUE(build_block_tree({}).nodes.empty()); }

TEST(BlockTree, EqualCentroidsStillSplit) {
  IndexedMesh mesh = shapes::tetrahedron();
  const IndexedMesh once = mesh;
  for (int k = 0; k < 100; ++k) mesh = shapes::joined(mesh, once);
  EXPECT_TRUE(test::verify_tree(build_block_tree({&mesh, 1})).empty());
}

TEST(BlockTree, TheNumberOfThreadsChangesNothing) {
  const IndexedMesh mesh = random_soup(150000, 6);
  const BlockTree one = build_block_tree({&mesh, 1}, 1);
  const BlockTree two = build_block_tree({&mesh, 1}, 2);
  ASSERT_EQ(one.leaves.size(), two.leaves.size());
  ASSERT_EQ(one.nodes.size(), two.nodes.size());
  for (std::size_t i = 0; i < one.leaves.size(); ++i) {
    ASSERT_EQ(one.leaves[i].triangle, two.leaves[i].triangle);
    ASSERT_EQ(one.leaves[i].corner, two.leaves[i].corner);
    ASSERT_EQ(one.leaves[i].count, two.leaves[i].count);
  }
  for (std::size_t i = 0; i < one.nodes.size(); ++i) {
    ASSERT_EQ(one.nodes[i].child, two.nodes[i].child);
    ASSERT_EQ(one.nodes[i].count, two.nodes[i].count);
    ASSERT_EQ(one.nodes[i].has_leaves, two.nodes[i].has_leaves);
    ASSERT_EQ(one.nodes[i].center, two.nodes[i].center);
    ASSERT_EQ(one.nodes[i].normal, two.nodes[i].normal);
    ASSERT_EQ(one.nodes[i].radius_mm, two.nodes[i].radius_mm);
    ASSERT_EQ(one.nodes[i].disc_radius_mm, two.nodes[i].disc_radius_mm);
    ASSERT_EQ(one.nodes[i].half_thickness_mm, two.nodes[i].half_thickness_mm);
  }
}

}  // namespace
}  // namespace gouge::block_tree_test
