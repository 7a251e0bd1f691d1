#include "lib/tilt/cheapest_choice.h"

#include <algorithm>
#include <limits>

#include "lib/tilt/lowest_parabola.h"

namespace gouge {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// Cost of the step between two layers.
struct Step {
  double by_tilt = 0, by_change = 0;
  Step(const TiltLayer& from, const TiltLayer& to, double blend_mm) {
    const double way = std::max(to.arc_length_mm - from.arc_length_mm, kMinWay_mm),
                 blend = std::max(blend_mm, kMinWay_mm);
    by_tilt = 0.5 * way / (blend * blend);
    by_change = 1 / way;
  }
};

/// The minimum cost of each tilt of a layer, and the tilt of the layer before from which it comes.
struct Best {
  std::vector<double> cost;
  std::vector<std::uint32_t> from;
};

bool is_struck(const TiltLayer& layer, std::uint32_t from, std::uint32_t to) {
  return !layer.struck.empty() && std::ranges::binary_search(layer.struck, std::pair(from, to));
}

class Choosing {
 public:
  Choosing(const std::vector<TiltLayer>& layers, double blend_mm) : layers_(layers), blend_mm_(blend_mm) {
    rows_.reserve(layers.size());
    for (const TiltLayer& layer : layers) rows_.emplace_back(layer.tilts);
  }

  LayerChoices run() {
    LayerChoices choices;
    best_.push_back({std::vector<double>(layers_.front().tilts.size(), 0.0), {}});
    for (std::size_t l = 0; l < layers_.size(); ++l) {
      if (l > 0) step_to(l);
      auto& is_possible = choices.is_possible.emplace_back();
      for (const double cost : best_[l].cost) is_possible.push_back(cost < kNever ? 1 : 0);
      if (std::ranges::find(is_possible, 1) != is_possible.end()) continue;
      choices.first_unreached = l;
      return choices;
    }
    for (std::size_t l = layers_.size() - 1; l-- > 0;) keep_those_leading_on(l, choices.is_possible);
    choices.cheapest = cheapest();
    return choices;
  }

 private:
  void step_to(std::size_t l) {
    const TiltLayer &from = layers_[l - 1], &to = layers_[l];
    const Step step(from, to, blend_mm_);
    std::vector<double> before = best_[l - 1].cost;
    for (std::size_t a = 0; a < before.size(); ++a) before[a] += step.by_tilt * from.tilts[a].squaredNorm();
    Best best{std::vector<double>(to.tilts.size(), kNever),
              parabolas_.find(rows_[l - 1], before, step.by_change, rows_[l])};
    std::vector<std::uint32_t> nearest;
    const double most2 = from.largest_change_rad * from.largest_change_rad;
    const auto change2 = [&](std::uint32_t a, std::uint32_t b) { return (to.tilts[b] - from.tilts[a]).squaredNorm(); };
    for (std::uint32_t b = 0; b < to.tilts.size(); ++b) {
      std::uint32_t& a = best.from[b];
      if (a == LowestParabolas::kNoTilt) continue;
      if (change2(a, b) > most2 || is_struck(from, a, b)) {
        if (nearest.empty()) nearest = nearest_of(l - 1, before, l);
        a = change2(nearest[b], b) > most2 ? LowestParabolas::kNoTilt : cheapest_allowed(from, before, step, to, b);
      }
      if (a == LowestParabolas::kNoTilt) continue;
      best.cost[b] = before[a] + step.by_tilt * to.tilts[b].squaredNorm() + step.by_change * change2(a, b);
    }
    best_.push_back(std::move(best));
  }

  /// Returns, for each tilt of layer `other`, the nearest tilt of layer `layer` among those with finite heights.
  [[nodiscard]] std::vector<std::uint32_t> nearest_of(std::size_t layer, std::vector<double> heights,
                                                      std::size_t other) {
    for (double& height : heights) height = height < kNever ? 0 : kNever;
    return parabolas_.find(rows_[layer], heights, 1, rows_[other]);
  }

  /// Returns the cheapest allowed predecessor of tilt `b`. Tests every tilt of the layer before.
  static std::uint32_t cheapest_allowed(const TiltLayer& from, const std::vector<double>& before, const Step& step,
                                        const TiltLayer& to, std::uint32_t b) {
    const double most2 = from.largest_change_rad * from.largest_change_rad;
    std::uint32_t found = LowestParabolas::kNoTilt;
    double least = kNever;
    for (std::uint32_t a = 0; a < from.tilts.size(); ++a) {
      const double change2 = (to.tilts[b] - from.tilts[a]).squaredNorm();
      const double cost = before[a] + step.by_change * change2;
      if (!(cost < least) || change2 > most2 || is_struck(from, a, b)) continue;
      least = cost;
      found = a;
    }
    return found;
  }

  void keep_those_leading_on(std::size_t l, std::vector<std::vector<char>>& is_possible) {
    const TiltLayer &from = layers_[l], &to = layers_[l + 1];
    const double most2 = from.largest_change_rad * from.largest_change_rad;
    if (!(most2 < kNever)) return;
    std::vector<double> heights;
    for (const char possible : is_possible[l + 1]) heights.push_back(possible != 0 ? 0 : kNever);
    const std::vector<std::uint32_t>& nearest = parabolas_.find(rows_[l + 1], heights, 1, rows_[l]);
    for (std::size_t a = 0; a < from.tilts.size(); ++a) {
      if ((to.tilts[nearest[a]] - from.tilts[a]).squaredNorm() > most2) is_possible[l][a] = 0;
    }
  }

  [[nodiscard]] std::vector<std::uint32_t> cheapest() const {
    const std::vector<double>& last = best_.back().cost;
    auto at = static_cast<std::uint32_t>(std::ranges::min_element(last) - last.begin());
    std::vector<std::uint32_t> chosen(layers_.size(), at);
    for (std::size_t l = layers_.size() - 1; l > 0; --l) chosen[l - 1] = at = best_[l].from[at];
    return chosen;
  }

  const std::vector<TiltLayer>& layers_;
  double blend_mm_;
  std::vector<TiltRows> rows_;
  std::vector<Best> best_;
  LowestParabolas parabolas_;
};

}  // namespace

LayerChoices cheapest_choice(const std::vector<TiltLayer>& layers, double blend_mm) {
  return Choosing(layers, blend_mm).run();
}

}  // namespace gouge
