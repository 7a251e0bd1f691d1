#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "lib/tool/evaluate.h"
#include "tests/support/random_tools.h"
#include "tests/toolmodels/sample_tools.h"
#include "toolmodels/compile_tool.h"
#include "toolmodels/elements.h"

// The contract of SupportRange (lib/tool/compiled_tool.h), by brute force: the soundness of the check rests
// on it.

namespace gouge::support_test {
namespace {

using test::Scatter;

struct TangentPlane {
  Vec3 foot, normal;
  double out = 0;  // how far the normal points away from the axis
};

Vec3 lifted(const Vec2& v, double angle) { return {v.x() * std::cos(angle), v.x() * std::sin(angle), v.y()}; }

Vec2 end_normal(const BoundaryElement& e, const Vec2& at) {
  if (e.kind == ElementKind::segment) return e.normal;
  return (e.is_reflex ? -1 : 1) * (at - e.center).normalized();
}

// A random tangent plane of element i; ends of arcs and cones are drawn often, because claims break there
// first.
TangentPlane random_plane(Scatter& random, const CompiledTool& tool, std::size_t i) {
  const BoundaryElement& e = tool.elements[i];
  const double draw = random.in(-0.3, 1.3);
  const double t = std::min(1.0, std::max(0.0, draw));
  const double angle = random.in(0, 2 * std::numbers::pi);
  Vec2 foot = e.a + t * (e.b - e.a);
  Vec2 normal = e.normal;
  if (e.kind == ElementKind::arc) {
    normal = ((1 - t) * (e.a - e.center) + t * (e.b - e.center)).normalized();
    foot = e.center + e.radius_mm * normal;
  }
  if (e.kind == ElementKind::vertex) {
    const Vec2 before = i > 0 ? end_normal(tool.elements[i - 1], e.a) : Vec2(0, -1);
    const Vec2 after = i + 1 < tool.elements.size() ? end_normal(tool.elements[i + 1], e.a) : Vec2(0, 1);
    const Vec2 mix = (1 - t) * before + t * after;
    normal = mix.norm() > 1e-6 ? Vec2(mix.normalized()) : e.normal;
  }
  return {lifted(foot, angle), lifted(normal, angle), normal.x()};
}

using Hull = std::array<Vec3, 6>;

Hull random_hull(Scatter& random, const TangentPlane& plane, double size) {
  const double spread = size * std::pow(10.0, random.in(-4, 0.3));
  Hull hull;
  for (Vec3& corner : hull) corner = plane.foot + spread * Vec3(random.in(-1, 1), random.in(-1, 1), random.in(-1, 1));
  return hull;
}

double radius(const Vec3& q) { return std::sqrt(q.x() * q.x() + q.y() * q.y()); }

bool is_claimed(const Hull& hull, const TangentPlane& plane, const SupportRange& range) {
  if (plane.out < -1e-12) return false;
  for (const Vec3& q : hull) {
    const double behind = plane.normal.dot(plane.foot - q);
    const double projected = (q + behind * plane.normal).z();
    if (q.z() < range.z_lo_mm || q.z() > range.z_hi_mm) return false;
    if (behind > 0 && (projected < range.z_lo_mm || projected > range.z_hi_mm)) return false;
  }
  return true;
}

Vec3 random_point(Scatter& random, const Hull& hull) {
  Vec3 sum = Vec3::Zero();
  double total = 0;
  for (const Vec3& corner : hull) {
    const double weight = std::pow(random.in(0, 1), 4);
    sum += weight * corner;
    total += weight;
  }
  return sum / total;
}

// How far the deepest of 30 points of the hull lies deeper than its plane allows; nothing when nothing is
// claimed.
double violation(Scatter& random, const CompiledTool& tool, const Hull& hull, const TangentPlane& plane, double r_min) {
  double worst = 0;
  for (int k = 0; k < 30; ++k) {
    const Vec3 q = random_point(random, hull);
    if (radius(q) < r_min) continue;
    const double depth = -evaluate_brute_force(tool, radius(q), q.z()).signed_distance_mm;
    worst = std::max(worst, depth - std::max(0.0, plane.normal.dot(plane.foot - q)));
  }
  return worst;
}

// The number of claims tried on the tool; fails at the first one that is broken.
std::size_t try_claims(Scatter& random, const CompiledTool& tool, int hulls) {
  std::size_t claims = 0;
  for (int k = 0; k < hulls; ++k) {
    const std::size_t i = random.next() % tool.elements.size();
    const TangentPlane plane = random_plane(random, tool, i);
    const SupportRange& range = tool.elements[i].support;
    const Hull hull = random_hull(random, plane, tool.z_max_mm - tool.z_min_mm);
    if (!is_claimed(hull, plane, range)) continue;
    ++claims;
    const double slack = 1e-9 * std::max(1.0, tool.z_max_mm - tool.z_min_mm);
    EXPECT_LE(violation(random, tool, hull, plane, range.r_min_mm), slack)
        << tool.name << " element " << i << " foot " << plane.foot.transpose() << " normal "
        << plane.normal.transpose();
    if (testing::Test::HasFailure()) break;
  }
  return claims;
}

TEST(SupportRange, TangentPlanesBoundTheDepthOfWholeHulls) {
  Scatter random(7);
  for (const ToolAssembly& assembly : test::sample_tools()) {
    const Result<ToolVariants> variants = make_tool_variants(assembly, 0.2, 0.5, 1.5);
    ASSERT_TRUE(variants.has_value());
    for (const CompiledTool* tool : {&variants->bare, &variants->against_part, &variants->non_cutting}) {
      if (tool->elements.empty()) continue;
      const std::size_t claims = try_claims(random, *tool, 6000);
      EXPECT_GT(claims, 300u) << tool->name << ": hardly anything is claimed, so nothing is tested";
    }
  }
}

// A tool with one radius at each height always has a bound.
TEST(SupportRange, HoldsForRandomToolsOfAllKinds) {
  const char* wanted = std::getenv("GOUGE_SUPPORT_HULLS");
  const int hulls = wanted != nullptr ? std::atoi(wanted) : 400;
  for (std::uint64_t seed = 0; seed < 240 && !HasFailure(); ++seed) {
    const test::RandomTool made = test::random_tool(seed);
    Scatter random(seed + 77);
    const std::size_t claims = try_claims(random, compile_tool(made.name, made.profile), hulls);
    EXPECT_TRUE(claims > 0 || !is_single_valued(made.profile)) << made.name;
  }
}

// Claims of a hollow tool are those of the tool with its underside filled; they hold for the hollow one.
TEST(SupportRange, HollowToolsClaimWhatHoldsForThemFilled) {
  Scatter random(8);
  const std::vector<ToolAssembly> hollow{
      test::assembly("face mill", FaceMillCutter{40, 1, 45, 50, 24, 5, 25}, {{20, 20, 30}}, {{50, 50, 30}}),
      test::assembly("cup", FaceMillCutter{40, 0, 0, 0, 30, 12, 25}, {{45, 45, 10}, {12, 12, 30}}, {{50, 30, 30}}),
      test::assembly("dish", AptCutter{24, 2, 0, 0, -15, 5, 15}, {{10, 10, 30}}, {{32, 32, 20}}),
      test::assembly("edge", AptCutter{24, 0, 0, 0, -25, -5, 15}, {{30, 20, 30}})};
  for (const ToolAssembly& assembly : hollow) {
    const Result<ToolVariants> variants = make_tool_variants(assembly, 0.2, 0.5, 1.5);
    ASSERT_TRUE(variants.has_value());
    for (const CompiledTool* tool : {&variants->bare, &variants->against_part}) {
      const std::size_t claims = try_claims(random, *tool, 30000);
      EXPECT_GT(claims, 300u) << tool->name << ": hardly anything is claimed, so nothing is tested";
    }
  }
}

TEST(SupportRange, ConvexToolClaimsEverything) {
  const Result<ToolVariants> variants = make_tool_variants(test::assembly("", BullNoseCutter{16, 2, 25}), 0, 0, 0);
  for (const BoundaryElement& e : variants->bare.elements) {
    EXPECT_LE(e.support.z_lo_mm, -1e299);
    EXPECT_GE(e.support.z_hi_mm, 1e299);
    EXPECT_EQ(e.support.r_min_mm, 0);
  }
}

TEST(SupportRange, HolderFaceClaimsOnlyOutsideTheShank) {
  const ToolAssembly tool = test::assembly("", FlatCutter{10, 30}, {{10, 10, 20}}, {{32, 32, 40}});
  const Result<ToolVariants> variants = make_tool_variants(tool, 0, 0, 0);
  bool is_seen = false;
  for (const BoundaryElement& e : variants->bare.elements) {
    const bool is_face = e.kind == ElementKind::segment && e.body == Body::holder && e.normal.y() < -0.5;
    if (!is_face) continue;
    is_seen = true;
    EXPECT_EQ(e.support.r_min_mm, 5);
    EXPECT_LE(e.support.z_lo_mm, -1e299) << "nothing below the face is wider than the shank";
  }
  EXPECT_TRUE(is_seen);
}

TEST(SupportRange, ReflexCornersAndUndercutsClaimNothing) {
  const ToolAssembly stepped = test::assembly("", FlatCutter{10, 30}, {{6, 6, 20}}, {{32, 32, 40}});
  const Result<ToolVariants> variants = make_tool_variants(stepped, 0, 0, 0);
  for (const BoundaryElement& e : variants->bare.elements)
    if (e.is_reflex) {
      EXPECT_GT(e.support.z_lo_mm, e.support.z_hi_mm);
    }
  // A hollow bottom: within the hollow nothing is claimed.
  Profile hollow;
  const Vec2 points[] = {{0, 3}, {4, 0}, {5, 0}, {5, 20}, {0, 20}};
  for (int i = 0; i < 4; ++i) hollow.elements.push_back(make_segment(Body::cutter, points[i], points[i + 1]));
  for (const BoundaryElement& e : compile_tool("hollow", hollow).elements) {
    const bool is_of_hollow = e.a.x() < 4 && e.a.y() < 10 && e.b.x() <= 4;
    EXPECT_EQ(e.support.z_lo_mm > e.support.z_hi_mm, is_of_hollow) << e.a.transpose();
  }
  // An undercut seen along the axis above the underside: its inner wall, whose normals point to the axis, claims nothing.
  Profile undercut;
  const Vec2 around[] = {{0, 0}, {5, 0}, {5, 10}, {8, 10}, {8, 8}, {10, 8}, {10, 20}, {0, 20}};
  for (int i = 0; i < 7; ++i) undercut.elements.push_back(make_segment(Body::cutter, around[i], around[i + 1]));
  for (const BoundaryElement& e : compile_tool("undercut", undercut).elements) {
    if (e.kind == ElementKind::segment && e.normal.x() < -0.5) {
      EXPECT_GT(e.support.z_lo_mm, e.support.z_hi_mm) << e.a.transpose();
    }
  }
  bool claims_wall = false;
  for (const BoundaryElement& e : compile_tool("undercut", undercut).elements)
    claims_wall = claims_wall || (e.a.x() >= 10 && e.b.x() >= 10 && e.support.z_lo_mm <= 8 && e.support.z_hi_mm >= 20);
  EXPECT_TRUE(claims_wall);
}

// A neck or a lip that turns back in height, as many tools of points have: its outside is bounded by planes like any
// other's.
TEST(SupportRange, ContoursThatTurnBackInHeightClaimWhatHolds) {
  Scatter random(9);
  const std::vector<std::vector<Vec2>> contours{
      {{0, 0}, {5, 0}, {5, 10}, {8, 10}, {8, 8}, {10, 8}, {10, 20}, {0, 20}},
      {{0, 2}, {3, 0}, {6, 1}, {6, 6}, {2, 9}, {4, 7}, {7, 12}, {3, 12}, {3, 16}, {9, 14}, {9, 30}, {0, 30}},
      {{0, 0}, {4, 0}, {9, 5}, {7, 9}, {8, 6}, {5, 4.5}, {3, 12}, {12, 12}, {12, 25}, {0, 25}}};
  for (std::size_t c = 0; c < contours.size(); ++c) {
    Profile profile;
    for (std::size_t i = 0; i + 1 < contours[c].size(); ++i)
      profile.elements.push_back(make_segment(Body::cutter, contours[c][i], contours[c][i + 1]));
    if (!verify_profile(profile).empty()) continue;
    const std::size_t claims = try_claims(random, compile_tool("contour " + std::to_string(c), profile), 40000);
    EXPECT_GT(claims, 300U) << c;
  }
}

}  // namespace
}  // namespace gouge::support_test
