#include "lib/machine/draw_machine.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "lib/base/units.h"
#include "lib/machine/iso_view.h"
#include "tests/lib/machine/machines.h"

// Drawings of machines: nothing is left out, and nothing leaves the sheet.

namespace gouge::draw_machine_test {
namespace {

std::vector<Vec2> points_of(const Drawing& drawing) {
  std::vector<Vec2> all;
  for (const auto& item : drawing.items) {
    if (const auto* const line = std::get_if<DrawnLine>(&item))
      all.insert(all.end(), line->points.begin(), line->points.end());
    if (const auto* const shape = std::get_if<DrawnShape>(&item))
      all.insert(all.end(), shape->points.begin(), shape->points.end());
    if (const auto* const text = std::get_if<DrawnText>(&item)) all.push_back(text->at);
  }
  return all;
}

std::multiset<std::string> texts_of(const Drawing& drawing) {
  std::multiset<std::string> all;
  for (const auto& item : drawing.items)
    if (const auto* const text = std::get_if<DrawnText>(&item)) all.insert(text->text);
  return all;
}

TEST(DrawMachine, ShowsEveryJointInThePictureAndInTheList) {
  for (Machine machine : test::machines()) {
    Joint& tilt = machine.joints[machine.rotary[1]];
    tilt.is_continuous = false;
    tilt.min = -35 * kDegree_rad;
    tilt.max = 110 * kDegree_rad;
    tilt.rate = 3600 * kDegree_rad;
    const Drawing drawing = draw_machine(machine);
    const std::multiset<std::string> texts = texts_of(drawing);
    for (const Joint& joint : machine.joints) EXPECT_EQ(texts.count(joint.name), 2U) << machine.name << joint.name;
    EXPECT_EQ(texts.count(machine.name), 1U);
    EXPECT_EQ(texts.count("-35 to 110 deg"), 1U) << machine.name;
    EXPECT_EQ(texts.count("-35 to 110 deg, 3600 deg/min"), 1U) << machine.name;
    EXPECT_EQ(texts.count("part zero") + texts.count("gauge point") + texts.count("tool tip"), 3U);
    for (const Vec2& p : points_of(drawing)) {
      ASSERT_TRUE(std::isfinite(p.x()) && std::isfinite(p.y())) << machine.name;
      EXPECT_GE(p.x(), 0) << machine.name;
      EXPECT_LE(p.x(), drawing.width) << machine.name;
      EXPECT_GE(p.y(), 0) << machine.name;
      EXPECT_LE(p.y(), drawing.height) << machine.name;
    }
  }
}

TEST(DrawMachine, SaysWhatIsNotKnown) {
  Machine machine = test::machines()[0];
  machine.joints[1].has_point = false;
  machine.joints[1].is_continuous = false;
  const std::multiset<std::string> texts = texts_of(draw_machine(machine));
  EXPECT_EQ(texts.count("place of the axis not known"), 1U);
  EXPECT_EQ(texts.count("axis through (1, 2, 3) mm"), 1U);
  EXPECT_EQ(texts.count("Source: not given"), 1U);
  EXPECT_EQ(texts.count("law of feeds: not given, law of rapids: not given"), 1U);
  EXPECT_EQ(texts.count("Control: not given"), 1U);
}

TEST(IsoView, HasTheAxesOfARightHandedFrame) {
  Drawing drawing;
  const IsoView view(drawing, Vec2(100, 100));
  const Vec2 zero = view.at(Vec3::Zero()), x = view.at(Vec3::UnitX()) - zero, y = view.at(Vec3::UnitY()) - zero,
             z = view.at(Vec3::UnitZ()) - zero;
  EXPECT_EQ(zero, Vec2(100, 100));
  EXPECT_GT(x.x(), 0);
  EXPECT_GT(x.y(), 0) << "down";
  EXPECT_GT(y.x(), 0);
  EXPECT_LT(y.y(), 0) << "up";
  EXPECT_NEAR(z.x(), 0, 1e-12);
  EXPECT_LT(z.y(), 0);
}

TEST(IsoView, ATurnFollowsTheRightHandRule) {
  // Seen from above, a turn about z runs counterclockwise: in the picture, where y points down, the area is negative.
  for (const double sense : {1.0, -1.0}) {
    Drawing drawing;
    IsoView view(drawing, Vec2(0, 0));
    view.turn_arrow(Vec3::Zero(), sense * Vec3::UnitZ(), 30, {}, 2);
    const std::vector<Vec2> arc = std::get<DrawnLine>(drawing.items.front()).points;
    double area = 0;
    for (std::size_t k = 1; k < arc.size(); ++k) area += arc[k - 1].x() * arc[k].y() - arc[k - 1].y() * arc[k].x();
    EXPECT_LT(sense * area, 0);
  }
}

}  // namespace
}  // namespace gouge::draw_machine_test
