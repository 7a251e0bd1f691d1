#include "lib/tilt/cheapest_choice.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace gouge {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// Coordinates of a layer's tilts side by side, in the order of x.
struct Columns {
  std::vector<double> x, y, square;
  std::vector<std::uint32_t> tilt, place;  // the tilt at a place, and the place of a tilt
  explicit Columns(const std::vector<Tilt>& tilts) : tilt(tilts.size()), place(tilts.size()) {
    std::iota(tilt.begin(), tilt.end(), 0U);
    std::ranges::stable_sort(tilt, {}, [&](std::uint32_t k) { return tilts[k].x(); });
    for (const std::uint32_t k : tilt) {
      place[k] = static_cast<std::uint32_t>(x.size());
      x.push_back(tilts[k].x());
      y.push_back(tilts[k].y());
      square.push_back(tilts[k].squaredNorm());
    }
  }
};

/// The least of a layer so far, at each place, and from which tilt of the one before.
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

/// From one tilt to all of the next layer for which `is_allowed(place)`.
template <typename IsAllowed>
void step_from(const TiltLayer& layer, std::uint32_t tilt, const Columns& to, const Step& step, double so_far,
               Best& best, const IsAllowed& is_allowed) {
  const double x = layer.tilts[tilt].x(), y = layer.tilts[tilt].y();
  const double most = layer.largest_change_rad, most2 = most * most;
  const auto index = static_cast<std::int64_t>(tilt);
  const auto first = std::ranges::lower_bound(to.x, x - most) - to.x.begin();
  const auto last = std::ranges::upper_bound(to.x, x + most) - to.x.begin();
  const double *const to_x = to.x.data(), *const to_y = to.y.data(), *const square = to.square.data();
  double* const cost = best.cost.data();
  std::int64_t* const came = best.from.data();
  for (auto b = static_cast<std::size_t>(first); b < static_cast<std::size_t>(last); ++b) {
    const double dx = to_x[b] - x, dy = to_y[b] - y;
    const double change2 = dx * dx + dy * dy;
    const double total = so_far + step.by_tilt * square[b] + step.by_change * change2;
    const bool is_less = total < cost[b] && !(change2 > most2) && is_allowed(b);
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
  std::vector<Columns> columns{Columns(layers.front().tilts)};
  columns.reserve(layers.size());
  for (std::size_t l = 1; l < layers.size(); ++l) {
    const TiltLayer& from = layers[l - 1];
    const Step step(from, layers[l], blend_mm);
    const Columns& to = columns.emplace_back(layers[l].tilts);
    best.emplace_back(to.x.size());
    for (std::uint32_t a = 0; a < from.tilts.size(); ++a) {
      const double so_far = best[l - 1].cost[columns[l - 1].place[a]] + step.by_tilt * from.tilts[a].squaredNorm();
      if (!(so_far < kNever)) continue;
      if (from.struck.empty()) {
        step_from(from, a, to, step, so_far, best[l], [](std::size_t) { return true; });
      } else {
        step_from(from, a, to, step, so_far, best[l],
                  [&](std::size_t b) { return !std::ranges::binary_search(from.struck, std::pair(a, to.tilt[b])); });
      }
    }
  }
  const auto cost_of = [&](std::uint32_t tilt) { return best.back().cost[columns.back().place[tilt]]; };
  std::uint32_t at = 0;
  for (std::uint32_t k = 1; k < layers.back().tilts.size(); ++k) at = cost_of(k) < cost_of(at) ? k : at;
  if (layers.back().tilts.empty() || !(cost_of(at) < kNever)) return std::nullopt;
  std::vector<std::uint32_t> chosen(layers.size());
  for (std::size_t l = layers.size(); l-- > 0;) {
    chosen[l] = at;
    at = static_cast<std::uint32_t>(best[l].from[columns[l].place[at]]);
  }
  return chosen;
}

}  // namespace gouge
