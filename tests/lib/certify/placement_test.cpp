#include "lib/certify/placement.h"

#include <gtest/gtest.h>

#include "lib/check/prepared_scene.h"
#include "tests/support/paths.h"
#include "tests/support/shapes.h"

namespace gouge::placement_test {
namespace {

Toolpath wide_path() {
  return paths::through({{{0, 0, 0}, {0, 0, 1}}, {{100, 0, 0}, {0, 0, 1}}, {{100, 80, 0}, {0, 0, 1}}});
}

TEST(Placement, AGapIsFoundOnlyBeyondTheReachOfTheTool) {
  const Toolpath path = wide_path();
  const auto gap = [&](const IndexedMesh& part) {
    const Scene scene{{part}, {}};
    return find_gap(path, scene, PreparedScene(scene).workpiece_tree(), 60).value_or("");
  };
  EXPECT_EQ(gap(shapes::box({0, 0, -20}, {120, 100, 0})), "");
  EXPECT_EQ(gap(shapes::box({150, 0, -20}, {270, 100, 0})), "") << "beside it, within the tool's reach";
  EXPECT_EQ(gap(shapes::box({1160, 0, -20}, {1270, 100, 0})),
            "no move reaches the part; the nearest cutting position examined is 1060 mm away");
  const Scene nothing;
  EXPECT_FALSE(find_gap(path, nothing, PreparedScene(nothing).workpiece_tree(), 60));
}

TEST(Placement, CutsThatStayAwayFromThePartAreFoundFromTenPositionsOn) {
  const auto is_apart = [](std::size_t positions, std::optional<double> nearest) {
    return find_apart(ClosestApproach{2000, positions, nearest, {}, 0}).has_value();
  };
  EXPECT_TRUE(is_apart(400, 8.5));
  EXPECT_TRUE(is_apart(400, std::nullopt));
  EXPECT_FALSE(is_apart(400, 1.5)) << "roughing";
  EXPECT_FALSE(is_apart(9, 8.5)) << "too few to judge by";
  EXPECT_EQ(find_apart(ClosestApproach{2000, 400, 8.59, {}, 8.58}),
            "at none of 400 cutting positions examined (of 2000) is the tool nearer than 8.5 mm to the part");
  EXPECT_EQ(find_apart(ClosestApproach{40, 40, {}, {}, 20}),
            "at none of 40 cutting positions is the tool nearer than 20.0 mm to the part");
}

TEST(Placement, ASmallerPartNamesTheUnitThatWouldFit) {
  const Toolpath path = wide_path();
  const auto sentence = [&](double size, LengthUnit read_as) {
    const IndexedMesh part = shapes::box({0, 0, -0.2 * size}, {size, 0.8 * size, 0});
    return find_other_size(path, {{part}, {}}, MoveVerdicts(3), read_as).value_or("");
  };
  EXPECT_EQ(sentence(0.12, LengthUnit::mm),
            "the part is 823 times smaller than the path; with --stl-units m it would be about as large as the path");
  EXPECT_EQ(sentence(4.1, LengthUnit::mm),
            "the part is 24 times smaller than the path; with --stl-units inch or --stl-units cm it would be about as "
            "large as the path");
  EXPECT_EQ(sentence(0.1, LengthUnit::um),
            "the part is 988 times smaller than the path; with --stl-units mm it would be about as large as the path");
  EXPECT_EQ(sentence(1, LengthUnit::mm), "the part is 99 times smaller than the path") << "no unit of these fits";
  EXPECT_EQ(sentence(110, LengthUnit::mm), "");
}

// An inch path: the part, written in mm and read in inches, is 25 times too large, and the tool cuts deep inside it.
TEST(Placement, ALargerPartCountsOnlyWhereMostCutsAreInItAndAUnitFits) {
  const Toolpath path = wide_path();
  const Scene scene{{shapes::box({0, 0, -25.4 * 20}, {25.4 * 100, 25.4 * 80, 1})}, {}};
  MoveVerdicts verdicts(3);
  EXPECT_FALSE(find_other_size(path, scene, verdicts, LengthUnit::inch)) << "a small pocket in a large part";
  verdicts[0].state = MoveState::gouge;
  verdicts[1].state = MoveState::buried;
  EXPECT_EQ(find_other_size(path, scene, verdicts, LengthUnit::inch),
            "the part is 26 times larger than the path, and 2 of 3 cuts are in it; with --stl-units mm it would be "
            "about as large as the path");
  EXPECT_FALSE(find_other_size(path, scene, verdicts, LengthUnit::mm)) << "no unit would fit";
}

}  // namespace
}  // namespace gouge::placement_test
