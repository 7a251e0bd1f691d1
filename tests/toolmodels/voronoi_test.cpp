#include "toolmodels/voronoi.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "lib/tool/evaluate.h"
#include "tests/support/random_tools.h"
#include "tests/toolmodels/sample_tools.h"
#include "toolmodels/compile_tool.h"

namespace gouge::detail::voronoi_test {
namespace {

using test::Scatter;

double distance(const DistanceForm& f, const Vec2& q) {
  return f.is_linear ? f.direction.dot(q - f.through) : f.sign * (q - f.center).norm() + f.shift;
}

double value(const BspNode& node, const Vec2& q) {
  const Vec2 x = q - node.origin;
  const double v = node.v0 + node.vx * x.x() + node.vy * x.y();
  return node.linear * v + node.square * v * v + node.round * x.squaredNorm();
}

Vec2 gradient(const BspNode& node, const Vec2& q) {
  const Vec2 x = q - node.origin;
  const double v = node.v0 + node.vx * x.x() + node.vy * x.y();
  return (node.linear + 2 * node.square * v) * Vec2(node.vx, node.vy) + 2 * node.round * x;
}

Vec2 random_vector(Scatter& random, double reach) { return {random.in(-reach, reach), random.in(-reach, reach)}; }

DistanceForm random_form(Scatter& random) {
  DistanceForm form;
  form.is_linear = random.next() % 3 == 0;
  form.through = random_vector(random, 10);
  form.direction = random_vector(random, 1).normalized();
  form.center = random_vector(random, 10);
  form.sign = random.next() % 2 == 0 ? 1 : -1;
  form.shift = random.next() % 4 == 0 ? 0 : random.in(-8, 8);
  return form;
}

ConvexCell random_cell(Scatter& random) {
  ConvexCell cell(20);
  for (std::uint64_t k = random.next() % 6; k > 0; --k) {
    const DirectedLine line{Vec2(random.in(0, 15), random.in(-10, 10)), random_vector(random, 1).normalized()};
    const ConvexCell part = cell.clipped(line, random.next() % 2 == 0 ? 1 : -1);
    if (part.corners().size() >= 3) cell = part;
  }
  return cell;
}

// A point of the cell: a positive combination of its corners.
Vec2 point_in(Scatter& random, const ConvexCell& cell) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& corner : cell.corners()) {
    const double weight = std::pow(random.in(0.01, 1), 6);
    sum += (corner.z() > 0 ? weight : 30 * weight * weight) * corner;
  }
  return sum.head<2>() / sum.z();
}

void expect_right_order(Scatter& random, const DistanceForm& f, const DistanceForm& g, const ConvexCell& cell,
                        int depth) {
  if (cell.corners().size() < 3) return;
  const Comparison c = compare(f, g, cell);
  if (c.kind == Comparison::Kind::split_first) {
    ASSERT_LT(depth, 3) << "cutting does not end";
    expect_right_order(random, f, g, cell.clipped(c.line, 1), depth + 1);
    expect_right_order(random, f, g, cell.clipped(c.line, -1), depth + 1);
    return;
  }
  for (int k = 0; k < 20; ++k) {
    const Vec2 q = point_in(random, cell);
    const double difference = distance(f, q) - distance(g, q);
    if (std::abs(difference) < 1e-9 * (1 + q.norm())) continue;
    const bool is_first =
        c.kind == Comparison::Kind::first_nearer || (c.kind == Comparison::Kind::curve && value(c.curve, q) < 0);
    ASSERT_EQ(is_first, difference < 0) << "at " << q.transpose() << " difference " << difference;
  }
}

TEST(Voronoi, TheCurveOfTwoDistancesHasNoFalseBranchInItsCell) {
  Scatter random(21);
  for (int k = 0; k < 40000; ++k) {
    const DistanceForm f = random_form(random), g = random_form(random);
    expect_right_order(random, f, g, random_cell(random), 0);
    if (HasFatalFailure()) return;
  }
}

TEST(Voronoi, EverywhereBelowIsNeverClaimedWrongly) {
  Scatter random(22);
  int claims = 0;
  for (int k = 0; k < 100000; ++k) {
    const DistanceForm f = random_form(random), g = random_form(random);
    const ConvexCell cell = random_cell(random);
    if (!is_everywhere_below(f, g, cell)) continue;
    ++claims;
    for (int i = 0; i < 20; ++i) {
      const Vec2 q = point_in(random, cell);
      ASSERT_LE(distance(f, q), distance(g, q) + 1e-9 * (1 + q.norm())) << q.transpose();
    }
  }
  EXPECT_GT(claims, 1000);
}

