#include "lib/clash/clash.h"

#include <gtest/gtest.h>

#include "tests/support/solids.h"

namespace gouge::setup_overlaps_test {
namespace {

const IndexedMesh kBlock = shapes::box(Vec3(0, 0, 0), Vec3(100, 60, 40));

std::vector<SetupOverlap> overlaps(const std::vector<IndexedMesh>& parts, const std::vector<IndexedMesh>& fixtures,
                                   std::vector<bool> is_left_out = {}) {
  is_left_out.resize(fixtures.size(), false);
  const Scene scene{parts, fixtures};
  return find_setup_overlaps(PreparedScene(scene), is_left_out, {});
}

IndexedMesh jaw(double sunk) { return shapes::box(Vec3(10, -30, 5), Vec3(90, sunk, 30)); }

TEST(SetupOverlaps, AreEveryFixtureAgainstEveryPart) {
  const IndexedMesh far = shapes::moved(kBlock, Vec3(500, 0, 0));
  const std::vector<SetupOverlap> found =
      overlaps({kBlock, far}, {jaw(-1), jaw(2), shapes::moved(jaw(3), Vec3(500, 0, 0))});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].fixture, 1U);
  EXPECT_EQ(found[0].part, 0U);
  EXPECT_NEAR(found[0].clash.depth_mm, 2, 1e-9);
  EXPECT_EQ(found[1].fixture, 2U);
  EXPECT_EQ(found[1].part, 1U);
  EXPECT_NEAR(found[1].clash.depth_mm, 3, 1e-9);
}

TEST(SetupOverlaps, LeaveOutFixturesThatTouchAndThoseThatAreAllowed) {
  EXPECT_TRUE(overlaps({kBlock}, {jaw(0), jaw(0.009), jaw(-3)}).empty());
  EXPECT_TRUE(overlaps({kBlock}, {jaw(2)}, {true}).empty());
}

TEST(SetupOverlaps, TouchingInsideEachOthersBoxesIsNoOverlapEither) {
  const IndexedMesh ring = shapes::torus(20, 5, 48, 24);
  EXPECT_TRUE(overlaps({ring}, {shapes::sphere(14.9, 24, 48)}).empty());
  EXPECT_EQ(overlaps({ring}, {shapes::sphere(17, 24, 48)}).size(), 1U);
}

TEST(SetupOverlaps, AFixtureWhollyInsideAPartIsOne) {
  const std::vector<SetupOverlap> found = overlaps({kBlock}, {shapes::moved(shapes::cube(5), Vec3(40, 30, 20))});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].clash.containment, Containment::b_in_a);
}

TEST(SetupOverlaps, OfOpenMeshesThatMeetAreNotCertified) {
  const std::vector<SetupOverlap> found =
      overlaps({shapes::open_cube(10)}, {shapes::moved(shapes::open_cube(10), Vec3(5, 5, 5))});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].clash.state, ClashState::not_certified);
}

// A cavity that reaches out of its body: the fixture is 0.02 mm deep in what is above the cavity.
TEST(SetupOverlaps, OfAPartThatCrossesItselfAreThoseOfItsBoundary) {
  const IndexedMesh part =
      shapes::joined(shapes::cube(20), shapes::inside_out(shapes::box(Vec3(2, 5, 5), Vec3(24, 15, 15))));
  const std::vector<SetupOverlap> found = overlaps({part}, {shapes::box(Vec3(17, 6, 6), Vec3(19.9, 14, 15.02))});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].clash.state, ClashState::penetrating);
  EXPECT_NEAR(found[0].clash.depth_mm, 0.02, 1e-9);
  EXPECT_LE(found[0].clash.depth_upper_mm, 0.0211);
  const std::vector<SetupOverlap> within = overlaps({part}, {shapes::box(Vec3(17, 6, 6), Vec3(19.9, 14, 14.9))});
  ASSERT_EQ(within.size(), 1U);
  EXPECT_EQ(within[0].clash.state, ClashState::not_certified) << "a cavity that reaches out proves no outside";
}

TEST(SetupOverlaps, AFixtureThatTouchesAWallInsideAPartIsInThePart) {
  const IndexedMesh part = shapes::joined(kBlock, shapes::box(Vec3(40, 20, 10), Vec3(60, 40, 20)));
  const std::vector<SetupOverlap> found = overlaps({part}, {shapes::box(Vec3(45, 25, 20), Vec3(55, 35, 30))});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].clash.state, ClashState::penetrating);
  EXPECT_EQ(found[0].clash.containment, Containment::b_in_a);
  EXPECT_NEAR(found[0].clash.depth_mm, 20, 0.01);
}

}  // namespace
}  // namespace gouge::setup_overlaps_test
