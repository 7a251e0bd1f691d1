#include "lib/clash/clash.h"

#include <gtest/gtest.h>

#include <cmath>

#include "lib/clash/free_shift.h"
#include "tests/lib/clash/pairs.h"
#include "tests/support/solids.h"

namespace gouge::clash_test {
namespace {

using test::Pair;

Clash clash_of(const IndexedMesh& a, const IndexedMesh& b, const ClashOptions& options = {}) {
  const Pair pair(a, b);
  return find_clash(pair.a, pair.b, Vec3::Zero(), options);
}

const IndexedMesh kBlock = shapes::box(Vec3(0, 0, 0), Vec3(100, 60, 40));

TEST(Clash, OfAJawSunkInABlockIsHowFarItIsSunkIn) {
  for (const double sunk : {2.0, 0.2, 0.05}) {
    const Clash clash = clash_of(kBlock, shapes::box(Vec3(-30, -20, 40 - sunk), Vec3(130, 80, 60)));
    EXPECT_EQ(clash.state, ClashState::penetrating);
    EXPECT_NEAR(clash.depth_mm, sunk, 1e-9);
    EXPECT_NEAR(clash.depth_upper_mm, sunk, 0.00101);
    ASSERT_FALSE(clash.deepest.empty());
    EXPECT_LT((clash.deepest[0].normal - Vec3::UnitZ()).norm(), 1e-9) << "the jaw gives way upward";
  }
}

TEST(Clash, OfASheetThatEnclosesNothingIsThatInTheBlock) {
  const IndexedMesh sheet = shapes::moved(shapes::closed_sheet(200), Vec3(0, 0, 10));
  EXPECT_EQ(clash_of(kBlock, sheet).state, ClashState::penetrating);
  EXPECT_EQ(clash_of(sheet, kBlock).state, ClashState::penetrating);
  EXPECT_EQ(clash_of(kBlock, shapes::moved(sheet, Vec3(0, 0, 100))).state, ClashState::free);
}

TEST(Clash, BodiesThatTouchWithinTheToleranceDoNotPenetrate) {
  for (const double sunk : {0.0, 0.005, 0.0099}) {
    const Clash clash = clash_of(kBlock, shapes::box(Vec3(-10, -5, 40 - sunk), Vec3(110, 60, 60)));
    EXPECT_EQ(clash.state, ClashState::touching) << sunk;
    EXPECT_LE(clash.depth_mm, clash.depth_upper_mm);
    EXPECT_LE(clash.depth_upper_mm, 0.011);
  }
}

TEST(Clash, FineMeshesThatLieOnEachOtherAtAnyAngleAreDecidedAsCoarseOnes) {
  const auto turned = [](const IndexedMesh& mesh) { return test::placed(mesh, Vec3(1, 2, 3), 0.3, Vec3(5, 6, 7)); };
  const Clash clash = clash_of(turned(shapes::refined(kBlock, 4)),
                               turned(shapes::refined(shapes::box(Vec3(-10, -5, 40), Vec3(110, 60, 60)), 4)));
  EXPECT_EQ(clash.state, ClashState::touching) << clash.reason;
}

TEST(Clash, BodiesApartAreFreeWithTheirDistance) {
  const Clash clash = clash_of(kBlock, shapes::box(Vec3(0, 0, 43), Vec3(100, 60, 60)));
  EXPECT_EQ(clash.state, ClashState::free);
  EXPECT_DOUBLE_EQ(clash.closest.distance_mm, 3);
}

TEST(Clash, ABodyWhollyInsideAnotherIsNeverFree) {
  const IndexedMesh small = shapes::box(Vec3(10, 10, 10), Vec3(20, 20, 20));
  const Clash inside = clash_of(kBlock, small), around = clash_of(small, kBlock);
  EXPECT_EQ(inside.state, ClashState::penetrating);
  EXPECT_EQ(inside.containment, Containment::b_in_a);
  EXPECT_EQ(around.containment, Containment::a_in_b);
  for (const Clash& clash : {inside, around}) EXPECT_NEAR(clash.depth_mm, 20, 1e-9) << "of its far corner";
}

TEST(Clash, OneOfSeveralPiecesInsideIsNotFreeEither) {
  const IndexedMesh two =
      shapes::joined(shapes::moved(shapes::cube(1), Vec3(50, 30, 20)), shapes::moved(shapes::cube(1), Vec3(500, 0, 0)));
  for (const Clash& clash : {clash_of(kBlock, two), clash_of(two, kBlock)}) {
    EXPECT_EQ(clash.state, ClashState::penetrating);
    EXPECT_EQ(clash.containment, Containment::none);
  }
}

TEST(Clash, ABodyInACavityIsFree) {
  const Clash clash = clash_of(shapes::hollow_cube(10), shapes::moved(shapes::cube(1), Vec3(4.5, 4.5, 4.5)));
  EXPECT_EQ(clash.state, ClashState::free) << clash.reason;
}

TEST(Clash, DepthIsOfTheWholeVolumeNotOfTheSurfaceAlone) {
  // Every point of the block's surface is beside the plate; the middle of the plate is inside the block.
  const IndexedMesh plate = shapes::box(Vec3(-20, -20, -2), Vec3(20, 20, 2));
  const IndexedMesh post = shapes::box(Vec3(-6, -6, -30), Vec3(6, 6, 30));
  const Clash clash = clash_of(plate, post);
  EXPECT_NEAR(clash.depth_mm, 6, 1e-9) << "of the plate in the post";
  ASSERT_EQ(clash.deepest.size(), 2U);
  EXPECT_NEAR(clash.deepest[1].depth_mm, 2, 1e-9) << "of the post in the plate";
  EXPECT_LE(clash.depth_upper_mm, 6.0011);
}

TEST(Clash, TheSameBodyTwiceIsAsDeepAsItIsThick) {
  const Clash clash = clash_of(kBlock, kBlock);
  EXPECT_NEAR(clash.depth_mm, 20, 1e-9);
  EXPECT_LE(clash.depth_upper_mm, 20.0011);
}

TEST(Clash, AnOpenBodyIsFreeOnlyBeyondAllBoundsAndNeverCertifiedWithin) {
  const IndexedMesh open = shapes::open_cube(10);
  EXPECT_EQ(clash_of(open, shapes::moved(shapes::cube(10), Vec3(50, 5, 5))).state, ClashState::free);
  const Clash within = clash_of(open, shapes::moved(shapes::cube(1), Vec3(5, 5, 5)));
  EXPECT_EQ(within.state, ClashState::not_certified);
  EXPECT_NE(within.reason.find("open edges"), std::string::npos) << within.reason;
  for (const IndexedMesh& no_solid : {open, shapes::inside_out(shapes::cube(10))}) {
    const Clash touching = clash_of(no_solid, shapes::moved(shapes::cube(10), Vec3(10, 0, 0)));
    EXPECT_EQ(touching.state, ClashState::not_certified);
    EXPECT_NE(touching.reason.find("bounds no solid"), std::string::npos) << touching.reason;
  }
}

TEST(Clash, WhatAnOpenSurfaceReachesIntoAClosedBodyIsFoundAllTheSame) {
  const Clash clash = clash_of(shapes::open_cube(10), shapes::moved(shapes::cube(10), Vec3(5, 5, 5)));
  EXPECT_EQ(clash.state, ClashState::penetrating);
  EXPECT_NEAR(clash.depth_mm, 5, 1e-9);
  EXPECT_TRUE(std::isinf(clash.depth_upper_mm));
}

TEST(Clash, ABudgetThatRunsOutLeavesTheBoundsAndCertifiesNothing) {
  ClashOptions options;
  options.budget = 20;
  const Clash touching =
      clash_of(shapes::refined(kBlock, 2), shapes::box(Vec3(-10, -5, 40), Vec3(110, 60, 60)), options);
  EXPECT_EQ(touching.state, ClashState::not_certified);
  EXPECT_GT(touching.depth_upper_mm, 0.011);
  EXPECT_FALSE(touching.reason.empty());
  const Clash deep = clash_of(shapes::bumpy_sphere(), shapes::moved(shapes::bumpy_sphere(), Vec3(40, 10, 5)), options);
  EXPECT_LE(deep.depth_mm, deep.depth_upper_mm);
  EXPECT_GE(deep.depth_upper_mm, 19);
}

// Two boxes that overlap in one file: the nearest facet of a point in both may be one that states outside.
TEST(Clash, OfABodyThatCrossesItselfTheWindingNumberShowsTheSide) {
  const IndexedMesh pair =
      shapes::joined(shapes::box(Vec3(0, 0, 0), Vec3(10, 10, 10)), shapes::box(Vec3(6, -1, -1), Vec3(16, 11, 11)));
  const IndexedMesh pin = shapes::box(Vec3(6.4, 4.9, 4.9), Vec3(6.6, 5.1, 30));
  const ClashBody a{Surface(pair)}, b{Surface(pin)};
  const Clash clash = find_clash(a, b, Vec3::Zero(), {});
  EXPECT_EQ(clash.state, ClashState::penetrating);
  EXPECT_GE(clash.depth_upper_mm, clash.depth_mm);
}

TEST(FreeShift, OfAJawIsHowFarItIsSunkIn) {
  const Pair pair(kBlock, shapes::box(Vec3(-30, -20, 38), Vec3(130, 80, 60)));
  const Clash clash = find_clash(pair.a, pair.b, Vec3::Zero(), {});
  const FreeShift shift = find_free_shift(pair.a, pair.b, clash, {});
  EXPECT_LT((shift.shift - Vec3(0, 0, 2)).norm(), 0.02);
}

TEST(FreeShift, IsProvedWhateverTheShapes) {
  std::size_t weighted = 0;
  for (unsigned seed = 0; seed < 24; ++seed) {
    const Pair pair = test::random_pair(seed);
    const Clash clash = find_clash(pair.a, pair.b, Vec3::Zero(), {});
    if (clash.state != ClashState::penetrating) continue;
    const FreeShift shift = find_free_shift(pair.a, pair.b, clash, {});
    const Clash after = find_clash(pair.a, pair.b, shift.shift, {});
    EXPECT_TRUE(after.state == ClashState::free || after.state == ClashState::touching) << seed << " " << after.reason;
    EXPECT_EQ(after.state, shift.state) << seed;
    weighted += shift.is_weighted ? 1U : 0U;
  }
  EXPECT_GT(weighted, 3U);
}

}  // namespace
}  // namespace gouge::clash_test
