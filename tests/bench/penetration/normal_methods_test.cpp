#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "tests/bench/penetration/normal_methods.h"
#include "tests/bench/penetration/paraboloid.h"
#include "tests/support/solids.h"

namespace gouge::normal_methods_test {
namespace {

std::vector<VertexOffset> offsets_of(const IndexedMesh& mesh, decltype(&offset_averaged) method) {
  return method(mesh, MeshAdjacency(mesh));
}

TEST(AveragedNormals, AreEquiangularWhereThatExists) {
  const IndexedMesh star = shapes::star_prism();
  const MeshAdjacency adjacency(star);
  const std::vector<Vec3> normals = face_normals(star);
  const std::vector<VertexOffset> offsets = offset_averaged(star, adjacency);
  std::size_t seen = 0;
  for (Corner v = 0; v < offsets.size(); ++v) {
    EXPECT_NEAR(offsets[v].move.norm(), 1, 1e-12);
    if (offsets[v].planes != PlaneCase::three_planes) continue;
    ++seen;
    const auto faces = adjacency.triangles_of_vertex(v);
    for (const std::uint32_t t : faces)
      EXPECT_NEAR(normals[t].dot(offsets[v].move), normals[faces[0]].dot(offsets[v].move), 1e-9);
  }
  EXPECT_GT(seen, 10U);
}

TEST(AveragedNormals, AreAngleWeightedSoThatCuttingAFaceChangesNothing) {
  // A pyramid's apex with five faces in no common cone: no equiangular vector.
  IndexedMesh fan;
  fan.vertices = {Vec3(0, 0, 3), Vec3(5, 0, 0), Vec3(3, 4, 1), Vec3(-4, 3, 0), Vec3(-3, -4, 0.5), Vec3(4, -4, 0)};
  for (std::size_t i = 0; i < 5; ++i) shapes::add_triangle(fan, 0, 1 + i, 1 + (i + 1) % 5);
  const VertexOffset whole = offsets_of(fan, &offset_averaged)[0];
  EXPECT_EQ(whole.planes, PlaneCase::many_planes);
  IndexedMesh cut = fan;
  cut.vertices.push_back(0.3 * fan.vertices[1] + 0.7 * fan.vertices[2]);
  cut.triangles[0] = {0, 1, 6};
  shapes::add_triangle(cut, 0, 6, 2);
  EXPECT_NEAR((offsets_of(cut, &offset_averaged)[0].move - whole.move).norm(), 0, 1e-12);
}

/// Largest angle to the true normals, over the vertices at least `from_pole` off the poles.
double worst_error(const IndexedMesh& mesh, const std::function<Vec3(const Vec3&)>& truth, double from_pole) {
  const std::vector<VertexOffset> offsets = offsets_of(mesh, &offset_by_paraboloid);
  double worst = 0;
  for (std::size_t v = 0; v < offsets.size(); ++v) {
    const Vec3& p = mesh.vertices[v];
    if (std::sqrt(p.x() * p.x() + p.y() * p.y()) < from_pole) continue;
    worst = std::max(worst, (offsets[v].move - truth(p)).norm());
  }
  return worst;
}

TEST(ParaboloidNormals, HaveAnErrorOfSecondOrderOrBetterOnSphereAndTorus) {
  const auto on_sphere = [](const Vec3& p) { return p.normalized(); };
  const auto on_torus = [](const Vec3& p) {
    const Vec3 ring = 20 * Vec3(p.x(), p.y(), 0).normalized();
    return Vec3((p - ring).normalized());
  };
  const double sphere1 = worst_error(shapes::sphere(10, 16, 32), on_sphere, 3);
  const double sphere2 = worst_error(shapes::sphere(10, 32, 64), on_sphere, 3);
  const double torus1 = worst_error(shapes::torus(20, 5, 48, 24), on_torus, 0);
  const double torus2 = worst_error(shapes::torus(20, 5, 96, 48), on_torus, 0);
  std::cout << "sphere " << sphere1 << " -> " << sphere2 << ", torus " << torus1 << " -> " << torus2 << "\n";
  EXPECT_LT(sphere2, sphere1 / 3.5);
  EXPECT_LT(torus2, torus1 / 3.5);
  EXPECT_LT(torus2, 0.01);
}

TEST(ParaboloidNormals, FollowTheGuessWhereThereIsNothingToFit) {
  EXPECT_EQ(paraboloid_normal(Vec3::Zero(), {}, Vec3::UnitZ()), Vec3(Vec3::UnitZ()));
}

TEST(CollapseDepth, IsTheRadiusOnASphereAndNeverOnAHollow) {
  const IndexedMesh ball = shapes::sphere(10, 40, 80);
  const std::vector<VertexOffset> offsets = offsets_of(ball, &offset_averaged);
  const std::size_t middle = ball.triangles.size() / 2;
  EXPECT_NEAR(collapse_depth_mm(ball, offsets, middle), 10, 0.1);
  const IndexedMesh hollow = shapes::inside_out(ball);
  EXPECT_TRUE(std::isinf(collapse_depth_mm(hollow, offsets_of(hollow, &offset_averaged), middle)));
}

TEST(CollapseDepth, OfACubeIsHalfItsSide) {
  const IndexedMesh cube = shapes::cube(10);
  const std::vector<VertexOffset> offsets = offsets_of(cube, &offset_by_planes);
  for (std::size_t t = 0; t < 12; ++t) EXPECT_NEAR(collapse_depth_mm(cube, offsets, t), 5, 1e-9);
}

}  // namespace
}  // namespace gouge::normal_methods_test
