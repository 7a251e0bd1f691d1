#pragma once

#include <cstdint>
#include <optional>

#include "lib/motion/body_motion.h"
#include "lib/motion/departure.h"
#include "lib/motion/motion.h"
#include "lib/motion/motion_interval.h"
#include "lib/stock/tool_piece.h"

namespace gouge {

/// Directions of the tool and its tip at one instant.
struct ToolPlace {
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  Vec3 tip = Vec3::Zero();
  [[nodiscard]] Vec3 of(const Vec3& in_tool) const { return axes * in_tool + tip; }
};

/// Places the pieces of a tool in the space of the part, at the ends of time intervals of one motion. It keeps the facts of
/// the last interval, as a search asks for many pieces in each. The motion must outlive it.
class PiecePlacer {
 public:
  /// Pieces that stay within `resolution_mm` of one point are placed as that point. `is_of_head`: the pieces turn about the
  /// tool axis as a body does that is no solid of revolution (BodyMotion).
  PiecePlacer(const Motion& motion, const Departure& departure, double resolution_mm, bool is_of_head = false)
      : motion_(motion), departure_(departure), resolution_mm_(resolution_mm) {
    if (is_of_head) of_head_.emplace(motion);
  }

  [[nodiscard]] ToolPlace place_at(double t, std::uint32_t segment) const;
  /// Bounds the length of the way of every point of the piece.
  [[nodiscard]] double way_mm(const ToolPiece& piece, const MotionInterval& interval);
  [[nodiscard]] SweptPiece swept_by(const ToolPiece& piece, const MotionInterval& interval);

 private:
  /// Facts of the motion in an interval.
  struct Stretch {
    MotionInterval interval;
    double length_mm = 0, turn_rad = 0;
  };
  /// Both ends of a stretch, and how far the motion departs from the straight way between them.
  struct Ends {
    ToolPlace start, end;
    double tip_sag_mm = 0, axis_sag_rad = 0;
  };

  void enter(const MotionInterval& interval);
  [[nodiscard]] MotionRates rates_of(const MotionInterval& interval) const;
  [[nodiscard]] const Ends& ends();

  const Motion& motion_;
  std::optional<BodyMotion> of_head_;
  Departure departure_;
  double resolution_mm_;
  std::optional<Stretch> last_;
  std::optional<Ends> ends_;  // of last_
};

}  // namespace gouge
