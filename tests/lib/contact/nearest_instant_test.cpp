#include "lib/contact/nearest_instant.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "lib/contact/cutter_sweep.h"
#include "lib/motion/motion.h"
#include "lib/tool/evaluate.h"
#include "tests/support/motions.h"
#include "tests/support/scatter.h"
#include "tests/support/tools.h"

namespace gouge::nearest_instant_test {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr int kSamples = 400;

/// Reference for `NearestInstant`: the motion itself at many instants.
double sampled_mm(const CompiledTool& tool, const Motion& motion, std::span<const Vec3> points) {
  double least = 1e9;
  for (int k = 0; k <= kSamples; ++k) {
    double most = -1e9;
    for (const Vec3& p : points)
      most = std::max(most, signed_distance_mm(tool, motion.at(static_cast<double>(k) / kSamples), p));
    least = std::min(least, most);
  }
  return least;
}

CutterStretch stretch_of(const Motion& motion, const CompiledTool& tool) {
  CutterStretch stretch;
  stretch.start = motion.start();
  stretch.end = motion.end();
  stretch.angle_rad = motion.turn_rad();
  stretch.cutter = &tool;
  stretch.is_convex = is_convex(tool);
  return stretch;
}

/// Some that turn, some that plunge beside what they turn towards, some that stand.
Motion random_motion(test::Scatter& random) {
  const Vec3 axis = random.axis(0.5);
  const Vec3 beside = axis.cross(random.direction()).normalized();
  const double angle = random.is(0.3) ? 0 : random.in(0, 1) * kDegree;
  const double path = random.is(0.2) ? 0 : std::pow(10, random.in(-2, 1.5));
  const Vec3 way = random.is(0.5) ? random.direction() : beside;
  const Vec3 tip = random.point(3);
  return test::straight({tip, axis}, {tip + path * way, std::cos(angle) * axis + std::sin(angle) * beside});
}

std::vector<ToolVariants> all_tools() {
  std::vector<ToolVariants> all = tools::all();
  for (ToolVariants& tool : tools::shapes()) all.push_back(std::move(tool));
  return all;
}

TEST(NearestInstant, BoundsPointsFromBothSides) {
  test::Scatter random(5);
  std::size_t convex = 0;
  for (const ToolVariants& tool : all_tools()) {
    convex += is_convex(tool.cutting) ? 1U : 0U;
    for (int n = 0; n < 150; ++n) {
      const Motion motion = random_motion(random);
      const CutterStretch stretch = stretch_of(motion, tool.cutting);
      std::vector<Vec3> points(1 + random.below(3));
      const Vec3 near = motion.at(random.in(0, 1)).tip + random.point(12);
      for (Vec3& p : points) p = near + random.point(0.5);
      NearestInstant nearest(stretch, points);
      nearest.search(-1e9, 1e9);
      const double truth = sampled_mm(tool.cutting, motion, points);
      const double path = (motion.end().tip - motion.start().tip).norm();
      EXPECT_LE(nearest.bound_mm(), truth + 1e-9) << tool.bare.name << " " << n;
      EXPECT_GE(nearest.found_mm(), truth - (path + 50 * motion.turn_rad()) / kSamples) << tool.bare.name << " " << n;
      const double far = (near - motion.start().tip).norm() + path + 1;
      const double open = motion.turn_rad() * (motion.turn_rad() * far + 2 * path) / 4;
      const double coarse = stretch.is_convex ? 0 : (path + far * motion.turn_rad()) / 4096;
      EXPECT_LE(nearest.found_mm() - nearest.bound_mm(), kInstantGap_mm + open + coarse) << tool.bare.name << " " << n;
    }
  }
  EXPECT_GT(convex, 4U);
}

TEST(NearestInstant, StopsWhereItIsEnoughOrHopeless) {
  const ToolVariants tool = tools::ball();
  const Motion motion = test::straight(Pose{Vec3(0, 0, 0), Vec3::UnitZ()}, Pose{Vec3(10, 0, 0), Vec3::UnitZ()});
  const CutterStretch stretch = stretch_of(motion, tool.cutting);
  const Vec3 beside(5, 8, 5), within(2, 1, 5);
  NearestInstant far(stretch, {&beside, 1});
  far.search(0, 1);
  EXPECT_GT(far.bound_mm(), 1);
  NearestInstant near(stretch, {&within, 1});
  near.search(0, 1e9);
  EXPECT_LE(near.found_mm(), 0);
}

TEST(NearestInstant, BoundsAllPointsOfATriangle) {
  test::Scatter random(6);
  for (const ToolVariants& tool : all_tools()) {
    for (int n = 0; n < 60; ++n) {
      const Motion motion = random_motion(random);
      const CutterStretch stretch = stretch_of(motion, tool.cutting);
      const Vec3 middle = motion.at(random.in(0, 1)).tip + random.point(8);
      const double size = random.in(0.05, 2);
      std::array<Vec3, 3> corners{random.point(size), random.point(size), Vec3::Zero()};
      corners[2] = -corners[0] - corners[1];
      NearestInstant nearest(stretch, middle, corners);
      nearest.search(-1e9, 1e9);
      for (int k = 0; k < 8; ++k) {
        double u = random.in(0, 1), w = random.in(0, 1);
        if (u + w > 1) u = 1 - u, w = 1 - w;
        const Vec3 point = middle + u * corners[0] + w * corners[1] + (1 - u - w) * corners[2];
        EXPECT_LE(nearest.bound_mm(), sampled_mm(tool.cutting, motion, {&point, 1}) + 1e-9)
            << tool.bare.name << " " << n;
      }
    }
  }
}

// A flank that comes down while it leans: the distance is largest half way, by a quarter of turn and path.
TEST(CutterSweep, IsNeverNearerThanItSaysWhileItTurnsAndRuns) {
  const ToolVariants tool = tools::flat();
  test::Scatter random(7);
  for (int n = 0; n < 300; ++n) {
    const Motion motion = random_motion(random);
    CutterSweep sweep;
    sweep.add(motion, tool.cutting, 0);
    sweep.index();
    const Pose pose = motion.at(random.in(0, 1));
    const Vec3 radial = pose.axis.cross(random.direction()).normalized();
    const Vec3 point = pose.tip + random.in(-1, 25) * pose.axis + random.in(4, 6) * radial;
    SweepHint hint;
    const double told = sweep.distance(point, -1e9, 1e9, hint), truth = sampled_mm(tool.cutting, motion, {&point, 1});
    EXPECT_LE(told, truth + 1e-9) << n;
    EXPECT_GE(told, truth - 0.01 - (motion.end().tip - motion.start().tip).norm() / kSamples) << n;
  }
}

}  // namespace
}  // namespace gouge::nearest_instant_test
