#include "lib/mesh/opposite_half_edges.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/support/shapes.h"

namespace gouge::winding_test {
namespace {

TEST(Winding, OneInsideZeroOutside) {
  const IndexedMesh cube = shapes::cube(10);
  EXPECT_NEAR(winding_number(cube, Vec3(5, 5, 5)), 1, 1e-14);
  EXPECT_NEAR(winding_number(cube, Vec3(9.999999, 9.999999, 9.999999)), 1, 1e-8);
  EXPECT_NEAR(winding_number(cube, Vec3(10.000001, 5, 5)), 0, 1e-8);
  EXPECT_NEAR(winding_number(cube, Vec3(10, 10, 10.000001)), 0, 1e-8);
  EXPECT_NEAR(winding_number(cube, Vec3(1e6, -3e6, 2e6)), 0, 1e-12);
}

TEST(Winding, PointsInTheExtendedPlaneOfAFaceAreDecidedToo) {
  EXPECT_NEAR(winding_number(shapes::cube(10), Vec3(20, 5, 10)), 0, 1e-14);
  EXPECT_NEAR(winding_number(shapes::cubes_crossing(10), Vec3(2, 2, 5)), 1, 1e-14);
}

TEST(Winding, CavitiesInsideOutAndOverlaps) {
  EXPECT_NEAR(winding_number(shapes::hollow_cube(10), Vec3(5, 5, 5)), 0, 1e-14);
  EXPECT_NEAR(winding_number(shapes::hollow_cube(10), Vec3(1, 1, 1)), 1, 1e-14);
  EXPECT_NEAR(winding_number(shapes::inside_out(shapes::cube(10)), Vec3(5, 5, 5)), -1, 1e-14);
  EXPECT_NEAR(winding_number(shapes::cubes_crossing(10), Vec3(7, 7, 7)), 2, 1e-14);
}

TEST(Winding, WholeForManyNeedlesAndManyTriangles) {
  EXPECT_NEAR(winding_number(shapes::needle_fan(20000), Vec3(0.001, 0, 0.001)), 1, 1e-10);
  EXPECT_NEAR(winding_number(shapes::sphere(10, 200, 400), Vec3(3, 4, 5)), 1, 1e-11);
  EXPECT_NEAR(winding_number(shapes::torus(20, 5), Vec3(0, 0, 0)), 0, 1e-13);
  EXPECT_NEAR(winding_number(shapes::torus(20, 5), Vec3(20, 0, 0)), 1, 1e-13);
}

TEST(Winding, AllSurfacesTogetherSayWhatIsInside) {
  const std::vector<IndexedMesh> apart = {shapes::cube(10), shapes::moved(shapes::cube(10), Vec3(30, 0, 0))};
  EXPECT_TRUE(is_inside(apart, Vec3(5, 5, 5)));
  EXPECT_TRUE(is_inside(apart, Vec3(35, 5, 5)));
  EXPECT_FALSE(is_inside(apart, Vec3(20, 5, 5)));
  EXPECT_TRUE(is_inside({&apart[1], 1}, Vec3(35, 5, 5)));
  EXPECT_FALSE(is_inside({&apart[0], 1}, Vec3(35, 5, 5)));
  const std::vector<IndexedMesh> hollow = {shapes::cube(10),
                                           shapes::inside_out(shapes::box(Vec3(2, 2, 2), Vec3(8, 8, 8)))};
  EXPECT_TRUE(is_inside(hollow, Vec3(1, 1, 1)));
  EXPECT_FALSE(is_inside(hollow, Vec3(5, 5, 5))) << "a cavity in a file of its own";
  EXPECT_TRUE(is_inside({&hollow[1], 1}, Vec3(5, 5, 5))) << "inside out";
  EXPECT_FALSE(is_inside({}, Vec3(1, 1, 1)));
}

TEST(Winding, AnOpenCubeIsNoWholeNumber) {
  const double at_centre = winding_number(shapes::open_cube(10), Vec3(5, 5, 5));
  EXPECT_NEAR(at_centre, 5.0 / 6, 1e-12);
}

TEST(Winding, TheOctantSeenFromTheOriginIsAnEighthOfTheSphere) {
  EXPECT_NEAR(solid_angle(Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ(), Vec3::Zero()), std::numbers::pi / 2, 1e-15);
  EXPECT_NEAR(solid_angle(Vec3::UnitY(), Vec3::UnitX(), Vec3::UnitZ(), Vec3::Zero()), -std::numbers::pi / 2, 1e-15);
}

}  // namespace
}  // namespace gouge::winding_test
