#include "lib/tilt/cheapest_choice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "tests/support/scatter.h"

namespace gouge::cheapest_choice_test {
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
    const double way = std::max(layers[l].arc_length_mm - layers[l - 1].arc_length_mm, kMinWay_mm);
    cost +=
        0.5 * way * (from.squaredNorm() + to.squaredNorm()) / (blend_mm * blend_mm) + (to - from).squaredNorm() / way;
  }
  return cost;
}

/// Cost of all choices.
double min_cost(const std::vector<TiltLayer>& layers, double blend_mm, Choice& choice) {
  if (choice.size() == layers.size()) return cost_of(layers, choice, blend_mm);
  double least = std::numeric_limits<double>::infinity();
  const auto count = static_cast<std::uint32_t>(layers[choice.size()].tilts.size());
  for (std::uint32_t k = 0; k < count; ++k) {
    choice.push_back(k);
    least = std::min(least, min_cost(layers, blend_mm, choice));
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
      layer.arc_length_mm = way;
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
    const double least = min_cost(layers, blend_mm, none);
    const auto found = cheapest_choice(layers, blend_mm).cheapest;
    ASSERT_EQ(found.has_value(), least < std::numeric_limits<double>::infinity());
    blocked += found ? 0 : 1;
    if (!found) continue;
    EXPECT_NEAR(cost_of(layers, *found, blend_mm), least, 1e-12 * (1 + least));
  }
  EXPECT_GT(blocked, 10);
  EXPECT_LT(blocked, 200);
}

/// By examining every change: the least cost to the last layer, and of each tilt whether a way goes through it.
struct EveryChange {
  double least = std::numeric_limits<double>::infinity();
  std::vector<std::vector<char>> is_possible;
  EveryChange(const std::vector<TiltLayer>& layers, double blend_mm) {
    constexpr double kNever = std::numeric_limits<double>::infinity();
    std::vector<std::vector<double>> cost{std::vector<double>(layers.front().tilts.size(), 0.0)};
    const auto step = [&](std::size_t l, std::uint32_t a, std::uint32_t b) {
      std::vector<TiltLayer> both{layers[l], layers[l + 1]};
      return cost_of(both, {a, b}, blend_mm);
    };
    for (std::size_t l = 0; l + 1 < layers.size(); ++l) {
      auto& next = cost.emplace_back(layers[l + 1].tilts.size(), kNever);
      for (std::uint32_t a = 0; a < cost[l].size(); ++a)
        for (std::uint32_t b = 0; b < next.size(); ++b) next[b] = std::min(next[b], cost[l][a] + step(l, a, b));
    }
    is_possible.resize(layers.size());
    for (std::size_t l = layers.size(); l-- > 0;) {
      for (std::uint32_t a = 0; a < cost[l].size(); ++a) {
        bool leads_on = l + 1 == layers.size();
        for (std::uint32_t b = 0; !leads_on && b < cost[l + 1].size(); ++b)
          leads_on = is_possible[l + 1][b] != 0 && step(l, a, b) < kNever;
        is_possible[l].push_back(cost[l][a] < kNever && leads_on ? 1 : 0);
      }
    }
    for (const double last : cost.back()) least = std::min(least, last);
  }
};

TEST(CheapestChoice, OnLatticesIsThatOfEveryChange) {
  test::Scatter random(31);
  int blocked = 0;
  for (int n = 0; n < 150; ++n) {
    std::vector<TiltLayer> layers(2 + random.below(5));
    double way = 0;
    for (TiltLayer& layer : layers) {
      layer.arc_length_mm = way;
      way += random.in(0.2, 3);
      const double free = random.in(0.05, 1);
      for (int x = -4; x <= 4; ++x)
        for (int y = -4; y <= 4; ++y)
          if (random.is(free)) layer.tilts.push_back(0.1 * Tilt(x, y));
      if (random.is(0.1)) layer.tilts = {Tilt(random.in(-0.4, 0.4), random.in(-0.4, 0.4))};
      if (random.is(0.7)) layer.largest_change_rad = random.in(0.05, 0.5);
    }
    const double blend_mm = random.in(0.5, 20);
    const auto compare = [&] {
      const EveryChange every(layers, blend_mm);
      const LayerChoices found = cheapest_choice(layers, blend_mm);
      ASSERT_EQ(found.cheapest.has_value(), every.least < std::numeric_limits<double>::infinity()) << n;
      blocked += found.cheapest ? 0 : 1;
      if (!found.cheapest) return;
      EXPECT_NEAR(cost_of(layers, *found.cheapest, blend_mm), every.least, 1e-12 * (1 + every.least)) << n;
      for (std::size_t l = 0; l < layers.size(); ++l) {
        for (std::size_t k = 0; k < layers[l].tilts.size(); ++k) {
          EXPECT_GE(found.is_possible[l][k], every.is_possible[l][k]) << n << " layer " << l << " tilt " << k;
          if (layers[0].struck.empty()) {
            EXPECT_EQ(found.is_possible[l][k], every.is_possible[l][k]) << n;
          }
        }
      }
    };
    compare();
    // Removes the change that the cheapest sequence takes, as a search does.
    for (int strikes = 0; strikes < 4; ++strikes) {
      const LayerChoices found = cheapest_choice(layers, blend_mm);
      if (!found.cheapest) break;
      for (std::size_t l = 0; l + 1 < layers.size(); ++l) {
        auto& struck = layers[l].struck;
        struck.emplace_back((*found.cheapest)[l], (*found.cheapest)[l + 1]);
        std::ranges::sort(struck);
      }
      compare();
    }
  }
  EXPECT_GT(blocked, 10);
}

TEST(CheapestChoice, OfEqualOnesTakesTheFirst) {
  TiltLayer layer;
  layer.tilts = {Tilt(0, 0), Tilt(0, 0), Tilt(0, 0)};
  std::vector<TiltLayer> layers(4, layer);
  for (std::size_t l = 0; l < layers.size(); ++l) layers[l].arc_length_mm = static_cast<double>(l);
  EXPECT_EQ(cheapest_choice(layers, 10).cheapest, Choice(4, 0));
  layers[1].struck = {{0, 0}, {1, 0}};
  EXPECT_EQ(cheapest_choice(layers, 10).cheapest, (Choice{0, 2, 0, 0}));
}

}  // namespace
}  // namespace gouge::cheapest_choice_test
