#pragma once

#include <deque>
#include <optional>

#include "lib/base/tolerance.h"
#include "lib/geom/pose.h"
#include "postproc/cldata/interpreting/motion_records.h"
#include "postproc/cldata/interpreting/statement_context.h"

namespace gouge {

inline constexpr double kFrameError =
    Tolerance::kUnitVectorError;  ///< error of length or of a right angle; a frame with a larger error is refused
inline constexpr double kIdentityError =
    Tolerance::kSameDirection;  ///< rounding: matrices are written with at least 5 decimals

/// The unit and the frame of positions. Both hold until the file states others.
class FrameState {
 public:
  FrameState(StatementContext& in, double mm_per_unit) : in_(in), mm_per_unit_(mm_per_unit) {}

  [[nodiscard]] double mm_per_unit() const { return mm_per_unit_; }
  /// Sets the unit of the file. Returns whether it is the first time.
  [[nodiscard]] bool state_unit(double mm_per_unit);
  [[nodiscard]] const RigidTransform& to_part() const { return to_part_; }
  [[nodiscard]] Pose to_local(const Pose& pose) const { return to_part_.inverse().pose(pose); }
  /// Sets the frame. Returns whether it is another one.
  bool set(const RigidTransform& to_part);
  void begin_block();
  /// Returns the line of the last frame that is not that of the part; 0: none.
  [[nodiscard]] std::size_t line() const { return line_; }
  /// Returns whether a frame of the file turns X, Y and Z.
  [[nodiscard]] bool has_turned() const { return has_turned_; }

  /// Returns the tip at argument `first`, in mm and in the frame; nothing after an error.
  [[nodiscard]] std::optional<Vec3> read_tip(std::size_t first);
  /// Makes a frame from the numbers at `origin`, `x` and `y`, and `z` if the file has it. Returns nothing after an
  /// error, which names `what`. Each component of an axis may have an error of `rounding`.
  [[nodiscard]] std::optional<RigidTransform> make(const Vec3& origin, const Vec3& x, const Vec3& y,
                                                   const std::optional<Vec3>& z, double rounding, const char* what);
  /// Returns whether axes of the last make() deviated from unit length or right angles by more than rounding. Then
  /// positions may be scaled.
  [[nodiscard]] bool is_skewed() const { return is_skewed_; }
  /// Notes a CSYS. It is not applied, because Creo writes positions in the coordinate system of the machine.
  void note_csys() { csys_.add(in_.line()); }
  void write_note() const;
  /// Appends the frame in force to `frames` unless it is already there, and returns it.
  [[nodiscard]] const MotionFrame* record(std::deque<MotionFrame>& frames);

 private:
  StatementContext& in_;
  double mm_per_unit_;
  bool is_unit_stated_ = false;
  RigidTransform to_part_;
  bool is_recorded_ = false;
  std::size_t line_ = 0;
  bool has_turned_ = false;
  bool is_skewed_ = false;
  Tally csys_;
};

}  // namespace gouge
