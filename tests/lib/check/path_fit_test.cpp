#include "lib/check/path_fit.h"

#include <gtest/gtest.h>

#include <functional>
#include <numbers>

#include "lib/check/usual_mistakes.h"
#include "tests/support/paths.h"
#include "tests/support/shapes.h"
#include "tests/support/tools.h"
#include "tests/support/whole_check.h"

namespace gouge::path_fit_test {
namespace {

constexpr double kRadius_mm = 5, kDome_mm = 50;
const Vec3 kCenter(30, 10, -20);

// A ball cutter over a patch of a dome that lies nowhere symmetrically, inclined to the normal by lead and
// tilt.
std::vector<Pose> over_the_dome(double undercut_mm = 0) {
  std::vector<Pose> poses;
  for (int i = 0; i < 12; ++i) {
    for (int j = 0; j < 15; ++j) {
      const double u = -0.5 + 0.09 * i, v = -0.25 + 0.07 * j;
      const Vec3 normal = Vec3(std::sin(u), std::sin(v) * std::cos(u), std::cos(v) * std::cos(u));
      const Vec3 axis = (normal + Vec3(0.30, 0.18, 0.05)).normalized();
      poses.push_back({kCenter + (kDome_mm + kRadius_mm - undercut_mm) * normal - kRadius_mm * axis, axis});
    }
  }
  return poses;
}

Scene dome() { return {{shapes::moved(shapes::sphere(kDome_mm, 64, 128), kCenter)}, {}}; }

PathFit fit_of(const Toolpath& path, const Scene& scene, const ToolVariants& tool, unsigned threads = 1) {
  CheckOptions options;
  options.threads = 1;
  const OwnSetup own(&tool, scene, options);
  return find_path_fit(path, check(path, own.setup).verdicts, {&tool}, own.scene, threads);
}

PathFit dome_fit(const std::vector<Pose>& poses, unsigned threads = 1) {
  return fit_of(paths::through(poses), dome(), tools::ball(2 * kRadius_mm), threads);
}

std::vector<Pose> mistaken(const std::function<Pose(Pose)>& mistake) {
  std::vector<Pose> poses = over_the_dome();
  for (Pose& pose : poses) pose = mistake(pose);
  return poses;
}

Pose turned(const Pose& pose, double degrees, const Vec3& about) {
  const Eigen::AngleAxisd turn(degrees * std::numbers::pi / 180, about);
  return {turn * pose.tip, turn * pose.axis};
}

struct Case {
  const char* explanation;
  std::function<Pose(Pose)> mistake;

