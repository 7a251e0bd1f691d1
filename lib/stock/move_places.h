#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lib/motion/motion.h"
#include "lib/stock/contour_hulls.h"
#include "lib/stock/hull_region.h"
#include "lib/tool/compiled_tool.h"

namespace gouge {

/// Returns the unit direction in which the distance of a point from a tool at a pose grows.
[[nodiscard]] Vec3 outward_of(const CompiledTool& tool, const Pose& pose, const Vec3& point);

/// The places of a tool on one segment of a motion.
class MovePlaces {
 public:
  /// Straight over [0, 1], with a fixed axis.
  MovePlaces(const Pose& from, const Vec3& to) : from_(from), by_(to - from.tip) {}
  MovePlaces(Motion motion, std::uint32_t segment) : motion_(std::move(motion)), segment_(segment) {}

  [[nodiscard]] Pose at(double t) const {
    return motion_ ? Pose{motion_->tip_at(t, segment_), motion_->at(t).axis} : Pose{from_.tip + t * by_, from_.axis};
  }
  /// Bounds the way during [a, b] of a point of the tool that is at `point` at a.
  [[nodiscard]] double way_mm(double a, double b, const Vec3& point) const;
  /// Returns the least signed distance of a point that a search of [a, b] finds, and its instant. It gives up where no
  /// distance can be below `most_mm`.
  struct Nearest {
    double distance_mm = 0, t = 0;
  };
  [[nodiscard]] std::optional<Nearest> nearest(const CompiledTool& tool, double a, double b, const Vec3& point,
                                               double most_mm) const;
  /// Proves that no point within `slack_mm` of a region is in the tool during [a, b], by planes between them. `away` is a
  /// direction from the tool to the region that is tried first, or zero; it becomes the one that separated them.
  [[nodiscard]] bool is_apart(const CompiledTool& tool, const std::vector<ContourHull>& hulls, double a, double b,
                              const HullRegion& region, double slack_mm, Vec3& away) const;

 private:
  /// A region whose distance from the tool is asked for, with a ball about it.
  struct Asked {
    const CompiledTool& tool;
    const std::vector<ContourHull>& hulls;
    const HullRegion& region;
    Vec3 middle = Vec3::Zero();
    double ball_mm = 0, slack_mm = 0;
  };
  /// The tool at the ends of an interval, and how far it may be off its chord between them.
  struct Swept {
    Pose first, last;
    double axis_off = 0, tip_off_mm = 0;
  };
  [[nodiscard]] bool is_apart(const Asked& asked, double a, double b, int halvings, Vec3& away) const;
  [[nodiscard]] Swept swept(double a, double b) const;

  Pose from_;
  Vec3 by_ = Vec3::Zero();
  std::optional<Motion> motion_;
  std::uint32_t segment_ = 0;
};

}  // namespace gouge
