#pragma once

#include <array>
#include <optional>
#include <variant>
#include <vector>

#include "lib/geom/pose.h"
#include "lib/path/toolpath.h"
#include "lib/verify/bounds.h"
#include "lib/verify/chain_bounds.h"

// A motion as pieces of time that can be halved. Each piece has proved bounds of the poses at its two ends, and of the
// distance of the pose from the chord between them. Square roots are sufficient to halve a turn: the axis in the middle
// is the normalised sum of the axes at the ends (docs/method/verify.md, "Poses").

namespace gouge {

/// The joints of a machine on a move, and their angles at its ends.
struct ChainMotion {
  const ClaimedJoints* joints = nullptr;
  ClaimedRun run = ClaimedRun::rotary;  ///< not on_circle
  RotaryAngles from{}, to{};
};

/// One piece of time of a motion.
class MotionPiece {
 public:
  /// Makes the straight motion between two poses, or a pose at rest.
  MotionPiece(const PoseBounds& from, const PoseBounds& to);

  [[nodiscard]] const PoseBounds& start() const { return ends_[0]; }
  [[nodiscard]] const PoseBounds& end() const { return ends_[1]; }
  /// Returns a bound of the distance of the tip from the point of its chord at the same instant.
  [[nodiscard]] double sag_mm() const { return sag_; }
  /// Returns a bound of the distance of the axis from the axis of its chord.
  [[nodiscard]] double bend() const { return bend_; }
  [[nodiscard]] std::array<MotionPiece, 2> halves() const;

 private:
  friend std::optional<std::vector<MotionPiece>> motion_pieces(const Toolpath& path, std::size_t move, bool is_dogleg);
  friend std::optional<std::vector<MotionPiece>> motion_pieces(const Toolpath& path, std::size_t move,
                                                               const ChainMotion& chain);

  /// A part of a circle or helix: center + radius radial + height axis + rest. All values but `radial` change evenly
  /// with time.
  struct Turn {
    Bounds3 center, axis;
    std::array<Bounds3, 2> radial, rest;
    std::array<Bounds, 2> radius, height;
    double angle = 0;  ///< at least the angle between both radials; at most slightly more than a quarter of a circle
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
  /// The motion along the curve of a move; nothing where it has none that is understood.
  static std::optional<std::vector<MotionPiece>> along_curve(const Toolpath& path, const Move& move,
                                                             const PoseBounds& from, const PoseBounds& to);
  /// Lets the joints carry the axis, and the tip where they move it.
  void run_by(const ChainSpan& span);

  std::array<PoseBounds, 2> ends_;
  std::variant<std::monostate, Turn, Bezier> curve_;
  std::optional<ChainSpan> chain_;
  double sag_ = 0, bend_ = 0;
};

/// Returns the pieces that make up a whole move, including the path to a linked position. Returns nothing if the axis
/// turns by half a circle, if a number is not finite, or if a curve has an unrealistic number of turns.
/// Requires  RoundsUpward.
[[nodiscard]] std::optional<std::vector<MotionPiece>> motion_pieces(const Toolpath& path, std::size_t move,
                                                                    bool is_dogleg);

/// Returns the pieces of a move by the joints of a machine. Requires a move with a start. Nothing where a rate is not
/// known, and where the linear joints have no proved solution. `chain.joints` must outlive the pieces.
[[nodiscard]] std::optional<std::vector<MotionPiece>> motion_pieces(const Toolpath& path, std::size_t move,
                                                                    const ChainMotion& chain);

/// Returns the pose at t in [0, 1] of a move, computed directly from the file. It uses plain doubles and is exact to a
/// few 1e-14 of the coordinates.
[[nodiscard]] Pose pose_at(const Toolpath& path, std::size_t move, double t, bool is_dogleg);

}  // namespace gouge
