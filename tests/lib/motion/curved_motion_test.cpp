// Arcs, helices and splines are swept as what they are.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "lib/motion/motion.h"
#include "lib/motion/tool_interval.h"
#include "tests/support/motions.h"
#include "tests/support/scatter.h"

namespace gouge::curved_motion_test {
namespace {

constexpr double kPi = std::numbers::pi;

using test::Scatter;

struct Helix {
  PathArc arc;
  Pose start, end;
  double radius = 0, rise = 0;
};

Helix random_helix(Scatter& random, double lean) {
  Helix h;
  h.arc.center = random.point(30);
  h.arc.axis = random.direction();
  h.arc.sweep_rad = random.in(-3, 3) * kPi;
  h.radius = std::pow(10, random.in(-1, 2));
  h.rise = random.in(-5, 5);
  const Vec3 e1 = h.arc.axis.unitOrthogonal();
  h.start.tip = h.arc.center + h.radius * e1;
  h.end.tip = h.arc.center + h.rise * h.arc.axis +
              h.radius * (std::cos(h.arc.sweep_rad) * e1 + std::sin(h.arc.sweep_rad) * h.arc.axis.cross(e1));
  h.start.axis = random.direction();
  h.end.axis = (h.start.axis + lean * random.direction()).normalized();
  return h;
}

PathSpline random_spline(Scatter& random, const Vec3& start) {
  std::vector<Vec3> control = {start};
  for (int i = 0; i < 6; ++i) control.push_back(control.back() + random.point(5));
  return make_spline(control, {0.1, 0.5, 0.9});
}

TEST(CurvedMotion, EndsAreTheGivenPosesBitForBitAndTheWayIsUnbroken) {
  Scatter random(1);
  for (int i = 0; i < 100; ++i) {
    Helix h = random_helix(random, 0.3);
    h.end.tip += random.point(1e-3);  // the rounding of a file
    const Motion arc = test::along(h.start, h.end, h.arc);
    EXPECT_EQ(arc.at(0).tip, h.start.tip);
    EXPECT_EQ(arc.at(1).tip, h.end.tip);
    EXPECT_EQ(arc.at(1).axis, h.end.axis);
    EXPECT_LE((arc.at(1 - 1e-12).tip - h.end.tip).norm(), 1e-8);
    const PathSpline spline = random_spline(random, h.start.tip);
    const Motion along = test::along(h.start, {spline.pieces.back().control.back(), h.end.axis}, spline);
    EXPECT_EQ(along.at(1).tip, spline.pieces.back().control.back());
    for (std::size_t s = 0; s + 1 < along.segments().size(); ++s) {
      EXPECT_LE((along.segments()[s].tip1 - along.segments()[s + 1].tip0).norm(), 1e-12);
    }
  }
}

TEST(CurvedMotion, TheTipStaysOnItsHelixAndTurnsTheRightWay) {
  Scatter random(2);
  for (int i = 0; i < 200; ++i) {
    const Helix h = random_helix(random, 0.3);
    const Motion motion = test::along(h.start, h.end, h.arc);
    const Vec3 e1 = (h.start.tip - h.arc.center).normalized();
    for (double t = 0; t <= 1; t += 0.05) {
      const Vec3 from = motion.at(t).tip - h.arc.center;
      EXPECT_NEAR(from.dot(h.arc.axis), t * h.rise, 1e-10);
      EXPECT_NEAR(from.cross(h.arc.axis).norm(), h.radius, 1e-9);
      const double turned = std::atan2(h.arc.axis.cross(e1).dot(from), e1.dot(from));
      EXPECT_NEAR(std::remainder(turned - t * h.arc.sweep_rad, 2 * kPi), 0, 1e-9);
    }
  }
}

TEST(CurvedMotion, AFullCircleComesBackToWhereItBegan) {
  const Pose pose{Vec3(5, 0, 0), Vec3::UnitZ()};
  const Motion motion = test::along(pose, pose, PathArc{Vec3::Zero(), Vec3::UnitZ(), 2 * kPi});
  EXPECT_TRUE(motion.at(0.5).tip.isApprox(Vec3(-5, 0, 0), 1e-14));
  EXPECT_TRUE(motion.at(0.25).tip.isApprox(Vec3(0, 5, 0), 1e-14));
}

// Halves the interval at random a few times: bounds must hold for long and for short ones.
std::uint32_t somewhere(ToolIntervals& intervals, const Motion& motion, Scatter& random, double& tightest) {
  auto index = static_cast<std::uint32_t>(random.in(0, static_cast<double>(motion.segments().size()) - 1e-9));
  const int depth = static_cast<int>(random.in(0, 8));
  for (int k = 0; k < depth; ++k) index = intervals.halve(index) + (random.in(0, 1) < 0.5 ? 0U : 1U);
  if (depth < 4) tightest = 1e300;
  return index;
}

void expect_bulge_holds(const Motion& motion, Scatter& random, double& tightest) {
  ToolIntervals intervals(motion, motion);
  double ignored = 0;
  const ToolInterval interval = intervals[somewhere(intervals, motion, random, ignored)];
  const Vec3 p = motion.at(random.in(0, 1)).tip + random.point(60);
  const double stated = interval.rates.bulge_mm((p - interval.tip_middle).norm());
  const Vec3 q0 = interval.f0.to_tool(p), q1 = interval.f1.to_tool(p);
  double length = 0;
  Vec3 last = interval.f0.tip;
  for (int k = 0; k <= 40; ++k) {
    const double s = k / 40.0;
    const ToolFrame frame = tool_frame(motion, interval.t0 + s * (interval.t1 - interval.t0), interval.segment);
    const double bulge = (frame.to_tool(p) - (q0 + s * (q1 - q0))).norm();
    ASSERT_LE(bulge, stated + 1e-9);
    if (bulge > 1e-5 && ignored < 1) tightest = std::min(tightest, stated / bulge);
    length += (frame.tip - last).norm();
    last = frame.tip;
    ASSERT_LE((frame.tip - interval.tip_middle).norm(), 0.5 * interval.rates.tip_path_mm + 1e-9);
  }
  ASSERT_LE(length, interval.rates.tip_path_mm * (1 + 1e-12) + 1e-9);
}

TEST(CurvedMotion, NoPathBulgesFurtherFromItsChordThanStated) {
  Scatter random(3);
  double tightest = 1e300;
  for (int i = 0; i < 3000; ++i) {
    Helix h = random_helix(random, i % 3 == 0 ? 0.0 : 0.5);
    if (i % 2 == 0) h.end.tip += random.point(2);  // spirals, and sweeps that do not fit their end
    expect_bulge_holds(test::along(h.start, h.end, h.arc), random, tightest);
    const PathSpline spline = random_spline(random, h.start.tip);
    expect_bulge_holds(test::along(h.start, {spline.pieces.back().control.back(), h.end.axis}, spline), random,
                       tightest);
  }
  EXPECT_LT(tightest, 1.1);  // the bound is not merely huge
}

}  // namespace
}  // namespace gouge::curved_motion_test
