#include "lib/path/place_path.h"

#include <gtest/gtest.h>

#include "tests/support/paths.h"

namespace gouge::place_path_test {
namespace {

TEST(PlacePath, PositionsAxesAndCurvesMoveTogether) {
  Toolpath path = paths::through({paths::upright(1, 2, 3), paths::upright(4, 5, 6)});
  path.arcs.push_back({Vec3(1, 0, 0), Vec3::UnitY(), 1.5});
  path.splines.push_back({{SplinePiece{}}});
  path.splines[0].pieces[0].control[3] = Vec3(7, 8, 9);
  RigidTransform turn;  // by 180 degrees about X, then up by 10
  turn.rotation = Vec3(1, -1, -1).asDiagonal();
  turn.shift = Vec3(0, 0, 10);
  place_path(turn, path);
  EXPECT_EQ(path.moves[1].end.tip, Vec3(4, -5, 4));
  EXPECT_EQ(path.moves[1].end.axis, Vec3(0, 0, -1));
  EXPECT_EQ(path.arcs[0].center, Vec3(1, 0, 10));
  EXPECT_EQ(path.arcs[0].axis, Vec3(0, -1, 0));
  EXPECT_EQ(path.arcs[0].sweep_rad, 1.5);
  EXPECT_EQ(path.splines[0].pieces[0].control[3], Vec3(7, -8, 1));
}

}  // namespace
}  // namespace gouge::place_path_test
