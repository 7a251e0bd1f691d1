#include "lib/machine/joint_reach.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lib/machine/joint_path.h"
#include "lib/path/path_info.h"
#include "tests/lib/machine/machines.h"

// Poses beside a path that the joints can take, as choose_joints takes them from position to position.

namespace gouge::joint_reach_test {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

struct Limit {
  std::string joint;
  std::optional<double> min_deg, max_deg;
};

Machine limited(std::size_t kind, const std::vector<Limit>& limits) {
  Machine machine = test::machines()[kind];
  for (const Limit& limit : limits) {
    Joint& joint = *std::ranges::find(machine.joints, limit.joint, &Joint::name);
    joint.is_continuous = false;
    if (limit.min_deg) joint.min = *limit.min_deg * (is_rotary(joint) ? kDegree : 1);
    if (limit.max_deg) joint.max = *limit.max_deg * (is_rotary(joint) ? kDegree : 1);
  }
  return machine;
}

Toolpath path_of(const Machine& machine, const std::vector<Pose>& poses) {
  Toolpath path;
  for (const Pose& pose : poses) {
    Move& move = path.moves.emplace_back();
    move.end = pose;
    move.has_start = path.moves.size() > 1;
  }
  path.joints = std::make_shared<const JointPath>(choose_joints(machine, path).path);
  return path;
}

/// An axis that leans by some degrees towards a direction about Z, 0: that of X.
Vec3 leaning(double by_deg, double towards_deg) {
  const double sine = std::sin(by_deg * kDegree);
  return {sine * std::cos(towards_deg * kDegree), sine * std::sin(towards_deg * kDegree), std::cos(by_deg * kDegree)};
}

/// Reach from an upright tool.
class Upright {
 public:
  explicit Upright(const Machine& machine)
      : path_(path_of(machine, {{Vec3::Zero(), Vec3::UnitZ()}})), reach_(machine, path_, std::nullopt) {}
  [[nodiscard]] bool can_lean(double by_deg, double towards_deg) const {
    return reach_.can_reach(0, Vec3::UnitZ(), {Vec3::Zero(), leaning(by_deg, towards_deg)});
  }
  [[nodiscard]] std::string why_not(double by_deg, double towards_deg) const {
    return reach_.why_not(0, Vec3::UnitZ(), {Vec3::Zero(), leaning(by_deg, towards_deg)});
  }