// Appendix C of the thesis. B is the reflex corner where the side BC begins, CD another side of the tool. O
// is equidistant from B, BC and CD; there the bisector of BC and CD must touch the parabola of B and CD, or
// the regions would overlap. Derivation: docs/method/tool_voronoi.md
TEST(Voronoi, TheParabolaTouchesTheBisectorAtTheReflexCornersNormal) {
  Scatter random(23);
  for (int k = 0; k < 2000; ++k) {
    const Vec2 b = random_vector(random, 10);
    const Vec2 side_normal = random_vector(random, 1).normalized();
    DistanceForm side;  // distances inside: positive away from the boundary
    side.through = b;
    side.direction = -side_normal;
    DistanceForm other;
    other.direction = random_vector(random, 1).normalized();
    other.through = b - random.in(1, 20) * other.direction;
    DistanceForm corner;
    corner.is_linear = false;
    corner.center = b;
    // O = B + s * inward normal with s = distance of O to CD.
    const double closing = 1 - side.direction.dot(other.direction);
    if (closing < 0.05) continue;
    const double s = distance(other, b) / closing;
    const Vec2 o = b + s * side.direction;
    ASSERT_NEAR(distance(side, o), distance(other, o), 1e-9 * (1 + s));
    // A small cell about O: the statement is a local one.
    ConvexCell cell(20);
    const Vec2 shift(1000, 0);  // keeps the cell in r >= 0
    for (DistanceForm* form : {&side, &other, &corner}) {
      form->through += shift;
      form->center += shift;
    }
    const Vec2 at = o + shift;
    for (const Vec2& u : {Vec2(1, 0), Vec2(-1, 0), Vec2(0, 1), Vec2(0, -1)})
      cell = cell.clipped({at + 0.01 * u, u}, -1);
    const Comparison line = compare(side, other, cell);
    const Comparison parabola = compare(corner, other, cell);
    ASSERT_TRUE(line.is_straight);
    ASSERT_EQ(parabola.kind, Comparison::Kind::curve);
    ASSERT_NEAR(value(parabola.curve, at), 0, 1e-7 * (1 + s * s));
    const Vec2 u = gradient(line.curve, at).normalized();
    const Vec2 v = gradient(parabola.curve, at).normalized();
    ASSERT_NEAR(u.x() * v.y() - u.y() * v.x(), 0, 1e-9 * (1 + s)) << "not tangent";
    ASSERT_GT(u.dot(v), 0) << "the sides are exchanged";
  }
}

// The same on whole tools, found from the outside: O lies s above the bottom on the inward normal of the side
// BC at B. There the border of the bottom's region goes from the line (BC and bottom) to the parabola (B and
// bottom); at a distance h it has left the tangent by nothing on one side and by the order of h^2 on the
// other.
void expect_tangency(double upper_diameter) {
  const ToolAssembly tool = test::assembly("step", FlatCutter{24, 4}, {{12, upper_diameter, 40}});
  const CompiledTool compiled = make_tool_variants(tool, 0, 0, 0)->bare;
  const Vec2 corner(6, 4);
  const Vec2 side = (Vec2(upper_diameter / 2, 44) - corner).normalized();
  const Vec2 inward(-side.y(), side.x());
  const double s = corner.y() / (1 - inward.y());
  const Vec2 o = corner + s * inward;
  ASSERT_GT(o.x(), 0.1);
  EXPECT_NEAR(evaluate(compiled, o.x(), o.y()).signed_distance_mm, -s, 1e-12);
  const Vec2 tangent = (inward + Vec2(0, -1)).normalized();  // both regions' distances change alike along it
  const Vec2 along(-tangent.y(), tangent.x());
  const auto border = [&](const Vec2& at) {  // how far off the tangent the bottom's region ends
    double low = -0.1, high = 0.1;
    for (int i = 0; i < 60; ++i) {
      const Vec2 q = at + 0.5 * (low + high) * tangent;
      (evaluate(compiled, q.x(), q.y()).element == 0 ? high : low) = 0.5 * (low + high);
    }
    return 0.5 * (low + high);
  };
  const double h = 1e-3;
  const double toward_side = along.dot(side) > 0 ? 1 : -1;
  EXPECT_NEAR(border(o + toward_side * h * along), 0, 1e-11) << "the bisector is a line through O";
  const double left = std::abs(border(o - toward_side * h * along));
  EXPECT_LT(left, 0.5 * h * h) << "not tangent";
  EXPECT_GT(left, 1e-3 * h * h) << "no parabola";
}

TEST(Voronoi, TheParabolaIsTangentAtADiameterStep) { expect_tangency(12); }

TEST(Voronoi, TheParabolaIsTangentAtTheCornerOfATaper) {
  expect_tangency(18);
  expect_tangency(9);
}

std::string kind_of(const BspNode& node) {
  const double slope = std::abs(node.square) * (node.vx * node.vx + node.vy * node.vy);
  if (std::abs(node.linear) > 0) return "line";
  if (!(slope > 0)) return "circle";
  if (std::abs(slope - std::abs(node.round)) < 1e-9) return "parabola";
  return slope < std::abs(node.round) ? "ellipse" : "hyperbola";
}

TEST(Voronoi, RandomToolsHaveBisectorsOfEveryKindBesideConcaveArcsToo) {
  std::map<std::string, int> all, beside_concave;
  for (std::uint64_t seed = 0; seed < 240; ++seed) {
    const CompiledTool tool = compile_tool("", test::random_tool(seed).profile);
    const bool is_concave = std::any_of(tool.elements.begin(), tool.elements.end(),
                                        [](const auto& e) { return e.kind == ElementKind::arc && e.is_reflex; });
    for (const BspNode& node : tool.nodes) ++(is_concave ? beside_concave : all)[kind_of(node)];
  }
  for (const char* kind : {"line", "circle", "parabola", "ellipse", "hyperbola"}) {
    EXPECT_GT(beside_concave[kind], 20) << kind;
    if (kind != std::string("ellipse")) {
      EXPECT_GT(all[kind], 20) << kind;
    }
  }
}

TEST(Voronoi, NeighboursShareTheLineBetweenTheirDomains) {
  for (const ToolAssembly& tool : test::sample_tools()) {
    const Result<ToolVariants> forms = make_tool_variants(tool, 0, 0, 1);
    const std::vector<BoundaryElement>& elements = forms->against_part.elements;
    const Domains domains = make_domains(elements);
    ASSERT_EQ(domains.lines.size(), elements.size() - 1);
    for (std::size_t i = 0; i + 1 < elements.size(); ++i) {
      EXPECT_EQ(domains.bounds[i].back().line, domains.bounds[i + 1].front().line) << tool.name;
      EXPECT_EQ(domains.bounds[i].back().sign, -domains.bounds[i + 1].front().sign) << tool.name;
    }
  }
}

}  // namespace
}  // namespace gouge::detail::voronoi_test
