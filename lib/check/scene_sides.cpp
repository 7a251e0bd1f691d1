#include "lib/check/scene_sides.h"

#include "lib/base/parallel.h"

namespace gouge {

std::uint8_t SceneSides::beyond(const Vec3& point) const {
  return static_cast<std::uint8_t>((parts_.is_beyond(point) ? 1 : 0) + (fixtures_.is_beyond(point) ? 2 : 0));
}

SideAnswer SceneSides::side_of(const JoinedPlaces& joined, std::uint8_t beyond) const {
  SideAnswer answer{Side::outside, {}};
  for (const auto& [kind, bit] : {std::pair(&parts_, 1), std::pair(&fixtures_, 2)}) {
    if ((beyond & bit) != 0) continue;
    const Side side = kind->side_of(joined);
    if (side == Side::inside) return {side, {}};
    if (side == Side::outside || answer.side == Side::unknown) continue;
    answer = {side, kind->why_unknown()};
  }
  return answer;
}

void FreeChains::decide(unsigned threads, const std::function<JoinedPlaces(std::size_t)>& places_of,
                        const std::function<bool(std::size_t)>& is_asked) {
  const std::size_t count = beyond_.size();
  std::vector<std::uint32_t> last(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t root = joins_.root(i);
    beyond_[root] |= beyond_[i];
    last[root] = i;
  }
  struct Open {
    std::uint32_t first, last;
  };
  std::vector<Open> open;
  answer_of_.assign(count, 0);
  for (std::uint32_t i = 0; i < count; ++i) {
    if (joins_.root(i) != i || beyond_[i] == SceneSides::kBeyondAll || (is_asked && !is_asked(i))) continue;
    open.push_back({i, last[i]});
    answer_of_[i] = static_cast<std::uint32_t>(open.size());
  }
  answers_.assign(open.size() + 1, SideAnswer{Side::outside, {}});  // the first: seen beyond everything
  for_each_chunk(open.size(), 1, threads, [&](std::size_t first, std::size_t end) {
    for (std::size_t k = first; k < end; ++k) {
      JoinedPlaces joined = places_of(open[k].first);
      if (open[k].last != open[k].first) {
        const JoinedPlaces more = places_of(open[k].last);
        joined.places.insert(joined.places.end(), more.places.begin(), more.places.end());
        joined.directions.insert(joined.directions.end(), more.directions.begin(), more.directions.end());
      }
      answers_[k + 1] = sides_.side_of(joined, beyond_[open[k].first]);
    }
  });
}

}  // namespace gouge
