#pragma once

#include <array>
#include <optional>
#include <variant>
#include <vector>

#include "lib/geom/pose.h"
#include "lib/path/toolpath.h"
#include "lib/verify/bounds.h"
#include "lib/verify/chain_bounds.h"

// A motion as pieces of time that can be halved, each with proven bounds of the pose at its two ends and of
// how far the pose is from the chord between them. Nothing but square roots is needed to halve a turn: the
// axis in the middle is the normalised sum of the axes at the ends. docs/method/verify.md, "Poses".

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
  /// The straight motion between two poses, or a pose at rest.
  MotionPiece(const PoseBounds& from, const PoseBounds& to);

  [[nodiscard]] const PoseBounds& start() const { return ends_[0]; }
  [[nodiscard]] const PoseBounds& end() const { return ends_[1]; }
  /// At every instant the tip is no farther than this from the point of the chord of the same instant ...
  [[nodiscard]] double sag_mm() const { return sag_; }
  /// ... and the axis no farther than this from its chord's.
  [[nodiscard]] double bend() const { return bend_; }
  [[nodiscard]] std::array<MotionPiece, 2> halves() const;

 private:
  friend std::optional<std::vector<MotionPiece>> motion_pieces(const Toolpath& path, std::size_t move, bool is_dogleg);
  friend std::optional<std::vector<MotionPiece>> motion_pieces(const Toolpath& path, std::size_t move,
                                                               const ChainMotion& chain);

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

/// The pieces that make up all of a move, the way to a linked position included. Nothing where the axis turns
/// by half a circle, where a curve has more turns than any tool makes, or where a number is not finite.
/// Requires  RoundsUpward.
[[nodiscard]] std::optional<std::vector<MotionPiece>> motion_pieces(const Toolpath& path, std::size_t move,
                                                                    bool is_dogleg);

/// The same by the joints of a machine. Requires a move with a start. Nothing where a rate is not known, and where the
/// linear joints have no proved solution. `chain.joints` must outlive the pieces.
[[nodiscard]] std::optional<std::vector<MotionPiece>> motion_pieces(const Toolpath& path, std::size_t move,
                                                                    const ChainMotion& chain);

/// The pose at t in [0, 1] of a move, as anyone would compute it from the file: plain doubles, a few 1e-14 of
/// the coordinates.
[[nodiscard]] Pose pose_at(const Toolpath& path, std::size_t move, double t, bool is_dogleg);

}  // namespace gouge
