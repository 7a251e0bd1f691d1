// Every bound against dense sampling: a bound that is once below the truth is a false clean.
#include <gtest/gtest.h>

#include <cmath>

#include "lib/check/hull_bound.h"
#include "lib/motion/motion.h"
#include "lib/tool/evaluate.h"
#include "tests/support/motions.h"
#include "tests/support/scatter.h"
#include "tests/support/tools.h"

namespace gouge::bounds_test {
namespace {

using test::Scatter;

/// Somewhere about the tool, most of it near the boundary of cutter, shank and holder.
Vec3 about_tool(Scatter& scatter) { return {scatter.in(-20, 20), scatter.in(-20, 20), scatter.in(-5, 130)}; }

double value_at(const CompiledTool& tool, const Motion& motion, double t, const Vec3& p, double reach) {
  const Pose pose = motion.at(t);
  const Vec3 d = p - pose.tip;
  const double z = d.dot(pose.axis);
  return reach - evaluate_brute_force(tool, (d - z * pose.axis).norm(), z).signed_distance_mm;
}

struct Case {
  Motion motion = MotionLaw::tool_at({});
  std::array<Vec3, 3> piece;
  double reach = 0;
};

Case random_case(Scatter& scatter) {
  const double way = std::pow(10, scatter.in(-2, 1));
  const double lean = std::pow(10, scatter.in(-3, -0.3));
  const double size = std::pow(10, scatter.in(-2, 1.3));
  const Vec3 tip = scatter.point(1);
  Case c;
  c.motion = test::straight({tip, scatter.axis(lean)}, {tip + scatter.point(way), scatter.axis(lean)});
  const Vec3 about = about_tool(scatter);
  Vec3 flat = scatter.in(0, 1) < 0.3 ? Vec3(1, 1, 0.01) : Vec3(1, 1, 1);  // lying across the axis: plateaus
  for (Vec3& corner : c.piece) corner = about + scatter.point(size).cwiseProduct(flat);
  c.reach = scatter.in(0, 1) < 0.5 ? 0.0 : scatter.in(0, 5);
  return c;
}

double sampled(const CompiledTool& tool, const Case& c, const ToolInterval& interval) {
  double most = -1e300;
  constexpr int kSteps = 6;
  for (int k = 0; k <= kSteps; ++k) {
    const double t = interval.t0 + (interval.t1 - interval.t0) * k / kSteps;
    for (int i = 0; i <= kSteps; ++i) {
      for (int j = 0; i + j <= kSteps; ++j) {
        const double u = static_cast<double>(i) / kSteps, v = static_cast<double>(j) / kSteps;
        const Vec3 p = (1 - u - v) * c.piece[0] + u * c.piece[1] + v * c.piece[2];
        most = std::max(most, value_at(tool, c.motion, t, p, c.reach));
      }
    }
  }
  return most;
}

TEST(Bounds, APieceIsNeverDeeperThanItsBound) {
  Scatter scatter(20);
  std::size_t tight = 0, positive = 0;
  const auto tools = tools::all();
  for (int i = 0; i < 60000; ++i) {
    const CompiledTool& tool = tools[static_cast<std::size_t>(i) % tools.size()].bare;
    const Case c = random_case(scatter);
    const ToolInterval whole(c.motion, whole_segment(c.motion, 0));
    const PieceBound bound = bound_piece(tool, c.piece, whole, c.reach, -1e300);
    const double most = sampled(tool, c, whole);
    ASSERT_LE(most, std::max(0.0, bound.upper_mm) + 1e-9) << "case " << i;
    ASSERT_LE(bound.value_mm, std::max(0.0, bound.upper_mm) + 1e-9) << "case " << i;
    if (most > 0.1) ++positive;
    if (most > 0.1 && bound.upper_mm < most + 0.1) ++tight;
  }
  EXPECT_GT(positive, 5000U);
  EXPECT_GT(tight, positive / 20);  // far from what a ball alone would give
}

// There the plane at the foot is any of the arc's planes, and rounding must not make it a foreign one.
TEST(Bounds, APieceAboutTheCentreOfAnArcIsNeverDeeperThanItsBound) {
  Scatter scatter(22);
  const ToolVariants dovetail = tools::variants(tools::assembly(TaperedCutter{20, 0.5, -30, 8}, 8));
  const ToolVariants cone = tools::variants(tools::assembly(AptCutter{20, 2, 0, 0, 20, 15, 30}));
  const ToolVariants grown = tools::variants(tools::assembly(BallCutter{10, 30}), 0.3, 0.3, 0.3);
  const Motion rest = MotionLaw::tool_at({});
  const ToolInterval whole(rest, whole_segment(rest, 0));
  for (const CompiledTool* tool : {&dovetail.bare, &cone.bare, &grown.against_part}) {
    for (const BoundaryElement& e : tool->elements) {
      if (e.kind != ElementKind::arc) continue;
      const Vec3 center(e.center.x(), 0, e.center.y());
      for (int i = 0; i < 400; ++i) {
        Case c;
        const double size = std::pow(10, scatter.in(-2.5, 1));
        c.piece[0] = center + scatter.point(size);
        c.piece[1] = center + scatter.point(size);
        c.piece[2] = 3 * center - c.piece[0] - c.piece[1];
        const PieceBound bound = bound_piece(*tool, c.piece, whole, 0, -1e300);
        ASSERT_LE(sampled(*tool, c, whole), bound.upper_mm + 1e-9) << "piece of size " << size;
      }
    }
  }
}

ProfilePoint corner_at(double r, double z) { return {ProfilePoint::SegmentShape::straight, r, z, 0}; }
ProfilePoint bulge_to(double r, double z, double radius) { return {ProfilePoint::SegmentShape::convex, r, z, radius}; }

/// Faces over a shank that narrows, hollow undersides, and contours that turn back in height.
std::vector<ToolVariants> tools_with_pockets() {
  std::vector<ToolVariants> made = tools::shapes();
  for (const Cutter& cutter : std::vector<Cutter>{
           TaperedCutter{10.8, 5.4, 4.8, 13}, AptCutter{6, 1.4, 0, 0, -4.5, 0, 16}, AptCutter{24, 0, 0, 0, -25, -5, 15},
           ProfileCutter{{corner_at(0, 0), corner_at(1.2, 0), bulge_to(4.5, 1.5, 3.1), bulge_to(1.6, 5.1, 7.7),
                          bulge_to(5, 6.1, 4.6), corner_at(5, 7.3)}}}) {
    ToolAssembly tool = tools::assembly(cutter, 6);
    tool.shank = {{14, 10.8, 7}, {10, 12, 10}};
    tool.holder = {{47, 28, 28}, {17, 46, 20}};
    made.push_back(tools::variants(tool));
  }
  return made;
}

TEST(Bounds, APieceBesideFacesHollowsAndLipsIsNeverDeeperThanItsBound) {
  Scatter scatter(23);
  const std::vector<ToolVariants> all = tools_with_pockets();
  std::size_t tight = 0, positive = 0;
  for (std::size_t i = 0; i < 40000; ++i) {
    const CompiledTool& tool = all[i % all.size()].bare;
    const BoundaryElement& e = tool.elements[scatter.next() % tool.elements.size()];
    Case c = random_case(scatter);
    const double size = std::pow(10, scatter.in(-2.5, 1)), share = scatter.in(0, 1);
    const Vec2 on = e.a + share * (e.b - e.a);
    const Vec3 about = c.motion.start().tip + Vec3(on.x(), 0, on.y()) + scatter.point(0.3 * size);
    for (Vec3& corner : c.piece) corner = about + scatter.point(size);
    const ToolInterval whole(c.motion, whole_segment(c.motion, 0));
    const PieceBound bound = bound_piece(tool, c.piece, whole, c.reach, -1e300);
    const double most = sampled(tool, c, whole);
    ASSERT_LE(most, std::max(0.0, bound.upper_mm) + 1e-9) << "case " << i << " " << tool.name;
    if (most > 0.1) ++positive;
    if (most > 0.1 && bound.upper_mm < 1.5 * most) ++tight;
  }
  EXPECT_GT(positive, 5000U);
  EXPECT_GT(tight, positive / 10);
}

TEST(Bounds, AFlatOnItsFloorNeedsOneLook) {
  const ToolVariants flat = tools::flat();
  const std::array<Vec3, 3> floor{Vec3(-3, -3, 0), Vec3(3, -2, 0), Vec3(0, 3, 0)};
  const Motion slide = test::straight({Vec3::Zero(), Vec3::UnitZ()}, {Vec3(0.5, 0, 0), Vec3::UnitZ()});
  const ToolInterval whole(slide, whole_segment(slide, 0));
  EXPECT_LE(bound_piece(flat.bare, floor, whole, 0, 0).upper_mm, 1e-12);
}

}  // namespace
}  // namespace gouge::bounds_test
