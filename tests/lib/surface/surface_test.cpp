#include "lib/surface/surface.h"

#include <gtest/gtest.h>

#include "lib/mesh/opposite_half_edges.h"
#include "tests/support/scatter.h"
#include "tests/support/shapes.h"
#include "tests/support/solids.h"

namespace gouge::surface_test {
namespace {

TEST(Surface, TellsTheSideOfAPointAsTheWindingNumberDoes) {
  test::Scatter random(1);
  for (const IndexedMesh& mesh :
       {shapes::cube(), shapes::torus(), shapes::star_prism(), shapes::bumpy_sphere(), shapes::hollow_cube(),
        shapes::needle_fan(), shapes::cubes_touching_at_edge(), shapes::cubes_touching_at_vertex()}) {
    const Surface surface(mesh);
    ASSERT_TRUE(surface.is_solid()) << mesh.name;
    const Box3 box = mesh.box();
    for (int i = 0; i < 400; ++i) {
      const Vec3& vertex = mesh.vertices[random.next() % mesh.vertices.size()];
      const Vec3 point = i % 2 == 0 ? Vec3(box.center() + random.point(box.sizes().maxCoeff()))
                                    : Vec3(vertex + random.in(0, 0.3) * box.sizes().norm() * random.direction());
      const ClosestPoint foot = *surface.closest_point(point);
      if (foot.distance_mm < 1e-9) continue;
      EXPECT_EQ(foot.is_inside, is_inside({&mesh, 1}, point)) << mesh.name << " " << point.transpose();
      // Out of the body along the line to or from the point.
      EXPECT_NEAR((point - foot.point - foot.signed_mm() * foot.normal).norm(), 0, 1e-9);
    }
  }
}

TEST(Surface, OfWhatIsNoSolidHasNoInside) {
  const IndexedMesh mesh = shapes::open_cube(10);
  const Surface surface(mesh);
  EXPECT_FALSE(surface.is_solid());
  const ClosestPoint foot = *surface.closest_point(Vec3(5, 5, 1));
  EXPECT_FALSE(foot.is_inside);
  EXPECT_DOUBLE_EQ(foot.distance_mm, 1);
}

TEST(Surface, KeepsTheMeshItIsGivenForAllItsCopies) {
  std::vector<Surface> copies(3, Surface(shapes::cube(10)));
  copies.erase(copies.begin());
  EXPECT_DOUBLE_EQ(copies.back().closest_point(Vec3(5, 5, 12))->signed_mm(), 2);
  EXPECT_EQ(copies.front().mesh().triangles.size(), 12U);
}

TEST(Surface, OfATreeThatIsThereUsesIt) {
  const IndexedMesh mesh = shapes::torus();
  const BlockTree tree = build_block_tree({&mesh, 1});
  const Surface shared(mesh, tree), own(mesh);
  EXPECT_EQ(&shared.tree(), &tree);
  EXPECT_EQ(&shared.mesh(), &mesh);
  EXPECT_EQ(shared.closest_point(Vec3(3, 4, 5))->point, own.closest_point(Vec3(3, 4, 5))->point);
}

}  // namespace
}  // namespace gouge::surface_test
