// The depth of remaining stock in a body, by questions about greater depths: find_depth of stock_search.

#include <algorithm>
#include <limits>

#include "lib/base/tolerance.h"
#include "lib/check/stock_bounds.h"
#include "lib/stock/stock_search.h"
#include "lib/tool/evaluate.h"

namespace gouge {

namespace {

constexpr int kDepthSteps = 24;

/// Returns the body of the boundary at the height of a point. Bodies stand one above the other, so that of the nearest
/// boundary may be another one: on the axis of a holder the shank below it may be nearer than the holder's surface.
Body body_at_height(const CompiledTool& tool, double r_mm, double z_mm) {
  const BoundaryElement* nearest = nullptr;
  double least_mm = std::numeric_limits<double>::infinity();
  for (const BoundaryElement& e : tool.elements) {
    const auto [low, high] = std::minmax(e.a.y(), e.b.y());
    const bool is_at_height = high - low > Tolerance::kRounding_mm && low <= z_mm && z_mm <= high;
    if (!is_at_height) continue;
    const double distance_mm = distance_to(e, {r_mm, z_mm});
    if (distance_mm >= least_mm) continue;
    least_mm = distance_mm;
    nearest = &e;
  }
  return nearest != nullptr ? nearest->body : tool.elements[evaluate(tool, r_mm, z_mm).element].body;
}

}  // namespace

StockDepth find_depth(const StockQuestion& question, const Motion& motion, const StockWitness& known, double upper_mm) {
  StockDepth deepest{known, upper_mm};
  StockQuestion limited = question;
  for (int k = 0; k < kDepthSteps && deepest.examined < question.budget; ++k) {
    const double depth = deepest.witness.depth_mm, gap = deepest.upper_mm - depth;
    if (gap <= depth_gap_mm(depth, question.options)) break;
    const double next = depth + std::min(0.5 * gap, depth);
    limited.budget = question.budget - deepest.examined;
    const StockAnswer answer = find_stock(limited, motion, deep_pieces(question.body, next), 0, 1, next);
    deepest.examined += answer.examined;
    if (answer.witness) {
      deepest.witness = *answer.witness;
    } else if (answer.is_clear) {
      deepest.upper_mm = std::min(deepest.upper_mm, next + question.options.resolution_mm);
    } else {
      break;
    }
  }
  // The proofs count cutters as wider and the stock as smaller.
  deepest.upper_mm = std::min(upper_mm, deepest.upper_mm + beyond_wider_cuts_mm(question.options.resolution_mm));
  return deepest;
}

double depth_gap_mm(double depth_mm, const StockOptions& options) {
  constexpr double kShare = 0.1;
  return std::max(2 * options.resolution_mm, kShare * depth_mm);
}

Body body_at(const CompiledTool& bare, const CompiledTool& asked, const Pose& pose, const Vec3& point) {
  const Vec3 from_tip = point - pose.tip;
  const double z = from_tip.dot(pose.axis), r = (from_tip - z * pose.axis).norm();
  return body_at_height(signed_distance_mm(bare, r, z) <= 0 ? bare : asked, r, z);
}

}  // namespace gouge
