#include "lib/tilt/cheapest_choice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "tests/support/scatter.h"

namespace gouge {
namespace {

using Choice = std::vector<std::uint32_t>;

double cost_of(const std::vector<TiltLayer>& layers, const Choice& choice, double blend_mm) {
  double cost = 0;
  for (std::size_t l = 1; l < layers.size(); ++l) {
    const auto& struck = layers[l - 1].struck;
    if (std::ranges::find(struck, std::pair(choice[l - 1], choice[l])) != struck.end())
      return std::numeric_limits<double>::infinity();
    const Tilt &from = layers[l - 1].tilts[choice[l - 1]], &to = layers[l].tilts[choice[l]];
    if ((to - from).squaredNorm() > layers[l - 1].largest_change_rad * layers[l - 1].largest_change_rad)
      return std::numeric_limits<double>::infinity();
    const double way = std::max(layers[l].way_mm - layers[l - 1].way_mm, kLeastWay_mm);
    cost +=
        0.5 * way * (from.squaredNorm() + to.squaredNorm()) / (blend_mm * blend_mm) + (to - from).squaredNorm() / way;
  }
  return cost;
}

/// Of all choices.
double least_cost(const std::vector<TiltLayer>& layers, double blend_mm, Choice& choice) {
  if (choice.size() == layers.size()) return cost_of(layers, choice, blend_mm);
  double least = std::numeric_limits<double>::infinity();
  const auto count = static_cast<std::uint32_t>(layers[choice.size()].tilts.size());
  for (std::uint32_t k = 0; k < count; ++k) {
    choice.push_back(k);
    least = std::min(least, least_cost(layers, blend_mm, choice));
    choice.pop_back();
  }
  return least;
}

TEST(CheapestChoice, IsTheCheapestOfAllThatAreNotStruck) {
  test::Scatter random(29);
  int blocked = 0;
  for (int n = 0; n < 400; ++n) {
    std::vector<TiltLayer> layers(static_cast<std::size_t>(random.in(1, 6)));
    double way = 0;
    for (TiltLayer& layer : layers) {
      layer.way_mm = way;
      way += random.is(0.1) ? 0 : random.in(0.1, 5);
      const int count = random.is(0.05) ? 0 : static_cast<int>(random.in(1, 6));
      for (int k = 0; k < count; ++k) layer.tilts.emplace_back(random.in(-0.5, 0.5), random.in(-0.5, 0.5));
    }
    for (TiltLayer& layer : layers) {
      if (random.is(0.3)) layer.largest_change_rad = random.in(0.2, 1);
    }
    for (std::size_t l = 0; l + 1 < layers.size() && random.is(0.6); ++l) {
      const double share = random.is(0.2) ? 0.9 : 0.3;
      for (std::uint32_t a = 0; a < layers[l].tilts.size(); ++a) {
        for (std::uint32_t b = 0; b < layers[l + 1].tilts.size(); ++b) {
          if (random.is(share)) layers[l].struck.emplace_back(a, b);
        }
      }
    }
    const double blend_mm = random.in(0.5, 20);
    Choice none;
    const double least = least_cost(layers, blend_mm, none);
    const auto found = cheapest_choice(layers, blend_mm);
    ASSERT_EQ(found.has_value(), least < std::numeric_limits<double>::infinity());
    blocked += found ? 0 : 1;
    if (!found) continue;
    EXPECT_NEAR(cost_of(layers, *found, blend_mm), least, 1e-12 * (1 + least));
  }
  EXPECT_GT(blocked, 10);
  EXPECT_LT(blocked, 200);
}

TEST(CheapestChoice, OfEqualOnesTakesTheFirst) {
  TiltLayer layer;
  layer.tilts = {Tilt(0, 0), Tilt(0, 0), Tilt(0, 0)};
  std::vector<TiltLayer> layers(4, layer);
  for (std::size_t l = 0; l < layers.size(); ++l) layers[l].way_mm = static_cast<double>(l);
  EXPECT_EQ(cheapest_choice(layers, 10), Choice(4, 0));
  layers[1].struck = {{0, 0}, {1, 0}};
  EXPECT_EQ(cheapest_choice(layers, 10), (Choice{0, 2, 0, 0}));
}

}  // namespace
}  // namespace gouge
