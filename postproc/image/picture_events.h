#pragma once

#include <vector>

#include "postproc/image/picture_input.h"

namespace gouge {

/// A finding as the pictures number it: 1 is the worst.
struct PictureEvent {
  int number = 0;
  Event event;
  Pose pose;                 ///< of the tool at the worst instant
  Vec3 at = Vec3::Zero();    ///< witness; for a buried tool the middle of its cutter
  bool has_witness = false;  ///< a buried tool has none
  Witness witness;
  double depth_mm = 0;
};

/// Gouges and buried tools, the deepest first (buried ones last, they have no depth), at most `most`. Of
/// findings of one tool and body close beside each other (5 % of the parts' size) only the deepest is taken.
[[nodiscard]] std::vector<PictureEvent> worst_events(const PictureInput& input, std::size_t most);

}  // namespace gouge
