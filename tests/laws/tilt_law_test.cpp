// No tilt breaks its limits at any instant, none gouges by a reference that examines every triangle, none touches what it
// need not, and hardly one is missed that a lattice of 1 degree has a way for. GOUGE_TILTS sets how many random runs,
// GOUGE_FIRST_TILT the number of the first.
#include <gtest/gtest.h>

#include <cstdlib>
#include <ctime>
#include <iostream>
#include <limits>
#include <numbers>
#include <utility>

#include "lib/path/path_info.h"
#include "lib/tilt/plan_tilts.h"
#include "tests/support/brute_force.h"
#include "tests/support/motions.h"
#include "tests/support/paths.h"
#include "tests/support/scatter.h"
#include "tests/support/shapes.h"
#include "tests/support/tools.h"
#include "tests/support/whole_check.h"

namespace gouge::tilt_law_test {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

std::size_t number_of(const char* name, std::size_t usual) {
  const char* given = std::getenv(name);
  return given == nullptr ? usual : std::strtoull(given, nullptr, 10);
}

/// Seconds of this program, which is alone on its thread, whatever else runs on the machine.
struct Stopwatch {
  std::clock_t since = std::clock();
  double lap() {
    const std::clock_t now = std::clock();
    return static_cast<double>(now - std::exchange(since, now)) / CLOCKS_PER_SEC;
  }
};

/// A path over a plate, with walls and posts that the holder runs into, and random limits.
struct RandomRun {
  explicit RandomRun(std::uint64_t number) : random(number * 104'729 + 5) {
    ToolAssembly assembly;
    assembly.number = 1;
    const double diameter = random.in(4, 16);
    switch (random.below(3)) {
      case 0:
        assembly.cutter = BallCutter{diameter, 20};
        break;
      case 1:
        assembly.cutter = FlatCutter{diameter, 20};
        break;
      default:
        assembly.cutter = BullNoseCutter{diameter, random.in(0.1, 0.45) * diameter, 20};
    }
    assembly.shank = {{diameter, diameter, random.in(5, 40)}};
    assembly.holder = {{random.in(24, 50), random.in(24, 60), 60}};
    tool = tools::variants(assembly, random.is(0.2) ? 0.2 : 0, 0, random.is(0.3) ? random.in(0, 1) : 0);
    add_part(diameter);
    path = paths::through(poses(diameter));
    options.max_tilt_rad = random.in(8, 45) * kDegree;
    options.blend_mm = random.in(2, 20);
    // Left stock is checked for plans, not for single tilts, as those of the lattice are.
    options.max_stock_mm = std::numeric_limits<double>::infinity();
    if (random.is(0.2)) options.freedom = random.is(0.5) ? TiltFreedom::lead : TiltFreedom::side;
    if (random.is(0.2)) options.cone = AxisCone{random.axis(0.3), random.in(25, 50) * kDegree};
    if (random.is(0.2)) options.max_turn_rad_per_mm = random.in(1, 6) * kDegree;
  }

  void add_part(double diameter) {
    scene.parts = {shapes::box(Vec3(-150, -150, -10), Vec3(150, 150, 0))};
    for (std::size_t k = 1 + random.below(3); k > 0; --k) {
      // Beside the path, nearer than the holder is wide.
      const double side = random.is(0.5) ? 1 : -1, near = side * random.in(0.6 * diameter, 0.5 * diameter + 14);
      const double far = near + side * random.in(2, 40), at = random.in(-60, 60), half = random.in(1, 60);
      scene.parts.push_back(shapes::box(Vec3(std::min(near, far), at - half, -5),
                                        Vec3(std::max(near, far), at + half, random.in(20, 90))));
    }
  }

  std::vector<Pose> poses(double diameter) {
    const double leans = random.is(0.3) ? 0.15 : 0, step = random.in(1, 12);
    const bool is_touching = random.is(0.7);
    const double z = is_touching ? 0 : random.in(0.1, 3);
    std::vector<Pose> all{{Vec3(0, -70, 120), Vec3::UnitZ()}};
    for (double y = -70; y < 70; y += step) {
      Vec3 axis = random.axis(leans).normalized();
      // The contact stays on the floor: for a ball its centre, for others upright.
      Vec3 tip(0, y, z);
      if (leans > 0) tip += 0.5 * diameter * Vec3(0, 0, 1) - 0.5 * diameter * axis;
      all.push_back({tip, axis});
    }
    all.push_back({Vec3(0, 70, 120), Vec3::UnitZ()});
    return all;
  }

  test::Scatter random;
  ToolVariants tool;
  Scene scene;
  Toolpath path;
  TiltOptions options;
};

struct Laws {
  const RandomRun& run;
  const OwnSetup& own;
  const MotionChecker& checker;
  const std::vector<const ToolVariants*>& tools;
  const CheckResult& before;
  const std::vector<bool>& is_wanted;

