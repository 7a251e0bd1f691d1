#include "lib/machine/joint_rates.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "lib/base/units.h"
#include "lib/machine/joint_path.h"
#include "tests/lib/machine/machines.h"

// Rates of rotary joints at the programmed feed, against the time of each move.

namespace gouge::joint_rates_test {
namespace {

Pose leaning(double x, double degrees) {
  return {Vec3(x, 0, 0), Vec3(0, -std::sin(degrees * kDegree_rad), std::cos(degrees * kDegree_rad))};
}

Toolpath path_of(const std::vector<Pose>& poses, const Feed& feed) {
  Toolpath path;
  path.moves.resize(poses.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    path.moves[i].end = poses[i];
    path.moves[i].has_start = i > 0;
    path.moves[i].set_feed(feed);
  }
  return path;
}

std::vector<RateExcess> excesses(Machine machine, Toolpath path, double rate_deg) {
  for (Joint& joint : machine.joints) joint.rate = rate_deg * kDegree_rad;
  path.joints = std::make_shared<const JointPath>(choose_joints(machine, path).path);
  return find_rate_excesses(machine, path);
}

const Feed kFeed = {600, FeedUnit::per_minute};

TEST(JointRates, AMoveTakesTheLengthOfItsTipPathAtItsFeed) {
  const Machine machine = test::machines()[0];
  // 10 degrees in 2 mm at 600 mm/min: 3000 deg/min; in 1 mm: 6000 deg/min.
  const Toolpath path = path_of({leaning(0, 0), leaning(2, 10), leaning(3, 20), leaning(100, 30)}, kFeed);
  EXPECT_TRUE(excesses(machine, path, 6001).empty());
  const std::vector<RateExcess> found = excesses(machine, path, 2999);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].move, 2U) << "the largest ratio first";
  EXPECT_EQ(found[0].joint, machine.rotary[1]);
  EXPECT_NEAR(found[0].needed / kDegree_rad, 6000, 1e-6);
  EXPECT_EQ(found[1].move, 1U);
  EXPECT_NEAR(found[1].needed / kDegree_rad, 3000, 1e-6);
}

TEST(JointRates, AnArcTakesTheTimeOfItsLength) {
  Toolpath path = path_of({leaning(-1, 0), leaning(1, 10)}, kFeed);
  path.arcs.push_back({});
  path.moves[1].kind = MoveKind::arc;
  path.moves[1].curve_kind = CurveKind::arc;
  path.arcs[0].center = Vec3::Zero();
  path.arcs[0].sweep_rad = std::numbers::pi;
  const std::vector<RateExcess> found = excesses(test::machines()[0], path, 1);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].needed / kDegree_rad, 10 * 600 / std::numbers::pi, 1e-6);
}

TEST(JointRates, NothingIsSaidWithoutAFeedARateOrAWay) {
  const Machine machine = test::machines()[0];
  const std::vector<Pose> poses = {leaning(0, 0), leaning(1, 10)};
  for (const Feed& feed :
       {Feed{}, Feed{0, FeedUnit::rapid}, Feed{0.2, FeedUnit::per_revolution}, Feed{0, FeedUnit::not_understood}})
    EXPECT_TRUE(excesses(machine, path_of(poses, feed), 1).empty());
  EXPECT_TRUE(excesses(machine, path_of({leaning(0, 0), leaning(0, 10)}, kFeed), 1).empty()) << "the tip rests";
  Toolpath rapid = path_of(poses, kFeed);
  rapid.moves[1].kind = MoveKind::rapid;
  EXPECT_TRUE(excesses(machine, rapid, 1).empty());
  Toolpath path = path_of(poses, kFeed);
  path.joints = std::make_shared<const JointPath>(choose_joints(machine, path).path);
  EXPECT_TRUE(find_rate_excesses(machine, path).empty()) << "no rates";
}

}  // namespace
}  // namespace gouge::joint_rates_test
