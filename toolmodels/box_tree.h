#pragma once

#include <vector>

#include "toolmodels/profile.h"

namespace gouge::detail {

/// Returns a box that contains the element, enlarged on each side by `margin_mm`.
[[nodiscard]] Eigen::AlignedBox2d box_around(const ProfileElement& element, double margin_mm);

/// A tree that finds which of many boxes meet a given box. Neighbours in the list are paired, so a search is quick for
/// boxes along a contour. Its number of steps is about the number of boxes that are met, times the logarithm of all.
class BoxTree {
 public:
  explicit BoxTree(const std::vector<Eigen::AlignedBox2d>& boxes);

  /// Calls visit(index) for every box that meets `box`, borders included, in ascending order.
  template <typename Visit>
  void for_each_meeting(const Eigen::AlignedBox2d& box, Visit&& visit) const {
    visit_below(1, box, visit);
  }

 private:
  template <typename Visit>
  void visit_below(std::size_t node, const Eigen::AlignedBox2d& box, Visit& visit) const {
    if (!nodes_[node].intersects(box)) return;
    if (node >= leaf_count_) return visit(node - leaf_count_);
    visit_below(2 * node, box, visit);
    visit_below(2 * node + 1, box, visit);
  }

  std::size_t leaf_count_;                  // a power of two
  std::vector<Eigen::AlignedBox2d> nodes_;  // node k has the children 2 k and 2 k + 1; [1] is the root
};

}  // namespace gouge::detail
