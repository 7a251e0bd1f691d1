#include <gtest/gtest.h>

#include <cmath>

#include "lib/offset/vertex_offsets.h"
#include "tests/support/solids.h"

namespace gouge::vertex_offsets_test {
namespace {

std::vector<VertexOffset> offsets_of(const IndexedMesh& mesh) { return offset_by_planes(mesh, MeshAdjacency(mesh)); }

TEST(OffsetOfPlanes, MovesACubesCornersAlongItsDiagonals) {
  for (const VertexOffset& o : offsets_of(shapes::cube())) {
    EXPECT_NEAR(o.move.norm(), std::sqrt(3.0), 1e-12);
    EXPECT_EQ(o.planes, PlaneCase::three_planes);
  }
}

TEST(OffsetOfPlanes, NamesTheDegenerateCases) {
  const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
  const auto of = [](std::initializer_list<Vec3> normals) { return offset_of_planes(std::vector<Vec3>(normals)); };
  EXPECT_EQ(of({}).planes, PlaneCase::none);
  EXPECT_EQ(of({z, z, z}).planes, PlaneCase::one_plane);
  EXPECT_EQ(of({z, x, z}).planes, PlaneCase::two_planes);
  EXPECT_NEAR((of({z, x}).move - Vec3(1, 0, 1)).norm(), 0, 1e-12);
  EXPECT_EQ(of({x, y, z}).planes, PlaneCase::three_planes);
  EXPECT_EQ(of({x, -x}).planes, PlaneCase::knife);
  EXPECT_EQ(of({Vec3(1, 0, 1e-3).normalized(), Vec3(-1, 0, 1e-3).normalized()}).planes, PlaneCase::knife);
  EXPECT_LE(of({Vec3(1, 0, 1e-3).normalized(), Vec3(-1, 0, 1e-3).normalized()}).move.norm(), kLongestOffset + 1e-9);
  EXPECT_EQ(of({Vec3(1, 0, 1).normalized(), Vec3(0, 1, 1).normalized(), Vec3(-1, 0, 1).normalized(),
                Vec3(0, -0.5, 1).normalized()})
                .planes,
            PlaneCase::many_planes);
}

TEST(OffsetOfPlanes, KeepsEveryFaceAtTheDistanceAskedForWhereThePlanesMeet) {
  const IndexedMesh star = shapes::star_prism();
  const std::vector<VertexOffset> offsets = offsets_of(star);
  const std::vector<Vec3> normals = face_normals(star);
  for (std::size_t t = 0; t < star.triangles.size(); ++t) {
    for (const Corner c : star.triangles[t]) {
      if (offsets[c].planes != PlaneCase::three_planes) continue;
      EXPECT_NEAR(normals[t].dot(offsets[c].move), 1, 1e-9);
    }
  }
}

}  // namespace
}  // namespace gouge::vertex_offsets_test
