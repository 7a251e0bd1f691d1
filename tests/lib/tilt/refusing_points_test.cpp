// Points that were in the tool refuse no tilt that is free without them, whether the tip rises or not.
#include <gtest/gtest.h>

#include "tests/lib/tilt/tilt_bench.h"
#include "tests/support/scatter.h"

namespace gouge::refusing_points_test {
namespace {

using namespace tilt_bench;

ToolAssembly long_tool(const Cutter& cutter) {
  ToolAssembly tool = long_ball();
  tool.cutter = cutter;
  return tool;
}

TEST(RefusingPoints, RefuseNoTiltThatIsFreeWithoutThem) {
  test::Scatter random(47);
  std::size_t free = 0, refused = 0, by_points = 0, raised = 0;
  for (const Cutter& cutter : std::vector<Cutter>{BallCutter{10, 20}, FlatCutter{10, 20}, BullNoseCutter{10, 2, 20},
                                                  LollipopCutter{10, 6, 0}}) {
    for (int n = 0; n < 6; ++n) {
      const double wall = random.in(9, 14), step = random.in(5.02, 5.6);
      const double height = random.is(0.6) ? random.in(0.05, 0.9) : random.in(1, 60);
      // Above the floor the tip stays, so that the edge of a flat end comes down and must rise.
      std::vector<Pose> poses = row(-10, 10, 5);
      const double lift = random.is(0.5) ? random.in(1.05, 2) : 0;
      for (Pose& pose : poses) pose.tip.z() += lift;
      const Bench bench(poses,
                        {floor_plate(), shapes::box(Vec3(wall, -100, -5), Vec3(wall + 50, 100, 90)),
                         shapes::box(Vec3(-50, -100, -5), Vec3(-step, 100, height))},
                        long_tool(cutter));
      std::vector<bool> is_wanted;
      for (const MoveVerdict& verdict : bench.before.verdicts) is_wanted.push_back(verdict.state == MoveState::gouge);
      const TiltOptions options;
      const std::vector<TiltRun> runs =
          find_tilt_runs({bench.path, bench.before, bench.own.setup.tools, bench.checker, options, is_wanted}, 5);
      if (runs.empty()) continue;
      for (const bool may_raise : {false, true}) {
        const TiltSpace space(runs.front().positions, {&bench.tool, &bench.checker, options, may_raise});
        const std::size_t i = space.size() / 2;
        RefusingPoints points;
        for (int k = 0; k < 300; ++k) {
          const Tilt tilt = random.in(0, options.max_tilt_rad) * Tilt(random.in(-1, 1), random.in(-1, 1));
          const bool is_free = space.is_free(i, tilt);
          if (space.is_refused_by(points, i, tilt)) {
            ++by_points;
            ASSERT_FALSE(is_free) << n << " tilt " << tilt.transpose() << (may_raise ? ", may rise" : "");
          }
          ASSERT_EQ(space.is_free(i, tilt, &points), is_free) << n << " tilt " << tilt.transpose();
          (is_free ? free : refused)++;
          const auto raise_mm = space.raise_mm(i, tilt);
          raised += is_free && raise_mm && *raise_mm > 0 ? 1U : 0U;
        }
      }
    }
  }
  EXPECT_GT(free, 300U);
  EXPECT_GT(refused, 1000U);
  EXPECT_GT(by_points, refused / 2);
  EXPECT_GT(raised, 10U);
}

}  // namespace
}  // namespace gouge::refusing_points_test