 private:
  Toolpath path_;
  JointReach reach_;
};

TEST(JointReach, EndsAtTheLimitOfTheSecondJointWhichItNames) {
  const Upright upright(limited(0, {{"A", -1, 1}}));
  for (const double towards : {-80.0, -20.0, 20.0, 80.0, 100.0, 180.0 - 20}) {
    EXPECT_TRUE(upright.can_lean(0.99, towards)) << towards;
    EXPECT_FALSE(upright.can_lean(1.01, towards)) << towards;
  }
  EXPECT_EQ(upright.why_not(0.99, -90), "");
  EXPECT_EQ(upright.why_not(1.25, -90), "joint A would be at 1.25 degrees; its limit is 1 degrees");
  EXPECT_EQ(upright.why_not(1.25, 90), "joint A would be at -1.25 degrees; its limit is -1 degrees");
}

TEST(JointReach, NeverPassesToTheOtherSolutionOnItsWay) {
  const Upright upright(limited(0, {{"A", -120, 1}}));
  EXPECT_TRUE(upright.can_lean(0.9, -90));
  EXPECT_FALSE(upright.can_lean(1.2, -90)) << "C would turn by 180 degrees while A passes 0";
  EXPECT_TRUE(upright.can_lean(1.2, 90));
}

TEST(JointReach, AtAPoleTheLimitsDecideBetweenBothSolutions) {
  const Upright upright(limited(0, {{"A", 0, 90}}));
  EXPECT_TRUE(upright.can_lean(20, -90));
  EXPECT_TRUE(upright.can_lean(20, 80)) << "C turns far while A is 0";
  EXPECT_FALSE(upright.can_lean(20, 90)) << "C may turn by 180 degrees either way";
  EXPECT_NE(upright.why_not(20, 90).find("joint C may turn by"), std::string::npos) << upright.why_not(20, 90);
}

TEST(JointReach, OfALimitedFirstJointIsAPairOfSectors) {
  const Upright upright(limited(0, {{"C", -10, 10}}));
  for (const double side : {-90.0, 90.0}) {
    EXPECT_TRUE(upright.can_lean(20, side + 9.9)) << side;
    EXPECT_FALSE(upright.can_lean(20, side + 10.1)) << side;
  }
  EXPECT_NE(upright.why_not(20, 0).find("joint C would be at "), std::string::npos) << upright.why_not(20, 0);
}

TEST(JointReach, HasLimitsOfLinearJointsOnAPlacedPartAlone) {
  const Machine machine = limited(0, {{"X", -10, 10}});
  const Machine placed = place_part(machine, {Eigen::Matrix3d::Identity(), Vec3::Zero()});
  const Toolpath path = path_of(placed, {{Vec3::Zero(), Vec3::UnitZ()}});
  const Vec3 lean = leaning(1, -90);
  const JointReach reach(placed, path, std::nullopt), unplaced(machine, path, std::nullopt);
  EXPECT_TRUE(reach.can_reach(0, Vec3::UnitZ(), {Vec3(9.9, 0, 0), lean}));
  EXPECT_FALSE(reach.can_reach(0, Vec3::UnitZ(), {Vec3(10.1, 0, 0), lean}));
  EXPECT_EQ(reach.why_not(0, Vec3::UnitZ(), {Vec3(10.1, 0, 0), lean}),
            "joint X would be at 10.1 mm; its limit is 10 mm");
  EXPECT_TRUE(unplaced.can_reach(0, Vec3::UnitZ(), {Vec3(10.1, 0, 0), lean}));
}

// The way to the tilted axis in small steps, as a path. Away from poles both agree.
TEST(JointReach, IsWhatThePathWithSmallStepsReaches) {
  constexpr int kSteps = 40;
  test::Scatter random(5);
  std::size_t reached = 0, not_reached = 0;
  for (int n = 0; n < 2000; ++n) {
    const auto kind = static_cast<std::size_t>(random.in(0, 4.999));
    Machine machine = test::machines()[kind];
    for (const std::size_t k : machine.rotary) {
      machine.joints[k].is_continuous = false;
      machine.joints[k].min = random.in(-150, 0) * kDegree;
      machine.joints[k].max = random.in(0, 150) * kDegree;
    }
    const auto within = [&](std::size_t k) {
      const Joint& joint = machine.joints[machine.rotary[k]];
      return random.in(*joint.min, *joint.max);
    };
    const Vec3 programmed = tool_axes(machine, {within(0), within(1)}).col(2);
    const Vec3 &pole = machine.joints[machine.rotary[0]].direction, side = programmed.unitOrthogonal();
    const Vec3 towards = Eigen::AngleAxisd(random.in(0, 2 * std::numbers::pi), programmed) * side;
    const double by = random.in(0, 30 * kDegree);
    std::vector<Pose> way;
    double off_pole = 1;
    for (int k = 0; k <= kSteps; ++k) {
      way.push_back({Vec3::Zero(), std::cos(by * k / kSteps) * programmed + std::sin(by * k / kSteps) * towards});
      off_pole = std::min(off_pole, way.back().axis.cross(pole).norm());
    }
    if (off_pole < 0.1) continue;
    Toolpath path = path_of(machine, {way.front()});
    if (!path.joints->end[0]) continue;
    // The path begins with the same angles.
    const JointReach reach(machine, path, std::nullopt);
    const JointChoice choice = choose_joints(machine, path_of(machine, way));
    const bool is_reached = choice.problems.empty();
    // Near a limit, digits decide.
    const RotaryAngles end = choice.path.end.back().value_or(RotaryAngles{});
    const bool is_close = is_reached && std::ranges::any_of(std::array{0, 1}, [&](int k) {
                            const Joint& joint = machine.joints[machine.rotary[static_cast<std::size_t>(k)]];
                            const double angle = end[static_cast<std::size_t>(k)];
                            return std::min(std::abs(angle - *joint.min), std::abs(angle - *joint.max)) < 1e-4;
                          });
    if (is_close || choice.breaks > 0) continue;
    const std::optional<RotaryAngles> begin = choice.path.end.front();
    if (!begin || std::abs((*begin)[0] - (*path.joints->end[0])[0]) > 1e-6) continue;
    EXPECT_EQ(reach.can_reach(0, programmed, way.back()), is_reached) << machine.name << ' ' << n;
    ++(is_reached ? reached : not_reached);
  }
  EXPECT_GT(reached, 300U);
  EXPECT_GT(not_reached, 30U);
}

}  // namespace
}  // namespace gouge::joint_reach_test
