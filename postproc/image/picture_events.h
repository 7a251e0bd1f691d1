#pragma once

#include <optional>
#include <vector>

#include "lib/field/checked_toolpath.h"
#include "lib/geom/pose.h"

// Data from which view directions are chosen, so that no picture need be drawn for the choice.

namespace gouge {

/// Number of findings with a picture in a report.
inline constexpr std::size_t kEventsOfReport = 6;

/// A finding with its rank among those with a picture, 1 being the worst, and its number (finding_numbers).
struct PictureEvent {
  int rank = 0;
  std::size_t number = 0;
  Event event;
  Pose pose;                        ///< pose of the tool at the worst instant
  RigidTransform heads;             ///< from the tool's frame to the place of the heads at that instant
  std::optional<std::size_t> head;  ///< the head that gouges or is buried; none if it is the tool
  /// the witness; for a buried body a point inside: the middle of the cutter, or a head's core
  Vec3 at = Vec3::Zero();
  bool has_witness = false;  ///< a buried tool has none
  Witness witness;
  double depth_mm = 0;
};

/// Returns at most `most` gouges and buried tools, the deepest first. Buried ones are last, because they have no depth.
/// Leaves out a finding near a deeper one (5 % of the parts' size) with the same tool and body.
[[nodiscard]] std::vector<PictureEvent> worst_events(const CheckedToolpath& input, std::size_t most);

/// The deepest point of a gouging move.
struct GougeWitness {
  Vec3 at = Vec3::Zero();
  Vec3 normal = Vec3::UnitZ();  ///< of unit length, out of the tool's depth
  double weight = 0;            ///< about the area that the move gouges, without a unit
};

/// Returns the witnesses of a path, in its order. If there are more than `most`, they are taken at equal steps.
[[nodiscard]] std::vector<GougeWitness> gouge_witnesses(const CheckedToolpath& input, std::size_t most);

/// Returns whether a point is visible for a viewer far away in direction `toward` (unit). No part or fixture may lie
/// between them, except within `clear_mm` of the point. Cost: about O(log n).
[[nodiscard]] bool is_in_sight(const CheckedToolpath& input, const Vec3& point, const Vec3& toward, double clear_mm);

}  // namespace gouge
