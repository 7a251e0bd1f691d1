#include "lib/hierarchy/surface_tree.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/support/shapes.h"

namespace gouge {
namespace {

IndexedMesh random_soup(std::size_t triangles, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> place(-100, 100), edge(-3, 3);
  IndexedMesh mesh;
  for (std::size_t t = 0; t < triangles; ++t) {
    const Vec3 a(place(random), place(random), place(random));
    for (int k = 0; k < 3; ++k) mesh.vertices.push_back(a + Vec3(edge(random), edge(random), edge(random)));
    const auto first = static_cast<Corner>(3 * t);
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.file_triangle.push_back(static_cast<std::uint32_t>(t));
  }
  return mesh;
}

TEST(SurfaceTree, BoundsHoldOnShapesAndSoups) {
  for (const IndexedMesh& mesh :
       {shapes::cube(), shapes::sphere(), shapes::torus(), shapes::needle_fan(), random_soup(3000, 1)}) {
    const SurfaceTree tree = build_surface_tree({mesh});
    EXPECT_EQ(tree.triangles.size(), mesh.triangles.size());
    const auto broken = verify_tree(tree);
    EXPECT_TRUE(broken.empty()) << broken.front();
  }
}

TEST(SurfaceTree, VerifySeesABoundThatDoesNotHold) {
  SurfaceTree tree = build_surface_tree({shapes::sphere()});
  tree.nodes[0].radius_mm *= 0.99;
  EXPECT_FALSE(verify_tree(tree).empty());
}

TEST(SurfaceTree, ManyMeshesAreOneTreeThatRemembersThem) {
  const SurfaceTree tree = build_surface_tree({shapes::cube(), shapes::tetrahedron()});
  std::size_t of_second = 0;
  for (const SurfaceTriangle& t : tree.triangles) of_second += t.mesh;
  EXPECT_EQ(of_second, 4U);
}

TEST(SurfaceTree, NothingMakesAnEmptyTree) {
  EXPECT_TRUE(build_surface_tree({}).nodes.empty());
}

TEST(SurfaceTree, EqualCentroidsStillSplit) {
  IndexedMesh mesh = shapes::tetrahedron();
  const IndexedMesh once = mesh;
  for (int k = 0; k < 100; ++k) mesh = shapes::joined(mesh, once);
  EXPECT_TRUE(verify_tree(build_surface_tree({mesh})).empty());
}

}  // namespace
}  // namespace gouge
