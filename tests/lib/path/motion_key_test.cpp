#include "lib/path/motion_key.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

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
  EXPECT_EQ(motion_key(path, 2, false), motion_key(other, 2, false));
  EXPECT_EQ(motion_key(path, 2, false).size(), kMotionDigits);
  other.moves.insert(other.moves.begin(), other.moves.front());
  EXPECT_EQ(motion_key(path, 2, false), motion_key(other, 3, false));
}

TEST(MotionKey, SeesEveryBitOfIt) {
  const Toolpath path = straight_path();
  const auto differs = [&](auto&& change) {
    Toolpath other = path;
    change(other);
    return motion_key(path, 2, false) != motion_key(other, 2, false);
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
  const std::string straight = motion_key(path, 2, false);
  path.moves[2].curve_kind = CurveKind::arc;
  path.moves[2].curve = 0;
  const std::string arc = motion_key(path, 2, false);
  EXPECT_NE(arc, straight);
  path.arcs[0].sweep_rad = -3.14;
  EXPECT_NE(motion_key(path, 2, false), arc);
}

/// A path whose rotary joints turn from one position to the next, degrees.
Toolpath turning_path(const RotaryAngles& from, const RotaryAngles& to) {
  const auto in_rad = [](const RotaryAngles& angles) {
    return RotaryAngles{angles[0] * std::numbers::pi / 180, angles[1] * std::numbers::pi / 180};
  };
  Toolpath path = straight_path();
  JointPath joints;
  joints.start = {std::nullopt, in_rad(from), in_rad(from)};
  joints.end = {in_rad(from), in_rad(from), in_rad(to)};
  path.joints = std::make_shared<const JointPath>(joints);
  return path;
}

TEST(MotionKey, SeesTheWaysOfTheJointsThatMakeTheMotion) {
  const auto key = [](const RotaryAngles& from, const RotaryAngles& to) {
    return motion_key(turning_path(from, to), 2, true);
  };
  const std::string back = key({10, 30}, {-10, 30});
  EXPECT_NE(back, key({10, 30}, {350, 30})) << "the other way round";
  EXPECT_NE(back, key({10, 30}, {-10, 31}));
  EXPECT_NE(back, key({190, -30}, {170, -30})) << "the other solution";
  EXPECT_EQ(back, key({370, 30}, {350, 30})) << "the same way, a turn later";
  EXPECT_EQ(back, key({-350, 30}, {-370, 30}));
  EXPECT_EQ(back, key({std::nextafter(10, 11), 30}, {-10, std::nextafter(30, 31)})) << "the rounding of a sum";
  EXPECT_EQ(key({0, 0}, {90, 0}), key({-1e-14, 0}, {90, 1e-14})) << "around 0";
}

TEST(MotionKey, IgnoresJointsThatDoNotMakeTheMotion) {
  const Toolpath turning = turning_path({10, 30}, {350, 30});
  EXPECT_EQ(motion_key(turning, 2, false), motion_key(straight_path(), 2, false));
  EXPECT_EQ(motion_key(straight_path(), 2, true), motion_key(straight_path(), 2, false)) << "no joints are known";
}

TEST(MotionKey, SeesTheJointsOfAPositionAlone) {
  Toolpath path = turning_path({10, 30}, {10, 30}), other = turning_path({20, 30}, {20, 30});
  EXPECT_NE(motion_key(path, 0, true), motion_key(other, 0, true));
}

}  // namespace
}  // namespace gouge::motion_key_test
