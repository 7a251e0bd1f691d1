#include "lib/validate/triangle_filter.h"

#include <gtest/gtest.h>

namespace gouge::detail::triangle_filter_test {
namespace {

using Corners = std::array<Vec3, 3>;

const Corners kFlat = {Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};

TEST(TriangleFilter, KnowsTrianglesWithArea) {
  EXPECT_TRUE(surely_has_area(kFlat));
  EXPECT_FALSE(surely_has_area({Vec3(0.1, 0.1, 0.1), Vec3(0.2, 0.2, 0.2), Vec3(0.3, 0.3, 0.3)}));
  EXPECT_FALSE(surely_has_area({Vec3(0, 0, 0), Vec3(1e-170, 0, 0), Vec3(0, 1e-170, 0)}));  // products underflow
}

TEST(TriangleFilter, KnowsTrianglesApartAboveAndBesideEachOther) {
  EXPECT_TRUE(are_surely_apart(kFlat, {Vec3(1, 1, 1e-9), Vec3(2, 1, 1), Vec3(1, 2, 1)}));
  EXPECT_TRUE(are_surely_apart(kFlat, {Vec3(3, 3, 0), Vec3(4, 3, 0), Vec3(3, 4, 0)}));   // in one plane
  EXPECT_FALSE(are_surely_apart(kFlat, {Vec3(2, 2, 0), Vec3(4, 3, 0), Vec3(3, 4, 0)}));  // touch
  EXPECT_FALSE(are_surely_apart(kFlat, {Vec3(1, 1, -1), Vec3(1, 1, 1), Vec3(2, 1, 1)}));
}

TEST(TriangleFilter, KnowsNeighboursAtACornerInOnePlane) {
  EXPECT_TRUE(share_surely_one_corner(kFlat, {Vec3(0, 0, 0), Vec3(-4, 0, 0), Vec3(0, -4, 0)}));
  EXPECT_TRUE(share_surely_one_corner(kFlat, {Vec3(0, 0, 0), Vec3(-1, 9, 0), Vec3(-4, -0.1, 0)}));
  EXPECT_FALSE(share_surely_one_corner(kFlat, {Vec3(0, 0, 0), Vec3(1, 1, 0), Vec3(-4, 0, 0)}));
  EXPECT_FALSE(share_surely_one_corner(kFlat, {Vec3(0, 0, 0), Vec3(9, 9, 1), Vec3(9, 9, -1)}));
}

TEST(TriangleFilter, KnowsNeighboursAtASideThatAreNotFoldedFlat) {
  EXPECT_TRUE(share_surely_one_side(kFlat, {Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(1, -1, 0)}));
  EXPECT_TRUE(share_surely_one_side(kFlat, {Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(1, 1, 1e-9)}));
  EXPECT_FALSE(share_surely_one_side(kFlat, {Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(1, 1, 0)}));
}

}  // namespace
}  // namespace gouge::detail::triangle_filter_test
