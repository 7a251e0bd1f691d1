#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "lib/tool/evaluate.h"
#include "tests/support/random_tools.h"
#include "tests/support/tool_points.h"
#include "tests/support/verify_tool.h"
#include "toolmodels/compile_tool.h"

// The contract of evaluate.h on random tools of all kinds. GOUGE_PROXIMITY_POINTS=100000000 makes the long
// run.

namespace gouge::proximity_test {
namespace {

using test::Scatter;

constexpr std::uint64_t kTools = 240;

std::size_t points_per_tool() {
  const char* wanted = std::getenv("GOUGE_PROXIMITY_POINTS");
  const std::size_t total = wanted != nullptr ? std::strtoull(wanted, nullptr, 10) : 1'200'000;
  return std::max<std::size_t>(1, total / kTools);
}

struct Worst {
  double error = 0;  // relative to size and distance from the origin
  Vec2 at = Vec2::Zero();
  void see(double absolute, double scale, const Vec2& q) {
    if (absolute / scale <= error) return;
    error = absolute / scale;
    at = q;
  }
};

struct Disagreement {
  Worst distance;  // between the tree and the minimum over all elements
  Worst leaf;      // how much farther the leaf's element is than the nearest one
  Worst foot;      // how far the foot is off its element, and off the point's way out
  Worst normal;    // off unit length

  void see(const CompiledTool& tool, const Vec2& q) {
    const ToolDistance fast = evaluate(tool, q.x(), q.y());
    const ToolDistance slow = evaluate_brute_force(tool, q.x(), q.y());
    const double scale = test::extent_mm(tool) + q.norm();
    const BoundaryElement& named = tool.elements[fast.element];
    distance.see(std::abs(fast.signed_distance_mm - slow.signed_distance_mm), scale, q);
    leaf.see(distance_to(named, q) - std::abs(slow.signed_distance_mm), scale, q);
    foot.see(distance_to(named, fast.foot), scale, q);
    foot.see((q - fast.signed_distance_mm * fast.normal - fast.foot).norm(), scale, q);
    normal.see(std::abs(fast.normal.norm() - 1), 1, q);
  }
};

void expect_small(const Worst& worst, const char* what, const std::string& tool) {
  EXPECT_LE(worst.error, 1e-12) << what << ", " << tool << " at " << worst.at.transpose();
}

// Where the leaf is another element than the reference names, the two tie, and the way out leads to the foot
// on one of them: that is what the four figures state together.
TEST(Proximity, DistanceLeafAndWayOutAreThoseOfTheNearestElement) {
  const std::size_t points = points_per_tool();
  Worst all;
  for (std::uint64_t seed = 0; seed < kTools; ++seed) {
    const test::RandomTool made = test::random_tool(seed);
    const CompiledTool tool = compile_tool(made.name, made.profile);
    Scatter random(seed);
    Disagreement worst;
    for (std::size_t i = 0; i < points; ++i) worst.see(tool, test::random_tool_point(random, tool));
    expect_small(worst.distance, "distance", made.name);
    expect_small(worst.leaf, "leaf", made.name);
    expect_small(worst.foot, "foot", made.name);
    expect_small(worst.normal, "normal", made.name);
    all.see(worst.distance.error, 1, worst.distance.at);
  }
  RecordProperty("points", std::to_string(points * kTools));
  RecordProperty("worst_relative_error", std::to_string(all.error * 1e15) + "e-15");
}

TEST(Proximity, EveryRandomToolIsSound) {
  for (std::uint64_t seed = 0; seed < kTools; ++seed) {
    const test::RandomTool made = test::random_tool(seed);
    EXPECT_EQ(verify_profile(made.profile), std::vector<std::string>{}) << made.name;
    EXPECT_EQ(test::verify_tool(compile_tool(made.name, made.profile)), std::vector<std::string>{}) << made.name;
  }
}

// Steps of every length, and both sides of bisectors a few units of the last place apart.
TEST(Proximity, DistanceIsOneLipschitzAndContinuousAcrossBisectors) {
  for (std::uint64_t seed = 0; seed < kTools; ++seed) {
    const test::RandomTool made = test::random_tool(seed);
    const CompiledTool tool = compile_tool(made.name, made.profile);
    Scatter random(seed + 5000);
    const double size = test::extent_mm(tool);
    for (int i = 0; i < 3000; ++i) {
      const Vec2 p = test::random_tool_point(random, tool);
      const double step = size * std::pow(10.0, random.in(-15, 0));
      const Vec2 q = test::in_half_plane(p + step * Vec2{random.in(-1, 1), random.in(-1, 1)});
      const double change =
          std::abs(evaluate(tool, p.x(), p.y()).signed_distance_mm - evaluate(tool, q.x(), q.y()).signed_distance_mm);
      ASSERT_LE(change, (p - q).norm() + 1e-12 * (size + p.norm())) << made.name << " at " << p.transpose();
    }
  }
}

// ---- the reference itself, against boundaries given as points

struct SampledBoundary {
  std::vector<Vec2> points;  // a closed polygon but for the axis
  double error_mm = 0;       // no boundary point is farther from the polygon's points than this

