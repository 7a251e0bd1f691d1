#include "lib/check/scene_sides.h"

#include "lib/base/parallel.h"

namespace gouge {

std::uint8_t SceneSides::beyond(const Vec3& point) const {
  return static_cast<std::uint8_t>((parts_.is_beyond(point) ? 1 : 0) + (fixtures_.is_beyond(point) ? 2 : 0));
}

SideResult SceneSides::side_of(const ConnectedPoints& joined, std::uint8_t beyond) const {
  SideResult result{Side::outside, {}};
  for (const auto& [kind, bit] : {std::pair(&parts_, 1), std::pair(&fixtures_, 2)}) {
    if ((beyond & bit) != 0) continue;
    const Side side = kind->side_of(joined);
    if (side == Side::inside) return {side, {}};
    if (side == Side::outside || result.side == Side::unknown) continue;
    result = {side, kind->why_unknown()};
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
    if (joins_.root(i) != i || beyond_[i] == SceneSides::kBeyondAll || (is_asked && !is_asked(i))) continue;
    open.push_back({i, last[i]});
    result_of_[i] = static_cast<std::uint32_t>(open.size());
  }
  results_.assign(open.size() + 1, SideResult{Side::outside, {}});  // the first: seen beyond everything
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
