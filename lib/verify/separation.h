#pragma once

#include <array>
#include <vector>

#include "lib/verify/bounds.h"
#include "lib/verify/moving_pose.h"
#include "lib/verify/tool_contour.h"
#include "lib/verify/triangle_order.h"

// The one lemma of a certificate: a plane separates a part of the tool from a part of the surface, except for the
// allowed depth. The page docs/method/verify.md states and proves it.

namespace gouge {

/// A triangle, a piece of one, or all triangles of a node.
struct SurfacePatch {
  bool is_triangle = true;
  std::array<Vec3, 3> corners{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};  ///< of a triangle
  Vec3 center = Vec3::Zero(), half = Vec3::Zero();                        ///< of a node: within center +- half
  Vec3 into = Vec3::Zero();                                               ///< normal into the solid; zero: none
  double least = 0;                                                       ///< of a node: into . p is nowhere smaller
  double radius_mm = 0;                                                   ///< no point is farther from the centre
};
[[nodiscard]] SurfacePatch triangle_patch(const std::array<Vec3, 3>& corners);
[[nodiscard]] SurfacePatch node_patch(const TriangleOrder& order, const TriangleOrder::Node& node);

/// A span of time: poses between which the tool moves along chords, but for a sag and a bend.
struct TimeSpan {
  std::vector<PoseBounds> poses;  ///< one that holds all of them, or those in which pieces meet
  double sag_mm = 0, bend = 0;
  double twist_mm = 0;  ///< the largest |chord of the tip| |chord of the axis| / 4 of a piece
  double path_mm = 0;   ///< no tip is farther from that of the first pose ...
  double swing = 0;     ///< ... nor axis from its
  Pose middle;          ///< about; where planes are looked for
};
/// Poses of consecutive pieces of a motion. More than a few of them are one pose, known less closely.
[[nodiscard]] TimeSpan span_of(const MotionPiece* first, const MotionPiece* last);

/// Ways to choose a plane, or to bound the depth otherwise. The numbers are those of
/// docs/formats/certificate.md.
enum class ProofKind : std::uint8_t {
  own_plane = 2,      ///< the surface's own
  center_plane = 3,   ///< across the way from the patch's centre to the tool
  closest_plane = 4,  ///< across the shortest way between a triangle and the tool
  own_ring = 5,       ///< the same three, of the tool only what is no nearer to the axis than the patch
  center_ring = 6,
  closest_ring = 7,
  exit_point = 8,  ///< no point of the patch is farther than that from one point of the contour
};

class Separation {
 public:
  /// Proves depths of up to `max_mm`. It examines the part of the contour that is that far or less from any point of a
  /// patch.
  Separation(const ToolContour& tool, double max_mm) : tool_(tool), max_mm_(max_mm) {}

  /// Selects the patch and the span of the next queries; both must stay where they are.
  void look_at(const SurfacePatch& patch, const TimeSpan& span);
  /// Returns whether it is proved that no point of the patch is deeper in the tool than `depth_mm` at any instant of
  /// the span. Requires look_at, depth_mm <= max_mm, RoundsUpward.
  [[nodiscard]] bool holds(ProofKind kind, double depth_mm);

  /// Returns, for the last plane, the shares of the shortfall that are due to the patch and to the time.
  [[nodiscard]] double patch_loss_mm() const { return patch_loss_; }
  [[nodiscard]] double time_loss_mm() const { return time_loss_; }

 private:
  /// A piece of the contour, or a part of one, that may matter. It may include more than there is.
  struct Reach {
    Bounds r0, z0, r1, z1;  ///< ends of a line; corners of a box around an arc
    const ToolContour::Piece* arc = nullptr;
  };

  [[nodiscard]] Vec3 direction(ProofKind kind);
  [[nodiscard]] Vec3 away_from(const Vec3& point) const;
  void bound_heights();
  void bound_radii();
  void clip(bool is_ring);
  [[nodiscard]] Bounds support(const Bounds& out, const Bounds& up) const;
  [[nodiscard]] bool is_separated_by(const Vec3& n, double depth_mm, bool is_ring);
  [[nodiscard]] bool is_near_exit_point(double depth_mm);

  const ToolContour& tool_;
  double max_mm_;
  const SurfacePatch* patch_ = nullptr;
  const TimeSpan* span_ = nullptr;
  double z_lo_ = 0, z_hi_ = 0, r_lo_ = 0, r_hi_ = 0;  // of the patch, as seen from the tool
  double reach_mm_ = 0;                               // no point of the patch is farther from the tip
  std::vector<Reach> reaches_;
  bool is_clipped_ = false, is_clipped_ring_ = false;  // `reaches_` are those of the patch, of all or of its ring
  double longest_mm_ = 0;                              // no point of `reaches_` is farther from the tip
  double patch_loss_ = 0, time_loss_ = 0;
};

}  // namespace gouge
