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
  std::uint32_t body = 0;          ///< reported in the contacts
  bool is_deeper_reported = true;  ///< also look for points inside beyond the depth of the volumes
};

struct PointContact {
  Contact contact;
  std::uint32_t point = 0;  ///< index among the points the moving body was built from
  /// Deeper than D, the depth of the volumes. The contact's depth and normal are still those of the nearest
  /// surface.
  bool is_deeper = false;
};

struct PenetrationResult {
  std::vector<PointContact> contacts;  ///< ordered by point
  PenetrationCounters counters;
};

/// Finds the points of a moving body inside a standing one, each with its depth and its way out.
///
/// Keeps its working memory, and the turned volumes as long as the rotation stays the same: then a pose costs
/// only their shift (thesis 6.1.4.2). One finder serves one thread; bodies may be shared.
///
/// Requires both trees over the same directions; `body.is_solid()` for the sides to mean something.
/// Ensures  With complete coverage: every point inside is reported, with the depth and direction of its nearest
///          surface; no point outside is.
/// Source   Thesis 5.2.1 (broad phase), 5.2.2 (narrow phase), 5.2.3 (only what is visited is updated).
class PenetrationFinder {
 public:
  PenetrationFinder(const DepthBody& body, const PointBody& points, const PenetrationOptions& options = {});

  /// The result stays valid until the next call. `pose` takes the moving body's frame to part coordinates.
  const PenetrationResult& find(const RigidTransform& pose);

 private:
  struct List {
    std::size_t first = 0, last = 0;  ///< slots in stack_
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
  float slack_ = 0;  ///< error of single precision at this pose
  TurnedAxes axes_;
  std::vector<float> shifts_;           ///< projections of the pose's shift
  std::vector<float> turned_;           ///< by node: intervals before the shift
  std::vector<std::uint32_t> turn_of_;  ///< by node: rotation its intervals belong to
  std::uint32_t turn_ = 0;
  std::vector<std::uint32_t> stack_, pending_;
  std::vector<float> volume_;  ///< of the node on each level of the moving tree
};

}  // namespace gouge
