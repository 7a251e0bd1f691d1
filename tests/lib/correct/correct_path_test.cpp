#include "lib/correct/correct_path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "tests/support/paths.h"
#include "tests/support/shapes.h"
#include "tests/support/tools.h"
#include "tests/support/whole_check.h"

namespace gouge::correct_path_test {
namespace {

using paths::upright;

struct Case {
  Toolpath path;
  ToolVariants tool = tools::ball();
  Scene scene;
  CheckOptions options;
  CorrectOptions correct;
};

CheckResult check(const Case& c, const Toolpath& path) { return whole_check(path, &c.tool, c.scene, c.options); }

Correction propose(const Case& c) {
  return correct_path(c.path, check(c, c.path), OwnSetup(&c.tool, c.scene, c.options).setup, c.correct);
}

double rounded(double x) { return std::round(x * 1e4) / 1e4; }

/// As a writer does it: numbers of four decimals, inserted positions as moves of their own.
Toolpath applied(const Toolpath& path, const Correction& correction) {
  Toolpath changed = path;
  changed.moves.clear();
  const auto round_tip = [](Pose pose) {
    for (int k = 0; k < 3; ++k) pose.tip[k] = rounded(pose.tip[k]);
    return pose;
  };
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    Move move = path.moves[i];
    for (const PathChange& change : correction.changes) {
      if (change.move != i) continue;
      for (const Pose& stop : change.inserted_before) {
        Move inserted = move;
        inserted.end = round_tip(stop);
        changed.moves.push_back(inserted);
        move.has_start = true;
      }
      if (change.new_end) move.end = round_tip(*change.new_end);
    }
    changed.moves.push_back(move);
  }
  return changed;
}

void expect_clean_again(const Case& c, const Correction& correction) {
  EXPECT_TRUE(correction.uncorrected.empty());
  const Toolpath changed = applied(c.path, correction);
  const CheckResult again = check(c, changed);
  EXPECT_EQ(again.counts.clean, changed.moves.size())
      << "worst " << again.worst_depth_mm << " in move " << again.worst_move;
}

std::set<std::size_t> changed_moves(const Correction& correction) {
  std::set<std::size_t> moves;
  for (const PathChange& change : correction.changes) moves.insert(change.move);
  return moves;
}

/// The positions themselves, not only the moves before them.
std::set<std::size_t> moved_positions(const Correction& correction) {
  std::set<std::size_t> moves;
  for (const PathChange& change : correction.changes) {
    if (change.new_end) moves.insert(change.move);
  }
  return moves;
}

/// A ball along a block whose top is z = 0: clean, but for two positions too deep.
Case two_dips() {
  Case c;
  std::vector<Pose> poses;
  for (int i = 0; i < 12; ++i) poses.push_back(upright(2.0 * i - 11, 0.3, i == 4 || i == 9 ? -0.2 : 0.0));
  c.path = paths::through(poses);
  c.scene.parts = {shapes::box(Vec3(-50, -50, -30), Vec3(50, 50, 0))};
  return c;
}

TEST(CorrectPath, ChangesTheTwoDipsAndNothingElse) {
  for (const Strategy strategy : {Strategy::weighted, Strategy::axis}) {
    Case c = two_dips();
    c.correct.strategies = BodyStrategies::all(strategy);
    const Correction correction = propose(c);
    EXPECT_EQ(changed_moves(correction), (std::set<std::size_t>{4, 9}));
    for (const PathChange& change : correction.changes) EXPECT_TRUE(change.inserted_before.empty());
    ASSERT_EQ(correction.records.size(), 2U);
    EXPECT_EQ(correction.records[0].strategy, strategy);
    EXPECT_NEAR(correction.records[0].depth_before_mm, 0.2, 0.001);
    EXPECT_LE(correction.records[0].depth_after_mm, 0.008);
    EXPECT_NEAR(correction.records[0].shift_mm.z(), 0.195, 0.004);
    EXPECT_GT(correction.records[0].iterations, 0);
    expect_clean_again(c, correction);
  }
}

// The programmed ramp leaves the tolerance so slowly that the end of its clean part is as deep as a clean motion may be.
TEST(CorrectPath, ARampIntoTheSurfaceBecomesTheStraightFeedToItsCorrectedEnd) {
  for (const ToolVariants& tool : {tools::flat(12), tools::ball()}) {
    for (const Strategy strategy : {Strategy::normal, Strategy::weighted, Strategy::axis}) {
      for (const double depth : {0.012, 0.02, 0.05, 0.1, 0.25, 0.5}) {
        Case c;
        c.tool = tool;
        c.path = paths::through({upright(-20, 0.3, 0), upright(10, 0.3, 0), upright(40, 0.3, -depth)});
        c.scene.parts = {shapes::box(Vec3(-50, -50, -30), Vec3(50, 50, 0))};
        c.correct.strategies = BodyStrategies::all(strategy);
        const Correction correction = propose(c);
        expect_clean_again(c, correction);
        ASSERT_EQ(correction.changes.size(), 1U) << depth;
        EXPECT_TRUE(correction.changes[0].inserted_before.empty()) << depth;
        ASSERT_TRUE(correction.changes[0].new_end.has_value());
        EXPECT_NEAR(correction.changes[0].new_end->tip.z(), -0.003, 0.0025) << depth;
      }
    }
  }
}

TEST(CorrectPath, NoPositionOfARampRisesOutOfTheSurface) {
  // Ends about as deep as a motion may be, where the accuracy of the search decides.
  for (const double start : {-0.0078, -0.0081, -0.0084, -0.009, -0.0099}) {
    Case c;
    c.tool = tools::flat(12);
    c.path = paths::through({upright(-20, 0.3, start), upright(10, 0.3, start), upright(40, 0.3, -0.05)});
    c.scene.parts = {shapes::box(Vec3(-50, -50, -30), Vec3(50, 50, 0))};
    const Correction correction = propose(c);
    expect_clean_again(c, correction);
    for (const Move& move : applied(c.path, correction).moves) EXPECT_LE(move.end.tip.z(), 0.001) << start;
  }
}

TEST(CorrectPath, StaysOnTheCutUpToBothSidesOfARib) {
  Case c;
  c.path = paths::through({upright(-20, 0.3, 0), upright(20, 0.3, 0)});
  c.scene.parts = {shapes::box(Vec3(-50, -50, -30), Vec3(50, 50, 0)), shapes::box(Vec3(-1, -40, -1), Vec3(1, 40, 8))};
  const Correction correction = propose(c);
  expect_clean_again(c, correction);
  ASSERT_EQ(correction.changes.size(), 1U);
  const std::vector<Pose>& stops = correction.changes[0].inserted_before;
  ASSERT_GE(stops.size(), 2U);
  for (const Pose& stop : {stops.front(), stops.back()}) {
    EXPECT_NEAR(stop.tip.z(), 0, 1e-9);
    EXPECT_LT(std::abs(stop.tip.x()), 7);
  }
}

TEST(CorrectPath, ACleanPathIsLeftAlone) {
  Case c = two_dips();
  for (Move& move : c.path.moves) move.end.tip.z() = 0;
  const Correction correction = propose(c);
  EXPECT_TRUE(correction.changes.empty());
  EXPECT_TRUE(correction.records.empty());
  EXPECT_TRUE(correction.uncorrected.empty());
}

// 2 mm deep across a block, with the clamp's top 0.2 mm above the tip: neither may be grazed afterwards.
TEST(CorrectPath, ARapidGoesOverWhatItMetWithItsClearanceAndNotWithinTheTolerance) {
  for (const double clearance : {1.0, 5.0}) {
    Case c;
    c.options.tolerance_mm = 0.2;
    c.correct.rapid_clearance_mm = clearance;
    c.path = paths::through({upright(-90, 0, -2), upright(90, 0, -2)}, MoveKind::rapid);
    c.scene.parts = {shapes::box(Vec3(-50, -50, -30), Vec3(30, 50, 0))};
    c.scene.fixtures = {shapes::box(Vec3(35, -50, -30), Vec3(50, 50, -1.8))};
    const Correction correction = propose(c);
    EXPECT_TRUE(correction.uncorrected.empty());
    ASSERT_EQ(correction.changes.size(), 1U);
    const std::vector<Pose>& inserted = correction.changes[0].inserted_before;
    ASSERT_EQ(inserted.size(), 2U) << "up and down again";
    c.options.tolerance_mm = 0.0;
    c.options.near_miss_mm = clearance - 0.01;
    EXPECT_EQ(check(c, applied(c.path, correction)).counts.clean, 4U) << clearance;
    EXPECT_LE(inserted[0].tip.z(), 1.4 * clearance + 0.3) << "no higher than it must";
  }
}

/// A rapid 5 mm above the floor from (-40, y) to (40, y), and a square post of 12 mm about z.
Case rapid_past_a_post(double y, double post_mm) {
  Case c;
  c.correct.strategies = BodyStrategies::all(Strategy::normal);
  c.path = paths::through({upright(-40, y, 5), upright(40, y, 5)}, MoveKind::rapid);
  c.scene.parts = {shapes::box(Vec3(-60, -60, -10), Vec3(60, 60, 0)),
                   shapes::box(Vec3(-6, -6, -1), Vec3(6, 6, post_mm))};
  return c;
}

double nearest(const Case& c, const Toolpath& path) {
  double low = 0, high = 20;
  for (int step = 0; step < 20; ++step) {
    CheckOptions near = c.options;
    near.tolerance_mm = 0;
    near.near_miss_mm = 0.5 * (low + high);
    const CheckResult result = whole_check(path, &c.tool, c.scene, near);
    (result.counts.clean == result.verdicts.size() ? low : high) = near.near_miss_mm;
  }
  return low;
}

TEST(CorrectPath, ARapidThatGrazesGoesRoundWithItsClearanceWhereNoLiftGoesOver) {
  Case c = rapid_past_a_post(10.97, 60);
  c.correct.rapid_clearance_mm = 2;
  const Correction correction = propose(c);
  EXPECT_TRUE(correction.uncorrected.empty());
  EXPECT_GE(nearest(c, applied(c.path, correction)), 1.99);
}

TEST(CorrectPath, TheLiftThatTheLargestShiftAllowsIsFoundAlsoBetweenThoseTried) {
  Case c = rapid_past_a_post(0, 58);
  c.correct.rapid_clearance_mm = 2;
  for (const double most : {56.0, 60.0, 70.0}) {
    c.correct.max_shift_mm = most;
    const Correction correction = propose(c);
    ASSERT_EQ(correction.changes.size(), 1U) << most;
    EXPECT_GE(nearest(c, applied(c.path, correction)), 1.99) << most;
    for (const Pose& stop : correction.changes[0].inserted_before) EXPECT_LE(stop.tip.z() - 5, most);
  }
  // Neither over it nor round it.
  c.correct.max_shift_mm = 50;
  c.scene.parts.push_back(shapes::box(Vec3(-6, -55, -1), Vec3(6, 55, 58)));
  const Correction none = propose(c);
  ASSERT_EQ(none.uncorrected.size(), 1U);
  EXPECT_EQ(none.uncorrected[0].reason, "no clean path was found between its positions within --max-shift 50 mm");
}

TEST(CorrectPath, APositionWhereARapidEndsTooDeepGetsTheClearance) {
  Case c;
  c.path = paths::through({upright(-90, 0, 20), upright(0, 0, -0.5), upright(0, 0, 20)}, MoveKind::rapid);
  c.scene.parts = {shapes::box(Vec3(-50, -50, -30), Vec3(50, 50, 0))};
  const Correction correction = propose(c);
  ASSERT_EQ(changed_moves(correction), (std::set<std::size_t>{1}));
  EXPECT_NEAR(correction.changes[0].new_end->tip.z(), 1, 0.01);
  expect_clean_again(c, correction);
  c.path.moves[1].kind = MoveKind::feed;
  EXPECT_NEAR(propose(c).changes[0].new_end->tip.z(), -0.005, 0.003) << "a cut stays a cut";
  c.scene = {{}, c.scene.parts};
  EXPECT_GE(propose(c).changes[0].new_end->tip.z(), 0) << "but not in a fixture";
}

TEST(CorrectPath, TheDepthAfterIsTheDepthThatIsLeft) {
  Case c = two_dips();
  c.options.tolerance_mm = 0.1;
  const Correction correction = propose(c);
  ASSERT_EQ(correction.records.size(), 2U);
  for (const ChangeRecord& record : correction.records) {
    EXPECT_NEAR(record.depth_after_mm, 0.2 - record.shift_mm.z(), 0.001);
    EXPECT_GT(record.depth_after_mm, 0.03);
  }
}

TEST(CorrectPath, NoPositionIsInsertedOnTheStraightWayBetweenItsNeighbours) {
  Case c;  // a rib whose flanks the tool rides over: flat on top
  c.tool = tools::flat();
  c.path = paths::through({upright(-20, 0, 0), upright(20, 0, 0)});
  c.scene.parts = {shapes::box(Vec3(-3, -20, -30), Vec3(3, 20, 2))};
  const Correction correction = propose(c);
  expect_clean_again(c, correction);
  std::vector<Pose> way = {c.path.moves[0].end};
  for (const PathChange& change : correction.changes)
    way.insert(way.end(), change.inserted_before.begin(), change.inserted_before.end());
  way.push_back(c.path.moves[1].end);
  ASSERT_GE(way.size(), 4U);
  for (std::size_t i = 1; i + 1 < way.size(); ++i) {
    const Vec3 along = (way[i + 1].tip - way[i - 1].tip).normalized();
    const Vec3 from = way[i].tip - way[i - 1].tip;
    EXPECT_GT((from - from.dot(along) * along).norm(), 1e-4) << i << " of " << way.size();
  }
}

TEST(CorrectPath, PositionsAreInsertedWhereARibStandsBetweenCleanOnes) {
  Case c;
  c.path = paths::through({upright(-20, 0, 0.5), upright(20, 0, 0.5), upright(20, 10, 0.5)});
  c.scene.parts = {shapes::box(Vec3(-60, -50, -10), Vec3(60, 50, 0)), shapes::box(Vec3(-1, -50, -1), Vec3(1, 50, 6))};
  const Correction correction = propose(c);
  EXPECT_EQ(changed_moves(correction), (std::set<std::size_t>{1}));
  ASSERT_EQ(correction.changes.size(), 1U);
  EXPECT_FALSE(correction.changes[0].new_end.has_value());
  EXPECT_GE(correction.changes[0].inserted_before.size(), 1U);
  for (const ChangeRecord& record : correction.records) EXPECT_TRUE(record.is_inserted);
  expect_clean_again(c, correction);
}

TEST(CorrectPath, AToleranceOf0GetsCleanToo) {
  Case c = two_dips();
  c.options.tolerance_mm = 0;
  for (Move& move : c.path.moves) move.end.tip.z() += 0.02;
  const Correction correction = propose(c);
  EXPECT_EQ(moved_positions(correction), (std::set<std::size_t>{4, 9}));
  expect_clean_again(c, correction);
}

TEST(CorrectPath, AnEnteredClearanceGetsCleanToo) {
  // The holder (16 mm, from z = 50) must stay 1 mm from a wall at x = 17.2; one position is too near.
  Case c;
  c.correct.strategies = BodyStrategies::all(Strategy::weighted);
  c.tool = tools::variants(tools::assembly(BallCutter{10, 30}), 0, 0, 1);
  c.options.holder_clearance_mm = 1;
  c.scene.parts = {shapes::box(Vec3(-30, -60, -20), Vec3(12, 60, 0)),
                   shapes::box(Vec3(17.2, -60, 0), Vec3(40, 60, 85))};
  std::vector<Pose> poses;
  for (int i = 0; i < 9; ++i) poses.push_back({Vec3(i == 4 ? 0.6 : 0.0, 5.0 * i - 20, 0.1), Vec3::UnitZ()});
  c.path = paths::through(poses);
  const CheckResult before = check(c, c.path);
  ASSERT_EQ(before.counts.gouge, 2U);
  EXPECT_EQ(before.verdicts[4].witness->body, Body::holder);
  const Correction correction = propose(c);
  EXPECT_EQ(moved_positions(correction), (std::set<std::size_t>{4}));
  expect_clean_again(c, correction);
}

TEST(CorrectPath, TiltedAxesStayAsTheyAre) {
  Case c;
  std::vector<Pose> poses;
  for (int i = 0; i < 30; ++i) {
    const double a = 0.2 * i;
    poses.push_back(
        {Vec3(1.5 * i - 20, 3 * std::sin(a), 11.5 + 0.5 * std::cos(a)), Vec3(0.3 * std::sin(a), 0.2, 1).normalized()});
  }
  c.path = paths::through(poses);
  c.scene.parts = {shapes::sphere(12, 24, 48)};
  ASSERT_GT(check(c, c.path).counts.gouge, 3U);
  const Correction correction = propose(c);
  for (const PathChange& change : correction.changes) {
    const Vec3& axis = c.path.moves[change.move].end.axis;
    EXPECT_EQ(change.new_end.value_or(c.path.moves[change.move].end).axis, axis);
  }
  expect_clean_again(c, correction);
}

TEST(CorrectPath, BeyondTheLargestShiftItIsListedWithTheReasonAndLeft) {
  Case c = two_dips();
  c.correct.max_shift_mm = 0.1;
  const Correction correction = propose(c);
  EXPECT_TRUE(correction.changes.empty());
  std::set<std::size_t> listed;
  for (const Uncorrected& u : correction.uncorrected) {
    listed.insert(u.move);
    const std::string no_way = "no way out within --max-shift 0.1 mm; a lift of 0.19";
    EXPECT_TRUE(
        u.reason.starts_with((u.move == 4 || u.move == 9 ? "" : "it begins at a position that stays: ") + no_way))
        << u.reason;
    EXPECT_NE(u.reason.find(" mm along the tool axis would free it: --max-shift 0.19"), std::string::npos) << u.reason;
    EXPECT_NEAR(u.depth_mm, 0.2, 0.001);
  }
  EXPECT_EQ(listed, (std::set<std::size_t>{4, 5, 9, 10}));
}

TEST(CorrectPath, ABuriedMoveIsListedWithTheReason) {
  Case c;
  c.path = paths::through({upright(0, 0, 0), upright(20, 0, 0)});
  c.scene.parts = {shapes::box(Vec3(-500, -500, -500), Vec3(500, 500, 500))};
  const Correction correction = propose(c);
  EXPECT_TRUE(correction.changes.empty());
  ASSERT_EQ(correction.uncorrected.size(), 2U);
  EXPECT_EQ(correction.uncorrected[0].reason, "the tool is buried: there is no way out to follow");
}

TEST(CorrectPath, ArcsAndTheirEndsAreNotTouched) {
  Case c = two_dips();
  c.path.moves[5].kind = MoveKind::arc;  // begins in the first dip
  c.path.moves[9].kind = MoveKind::arc;  // ends in the second
  for (const std::size_t i : {5U, 9U}) c.path.moves[i].not_checked_reason = "an arc";
  const Correction correction = propose(c);
  EXPECT_TRUE(correction.changes.empty());
  std::set<std::string> reasons;
  for (const Uncorrected& u : correction.uncorrected) reasons.insert(u.reason);
  EXPECT_EQ(reasons.count("an arc or a step of a cycle begins at the position"), 1U);
}

TEST(CorrectPath, OneAndTwoThreadsProposeTheSameBits) {
  Case c = two_dips();
  c.scene.parts.push_back(shapes::box(Vec3(0.4, -50, -1), Vec3(0.6, 50, 2)));
  c.options.threads = 1;
  const Correction one = propose(c);
  c.options.threads = 2;
  const Correction two = propose(c);
  ASSERT_EQ(one.changes.size(), two.changes.size());
  ASSERT_GT(one.changes.size(), 2U);
  for (std::size_t i = 0; i < one.changes.size(); ++i) {
    EXPECT_EQ(one.changes[i].move, two.changes[i].move);
    EXPECT_EQ(one.changes[i].new_end.has_value(), two.changes[i].new_end.has_value());
    if (one.changes[i].new_end && two.changes[i].new_end) {
      EXPECT_EQ(one.changes[i].new_end->tip, two.changes[i].new_end->tip);
    }
    ASSERT_EQ(one.changes[i].inserted_before.size(), two.changes[i].inserted_before.size());
    for (std::size_t k = 0; k < one.changes[i].inserted_before.size(); ++k) {
      EXPECT_EQ(one.changes[i].inserted_before[k].tip, two.changes[i].inserted_before[k].tip);
    }
  }
  EXPECT_EQ(one.uncorrected.size(), two.uncorrected.size());
}

// The start lies in a wall and is freed sideways; the end lies in a pin that no shift frees. On the straight line from
// the shifted start to the end the ball would cut a second pin, beside the programmed motion, less deep than the first.
TEST(CorrectPath, CutsNothingNewOnAMoveThatStaysAGouge) {
  Case c;
  c.correct.strategies = BodyStrategies::all(Strategy::weighted);
  c.tool = tools::ball(6);
  const IndexedMesh pin = shapes::box({20, 3.05, -1}, {21, 3.6, 50});
  c.scene.parts = {shapes::box({-30, -30, -20}, {90, 30, 0}), shapes::box({-3, -20, -1}, {3, -2, 60}),
                   shapes::box({55, -0.5, -1}, {56, 0.5, 50}), pin};
  c.path = paths::through({upright(0, 0, 2), upright(60, 0, 2), upright(60, 0, 100)});
  Case beside = c;
  beside.scene.parts = {pin};
  ASSERT_EQ(check(beside, c.path).counts.clean, 3U);
  const Correction correction = propose(c);
  ASSERT_FALSE(correction.changes.empty());
  const Toolpath after = applied(c.path, correction);
  const CheckResult found = check(beside, after);
  EXPECT_EQ(found.counts.clean, after.moves.size());
}

/// A row along the top of a block. Its last position is 0.2 mm too deep. The next move runs at rapid into a pin that no
/// shift of 1 mm frees. Move 1 crosses a rib.
Case rapid_into_a_pin() {
  Case c;
  c.correct.max_shift_mm = 1;
  c.scene.parts = {shapes::box({-60, -30, -20}, {90, 30, 0}), shapes::box({-41, -9, -1}, {-40, 9, 0.5}),
                   shapes::box({29.5, -0.5, -1}, {30.5, 0.5, 50})};
  c.path = paths::through(
      {upright(-50, 0, 1), upright(-30, 0, 0), upright(0, 0, -0.2), upright(30, 0, 2), upright(30, 0, 100)});
  c.path.moves[3].kind = c.path.moves[4].kind = MoveKind::rapid;
  return c;
}

TEST(CorrectPath, NoRapidGoesBackToItsStartAndTheFeedBeforeItDoes) {
  const Case c = rapid_into_a_pin();
  const Correction correction = propose(c);
  EXPECT_EQ(moved_positions(correction), (std::set<std::size_t>{}));
  const auto change = std::ranges::find(correction.changes, 2U, &PathChange::move);
  ASSERT_NE(change, correction.changes.end());
  ASSERT_FALSE(change->inserted_before.empty());
  EXPECT_NEAR(change->inserted_before.back().tip.z(), 0, 0.01);
  EXPECT_FALSE(changed_moves(correction).contains(3));
  const Toolpath after = applied(c.path, correction);
  const std::size_t last = after.moves.size();
  EXPECT_EQ(after.moves[last - 3].kind, MoveKind::feed);
  EXPECT_EQ(after.moves[last - 3].end.tip, c.path.moves[2].end.tip);
  EXPECT_EQ(check(c, after).verdicts[last - 4].state, MoveState::clean);
  const auto left = std::ranges::find(correction.uncorrected, 2U, &Uncorrected::move);
  ASSERT_NE(left, correction.uncorrected.end());
  EXPECT_TRUE(left->reason.starts_with("a rapid that stays begins at its end")) << left->reason;
}

TEST(CorrectPath, WhereARapidLeadsToTheStartOfARapidThatStaysBothStay) {
  Case c = rapid_into_a_pin();
  c.path.moves[2].kind = MoveKind::rapid;
  const std::set<std::size_t> changed = changed_moves(propose(c));
  EXPECT_FALSE(changed.contains(2));
  EXPECT_FALSE(changed.contains(3));
}

}  // namespace
}  // namespace gouge::correct_path_test
