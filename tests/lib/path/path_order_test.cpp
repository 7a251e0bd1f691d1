#include "lib/path/path_order.h"

#include <gtest/gtest.h>

#include <vector>

#include "lib/path/tip_grid.h"
#include "tests/support/paths.h"

namespace gouge::path_order_test {
namespace {

constexpr double kWithin_mm = 1e-3;

/// Passes along X at these places of Y, each with three positions.
Toolpath passes(const std::vector<double>& places) {
  std::vector<Pose> poses;
  for (const double y : places)
    for (const double x : {0.0, 10.0, 20.0}) poses.push_back(paths::upright(x, y, 0));
  return paths::through(poses);
}

TEST(PathOrder, OfACopyIsTheSame) {
  const Toolpath path = passes({0, 2, 4});
  const PathOrder order = compare_order(path, path, kWithin_mm);
  EXPECT_TRUE(order.is_same());
  EXPECT_EQ(order.positions, 9U);
}

TEST(PathOrder, DiffersFromTheFirstPassThatIsExchanged) {
  const PathOrder order = compare_order(passes({0, 2, 4, 6}), passes({0, 4, 2, 6}), kWithin_mm);
  EXPECT_EQ(order.move, 3U);
  EXPECT_EQ(order.other, 3U);
}

TEST(PathOrder, DiffersWhereAPassIsReversed) {
  Toolpath reversed = passes({0, 2});
  std::swap(reversed.moves[3].end, reversed.moves[5].end);
  EXPECT_EQ(compare_order(passes({0, 2}), reversed, kWithin_mm).move, 3U);
}

TEST(PathOrder, IsNotOfPassesThatAreRepeatedOrMissing) {
  EXPECT_TRUE(compare_order(passes({0, 2, 4}), passes({0, 2, 2, 4}), kWithin_mm).is_same());
  EXPECT_TRUE(compare_order(passes({0, 2, 4, 0}), passes({2, 4, 0, 2}), kWithin_mm).is_same());
  EXPECT_TRUE(compare_order(passes({0, 2, 4}), passes({0, 4}), kWithin_mm).is_same());
}

TEST(PathOrder, IsOfPositionsThatDifferByTheirRounding) {
  Toolpath rounded = passes({2, 0});
  for (Move& move : rounded.moves) move.end.tip += Vec3(4e-4, -3e-4, 0);
  const PathOrder order = compare_order(passes({0, 2}), rounded, kWithin_mm);
  EXPECT_EQ(order.positions, 6U);
  EXPECT_FALSE(order.is_same());
}

// Each path passes the crossing twice, and states it as a position once: one path the first time, the other one the second.
TEST(PathOrder, OfACrossingIsNotCertain) {
  const auto loop = [](bool is_stated_first) {
    std::vector<Pose> poses{paths::upright(-10, 0, 0)};
    if (is_stated_first) poses.push_back(paths::upright(0, 0, 0));
    for (const auto& [x, y] : {std::pair(10.0, 0.0), std::pair(10.0, 10.0), std::pair(0.0, 10.0)})
      poses.push_back(paths::upright(x, y, 0));
    if (!is_stated_first) poses.push_back(paths::upright(0, 0, 0));
    poses.push_back(paths::upright(0, -10, 0));
    return paths::through(poses);
  };
  const PathOrder order = compare_order(loop(true), loop(false), kWithin_mm);
  EXPECT_TRUE(order.is_same());
  EXPECT_EQ(order.positions, 5U) << "the crossing does not count";
}

TEST(TipGrid, FindsPointsAcrossTheBordersOfCells) {
  constexpr double kNear_mm = 0.25;  // cells of 1 mm
  TipGrid grid(kNear_mm);
  const std::vector<Vec3> tips = {{0.9, 0.9, -0.1}, {1.1, 1.0, 0.0}, {1.0, 1.0, 0.3}, {1.0, 1.0, 0.0}, {1e9, -1e9, 0}};
  for (std::size_t i = 0; i < tips.size(); ++i) grid.add(tips[i], i);
  EXPECT_EQ(grid.find({1, 1, 0}, 9), (std::vector<std::size_t>{0, 1, 3}));
  EXPECT_EQ(grid.find({1, 1, 0}, 2).size(), 2U);
  EXPECT_EQ(grid.find({1e9, -1e9, 0.2}, 9), (std::vector<std::size_t>{4}));
}

}  // namespace
}  // namespace gouge::path_order_test
