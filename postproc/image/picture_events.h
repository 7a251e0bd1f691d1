#pragma once

#include <optional>
#include <vector>

#include "lib/field/checked_toolpath.h"
#include "lib/geom/rigid_transform.h"

namespace gouge {

/// So many findings have a picture in a report.
inline constexpr std::size_t kEventsOfReport = 6;

/// A finding as the pictures number it: 1 is the worst.
struct PictureEvent {
  int number = 0;
  Event event;
  Pose pose;                        ///< of the tool at the worst instant
  RigidTransform heads;             ///< from the tool's frame: where the heads are then
  std::optional<std::size_t> head;  ///< the head that gouges or is buried; none where the tool does
  Vec3 at = Vec3::Zero();    ///< witness; of what is buried a point inside: the middle of the cutter, a head's core
  bool has_witness = false;  ///< what is buried has none
  Witness witness;
  double depth_mm = 0;
};

/// Gouges and buried tools, the deepest first (buried ones last, they have no depth), at most `most`. Of
/// findings of one tool and body close beside each other (5 % of the parts' size) only the deepest is taken.
[[nodiscard]] std::vector<PictureEvent> worst_events(const CheckedToolpath& input, std::size_t most);

}  // namespace gouge
