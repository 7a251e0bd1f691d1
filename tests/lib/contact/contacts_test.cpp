#include "lib/contact/contacts.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/reference.h"
#include "tests/support/shapes.h"
#include "tests/support/tools.h"

namespace gouge::contacts_test {
namespace {

constexpr CorrectionAim kAim{0.005, 0.005, -0.002};

Pose upright(double z) { return {Vec3(0, 0, z), Vec3::UnitZ()}; }

/// One triangle that covers the origin of the plane z = 0.
IndexedMesh floor_triangle() {
  IndexedMesh mesh;
  mesh.vertices = {Vec3(-90, -80, 0), Vec3(100, -70, 0), Vec3(0, 120, 0)};
  shapes::add_triangle(mesh, 0, 1, 2);
  return mesh;
}

TEST(Contacts, APlaneUnderABallIsOneContactWithThePlanesNormal) {
  const Scene scene{{floor_triangle()}, {}};
  const auto contacts = find_contacts(upright(-0.3), tools::ball(), prepare_scene(scene), kAim);
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_LE(contacts[0].excess_mm, 0.3 - kAim.workpiece_mm + 1e-12);
  EXPECT_GE(contacts[0].excess_mm, (0.3 - kAim.workpiece_mm) / 1.1 - 1e-12);
  EXPECT_GT(contacts[0].normal.z(), 0.99);
  EXPECT_NEAR(contacts[0].normal.norm(), 1, 1e-12);
  EXPECT_NEAR(contacts[0].point.z(), 0, 1e-12);
}

TEST(Contacts, EveryContactRealisesItsExcessAndGivesWayAlongItsNormal) {
  const Scene scene{{shapes::sphere(12, 24, 48)}, {}};
  const PreparedScene prepared = prepare_scene(scene);
  for (const ToolVariants& tool : tools::all()) {
    const reference::Contour contour(tool.against_part);
    const Pose pose{Vec3(1, -2, 11), Vec3(0.2, 0.1, 1).normalized()};
    const auto contacts = find_contacts(pose, tool, prepared, kAim);
    EXPECT_GT(contacts.size(), 5U);
    for (const ToolContact& c : contacts) {
      const double depth = c.excess_mm + kAim.workpiece_mm;
      EXPECT_NEAR(contour.depth(pose, c.point), depth, 1e-9);
      EXPECT_NEAR(contour.depth({pose.tip + 0.5 * depth * c.normal, pose.axis}, c.point), 0.5 * depth, 1e-9);
    }
  }
}

TEST(Contacts, WhatIsNoDeeperThanTheAimIsNone) {
  const Scene scene{{floor_triangle()}, {}};
  EXPECT_TRUE(find_contacts(upright(-0.0049), tools::ball(), prepare_scene(scene), kAim).empty());
  EXPECT_EQ(find_contacts(upright(-0.0051), tools::ball(), prepare_scene(scene), kAim).size(), 1U);
}

TEST(Contacts, ANegativeAimAsksForAir) {
  const Scene scene{{floor_triangle()}, {}};
  const CorrectionAim air{-0.5, -0.5, -0.5};
  EXPECT_EQ(find_contacts(upright(0.4), tools::ball(), prepare_scene(scene), air).size(), 1U);
  EXPECT_TRUE(find_contacts(upright(0.6), tools::ball(), prepare_scene(scene), air).empty());
  EXPECT_GT(largest_excess(upright(0.4), tools::ball(), prepare_scene(scene), air, 1e-4), 0.05);
  EXPECT_EQ(largest_excess(upright(0.6), tools::ball(), prepare_scene(scene), air, 1e-4), 0);
}

TEST(Contacts, FixturesAndClearancesAreCorrectedForAsWell) {
  const Scene fixture{{shapes::moved(shapes::cube(1), Vec3(0, 0, -300))}, {floor_triangle()}};
  EXPECT_EQ(find_contacts(upright(-0.3), tools::ball(), prepare_scene(fixture), kAim).size(), 1U);

  // The holder (16 mm, from z = 50) passes a wall at 16.4 mm; the clearance is 1 mm.
  const Scene wall{{shapes::box(Vec3(16.4, -9, 55), Vec3(40, 9, 80))}, {}};
  EXPECT_TRUE(find_contacts(upright(0), tools::ball(), prepare_scene(wall), kAim).empty());
  const ToolVariants cautious = tools::variants(tools::assembly(BallCutter{10, 30}), 0, 0, 1);
  const auto contacts = find_contacts(upright(0), cautious, prepare_scene(wall), kAim);
  ASSERT_GT(contacts.size(), 0U);
  for (const ToolContact& c : contacts) EXPECT_LT(c.normal.x(), -0.99);
}

TEST(LargestExcess, IsNeverMoreThanTheTruthAndNothingOnlyWhenTheAimIsMet) {
  const Scene scene{{floor_triangle()}, {}};
  const PreparedScene prepared = prepare_scene(scene);
  for (const double depth : {0.0, 0.004, 0.0052, 0.006, 0.02, 0.1, 0.7, 2.0}) {
    const double truth = std::max(0.0, depth - kAim.workpiece_mm);
    const double found = largest_excess(upright(-depth), tools::ball(), prepared, kAim, 1e-4);
    EXPECT_LE(found, truth + 1e-12) << depth;
    EXPECT_GE(found, truth - 0.0501) << depth;
    EXPECT_EQ(found > 0, truth > 1e-4) << depth;
  }
}

}  // namespace
}  // namespace gouge::contacts_test
