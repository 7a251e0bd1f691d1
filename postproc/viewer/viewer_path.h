#pragma once

#include <cstdint>
#include <vector>

#include "lib/field/checked_toolpath.h"
#include "lib/geom/pose.h"

namespace gouge {

/// A pose of the path that the viewer shows, and interpolates between: the end of a move, or an instant of a curve.
struct Station {
  Pose pose;
  std::size_t move = 0;
  double t = 1;
  bool is_start = false;  ///< no motion leads here: the first position, or one after a motion that is not known
};

/// Stations of a path: curves with chords `error_mm` from them. Of a path of more than `most` moves every so manieth, and
/// the worst move of each finding with its neighbours, where the next but one would not be told apart.
[[nodiscard]] std::vector<Station> stations_of(const CheckedToolpath& input, double error_mm, std::size_t most);

}  // namespace gouge
