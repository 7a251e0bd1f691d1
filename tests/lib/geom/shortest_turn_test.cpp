#include "lib/geom/shortest_turn.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gouge::test::shortest_turn_test {
namespace {

TEST(ShortestTurn, TakesOneVectorToTheOtherAtEveryAngle) {
  for (const double off : {1e-15, 1e-12, 1e-9, 1e-6, 2e-6, 4e-5, 1e-3, 0.1, 1.0, 2.0, 3.0}) {
    for (const double angle : {0.0, 0.3, 2.0, 4.0, 6.0}) {
      const Vec3 from = Vec3(0.3, -0.5, 0.8).normalized();
      const Vec3 across = Eigen::AngleAxisd(angle, from) * from.unitOrthogonal();
      const Vec3 to = -std::cos(off) * from + std::sin(off) * across;
      const Eigen::Quaterniond turn = shortest_turn(from, to);
      EXPECT_LT((turn * from - to).norm(), 2e-15) << off;
      EXPECT_LT(std::abs(turn.vec().dot(from)), 1e-15) << off << ": it turns about a normal of both";
    }
  }
  EXPECT_LT((shortest_turn(Vec3::UnitZ(), -Vec3::UnitZ()) * Vec3::UnitZ() + Vec3::UnitZ()).norm(), 1e-15);
  EXPECT_LT(shortest_turn(Vec3::UnitX(), Vec3::UnitX()).angularDistance(Eigen::Quaterniond::Identity()), 1e-15);
}

}  // namespace
}  // namespace gouge::test::shortest_turn_test
