#pragma once

#include <cstddef>
#include <vector>

#include "lib/path/motion_chords.h"
#include "lib/path/tip_grid.h"

namespace gouge {

/// The places that rapids of a path reach, for feeds of another path that became rapids.
class RapidPlaces {
 public:
  /// Places nearer than `within_mm` are equal; so are axes whose points at `height_mm` are.
  RapidPlaces(const Toolpath& path, double within_mm, double height_mm);

  /// Returns the first rapid that ends at a position, else kNone. Cost: that of few rapids.
  [[nodiscard]] std::size_t ending_at(const Pose& end) const { return ending_at(end, end); }
  /// Returns the first rapid that ends at a position and passes another one, else kNone. Cost: that of few rapids.
  [[nodiscard]] std::size_t ending_at(const Pose& end, const Pose& passed) const;
  /// Returns the first rapid that passes both positions, else kNone. Cost: the number of rapids.
  [[nodiscard]] std::size_t passing(const Pose& one, const Pose& two) const;

 private:
  [[nodiscard]] bool passes(const MotionChord& rapid, const Pose& pose) const;

  std::vector<MotionChord> rapids_;
  TipGrid ends_;  // indices of rapids_
  double within_mm_, height_mm_;
};

}  // namespace gouge
