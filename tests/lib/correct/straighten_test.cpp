// Arcs that gouge become chords, are corrected, and end clean.
#include "lib/correct/straighten.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "lib/correct/correct_path.h"
#include "tests/support/paths.h"
#include "tests/support/shapes.h"
#include "tests/support/tools.h"
#include "tests/support/whole_check.h"

namespace gouge::straighten_test {
namespace {

using paths::through;
using paths::upright;

struct ArcCase {
  ToolVariants tool = tools::ball();
  Scene scene;
  Toolpath path;
  CheckOptions options;

  // A half circle of radius 10 over a floor, whose middle a ridge crosses; its ends are free.
  explicit ArcCase(double ridge_top) {
    scene.parts.push_back(shapes::box(Vec3(-3, 5, -10), Vec3(3, 15, ridge_top)));
    path = through({upright(20, 0, 0), upright(10, 0, 0), upright(-10, 0, 0), upright(-20, 0, 0)});
    path.moves[2].kind = MoveKind::arc;
    path.moves[2].curve_kind = CurveKind::arc;
    path.arcs.push_back({Vec3::Zero(), Vec3::UnitZ(), std::numbers::pi});
    for (std::size_t i = 0; i < path.moves.size(); ++i) path.moves[i].statement = i;
  }

  [[nodiscard]] CheckResult check(const Toolpath& checked) const { return whole_check(checked, &tool, scene, options); }
  [[nodiscard]] Correction correct() const {
    return correct_path(path, check(path), OwnSetup(&tool, scene, options).setup, {});
  }
};

// The path with the changes made, as a writer and a reader would.
Toolpath changed(const Toolpath& path, const Correction& correction) {
  Toolpath result = path;
  result.moves.clear();
  std::size_t next = 0;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    Move move = path.moves[i];
    const PathChange* change =
        next < correction.changes.size() && correction.changes[next].move == i ? &correction.changes[next++] : nullptr;
    if (change != nullptr) {
      if (change->is_straightened) {
        move.kind = MoveKind::feed;
        move.curve_kind = CurveKind::none;
      }
      for (const Pose& pose : change->inserted_before) {
        Move inserted = move;
        inserted.end = pose;
        result.moves.push_back(inserted);
        move.has_start = true;
      }
      if (change->new_end) move.end = *change->new_end;
    }
    result.moves.push_back(move);
  }
  return result;
}

TEST(Straighten, AGougingArcEndsInACleanCheck) {
  const ArcCase c(1);
  ASSERT_EQ(c.check(c.path).verdicts[2].state, MoveState::gouge);
  const Correction correction = c.correct();
  EXPECT_TRUE(correction.uncorrected.empty());
  ASSERT_FALSE(correction.changes.empty());
  for (const PathChange& change : correction.changes) EXPECT_TRUE(change.is_straightened);
  const CheckResult after = c.check(changed(c.path, correction));
  EXPECT_EQ(after.counts.clean, after.verdicts.size());
}

TEST(Straighten, ACleanArcStaysAnArc) {
  const ArcCase c(-1);
  ASSERT_EQ(c.check(c.path).counts.gouge, 0U);
  EXPECT_TRUE(c.correct().changes.empty());
}

// A list of positions on one circle, as NCL and Creo write them: the statement before them describes all of them.
TEST(Straighten, PositionsOfOneStatementGoTogetherThoughOneAloneGouges) {
  ArcCase c(1);
  const double w = std::sqrt(0.5) * 10;
  c.path = through({upright(20, 0, 0), upright(10, 0, 0), upright(w, w, 0), upright(-w, w, 0), upright(-10, 0, 0),
                    upright(-20, 0, 0)});
  for (std::size_t i = 0; i < c.path.moves.size(); ++i) {
    Move& move = c.path.moves[i];
    const bool is_arc = i >= 2 && i <= 4;
    move.statement = is_arc ? 2 : i;
    if (!is_arc) continue;
    move.kind = MoveKind::arc;
    move.curve_kind = CurveKind::arc;
    move.curve = c.path.arcs.size();
    c.path.arcs.push_back({Vec3::Zero(), Vec3::UnitZ(), std::numbers::pi / (i == 3 ? 2 : 4)});
  }
  const CheckResult before = c.check(c.path);
  ASSERT_EQ(before.verdicts[3].state, MoveState::gouge);
  ASSERT_EQ(before.verdicts[2].state, MoveState::clean);
  const Correction correction = c.correct();
  std::vector<std::size_t> straightened;
  for (const PathChange& change : correction.changes) {
    if (change.is_straightened) straightened.push_back(change.move);
  }
  EXPECT_EQ(straightened, (std::vector<std::size_t>{2, 3, 4}));
  const CheckResult after = c.check(changed(c.path, correction));
  EXPECT_EQ(after.counts.clean, after.verdicts.size());
}

TEST(Straighten, TheRestOfTheArcStaysOnIt) {
  const ArcCase c(1);
  const Correction correction = c.correct();
  std::size_t on = 0, off = 0;
  for (const Pose& pose : correction.changes.at(0).inserted_before) {
    const bool is_on = std::abs(pose.tip.norm() - 10) < 1e-9 && std::abs(pose.tip.z()) < 1e-9;
    ++(is_on ? on : off);
    EXPECT_TRUE(is_on || pose.tip.y() >= 1);
  }
  EXPECT_GT(on, 10U);
  EXPECT_GT(off, 3U);
}

}  // namespace
}  // namespace gouge::straighten_test
