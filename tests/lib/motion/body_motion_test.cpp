#include "lib/motion/body_motion.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gouge::body_motion_test {
namespace {

TEST(RotationToAxis, IsARotationThatTakesZToTheAxisUpToTheOppositeOne) {
  for (const double off : {0.0, 1e-12, 1e-9, 1e-6, 2e-5, 4.4e-5, 4.6e-5, 1e-3, 0.1, 1.5, 3.0, 3.14159}) {
    for (const double about : {0.0, 1.0, 2.5, 4.0}) {
      const Vec3 axis(std::sin(off) * std::cos(about), std::sin(off) * std::sin(about), -std::cos(off));
      const Eigen::Matrix3d turn = rotation_to_axis(axis);
      EXPECT_LT((turn.transpose() * turn - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff(), 2e-15) << off;
      EXPECT_LT((turn.col(2) - axis).norm(), 1e-15) << off;
      EXPECT_NEAR(turn.determinant(), 1, 1e-14) << off;
      EXPECT_NEAR(turn.trace(), 1 - 2 * std::cos(off), 1e-14) << "the shortest turn";
    }
  }
}

}  // namespace
}  // namespace gouge::body_motion_test
