#include "lib/validate/bounded_volume.h"

#include <gtest/gtest.h>

#include <cmath>

#include "lib/validate/cgal_bridge.h"
#include "lib/validate/validate_mesh.h"
#include "tests/support/scatter.h"
#include "tests/support/shapes.h"

namespace gouge::detail::bounded_volume_test {
namespace {

IndexedMesh random_piece(test::Scatter& random) {
  const double size = std::pow(10, random.in(-2, 1));
  IndexedMesh piece =
      random.is(0.5) ? shapes::sphere(size, 5, 8) : shapes::box(Vec3::Constant(-size), Vec3::Constant(size));
  if (random.is(0.3)) piece = shapes::inside_out(piece);
  return shapes::moved(piece, random.is(0.3) ? Vec3::Zero() : Vec3(random.point(40)));
}

TEST(BoundedVolume, AgreesWithCgal) {
  int bounding = 0, not_bounding = 0, left_open = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    test::Scatter random(seed);
    IndexedMesh mesh = random_piece(random);
    std::size_t pieces = 1;
    for (; random.is(0.6); ++pieces) mesh = shapes::joined(mesh, random_piece(random));
    const MeshValidation judged = validate_mesh(mesh, find_mesh_findings(mesh));
    if (judged.self_intersections.pairs > 0) continue;
    const VolumeFacts facts = find_volume_facts(mesh).value();
    EXPECT_EQ(judged.bounds_volume, facts.bounds_volume) << seed;
    EXPECT_EQ(signed_volume(mesh), facts.volume_mm3) << seed;  // to the last bit
    const auto found = does_bound_volume(mesh, pieces);
    ++(!found ? left_open : *found ? bounding : not_bounding);
    EXPECT_EQ(found.value_or(facts.bounds_volume), facts.bounds_volume) << seed;
  }
  EXPECT_GT(bounding, 50);
  EXPECT_GT(not_bounding, 50);
  EXPECT_LT(left_open, 20);
}

TEST(BoundedVolume, LiesBetweenAShellAndItsCavity) {
  const IndexedMesh solid = shapes::cube(),
                    cavity = shapes::inside_out(shapes::box(Vec3::Constant(3), Vec3::Constant(6)));
  EXPECT_EQ(does_bound_volume(solid, 1), true);
  EXPECT_EQ(does_bound_volume(shapes::inside_out(solid), 1), false);
  EXPECT_EQ(does_bound_volume(shapes::joined(solid, cavity), 2), true);
  EXPECT_EQ(does_bound_volume(shapes::joined(solid, shapes::inside_out(cavity)), 2), false);
  const IndexedMesh core = shapes::moved(shapes::tetrahedron(0.5), Vec3::Constant(4));
  EXPECT_EQ(does_bound_volume(shapes::joined(shapes::joined(solid, cavity), core), 3), true);
  EXPECT_EQ(does_bound_volume(shapes::joined(core, shapes::joined(cavity, shapes::inside_out(solid))), 3), false);
}

// The volume of a speck far from the middle of the mesh drowns in rounding.
TEST(BoundedVolume, IsLeftOpenWhereRoundingHidesAPiece) {
  const IndexedMesh speck = shapes::moved(shapes::cube(1e-7), Vec3::Constant(1e6));
  EXPECT_EQ(does_bound_volume(shapes::joined(shapes::cube(), speck), 2), std::nullopt);
}

}  // namespace
}  // namespace gouge::detail::bounded_volume_test
