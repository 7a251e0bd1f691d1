#pragma once

#include <optional>
#include <vector>

#include "lib/motion/tool_interval.h"
#include "lib/overcut/swept_solid.h"
#include "lib/tool/compiled_tool.h"
#include "lib/tool/convex_cover.h"
#include "lib/tool/inscribed_balls.h"

namespace gouge {

/// A bound of the reach of a tool below a surface that is nowhere deeper in the tool than `depth_mm`. A point outside
/// of the sharp zones that is farther below the surface than `slack_mm` is within that depth, plus the slack, of a
/// surface point. That surface point is as deep in the tool as the point is below the surface, less the slack.
/// Proof: docs/method/overcut.md, section 2.
struct RoundedReach {
  double depth_mm = 0, slack_mm = 0;
  const std::vector<Box2>* sharp_zones = nullptr;  ///< boxes of the tool's half plane (inscribed_balls.h)
  const ConvexCover* cover = nullptr;              ///< of the tool
};

/// A tool during one motion.
class SweptTool : public SweptSolid {
 public:
  /// Prepares the tool. Requires a tool with elements, which must outlive it. Without `rounded`, the whole tool counts
  /// as sharp.
  SweptTool(const Motion& motion, const CompiledTool& tool, std::optional<RoundedReach> rounded = std::nullopt)
      : SweptSolid(motion), tool_(tool), intervals_(motion, motion), rounded_(rounded) {}

  [[nodiscard]] double distance_at(const Vec3& point_part, double t) const override;
  [[nodiscard]] Vec3 outward_at(const Vec3& point_part, double t) const override;
  [[nodiscard]] std::uint32_t segments() const override { return intervals_.segments(); }
  std::uint32_t halve(std::uint32_t interval) override { return intervals_.halve(interval); }
  /// Bounds to first order, by planes that support the tool (SupportRange).
  [[nodiscard]] SweptBound bound(const Vec3& centre, double radius_mm, std::uint32_t interval) const override;
  [[nodiscard]] std::optional<DriftingHalfSpace> half_space(const Vec3& point, double s, const Vec3& centre,
                                                            double radius_mm, std::uint32_t interval) const override;
  [[nodiscard]] std::vector<Box3> extents(const Eigen::Matrix3d& frame, std::uint32_t interval,
                                          bool is_sharp_only) const override;
  [[nodiscard]] std::vector<Box3> pieces(const Eigen::Matrix3d& frame, std::uint32_t interval,
                                         std::size_t zone) const override;
  [[nodiscard]] double rounded_bound_mm() const override;
  [[nodiscard]] std::vector<Box3> deep_extents(const Eigen::Matrix3d& frame, const Surface& part,
                                               double depth_mm) const override;

 private:
  [[nodiscard]] Box3 extent(const Eigen::Matrix3d& frame, std::uint32_t index, const Box2& ring) const;
  [[nodiscard]] Box3 extent_of_arc(const Eigen::Matrix3d& frame, std::uint32_t index, const Box2& ring,
                                   int piece) const;

  const CompiledTool& tool_;
  ToolIntervals intervals_;
  std::optional<RoundedReach> rounded_;
};

}  // namespace gouge
