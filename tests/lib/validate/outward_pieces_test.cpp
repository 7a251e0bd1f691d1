#include "lib/validate/outward_pieces.h"

#include <gtest/gtest.h>

#include <cmath>

#include "lib/validate/cgal_bridge.h"
#include "lib/validate/validate_mesh.h"
#include "tests/support/scatter.h"
#include "tests/support/shapes.h"

namespace gouge::detail {
namespace {

IndexedMesh random_piece(test::Scatter& random) {
  const double size = std::pow(10, random.in(-2, 1));
  IndexedMesh piece =
      random.is(0.5) ? shapes::sphere(size, 5, 8) : shapes::box(Vec3::Constant(-size), Vec3::Constant(size));
  if (random.is(0.3)) piece = shapes::inside_out(piece);
  return shapes::moved(piece, random.is(0.3) ? Vec3::Zero() : Vec3(random.point(40)));
}

TEST(OutwardPieces, AgreeWithCgalWhereTheyAreDecided) {
  int decided = 0, left_open = 0;
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
    const auto outward = face_all_pieces_outward(mesh, pieces);
    ++(outward ? decided : left_open);
    EXPECT_EQ(outward.value_or(facts.bounds_volume), facts.bounds_volume) << seed;
  }
  EXPECT_GT(decided, 100);
  EXPECT_GT(left_open, 20);
}

TEST(OutwardPieces, ArePerhapsNestedWhenABoxIsInAnother) {
  EXPECT_EQ(face_all_pieces_outward(shapes::hollow_cube(), 2), std::nullopt);
  EXPECT_EQ(face_all_pieces_outward(shapes::cube(), 1), true);
  EXPECT_EQ(face_all_pieces_outward(shapes::inside_out(shapes::cube()), 1), false);
}

// The volume of a speck far from the middle of the mesh drowns in rounding.
TEST(OutwardPieces, AreLeftOpenWhereRoundingHidesTheVolume) {
  const IndexedMesh speck = shapes::moved(shapes::cube(1e-7), Vec3::Constant(1e6));
  EXPECT_EQ(face_all_pieces_outward(shapes::joined(shapes::cube(), speck), 2), std::nullopt);
}

}  // namespace
}  // namespace gouge::detail
