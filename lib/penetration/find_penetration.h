#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lib/geom/pose.h"
#include "lib/penetration/contact.h"
#include "lib/penetration/depth_body.h"
#include "lib/penetration/narrow_phase.h"
#include "lib/penetration/point_body.h"
#include "lib/penetration/turned_axes.h"

namespace gouge {

struct PenetrationOptions {
  std::uint32_t body = 0;          ///< index that contacts report
  bool is_deeper_reported = true;  ///< also search for inside points beyond the depth of the volumes
};

struct PointContact {
  Contact contact;
  std::uint32_t point = 0;  ///< index among the points from which the moving body was built
  /// True if the point is deeper than D, the depth of the volumes. The contact still has the depth and normal of the
  /// nearest surface.
  bool is_deeper = false;
};

struct PenetrationResult {
  std::vector<PointContact> contacts;  ///< in the order of the points
  PenetrationCounters counters;
};

/// A finder of the points of a moving body inside a stationary one, each with its depth and its exit direction.
///
/// Keeps its working memory, and the turned volumes as long as the rotation stays the same: then a pose costs only a
/// shift of them (thesis 6.1.4.2). A finder serves one thread; bodies may be shared.
///
/// Requires both trees over the same directions. The sides are meaningful only if `body.is_solid()`.
/// Ensures  With complete coverage every point inside is reported, with the depth and direction of its nearest surface.
///          No point outside is reported.
/// Source   Thesis 5.2.1 (broad phase), 5.2.2 (narrow phase), 5.2.3 (only visited volumes are updated).
class PenetrationFinder {
 public:
  PenetrationFinder(const DepthBody& body, const PointBody& points, const PenetrationOptions& options = {});

  /// Finds the contacts at a pose. `pose` maps the moving body's frame to part coordinates. The result stays valid
  /// until the next call.
  const PenetrationResult& find(const RigidTransform& pose);

 private:
  struct List {
    std::size_t first = 0, last = 0;  ///< range of slots in stack_
    [[nodiscard]] bool is_empty() const { return first == last; }
  };

  void visit(std::uint32_t node, const List& candidates);
  void visit_leaf(std::uint32_t node, const List& candidates);
  List refine(const float* volume, float size, const List& candidates, std::size_t most);
  void update_volume(std::uint32_t node, float* volume);
  void bound_points(std::uint32_t node, float* volume);
  void report_lump(std::uint32_t node);
  void test_points(std::uint32_t node);
  [[nodiscard]] std::size_t items_of(const List& list) const;
  void search_points(std::uint32_t node);
  void report(std::uint32_t point, const Vec3& position, const Vec3& normal, double depth_mm, std::uint32_t triangle);
  void report_if_deep(std::uint32_t point, const Vec3& position);

  const DepthBody& body_;
  const PointBody& points_;
  PenetrationOptions options_;
  NarrowPhase narrow_;
  PenetrationResult result_;
  RigidTransform pose_;
  bool has_turned_ = false;
  std::size_t stride_ = 0;
  float slack_ = 0;  ///< rounding of single precision at this pose
  TurnedAxes axes_;
  std::vector<float> shifts_;           ///< projections of the pose's shift
  std::vector<float> turned_;           ///< by node: intervals before the shift
  std::vector<std::uint32_t> turn_of_;  ///< by node: number of the rotation of its intervals
  std::uint32_t turn_ = 0;
  std::vector<std::uint32_t> stack_, pending_;
  std::vector<float> volume_;  ///< volume of the current node on each level of the moving tree
};

}  // namespace gouge
