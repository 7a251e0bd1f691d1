#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/paths.h"
#include "tests/support/random_tools.h"
#include "tests/support/shapes.h"
#include "tests/support/tools.h"
#include "tests/support/whole_check.h"

// A blade or a point of a tool that is nowhere as deep as the tolerance may be anywhere in the part: no move is clean
// for that.

namespace gouge::reach_test {
namespace {

using paths::through;
using paths::upright;

Scene block() { return {{shapes::box(Vec3(-100, -50, -40), Vec3(0, 50, 0))}, {}}; }

CheckResult check(const std::vector<Pose>& poses, const ToolVariants& tool, double tolerance_mm,
                  double resolution_mm = 0.001) {
  CheckOptions options;
  options.tolerance_mm = tolerance_mm;
  options.resolution_mm = resolution_mm;
  options.threads = 1;
  const Scene scene = block();
  return whole_check(through(poses), &tool, scene, options);
}

ToolVariants saw(double stock = 0) {
  return make_tool_variants({1, "saw", SlittingSawCutter{63, 0.5, 0, 0}, {{16, 16, 40}}, {}}, stock, 0, 0).value();
}

ToolVariants point(double half_deg) { return tools::variants({1, "point", ChamferCutter{1, 0, half_deg, 0}, {}, {}}); }

ToolVariants needle() {
  Profile profile;
  const std::vector<Vec2> corners{{0, 0}, {0.1, 0}, {0.1, 6}, {3, 6}, {3, 20}, {0, 20}};
  for (std::size_t i = 0; i + 1 < corners.size(); ++i)
    profile.elements.push_back(make_segment(Body::cutter, corners[i], corners[i + 1]));
  ToolVariants variants;
  variants.bare = variants.against_part = variants.against_fixture = compile_tool("needle", profile);
  return variants;
}

TEST(Reach, ASawThatSlotsThePartIsNotCleanBecauseItIsThin) {
  const std::vector<Pose> poses{upright(100, 0, -20), upright(15, 0, -20)};
  const CheckResult r = check(poses, saw(), 0.26);
  EXPECT_EQ(r.verdicts[1].state, MoveState::not_certified);
  EXPECT_NE(reason_text(r.verdicts[1].reason)
                .find("a thin or pointed feature of the tool may reach into the solid by up to 24"),
            std::string::npos)
      << reason_text(r.verdicts[1].reason);
  EXPECT_EQ(check(poses, saw(), 0.01, 0.3).counts.clean, 1U) << "a coarse resolution lets as much through";
  EXPECT_EQ(check(poses, saw(), 0.2).verdicts[1].state, MoveState::gouge);
  EXPECT_EQ(check({upright(100, 0, -20), upright(35, 0, -20)}, saw(), 0.26).counts.clean, 2U) << "beside the part";
}

TEST(Reach, ANeedleThatPloughsThePartIsNotClean) {
  const std::vector<Pose> poses{upright(-50, 0, 10), upright(-50, 0, -5), upright(-40, 0, -5)};
  const CheckResult r = check(poses, needle(), 0.1);
  EXPECT_EQ(r.verdicts[0].state, MoveState::clean);
  EXPECT_EQ(r.verdicts[1].state, MoveState::not_certified);
  EXPECT_EQ(r.verdicts[2].state, MoveState::not_certified);
  EXPECT_EQ(check({upright(-50, 0, 10), upright(-50, 0, 0.01)}, needle(), 0.1).counts.clean, 2U);
}

TEST(Reach, APointedTipIsCleanNoDeeperThanThreeTimesTheDepthAllowed) {
  const ToolVariants tool = point(2);
  const auto state_at = [&](double z, double tolerance) {
    return check({upright(-50, 0, z + 10), upright(-50, 0, z), upright(-40, 0, z)}, tool, tolerance).verdicts[2].state;
  };
  EXPECT_EQ(state_at(-0.28, 0.01), MoveState::not_certified);
  EXPECT_EQ(state_at(-0.034, 0.01), MoveState::not_certified);
  EXPECT_EQ(state_at(-0.02, 0.01), MoveState::clean);
  EXPECT_EQ(state_at(-0.5, 0.01), MoveState::gouge);
  EXPECT_EQ(state_at(-0.05, 0), MoveState::gouge) << "no tolerance";
  EXPECT_EQ(state_at(0.01, 0), MoveState::clean);
}

TEST(Reach, OfUsualCornersChangesNoVerdict) {
  for (const double depth : {0.0005, 0.0095}) {
    const CheckResult flat = check({upright(-50, 0, 10), upright(-50, 0, -depth)}, tools::flat(), 0.01);
    EXPECT_EQ(flat.verdicts[1].state, MoveState::clean) << depth;
    const double lean = std::sin(std::numbers::pi / 6);
    const CheckResult cone = check({upright(-50, 0, 10), upright(-50, 0, -depth / lean)}, point(30), 0.01);
    EXPECT_EQ(cone.verdicts[1].state, MoveState::clean) << depth;
  }
}

TEST(Reach, StockToLeaveThickensABladeAgainstThePartAlone) {
  const ToolVariants grown = saw(1);
  EXPECT_EQ(check({upright(100, 0, -20), upright(32.3, 0, -20)}, grown, 0.26).verdicts[1].state, MoveState::clean);
  EXPECT_EQ(check({upright(100, 0, -20), upright(15, 0, -20)}, grown, 0.26).verdicts[1].state, MoveState::gouge);
}

/// How far a tool reaches below the plane z = 0 at a pose: its lowest point, by examining its boundary.
double lowest(const CompiledTool& tool, const Pose& pose) {
  double low = pose.tip.z();
  const double lean = std::sqrt(std::max(0.0, 1 - pose.axis.z() * pose.axis.z()));
  for (const BoundaryElement& e : tool.elements) {
    for (int k = 0; k <= 64; ++k) {
      Vec2 q = e.a + (e.b - e.a) * k / 64.0;
      if (e.kind == ElementKind::arc) q = e.center + e.radius_mm * (q - e.center).normalized();
      low = std::min(low, pose.tip.z() + q.y() * pose.axis.z() - q.x() * lean);
    }
  }
  return low;
}

TEST(Reach, NoCleanMoveOfAnyToolGoesFartherIntoTheSolidThanThreeTimesTheDepthAllowed) {
  const Scene scene{{shapes::box(Vec3(-1e4, -1e4, -1e4), Vec3(1e4, 1e4, 0))}, {}};
  const PreparedScene prepared = prepare_scene(scene);
  std::vector<ToolVariants> tools{point(2), point(5), point(12), point(16), point(40), needle(), saw(), tools::ball()};
  for (std::uint64_t seed = 0; seed < 32; ++seed) {
    const test::RandomTool random = test::random_tool(seed);
    ToolVariants tool;
    tool.bare = tool.against_part = tool.against_fixture = compile_tool(random.name, random.profile);
    tools.push_back(tool);
  }
  std::size_t clean = 0, held_back = 0;
  for (std::size_t seed = 0; seed < tools.size(); ++seed) {
    const ToolVariants& tool = tools[seed];
    test::Scatter numbers(seed + 5);
    CheckOptions options;
    options.threads = 1;
    options.budget_per_move = 20'000;
    options.tolerance_mm = tool.bare.core_depth_mm * std::pow(10.0, numbers.in(-2.5, -0.3));
    options.resolution_mm = 0.1 * options.tolerance_mm;
    const double allowed = options.tolerance_mm + options.resolution_mm;
    for (int k = 0; k < 6; ++k) {
      const double tilt = k % 3 != 0 ? 0 : numbers.in(0, 1.5);
      Pose end{Vec3::Zero(), Vec3(std::sin(tilt), 0, std::cos(tilt))};
      end.tip.z() = -lowest(tool.bare, end) - allowed * numbers.in(0.2, k % 2 == 0 ? 2 : 10);
      const Pose start{end.tip + Vec3(0, 0, 500), end.axis};
      const CheckResult r = gouge::check(through({start, end}), CheckSetup{{&tool}, {}, prepared, options});
      const double reach = -lowest(tool.bare, end);
      if (r.verdicts[1].state == MoveState::not_certified) held_back += reach > 3 * allowed ? 1 : 0;
      if (r.verdicts[1].state != MoveState::clean) continue;
      ++clean;
      EXPECT_LE(reach, kReachPerDepth * allowed * (1 + 1e-9))
          << tool.bare.name << " " << seed << " tilt " << tilt << " tolerance " << options.tolerance_mm;
    }
  }
  EXPECT_GT(clean, 30U);
  EXPECT_GT(held_back, 2U);
}

}  // namespace
}  // namespace gouge::reach_test
