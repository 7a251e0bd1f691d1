#include "lib/path/curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/scatter.h"

namespace gouge::curve_test {
namespace {

// The value of the B-spline by its definition: the basis functions of Cox and de Boor, one by one.
double basis(const std::vector<double>& knots, std::size_t i, std::size_t degree, double u) {
  if (degree == 0) return knots[i] <= u && u < knots[i + 1] ? 1 : 0;
  double sum = 0;
  if (knots[i + degree] > knots[i])
    sum += (u - knots[i]) / (knots[i + degree] - knots[i]) * basis(knots, i, degree - 1, u);
  if (knots[i + degree + 1] > knots[i + 1])
    sum += (knots[i + degree + 1] - u) / (knots[i + degree + 1] - knots[i + 1]) * basis(knots, i + 1, degree - 1, u);
  return sum;
}

Vec3 by_definition(const std::vector<Vec3>& control, const std::vector<double>& inner, double u) {
  std::vector<double> knots(4, 0.0);
  knots.insert(knots.end(), inner.begin(), inner.end());
  knots.insert(knots.end(), 4, 1.0);
  Vec3 point = Vec3::Zero();
  for (std::size_t i = 0; i < control.size(); ++i) point += basis(knots, i, 3, u) * control[i];
  return point;
}

const SplinePiece& piece_at(const PathSpline& spline, double u) {
  for (const SplinePiece& piece : spline.pieces) {
    if (u <= piece.u1) return piece;
  }
  return spline.pieces.back();
}

std::vector<Vec3> random_control(test::Scatter& random, std::size_t count) {
  std::vector<Vec3> control;
  for (std::size_t i = 0; i < count; ++i) control.push_back(random.point(50));
  return control;
}

TEST(Spline, PiecesAreTheCurveOfItsDefinition) {
  test::Scatter random(4);
  const std::vector<std::vector<double>> knots = {
      {}, {0.5}, {0.1, 0.2, 0.9}, {0.3, 0.3, 0.7}, {0.4, 0.4, 0.4}, {0.0416667, 0.375, 0.625, 0.9583333}};
  for (const std::vector<double>& inner : knots) {
    const std::vector<Vec3> control = random_control(random, inner.size() + 4);
    const PathSpline spline = make_spline(control, inner);
    ASSERT_FALSE(spline.pieces.empty());
    EXPECT_EQ(spline.pieces.front().control.front(), control.front());
    EXPECT_EQ(spline.pieces.back().control.back(), control.back());
    for (double u = 0; u < 1; u += 0.01) {
      const double off = (piece_at(spline, u).at(u) - by_definition(control, inner, u)).norm();
      EXPECT_LE(off, 1e-11) << u << " of " << inner.size();
    }
  }
}

TEST(Spline, BoundsOfItsDerivativesHold) {
  test::Scatter random(5);
  const std::vector<double> inner = {0.2, 0.25, 0.7};
  for (int i = 0; i < 100; ++i) {
    for (const SplinePiece& piece : make_spline(random_control(random, 7), inner).pieces) {
      const double h = (piece.u1 - piece.u0) / 64;
      for (double u = piece.u0 + h; u < piece.u1 - 0.5 * h; u += h) {
        const Vec3 bend = (piece.at(u - h) - 2 * piece.at(u) + piece.at(u + h)) / (h * h);
        EXPECT_LE(bend.norm(), piece.largest_second_derivative() * (1 + 1e-9) + 1e-6);
        EXPECT_LE((piece.at(u + h) - piece.at(u)).norm() / h, piece.largest_speed() * (1 + 1e-12));
      }
    }
  }
}

TEST(Spline, KnotsThatAreNoneMakeNoSpline) {
  const std::vector<Vec3> control(5, Vec3::Zero());
  EXPECT_TRUE(make_spline(control, {}).pieces.empty());
  EXPECT_TRUE(make_spline(control, {1.5}).pieces.empty());
  EXPECT_TRUE(make_spline(control, {0.0}).pieces.empty());
  EXPECT_TRUE(make_spline(control, {std::nan("")}).pieces.empty());
  EXPECT_TRUE(make_spline(std::vector<Vec3>(6, Vec3::Zero()), {0.5, 0.4}).pieces.empty());
  EXPECT_TRUE(make_spline(std::vector<Vec3>(8, Vec3::Zero()), {0.5, 0.5, 0.5, 0.5}).pieces.empty());
}

TEST(Lengths, OfAHelixAndOfAStraightSplineAreThoseOfTheBooks) {
  const PathArc arc{Vec3(1, 2, 3), Vec3::UnitZ(), -4 * std::numbers::pi};
  const double length = arc_length_mm(arc, Vec3(6, 2, 10), Vec3(6, 2, 4));
  EXPECT_NEAR(length, std::sqrt(std::pow(20 * std::numbers::pi, 2) + 36), 1e-12);
  const PathSpline line = make_spline({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(3, 0, 0)}, {});
  EXPECT_NEAR(spline_length_mm(line), 3, 1e-12);
}

}  // namespace
}  // namespace gouge::curve_test
