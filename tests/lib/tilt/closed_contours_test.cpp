#include "lib/tilt/closed_contours.h"

#include <gtest/gtest.h>

#include "tests/support/paths.h"
#include "tests/support/shapes.h"
#include "tests/support/tools.h"
#include "tests/support/whole_check.h"

namespace gouge::closed_contours_test {
namespace {

using paths::upright;

/// Down, around a square `laps` times from its middle of a side, and up.
Toolpath squares(int laps) {
  std::vector<Pose> poses{upright(0, -40, 120), upright(0, -40, 0)};
  for (int lap = 0; lap < laps; ++lap) {
    for (const auto& [x, y] : {std::pair(40, -40), std::pair(40, 40), std::pair(-40, 40), std::pair(-40, -40)})
      poses.push_back(upright(x, y, 0));
    poses.push_back(upright(0, -40, 0));
  }
  poses.push_back(upright(0, -40, 120));
  return paths::through(poses);
}

std::vector<Seam> seams_of(const Toolpath& path) {
  return find_seams(path, std::vector<bool>(path.moves.size(), true));
}

TEST(FindSeams, OfEachLapIsWhereItClosesAndNothingElse) {
  const std::vector<Seam> one = seams_of(squares(1));
  ASSERT_EQ(one.size(), 1U);
  EXPECT_EQ(one[0].begin, 1U);
  EXPECT_EQ(one[0].end, 6U);
  const std::vector<Seam> two = seams_of(squares(2));
  ASSERT_EQ(two.size(), 2U);
  EXPECT_EQ(two[1].begin, 6U);
  EXPECT_EQ(two[1].end, 11U);
}

TEST(FindSeams, OfThereAndBackOfRapidsAndOfAnotherToolAreNone) {
  EXPECT_TRUE(
      seams_of(paths::through({upright(0, 0, 50), upright(0, 0, 0), upright(9, 0, 0), upright(0, 0, 0)})).empty());
  Toolpath rapid = squares(1);
  rapid.moves[3].kind = MoveKind::rapid;
  EXPECT_TRUE(seams_of(rapid).empty());
  Toolpath changed = squares(1);
  for (std::size_t i = 4; i < changed.moves.size(); ++i) changed.moves[i].tool = 1;
  EXPECT_TRUE(seams_of(changed).empty());
}

TEST(ClosedContours, GiveTheOtherEndTheAxisThatOneHas) {
  const Toolpath path = squares(1);
  ToolAssembly assembly;
  assembly.number = 1;
  assembly.cutter = BallCutter{10, 20};
  const ToolVariants tool = tools::variants(assembly);
  Scene scene;
  scene.parts = {shapes::cube()};
  const OwnSetup own(&tool, scene, CheckOptions{});
  const CheckResult before = check(path, own.setup);
  const MotionChecker checker(own.setup);
  const TiltOptions options;
  const std::vector<bool> is_wanted(path.moves.size(), true);
  ClosedContours contours({path, before, own.setup.tools, checker, options, is_wanted});

  const auto at_end_of = [&](std::size_t move) {
    TiltPosition at;
    at.move = move;
    at.programmed = path.moves[move].end;
    at.pivot = ContactPivot(at.programmed);
    return at;
  };
  TiltRun first, second;
  first.positions = {at_end_of(1), at_end_of(2)};
  second.positions = {at_end_of(5), at_end_of(6)};
  // As seen from a frame that is turned.
  second.positions[1].first = Vec3::UnitY();
  second.positions[1].second = -Vec3::UnitX();
  contours.begin({first, second});
  EXPECT_FALSE(contours.with_known(second.positions));
  EXPECT_TRUE(contours.loops(TiltSpace(second.positions, {})).empty());

  contours.learn(TiltSpace(first.positions, {}), {Tilt(0.1, 0.2), Tilt::Zero()});
  const auto known = contours.with_known(second.positions);
  ASSERT_TRUE(known);
  const std::vector<TiltPosition>& given = *known;
  EXPECT_FALSE(given[0].is_fixed());
  ASSERT_TRUE(given[1].is_fixed());
  EXPECT_NEAR((*given[1].given - Tilt(0.2, -0.1)).norm(), 0, 1e-12);
  EXPECT_NEAR((given[1].axis_for(*given[1].given) - first.positions[0].axis_for(Tilt(0.1, 0.2))).norm(), 0, 1e-12);

  // Where the other end is in no run it stays as programmed, and so must this one.
  ClosedContours apart({path, before, own.setup.tools, checker, options, is_wanted});
  apart.begin({second});
  const auto stays = apart.with_known(second.positions);
  ASSERT_TRUE(stays);
  EXPECT_TRUE((*stays)[1].stays_programmed());

  const TiltSpace both({first.positions[0], second.positions[0], second.positions[1]}, {});
  ASSERT_EQ(contours.loops(both).size(), 1U);
  EXPECT_EQ(contours.loops(both)[0], std::pair(std::size_t{0}, std::size_t{2}));
}

}  // namespace
}  // namespace gouge::closed_contours_test
