// Arcs that must change and stay arcs.
#include "lib/correct/shift_arc.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "lib/correct/correct_path.h"
#include "tests/support/motions.h"
#include "tests/support/paths.h"
#include "tests/support/shapes.h"
#include "tests/support/tools.h"
#include "tests/support/whole_check.h"

namespace gouge::shift_arc_test {
namespace {

using paths::upright;

constexpr double kTurn = 2 * std::numbers::pi;

// A circle of radius 10 on a floor at height 0.
struct FloorCase {
  ToolVariants tool = tools::flat();
  Scene scene;
  CheckOptions options;
  Toolpath path;

  explicit FloorCase(double depth, double sweep = kTurn) {
    scene.parts.push_back(shapes::box(Vec3(-40, -40, -10), Vec3(40, 40, 0)));
    const Vec3 end(10 * std::cos(sweep), 10 * std::sin(sweep), -depth);
    path = paths::through({upright(10, 0, 20), upright(10, 0, -depth), upright(end.x(), end.y(), end.z()),
                           upright(end.x(), end.y(), 20)});
    if (sweep >= kTurn) path.moves[2].end.tip = path.moves[3].end.tip = path.moves[1].end.tip;
    path.moves[3].end.tip.z() = 20;
    path.moves[2].kind = MoveKind::arc;
    path.moves[2].curve_kind = CurveKind::arc;
    path.arcs.push_back({Vec3(0, 0, -depth), Vec3::UnitZ(), sweep});
    for (std::size_t i = 0; i < path.moves.size(); ++i) path.moves[i].statement = i;
  }

  [[nodiscard]] Correction correct(bool can_rewrite = true) const {
    const OwnSetup own(&tool, scene, options);
    RewritableMoves rewritable;
    rewritable.arc.assign(path.moves.size(), can_rewrite);
    CorrectOptions correct;
    correct.rewritable = &rewritable;
    return correct_path(path, check(path, own.setup), own.setup, correct);
  }

  [[nodiscard]] std::optional<PathArc> shifted(const Vec3& start_by, const Vec3& end_by) const {
    const OwnSetup own(&tool, scene, options);
    ArcTask task{
        path.arcs[0], path.moves[1].end, path.moves[2].end, path.moves[1].end, path.moves[2].end, MoveKind::arc, &tool};
    task.new_start.tip += start_by;
    task.new_end.tip += end_by;
    return shift_arc(task, own.checker());
  }
};

const PathChange* change_of(const Correction& correction, std::size_t move) {
  for (const PathChange& change : correction.changes) {
    if (change.move == move) return &change;
  }
  return nullptr;
}

TEST(ShiftArc, OneCircleALittleTooDeepStaysOneCircle) {
  const FloorCase c(0.031);
  const Correction correction = c.correct();
  EXPECT_TRUE(correction.uncorrected.empty());
  const PathChange* change = change_of(correction, 2);
  ASSERT_NE(change, nullptr);
  EXPECT_FALSE(change->is_straightened);
  EXPECT_TRUE(change->inserted_before.empty());
  ASSERT_TRUE(change->new_arc.has_value());
  ASSERT_TRUE(change->new_end.has_value());
  EXPECT_NEAR(change->new_arc->center.x(), 0, 1e-9);
  EXPECT_NEAR(change->new_arc->center.z(), change->new_end->tip.z(), 1e-9);
  EXPECT_GT(change->new_end->tip.z(), -c.options.tolerance_mm);
  EXPECT_EQ(change->new_end->tip, change_of(correction, 1)->new_end->tip) << "a full circle still";
  const Motion motion = test::along(*change->new_end, *change->new_end, *change->new_arc);
  const OwnSetup own(&c.tool, c.scene, c.options);
  EXPECT_EQ(own.checker().check(motion, MoveKind::arc, c.tool, c.options).state, MoveState::clean);
  EXPECT_EQ(std::count_if(correction.records.begin(), correction.records.end(),
                          [](const ChangeRecord& record) { return record.move == 2; }),
            1);
}

TEST(ShiftArc, APartOfACircleToo) {
  const Correction correction = FloorCase(0.5, 2).correct();
  const PathChange* change = change_of(correction, 2);
  ASSERT_NE(change, nullptr);
  ASSERT_TRUE(change->new_arc.has_value());
  EXPECT_NEAR(change->new_arc->sweep_rad, 2, 1e-6);
}

TEST(ShiftArc, WhereTheFileCannotSayItItBecomesStraight) {
  const Correction correction = FloorCase(0.031).correct(false);
  const PathChange* change = change_of(correction, 2);
  ASSERT_NE(change, nullptr);
  EXPECT_TRUE(change->is_straightened);
  EXPECT_FALSE(change->new_arc.has_value());
}

TEST(ShiftArc, TakesTheRadiusThatItsEndsAskFor) {
  FloorCase c(0, 2);
  c.scene.parts = {shapes::box(Vec3(10.7, -40, -10), Vec3(40, 40, 10))};  // a wall beside the start
  c.tool = tools::flat(2);
  const Vec3 in = -0.5 * Vec3::UnitX(), end_in = -0.5 * c.path.moves[2].end.tip.normalized();
  c.options.tolerance_mm = 0.6;  // so that no part of the arc need be too deep
  const auto arc = c.shifted(in, end_in);
  ASSERT_TRUE(arc.has_value());
  EXPECT_NEAR((c.path.moves[1].end.tip + in - arc->center).norm(),
              (c.path.moves[2].end.tip + end_in - arc->center).norm(), 1e-9);
}

TEST(ShiftArc, NothingWhereEndsPartOrOneSideAloneIsTooDeep) {
  const FloorCase circle(0.031);
  EXPECT_FALSE(circle.shifted(Vec3(0, 0, 0.03), Vec3(0, 0, 0.04)).has_value()) << "no longer a full circle";
  const FloorCase part(0.031, 2);
  EXPECT_TRUE(part.shifted(Vec3(0, 0, 0.03), Vec3(0, 0, 0.03)).has_value());
  EXPECT_FALSE(part.shifted(Vec3(0, 0, 0.03), Vec3(0, 0, 0.04)).has_value()) << "a helix";
  EXPECT_FALSE(part.shifted(Vec3(0, 0, 0.01), Vec3(0, 0, 0.01)).has_value()) << "still too deep";
  FloorCase half(0.031, 2);
  half.scene.parts = {shapes::box(Vec3(5, -40, -10), Vec3(40, 40, 0))};
  EXPECT_FALSE(half.shifted(Vec3(0, 0, 0.03), Vec3(0, 0, 0.03)).has_value()) << "the rest is where it belongs";
}

}  // namespace
}  // namespace gouge::shift_arc_test
