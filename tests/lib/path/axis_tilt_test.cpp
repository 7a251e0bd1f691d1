#include "lib/path/axis_tilt.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace gouge::axis_tilt_test {
namespace {

Vec3 leaning(double angle_rad) { return {std::sin(angle_rad), 0, std::cos(angle_rad)}; }

Move feed_to(const Vec3& tip, const Vec3& axis, bool has_start = true) {
  Move move;
  move.end = {tip, axis};
  move.has_start = has_start;
  return move;
}

// Positions at x = 0, 1, ... with an upright axis.
Toolpath upright(std::size_t count) {
  Toolpath path;
  for (std::size_t i = 0; i < count; ++i)
    path.moves.push_back(feed_to(Vec3(static_cast<double>(i), 0, 0), Vec3::UnitZ(), i > 0));
  return path;
}

std::vector<std::size_t> same(const Toolpath& path) {
  std::vector<std::size_t> origins;
  for (std::size_t i = 0; i < path.moves.size(); ++i) origins.push_back(i);
  return origins;
}

const TiltPlace& place_at(const TiltedRun& run, double length_mm) {
  std::size_t best = 0;
  for (std::size_t i = 0; i < run.curve.size(); ++i) {
    if (std::abs(run.curve[i].length_mm - length_mm) < std::abs(run.curve[best].length_mm - length_mm)) best = i;
  }
  return run.curve[best];
}

TEST(AxisTilt, OfAnUnchangedPathIsNone) {
  const Toolpath path = upright(5);
  const AxisTilts tilts = find_axis_tilts(path, path, same(path));
  EXPECT_EQ(tilts.positions, 0U);
  EXPECT_TRUE(tilts.runs.empty());
  EXPECT_EQ(tilts.tilt_rad.move, kNone);
  EXPECT_TRUE(find_axis_tilts(path, path, {}).runs.empty());
}

// The tip moves aside while the tool tilts about a contact: that is no feed.
TEST(AxisTilt, FadesInOnAPlungeAsItGoesOnBehindIt) {
  Toolpath before;
  for (int i = 0; i <= 10; ++i) before.moves.push_back(feed_to(Vec3(0, 0, 10 - i), Vec3::UnitZ(), i > 0));
  for (int i = 1; i <= 10; ++i) before.moves.push_back(feed_to(Vec3(0, i, 0), Vec3::UnitZ()));
  Toolpath after = before;
  for (std::size_t i = 0; i < after.moves.size(); ++i) {
    Pose& end = after.moves[i].end;
    end.axis = leaning(-0.03 * static_cast<double>(std::min(i, std::size_t{10})));
    end.tip += 5 * (Vec3::UnitZ() - end.axis);
  }
  const AxisTilts tilts = find_axis_tilts(before, after, same(after));
  ASSERT_EQ(tilts.runs.size(), 1U);
  // -X is left of a feed along Y.
  double last = 0;
  for (const TiltPlace& place : tilts.runs[0].curve) {
    EXPECT_NEAR(place.lead_after_rad, 0, 1e-9);
    EXPECT_GE(place.side_after_rad, last - 1e-9);
    last = place.side_after_rad;
  }
  EXPECT_NEAR(last, 0.3, 1e-9);
}

TEST(AxisTilt, IsSplitIntoLeadAndSideOfTheFeed) {
  const Toolpath before = upright(21);
  Toolpath after = before;
  after.moves[10].end.axis = leaning(0.1);
  after.moves[11].end.axis = Vec3(0, std::sin(0.2), std::cos(0.2));
  const AxisTilts tilts = find_axis_tilts(before, after, same(after));
  EXPECT_EQ(tilts.positions, 2U);
  EXPECT_NEAR(tilts.tilt_rad.value, 0.2, 1e-12);
  EXPECT_EQ(tilts.tilt_rad.move, 11U);
  ASSERT_EQ(tilts.runs.size(), 1U);
  const TiltedRun& run = tilts.runs[0];
  EXPECT_EQ(run.first, 10U);
  EXPECT_EQ(run.last, 13U) << "the move from the last tilted position turns back";
  EXPECT_NEAR(run.begin_mm, 1, 1e-12) << "behind a margin of a millimetre";
  EXPECT_NEAR(run.end_mm, 4, 1e-12);
  EXPECT_NEAR(run.curve.back().length_mm, 5, 1e-12);
  const TiltPlace &lead = place_at(run, 2), &side = place_at(run, 3);
  EXPECT_NEAR(lead.lead_after_rad, 0.1, 1e-12);
  EXPECT_NEAR(lead.side_after_rad, 0, 1e-12);
  EXPECT_NEAR(lead.lead_before_rad, 0, 1e-12);
  EXPECT_NEAR(side.lead_after_rad, 0, 1e-12);
  EXPECT_NEAR(side.side_after_rad, 0.2, 1e-12) << "Y is left of a feed along X";
}

TEST(AxisTilt, OfACornerIsDrawnOnBothSidesOfIt) {
  Toolpath before = upright(3);
  before.moves.push_back(feed_to(Vec3(2, 1, 0), Vec3::UnitZ()));
  before.moves.push_back(feed_to(Vec3(2, 2, 0), Vec3::UnitZ()));
  Toolpath after = before;
  after.moves[2].end.axis = leaning(0.1);
  const AxisTilts tilts = find_axis_tilts(before, after, same(after));
  ASSERT_EQ(tilts.runs.size(), 1U);
  std::vector<TiltPlace> at_corner;
  for (const TiltPlace& place : tilts.runs[0].curve) {
    if (std::abs(place.length_mm - 2) < 1e-9) at_corner.push_back(place);
  }
  ASSERT_EQ(at_corner.size(), 2U);
  EXPECT_NEAR(at_corner[0].lead_after_rad, 0.1, 1e-12);
  EXPECT_NEAR(at_corner[1].lead_after_rad, 0, 1e-12);
  EXPECT_NEAR(at_corner[1].side_after_rad, -0.1, 1e-12) << "X is right of a feed along Y";
}

TEST(AxisTilt, OfALongMoveBesideTheRunIsCutToTheMargin) {
  Toolpath before;
  for (const double x : {0.0, 1000.0, 1010.0, 2000.0})
    before.moves.push_back(feed_to(Vec3(x, 0, 0), Vec3::UnitZ(), x > 0));
  Toolpath after = before;
  after.moves.insert(after.moves.begin() + 2,
                     {feed_to(Vec3(1002, 0, 0), Vec3::UnitZ()), feed_to(Vec3(1005, 0, 0), leaning(0.1)),
                      feed_to(Vec3(1008, 0, 0), Vec3::UnitZ())});
  const AxisTilts tilts = find_axis_tilts(before, after, {0, 1, 2, 2, 2, 2, 3});
  ASSERT_EQ(tilts.runs.size(), 1U);
  EXPECT_NEAR(tilts.runs[0].curve.back().length_mm, 6 + 2 * 1, 1e-9);
  EXPECT_NEAR(place_at(tilts.runs[0], 4).lead_after_rad, 0.1, 1e-12);
}

TEST(AxisTilt, FollowsAnArcAndEndsAtRapids) {
  // A half circle between rapids, at whose end the axis leans outwards: to the right of a feed to the left.
  Toolpath before;
  for (const Vec3& tip : {Vec3(10, -5, 0), Vec3(10, 0, 0), Vec3(-10, 0, 0), Vec3(-10, -5, 0)})
    before.moves.push_back(feed_to(tip, Vec3::UnitZ(), tip.y() >= 0 || tip.x() < 0));
  before.moves[1].kind = before.moves[3].kind = MoveKind::rapid;
  before.moves[2].kind = MoveKind::arc;
  before.moves[2].curve_kind = CurveKind::arc;
  before.arcs.push_back({Vec3::Zero(), Vec3::UnitZ(), std::numbers::pi});
  Toolpath after = before;
  after.moves[2].end.axis = leaning(-0.2);
  const AxisTilts tilts = find_axis_tilts(before, after, same(after));
  ASSERT_EQ(tilts.runs.size(), 1U);
  const TiltedRun& run = tilts.runs[0];
  EXPECT_EQ(run.begin_mm, 0) << "no margin in a rapid";
  EXPECT_GT(run.curve.size(), 10U) << "chords of the arc";
  const double half = 10 * std::numbers::pi;
  EXPECT_NEAR(run.end_mm, half + 5, 0.2) << "the rapid behind turns the axis back";
  // Half way round the feed leads against X, where the axis leans by half as much.
  EXPECT_NEAR(place_at(run, half / 2).lead_after_rad, 0.1, 2e-3);
  EXPECT_NEAR(place_at(run, half / 2).side_after_rad, 0, 5e-3);
}

TEST(AxisTilt, KeepsTheLongestRuns) {
  const Toolpath before = upright(400);
  Toolpath after = before;
  for (std::size_t i = 10; i < 390; i += 20) {
    after.moves[i].end.axis = leaning(0.1);
    if (i % 40 == 10) after.moves[i + 1].end.axis = leaning(0.1);
  }
  const AxisTilts tilts = find_axis_tilts(before, after, same(after), 8);
  ASSERT_EQ(tilts.runs.size(), 8U);
  EXPECT_EQ(tilts.runs_left_out, 11U);
  for (const TiltedRun& run : tilts.runs) EXPECT_EQ(run.last - run.first, 3U);
  EXPECT_LT(tilts.runs[0].first, tilts.runs[7].first) << "in path order";
}

TEST(ProgrammedAxis, OfAnInsertedPositionIsThatOfItsPlace) {
  Toolpath before;
  before.moves = {feed_to(Vec3::Zero(), leaning(0), false), feed_to(Vec3(10, 0, 0), leaning(0.4))};
  Toolpath after = before;
  after.moves.insert(after.moves.begin() + 1, {feed_to(Vec3(5, 0, 0), Vec3(0, std::sin(0.3), std::cos(0.3)))});
  const std::vector<Vec3> axes = programmed_axes(before, after, {0, 1, 1});
  EXPECT_LT((axes[1] - leaning(0.2)).norm(), 0.01 / 10 * 0.4 + 1e-12);
  EXPECT_EQ(axes[2], before.moves[1].end.axis);
}

TEST(ProgrammedAxis, OfAPositionThatWasShiftedAndNotTiltedIsItsOwn) {
  Toolpath before;
  before.moves = {feed_to(Vec3::Zero(), leaning(0.5), false), feed_to(Vec3(10, 0, 0), leaning(0.9))};
  Toolpath after = before;
  // Lifted along its own axis from 0.3 of the motion: above 0.3 + 2 mm sin(0.62) of it.
  const Vec3 axis = leaning(0.62);
  after.moves.insert(after.moves.begin() + 1, {feed_to(Vec3(3, 0, 0) + 2 * axis, axis)});
  EXPECT_LT((programmed_axes(before, after, {0, 1, 1})[1] - axis).norm(), 1e-12);
  EXPECT_EQ(find_axis_tilts(before, after, {0, 1, 1}).positions, 0U);
}

TEST(ProgrammedAxis, OfAPositionOnAnArcGoesByTheArc) {
  Toolpath before;
  before.moves = {feed_to(Vec3(10, 0, 0), leaning(0), false), feed_to(Vec3(-10, 0, 0), leaning(0.4))};
  before.moves[1].kind = MoveKind::arc;
  before.moves[1].curve_kind = CurveKind::arc;
  before.arcs.push_back({Vec3::Zero(), Vec3::UnitZ(), std::numbers::pi});
  Toolpath after = before;
  const double quarter = std::sqrt(0.5);
  after.moves[1] = feed_to(Vec3(-10, 0, 0), leaning(0.4));
  after.moves.insert(after.moves.begin() + 1,
                     {feed_to(Vec3(10 * quarter, 10 * quarter, 0), Vec3(0, std::sin(0.3), std::cos(0.3)))});
  EXPECT_LT((programmed_axes(before, after, {0, 1, 1})[1] - leaning(0.1)).norm(), 1e-3);
}

}  // namespace
}  // namespace gouge::axis_tilt_test