  friend void PrintTo(const Case& one, std::ostream* out) { *out << one.explanation; }
};

class UsualMistake : public ::testing::TestWithParam<Case> {};

INSTANTIATE_TEST_SUITE_P(
    PathFit, UsualMistake,
    ::testing::Values(
        Case{"I negated", [](Pose p) { return p.axis.x() *= -1, p; }},
        Case{"J negated", [](Pose p) { return p.axis.y() *= -1, p; }},
        Case{"K negated", [](Pose p) { return p.axis.z() *= -1, p; }},
        Case{"I, J and K negated", [](Pose p) { return p.axis *= -1, p; }},
        Case{"I and J exchanged", [](Pose p) { return std::swap(p.axis.x(), p.axis.y()), p; }},
        Case{"J and K exchanged", [](Pose p) { return std::swap(p.axis.y(), p.axis.z()), p; }},
        Case{"K and I exchanged", [](Pose p) { return std::swap(p.axis.z(), p.axis.x()), p; }},
        Case{"X and Y of positions and axes exchanged",
             [](Pose p) { return std::swap(p.tip.x(), p.tip.y()), std::swap(p.axis.x(), p.axis.y()), p; }},
        Case{"the part rotated by 90 degrees about Z", [](const Pose& p) { return turned(p, 90, Vec3::UnitZ()); }},
        Case{"the part rotated by 180 degrees about X", [](const Pose& p) { return turned(p, 180, Vec3::UnitX()); }},
        Case{"the part rotated by 270 degrees about Y", [](const Pose& p) { return turned(p, 270, Vec3::UnitY()); }},
        Case{"positions of the centre of the cutter's corner instead of its tip",
             [](Pose p) { return p.tip += kRadius_mm * p.axis, p; }},
        Case{"positions of the tip instead of the centre of the cutter's corner",
             [](Pose p) { return p.tip -= kRadius_mm * p.axis, p; }},
        Case{"the positions in inches (--path-units)", [](Pose p) { return p.tip /= 25.4, p; }}));

TEST_P(UsualMistake, IsFoundAndUndone) {
  const PathFit fit = dome_fit(mistaken(GetParam().mistake));
  EXPECT_NE(fit.kind, PathFit::Kind::fits);
  ASSERT_TRUE(fit.explanation.has_value());
  EXPECT_EQ(fit.explanation->text, GetParam().explanation);
  EXPECT_GE(fit.explanation->share, 0.95);
  EXPECT_TRUE(fit.explanation->is_of_all);
}

TEST(PathFit, AnStlInAnotherUnitIsOne) {
  for (const double factor : {25.4, 1 / 25.4}) {
    Scene scene = dome();
    for (Vec3& vertex : scene.parts[0].vertices) vertex *= factor;
    const PathFit fit = fit_of(paths::through(over_the_dome()), scene, tools::ball(2 * kRadius_mm));
    ASSERT_TRUE(fit.explanation.has_value()) << factor;
    EXPECT_EQ(fit.explanation->text,
              factor > 1 ? "a part 25.4 times smaller (--stl-units)" : "a part 25.4 times as large (--stl-units)");
  }
}

TEST(PathFit, WhatFitsNeedsNoExplanation) {
  const PathFit fit = dome_fit(over_the_dome());
  EXPECT_EQ(fit.kind, PathFit::Kind::fits);
  EXPECT_EQ(fit.positions, 180U);
  EXPECT_FALSE(fit.explanation.has_value());
}

TEST(PathFit, AUniformShallowUndercutIsLegitimateWork) {
  for (const double undercut : {0.05, 0.3, 0.5, 1.0, 2.0, 3.0}) {
    const PathFit fit = dome_fit(over_the_dome(undercut));
    EXPECT_EQ(fit.kind, PathFit::Kind::fits) << undercut;
    EXPECT_FALSE(fit.explanation.has_value()) << undercut;
  }
  // By the corner radius of a bull-nose cutter, which a shift by it would explain.
  std::vector<Pose> floor;
  for (int i = 0; i < 60; ++i) floor.push_back(paths::upright(i % 10, 0.5 * i, -2));
  const Scene block{{shapes::box(Vec3(-50, -50, -30), Vec3(50, 50, 0))}, {}};
  EXPECT_EQ(fit_of(paths::through(floor), block, tools::bull(16, 2)).kind, PathFit::Kind::fits);
}

/// A pass along x on a floor at z = 0, 15 mm beside a wall that is 60 mm high and 60 mm long. A holder of 40 mm begins
/// 30 mm above the tip of the ball.
Toolpath beside_a_wall(double level) {
  std::vector<Pose> poses;
  for (int i = 0; i <= 160; ++i) poses.push_back(paths::upright(20 + i, 5, level));
  return paths::through(poses);
}

ToolVariants ball_in_a_wide_holder() {
  ToolAssembly tool = tools::assembly(BallCutter{10, 30});
  tool.shank.clear();
  tool.holder = {{40, 40, 50}};
  return tools::variants(tool);
}

Scene floor_and_wall() {
  return {{shapes::box(Vec3(0, -60, -20), Vec3(200, 60, 0)), shapes::box(Vec3(70, 20, 0), Vec3(130, 30, 60))}, {}};
}

TEST(PathFit, AHolderThatCollidesInMostPositionsIsNoMisfit) {
  const PathFit fit = fit_of(beside_a_wall(0.005), floor_and_wall(), ball_in_a_wide_holder());
  EXPECT_EQ(fit.kind, PathFit::Kind::fits) << (fit.explanation ? fit.explanation->text : "");
  EXPECT_EQ(fit.positions, 161U);
  EXPECT_EQ(fit.gouging, 0U) << "the cutter is nowhere in the part";
  EXPECT_EQ(fit.deep, 0U);
}

TEST(PathFit, ACutterThatIsDeepBesideACollidingHolderIsSeenAllTheSame) {
  const PathFit fit = fit_of(beside_a_wall(-12), floor_and_wall(), ball_in_a_wide_holder());
  EXPECT_EQ(fit.kind, PathFit::Kind::too_deep);
  EXPECT_GT(fit.deep, 140U);
}

TEST(PathFit, APlainMisfitThatNothingExplainsSaysSo) {
  const PathFit fit = dome_fit(mistaken([](Pose p) { return p.tip += Vec3(7, -4, -17), p; }));
  EXPECT_EQ(fit.kind, PathFit::Kind::too_deep);
  EXPECT_GT(fit.deep, fit.positions / 2);
  EXPECT_FALSE(fit.explanation.has_value());
}

TEST(PathFit, OneBadOperationIsNoMisfit) {
  std::vector<Pose> poses = over_the_dome();
  std::vector<Pose> bad = mistaken([](Pose p) { return p.tip += Vec3(0, 0, -20), p; });
  for (int i = 0; i < 3; ++i) poses.insert(poses.end(), bad.begin(), bad.end());
  Toolpath path = paths::through(poses);
  path.operations.resize(2);
  for (std::size_t i = 0; i < path.moves.size(); ++i) path.moves[i].operation = i < 180 ? 0 : 1;
  const PathFit fit = fit_of(path, dome(), tools::ball(2 * kRadius_mm));
  EXPECT_GT(fit.deep, fit.positions / 2);
  EXPECT_EQ(fit.kind, PathFit::Kind::fits);
}

TEST(PathFit, OfAnUprightAxisNoSignIsProposedThatChangesNothing) {
  std::vector<Pose> poses;
  for (int i = 0; i < 100; ++i) poses.push_back(paths::upright(i % 10, 0.3 * i, -12));
  const Scene block{{shapes::box(Vec3(-50, -50, -60), Vec3(50, 50, 0))}, {}};
  const PathFit fit = fit_of(paths::through(poses), block, tools::flat());
  EXPECT_EQ(fit.kind, PathFit::Kind::too_deep);
  EXPECT_EQ(fit.explanation ? fit.explanation->text : "none", "none");
}

TEST(PathFit, ConcernsTheTiltedPositionsAloneWhereFilesLeaveTheOthersUnsaid) {
  std::vector<Pose> poses = mistaken([](Pose p) { return p.axis.z() *= -1, p; });
  for (int i = 0; i < 60; ++i)
    poses.push_back(paths::upright(kCenter.x() + 0.1 * i - 3, kCenter.y(), kCenter.z() + kDome_mm));
  const PathFit fit = dome_fit(poses);
  ASSERT_TRUE(fit.explanation.has_value());
  EXPECT_EQ(fit.explanation->text, "K of the tilted axes negated");
  EXPECT_FALSE(fit.explanation->is_of_all);
}

TEST(PathFit, AFewPositionsAreTooLittleToJudgeBy) {
  std::vector<Pose> poses = mistaken([](Pose p) { return p.tip.z() -= 20, p; });
  poses.resize(9);
  EXPECT_EQ(dome_fit(poses).kind, PathFit::Kind::fits);
  EXPECT_EQ(dome_fit({}).kind, PathFit::Kind::fits);
}

TEST(PathFit, IsTheSameAtAnyNumberOfThreads) {
  const std::vector<Pose> poses = mistaken([](Pose p) { return p.axis.y() *= -1, p; });
  const PathFit one = dome_fit(poses, 1), four = dome_fit(poses, 4);
  ASSERT_TRUE(one.explanation && four.explanation);
  EXPECT_EQ(one.explanation->text, four.explanation->text);
  EXPECT_EQ(one.explanation->share, four.explanation->share);
  EXPECT_EQ(one.gouging, four.gouging);
}

TEST(UsualMistakes, UndoneTurnsAreProperAndKeepLengths) {
  for (const UndoneMistake& mistake : usual_mistakes(LengthUnit::mm)) {
    EXPECT_NEAR(std::abs(mistake.axis.determinant()), 1, 1e-12) << mistake.text;
    EXPECT_NEAR(mistake.pose({Vec3(1, 2, 3), Vec3(0.6, 0, 0.8)}, 2).axis.norm(), 1, 1e-12) << mistake.text;
  }
}

}  // namespace
}  // namespace gouge::path_fit_test
