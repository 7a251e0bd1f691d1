#include "lib/contact/left_stock.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "lib/tool/evaluate.h"
#include "tests/support/motions.h"
#include "tests/support/scatter.h"
#include "tests/support/shapes.h"
#include "tests/support/tools.h"

namespace gouge::left_stock_test {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr StockLimits kUsual{0.01, 0.02, 20};

struct Bench {
  std::vector<IndexedMesh> parts;
  BlockTree tree;
  explicit Bench(std::vector<IndexedMesh> meshes) : parts(std::move(meshes)), tree(build_block_tree(parts, 1)) {}
};

Bench floor_alone() { return Bench({shapes::box(Vec3(-100, -100, -10), Vec3(100, 100, 0))}); }

CutterSweep sweep_of(const CompiledTool& cutter, const std::vector<std::pair<Pose, Pose>>& motions) {
  CutterSweep sweep;
  std::size_t move = 0;
  for (const auto& [start, end] : motions) sweep.add(test::straight(start, end), cutter, move++);
  sweep.index();
  return sweep;
}

/// Along y from -20 to 20.
std::pair<Pose, Pose> row(double x, double z, const Vec3& axis = Vec3::UnitZ()) {
  return {{Vec3(x, -20, z), axis.normalized()}, {Vec3(x, 20, z), axis.normalized()}};
}

std::optional<LeftStock> left(const Bench& bench, const CutterSweep& before, const CutterSweep& after,
                              const StockLimits& limits = kUsual) {
  return find_left_stock(bench.tree, before, {&after, nullptr}, limits);
}

TEST(LeftStock, IsNoneWhereThePathIsTheSame) {
  const Bench bench = floor_alone();
  for (const ToolVariants& tool : tools::all()) {
    const CutterSweep same = sweep_of(tool.cutting, {row(0, 0)});
    EXPECT_FALSE(left(bench, same, same)) << tool.bare.name;
  }
}

TEST(LeftStock, IsTheLiftOfALiftedPath) {
  const Bench bench = floor_alone();
  for (const ToolVariants& tool : tools::all()) {
    const CutterSweep before = sweep_of(tool.cutting, {row(0, 0)});
    for (const double lift : {0.005, 0.03, 1.25}) {
      const auto found = left(bench, before, sweep_of(tool.cutting, {row(0, lift)}));
      ASSERT_EQ(found.has_value(), lift > 0.02) << lift;
      if (!found) continue;
      EXPECT_FALSE(!found->is_proved || found->is_more);
      EXPECT_GT(found->thickness_mm * 1.1 + 0.011, lift);
      EXPECT_LT(found->thickness_mm, lift + 0.011);
      EXPECT_EQ(found->move, 0U);
      EXPECT_NEAR(found->point.z(), 0, 1e-9);
    }
    // Where nothing cuts at all it is as much as is distinguished.
    const auto gone = left(bench, before, sweep_of(tool.cutting, {row(60, 0)}));
    ASSERT_TRUE(gone.has_value());
    EXPECT_TRUE(gone->is_more);
    EXPECT_DOUBLE_EQ(gone->thickness_mm, 20);
  }
}

TEST(LeftStock, OfAFlatEndTiltedAboutItsEdgeIsItsWidthTimesTheSine) {
  const Bench bench = floor_alone();
  const ToolVariants tool = tools::flat(10);
  const CutterSweep before = sweep_of(tool.cutting, {row(0, 0)});
  for (const double degrees : {0.5, 3.0, 12.0}) {
    const double angle = degrees * kDegree;
    // About the edge at x = 5: the tip is 5 mm from it along the tilted end.
    const Vec3 axis(std::sin(angle), 0, std::cos(angle));
    const Vec3 tip(5 - 5 * std::cos(angle), 0, 5 * std::sin(angle));
    const auto found = left(bench, before, sweep_of(tool.cutting, {row(tip.x(), tip.z(), axis)}));
    ASSERT_TRUE(found.has_value());
    // From the floor at x = -5 to the other edge; to a tenth and 0.01 mm, and 0.1 mm from the border.
    EXPECT_LE(found->thickness_mm, 2 * 10 * std::sin(angle / 2) + 0.001);
    EXPECT_GE(found->thickness_mm * 1.1 + 0.011, (10 - 0.2) * std::sin(angle));
    EXPECT_LT(found->point.x(), -4.5);
  }
}

TEST(LeftStock, IsNoneWhereOtherMotionsCutIt) {
  const Bench bench = floor_alone();
  const ToolVariants tool = tools::flat(10);
  const CutterSweep before = sweep_of(tool.cutting, {row(0, 0)});
  const auto longer = [](double x) {
    return std::pair<Pose, Pose>{{Vec3(x, -25, 0), Vec3::UnitZ()}, {Vec3(x, 25, 0), Vec3::UnitZ()}};
  };
  // Rows at both sides that together reach over the strip, or not.
  EXPECT_FALSE(left(bench, before, sweep_of(tool.cutting, {longer(-3), longer(3)})));
  const auto found = left(bench, before, sweep_of(tool.cutting, {longer(-6), longer(6)}));
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(found->thickness_mm, 1, 0.11);
  EXPECT_NEAR(found->point.x(), 0, 0.11);
}

// A gouged surface was not finished, nor was its rim, which a cutter crosses at any angle.
TEST(LeftStock, IsNoneWhereThePathBeforeGouged) {
  const Bench bench = floor_alone();
  for (const ToolVariants& tool : tools::all()) {
    for (const double depth : {0.02, 0.1, 0.3, 1.0, 3.0}) {
      const CutterSweep before = sweep_of(tool.cutting, {row(0, -depth)});
      const auto found = left(bench, before, sweep_of(tool.cutting, {row(0, 0)}));
      EXPECT_FALSE(found.has_value()) << depth << ": " << found->thickness_mm << " at " << found->point.transpose();
    }
  }
}

// Its side is flush with that of the block, from within: that finishes no wall.
TEST(LeftStock, OfAWallIsNoneForACutterInsideTheSolid) {
  const Bench bench = floor_alone();
  const ToolVariants tool = tools::flat(10);
  const CutterSweep before = sweep_of(tool.cutting, {row(95, -0.3)}), after = sweep_of(tool.cutting, {row(95, 0)});
  StockLimits limits = kUsual;
  EXPECT_TRUE(left(bench, before, after, limits).has_value()) << "a surface may be seen from either side";
  limits.are_solids = true;
  EXPECT_FALSE(left(bench, before, after, limits).has_value());
}

// A slot that is too narrow: its walls are gouged and its floor is finished.
TEST(LeftStock, OfAFloorIsSeenBesideWallsThatWereGouged) {
  const Bench bench({shapes::box(Vec3(-100, -100, -10), Vec3(100, 100, 0)),
                     shapes::box(Vec3(-20, -100, -5), Vec3(-4.9, 100, 8)),
                     shapes::box(Vec3(4.9, -100, -5), Vec3(20, 100, 8))});
  const ToolVariants tool = tools::flat(10);
  const auto found =
      left(bench, sweep_of(tool.cutting, {row(0, 0)}), sweep_of(tool.cutting, {row(0, 8)}), {0.01, 0.02, 20});
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(found->thickness_mm, 8, 0.82);
  EXPECT_NEAR(found->point.z(), 0, 1e-9);
}

// Dips into a floor that one row finishes: of the strip that the row finished between them the lift is left.
TEST(LeftStock, IsSeenBetweenGouges) {
  const Bench bench = floor_alone();
  const ToolVariants tool = tools::ball(10);
  const auto dip = [](double y) {
    return std::pair<Pose, Pose>{{Vec3(0, y, 0), Vec3::UnitZ()}, {Vec3(0, y, -0.5), Vec3::UnitZ()}};
  };
  const auto found =
      left(bench, sweep_of(tool.cutting, {row(0, 0), dip(-10), dip(10)}), sweep_of(tool.cutting, {row(0, 0.25)}));
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(found->thickness_mm, 0.25, 0.036);
  EXPECT_GT(std::abs(std::abs(found->point.y()) - 10), std::sqrt(5 * 5 - 4.5 * 4.5)) << "the dips are that wide";
}

TEST(LeftStock, OfABallIsNoneWhileItsCentreStays) {
  const Bench bench = floor_alone();
  const ToolVariants tool = tools::ball(10);
  const CutterSweep before = sweep_of(tool.cutting, {row(0, 0)});
  for (const double degrees : {2.0, 20.0}) {
    const Vec3 axis(std::sin(degrees * kDegree), 0, std::cos(degrees * kDegree));
    const Vec3 tip = Vec3(0, 0, 5) - 5 * axis;
    EXPECT_FALSE(left(bench, before, sweep_of(tool.cutting, {row(tip.x(), tip.z(), axis)})));
    EXPECT_TRUE(left(bench, before, sweep_of(tool.cutting, {row(tip.x(), tip.z() + 0.02, axis)})));
  }
}

TEST(LeftStock, IsOfAWallThatTheFlankFinished) {
  const Bench bench(
      {shapes::box(Vec3(-100, -100, -10), Vec3(100, 100, 0)), shapes::box(Vec3(5, -100, 0), Vec3(20, 100, 20))});
  const ToolVariants tool = tools::ball(10);
  const CutterSweep before = sweep_of(tool.cutting, {row(0, 0)});
  const Vec3 axis = Vec3(-0.1, 0, 1).normalized(), tip = Vec3(0, 0, 5) - 5 * axis;
  const auto found = left(bench, before, sweep_of(tool.cutting, {row(tip.x(), tip.z(), axis)}));
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(found->point.x(), 5, 1e-9);
  // At the top of the wall, 15 mm above the centre and 5 mm beside it.
  EXPECT_NEAR(found->thickness_mm, (5 + 15 * 0.1) / std::hypot(0.1, 1) - 5, 0.035);
}

TEST(LeftStock, IsTheSameFromBothSidesOfAMesh) {
  const ToolVariants tool = tools::bull(10, 2);
  const CutterSweep before = sweep_of(tool.cutting, {row(0, 0)});
  const CutterSweep after = sweep_of(tool.cutting, {row(0.5, 0.05, Vec3(0.02, 0, 1))});
  const Bench usual = floor_alone();
  const Bench turned({shapes::inside_out(usual.parts.front())});
  const auto one = left(usual, before, after), other = left(turned, before, after);
  ASSERT_TRUE(one && other);
  EXPECT_NEAR(one->thickness_mm, other->thickness_mm, 0.11 * one->thickness_mm + 0.011);
}

// Against samples of both paths: where nothing is left, no sample is; where some is, none is left much higher. Samples
// are of what a row on a floor finished, away from where a dip gouged it.
TEST(LeftStock, HoldsForSamplesOfRandomPaths) {
  const Bench bench = floor_alone();
  test::Scatter random(11);
  std::size_t none = 0, some = 0, samples = 0;
  std::vector<ToolVariants> all = tools::all();
  all.push_back(tools::shapes()[2]);  // a lollipop, which is not convex
  for (int n = 0; n < 40; ++n) {
    const ToolVariants& tool = all[static_cast<std::size_t>(n) % all.size()];
    const Pose a{Vec3(random.in(-6, 6), -8, 0), Vec3::UnitZ()}, b{Vec3(random.in(-6, 6), 8, 0), Vec3::UnitZ()};
    const Pose low{a.tip + Vec3(0, random.in(0, 16), 0), a.axis}, deep{low.tip - Vec3(0, 0, random.in(0.1, 2)), a.axis};
    const double lift = random.is(0.5) ? 0 : random.in(0, 0.4);
    Pose c = a, d = b;
    if (random.is(0.5)) c.axis = d.axis = (a.axis + random.in(0, 0.1) * random.axis(0.4).normalized()).normalized();
    c.tip.z() += lift;
    d.tip.z() += lift;
    const CutterSweep before = sweep_of(tool.cutting, {{a, b}, {low, deep}}), after = sweep_of(tool.cutting, {{c, d}});
    const auto found = left(bench, before, after);
    (found ? some : none) += 1;
    const double most = found ? found->thickness_mm * 1.1 + 0.011 : kUsual.allowed_mm;
    if (found && (found->is_more || !found->is_proved)) continue;
    const Motion row_motion = test::straight(a, b), dip = test::straight(low, deep), new_motion = test::straight(c, d);
    const auto nearest = [&](const Motion& motion, const Vec3& point, int instants) {
      double least = 1e9;
      for (int k = 0; k <= instants; ++k)
        least = std::min(least, signed_distance_mm(tool.cutting, motion.at(static_cast<double>(k) / instants), point));
      return least;
    };
    const auto is_near_gouge = [&](const Vec3& point) {
      for (int k = 0; k < 49; ++k) {
        const double angle = k * std::numbers::pi / 8, away = k == 0 ? 0 : 0.2 * (1 + (k - 1) / 16);
        if (nearest(dip, point + away * Vec3(std::cos(angle), std::sin(angle), 0), 20) < -0.009) return true;
      }
      return false;
    };
    for (int k = 0; k < 60; ++k) {
      const Vec3 point(random.in(-8, 8), random.in(-8, 8), 0);
      if (nearest(row_motion, point + Vec3(0, 0, 0.11), 1600) > -0.101 || is_near_gouge(point)) continue;
      ++samples;
      const double away = nearest(new_motion, point, 1600);
      EXPECT_LE(away, most + 1e-3) << n << " at " << point.transpose() << ", lift " << lift;
    }
  }
  EXPECT_GT(samples, 100U);
  EXPECT_GT(none, 3U);
  EXPECT_GT(some, 3U);
}

}  // namespace
}  // namespace gouge::left_stock_test
