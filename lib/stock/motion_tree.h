#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "lib/geom/vec.h"
#include "lib/motion/departure.h"
#include "lib/motion/motion.h"

namespace gouge {

/// The space that a tool's body may take: a cylinder about its axis, from the tip. mm.
struct ToolCylinder {
  double radius_mm = 0, z_lo_mm = 0, z_hi_mm = 0;
};

/// A piece of space that a body of the tool must contain, moved out by `grow_mm` (in where it is negative). It contains a
/// disc about its middle, in a plane of any direction, and the points middle +- half.
struct SoughtPiece {
  Vec3 middle = Vec3::Zero(), half = Vec3::Zero();
  double disc_mm = 0, grow_mm = 0;
};

/// A time interval of a motion, with bounds of its tips and axes.
struct MotionSpan {
  std::array<float, 3> low{}, high{};  ///< box of the tips
  std::array<float, 3> axis{};         ///< middle direction, unit
  float cone_rad = 0;                  ///< largest angle of the axis to it
  std::uint32_t move = 0, segment = 0;
  float t0 = 0, t1 = 1;

  /// Returns the first and the last instant, moved out by the rounding of floats.
  [[nodiscard]] double from() const { return std::max(0.0, static_cast<double>(t0) - kInstantRounding); }
  [[nodiscard]] double until() const { return std::min(1.0, static_cast<double>(t1) + kInstantRounding); }

 private:
  static constexpr double kInstantRounding = 2e-7;
};

/// Appends the spans of a motion and its departure. No span has a path longer than `longest_mm`, turns by more than a tenth of a radian or
/// leaves its chord by more than a small share of `longest_mm`, unless it would need more than kMaxSpans. Requires motion.is_defined().
void append_spans(const Motion& motion, const Departure& departure, std::uint32_t move, double longest_mm,
                  std::vector<MotionSpan>& spans);
inline constexpr int kMaxSpans = 256;

/// Motions of one tool, held in a binary tree by place. It finds the motions that may bring a body of the tool to a point.
class MotionTree {
 public:
  /// Cost  O(n log n) for n spans; about 80 bytes for each.
  explicit MotionTree(std::vector<MotionSpan> spans);

  /// Calls `visit(span)` for every span of a move below `before` during which the cylinder may contain the piece, until it
  /// returns true. Returns whether it did.
  template <typename Visit>
  bool find(const SoughtPiece& piece, const ToolCylinder& body, std::uint32_t before, const Visit& visit) const {
    std::array<std::uint32_t, 64> waiting;
    std::size_t count = 0;
    if (!cells_.empty()) waiting[count++] = 0;
    while (count > 0) {
      const std::uint32_t index = waiting[--count];
      const Cell& cell = cells_[index];
      if (cell.bounds.move >= before || !may_contain(cell.bounds, piece, body)) continue;
      if (cell.second != 0) {
        waiting[count++] = cell.second;
        waiting[count++] = index + 1;
        continue;
      }
      for (std::uint32_t s = cell.first_span; s < cell.last_span; ++s) {
        if (spans_[s].move < before && may_contain(spans_[s], piece, body) && visit(spans_[s])) return true;
      }
    }
    return false;
  }

 private:
  /// `bounds.move` is the least move. An inner cell is followed by its first child; `second` is the other one.
  struct Cell {
    MotionSpan bounds;
    std::uint32_t second = 0, first_span = 0, last_span = 0;
  };

  void build(std::uint32_t first, std::uint32_t last);
  [[nodiscard]] MotionSpan around(std::uint32_t first, std::uint32_t last) const;

  static bool may_contain(const MotionSpan& span, const SoughtPiece& piece, const ToolCylinder& body);

  std::vector<MotionSpan> spans_;
  std::vector<Cell> cells_;
};

}  // namespace gouge
