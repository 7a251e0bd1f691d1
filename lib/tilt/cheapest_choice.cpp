#include "lib/tilt/cheapest_choice.h"

#include <algorithm>
#include <limits>

namespace gouge {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// Coordinates of a layer's tilts side by side.
struct Columns {
  std::vector<double> x, y, square;
  explicit Columns(const std::vector<Tilt>& tilts) {
    for (const Tilt& tilt : tilts) {
      x.push_back(tilt.x());
      y.push_back(tilt.y());
      square.push_back(tilt.squaredNorm());
    }
  }
};

/// The least of a layer so far, and from which tilt of the one before.
struct Best {
  std::vector<double> cost;
  std::vector<std::int64_t> from;  // as wide as what it is chosen with
  explicit Best(std::size_t count) : cost(count, kNever), from(count, 0) {}
};

/// What the step between two layers costs.
struct Step {
  double by_tilt = 0, by_change = 0;
  Step(const TiltLayer& from, const TiltLayer& to, double blend_mm) {
    const double way = std::max(to.way_mm - from.way_mm, kLeastWay_mm), blend = std::max(blend_mm, kLeastWay_mm);
    by_tilt = 0.5 * way / (blend * blend);
    by_change = 1 / way;
  }
};

/// From one tilt `a` to all of the next layer for which `is_allowed(b)`.
template <typename IsAllowed>
void step_from(std::size_t a, const Columns& from, const Columns& to, const Step& step, double so_far, Best& best,
               const IsAllowed& is_allowed) {
  const double x = from.x[a], y = from.y[a];
  const auto index = static_cast<std::int64_t>(a);
  const std::size_t count = to.x.size();
  const double *const to_x = to.x.data(), *const to_y = to.y.data(), *const square = to.square.data();
  double* const cost = best.cost.data();
  std::int64_t* const came = best.from.data();
  for (std::size_t b = 0; b < count; ++b) {
    const double dx = to_x[b] - x, dy = to_y[b] - y;
    const double total = so_far + step.by_tilt * square[b] + step.by_change * (dx * dx + dy * dy);
    const bool is_less = total < cost[b] && is_allowed(b);
    came[b] = is_less ? index : came[b];
    cost[b] = is_less ? total : cost[b];
  }
}

}  // namespace

std::optional<std::vector<std::uint32_t>> cheapest_choice(const std::vector<TiltLayer>& layers, double blend_mm) {
  std::vector<Best> best;
  best.reserve(layers.size());
  best.emplace_back(layers.front().tilts.size());
  std::ranges::fill(best.back().cost, 0);
  Columns from(layers.front().tilts);
  for (std::size_t l = 1; l < layers.size(); ++l) {
    const Step step(layers[l - 1], layers[l], blend_mm);
    const auto& struck = layers[l - 1].struck;
    Columns to(layers[l].tilts);
    best.emplace_back(to.x.size());
    for (std::uint32_t a = 0; a < from.x.size(); ++a) {
      const double so_far = best[l - 1].cost[a] + step.by_tilt * from.square[a];
      if (struck.empty()) {
        step_from(a, from, to, step, so_far, best[l], [](std::size_t) { return true; });
      } else {
        step_from(a, from, to, step, so_far, best[l], [&](std::size_t b) {
          return !std::ranges::binary_search(struck, std::pair(a, static_cast<std::uint32_t>(b)));
        });
      }
    }
    from = std::move(to);
  }
  const std::vector<double>& last = best.back().cost;
  const auto cheapest = std::ranges::min_element(last);
  if (cheapest == last.end() || !(*cheapest < kNever)) return std::nullopt;
  std::vector<std::uint32_t> chosen(layers.size());
  auto at = static_cast<std::size_t>(cheapest - last.begin());
  for (std::size_t l = layers.size(); l-- > 0;) {
    chosen[l] = static_cast<std::uint32_t>(at);
    at = static_cast<std::size_t>(best[l].from[at]);
  }
  return chosen;
}

}  // namespace gouge
