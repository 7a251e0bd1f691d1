#include "tests/bench/penetration/cell_search.h"

#include <gtest/gtest.h>

#include "tests/lib/penetration/random_points.h"
#include "tests/support/solids.h"

namespace gouge::cell_search_test {
namespace {

TEST(CellSearch, FindsWhatTheTreesFind) {
  const PointBody points = build_point_body(shapes::refined(shapes::star_prism(), 3).vertices);
  for (const IndexedMesh& mesh : {shapes::slotted_block(), shapes::bumpy_sphere(), shapes::needle_fan(60)}) {
    DepthBodyOptions options;
    options.depth_mm = 1;
    const DepthBody body = build_depth_body(Surface(IndexedMesh(mesh)), options);
    const CellBody cell_body(body);
    CellSearch cells(cell_body, points);
    PenetrationFinder trees(body, points);
    RandomPoints random(body.mesh(), 1, 4);
    std::size_t inside = 0, apart = 0;
    for (int i = 0; i < 200; ++i) {
      RigidTransform pose = random.pose(10);
      pose.shift = 1.2 * random.next() - pose.rotation * Vec3(4, 4, 4);
      if (i % 4 == 0) pose.shift += 60 * random.direction();
      const PenetrationResult& a = cells.find(pose);
      const PenetrationResult& b = trees.find(pose);
      ASSERT_EQ(a.contacts.size(), b.contacts.size()) << mesh.name << " pose " << i;
      (a.contacts.empty() ? apart : inside) += 1;
      for (std::size_t k = 0; k < a.contacts.size(); ++k) {
        EXPECT_EQ(a.contacts[k].point, b.contacts[k].point);
        EXPECT_NEAR(a.contacts[k].contact.depth_mm, b.contacts[k].contact.depth_mm, 1e-12 * (1 + pose.shift.norm()));
        EXPECT_EQ(a.contacts[k].is_deeper, b.contacts[k].is_deeper);
      }
    }
    EXPECT_GT(inside, 20U) << mesh.name;
    EXPECT_GT(apart, 5U) << mesh.name;
  }
}

}  // namespace
}  // namespace gouge::cell_search_test