  /// A long move may hold several runs: one of them begins where the one before it ends.
  void expect_kept(const TiltPlan& plan, std::size_t index, std::size_t number) const {
    const SmoothedRun& tilted = plan.runs[index];
    // The motions of the run, with the programmed ones that they represent.
    std::vector<std::pair<Pose, Pose>> stations;  // programmed, tilted
    const std::size_t first = tilted.positions.front().move, last = tilted.positions.back().move;
    const auto is_of = [](const UntiltedRun& failed, std::size_t i) {
      return failed.first_wanted <= i && i <= failed.last_wanted;
    };
    const auto is_given_up = [&](std::size_t i) {
      return std::ranges::any_of(plan.failed, [&](const UntiltedRun& failed) { return is_of(failed, i); });
    };
    const TiltedPosition *previous = nullptr, *next = nullptr;
    for (const SmoothedRun& other : plan.runs) {
      if (&other == &tilted || other.positions.empty()) continue;
      if (&other < &tilted && other.positions.back().move == first) previous = &other.positions.back();
      if (&other > &tilted && other.positions.front().move == last && next == nullptr) next = &other.positions.front();
    }
    if (previous != nullptr) {
      stations.emplace_back(previous->programmed, previous->pose);
    } else if (first > 0 && !is_given_up(first)) {
      stations.emplace_back(run.path.moves[first - 1].end, run.path.moves[first - 1].end);
    }
    std::size_t move = first;
    for (const TiltedPosition& p : tilted.positions) {
      for (; move < p.move; ++move) {
        const Pose& end = run.path.moves[move].end;
        if (stations.empty() || stations.back().first.tip != end.tip) stations.emplace_back(end, end);
      }
      stations.emplace_back(p.programmed, p.pose);
    }
    if (next != nullptr) {
      stations.emplace_back(next->programmed, next->pose);
    } else if (move + 1 < run.path.moves.size() && !is_given_up(move)) {
      stations.emplace_back(run.path.moves[move].end, run.path.moves[move].end);
    }
    for (std::size_t i = 1; i < stations.size(); ++i) {
      if ((stations[i].first.tip - stations[i - 1].first.tip).norm() < 1e-9) continue;
      const Motion programmed = test::straight(stations[i - 1].first, stations[i].first);
      const Motion motion = test::straight(stations[i - 1].second, stations[i].second);
      for (const double t : {0.0, 0.37, 0.63}) {
        const Pose was = programmed.at(t), is = motion.at(t);
        ASSERT_LE(angle_between_rad(was.axis, is.axis), run.options.max_tilt_rad + 1e-6) << number << " station " << i;
        if (run.options.cone && angle_between_rad(was.axis, is.axis) > 1e-9) {
          ASSERT_LE(angle_between_rad(is.axis, run.options.cone->axis), run.options.cone->half_angle_rad + 1e-6)
              << number;
        }
        ASSERT_LE(depth_at(is), 0.01 + 0.001 + 1e-6) << number << " station " << i << " at " << is.tip.transpose();
      }
      const double way = (motion.end().tip - motion.start().tip).norm();
      const double allowed = std::max(run.options.max_turn_rad_per_mm * std::max(way, 1e-3), programmed.turn_rad());
      ASSERT_LE(motion.turn_rad(), allowed * (1 + 1e-3) + 1e-5) << number << " station " << i;
    }
  }

  /// Walls closely; the floor, which a flat end lies on, to 0.05 mm: from below both.
  [[nodiscard]] double depth_at(const Pose& pose) const {
    const std::vector<IndexedMesh> floor{run.scene.parts.front()};
    const std::vector<IndexedMesh> walls(run.scene.parts.begin() + 1, run.scene.parts.end());
    return std::max(brute_force::mesh_depth(run.tool.against_part, pose, floor, 0.05),
                    brute_force::mesh_depth(run.tool.against_part, pose, walls, 5e-3));
  }

  /// Returns whether a lattice of 1 degree has a way through the run: free tilts at every position, and free motions from each
  /// to a tilt at most 3 degrees away.
  [[nodiscard]] bool has_path_from(std::size_t first_wanted) const {
    const TiltJob job{run.path, before, tools, checker, run.options, is_wanted};
    for (const TiltRun& found : find_tilt_runs(job, run.options.blend_mm / 8)) {
      if (found.first_wanted == first_wanted) return has_way(found);
    }
    return false;
  }

