#include "lib/path/path_info.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gouge::path_info_test {
namespace {

Move move_to(MoveKind kind, Vec3 tip, Vec3 axis, bool has_start = true) {
  Move move;
  move.kind = kind;
  move.has_start = has_start;
  move.end = {tip, axis};
  return move;
}

TEST(AngleBetween, IsAccurateAtBothEnds) {
  EXPECT_NEAR(angle_between_deg(Vec3::UnitZ(), Vec3(1e-9, 0, 1)), 1e-9 * 180 / 3.14159265358979, 1e-20);
  EXPECT_NEAR(angle_between_deg(Vec3::UnitZ(), -Vec3::UnitZ()), 180, 1e-12);
  EXPECT_NEAR(angle_between_deg(Vec3::UnitZ(), Vec3::UnitX()), 90, 1e-12);
}

TEST(DescribePath, CountsWhatIsThere) {
  Toolpath path;
  path.tools.resize(2);
  path.operations.resize(1);
  const Pose up{Vec3(0, 0, 10), Vec3::UnitZ()};
  path.moves.push_back(move_to(MoveKind::rapid, up.tip, up.axis, false));
  path.moves.push_back(move_to(MoveKind::feed, Vec3(0, 0, 4), Vec3(0, 0, 1)));
  path.moves.push_back(move_to(MoveKind::feed, Vec3(3, 0, 0), Vec3(1, 0, -0.0)));
  path.moves.push_back(move_to(MoveKind::arc, Vec3(3, 1, 0), Vec3(1, 0, 0.0)));
  path.moves[3].not_checked_reason = "because";
  path.moves[1].tool = path.moves[2].tool = path.moves[3].tool = 1;
  path.moves[2].operation = 0;
  const PathInfo info = describe_path(path);
  EXPECT_EQ(info.moves_by_kind, (std::array<std::size_t, 4>{2, 1, 1, 0}));
  EXPECT_EQ(info.alone, 1u);
  EXPECT_EQ(info.orientations, 2u) << "0 and -0 are one orientation";
  EXPECT_NEAR(info.largest_turn_deg, 90, 1e-12);
  EXPECT_NEAR(info.largest_tilt_deg, 90, 1e-12);
  EXPECT_EQ(info.largest_tilt_move, 2u) << "the first of equals";
  EXPECT_EQ(info.largest_turn_move, 2u);
  EXPECT_DOUBLE_EQ(info.feed_length_mm, 6 + 5);
  EXPECT_EQ(info.not_checkable.at("because"), 1u);
  EXPECT_EQ(info.moves_of_tool, (std::vector<std::size_t>{0, 3}));
  EXPECT_EQ(info.moves_without_tool, 1u);
  EXPECT_EQ(info.moves_of_operation, (std::vector<std::size_t>{1}));
  EXPECT_DOUBLE_EQ(info.box.max().x(), 3);
  EXPECT_DOUBLE_EQ(info.box.max().z(), 10);
}

TEST(DescribePath, AConstantAxisHasNoTilt) {
  Toolpath path;
  for (const double x : {0.0, 1.0, 2.0})
    path.moves.push_back(move_to(MoveKind::feed, Vec3(x, 0, 0), Vec3(x > 1 ? -0.0 : 0.0, 0, 1), x > 0));
  const PathInfo info = describe_path(path);
  EXPECT_EQ(info.largest_tilt_move, kNone);
  EXPECT_EQ(info.largest_tilt_deg, 0);
}

TEST(DescribePath, TheBoxHoldsArcs) {
  Toolpath path;
  path.moves.push_back(move_to(MoveKind::feed, Vec3(10, 0, 0), Vec3::UnitZ(), false));
  path.moves.push_back(move_to(MoveKind::arc, Vec3(-10, 0, 0), Vec3::UnitZ()));
  path.moves[1].curve_kind = CurveKind::arc;
  path.arcs.push_back({Vec3::Zero(), Vec3::UnitZ(), std::acos(-1)});
  EXPECT_NEAR(describe_path(path).box.max().y(), 10, PathInfo::kBoxError_mm);
  EXPECT_EQ(describe_path(path).box.min().y(), 0);
}

TEST(DescribePath, AnEmptyPathHasAnEmptyBox) { EXPECT_TRUE(describe_path({}).box.isEmpty()); }

TEST(KindName, IsAWordOfTheReports) {
  EXPECT_STREQ(kind_name(MoveKind::feed), "feed");
  EXPECT_STREQ(kind_name(MoveKind::cycle), "cycle");
}

}  // namespace
}  // namespace gouge::path_info_test
