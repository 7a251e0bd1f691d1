#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "lib/motion/tool_interval.h"
#include "lib/overcut/swept_solid.h"
#include "lib/tool/compiled_tool.h"
#include "lib/tool/inscribed_balls.h"

namespace gouge {

/// A tool during one motion.
class SweptTool : public SweptSolid {
 public:
  /// Prepares the tool. Requires a tool with elements, which must outlive it. `sharp_zones` are those of the tool
  /// (inscribed_balls.h); if there are none, the whole tool counts as sharp.
  SweptTool(const Motion& motion, const CompiledTool& tool, std::optional<std::vector<Box2>> sharp_zones = std::nullopt)
      : SweptSolid(motion), tool_(tool), intervals_(motion, motion), sharp_zones_(std::move(sharp_zones)) {}

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

 private:
  [[nodiscard]] Box3 extent(const Eigen::Matrix3d& frame, std::uint32_t index, const Box2& ring) const;
  [[nodiscard]] Box3 extent_of_arc(const Eigen::Matrix3d& frame, std::uint32_t index, const Box2& ring,
                                   int piece) const;

  const CompiledTool& tool_;
  ToolIntervals intervals_;
  std::optional<std::vector<Box2>> sharp_zones_;
};

}  // namespace gouge
