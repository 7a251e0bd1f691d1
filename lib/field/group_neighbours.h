#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gouge {

/// Appends groups of up to four neighbours, groups of these groups, and so on. A tree of points can query a group once
/// for all of its bodies while they are far away. Returns the number of last groups that together represent all bodies.
///
/// A Body has is_of(other), which states whether both may be in one group. It can be made from (parts, index of the
/// first).
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
