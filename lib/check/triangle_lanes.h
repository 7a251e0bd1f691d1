#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "lib/hierarchy/blocks.h"

// Triangles side by side in lanes, for the wide kernel: gathered from several blocks, or divided into four. The
// functions are in the header because the sweep spends its time here.

namespace gouge {

inline void add_lane(TriangleBlock& to, const TriangleBlock& from, std::size_t lane) {
  // The first triangle fills all lanes, so that unused lanes hold a triangle too.
  const std::size_t last = to.count == 0 ? kBlockLanes : to.count + 1;
  for (std::size_t i = to.count; i < last; ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t k = 0; k < 3; ++k) to.corner[c][k][i] = from.corner[c][k][lane];
    }
    to.triangle[i] = from.triangle[lane];
  }
  ++to.count;
}

/// Appends a triangle to the last of `blocks`, or to a new block if that is full.
inline void append_lane(std::vector<TriangleBlock>& blocks, const TriangleBlock& from, std::size_t lane) {
  if (blocks.empty() || blocks.back().count == kBlockLanes) blocks.emplace_back();
  add_lane(blocks.back(), from, lane);
}

/// Appends the four triangles that the middles of the edges make with the corners.
inline void add_quarters(TriangleBlock& to, const TriangleBlock& from, std::size_t lane) {
  TriangleBlock middle = from;
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t k = 0; k < 3; ++k) {
      middle.corner[c][k][lane] = 0.5F * (from.corner[(c + 1) % 3][k][lane] + from.corner[(c + 2) % 3][k][lane]);
    }
  }
  add_lane(to, middle, lane);
  for (std::size_t c = 0; c < 3; ++c) {
    TriangleBlock tip = middle;
    for (std::size_t k = 0; k < 3; ++k) tip.corner[c][k][lane] = from.corner[c][k][lane];
    add_lane(to, tip, lane);
  }
}

[[nodiscard]] inline float longest_edge(const TriangleBlock& block, std::size_t lane) {
  float longest2 = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    float edge2 = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const float d = block.corner[(c + 1) % 3][k][lane] - block.corner[c][k][lane];
      edge2 += d * d;
    }
    longest2 = std::max(longest2, edge2);
  }
  return std::sqrt(longest2);
}

[[nodiscard]] inline bool are_short(const std::vector<TriangleBlock>& blocks, float edge_mm) {
  for (const TriangleBlock& block : blocks) {
    for (std::size_t i = 0; i < block.count; ++i) {
      if (longest_edge(block, i) > edge_mm) return false;
    }
  }
  return true;
}

}  // namespace gouge
