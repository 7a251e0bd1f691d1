#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <numbers>

#include "lib/check/sweep_filter.h"
#include "lib/head/check_heads.h"
#include "lib/surface/surface.h"
#include "tests/support/motions.h"
#include "tests/support/revolved_heads.h"
#include "tests/support/scatter.h"
#include "tests/support/shapes.h"
#include "tests/support/solids.h"

// The bounds of heads against dense sampling, where they are hardest: fast turns with long arms, arcs whose
// axis turns, faces that slide along faces, thin bodies, slots with walls in them, solids within cavities,
// far from the origin. GOUGE_HEAD_MOTIONS sets how many motions each case gets (short by default), GOUGE_HEAD_SAMPLES
// at how many points of the part each is sampled, GOUGE_HEAD_CELLS how many cells its search gets.

namespace gouge::head_guarantee_test {
namespace {

using test::heads_around_the_axis;
using test::Scatter;

constexpr int kClimb = 100;  // steps

int number_from(const char* variable, int otherwise) {
  const char* given = std::getenv(variable);
  return given == nullptr ? otherwise : std::atoi(given);
}

int motions() { return number_from("GOUGE_HEAD_MOTIONS", 12); }
int samples() { return number_from("GOUGE_HEAD_SAMPLES", 400); }

struct Tally {
  int deep = 0, clean = 0, tight = 0, covered = 0, all = 0;
};

using MakeMotion = std::function<Motion(Scatter&)>;

/// Samples surface points, also those next to where the head was found deepest, over many instants; from the deepest
/// sample on it follows random steps that lead deeper.
double sampled_depth(const BodyMotion& moving, const HeadBody& head, const IndexedMesh& part,
                     const HeadResult& reported, Scatter& random) {
  struct Sample {
    std::size_t triangle = 0;
    double u = 0, v = 0, t = 0, depth_mm = 0;
  } deepest;
  const auto offer = [&](Sample sample) {
    const Vec3& a = part.corner(sample.triangle, 0);
    const Vec3 p =
        a + sample.u * (part.corner(sample.triangle, 1) - a) + sample.v * (part.corner(sample.triangle, 2) - a);
    sample.depth_mm = -head.surface.closest_point(moving.at(sample.t).inverse().point(p))->signed_mm();
    const bool is_deeper = sample.depth_mm > deepest.depth_mm;
    if (is_deeper) deepest = sample;
    return is_deeper;
  };
  for (int i = 0; i < samples(); ++i) {
    Sample sample;
    sample.triangle = reported.has_witness && i % 2 == 0 ? reported.triangle : random.below(part.triangles.size());
    sample.u = random.in(0, 1);
    sample.v = random.in(0, 1);
    if (sample.u + sample.v > 1) {
      sample.u = 1 - sample.u;
      sample.v = 1 - sample.v;
    }
    if (i % 7 == 0) sample.v = 0;
    for (int s = 0; s <= 64; ++s) {
      sample.t = i % 3 == 0 ? random.in(0, 1) : s / 64.0;
      offer(sample);
    }
  }
  double step = 0.1;
  for (int i = 0; i < kClimb && deepest.depth_mm > 0; ++i) {
    Sample next = deepest;
    next.u = std::clamp(next.u + step * random.in(-1, 1), 0.0, 1.0);
    next.v = std::clamp(next.v + step * random.in(-1, 1), 0.0, 1 - next.u);
    next.t = std::clamp(next.t + 0.2 * step * random.in(-1, 1), 0.0, 1.0);
    if (!offer(next)) step *= 0.9;
  }
  return deepest.depth_mm;
}

struct Expectation {
  const HeadBody& head;
  const IndexedMesh& part;
  const SearchGoal& goal;
};

void expect_reported(const Expectation& of, const BodyMotion& moving, const HeadResult& reported, double sampled_mm) {
  const double rounding = 1e-9 + 1e-14 * moving.motion().start().tip.norm();
  EXPECT_LE(sampled_mm, reported.depth_upper_mm + rounding);
  EXPECT_LE(reported.depth_mm, reported.depth_upper_mm);
  if (!reported.has_witness) return;
  const Vec3 there = moving.at(reported.t).inverse().point(reported.point);
  EXPECT_NEAR(-of.head.surface.closest_point(there)->signed_mm(), reported.depth_mm, rounding);
}

/// Each motion searched from all of the part, and from what the head's cover leaves of it, swept with its neighbours.
Tally expect_bounds(const IndexedMesh& head_mesh, const IndexedMesh& part, const MakeMotion& make,
                    const SearchGoal& goal, std::uint64_t seed) {
  Scatter random(seed);
  const Result<HeadBody> head = build_head_body(head_mesh);
  EXPECT_TRUE(head.has_value()) << head_mesh.name;
  const BlockTree tree = build_block_tree({&part, 1});
  const std::array targets{HeadTarget{&tree}};
  const std::array<CoverTarget, 1> covers{{{&head->cover, &tree}}};
  const bool is_covered = !head->cover.pieces.empty();
  const Expectation of{*head, part, goal};
  Tally tally;
  for (int i = 0; i < motions();) {
    std::vector<Motion> group;
    for (const std::size_t last = 1 + random.below(6); group.size() < last && i < motions(); ++i) {
      if (Motion motion = make(random); motion.is_defined()) group.push_back(std::move(motion));
    }
    const std::vector<SweptMove> swept = is_covered ? sweep_covers(group, covers, {goal, 0}) : std::vector<SweptMove>{};
    for (std::size_t m = 0; m < group.size(); ++m) {
      SCOPED_TRACE(head_mesh.name + ", motion " + std::to_string(i));
      const BodyMotion moving(group[m]);
      const HeadResult reported = search_head(moving, *head, targets, goal);
      const double sampled = sampled_depth(moving, *head, part, reported, random);
      expect_reported(of, moving, reported, sampled);
      if (is_covered) {
        const HeadResult left = search_head(moving, *head, targets, goal, swept[m].start);
        expect_reported(of, moving, left, sampled);
        EXPECT_LE(left.depth_mm, reported.depth_upper_mm + 1e-9);
        EXPECT_LE(reported.depth_mm, left.depth_upper_mm + 1e-9);
        ++tally.covered;
      }
      ++tally.all;
      tally.deep += reported.depth_mm > goal.tolerance_mm ? 1 : 0;
      tally.clean += reported.depth_upper_mm <= goal.tolerance_mm + goal.resolution_mm ? 1 : 0;
      tally.tight += reported.depth_upper_mm - reported.depth_mm <= goal.resolution_mm ? 1 : 0;
    }
  }
  return tally;
}

const auto kCells = static_cast<std::size_t>(number_from("GOUGE_HEAD_CELLS", 20000));
const SearchGoal kGoal{0.01, 0.01, 0.01, kCells};

TEST(HeadGuarantee, HoldsForFastTurnsWithLongArms) {
  // The head is 300 mm from the tip, so that a degree of turn is 5 mm of way.
  const IndexedMesh head = shapes::box(Vec3(-30, -20, 280), Vec3(40, 25, 330));
  const IndexedMesh part = shapes::moved(shapes::star_prism(), Vec3(0, 0, 280));
  const Tally tally = expect_bounds(
      head, part,
      [](Scatter& random) {
        const Vec3 z = Vec3::UnitZ();
        const Pose from{30 * random.point(1), (z + 0.3 * random.point(1)).normalized()};
        return test::straight(from, {30 * random.point(1), (z + 0.3 * random.point(1)).normalized()});
      },
      kGoal, 1);
  EXPECT_GT(tally.deep, tally.all / 4);
}

TEST(HeadGuarantee, HoldsOnArcsWhoseAxisTurns) {
  const Tally tally = expect_bounds(
      shapes::torus(20, 6, 24, 12), shapes::star_prism(),
      [](Scatter& random) {
        PathArc arc;
        arc.axis = random.direction();
        arc.center = 20 * random.point(1);
        arc.sweep_rad = 3 * random.in(-1, 1);
        const Vec3 r0 = 40 * arc.axis.cross(random.direction());
        const Vec3 r1 = Eigen::AngleAxisd(arc.sweep_rad, arc.axis) * r0;
        const Pose from{arc.center + r0, random.direction()};
        return test::along(from, {arc.center + r1 + 15 * random.in(-1, 1) * arc.axis, random.direction()}, arc);
      },
      kGoal, 2);
  EXPECT_GT(tally.deep, 0);
}

TEST(HeadGuarantee, HoldsWhereFacesSlideAlongFaces) {
  // Steps of a millimetre and upright axes: faces lie in one plane again and again.
  const Tally tally = expect_bounds(
      shapes::box(Vec3(-10, -8, 20), Vec3(10, 8, 30)), shapes::box(Vec3(-6, -6, 0), Vec3(6, 6, 25)),
      [](Scatter& random) {
        const auto step = [&] { return std::round(6 * random.in(-1, 1)); };
        const Pose from{Vec3(3 * step(), 3 * step(), step()), Vec3::UnitZ()};
        const bool is_level = random.below(2) == 0;
        return test::straight(from, {from.tip + Vec3(3 * step(), 3 * step(), is_level ? 0 : step()), Vec3::UnitZ()});
      },
      kGoal, 3);
  EXPECT_GT(tally.tight + tally.clean, tally.all / 2);
}

TEST(HeadGuarantee, HoldsForWallsInTheSlotsOfAHead) {
  // A slotted head and the same block as part: walls stand in slots, 2.5 mm from either side, or in walls.
  const IndexedMesh block = shapes::slotted_block();
  const Tally tally = expect_bounds(
      shapes::moved(block, Vec3(0, 0, 3)), block,
      [](Scatter& random) {
        const Pose from{Vec3(8 * random.in(-1, 1), 3 * random.in(-1, 1), 6 * random.in(-1, 1)), Vec3::UnitZ()};
        const Vec3 axis = (Vec3::UnitZ() + 0.1 * random.point(1)).normalized();
        return test::straight(from,
                              {from.tip + 3 * random.point(1), random.below(2) == 0 ? Vec3(Vec3::UnitZ()) : axis});
      },
      kGoal, 4);
  EXPECT_GT(tally.deep, 0);
}

TEST(HeadGuarantee, HoldsForWhatReachesAcrossASlotIntoTheOtherWall) {
  // A sheet whose tip is in the far wall of the slot: all of it is over the near wall's side, and outside
  // that.
  IndexedMesh sheet;
  sheet.name = "sheet";
  sheet.vertices = {Vec3(8.3, 17, 13), Vec3(8.3, 23, 13), Vec3(15.6, 20, 13.5)};
  sheet.triangles = {{0, 1, 2}};
  sheet.file_triangle = {0};
  const Tally tally = expect_bounds(
      shapes::slotted_block(8, 6, 20, 40), sheet,
      [](Scatter& random) {
        const auto tip = [&] { return Vec3(0.2 * random.in(-1, 1), 5 * random.in(-1, 1), 2 * random.in(-1, 1)); };
        const Vec3 axis = (Vec3::UnitZ() + 0.01 * random.point(1)).normalized();
        const Pose from{tip(), Vec3::UnitZ()};
        return test::straight(from, {tip(), random.below(2) == 0 ? Vec3(Vec3::UnitZ()) : axis});
      },
      kGoal, 9);
  EXPECT_EQ(tally.deep, tally.all);
}

TEST(HeadGuarantee, HoldsForWhatIsMetInMidSwing) {
  // A small head far out swings through the part: at both ends it is far away, and so is the chord.
  const Vec3 middle_axis = Vec3(0.2, -0.3, 1).normalized();
  const Vec3 place = rotation_to_axis(middle_axis) * Vec3(150, 30, 200);
  const Tally tally = expect_bounds(
      shapes::box(Vec3(145, 25, 195), Vec3(155, 35, 205)), shapes::moved(shapes::cube(3), place - Vec3(1.5, 1.5, 1.5)),
      [&](Scatter& random) {
        const Vec3 about = middle_axis.cross(random.direction()).normalized();
        const double turn = 0.1 + random.in(0, 1);
        const Pose from{Vec3::Zero(), Eigen::AngleAxisd(-turn, about) * middle_axis};
        return test::straight(from, {Vec3::Zero(), Eigen::AngleAxisd(turn, about) * middle_axis});
      },
      kGoal, 10);
  EXPECT_GT(tally.deep, tally.all / 4);
}

TEST(HeadGuarantee, HoldsForHeadsAroundTheAxis) {
  // Nearly round, and what a cover holds that the head does not: steps, a thread of bumps, corners of a box, a gap.
  const MakeMotion make = [](Scatter& random) {
    const Pose from{Vec3(40 * random.in(-1, 1), 40 * random.in(-1, 1), 20 * random.in(-1, 1)), random.axis(0.4)};
    const double way = random.below(2) == 0 ? 1 : 30;
    return test::straight(from, {from.tip + way * random.point(1), random.axis(0.4)});
  };
  std::uint64_t seed = 11;
  for (const IndexedMesh& head : heads_around_the_axis()) {
    const Tally tally = expect_bounds(head, shapes::star_prism(), make, kGoal, seed++);
    EXPECT_EQ(tally.covered, tally.all) << head.name;
    EXPECT_GT(tally.deep, 0) << head.name;
  }
}

TEST(HeadGuarantee, HoldsForAThinPlateAndForCavities) {
  const MakeMotion make = [](Scatter& random) {
    return test::straight({25 * random.point(1), random.direction()}, {25 * random.point(1), random.direction()});
  };
  expect_bounds(shapes::box(Vec3(-30, -20, 10), Vec3(30, 20, 10.02)), shapes::bumpy_sphere(), make,
                {1e-3, 1e-3, 1e-3, std::min(kCells, std::size_t{8000})}, 5);
  expect_bounds(shapes::hollow_cube(30), shapes::cube(12), make, kGoal, 6);
  expect_bounds(shapes::needle_fan(60), shapes::hollow_cube(20), make, kGoal, 7);
}

TEST(HeadGuarantee, HoldsFarFromTheOrigin) {
  const Vec3 far(1e5, -1e5, 1e5);
  expect_bounds(
      shapes::torus(20, 6, 24, 12), shapes::moved(shapes::star_prism(), far),
      [&](Scatter& random) {
        return test::straight({far + 30 * random.point(1), random.direction()},
                              {far + 30 * random.point(1), random.direction()});
      },
      {1e-4, 1e-4, 1e-4, kCells}, 8);
}

TEST(HeadGuarantee, NeverCallsAHeadWithinASolidCleanThatTouchesNothing) {
  // Within the material around a cavity, within the cavity, and within a solid inside the cavity.
  const IndexedMesh part =
      shapes::joined(shapes::joined(shapes::box(Vec3(-100, -100, -100), Vec3(100, 100, 100)),
                                    shapes::inside_out(shapes::box(Vec3(-60, -60, -60), Vec3(60, 60, 60)))),
                     shapes::box(Vec3(-40, -40, -40), Vec3(40, 40, 40)));
  Scene scene;
  scene.parts = {part};
  const std::vector<HeadBody> heads = {*build_head_body(shapes::box(Vec3(-3, -3, 0), Vec3(3, 3, 6)))};
  const PreparedScene prepared = prepare_scene(scene);
  const HeadChecker checker(heads, prepared);
  for (double x = -130; x <= 130; x += 7) {
    const Vec3 tip(x, 1, 2);
    MoveVerdict verdict;
    checker.check(test::straight({tip, Vec3::UnitZ()}, {tip + Vec3(0.5, 2, 1), Vec3::UnitZ()}), {}, verdict);
    const double out = std::abs(x);
    const bool is_solid = out < 36 || (out > 65 && out < 95);
    const bool is_free = (out > 44 && out < 55) || out > 105;
    if (is_solid) {
      EXPECT_EQ(verdict.state, MoveState::buried) << x;
    }
    if (is_free) {
      EXPECT_EQ(verdict.state, MoveState::clean) << x << " " << reason_text(verdict.reason);
    }
  }
}

}  // namespace
}  // namespace gouge::head_guarantee_test
