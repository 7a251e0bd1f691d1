#include "cli/misplaced.h"

#include <gtest/gtest.h>

#include "tests/support/paths.h"
#include "tests/support/shapes.h"
#include "tests/support/tools.h"
#include "tests/support/whole_check.h"

namespace gouge {
namespace {

TEST(Misplaced, IsReportedOfAPartFarAwayOrFarTooSmall) {
  const Toolpath path = paths::through({{{0, 0, 0}, {0, 0, 1}}, {{100, 0, 0}, {0, 0, 1}}, {{100, 80, 0}, {0, 0, 1}}});
  const auto reported = [&](const IndexedMesh& part) {
    const auto warning = find_misplaced(path, {{part}, {}}, 60);
    return warning ? warning->message : std::string();
  };
  EXPECT_EQ(reported(shapes::box({0, 0, -20}, {120, 100, 0})), "");
  EXPECT_EQ(reported(shapes::box({0, 0, -20}, {900, 900, 0})), "") << "a corner of a large part";
  EXPECT_EQ(reported(shapes::box({150, 0, -20}, {270, 100, 0})), "") << "beside it, within the tool's reach";
  EXPECT_EQ(reported(shapes::box({1160, 0, -20}, {1270, 100, 0})).find("no move comes nearer than 1000 mm to the part"),
            0u);
  EXPECT_EQ(reported(shapes::box({0, 0, -1}, {4, 4, 0})).find("the part is 22 times smaller than the path"), 0u);
  EXPECT_FALSE(find_misplaced(path, {}, 60));
}

TEST(Misplaced, IsReportedOfCutsThatStayAwayFromThePart) {
  const Toolpath path = paths::through({{{0, 0, 0}, {0, 0, 1}}});
  const auto reported = [&](std::size_t positions, std::optional<double> nearest) {
    return find_apart(path, Closeness{2000, positions, nearest, {}, 0}).has_value();
  };
  EXPECT_TRUE(reported(400, 8.5));
  EXPECT_TRUE(reported(400, std::nullopt));
  EXPECT_FALSE(reported(400, 1.5)) << "roughing";
  EXPECT_FALSE(reported(9, 8.5)) << "too few to say so";
  EXPECT_EQ(find_apart(path, Closeness{2000, 400, 8.59, {}, 8.58})->message,
            "at none of 400 cutting positions examined (of 2000) is the tool nearer than 8.5 mm to the part; check the "
            "units (--stl-units, --path-units) and --place");
  EXPECT_EQ(find_apart(path, Closeness{40, 40, {}, {}, 20})->message,
            "at none of 40 cutting positions is the tool nearer than 20.0 mm to the part; check the units "
            "(--stl-units, --path-units) and --place");
}

TEST(Misplaced, NamesTheUnitThatWouldFit) {
  const Toolpath path = paths::through({{{0, 0, 0}, {0, 0, 1}}, {{100, 0, 0}, {0, 0, 1}}, {{100, 80, 0}, {0, 0, 1}}});
  const auto reported = [&](double size, LengthUnit read_as) {
    const IndexedMesh part = shapes::box({0, 0, -0.2 * size}, {size, 0.8 * size, 0});
    const auto warning = find_misplaced(path, {{part}, {}}, 60, read_as);
    return warning ? warning->message.substr(0, warning->message.find("; check")) : std::string();
  };
  EXPECT_EQ(reported(0.12, LengthUnit::mm),
            "the part is 823 times smaller than the path; with --stl-units m it would be about as large as the path");
  EXPECT_EQ(reported(4.1, LengthUnit::mm),
            "the part is 24 times smaller than the path; with --stl-units inch or --stl-units cm it would be about as "
            "large as the path");
  EXPECT_EQ(reported(0.1, LengthUnit::um),
            "the part is 988 times smaller than the path; with --stl-units mm it would be about as large as the path");
  EXPECT_EQ(reported(1, LengthUnit::mm).find("--stl-units"), std::string::npos) << "a hundred times: no unit of these";
  EXPECT_EQ(reported(110, LengthUnit::mm), "");
}

// An inch path: the part, written in mm and read in inches, is 25 times too large, and the tool cuts deep inside it.
TEST(Misplaced, IsReportedOfAPartFarTooLargeWhenTheCutsAreInIt) {
  const Toolpath path = paths::through({{{0, 0, 0}, {0, 0, 1}}, {{100, 0, 0}, {0, 0, 1}}, {{100, 80, 0}, {0, 0, 1}}});
  const Scene scene{{shapes::box({0, 0, -25.4 * 20}, {25.4 * 100, 25.4 * 80, 1})}, {}};
  MoveVerdicts verdicts(3);
  EXPECT_FALSE(find_too_large(path, scene, verdicts, LengthUnit::inch)) << "a small pocket in a large part";
  verdicts[0].state = MoveState::gouge;
  verdicts[1].state = MoveState::buried;
  EXPECT_EQ(find_too_large(path, scene, verdicts, LengthUnit::inch)->message,
            "the part is 26 times larger than the path, and 2 of 3 cuts are in it; with --stl-units mm it would be "
            "about as large as the path; check the units (--stl-units, --path-units) and --place");
  EXPECT_FALSE(find_too_large(path, scene, verdicts, LengthUnit::mm)) << "no unit would fit";
}

}  // namespace
}  // namespace gouge
