#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "lib/geom/pose.h"

namespace gouge {

/// The frame of a Klartext program within the preset, or within a tilted plane: a datum shift, then a rotation in the
/// plane of X and Y or a mirror image. Lengths in mm. A scale makes it unknown. A datum shift before a tilted plane moves
/// its origin, and one after it is within the plane.
/// Source   TNC 407 280 580, cycles 7, 8, 10 and 11; the order in which a manual combines them: datum shift, tilted plane,
///          rotation.
class KlartextFrame {
 public:
  /// Returns coordinates outside of this frame: of the preset or of the tilted plane. Unknown coordinates stay apart.
  [[nodiscard]] Vec3 outside(const Vec3& program) const;
  /// Returns coordinates of the program.
  [[nodiscard]] Vec3 inside(const Vec3& outside) const;
  /// Returns whether arcs turn the other way outside.
  [[nodiscard]] bool is_mirrored() const { return mirror_[0] != mirror_[1]; }

  /// Shifts one axis. A step refers to the shift in force.
  void shift(std::size_t axis, double value_mm, bool is_step);
  /// Begins a datum shift, and ends one before it.
  void begin_shift();
  /// Ends a datum shift, if one runs. An axis that it leaves out then has a shift that is not known, unless it is 0.
  void end_shift();
  [[nodiscard]] bool is_shifting() const { return is_shifting_; }
  /// Returns whether the datum shift that runs has stated an axis.
  [[nodiscard]] bool has_shifted(std::size_t axis) const { return named_.at(axis) || stepped_.at(axis); }
  void rotate(double degrees, bool is_step);
  /// Returns whether the rotation in force is known and has this angle.
  [[nodiscard]] bool is_rotated_by(double degrees) const {
    return open_.empty() && std::abs(rotation_deg_ - degrees) <= 0;
  }
  void mirror(bool x, bool y);
  void scale(double factor);
  /// Begins a tilted plane: the shift becomes its origin, which is returned.
  Vec3 begin_tilt();
  /// Ends it. The shift is that of its origin.
  void end_tilt();
  /// Ends all, as a new preset does.
  void reset() { *this = {}; }
  /// Makes the frame unknown until a datum shift states all axes in a frame without rotation, mirror image and tilt.
  void lose(const std::string& reason);

  /// Returns why the frame is not known; empty: it is.
  [[nodiscard]] const std::string& open() const { return open_; }

 private:
  /// Returns whether a rotation, mirror image or scale is in force.
  [[nodiscard]] bool is_turned() const;
  void combine(const char* what);

  Vec3 shift_ = Vec3::Zero(), tilt_origin_ = Vec3::Zero();
  double rotation_deg_ = 0;
  std::array<bool, 2> mirror_{};
  std::array<bool, 3> named_{}, stepped_{};  // by the datum shift that runs: as absolute values, and as steps
  bool is_tilted_ = false, is_shifting_ = false, is_scaled_ = false;
  std::string open_;
};

}  // namespace gouge