  explicit SampledBoundary(const Profile& profile) {
    for (const ProfileElement& e : profile.elements) {
      const double length = e.is_arc ? e.radius_mm * sweep_rad(e) : (e.b - e.a).norm();
      constexpr int kSteps = 200;
      const std::vector<Vec2> arc = e.is_arc ? sample(e, kSteps) : std::vector<Vec2>{};
      for (int i = 0; i <= kSteps; ++i)
        points.emplace_back(e.is_arc ? arc[static_cast<std::size_t>(i)] : Vec2(e.a + i / double{kSteps} * (e.b - e.a)));
      error_mm = std::max(error_mm, 0.5 * length / kSteps);
    }
  }

  double nearest(const Vec2& q) const {
    double squared = (points.front() - q).squaredNorm();
    for (const Vec2& p : points) squared = std::min(squared, (p - q).squaredNorm());
    return std::sqrt(squared);
  }

  // By the angle the polygon turns around q, mirrored at the axis to close it: no crossing is counted.
  bool is_around(const Vec2& q) const {
    double turned = 0;
    const auto add = [&](Vec2 u, Vec2 v) {
      u -= q;
      v -= q;
      turned += std::atan2(u.x() * v.y() - u.y() * v.x(), u.dot(v));
    };
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      add(points[i], points[i + 1]);
      add({-points[i + 1].x(), points[i + 1].y()}, {-points[i].x(), points[i].y()});
    }
    return turned > std::numbers::pi;
  }
};

TEST(Proximity, TheReferenceAgreesWithSampledBoundaries) {
  for (std::uint64_t seed = 0; seed < kTools; ++seed) {
    const test::RandomTool made = test::random_tool(seed);
    const CompiledTool tool = compile_tool(made.name, made.profile);
    const SampledBoundary boundary(made.profile);
    Scatter random(seed + 9000);
    for (int i = 0; i < 60; ++i) {
      const Vec2 q = test::random_tool_point(random, tool);
      const double found = evaluate_brute_force(tool, q.x(), q.y()).signed_distance_mm;
      const double sampled = boundary.nearest(q);
      const double rounding = 1e-12 * (test::extent_mm(tool) + q.norm());
      ASSERT_LE(std::abs(found), sampled + rounding) << made.name << " at " << q.transpose();
      ASSERT_GE(std::abs(found), sampled - boundary.error_mm - rounding) << made.name << " at " << q.transpose();
      if (sampled > 2 * boundary.error_mm) {
        ASSERT_EQ(found < 0, boundary.is_around(q)) << made.name << " at " << q.transpose();
      }
    }
  }
}

// Off the middle of a step a thousandth of a millimetre wide, a hundred sizes away: the step's own line and
// its neighbours' tie within rounding there, and none of them knows the side.
TEST(Proximity, TheReferenceKnowsTheSideFarBesideTinySteps) {
  Profile profile;
  const Vec2 corners[] = {{0, 0},         {5, 0},  {5, 10}, {5.000001, 10}, {5.000001, 10.000001},
                          {5, 10.000001}, {5, 30}, {0, 30}};
  for (int i = 0; i < 7; ++i) profile.elements.push_back(make_segment(Body::cutter, corners[i], corners[i + 1]));
  const CompiledTool tool = compile_tool("ridge", profile);
  Scatter random(3);
  for (int i = 0; i < 20'000; ++i) {
    const Vec2 far{random.in(5.1, 3000), 10.0000005 + random.in(-2e-6, 2e-6)};
    ASSERT_GT(evaluate_brute_force(tool, far.x(), far.y()).signed_distance_mm, 0) << far.transpose();
    ASSERT_GT(evaluate(tool, far.x(), far.y()).signed_distance_mm, 0) << far.transpose();
    const Vec2 inside(random.in(0, 4.9), far.y());
    ASSERT_LT(evaluate_brute_force(tool, inside.x(), inside.y()).signed_distance_mm, 0) << inside.transpose();
  }
}

}  // namespace
}  // namespace gouge::proximity_test
