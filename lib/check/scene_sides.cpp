#include "lib/check/scene_sides.h"

#include "lib/base/parallel.h"
#include "lib/check/contact_rule.h"

namespace gouge {

SceneSides::SceneSides(const Scene& scene) {
  for (const ObstacleMeshes& obstacle : obstacles_of(scene)) obstacles_.emplace_back(obstacle.meshes);
}

std::uint8_t SceneSides::beyond(const Vec3& point) const {
  unsigned bits = 0;
  for (std::size_t k = 0; k < obstacles_.size(); ++k) bits |= obstacles_[k].is_beyond(point) ? 1U << k : 0U;
  return static_cast<std::uint8_t>(bits);
}

SideResult SceneSides::side_of(const ConnectedPoints& joined, std::uint8_t beyond) const {
  SideResult result{Side::outside, {}};
  for (std::size_t k = 0; k < obstacles_.size(); ++k) {
    if ((beyond & (1U << k)) != 0) continue;
    const Side side = obstacles_[k].side_of(joined);
    if (side == Side::inside) return {side, {}};
    if (side == Side::outside || result.side == Side::unknown) continue;
    result = {side, obstacles_[k].why_unknown()};
  }
  return result;
}

void FreeChains::decide(unsigned threads, const std::function<ConnectedPoints(std::size_t)>& points_of,
                        const std::function<bool(std::size_t)>& is_asked) {
  const std::size_t count = beyond_.size();
  PagedVector<std::uint32_t> last(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t root = joins_.root(i);
    beyond_[root] |= beyond_[i];
    last[root] = i;
  }
  struct Open {
    std::uint32_t first, last;
  };
  std::vector<Open> open;
  result_of_.assign(count, 0);
  for (std::uint32_t i = 0; i < count; ++i) {
    if (joins_.root(i) != i || beyond_[i] == sides_.beyond_all() || (is_asked && !is_asked(i))) continue;
    open.push_back({i, last[i]});
    result_of_[i] = static_cast<std::uint32_t>(open.size());
  }
  results_.assign(open.size() + 1, SideResult{Side::outside, {}});  // the first result is for chains seen beyond all
                                                                    // meshes
  for_each_chunk(open.size(), 1, threads, [&](std::size_t first, std::size_t end) {
    for (std::size_t k = first; k < end; ++k) {
      ConnectedPoints joined = points_of(open[k].first);
      if (open[k].last != open[k].first) {
        const ConnectedPoints more = points_of(open[k].last);
        joined.points.insert(joined.points.end(), more.points.begin(), more.points.end());
        joined.directions.insert(joined.directions.end(), more.directions.begin(), more.directions.end());
      }
      results_[k + 1] = sides_.side_of(joined, beyond_[open[k].first]);
    }
  });
}

}  // namespace gouge
