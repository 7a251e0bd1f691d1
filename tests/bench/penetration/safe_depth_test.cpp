#include <gtest/gtest.h>

#include "tests/bench/penetration/normal_methods.h"
#include "tests/bench/penetration/safe_depth.h"
#include "tests/support/solids.h"

namespace gouge::safe_depth_test {
namespace {

DepthBody body_of(const IndexedMesh& mesh, decltype(&offset_by_planes) normals = &offset_by_planes) {
  DepthBodyOptions options;
  options.offset_vertices = normals;
  return build_depth_body(Surface(IndexedMesh(mesh)), options);
}

/// Returns whether an edge of one triangle passes through the inside of another.
bool do_cross(const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b) {
  const Vec3 n = (b[1] - b[0]).cross(b[2] - b[0]);
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 &p = a[k], &q = a[(k + 1) % 3];
    const double hp = n.dot(p - b[0]), hq = n.dot(q - b[0]);
    if (!(hp * hq < 0)) continue;
    const Vec3 x = p + hp / (hp - hq) * (q - p);
    bool is_in = true;
    for (std::size_t i = 0; i < 3; ++i)
      is_in = is_in && n.dot((b[(i + 1) % 3] - b[i]).cross(x - b[i])) > 1e-9 * n.squaredNorm();
    if (is_in) return true;
  }
  return false;
}

bool does_offset_cross(const DepthBody& body, double depth) {
  std::vector<std::array<Vec3, 3>> offset;
  for (const TriangleCorners& t : body.mesh().triangles) {
    offset.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) offset.back()[k] = body.mesh().vertices[t[k]] - depth * body.offsets[t[k]].move;
  }
  for (std::size_t i = 0; i < offset.size(); ++i) {
    for (std::size_t j = 0; j < offset.size(); ++j) {
      if (i != j && do_cross(offset[i], offset[j])) return true;
    }
  }
  return false;
}

TEST(SafeDepth, OfAPlateIsHalfItsThickness) {
  const SafeDepth safe = largest_safe_depth(body_of(shapes::box(Vec3(0, 0, 0), Vec3(40, 40, 4))), 100);
  EXPECT_LE(safe.depth_mm, 2);
  EXPECT_GE(safe.depth_mm, 1.8);
}

TEST(SafeDepth, OfAFineMeshEndsWhereTheStripAtAnEdgeIsEatenUp) {
  // The plate's sides are cut into strips 1 high; the mitre of the upper edge comes down by the depth.
  const DepthBody plate = body_of(shapes::refined(shapes::box(Vec3(0, 0, 0), Vec3(40, 40, 4)), 2));
  const SafeDepth safe = largest_safe_depth(plate, 100);
  EXPECT_EQ(safe.limit, SafeDepthLimit::collapse);
  EXPECT_NEAR(safe.depth_mm, 1, 1e-9);
}

TEST(SafeDepth, OfASphereIsNearItsRadiusAndNotAboveIt) {
  const SafeDepth safe = largest_safe_depth(body_of(shapes::sphere(10, 16, 32), &offset_averaged), 100);
  EXPECT_LE(safe.depth_mm, 10.2);
  EXPECT_GT(safe.depth_mm, 3) << static_cast<int>(safe.limit) << " at " << safe.triangle;
}

TEST(SafeDepth, OfASlottedBlockIsHalfItsWall) {
  const SafeDepth safe = largest_safe_depth(body_of(shapes::slotted_block(1)), 100);
  EXPECT_LE(safe.depth_mm, 0.5 + 1e-9);
  EXPECT_GE(safe.depth_mm, 0.4);
}

TEST(SafeDepth, IsWhatWasAskedWhereThatIsSmall) {
  const SafeDepth safe = largest_safe_depth(body_of(shapes::torus(20, 5, 48, 24)), 0.05);
  EXPECT_EQ(safe.limit, SafeDepthLimit::asked);
  EXPECT_DOUBLE_EQ(safe.depth_mm, 0.05);
}

TEST(SafeDepth, OffsetsToItDoNotCrossThemselves) {
  for (const IndexedMesh& mesh : {shapes::slotted_block(), shapes::star_prism(), shapes::torus(20, 5, 24, 12)}) {
    const DepthBody body = body_of(mesh);
    const SafeDepth safe = largest_safe_depth(body, 100);
    EXPECT_GT(safe.depth_mm, 0.05) << mesh.name;
    EXPECT_FALSE(does_offset_cross(body, 0.98 * safe.depth_mm)) << mesh.name << " at " << safe.depth_mm;
    std::cout << mesh.name << ": safe to " << safe.depth_mm << " mm, limit " << static_cast<int>(safe.limit) << "\n";
  }
}

TEST(SafeDepth, TheCrossingTestSeesCrossings) {
  const DepthBody two = body_of(shapes::cubes_crossing());
  EXPECT_TRUE(does_offset_cross(two, 0.1));
}

}  // namespace
}  // namespace gouge::safe_depth_test
