#include "lib/path/motion_key.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gouge::motion_key_test {
namespace {

Toolpath straight_path() {
  Toolpath path;
  for (int k = 0; k < 3; ++k) {
    Move move;
    move.end.tip = {10.0 * k, 0, 0};
    move.has_start = k > 0;
    move.line = static_cast<std::size_t>(k) + 1;
    path.moves.push_back(move);
  }
  return path;
}

TEST(MotionKey, IsOfTheMotionAloneWhereverItStands) {
  const Toolpath path = straight_path();
  Toolpath other = path;
  other.moves[2].line = 99;
  other.moves[2].tool = 4;
  other.moves[2].feed_mm = 800;
  EXPECT_EQ(motion_key(path, 2), motion_key(other, 2));
  EXPECT_EQ(motion_key(path, 2).size(), kMotionDigits);
  other.moves.insert(other.moves.begin(), other.moves.front());
  EXPECT_EQ(motion_key(path, 2), motion_key(other, 3));
}

TEST(MotionKey, SeesEveryBitOfIt) {
  const Toolpath path = straight_path();
  const auto differs = [&](auto&& change) {
    Toolpath other = path;
    change(other);
    return motion_key(path, 2) != motion_key(other, 2);
  };
  EXPECT_TRUE(differs([](Toolpath& p) { p.moves[2].end.tip.x() = std::nextafter(20.0, 21.0); }));
  EXPECT_TRUE(differs([](Toolpath& p) { p.moves[1].end.tip.y() = 1e-300; })) << "where it begins";
  EXPECT_TRUE(differs([](Toolpath& p) { p.moves[2].end.axis = {0, 1, 0}; }));
  EXPECT_TRUE(differs([](Toolpath& p) { p.moves[2].kind = MoveKind::rapid; }));
  EXPECT_TRUE(differs([](Toolpath& p) { p.moves[2].feed_unit = FeedUnit::rapid; })) << "a step of a cycle in rapid";
  EXPECT_TRUE(differs([](Toolpath& p) { p.moves[2].has_start = false; }));
  EXPECT_TRUE(differs([](Toolpath& p) { p.moves[2].not_checked_reason = "why"; }));
  EXPECT_FALSE(differs([](Toolpath& p) { p.moves[2].end.tip.y() = -0.0; })) << "zero has no sign";
}

TEST(MotionKey, SeesTheCurve) {
  Toolpath path = straight_path();
  path.arcs.push_back({{15, 0, 0}, {0, 0, 1}, 3.14});
  const std::string straight = motion_key(path, 2);
  path.moves[2].curve_kind = CurveKind::arc;
  path.moves[2].curve = 0;
  const std::string arc = motion_key(path, 2);
  EXPECT_NE(arc, straight);
  path.arcs[0].sweep_rad = -3.14;
  EXPECT_NE(motion_key(path, 2), arc);
}

}  // namespace
}  // namespace gouge::motion_key_test
