#include "lib/machine/linear_limits.h"

#include <gtest/gtest.h>

#include "tests/lib/machine/machines.h"

// Limits of linear joints at the positions of a path, on a machine with a part zero.

namespace gouge::linear_limits_test {
namespace {

constexpr std::size_t kTrunnion = 0, kTableHead = 2;

/// Three positions of an upright tool, at the values 0, 50 and 100 of X.
Toolpath along_x(const Machine& machine) {
  Toolpath path;
  for (const double x : {0.0, 50.0, 100.0}) {
    Move& move = path.moves.emplace_back();
    move.end = {Vec3(x, 0, 0), Vec3::UnitZ()};
    move.has_start = path.moves.size() > 1;
  }
  path.joints = std::make_shared<const JointPath>(choose_joints(machine, path).path);
  return path;
}

Machine limited(std::size_t kind, const std::string& joint, double min, double max) {
  Machine machine = test::machines()[kind];
  for (Joint& one : machine.joints) {
    if (one.name != joint) continue;
    one.min = min;
    one.max = max;
  }
  return machine;
}

RigidTransform shifted(const Vec3& by) { return {Eigen::Matrix3d::Identity(), by}; }

TEST(LinearLimits, HoldOnAPlacedPartAlone) {
  const Machine machine = limited(kTrunnion, "X", -10, 60);
  const Toolpath path = along_x(machine);
  EXPECT_TRUE(check_linear_limits(machine, path, 0.0).problems.empty()) << "values count from the part zero";
  const LinearLimits found = check_linear_limits(place_part(machine, shifted({0, 0, 7})), path, std::nullopt);
  ASSERT_EQ(found.problems.size(), 1U);
  EXPECT_EQ(found.problems[0].move, 2U);
  EXPECT_EQ(found.problems[0].joint, 2U);
  EXPECT_NEAR(found.problems[0].value, 100, 1e-9);
  EXPECT_EQ(found.problems[0].limit, 60);
  EXPECT_TRUE(found.open.empty());
  const LinearLimits moved = check_linear_limits(place_part(machine, shifted({-40, 0, 0})), path, std::nullopt);
  ASSERT_EQ(moved.problems.size(), 1U) << "now the first is too far";
  EXPECT_EQ(moved.problems[0].move, 0U);
  EXPECT_EQ(moved.problems[0].limit, -10);
}

TEST(LinearLimits, AJointThatDependsOnTheToolLengthNeedsIt) {
  const Machine machine = place_part(limited(kTableHead, "Z", 0, 80), shifted({0, 0, 0}));
  const Toolpath path = along_x(machine);
  const LinearLimits open = check_linear_limits(machine, path, std::nullopt);
  EXPECT_TRUE(open.problems.empty());
  EXPECT_EQ(open.open, (std::vector<std::size_t>{3}));
  EXPECT_TRUE(check_linear_limits(machine, path, 79.0).problems.empty());
  EXPECT_EQ(check_linear_limits(machine, path, 81.0).problems.size(), 3U);
}

}  // namespace
}  // namespace gouge::linear_limits_test
