#include "lib/tool/evaluate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

// Tools written down by hand: lib/tool knows nothing of how tools are made.

namespace gouge::evaluate_test {
namespace {

BoundaryElement segment(const Vec2& a, const Vec2& b, Body body = Body::cutter) {
  BoundaryElement e;
  e.body = body;
  e.a = a;
  e.b = b;
  const Vec2 along = (b - a).normalized();
  e.normal = Vec2(along.y(), -along.x());
  return e;
}

BoundaryElement vertex(const Vec2& at, const Vec2& normal, bool is_reflex) {
  BoundaryElement e;
  e.kind = ElementKind::vertex;
  e.a = e.b = at;
  e.normal = normal.normalized();
  e.is_reflex = is_reflex;
  return e;
}

// Radius 5 up to z = 10, radius 8 up to z = 20.
CompiledTool stepped() {
  CompiledTool tool;
  tool.elements = {segment({0, 0}, {5, 0}),
                   vertex({5, 0}, {1, -1}, false),
                   segment({5, 0}, {5, 10}),
                   vertex({5, 10}, {1, -1}, true),
                   segment({5, 10}, {8, 10}, Body::holder),
                   vertex({8, 10}, {1, -1}, false),
                   segment({8, 10}, {8, 20}, Body::holder),
                   vertex({8, 20}, {1, 1}, false),
                   segment({8, 20}, {0, 20}, Body::holder)};
  tool.z_max_mm = 20;
  tool.r_max_mm = 8;
  return tool;
}

CompiledTool half_sphere() {
  CompiledTool tool;
  BoundaryElement arc;
  arc.kind = ElementKind::arc;
  arc.a = Vec2(0, 0);
  arc.b = Vec2(5, 5);
  arc.center = Vec2(0, 5);
  arc.radius_mm = 5;
  arc.normal = Vec2(1, -1).normalized();
  tool.elements = {arc};
  tool.z_max_mm = 5;
  tool.r_max_mm = 5;
  return tool;
}

TEST(Evaluate, BodiesHaveNames) {
  EXPECT_STREQ(body_name(Body::cutter), "cutter");
  EXPECT_STREQ(body_name(Body::shank), "shank");
  EXPECT_STREQ(body_name(Body::holder), "holder");
}

TEST(Evaluate, InsideIsNegativeAndTheNormalLeadsOut) {
  const ToolDistance a = evaluate_brute_force(stepped(), 4, 5);
  EXPECT_EQ(a.signed_distance_mm, -1);
  EXPECT_EQ(a.element, 2u);
  EXPECT_EQ(a.foot, Vec2(5, 5));
  EXPECT_EQ(a.normal, Vec2(1, 0));
}

TEST(Evaluate, OutsideOfAConvexCornerTheCornerIsNearest) {
  const ToolDistance a = evaluate_brute_force(stepped(), 8, -4);
  EXPECT_EQ(a.signed_distance_mm, 5);
  EXPECT_EQ(a.element, 1u);
  EXPECT_TRUE(a.normal.isApprox(Vec2(0.6, -0.8)));
}

TEST(Evaluate, InsideOfAReflexCornerTheCornerIsNearest) {
  const ToolDistance a = evaluate_brute_force(stepped(), 4.4, 10.8);
  EXPECT_NEAR(a.signed_distance_mm, -1, 1e-15);
  EXPECT_EQ(a.element, 3u);
  EXPECT_TRUE(a.normal.isApprox(Vec2(0.6, -0.8)));
}

TEST(Evaluate, InTheNotchTheNearerWallAnswers) {
  EXPECT_EQ(evaluate_brute_force(stepped(), 5.5, 9).element, 2u);
  EXPECT_EQ(evaluate_brute_force(stepped(), 6, 9.5).element, 4u);
  EXPECT_EQ(evaluate_brute_force(stepped(), 6, 9.5).signed_distance_mm, 0.5);
}

TEST(Evaluate, OnAVertexTheNormalIsTheMeanDirection) {
  const ToolDistance a = evaluate_element(stepped(), 1, 5, 0);
  EXPECT_EQ(a.signed_distance_mm, 0);
  EXPECT_TRUE(a.normal.isApprox(Vec2(1, -1).normalized()));
}

TEST(Evaluate, AtTheCentreOfAnArcTheResultIsStillAUnitVector) {
  const ToolDistance a = evaluate(half_sphere(), 0, 5);
  EXPECT_EQ(a.signed_distance_mm, -5);
  EXPECT_NEAR(a.normal.norm(), 1, 1e-15);
  EXPECT_NEAR((a.foot - Vec2(0, 5)).norm(), 5, 1e-15);
}

TEST(Evaluate, AConcaveArcHasTheSolidOutsideItsCircle) {
  CompiledTool tool = half_sphere();
  tool.elements[0].is_reflex = true;
  std::swap(tool.elements[0].a, tool.elements[0].b);  // the contour has the solid on its left
  EXPECT_EQ(evaluate_element(tool, 0, 3, 1).signed_distance_mm, 0);
  EXPECT_GT(evaluate_element(tool, 0, 0.3, 4.6).signed_distance_mm, 0);
  EXPECT_LT(evaluate_element(tool, 0, 6, -3).signed_distance_mm, 0);
  EXPECT_TRUE(evaluate_element(tool, 0, 6, -3).normal.isApprox(Vec2(-0.6, 0.8)));
}

TEST(Evaluate, TheTreeLeadsToTheLeafTheSignsName) {
  CompiledTool tool = stepped();
  BspNode root;
  root.origin = Vec2(5, 10);
  root.vy = 1;
  root.linear = 1;
  root.negative = ~2;
  root.positive = ~6;
  tool.nodes = {root};
  EXPECT_EQ(evaluate(tool, 4, 9.999).element, 2u);
  EXPECT_EQ(evaluate(tool, 4, 10).element, 6u);
}

TEST(Evaluate, CurvesAreMeasuredFromTheirOrigin) {
  CompiledTool tool = stepped();
  BspNode root;
  root.origin = Vec2(1, 2);
  root.v0 = 5;  // the circle of radius 5 about the origin of the node
  root.square = -1;
  root.round = 1;
  root.negative = ~0;
  root.positive = ~4;
  tool.nodes = {root};
  EXPECT_EQ(evaluate(tool, 4, 5.9).element, 0u);
  EXPECT_EQ(evaluate(tool, 4, 6.1).element, 4u);
}

TEST(Evaluate, AFootOnAnArcIsAPointOfTheArcEvenBesideItsCentre) {
  const CompiledTool tool = half_sphere();
  for (const double step : {1e-15, 1e-12, 1e-9}) {
    const ToolDistance above = evaluate(tool, 0.5 * step, 5 + step);  // the arc ends at z = 5
    EXPECT_NEAR(above.signed_distance_mm, -5, 2 * step);
    EXPECT_EQ(above.foot, Vec2(5, 5));
    EXPECT_EQ(above.normal, Vec2(1, 0));
  }
}

}  // namespace
}  // namespace gouge::evaluate_test
