#include <gtest/gtest.h>

#include <cmath>

#include "tests/bench/penetration/coulomb.h"
#include "tests/bench/penetration/direction_families.h"

namespace gouge::direction_families_test {
namespace {

TEST(Directions, HaveTheAskedNumberOfUnitAxesNoTwoAlike) {
  for (const auto& [family, ks] : {std::pair{DirectionFamily::platonic, std::vector<std::size_t>{8, 12, 20}},
                                   std::pair{DirectionFamily::coulomb, std::vector<std::size_t>{6, 10, 22, 64}}}) {
    for (const std::size_t k : ks) {
      const auto set = make_directions(family, k);
      ASSERT_TRUE(set.has_value()) << k;
      EXPECT_EQ(set->k(), k);
      for (std::size_t i = 0; i < set->axes.size(); ++i) {
        EXPECT_NEAR(set->axes[i].norm(), 1, 1e-12);
        for (std::size_t j = 0; j < i; ++j) EXPECT_LT(std::abs(set->axes[i].dot(set->axes[j])), 0.99) << k;
      }
    }
  }
}

TEST(Directions, AreNotMadeUpForOtherK) {
  EXPECT_FALSE(make_directions(DirectionFamily::platonic, 4).has_value());
  EXPECT_FALSE(make_directions(DirectionFamily::coulomb, 7).has_value());
  EXPECT_FALSE(make_directions(DirectionFamily::coulomb, 4).has_value());
  EXPECT_FALSE(make_directions(DirectionFamily::coulomb, 130).has_value());
}

TEST(Coulomb, FindsTheOctahedronAndTheIcosahedron) {
  const std::vector<Vec3> three = spread_axes(3), six = spread_axes(6);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < i; ++j) EXPECT_NEAR(three[i].dot(three[j]), 0, 1e-5);
  }
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j < i; ++j) EXPECT_NEAR(std::abs(six[i].dot(six[j])), 1 / std::sqrt(5.0), 1e-4);
  }
  // Energies of the best known arrangements of 6 and 12 charges.
  EXPECT_NEAR(coulomb_energy(three), 9.985281374, 1e-6);
  EXPECT_NEAR(coulomb_energy(six), 49.165253058, 1e-6);
}

TEST(Coulomb, SpreadsNoWorseThanTheCubesDirections) {
  for (const std::size_t k : {14U, 18U, 26U}) {
    const double cube = coulomb_energy(cube_directions(k).axes);
    EXPECT_LE(coulomb_energy(spread_axes(k / 2)), cube + 1e-6) << k;
    if (k != 14) {
      EXPECT_LT(coulomb_energy(spread_axes(k / 2)), cube - 0.01) << k;
    }
  }
}

}  // namespace
}  // namespace gouge::direction_families_test
