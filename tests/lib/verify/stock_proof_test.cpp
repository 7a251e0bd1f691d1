// What a proof about stock rests on: blocks, cutters at one instant, and blocks beside a stock. Each against random points.
#include "lib/verify/stock_claims.h"

#include <gtest/gtest.h>

#include <cmath>

#include "lib/mesh/indexed_mesh.h"
#include "lib/verify/claimed_pose.h"
#include "lib/verify/coaxial_cut.h"
#include "tests/support/paths.h"
#include "tests/support/reference_contour.h"
#include "tests/support/scatter.h"
#include "tests/support/shapes.h"
#include "tests/support/tools.h"

namespace gouge::stock_proof_test {
namespace {

SpaceBlock random_block(test::Scatter& scatter, const Vec3& center, double size) {
  SpaceBlock block{center, {}};
  const BlockFrame frame = frame_along(scatter.direction(), scatter.direction());
  for (std::size_t k = 0; k < 3; ++k) block.arms[k] = size * std::pow(10, scatter.in(-1.5, 0)) * frame[k];
  return block;
}

Vec3 point_in(const SpaceBlock& block, test::Scatter& scatter) {
  Vec3 point = block.center;
  for (const Vec3& arm : block.arms) {
    const double share = scatter.in(-1.2, 1.2);
    point += std::clamp(share, -1.0, 1.0) * arm;
  }
  return point;
}

std::vector<ToolVariants> every_tool() {
  std::vector<ToolVariants> every = tools::shapes();
  for (const ToolVariants& tool : tools::all()) every.push_back(tool);
  return every;
}

/// Returns an upper bound of how deep a point is in a tool that runs straight with a fixed axis, at its deepest instant.
double deepest_on_way(const reference::Contour& tool, const Pose& from, const Vec3& way, const Vec3& point) {
  constexpr int kInstants = 400;
  double deepest = -1e9;
  for (int k = 0; k <= kInstants; ++k)
    deepest = std::max(deepest, tool.depth({Vec3(from.tip + k * way / kInstants), from.axis}, point));
  return deepest + 0.5 * way.norm() / kInstants;
}

CutPoses exactly(const Pose& pose) {
  const PoseBounds bounds{Bounds3(pose.tip), widened(Bounds3(pose.axis), 4e-16)};
  return {bounds, bounds};
}

TEST(SpaceBlock, ContainsItsBoxAndIsTheSumOfItsHalves) {
  test::Scatter scatter(31);
  const RoundsUpward upward;
  for (int k = 0; k < 200; ++k) {
    const Vec3 one = scatter.point(50), other = scatter.point(50);
    const Vec3 low = one.cwiseMin(other), high = one.cwiseMax(other);
    const BlockFrame frame =
        frame_along(scatter.direction(), scatter.is(0.1) ? Vec3::Zero().eval() : scatter.direction());
    const SpaceBlock block = block_around(low, high, frame);
    const auto shares_of = [](const SpaceBlock& of, const Vec3& point) {
      Eigen::Matrix3d arms;
      for (int i = 0; i < 3; ++i) arms.col(i) = of.arms[static_cast<std::size_t>(i)];
      return Vec3(arms.inverse() * (point - of.center));
    };
    for (std::size_t c = 0; c < 8; ++c) {
      const Vec3 corner((c & 1U) != 0 ? low.x() : high.x(), (c & 2U) != 0 ? low.y() : high.y(),
                        (c & 4U) != 0 ? low.z() : high.z());
      EXPECT_LE(shares_of(block, corner).cwiseAbs().maxCoeff(), 1.0);
    }
    SpaceBlock part = block;
    for (int n = 0; n < 20; ++n) {
      const Vec3 point = point_in(part, scatter);
      const std::array<SpaceBlock, 2> halves = part.halves(scatter.below(3));
      const double first = shares_of(halves[0], point).cwiseAbs().maxCoeff(),
                   second = shares_of(halves[1], point).cwiseAbs().maxCoeff();
      EXPECT_LE(std::min(first, second), 1 + 1e-6);
      EXPECT_LE((point - part.center).norm(), part.radius_mm() * (1 + 1e-12));
      part = halves[scatter.below(2)];
    }
  }
}

TEST(NamedCut, ContainsNoPointThatIsFartherFromTheCutterThanTheResolution) {
  test::Scatter scatter(32);
  const RoundsUpward upward;
  const std::vector<ToolVariants> all = every_tool();
  std::size_t within = 0;
  for (const ToolVariants& tool : all) {
    const ToolContour cutter(tool.cutting);
    const reference::Contour exact(tool.cutting);
    std::size_t of_tool = 0;
    for (int k = 0; k < 4000; ++k) {
      const Pose pose{scatter.point(40), scatter.direction()};
      const double wider = scatter.is(0.2) ? 0 : std::pow(10, scatter.in(-3, 0));
      const double r = scatter.in(0, cutter.largest_radius_mm()), z = scatter.in(0, 30);
      const Vec3 center = pose.tip + z * pose.axis + r * pose.axis.unitOrthogonal();
      const SpaceBlock block = random_block(scatter, center, scatter.in(0.01, 3));
      if (!is_within_cutter(cutter, exactly(pose), block, wider)) continue;
      ++of_tool;
      for (int n = 0; n < 30; ++n) EXPECT_GE(exact.depth(pose, point_in(block, scatter)), -wider - 1e-8);
    }
    EXPECT_GT(of_tool, 20U);
    within += of_tool;
  }
  EXPECT_GT(within, 10'000U);
}

// A thin block about the axis may reach below the tip by wider / sqrt(2), and no farther.
TEST(NamedCut, DoesNotReachBeyondTheTip) {
  const RoundsUpward upward;
  const ToolVariants tool = tools::flat(10);
  const auto holds = [&](double below) {
    const SpaceBlock block{Vec3(0, 0, 5 - below), {Vec3(0.01, 0, 0), Vec3(0, 0.01, 0), Vec3(0, 0, 5)}};
    return is_within_cutter(ToolContour(tool.cutting), exactly({}), block, 0.05);
  };
  EXPECT_TRUE(holds(0.0353));
  EXPECT_FALSE(holds(0.0354));
  EXPECT_FALSE(holds(4));
}

// A flat cutter of diameter 10: the block may reach beyond the flank by wider / sqrt(2), and no farther.
TEST(NamedCut, IsTightForACylinder) {
  const RoundsUpward upward;
  const ToolVariants tool = tools::flat(10);
  const ToolContour cutter(tool.cutting);
  const auto holds = [&](double reach) {
    const SpaceBlock block{Vec3(0.5 * reach, 0, 10), {Vec3(0.5 * reach, 0, 0), Vec3(0, 1e-6, 0), Vec3(0, 0, 5)}};
    return is_within_cutter(cutter, exactly({}), block, 0.05);
  };
  EXPECT_TRUE(holds(5 + 0.0353));
  EXPECT_FALSE(holds(5 + 0.0354));
}

TEST(NamedCut, ContainsNoPointThatIsFartherFromAStraightCutThanTheResolution) {
  test::Scatter scatter(35);
  const RoundsUpward upward;
  const std::vector<ToolVariants> all = every_tool();
  std::size_t within = 0, longer = 0;
  for (const ToolVariants& tool : all) {
    const ToolContour cutter(tool.cutting);
    const reference::Contour exact(tool.cutting);
    for (int k = 0; k < 3000; ++k) {
      const Pose from{scatter.point(20), scatter.direction()};
      const Vec3 way = scatter.is(0.5) ? scatter.point(20) : Vec3(20 * scatter.direction().cross(from.axis));
      const CutPoses poses{exactly(from).first, exactly({Vec3(from.tip + way), from.axis}).first};
      const Vec3 center = from.tip + scatter.in(0, 1) * way + scatter.in(0, 20) * from.axis;
      SpaceBlock block{center, {}};
      const BlockFrame frame = frame_along(from.axis, way);
      for (std::size_t i = 0; i < 3; ++i) block.arms[i] = std::pow(10, scatter.in(-1, 1)) * frame[i];
      const double wider = std::pow(10, scatter.in(-3, 0));
      if (!is_within_cutter(cutter, poses, block, wider)) continue;
      ++within;
      if (block.arms[0].norm() > cutter.largest_radius_mm()) ++longer;
      for (int n = 0; n < 20; ++n) {
        const Vec3 point = point_in(block, scatter);
        EXPECT_GE(deepest_on_way(exact, from, way, point), -wider - 1e-8);
      }
    }
  }
  EXPECT_GT(within, 2000U);
  EXPECT_GT(longer, 100U);
}

// Points that are deep in a body, in the block, at instants of a move: all of them are in the cutter that is said to have
// been where the body is.
TEST(CoaxialCut, ContainsAllThatIsDeepInTheBody) {
  test::Scatter scatter(36);
  const RoundsUpward upward;
  const std::vector<ToolVariants> all = every_tool();
  std::size_t within = 0, points = 0;
  for (int k = 0; k < 40'000; ++k) {
    const ToolVariants &mover = all[scatter.below(all.size())], &cutter = all[scatter.below(all.size())];
    const CompiledTool& form = scatter.is(0.5) ? mover.bare : mover.non_cutting;
    const ToolContour body(form), contour(cutter.cutting);
    const Vec3 axis = scatter.axis(0.3), way = scatter.is(0.5) ? scatter.point(8) : Vec3(scatter.in(-8, 8) * axis);
    const double lean = scatter.is(0.5) ? 0.0 : 0.02;
    const Pose from{scatter.point(1), axis};
    const Pose to{Vec3(from.tip + way), Vec3((axis + lean * scatter.point(1)).normalized())};
    const Pose cut{Vec3(from.tip + scatter.point(0.3) + scatter.in(-3, 20) * axis),
                   Vec3((axis + lean * scatter.point(1)).normalized())};
    const CutPoses poses{exactly(cut).first, exactly({Vec3(cut.tip + scatter.in(0.5, 1.5) * way), cut.axis}).first};
    const MotionPiece piece(exactly(from).first, exactly(to).first);
    const TimeSpan span = span_of(&piece, &piece + 1);
    SpaceBlock block{Vec3(from.tip + 0.5 * way + scatter.in(0, 30) * axis), {}};
    const BlockFrame frame = frame_along(axis, scatter.direction());
    for (std::size_t i = 0; i < 3; ++i) block.arms[i] = (i == 2 ? scatter.in(0, 3) : 40.0) * frame[i];
    const double depth = scatter.in(0, 1), wider = scatter.in(0, 0.5);
    if (!is_deep_part_within({body, depth, block, span}, contour, poses, wider)) continue;
    ++within;
    const reference::Contour exact_body(form), exact_cutter(cutter.cutting);
    for (int n = 0; n < 60; ++n) {
      const double t = scatter.in(0, 1);
      const Pose pose{Vec3(from.tip + t * way), Vec3(((1 - t) * from.axis + t * to.axis).normalized())};
      const double z = (block.center - pose.tip).dot(pose.axis) + scatter.in(-3, 3);
      const Vec3 point =
          pose.tip + z * pose.axis + scatter.in(0, 6) * pose.axis.cross(scatter.direction()).normalized();
      const bool is_in_block = std::abs((point - block.center).dot(frame[2])) <= block.arms[2].norm();
      if (!is_in_block || exact_body.depth(pose, point) < depth) continue;
      ++points;
      const Vec3 cut_way = poses.last.tip.middle() - cut.tip;
      EXPECT_GE(deepest_on_way(exact_cutter, cut, cut_way, point), -wider - 1e-5);
    }
  }
  EXPECT_GT(within, 200U);
  EXPECT_GT(points, 1000U);
}

TEST(NamedCut, IsAtTheInstantThatItsNumbersState) {
  test::Scatter scatter(33);
  const RoundsUpward upward;
  const ToolVariants tool = tools::flat(10);
  for (int k = 0; k < 100; ++k) {
    const Toolpath path =
        paths::through({{scatter.point(20), scatter.axis(0.5)}, {scatter.point(20), scatter.axis(0.5)}});
    const std::vector<ClaimedProgram> programs{{ClaimedScene{path, {&tool}, {}, {}, {}}, {&tool}, {true}}};
    const CutPrograms cuts(programs);
    NamedCut cut;
    cut.move = 1;
    cut.level = scatter.below(12);
    cut.first = cut.last = scatter.below((1ULL << cut.level) + 1);
    ASSERT_NE(cuts.cutter_of(cut), nullptr);
    const auto poses = cuts.poses_of(cut);
    ASSERT_TRUE(poses.has_value());
    const Pose pose = claimed_pose(programs[0].scene, 1, cut.share());
    EXPECT_LT((poses->first.tip.middle() - pose.tip).norm(), 1e-9);
    EXPECT_LT((poses->last.axis.middle() - pose.axis).norm(), 1e-9);
    if (cut.first > 0) {
      NamedCut time = cut;
      --time.first;
      EXPECT_FALSE(cuts.poses_of(time).has_value()) << "the axis turns";
    }
    std::string steps;
    append_cut(cut, steps);
    std::string_view left = steps;
    EXPECT_EQ(take_cut(left), cut);
    EXPECT_TRUE(left.empty());
    cut.move = 0;
    EXPECT_EQ(cuts.cutter_of(cut), nullptr) << "a position is no cut";
  }
}

TEST(StockSpace, HasNoPointOfTheStockInABlockBesideIt) {
  test::Scatter scatter(34);
  const RoundsUpward upward;
  std::size_t beside = 0;
  for (const double allowance : {0.0, 0.02, 1.0}) {
    const IndexedMesh mesh = shapes::box(Vec3(-10, -8, -5), Vec3(10, 8, 5)),
                      hole = shapes::box(Vec3(12, -8, -5), Vec3(15, 8, 5));
    ClaimedStock stock;
    stock.resolution_mm = 0.05;
    stock.allowance_mm = allowance;
    stock.solids.emplace_back(mesh);
    stock.solids.emplace_back(hole);
    const StockSpace space(stock);
    for (int k = 0; k < 3000; ++k) {
      const SpaceBlock block = random_block(scatter, scatter.point(18), scatter.in(0.01, 6));
      bool may_be_outside = true;
      const bool is_beside = space.is_beside(block, may_be_outside);
      if (!is_beside) continue;
      ++beside;
      for (int n = 0; n < 10; ++n) {
        const Vec3 point = point_in(block, scatter);
        for (const SolidDepth& solid : stock.solids) {
          const double depth = solid.at(point);
          EXPECT_LE((depth > 0 ? depth : -solid.distance_to_surface(point)) + allowance, 0.05 + 1e-9);
        }
      }
    }
  }
  EXPECT_GT(beside, 1000U);
}

/// A slot, and the same slot again with a shank as wide as the cutter, which passes where the cutter was.
struct Slot {
  Slot() {
    ToolAssembly assembly = tools::assembly(FlatCutter{10, 5}, 10);
    assembly.shank = {{10, 10, 40}};
    assembly.holder.clear();
    tool = std::make_unique<ToolVariants>(tools::variants(assembly));
    path = paths::through(
        {paths::upright(-30, 0, -4), paths::upright(30, 0, -4), paths::upright(30, 0, -8), paths::upright(-30, 0, -8)});
    stock.low = Vec3(-20, -20, -20);
    stock.high = Vec3(20, 20, 0);
    stock.tolerance_mm = 0.1;
    stock.resolution_mm = 0.05;
    stock.programs.push_back({ClaimedScene{path, {tool.get()}, {}, {}, {}}, {tool.get()}, {true}});
  }
  std::unique_ptr<ToolVariants> tool;
  Toolpath path;
  ClaimedStock stock;
};

TEST(StockClaims, AreProvedForAShankThatFillsItsSlotAndRefutedWithoutTheSlot) {
  Slot of;
  const StockDepths depths(4, of.stock.largest_clear_mm());
  ProofGroup group{3, 1, {}};
  const RoundsUpward upward;
  {
    const StockClaims claims(of.stock, depths);
    ASSERT_TRUE(claims.is_askable(3));
    ASSERT_TRUE(claims.search()->find(3, 1, group.steps));
    EXPECT_FALSE(claims.refute(group).has_value());
    ProofGroup longer = group;
    longer.steps.push_back(2);
    EXPECT_TRUE(claims.refute(longer).has_value());
    ProofGroup shorter = group;
    shorter.steps.pop_back();
    EXPECT_TRUE(claims.refute(shorter).has_value());
  }
  of.path.moves[1].kind = MoveKind::rapid;
  const StockClaims claims(of.stock, depths);
  EXPECT_TRUE(claims.refute(group).has_value());
  std::string steps;
  EXPECT_FALSE(claims.search()->find(3, 1, steps));
}

TEST(StockClaims, AreNotProvedOfHeadsNorOfSeveralMotions) {
  Slot of;
  const StockDepths depths(4, of.stock.largest_clear_mm());
  of.stock.is_motion_open = true;
  EXPECT_FALSE(StockClaims(of.stock, depths).is_askable(3));
  of.stock.is_motion_open = false;
  const IndexedMesh head = shapes::box(Vec3(-5, -5, 50), Vec3(5, 5, 60));
  of.stock.heads.emplace_back(head);
  EXPECT_FALSE(StockClaims(of.stock, depths).is_askable(3));
}

// A cut proves that material is gone from its own instant on.
TEST(StockClaims, AreRefutedByACutThatComesLater) {
  Slot of;
  const StockDepths depths(4, of.stock.largest_clear_mm());
  ProofGroup group{3, 1, {}};
  const RoundsUpward upward;
  ASSERT_TRUE(StockClaims(of.stock, depths).search()->find(3, 1, group.steps));
  // The same program with both slots exchanged: the wide shank goes first.
  std::swap(of.path.moves[1].end, of.path.moves[3].end);
  of.path = paths::through(
      {paths::upright(-30, 0, -8), paths::upright(30, 0, -8), paths::upright(30, 0, -4), paths::upright(-30, 0, -4)});
  const StockClaims claims(of.stock, depths);
  group.first = 1;
  EXPECT_TRUE(claims.refute(group).has_value());
}

}  // namespace
}  // namespace gouge::stock_proof_test
