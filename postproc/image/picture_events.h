#pragma once

#include <optional>
#include <vector>

#include "lib/field/checked_toolpath.h"
#include "lib/geom/pose.h"

// Input for the choice of view directions: no picture need be drawn to know its content.

namespace gouge {

/// Number of findings with a picture in a report.
inline constexpr std::size_t kEventsOfReport = 6;

/// A finding as the pictures number it: 1 is the worst.
struct PictureEvent {
  int number = 0;
  Event event;
  Pose pose;                        ///< of the tool at the worst instant
  RigidTransform heads;             ///< from the tool's frame: where the heads are then
  std::optional<std::size_t> head;  ///< the head that gouges or is buried; none where the tool does
  Vec3 at = Vec3::Zero();           ///< witness; buried: a point inside, the middle of the cutter, a head's core
  bool has_witness = false;         ///< a buried tool has none
  Witness witness;
  double depth_mm = 0;
};

/// Returns gouges and buried tools, the deepest first, at most `most`. Buried ones are last, as they have no depth. Of
/// findings of one tool and body close beside each other (5 % of the parts' size) only the deepest is taken.
[[nodiscard]] std::vector<PictureEvent> worst_events(const CheckedToolpath& input, std::size_t most);

/// The deepest point of a gouging move.
struct GougeWitness {
  Vec3 at = Vec3::Zero();
  Vec3 normal = Vec3::UnitZ();  ///< unit, out of the tool's depth
  double weight = 0;            ///< about the area that the move gouges, without a unit
};

/// Returns the witnesses of a path, in its order. Of more than `most` they are taken at equal steps.
[[nodiscard]] std::vector<GougeWitness> gouge_witnesses(const CheckedToolpath& input, std::size_t most);

/// Returns whether a point is visible to a viewer far away in direction `toward` (unit). No part or fixture may lie
/// between, farther than `clear_mm` from the point. Cost: about O(log n).
[[nodiscard]] bool is_in_sight(const CheckedToolpath& input, const Vec3& point, const Vec3& toward, double clear_mm);

}  // namespace gouge
