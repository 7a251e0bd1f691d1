#include "lib/contact/contacts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

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

/// A square of the plane through the origin with this normal, of two triangles that meet along a diagonal.
IndexedMesh square(const Vec3& n) {
  const Vec3 u = n.unitOrthogonal(), v = n.cross(u);
  IndexedMesh mesh;
  mesh.vertices = {-70 * u - 60 * v, 65 * u - 61 * v, 71 * u + 63 * v, -66 * u + 62 * v};
  shapes::add_quad(mesh, 0, 1, 2, 3);
  return mesh;
}

/// A round cutter: its lowest circle of centers has the radius `ring_mm` about the axis, at the height of the corner's
/// radius.
struct RoundCutter {
  const char* name;
  ToolVariants tool;
  double ring_mm, corner_mm;
};

std::vector<RoundCutter> round_cutters() {
  return {{"ball", tools::ball(), 0, 5}, {"bull", tools::bull(), 6, 2}, {"tapered", tools::tapered(), 0, 2}};
}

/// Returns the tip at which the cutter is `depth_mm` deep in the plane through `foot`.
Vec3 tip_at_depth(const RoundCutter& cutter, const Vec3& axis, const Vec3& n, const Vec3& foot, double depth_mm) {
  const Vec3 across = n - n.dot(axis) * axis;
  const Vec3 center = cutter.corner_mm * axis - cutter.ring_mm * across.normalized();
  return foot + (cutter.corner_mm - depth_mm) * n - center;
}

const ToolContact& deepest_of(const std::vector<ToolContact>& contacts) {
  return *std::ranges::max_element(contacts, {}, &ToolContact::excess_mm);
}

TEST(Contacts, InAFlatFaceTheDeepestOneHasExactlyTheNormalOfTheFace) {
  constexpr double kDepth_mm = 0.25;
  for (const RoundCutter& cutter : round_cutters()) {
    for (const double lean_deg : {0.01, 0.5, 3.0, 20.0, 50.0}) {
      for (const Vec3& n : {Vec3(0, 0, 1), Vec3(0.48, -0.6, 0.64)}) {
        const Scene scene{{square(n)}, {}};
        const PreparedScene prepared = prepare_scene(scene);
        const double lean = lean_deg * M_PI / 180;
        const Vec3 axis = std::cos(lean) * n + std::sin(lean) * n.unitOrthogonal();
        for (const double x : {-21.0, 0.0, 0.4, 7.0}) {
          const Vec3 foot = x * n.unitOrthogonal() + 0.3 * x * n.cross(n.unitOrthogonal());
          const Pose pose{tip_at_depth(cutter, axis, n, foot, kDepth_mm), axis};
          const auto contacts = find_contacts(pose, cutter.tool, prepared, kAim);
          ASSERT_FALSE(contacts.empty()) << cutter.name << " " << lean_deg << " " << x << " " << n.transpose()
                                         << " tip " << pose.tip.transpose();
          const ToolContact& contact = deepest_of(contacts);
          const std::string where = std::string(cutter.name) + " " + std::to_string(lean_deg) + " " + std::to_string(x);
          EXPECT_NEAR((contact.normal - n).norm(), 0, 1e-6) << where;
          EXPECT_NEAR(contact.excess_mm, kDepth_mm - kAim.workpiece_mm, 1e-9) << where;
          EXPECT_NEAR(contact.point.dot(n), 0, 1e-9) << where;
        }
      }
    }
  }
}

TEST(Contacts, ASideInAWallGivesWayAcrossTheWall) {
  const Scene scene{{square(Vec3(-1, 0, 0))}, {}};
  const PreparedScene wall = prepare_scene(scene);
  const double taper = 5 * M_PI / 180;
  const Vec3 tapered_axis(std::sin(-taper), 0, std::cos(taper));
  for (const auto& [tool, pose] : {std::pair(tools::flat(), Pose{Vec3(-4.8, 0.3, 1.7), Vec3::UnitZ()}),
                                   std::pair(tools::tapered(), Pose{Vec3(-1.8, 0.3, 1.7), tapered_axis})}) {
    const auto contacts = find_contacts(pose, tool.cutting, wall.workpiece_tree(), kAim.workpiece_mm);
    ASSERT_FALSE(contacts.empty());
    EXPECT_NEAR((deepest_of(contacts).normal + Vec3::UnitX()).norm(), 0, 1e-6);
  }
}

TEST(Contacts, AtAnEdgeOfTheSurfaceTheDeepestPointIsTheNearestOne) {
  // A ball whose center is 4.8 mm from the edge of a block, 20 degrees from the vertical.
  const Scene scene{{shapes::box(Vec3(-50, -40, -30), Vec3(0, 45, 0))}, {}};
  const PreparedScene block = prepare_scene(scene);
  const Vec3 out(std::sin(0.35), 0, std::cos(0.35));
  const Pose pose{Vec3(0, 1.3, 0) + 4.8 * out - 5 * Vec3::UnitZ(), Vec3::UnitZ()};
  const auto contacts = find_contacts(pose, tools::ball(), block, kAim);
  ASSERT_FALSE(contacts.empty());
  EXPECT_NEAR((deepest_of(contacts).point - Vec3(0, 1.3, 0)).norm(), 0, 1e-6);
  EXPECT_NEAR((deepest_of(contacts).normal - out).norm(), 0, 1e-6);
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
