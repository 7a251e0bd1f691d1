#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gouge {

/// Appends groups of up to four neighbours, groups of those, and so on. A tree of points can query a group once for all
/// of its bodies while they are far from it. Returns how many groups are last and represent all.
///
/// A Body has is_of(other), whether it may be in one group with it, and is made from (parts, index of the first).
template <class Body>
[[nodiscard]] std::size_t group_neighbours(std::vector<Body>& bodies) {
  constexpr std::size_t kGroup = 4;
  std::size_t first = 0;
  while (true) {
    const std::size_t last = bodies.size();
    if (last - first <= kGroup) return last - first;
    for (std::size_t at = first; at < last;) {
      std::size_t end = at + 1;
      while (end < last && end - at < kGroup && bodies[end].is_of(bodies[at])) ++end;
      bodies.push_back(Body(std::span<const Body>(bodies).subspan(at, end - at), static_cast<std::uint32_t>(at)));
      at = end;
    }
    if (bodies.size() - last == last - first) return last - first;
    first = last;
  }
}

}  // namespace gouge
