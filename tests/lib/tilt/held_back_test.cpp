// Where a run is given up because an end of it that stays as programmed is too deep, no tilt beside that end is free
// with a free motion to it.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/lib/tilt/tilt_bench.h"
#include "tests/support/scatter.h"

namespace gouge::held_back_test {
namespace {

using namespace tilt_bench;

/// A row beside a wall that the holder runs into, across a low step that the cutter runs into.
Bench over_step(test::Scatter& random) {
  const double begin = random.in(-60, 40), height = random.is(0.3) ? random.in(0.002, 0.012) : random.in(0.02, 0.6);
  return {row(-60, 60, 4),
          {floor_plate(), shapes::box(Vec3(random.in(8, 14), -20, -5), Vec3(60, 20, 90)),
           shapes::box(Vec3(-20, begin, -1), Vec3(20, begin + random.in(2, 60), height))}};
}

bool is_way(const TiltSpace& space, std::size_t i, std::size_t neighbour, const Tilt& tilt) {
  const Tilt at = *space[i].given;
  const bool is_free = space[neighbour].is_fixed() ? tilt == *space[neighbour].given : space.is_free(neighbour, tilt);
  return is_free && (neighbour < i ? space.is_free_between(neighbour, tilt, i, at)
                                   : space.is_free_between(i, at, neighbour, tilt));
}

TEST(HeldBack, NoTiltBesideItIsFreeWithItsMotion) {
  test::Scatter random(11);
  std::size_t held = 0, open = 0;
  for (int n = 0; n < 60; ++n) {
    const Bench bench = over_step(random);
    std::vector<bool> is_wanted;
    for (const MoveVerdict& verdict : bench.before.verdicts)
      is_wanted.push_back(verdict.state == MoveState::gouge && verdict.witness->body != Body::cutter);
    TiltOptions options;
    options.blend_mm = random.in(2, 12);
    const TiltJob job{bench.path, bench.before, bench.own.setup.tools, bench.checker, options, is_wanted};
    for (const TiltRun& run : find_tilt_runs(job, random.in(0.5, 3))) {
      const bool may_raise = random.is(0.5);
      const TiltSpace space(run.positions, {&bench.tool, &bench.checker, options, may_raise});
      for (const std::size_t i : {std::size_t{0}, space.size() - 1}) {
        if (!space[i].is_fixed() || space.size() < 2) continue;
        const std::size_t neighbour = i == 0 ? 1 : i - 1;
        if (!space.holds_back(i)) {
          open += is_way(space, i, neighbour, Tilt::Zero()) ? 1U : 0U;
          continue;
        }
        ++held;
        EXPECT_FALSE(is_way(space, i, neighbour, Tilt::Zero())) << n;
        for (int k = 0; k < 60; ++k) {
          const Tilt tilt = random.in(0, random.is(0.5) ? 0.1 : 0.5) * Tilt(random.in(-1, 1), random.in(-1, 1));
          EXPECT_FALSE(is_way(space, i, neighbour, tilt)) << n << " tilt " << tilt.transpose();
        }
      }
    }
  }
  EXPECT_GT(held, 10U);
  EXPECT_GT(open, 10U);
}

TEST(HeldBack, IsSaidOfTheEndThatIsTooDeep) {
  // The holder runs into the wall all along; from y = 30 on the cutter runs into a step of 0.1 mm, where the wall ends.
  const Bench bench(row(-60, 60, 4), {floor_plate(), shapes::box(Vec3(9, -20, -5), Vec3(60, 20, 90)),
                                      shapes::box(Vec3(-20, 21, -1), Vec3(20, 61, 0.1))});
  const TiltPlan plan = bench.plan();
  EXPECT_TRUE(plan.runs.empty());
  ASSERT_EQ(plan.failed.size(), 1U);
  EXPECT_NE(plan.failed[0].reason.find(", and there the cutter is 0.1 mm too deep"), std::string::npos)
      << plan.failed[0].reason;
}

}  // namespace
}  // namespace gouge::held_back_test
