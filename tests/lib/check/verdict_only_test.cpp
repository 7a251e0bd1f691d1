#include <gtest/gtest.h>

#include "lib/base/best_first_search.h"
#include "tests/support/paths.h"
#include "tests/support/scatter.h"
#include "tests/support/shapes.h"
#include "tests/support/tools.h"
#include "tests/support/whole_check.h"

// Where only the verdict on a motion is wanted its check ends with the first point that is too deep. The verdict is that
// of the check which measures the depth.

namespace gouge::verdict_only_test {
namespace {

constexpr std::size_t kPoses = 300;

/// Moves in which tools of some 10 mm touch, gouge or miss a sphere of 10 mm on a block of 40 mm, a fifth of them rapids.
Toolpath scattered_path(test::Scatter& random) {
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < kPoses; ++i) {
    const Vec3 toward = random.axis(1.5);
    poses.push_back({toward * random.in(9.6, 11.5), (toward + 0.7 * random.point(1)).normalized()});
  }
  Toolpath path = paths::through(poses);
  for (Move& move : path.moves) {
    move.has_start = move.has_start && random.is(0.5);
    if (random.is(0.2)) move.kind = MoveKind::rapid;
  }
  return path;
}

TEST(VerdictOnly, IsThatOfTheCheckThatMeasures) {
  const Scene scene{{shapes::sphere(10)}, {shapes::box(Vec3(-20, -20, -40), Vec3(20, 20, -9))}};
  std::size_t gouges = 0, nears = 0, cleans = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    test::Scatter random(seed);
    const Toolpath path = scattered_path(random);
    const Cutter cutters[] = {BallCutter{6, 30}, FlatCutter{6, 30}, BullNoseCutter{8, 2, 30},
                              TaperedCutter{4, 1, 5, 30}};
    const ToolVariants tool =
        tools::variants(tools::assembly(cutters[seed - 1], 6), seed % 2 == 0 ? 0.05 : 0, 0.3, 0.5);
    CheckOptions options;
    options.near_miss_mm = 0.4;
    const CheckResult measured = whole_check(path, &tool, scene, options);
    options.gouge_gap_mm = kAnyGap_mm;
    const CheckResult told = whole_check(path, &tool, scene, options);
    ASSERT_EQ(measured.verdicts.size(), told.verdicts.size());
    for (std::size_t i = 0; i < measured.verdicts.size(); ++i) {
      const MoveVerdict &whole = measured.verdicts[i], &quick = told.verdicts[i];
      EXPECT_EQ(whole.state, quick.state) << "seed " << seed << ", move " << i << ", depth " << whole.depth_mm;
      EXPECT_LE(quick.depth_mm, whole.depth_upper_mm + 1e-9);
      gouges += whole.state == MoveState::gouge ? 1 : 0;
      nears += whole.state == MoveState::near_miss ? 1 : 0;
      cleans += whole.state == MoveState::clean ? 1 : 0;
    }
  }
  EXPECT_GT(gouges, 300U);
  EXPECT_GT(nears, 20U);
  EXPECT_GT(cleans, 100U);
}

}  // namespace
}  // namespace gouge::verdict_only_test
