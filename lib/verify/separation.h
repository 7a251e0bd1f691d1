#pragma once

#include <array>
#include <vector>

#include "lib/verify/bounds.h"
#include "lib/verify/moving_pose.h"
#include "lib/verify/tool_contour.h"
#include "lib/verify/triangle_order.h"

// The only lemma of a certificate: a plane separates a part of the tool from a part of the surface, up to the allowed
// depth. docs/method/verify.md states and proves it.

namespace gouge {

enum class PatchShape : std::uint8_t { triangle, node, block };

/// A triangle or a part of one, all triangles of a node, or a block of space.
struct SurfacePatch {
  PatchShape shape = PatchShape::triangle;
  std::array<Vec3, 3> corners{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};  ///< of a triangle
  std::array<Vec3, 3> arms{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};     ///< of a block: its points are center plus
                                                                          ///< each arm by a factor in [-1, 1]
  Vec3 center = Vec3::Zero(), half = Vec3::Zero();                        ///< of a node: all corners are within center
                                                                          ///< +- half
  Vec3 into = Vec3::Zero();                                               ///< normal into the solid; zero: unknown
  double least = 0;                                                       ///< of a node: minimum of into . p
  double radius_mm = 0;                                                   ///< maximum distance of its points from the
                                                                          ///< centre
};
[[nodiscard]] SurfacePatch triangle_patch(const std::array<Vec3, 3>& corners);
[[nodiscard]] SurfacePatch node_patch(const TriangleOrder& order, const TriangleOrder::Node& node);

/// A span of time. Between its poses the tool moves along chords, up to a sag and a bend.
struct TimeSpan {
  std::vector<PoseBounds> poses;  ///< one pose that contains all of them, or the poses at which pieces meet
  double sag_mm = 0, bend = 0;
  double twist_mm = 0;  ///< maximum of |chord of the tip| |chord of the axis| / 4 over the pieces
  double path_mm = 0;   ///< maximum distance of a tip from the tip of the first pose
  double swing = 0;     ///< maximum distance of an axis from the axis of the first pose
  Pose middle;          ///< approximate; planes are chosen there
};
/// Returns the poses of consecutive pieces of a motion. More than a few poses become one pose with wider bounds.
[[nodiscard]] TimeSpan span_of(const MotionPiece* first, const MotionPiece* last);

/// Heights of a patch in the tool, at all instants of a span.
struct PatchHeights {
  double low_mm = 0, high_mm = 0;
  double reach_mm = 0;  ///< largest distance from the tip, at the poses of the span
};
/// Requires RoundsUpward.
[[nodiscard]] PatchHeights heights_of(const SurfacePatch& patch, const TimeSpan& span);

/// Methods to choose a plane, or to bound the depth otherwise. The numbers are those of docs/formats/certificate.md.
enum class ProofKind : std::uint8_t {
  own_plane = 2,      ///< the plane along the surface itself, normal to `into`
  center_plane = 3,   ///< perpendicular to the shortest path between the patch's centre and the tool
  closest_plane = 4,  ///< perpendicular to the shortest path between a triangle and the tool
  own_ring = 5,       ///< the same three planes, for the part of the tool that is at least as far from the axis as the
                      ///< patch
  center_ring = 6,
  closest_ring = 7,
  exit_point = 8,  ///< all points of the patch are within the allowed depth of one point of the contour
};

class Separation {
 public:
  /// Proves depths of up to `max_mm`. It examines the part of the contour within that distance of any point of a patch.
  Separation(const ToolContour& tool, double max_mm) : tool_(tool), max_mm_(max_mm) {}

  /// Selects the patch and the span of the next queries. Both must outlive these queries.
  void look_at(const SurfacePatch& patch, const TimeSpan& span);
  /// Returns whether it is proved that all points of the patch are at most `depth_mm` deep in the tool during the span.
  /// Requires look_at, depth_mm <= max_mm, RoundsUpward.
  [[nodiscard]] bool holds(ProofKind kind, double depth_mm);

  /// Returns, for the last plane, the loss due to the size of the patch; time_loss_mm() is the loss due to the length
  /// of time.
  [[nodiscard]] double patch_loss_mm() const { return patch_loss_; }
  [[nodiscard]] double time_loss_mm() const { return time_loss_; }

 private:
  /// A piece of the contour, or a part of one, that may matter. It may be larger than that part.
  struct Reach {
    Bounds r0, z0, r1, z1;  ///< ends of a line; corners of a box around an arc
    const ToolContour::Piece* arc = nullptr;
  };

  [[nodiscard]] Vec3 direction(ProofKind kind);
  [[nodiscard]] Vec3 away_from(const Vec3& point) const;
  void bound_radii();
  void clip(bool is_ring);
  [[nodiscard]] Bounds support(const Bounds& out, const Bounds& up) const;
  [[nodiscard]] bool is_separated_by(const Vec3& n, double depth_mm, bool is_ring);
  [[nodiscard]] bool is_near_exit_point(double depth_mm);

  const ToolContour& tool_;
  double max_mm_;
  const SurfacePatch* patch_ = nullptr;
  const TimeSpan* span_ = nullptr;
  double z_lo_ = 0, z_hi_ = 0, r_lo_ = 0, r_hi_ = 0;  // of the patch, in the frame of the tool
  double reach_mm_ = 0;                               // maximum distance of the patch from the tip
  std::vector<Reach> reaches_;
  bool is_clipped_ = false, is_clipped_ring_ = false;  // `reaches_` are for this patch, with all of the tool or with
                                                       // its ring
  double longest_mm_ = 0;                              // maximum distance of `reaches_` from the tip
  double patch_loss_ = 0, time_loss_ = 0;
};

}  // namespace gouge
