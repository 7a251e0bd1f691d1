// Compares the bounds of a cover with the mesh itself.
#include "lib/head/revolved_cover.h"

#include <gtest/gtest.h>

#include <cmath>

#include "lib/surface/surface.h"
#include "tests/support/revolved_heads.h"
#include "tests/support/scatter.h"

namespace gouge::revolved_cover_test {
namespace {

/// How many of the claims spoke, so that a cover that never claims anything is seen.
struct Claims {
  std::size_t outside = 0, feet = 0, ends = 0, distance = 0;
};

Vec2 turned(const Vec3& q) { return {q.head<2>().norm(), q.z()}; }

void expect_claims_hold(const ConvexCover& cover, const Surface& surface, const Vec3& at, Claims& claims) {
  const Vec2 q = turned(at);
  const double depth = -surface.closest_point(at)->signed_mm();
  double nearest = 1e300;
  for (const CoverPiece& piece : cover.pieces) {
    const double f = cover_distance(piece, q);
    nearest = std::min(nearest, std::max({f, piece.z_lo_mm - q.y(), q.y() - piece.z_hi_mm}));
    if (q.y() < piece.z_lo_mm || q.y() > piece.z_hi_mm) continue;
    if (f >= 0) {
      ++claims.outside;
      ASSERT_LE(depth, 1e-9) << at.transpose();
    } else if ((q.y() + f > piece.foot_lo_mm || q.x() >= piece.r_closed_mm) && q.y() - f < piece.foot_hi_mm) {
      ++claims.feet;
      ASSERT_LE(depth, -f + 1e-9) << at.transpose();
    }
    const bool has_below = q.x() >= piece.r_below_mm, has_above = q.x() >= piece.r_above_mm;
    ASSERT_LE(depth, (has_below ? q.y() - piece.z_lo_mm : 1e300) + 1e-9) << at.transpose();
    ASSERT_LE(depth, (has_above ? piece.z_hi_mm - q.y() : 1e300) + 1e-9) << at.transpose();
    claims.ends += has_below || has_above ? 1 : 0;
  }
  if (nearest > 0) {
    ++claims.distance;
    ASSERT_LE(nearest, -depth + 1e-9) << at.transpose();
  }
}

TEST(RevolvedCover, ClaimsNoMoreThanTheMesh) {
  for (const IndexedMesh& mesh : test::heads_around_the_axis()) {
    SCOPED_TRACE(mesh.name);
    const ConvexCover cover = make_revolved_cover(mesh);
    ASSERT_FALSE(cover.pieces.empty());
    EXPECT_DOUBLE_EQ(cover.pieces.front().z_lo_mm, mesh.box().min().z());
    EXPECT_DOUBLE_EQ(cover.pieces.back().z_hi_mm, mesh.box().max().z());
    const Surface surface(mesh);
    test::Scatter random(3);
    Claims claims;
    for (int i = 0; i < 20000 && !::testing::Test::HasFailure(); ++i) {
      // Around it, and close to its facets on either side.
      Vec3 at = 30 * random.point(1) + Vec3(0, 0, 26);
      if (i % 2 == 0) {
        const std::size_t t = random.below(mesh.triangles.size());
        const double u = random.in(0, 1), v = random.in(0, 1 - u);
        at = mesh.corner(t, 0) + u * (mesh.corner(t, 1) - mesh.corner(t, 0)) +
             v * (mesh.corner(t, 2) - mesh.corner(t, 0)) + std::pow(10, random.in(-9, 0.5)) * random.point(1);
      }
      expect_claims_hold(cover, surface, at, claims);
    }
    EXPECT_GT(claims.outside, 100u);
    EXPECT_GT(claims.feet, 100u);
    EXPECT_GT(claims.ends, 100u);
    EXPECT_GT(claims.distance, 100u);
  }
}

TEST(RevolvedCover, HoldsEveryVertexAndFacet) {
  for (const IndexedMesh& mesh : test::heads_around_the_axis()) {
    const ConvexCover cover = make_revolved_cover(mesh);
    test::Scatter random(4);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      for (int i = 0; i < 20; ++i) {
        const double u = i == 0 ? 0 : random.in(0, 1), v = i == 0 ? 0 : random.in(0, 1 - u);
        const Vec2 q = turned(mesh.corner(t, 0) + u * (mesh.corner(t, 1) - mesh.corner(t, 0)) +
                              v * (mesh.corner(t, 2) - mesh.corner(t, 0)));
        double least = 1e300;
        for (const CoverPiece& piece : cover.pieces) {
          if (q.y() >= piece.z_lo_mm - 1e-9 && q.y() <= piece.z_hi_mm + 1e-9)
            least = std::min(least, cover_distance(piece, q));
        }
        ASSERT_LE(least, 1e-9) << mesh.name << ", triangle " << t;
      }
    }
  }
}

TEST(RevolvedCover, IsTightAroundWhatIsRound) {
  // No point of the cover is farther from a rounded cylinder than its chords lie off the circles.
  const IndexedMesh mesh = test::heads_around_the_axis().front();
  const ConvexCover cover = make_revolved_cover(mesh);
  ASSERT_EQ(cover.pieces.size(), 1u);
  EXPECT_GT(cover_distance(cover.pieces[0], {16.03, 25}), 0);
  EXPECT_GT(cover_distance(cover.pieces[0], {5, 4.97}), 0);
  EXPECT_GT(cover_distance(cover.pieces[0], {10 + 6.05 * std::sqrt(0.5), 11 - 6.05 * std::sqrt(0.5)}), 0);
}

TEST(RevolvedCover, TakesAPieceForTheNeckOfASpindle) {
  // Beside the neck, between the nose and the flange, there is room.
  const IndexedMesh mesh = test::heads_around_the_axis()[1];
  bool is_free = false;
  for (const CoverPiece& piece : make_revolved_cover(mesh).pieces)
    is_free = is_free || (piece.z_lo_mm < 15 && piece.z_hi_mm > 15 && cover_distance(piece, {10, 15}) > 0);
  EXPECT_TRUE(is_free);
}

TEST(RevolvedCover, ClaimsNothingOfWhatIsBesideTheAxis) {
  EXPECT_TRUE(make_revolved_cover(shapes::box({60, -20, 100}, {120, 20, 160})).pieces.empty());
  EXPECT_TRUE(make_revolved_cover(shapes::torus(200, 5, 24, 12)).pieces.empty());
}

}  // namespace
}  // namespace gouge::revolved_cover_test
