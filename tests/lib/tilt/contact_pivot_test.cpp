#include "lib/tilt/contact_pivot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/scatter.h"
#include "tests/support/tools.h"

namespace gouge::contact_pivot_test {
namespace {

std::vector<CompiledTool> cutters() {
  std::vector<CompiledTool> all;
  for (const ToolVariants& tool : tools::all()) all.push_back(tool.cutting);
  for (const ToolVariants& tool : tools::shapes()) all.push_back(tool.cutting);
  return all;
}

/// How far the tool reaches in a direction, by points all over its contour.
double reach(const CompiledTool& tool, const Pose& pose, const Vec3& direction) {
  const double along = direction.dot(pose.axis), away = (direction - along * pose.axis).norm();
  double most = -1e300;
  const auto offer = [&](const Vec2& p) { most = std::max(most, away * p.x() + along * p.y()); };
  for (const BoundaryElement& e : tool.elements) {
    offer(e.a);
    offer(e.b);
    for (int k = 0; k < 4000 && e.kind == ElementKind::arc; ++k) {
      const double angle = k * M_PI / 2000;
      const Vec2 p = e.center + e.radius_mm * Vec2(std::cos(angle), std::sin(angle));
      const double from = std::atan2(e.a.y() - e.center.y(), e.a.x() - e.center.x());
      const double to = std::atan2(e.b.y() - e.center.y(), e.b.x() - e.center.x());
      const double turn = e.is_reflex ? std::remainder(from - to, 2 * M_PI) : std::remainder(to - from, 2 * M_PI);
      const double at = e.is_reflex ? std::remainder(from - angle, 2 * M_PI) : std::remainder(angle - from, 2 * M_PI);
      if (at >= 0 && at <= turn) offer(p);
    }
  }
  return most + direction.dot(pose.tip);
}

Vec3 turned(const Vec3& axis, double angle, test::Scatter& random) {
  return Eigen::AngleAxisd(angle, axis.cross(random.direction()).normalized()) * axis;
}

bool has_ball_tip(const CompiledTool& cutter) {
  const auto arc = std::ranges::find_if(cutter.elements, [](const auto& e) { return e.kind != ElementKind::vertex; });
  return arc->kind == ElementKind::arc && !arc->is_reflex && std::abs(arc->center.x()) < 1e-9;
}

TEST(ContactPivot, KeepsHowFarEveryCutterReachesIntoThePart) {
  test::Scatter random(3);
  for (const CompiledTool& cutter : cutters()) {
    if (has_ball_tip(cutter)) continue;  // its centre stays
    for (int i = 0; i < 300; ++i) {
      const Pose pose{random.point(50), random.direction()};
      Vec3 normal = random.direction();
      if (i % 5 == 0) normal = pose.axis;
      if (i % 5 == 1) normal = pose.axis.cross(random.direction()).normalized();
      const Vec3 axis = turned(pose.axis, random.in(1e-4, 1.2), random);
      const Vec3 tip = ContactPivot(pose, cutter, {normal}).tip_for(axis);
      EXPECT_NEAR(reach(cutter, {tip, axis}, -normal), reach(cutter, pose, -normal), 1e-4) << cutter.name << " " << i;
    }
  }
}

TEST(ContactPivot, KeepsTheCentreOfABall) {
  test::Scatter random(4);
  const CompiledTool ball = tools::ball(10).cutting;
  for (int i = 0; i < 200; ++i) {
    const Pose pose{random.point(50), random.direction()};
    const Vec3 axis = turned(pose.axis, random.in(0, 0.6), random);
    // On the ball before and after.
    Vec3 normal = random.direction();
    if (normal.dot(pose.axis) < 0.1 || normal.dot(axis) < 0.1) continue;
    const Vec3 tip = ContactPivot(pose, ball, {normal}).tip_for(axis);
    EXPECT_NEAR((tip + 5 * axis - pose.tip - 5 * pose.axis).norm(), 0, 1e-9);
  }
}

TEST(ContactPivot, OfAFlatEndOnAFloorTurnsAboutTheEdgeOnTheSideItLeansTo) {
  const CompiledTool flat = tools::flat(10).cutting;
  const Pose pose{Vec3(1, 2, 3), Vec3::UnitZ()};
  const Vec3 axis(std::sin(0.3), 0, std::cos(0.3));
  const Vec3 tip = ContactPivot(pose, flat, {Vec3::UnitZ()}).tip_for(axis);
  // The edge at +x of the tip stays where it was.
  const Vec3 edge = tip + 5 * Vec3(std::cos(0.3), 0, -std::sin(0.3));
  EXPECT_NEAR((edge - Vec3(6, 2, 3)).norm(), 0, 1e-9);
  EXPECT_EQ(ContactPivot(pose).tip_for(axis), pose.tip);
}

TEST(ContactPivot, InACornerOfFloorAndWallReachesIntoNeither) {
  test::Scatter random(5);
  for (const CompiledTool& cutter : {tools::flat(10).cutting, tools::bull(16, 2).cutting}) {
    for (int i = 0; i < 100; ++i) {
      const Pose pose{random.point(10), Vec3::UnitZ()};
      const Vec3 wall = Eigen::AngleAxisd(random.in(0, 6), Vec3::UnitZ()) * Vec3::UnitX();
      const Vec3 axis = turned(pose.axis, random.in(0.01, 0.5), random);
      const Vec3 tip = ContactPivot(pose, cutter, {wall, Vec3::UnitZ()}).tip_for(axis);
      for (const Vec3& normal : {wall, Vec3(Vec3::UnitZ())})
        EXPECT_LE(reach(cutter, {tip, axis}, -normal), reach(cutter, pose, -normal) + 1e-4);
      EXPECT_NEAR(reach(cutter, {tip, axis}, -Vec3::UnitZ()), reach(cutter, pose, -Vec3::UnitZ()), 1e-4);
    }
  }
}

TEST(ContactPivot, MovesNoFurtherThanTheToolIsLongWhereAContactRunsAlongItsSide) {
  const CompiledTool flat = tools::flat(10).cutting;
  const Pose pose{Vec3::Zero(), Vec3::UnitZ()};
  const ContactPivot pivot(pose, flat, {Vec3::UnitX()});
  for (const double angle : {-0.2, -0.01, -1e-4, 1e-4, 0.01, 0.2}) {
    const Vec3 tip = pivot.tip_for(Vec3(std::sin(angle), 0, std::cos(angle)));
    EXPECT_LE(tip.norm(), 40 * std::abs(angle)) << angle;
  }
}

}  // namespace
}  // namespace gouge::contact_pivot_test
