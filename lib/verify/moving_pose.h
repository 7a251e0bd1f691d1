#pragma once

#include <array>
#include <optional>
#include <variant>
#include <vector>

#include "lib/geom/pose.h"
#include "lib/path/toolpath.h"
#include "lib/verify/bounds.h"

// A motion as pieces of time that can be halved. Each has proved bounds of the pose at its two ends, and of how far the
// pose is from the chord between them. Square roots suffice to halve a turn: the axis in the middle is the normalised
// sum of the axes at the ends. docs/method/verify.md, "Poses".

namespace gouge {

/// Pose of the tool at one instant, or at any of several.
struct PoseBounds {
  Bounds3 tip, axis;
};

/// One piece of time of a motion.
class MotionPiece {
 public:
  /// The straight motion between two poses, or a pose at rest.
  MotionPiece(const PoseBounds& from, const PoseBounds& to);

  [[nodiscard]] const PoseBounds& start() const { return ends_[0]; }
  [[nodiscard]] const PoseBounds& end() const { return ends_[1]; }
  /// Bounds the distance of the tip from the point of the chord of the same instant.
  [[nodiscard]] double sag_mm() const { return sag_; }
  /// Bounds the distance of the axis from that of its chord.
  [[nodiscard]] double bend() const { return bend_; }
  [[nodiscard]] std::array<MotionPiece, 2> halves() const;

 private:
  friend std::optional<std::vector<MotionPiece>> motion_pieces(const Toolpath& path, std::size_t move, bool is_dogleg);

  /// A stretch of a circle or helix: center + radius radial + height axis + rest, all but `radial` even in
  /// time.
  struct Turn {
    Bounds3 center, axis;
    std::array<Bounds3, 2> radial, rest;
    std::array<Bounds, 2> radius, height;
    double angle = 0;  ///< at least that between both radials; at most a quarter of a circle and a little
    [[nodiscard]] Bounds3 tip(std::size_t k) const {
      return center + radius[k] * radial[k] + height[k] * axis + rest[k];
    }
  };
  using Bezier = std::array<Bounds3, 4>;

  void bound_chord();
  static std::optional<std::vector<MotionPiece>> along_arc(const PoseBounds& from, const PoseBounds& to,
                                                           const PathArc& arc);
  static std::vector<MotionPiece> along_spline(const PoseBounds& from, const PoseBounds& to, const PathSpline& spline);
  static std::vector<MotionPiece> dogleg(const Pose& from, const Pose& to);

  std::array<PoseBounds, 2> ends_;
  std::variant<std::monostate, Turn, Bezier> curve_;
  double sag_ = 0, bend_ = 0;
};

/// Returns the pieces that make up all of a move, the way to a linked position included. Returns nothing where the axis
/// turns by half a circle, or where a number is not finite. Also where a curve has more turns than any tool makes.
/// Requires  RoundsUpward.
[[nodiscard]] std::optional<std::vector<MotionPiece>> motion_pieces(const Toolpath& path, std::size_t move,
                                                                    bool is_dogleg);

/// Returns the pose at t in [0, 1] of a move, as anyone would compute it from the file. It is in plain doubles, to a
/// few 1e-14 of the coordinates.
[[nodiscard]] Pose pose_at(const Toolpath& path, std::size_t move, double t, bool is_dogleg);

}  // namespace gouge
