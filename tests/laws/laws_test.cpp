// Relations between the results of two queries that hold in every scene. A verdict states that the true depth lies
// in [depth, depth_upper]; two verdicts on the same truth must therefore overlap, however they were found.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "lib/geom/pose.h"
#include "tests/laws/random_scenes.h"
#include "tests/support/reference.h"
#include "tests/support/tools.h"
#include "tests/support/whole_check.h"

namespace gouge::laws_test {
namespace {

using laws::RandomScene;
using laws::SceneScatter;

constexpr double kRounding_mm = 1e-9;
const CheckOptions kOptions{};

CheckResult check(const Toolpath& path, const ToolVariants& tool, const Scene& scene,
                  const CheckOptions& options = kOptions) {
  return whole_check(path, &tool, scene, options);
}

const std::vector<ToolVariants>& all_tools() {
  static const std::vector<ToolVariants> kTools = [] {
    std::vector<ToolVariants> both = tools::all();
    for (const ToolVariants& more : tools::shapes()) both.push_back(more);
    return both;
  }();
  return kTools;
}

const ToolVariants& tool_of(std::size_t i) { return all_tools()[i % all_tools().size()]; }

bool is_surely_a_gouge(const MoveVerdict& v, const CheckOptions& options = kOptions) {
  return v.depth_mm > options.tolerance_mm + options.resolution_mm;
}

/// The truth of `a` is at least that of `b`.
void expect_no_shallower(const MoveVerdict& a, const MoveVerdict& b, const std::string& where,
                         const CheckOptions& options = kOptions) {
  EXPECT_GE(a.depth_upper_mm, b.depth_mm - kRounding_mm) << where;
  EXPECT_TRUE(a.state == MoveState::gouge || !is_surely_a_gouge(b, options)) << where;
}

void expect_same_truth(const MoveVerdict& a, const MoveVerdict& b, const std::string& where) {
  expect_no_shallower(a, b, where);
  expect_no_shallower(b, a, where);
  if (a.state == MoveState::gouge && b.state == MoveState::gouge) {
    EXPECT_NEAR(a.depth_mm, b.depth_mm, kOptions.resolution_mm + kRounding_mm) << where;
  }
}

std::string where(std::size_t scene, std::size_t move) {
  return "scene " + std::to_string(scene) + ", move " + std::to_string(move);
}

/// Runs `law(scatter, random scene, tool, number)` on many scenes, which must hold both clean moves and gouges.
template <class Law>
void on_random_scenes(std::uint64_t stream, std::size_t count, Law&& law) {
  std::size_t gouges = 0, moves = 0;
  for (std::size_t i = 0; i < count; ++i) {
    SceneScatter scatter(stream * 100000 + i);
    const RandomScene random = scatter.scene(tool_of(i).bare);
    const CheckResult result = check(random.path, tool_of(i), random.scene);
    gouges += result.counts.gouge;
    moves += result.verdicts.size();
    law(scatter, random, tool_of(i), result, i);
  }
  EXPECT_GT(gouges, moves / 4);
  EXPECT_LT(gouges, moves * 95 / 100);
  ::testing::Test::RecordProperty("gouges_of_100", static_cast<int>(100 * gouges / moves));
}

RandomScene moved(RandomScene random, const RigidTransform& by) {
  for (Vec3& v : random.scene.parts[0].vertices) v = by.point(v);
  for (Move& move : random.path.moves) move.end = by.pose(move.end);
  return random;
}

/// A turn by 90 degrees about one of the axes, and a shift that is a power of two: exact in binary.
RigidTransform quarter_turn(SceneScatter& scatter) {
  const auto k = static_cast<Eigen::Index>(scatter.below(3));
  RigidTransform turn;
  turn.rotation.setZero();
  turn.rotation(k, k) = 1;
  turn.rotation((k + 1) % 3, (k + 2) % 3) = -1;
  turn.rotation((k + 2) % 3, (k + 1) % 3) = 1;
  return turn;
}

TEST(Laws, AQuarterTurnOfEverythingKeepsTheVerdicts) {
  on_random_scenes(1, 150,
                   [](SceneScatter& scatter, const RandomScene& random, const ToolVariants& tool, const CheckResult& a,
                      std::size_t i) {
                     const RandomScene turned = moved(random, quarter_turn(scatter));
                     const CheckResult b = check(turned.path, tool, turned.scene);
                     for (std::size_t m = 0; m < a.verdicts.size(); ++m)
                       expect_same_truth(a.verdicts[m], b.verdicts[m], where(i, m));
                   });
}

TEST(Laws, AnyRigidMotionOfEverythingNeverTurnsGougeIntoClean) {
  on_random_scenes(2, 150,
                   [](SceneScatter& scatter, const RandomScene& random, const ToolVariants& tool, const CheckResult& a,
                      std::size_t i) {
                     RigidTransform by;
                     by.rotation =
                         Eigen::AngleAxisd(scatter.in(-3, 3), scatter.point(1).normalized()).toRotationMatrix();
                     by.shift = scatter.point(300);
                     const RandomScene turned = moved(random, by);
                     const CheckResult b = check(turned.path, tool, turned.scene);
                     for (std::size_t m = 0; m < a.verdicts.size(); ++m)
                       expect_same_truth(a.verdicts[m], b.verdicts[m], where(i, m));
                   });
}

TEST(Laws, TheOrderOfTrianglesAndCornersChangesNothingButTriangleNumbers) {
  on_random_scenes(3, 150,
                   [](SceneScatter& scatter, const RandomScene& random, const ToolVariants& tool, const CheckResult& a,
                      std::size_t i) {
                     RandomScene shuffled = random;
                     IndexedMesh& mesh = shuffled.scene.parts[0];
                     for (std::size_t t = mesh.triangles.size(); t > 1; --t) {
                       std::swap(mesh.triangles[t - 1], mesh.triangles[scatter.below(t)]);
                     }
                     for (TriangleCorners& corners : mesh.triangles)
                       std::rotate(corners.begin(), corners.begin() + 1, corners.end());
                     const CheckResult b = check(shuffled.path, tool, shuffled.scene);
                     for (std::size_t m = 0; m < a.verdicts.size(); ++m) {
                       expect_same_truth(a.verdicts[m], b.verdicts[m], where(i, m));
                       if (!b.verdicts[m].witness) continue;
                       const Witness& w = *b.verdicts[m].witness;
                       const double off = reference::distance_to_triangle(
                           w.point, mesh.corner(w.triangle, 0), mesh.corner(w.triangle, 1), mesh.corner(w.triangle, 2));
                       EXPECT_LE(off, 1e-9) << where(i, m);
                     }
                   });
}

TEST(Laws, AToolThatContainsAnotherIsNeverLessDeep) {
  // Each pair with how far the tip of the larger one lies below that of the smaller.
  struct Pair {
    ToolVariants smaller, larger;
    double tip_below_mm;
  };
  const ToolVariants ball10 = tools::ball(10);
  const std::vector<Pair> pairs = {
      {ball10, tools::variants(tools::assembly(BallCutter{12, 31}, 12)), 1},  // about the same centre
      {ball10, tools::flat(10), 0},
      {tools::bull(16, 2), tools::flat(16), 0},
      {tools::bull(16, 4), tools::bull(16, 2), 0},
      {tools::necked(), tools::variants(tools::assembly(FlatCutter{12, 10}, 12)), 0},
      {ball10, tools::variants(tools::assembly(BallCutter{10, 30}), 0.3, 0, 0), 0},
      {tools::tapered(), tools::variants(tools::assembly(TaperedCutter{4, 2, 5, 30}, 8), 0, 0.5, 1), 0}};
  on_random_scenes(
      4, 140,
      [&](SceneScatter& scatter, const RandomScene& random, const ToolVariants&, const CheckResult&, std::size_t i) {
        const Pair& pair = pairs[i % pairs.size()];
        Toolpath lower = paths::through({random.path.moves[0].end, {scatter.point(2), random.path.moves[0].end.axis}});
        Toolpath path = lower;
        for (Move& move : lower.moves) move.end.tip -= pair.tip_below_mm * move.end.axis;
        const CheckResult a = check(path, pair.smaller, random.scene);
        const CheckResult b = check(lower, pair.larger, random.scene);
        for (std::size_t m = 0; m < a.verdicts.size(); ++m)
          expect_no_shallower(b.verdicts[m], a.verdicts[m], where(i, m));
      });
}

TEST(Laws, ASmallerToleranceOrAFinerResolutionNeverTurnsGougeIntoClean) {
  on_random_scenes(5, 100,
                   [](SceneScatter& scatter, const RandomScene& random, const ToolVariants& tool, const CheckResult&,
                      std::size_t i) {
                     CheckOptions wide, narrow;
                     wide.tolerance_mm = std::pow(10, scatter.in(-2, 0.3));
                     narrow.tolerance_mm = wide.tolerance_mm * scatter.in(0, 0.9);
                     wide.resolution_mm = 0.004;
                     narrow.resolution_mm = 0.0003;
                     const CheckResult a = check(random.path, tool, random.scene, wide);
                     const CheckResult b = check(random.path, tool, random.scene, narrow);
                     for (std::size_t m = 0; m < a.verdicts.size(); ++m) {
                       expect_no_shallower(b.verdicts[m], a.verdicts[m], where(i, m), narrow);
                       expect_no_shallower(a.verdicts[m], b.verdicts[m], where(i, m), wide);
                     }
                   });
}

TEST(Laws, AMoveIsAsDeepAsTheDeeperOfItsHalves) {
  on_random_scenes(
      6, 120,
      [](SceneScatter&, const RandomScene& random, const ToolVariants& tool, const CheckResult& whole, std::size_t i) {
        std::vector<Pose> poses{random.path.moves[0].end};
        for (std::size_t m = 1; m < random.path.moves.size(); ++m) {
          poses.push_back(reference::pose_at(random.path.start_of(m), random.path.moves[m].end, 0.5));
          poses.push_back(random.path.moves[m].end);
        }
        const CheckResult halves = check(paths::through(poses), tool, random.scene);
        for (std::size_t m = 1; m < whole.verdicts.size(); ++m) {
          const MoveVerdict& one = halves.verdicts[2 * m - 1];
          const MoveVerdict& two = halves.verdicts[2 * m];
          MoveVerdict both = one.depth_mm > two.depth_mm ? one : two;
          both.depth_upper_mm = std::max(one.depth_upper_mm, two.depth_upper_mm);
          expect_same_truth(whole.verdicts[m], both, where(i, m));
        }
      });
}

TEST(Laws, TheReversedPathHasTheSameGouges) {
  on_random_scenes(
      7, 150,
      [](SceneScatter&, const RandomScene& random, const ToolVariants& tool, const CheckResult& a, std::size_t i) {
        std::vector<Pose> back;
        for (const Move& move : random.path.moves) back.insert(back.begin(), move.end);
        const CheckResult b = check(paths::through(back), tool, random.scene);
        const std::size_t n = a.verdicts.size();
        for (std::size_t m = 1; m < n; ++m) expect_same_truth(a.verdicts[m], b.verdicts[n - m], where(i, m));
      });
}

TEST(Laws, AMoveIsNoShallowerThanItsEnds) {
  on_random_scenes(
      8, 150,
      [](SceneScatter&, const RandomScene& random, const ToolVariants& tool, const CheckResult& a, std::size_t i) {
        Toolpath alone = random.path;
        for (Move& move : alone.moves) move.has_start = false;
        const CheckResult ends = check(alone, tool, random.scene);
        for (std::size_t m = 1; m < a.verdicts.size(); ++m) {
          expect_no_shallower(a.verdicts[m], ends.verdicts[m], where(i, m));
          expect_no_shallower(a.verdicts[m], ends.verdicts[m - 1], where(i, m));
        }
      });
}

TEST(Laws, AFixtureMoreNeverRemovesAGouge) {
  on_random_scenes(9, 120,
                   [](SceneScatter& scatter, const RandomScene& random, const ToolVariants& tool, const CheckResult& a,
                      std::size_t i) {
                     Scene more = random.scene;
                     more.fixtures.push_back(scatter.triangles(4));
                     const CheckResult b = check(random.path, tool, more);
                     for (std::size_t m = 0; m < a.verdicts.size(); ++m)
                       expect_no_shallower(b.verdicts[m], a.verdicts[m], where(i, m));
                     // The same surface as fixture or as part is as deep: no tool here has stock to leave.
                     const CheckResult c = check(
                         random.path, tool, {{shapes::moved(shapes::cube(1), Vec3(0, 0, -900))}, random.scene.parts});
                     for (std::size_t m = 0; m < a.verdicts.size(); ++m)
                       expect_same_truth(a.verdicts[m], c.verdicts[m], where(i, m));
                   });
}

TEST(Laws, EveryMoveHasOneStateAndTheCountsAddUp) {
  on_random_scenes(
      10, 150, [](SceneScatter&, const RandomScene& random, const ToolVariants&, const CheckResult& a, std::size_t i) {
        const StateCounts& c = a.counts;
        EXPECT_EQ(a.verdicts.size(), random.path.moves.size());
        EXPECT_EQ(c.clean + c.near_miss + c.gouge + c.buried + c.not_checked + c.not_certified, a.verdicts.size()) << i;
        std::size_t reported = 0;
        for (const Event& event : a.events) reported += event.moves;
        EXPECT_EQ(reported, a.verdicts.size() - c.clean - c.not_checked) << i;
        double worst = 0;
        for (const MoveVerdict& v : a.verdicts) {
          const bool is_gouge = v.state == MoveState::gouge;
          worst = std::max(worst, is_gouge ? v.depth_mm : 0);
          EXPECT_EQ(is_gouge, v.depth_mm > kOptions.tolerance_mm) << i;
          EXPECT_LE(v.depth_upper_mm, kOptions.resolution_mm + (is_gouge ? v.depth_mm : kOptions.tolerance_mm)) << i;
        }
        EXPECT_EQ(worst, a.worst_depth_mm) << i;
      });
}

TEST(Laws, TheReferenceNeverFindsMoreOnRandomScenes) {
  std::size_t seen = 0, gouges = 0;
  on_random_scenes(
      11, 60,
      [&](SceneScatter&, const RandomScene& random, const ToolVariants& tool, const CheckResult& a, std::size_t i) {
        const reference::Contour contour(tool.against_part);
        for (std::size_t m = 0; m < a.verdicts.size(); ++m) {
          const MoveVerdict& v = a.verdicts[m];
          const Move& move = random.path.moves[m];
          const Pose from = move.has_start ? random.path.start_of(m) : move.end;
          const double mark = v.state == MoveState::gouge ? v.depth_mm - 0.005 : v.depth_upper_mm;
          const reference::Found found = reference::deepest(contour, contour, from, move.end, random.scene, mark);
          EXPECT_LE(found.depth_mm, v.depth_upper_mm + kRounding_mm) << where(i, m) << ", t " << found.t;
          gouges += v.state == MoveState::gouge ? 1 : 0;
          seen += v.state == MoveState::gouge && found.depth_mm > v.depth_mm - 0.001 ? 1 : 0;
        }
      });
  EXPECT_GE(seen * 10, gouges * 9) << "the reference is too weak";
}

}  // namespace
}  // namespace gouge::laws_test
