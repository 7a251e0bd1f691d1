#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <numbers>

#include "lib/penetration/correction.h"
#include "lib/penetration/find_penetration.h"
#include "tests/support/solids.h"

namespace gouge::correction_test {
namespace {

/// A circle against lines {x : n . x = 0}, free where n . x >= 0: figure 35.
ContactsAt circle_between_lines(const Vec3& centre, double radius, std::vector<Vec3> normals) {
  return [=](const Vec3& shift) {
    std::vector<Contact> contacts;
    for (const Vec3& n : normals) {
      Contact c;
      c.normal = n;
      c.depth_mm = radius - n.dot(centre + shift);
      if (c.depth_mm > 0) contacts.push_back(c);
    }
    return contacts;
  };
}

Vec3 in_plane(double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  return {std::cos(angle), std::sin(angle), 0};
}

TEST(WeightedCorrection, IsTheThesisFormula) {
  std::vector<Contact> contacts(2);
  contacts[0].normal = Vec3::UnitX();
  contacts[0].depth_mm = 1;
  contacts[1].normal = Vec3::UnitY();
  contacts[1].depth_mm = 3;
  EXPECT_NEAR((weighted_correction(contacts) - Vec3(0.25, 2.25, 0)).norm(), 0, 1e-15);
  EXPECT_EQ(weighted_correction({}), Vec3(Vec3::Zero()));
}

TEST(Correction, OfTheCircleBetweenTwoLinesTakesSevenIterations) {
  // Lines at right angles, the circle of figure 35 as deep as its radius; free is a hundredth of it.
  CorrectionOptions options;
  options.free_mm = 0.01;
  const FreeingShift c =
      correct_until_free(circle_between_lines(Vec3::Zero(), 1, {in_plane(45), in_plane(135)}), options);
  EXPECT_EQ(c.end, CorrectionEnd::free);
  EXPECT_EQ(c.iterations, 7U);
  EXPECT_EQ(c.trail.size(), 7U);
  EXPECT_LE(c.depth_left_mm, 0.01);
}

TEST(Correction, TakesFourToEightIterationsBetweenLinesOfUsualAngles) {
  CorrectionOptions options;
  options.free_mm = 0.01;
  for (double half = 30; half <= 45; half += 5) {
    const FreeingShift c = correct_until_free(
        circle_between_lines(Vec3(0.1, 0.2, 0), 1, {in_plane(90 - half), in_plane(90 + half)}), options);
    EXPECT_EQ(c.end, CorrectionEnd::free);
    EXPECT_GE(c.iterations, 4U) << half;
    EXPECT_LE(c.iterations, 8U) << half;
  }
}

TEST(Correction, AgainstOneLineIsExactAtOnce) {
  const FreeingShift c = correct_until_free(circle_between_lines(Vec3(0, 0.3, 0), 1, {Vec3::UnitY()}));
  EXPECT_EQ(c.iterations, 1U);
  EXPECT_NEAR((c.shift - Vec3(0, 0.7, 0)).norm(), 0, 1e-12);
}

TEST(Correction, ReportsABalance) {
  const FreeingShift c = correct_until_free(circle_between_lines(Vec3::Zero(), 1, {Vec3::UnitX(), -Vec3::UnitX()}));
  EXPECT_EQ(c.end, CorrectionEnd::balanced);
  EXPECT_EQ(c.iterations, 0U);
}

TEST(Correction, ReportsACycle) {
  // Two walls that push by more than there is room between them: to and fro.
  const ContactsAt walls = [](const Vec3& shift) {
    Contact c;
    c.depth_mm = 1;
    c.normal = shift.x() > 0.5 ? Vec3(-Vec3::UnitX()) : Vec3(Vec3::UnitX());
    return std::vector<Contact>{c};
  };
  const FreeingShift c = correct_until_free(walls);
  EXPECT_EQ(c.end, CorrectionEnd::cycle);
  EXPECT_LE(c.iterations, 4U);
}

TEST(Correction, StopsWhenTheIterationsRunOut) {
  const ContactsAt receding = [](const Vec3&) {
    Contact c;
    c.depth_mm = 1;
    c.normal = Vec3::UnitX();
    return std::vector<Contact>{c};
  };
  CorrectionOptions options;
  options.iterations = 9;
  const FreeingShift c = correct_until_free(receding, options);
  EXPECT_EQ(c.end, CorrectionEnd::limit);
  EXPECT_EQ(c.iterations, 9U);
}

TEST(Correction, FreesNonConvexBodiesInFourToEightIterations) {
  DepthBodyOptions options;
  options.depth_mm = 3;
  const DepthBody body = build_depth_body(Surface(shapes::bumpy_sphere(40, 3)), options);
  const PointBody points = build_point_body(shapes::bumpy_sphere(10, 1, 20, 24).vertices);
  PenetrationFinder finder(body, points);
  CorrectionOptions limits;
  limits.free_mm = 0.02;
  std::size_t fewest = 99, most = 0;
  for (int i = 0; i < 20; ++i) {
    const Vec3 axis = Vec3(std::cos(0.7 * i), std::sin(0.7 * i), 0.1 * i - 1).normalized();
    RigidTransform start;
    start.shift = 48.5 * axis;
    const FreeingShift c = correct_until_free(
        [&](const Vec3& shift) {
          RigidTransform pose = start;
          pose.shift += shift;
          std::vector<Contact> contacts;
          for (const PointContact& p : finder.find(pose).contacts) contacts.push_back(p.contact);
          return contacts;
        },
        limits);
    EXPECT_EQ(c.end, CorrectionEnd::free) << i;
    if (c.iterations == 0) continue;
    fewest = std::min(fewest, c.iterations);
    most = std::max(most, c.iterations);
  }
  std::cout << "freed in " << fewest << " to " << most << " iterations\n";
  EXPECT_LE(most, 8U);
}

}  // namespace
}  // namespace gouge::correction_test
