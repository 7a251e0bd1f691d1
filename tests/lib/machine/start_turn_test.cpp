#include "lib/machine/start_turn.h"

#include <gtest/gtest.h>

#include "lib/base/units.h"
#include "tests/lib/machine/machines.h"

// Starts, whole turns away, from which a joint cannot make the turns that are chosen.

namespace gouge::start_turn_test {
namespace {

Machine limited(double min_deg, double max_deg) {
  Machine machine = test::machines()[0];
  Joint& joint = machine.joints[machine.rotary[0]];
  joint.is_continuous = false;
  joint.min = min_deg * kDegree_rad;
  joint.max = max_deg * kDegree_rad;
  return machine;
}

Toolpath path_at(const std::vector<double>& degrees) {
  Toolpath path;
  JointPath joints;
  for (const double angle : degrees) {
    path.moves.emplace_back();
    joints.end.emplace_back(RotaryAngles{angle * kDegree_rad, 0.3});
    joints.start.push_back(path.moves.size() > 1 ? joints.end[path.moves.size() - 2] : std::nullopt);
  }
  path.joints = std::make_shared<const JointPath>(joints);
  return path;
}

TEST(OtherStarts, AreWholeTurnsAwayAndEndBeyondALimit) {
  const auto found = find_other_starts(limited(-360, 360), path_at({10, 60, 5, -20, -30}));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].joint, 0U);
  EXPECT_NEAR(found[0].chosen_rad, 10 * kDegree_rad, 1e-12);
  EXPECT_NEAR(found[0].other_rad, -350 * kDegree_rad, 1e-12);
  EXPECT_EQ(found[0].move, 3U) << "-20 - 360 degrees is beyond the limit";
  const auto above = find_other_starts(limited(-360, 720), path_at({-10, 20}));
  ASSERT_EQ(above.size(), 1U);
  EXPECT_NEAR(above[0].other_rad, 710 * kDegree_rad, 1e-12) << "the farthest is the nearest to a limit";
}

TEST(OtherStarts, AreNoneWhereTheWaysFitOrNoOtherStartIsPermitted) {
  EXPECT_TRUE(find_other_starts(limited(-360, 360), path_at({10, 60, 0.1})).empty()) << "it fits from -350 too";
  EXPECT_TRUE(find_other_starts(limited(-180, 180), path_at({10, 170, -170})).empty());
  EXPECT_TRUE(find_other_starts(limited(-360, 360), path_at({0, 90, -90})).empty()) << "360 is the limit itself";
  EXPECT_TRUE(find_other_starts(test::machines()[0], path_at({10, 1000})).empty()) << "without limits";
  EXPECT_TRUE(find_other_starts(limited(-360, 360), path_at({})).empty());
}

}  // namespace
}  // namespace gouge::start_turn_test
