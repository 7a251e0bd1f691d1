#include "lib/verify/moving_pose.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/paths.h"
#include "tests/support/reference.h"
#include "tests/support/scatter.h"

namespace gouge::moving_pose_test {
namespace {

class Motions : public testing::Test {
 protected:
  Vec3 vector(double size) {
    const double x = random_.in(-size, size), y = random_.in(-size, size), z = random_.in(-size, size);
    return {x, y, z};
  }
  Pose pose() {
    const Vec3 tip = vector(50);
    return {tip, vector(1).normalized()};
  }

  // Straight, along an arc or helix of up to two turns, along a spline of two pieces, or a dogleg.
  Toolpath path(int kind) {
    const Pose start = pose();
    Toolpath path = paths::through({start, pose()});
    Move& move = path.moves[1];
    if (kind == 1) {
      move.curve_kind = CurveKind::arc;
      path.arcs.push_back({vector(40), vector(1).normalized(), random_.in(-12, 12)});
    } else if (kind == 2) {
      move.curve_kind = CurveKind::spline;
      const Vec3 joint = vector(50);
      PathSpline spline;
      spline.pieces.push_back({0, 0.3, {start.tip, vector(50), vector(50), joint}});
      spline.pieces.push_back({0.3, 1, {joint, vector(50), vector(50), move.end.tip}});
      path.splines.push_back(spline);
    } else if (kind == 3) {
      move.kind = MoveKind::rapid;
    }
    return path;
  }

  test::Scatter random_{7};
};

bool holds(const Bounds3& bounds, const Vec3& v, double slack) {
  for (std::size_t k = 0; k < 3; ++k) {
    const double x = v[static_cast<Eigen::Index>(k)];
    if (x < bounds[k].inf() - slack || x > bounds[k].sup() + slack) return false;
  }
  return true;
}

/// Every instant is `off` the chord of its piece by no more than the piece states; ends are where they are stated
/// to be.
void expect_bounded(const Toolpath& path, const MotionPiece& piece, double t0, double t1, int level) {
  for (const auto& [t, pose] : {std::pair(t0, piece.start()), std::pair(t1, piece.end())}) {
    const Pose at = pose_at(path, 1, t, true);
    EXPECT_TRUE(holds(pose.tip, at.tip, 1e-9)) << t;
    EXPECT_TRUE(holds(pose.axis, at.axis, 1e-11)) << t;
  }
  for (double s = 0.1; s < 1; s += 0.2) {
    const Pose at = pose_at(path, 1, t0 + s * (t1 - t0), true);
    const Vec3 tip = (1 - s) * piece.start().tip.middle() + s * piece.end().tip.middle();
    const Vec3 axis = (1 - s) * piece.start().axis.middle() + s * piece.end().axis.middle();
    EXPECT_LE((at.tip - tip).norm(), piece.sag_mm() + 1e-9);
    EXPECT_LE((at.axis - axis).norm(), piece.bend() + 1e-11);
  }
  if (level == 0) return;
  const auto halves = piece.halves();
  expect_bounded(path, halves[0], t0, 0.5 * (t0 + t1), level - 1);
  expect_bounded(path, halves[1], 0.5 * (t0 + t1), t1, level - 1);
}

TEST_F(Motions, PiecesHoldThePoseAtEveryInstant) {
  for (int trial = 0; trial < 400; ++trial) {
    const Toolpath moved = path(trial % 4);
    const RoundsUpward upward;
    const auto pieces = motion_pieces(moved, 1, true);
    ASSERT_TRUE(pieces.has_value()) << trial;
    // Pieces of splines and doglegs are not equally long: their instants are known where the tip is.
    if (trial % 4 >= 2) continue;
    const double count = static_cast<double>(pieces->size());
    for (std::size_t k = 0; k < pieces->size(); ++k)
      expect_bounded(moved, (*pieces)[k], static_cast<double>(k) / count, static_cast<double>(k + 1) / count, 3);
    if (HasFailure()) FAIL() << "trial " << trial;
  }
}

TEST_F(Motions, PiecesOfSplinesAndDoglegsHoldThePoseAtTheirOwnInstants) {
  for (int trial = 0; trial < 200; ++trial) {
    const int kind = 2 + trial % 2;
    const Toolpath moved = path(kind);
    std::vector<double> breaks{0, 0.3, 1};
    if (kind == 3) {
      const Vec3 way = moved.moves[1].end.tip - moved.moves[0].end.tip;
      breaks = {0};
      for (int k = 0; k < 3; ++k) breaks.push_back(std::abs(way[k]) / way.cwiseAbs().maxCoeff());
      std::sort(breaks.begin(), breaks.end());
    }
    const RoundsUpward upward;
    const auto pieces = motion_pieces(moved, 1, true);
    ASSERT_TRUE(pieces.has_value());
    ASSERT_EQ(pieces->size() + 1, breaks.size());
    for (std::size_t k = 0; k < pieces->size(); ++k) expect_bounded(moved, (*pieces)[k], breaks[k], breaks[k + 1], 3);
    if (HasFailure()) FAIL() << "trial " << trial;
  }
}

TEST_F(Motions, PosesAreThoseOfTheReference) {
  for (int trial = 0; trial < 300; ++trial) {
    const Toolpath moved = path(trial % 3);
    const double t = random_.in(0, 1);
    const Pose own = pose_at(moved, 1, t, false), other = reference::movement(moved, 1).at(t);
    EXPECT_LE((own.tip - other.tip).norm(), 1e-9);
    EXPECT_LE((own.axis - other.axis).norm(), 1e-12);
  }
}

TEST_F(Motions, WhatIsNoNumberOrTurnsByHalfACircleHasNoPieces) {
  const RoundsUpward upward;
  Toolpath path = paths::through({paths::upright(0, 0, 0), {Vec3(1, 0, 0), -Vec3::UnitZ()}});
  EXPECT_FALSE(motion_pieces(path, 1, false).has_value());
  path = paths::through({paths::upright(0, 0, 0), paths::upright(0, std::nan(""), 0)});
  EXPECT_FALSE(motion_pieces(path, 1, false).has_value());
  for (const bool is_control : {true, false}) {
    path = this->path(2);
    ASSERT_TRUE(motion_pieces(path, 1, false).has_value());
    SplinePiece& piece = path.splines.front().pieces.back();
    (is_control ? piece.control[1].x() : piece.u0) = std::nan("");
    EXPECT_FALSE(motion_pieces(path, 1, false).has_value());
  }
}

}  // namespace
}  // namespace gouge::moving_pose_test
