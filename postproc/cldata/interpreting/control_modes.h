#pragma once

#include <optional>

#include "postproc/cldata/parsing/machine_text.h"

namespace gouge {

/// Modal codes of the control that a post-processor may write only where they change: the plane of arcs and cycles, the
/// meaning of arc centres, and the level to which cycles retract. Text for the control may set another code than the file
/// needs. The arcs and cycles behind it then have another meaning. Reasons are null, or why a motion is not checked.
class ControlModes {
 public:
  void take_plane(ControlPlane plane, const char* reason) {
    text_plane_ = plane == written_plane_ ? std::nullopt : std::optional(plane);
    plane_reason_ = reason;
  }
  void take_centres(bool are_absolute, const char* reason) { centre_reason_ = are_absolute ? reason : nullptr; }
  /// Takes G98 or G99. Before the first cycle, G98 is the state in which a control starts.
  void take_level(bool is_start_level, const char* reason) {
    level_reason_ = is_start_level && !has_cycle_ ? nullptr : reason;
  }

  /// Notes an arc in a plane; none: in no plane of the axes, or a curve that is no arc.
  [[nodiscard]] const char* note_arc(const std::optional<ControlPlane>& plane) {
    if (text_plane_ && plane && (*plane == *text_plane_ || *plane != written_plane_)) text_plane_.reset();
    if (!text_plane_ && plane) written_plane_ = *plane;
    return text_plane_ ? plane_reason_ : centre_reason_;
  }
  [[nodiscard]] const char* note_cycle() {
    has_cycle_ = true;
    return text_plane_ ? plane_reason_ : level_reason_;
  }

 private:
  ControlPlane written_plane_ = ControlPlane::xy;  // of the last arc
  std::optional<ControlPlane> text_plane_;         // where it differs
  bool has_cycle_ = false;
  const char* plane_reason_ = nullptr;
  const char* centre_reason_ = nullptr;
  const char* level_reason_ = nullptr;
};

}  // namespace gouge