  [[nodiscard]] bool has_way(const TiltRun& found) const {
    const TiltSpace space(found.positions, {tools[0], &checker, run.options, false});
    std::vector<Tilt> reached{Tilt::Zero()};
    for (std::size_t i = 1; i < space.size(); ++i) {
      const bool is_last = i + 1 == space.size();
      std::vector<Tilt> next;
      RefusingPoints refusing;
      for (const Tilt& tilt : lattice()) {
        // With lead or side alone corners stay as programmed, too.
        const bool is_fixed = is_last || space[i].is_fixed();
        if (is_fixed ? tilt.norm() > 0 : !space.is_free(i, tilt, &refusing)) continue;
        std::vector<Tilt> near;
        std::ranges::copy_if(reached, std::back_inserter(near),
                             [&](const Tilt& from) { return (from - tilt).norm() < 3 * kDegree; });
        std::ranges::sort(near, {}, [&](const Tilt& from) { return (from - tilt).norm(); });
        const bool is_reached =
            std::ranges::any_of(near, [&](const Tilt& from) { return space.is_free_between(i - 1, from, i, tilt); });
        if (is_reached) next.push_back(tilt);
      }
      if (next.empty()) return false;
      reached = std::move(next);
    }
    return true;
  }

  [[nodiscard]] std::vector<Tilt> lattice() const {
    std::vector<Tilt> all;
    const int most = static_cast<int>(run.options.max_tilt_rad / kDegree);
    for (int x = -most; x <= most; ++x) {
      for (int y = -most; y <= most; ++y) {
        const bool is_allowed = (run.options.freedom != TiltFreedom::lead || y == 0) &&
                                (run.options.freedom != TiltFreedom::side || x == 0);
        if (is_allowed && std::hypot(x, y) <= most) all.push_back(kDegree * Tilt(x, y));
      }
    }
    return all;
  }
};

TEST(TiltLaw, HoldsForRandomRuns) {
  const std::size_t first = number_of("GOUGE_FIRST_TILT", 0), count = number_of("GOUGE_TILTS", 20);
  std::size_t tilted = 0, failed = 0, missed = 0, ours_alone = 0;
  double seconds = 0, lattice_seconds = 0;
  std::vector<double> times_as_fast;
  const bool is_at_length = count > 20;
  for (std::size_t n = first; n < first + count; ++n) {
    const RandomRun run(n);
    CheckOptions options;
    options.threads = 1;
    const OwnSetup own(&run.tool, run.scene, options);
    const CheckResult before = check(run.path, own.setup);
    const MotionChecker checker(own.setup);
    std::vector<bool> is_wanted;
    for (const MoveVerdict& verdict : before.verdicts)
      is_wanted.push_back(verdict.state == MoveState::gouge && verdict.witness->body != Body::cutter);
    Stopwatch watch;
    const TiltPlan plan = plan_tilts({run.path, before, own.setup.tools, checker, run.options, is_wanted}, {});
    const Laws laws{run, own, checker, own.setup.tools, before, is_wanted};
    const double planned = watch.lap();
    seconds += planned;
    for (std::size_t r = 0; r < plan.runs.size(); ++r) {
      if (!plan.runs[r].positions.empty()) laws.expect_kept(plan, r, n);
    }
    watch.lap();
    for (const SmoothedRun& one : plan.runs)
      if (is_at_length) ours_alone += laws.has_path_from(one.first_wanted) ? 0U : 1U;
    for (const UntiltedRun& one : plan.failed) {
      const bool is_missed = laws.has_path_from(one.first_wanted);
      missed += is_missed ? 1 : 0;
      if (is_missed) std::cout << "run " << n << " has a way on a lattice of 1 degree, but: " << one.reason << "\n";
    }
    const double by_lattice = watch.lap();
    lattice_seconds += by_lattice;
    if (planned > 0) times_as_fast.push_back(by_lattice / planned);
    tilted += plan.runs.size();
    failed += plan.failed.size();
    if (std::getenv("GOUGE_TELL") != nullptr)
      std::cout << n << ": " << plan.runs.size() << " tilted, " << plan.failed.size() << " not, planned in " << planned
                << " s, the lattice took " << by_lattice << " s" << std::endl;
    if (::testing::Test::HasFailure()) return;
  }
  std::cout << tilted << " runs tilted, " << failed << " not, " << missed
            << " of these though a lattice of 1 degree has a way; it has none for " << ours_alone
            << " that are tilted. Planned in " << seconds << " s, the lattices took " << lattice_seconds << " s";
  std::ranges::sort(times_as_fast);
  if (!times_as_fast.empty()) std::cout << ", in the median " << times_as_fast[times_as_fast.size() / 2] << " times";
  std::cout << "\n";
  EXPECT_GT(tilted, count / 8);
  EXPECT_LE(missed, ours_alone + 1);  // solved as often as by the lattice
}

}  // namespace
}  // namespace gouge::tilt_law_test
