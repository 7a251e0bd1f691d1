#include "lib/tool/free_regions.h"

#include <algorithm>
#include <cmath>

#include "lib/base/tolerance.h"
#include "lib/tool/evaluate.h"

namespace gouge {
namespace {

constexpr double kLeast = 1e-5;  // regions that exceed the depth by less than this share of the height are ignored
constexpr int kRows = 200, kColumns = 64, kSamples = 256;

/// Returns a lower bound of the depth between two points of depths a and b. Depth changes no faster than the distance.
double min_between(double a, double b, double distance) { return 0.5 * (a + b - distance); }

}  // namespace

bool FreeRegions::covers_all() const {
  for (std::size_t k = 0; k < has_body.size(); ++k) {
    if (has_body[k] && !is_covered[k]) return false;
  }
  return true;
}

Body FreeRegions::uncovered() const {
  std::size_t k = 0;
  while (k + 1 < has_body.size() && (!has_body[k] || is_covered[k])) ++k;
  return static_cast<Body>(k);
}

RegionFinder::RegionFinder(const CompiledTool& tool)
    : tool_(tool), min_mm_(std::max(kLeast * (tool.z_max_mm - tool.z_min_mm), Tolerance::kSamePoint_mm)) {
  find_rings();
  for (std::size_t k = 0; k < has_body_.size(); ++k) {
    double low = tool.z_max_mm, high = tool.z_min_mm;
    for (const BoundaryElement& e : tool.elements) {
      if (static_cast<std::size_t>(e.body) != k) continue;
      has_body_[k] = true;
      low = std::min({low, e.a.y(), e.b.y()});
      high = std::max({high, e.a.y(), e.b.y()});
    }
    if (!has_body_[k]) continue;
    for (int i = 0; i <= kSamples; ++i)
      body_depth_mm_[k] = std::max(body_depth_mm_[k], depth_at(0, low + (high - low) * i / kSamples));
    for (const Ring& ring : rings_) {
      if (ring.point.y() >= low && ring.point.y() <= high)
        body_depth_mm_[k] = std::max(body_depth_mm_[k], ring.depth_mm);
    }
  }
}

double RegionFinder::depth_at(double r, double z) const { return -signed_distance_mm(tool_, std::abs(r), z); }

// Finds local maxima of the depth off the axis. Hollow cutters and undercut rings have them. The search climbs from the
// grid points that are at least as deep as their neighbours.
void RegionFinder::find_rings() {
  if (tool_.elements.empty()) return;
  const double height = tool_.z_max_mm - tool_.z_min_mm;
  const double near = 1e-3 * (height + tool_.r_max_mm);
  std::vector<double> depth(static_cast<std::size_t>(kRows * kColumns));
  const auto at = [&](int i, int j) -> double& { return depth[static_cast<std::size_t>(i * kColumns + j)]; };
  const auto point = [&](int i, int j) {
    return Vec2(tool_.r_max_mm * j / kColumns, tool_.z_min_mm + height * (i + 0.5) / kRows);
  };
  for (int i = 0; i < kRows; ++i) {
    for (int j = 0; j < kColumns; ++j) at(i, j) = depth_at(point(i, j).x(), point(i, j).y());
  }
  const auto is_top = [&](int i, int j) {
    const auto beside = [&](int k, int l) { return k < 0 || k >= kRows || l >= kColumns ? 0.0 : at(k, l); };
    return at(i, j) > 0 && at(i, j) > beside(i - 1, j) && at(i, j) > beside(i, j - 1) && at(i, j) >= beside(i + 1, j) &&
           at(i, j) >= beside(i, j + 1);
  };
  for (int i = 0; i < kRows; ++i) {
    for (int j = 1; j < kColumns; ++j) {
      if (!is_top(i, j)) continue;
      Ring ring = climb(point(i, j));
      if (ring.point.x() <= near) continue;
      const bool is_known = std::any_of(rings_.begin(), rings_.end(), [&](const Ring& known) {
        return (known.point - ring.point).norm() <= std::max(near, 0.5 * std::min(known.depth_mm, ring.depth_mm));
      });
      if (is_known) continue;
      join_with_axis(ring);
      rings_.push_back(ring);
    }
  }
}

/// Climbs to larger depths from a point. Halves the step if no step leads up. In a narrow lip only tiny steps lead up, to
/// and fro across its ridge. After kPatience steps the search therefore leaps along the ridge, twice as far each time
/// (R. Hooke, T. A. Jeeves, Direct search, 1961).
RegionFinder::Ring RegionFinder::climb(Vec2 point) const {
  constexpr int kPatience = 1000;
  double depth = depth_at(point.x(), point.y());
  const double size = tool_.r_max_mm + tool_.z_max_mm - tool_.z_min_mm;
  Vec2 last = point, before_last = point;
  int steps = 0;
  for (double step = 0.5 * depth; step > kLeast * size;) {
    Vec2 best = point;
    double best_depth = depth;
    for (int k = 0; k < 8; ++k) {
      const double angle = 0.785398163397448 * k;
      Vec2 next = point + step * Vec2(std::cos(angle), std::sin(angle));
      next.x() = std::max(0.0, next.x());
      const double there = depth_at(next.x(), next.y());
      if (there > best_depth + 1e-3 * step) best = next, best_depth = there;
    }
    if (!(best_depth > depth)) {
      step *= 0.5;
      continue;
    }
    before_last = last;
    last = point;
    point = best;
    depth = best_depth;
    if (++steps <= kPatience) continue;
    for (Vec2 leap = point - before_last;; leap *= 2) {
      const Vec2 next(std::max(0.0, point.x() + leap.x()), point.y() + leap.y());
      const double there = depth_at(next.x(), next.y());
      if (!(there > depth + 1e-3 * step)) break;
      point = next;
      depth = there;
    }
  }
  Ring ring;
  ring.point = point;
  ring.depth_mm = depth;
  return ring;
}

void RegionFinder::join_with_axis(Ring& ring) const {
  constexpr int kHeights = 96, kParts = 48;
  for (int i = 0; i <= kHeights; ++i) {
    const double z =
        i == kHeights ? ring.point.y() : tool_.z_min_mm + (tool_.z_max_mm - tool_.z_min_mm) * (i + 0.5) / kHeights;
    const Vec2 joint(0, z);
    const double distance = (joint - ring.point).norm() / kParts;
    double before = ring.depth_mm, least = ring.depth_mm;
    for (int k = 1; k <= kParts && least > ring.joint_depth_mm; ++k) {
      const Vec2 q = ring.point + (joint - ring.point) * (static_cast<double>(k) / kParts);
      const double depth = depth_at(q.x(), q.y());
      least = std::min(least, min_between(before, depth, distance));
      before = depth;
    }
    if (least <= ring.joint_depth_mm) continue;
    ring.joint_depth_mm = least;
    ring.joint_z_mm = z;
  }
}

FreeRegions RegionFinder::at(double depth_mm) const {
  FreeRegions found;
  found.depth_mm = depth_mm;
  found.has_body = has_body_;
  for (std::size_t k = 0; k < has_body_.size(); ++k) found.is_covered[k] = body_depth_mm_[k] > depth_mm + min_mm_;
  const double height = tool_.z_max_mm - tool_.z_min_mm;
  bool is_open = false;
  // A point on the axis decides for its surroundings: up to its excess all points are free, or up to its lack none is.
  for (double z = tool_.z_min_mm; z <= tool_.z_max_mm && height > 0;) {
    const double depth = depth_at(0, z), excess = depth - depth_mm;
    const bool is_free = excess > min_mm_;
    if (is_free) {
      if (!is_open) found.regions.push_back({z - excess, z + excess, Vec2(0, z), depth});
      FreeRegion& region = found.regions.back();
      region.z_hi_mm = std::max(region.z_hi_mm, z + excess);
      if (depth > region.depth_mm) region.deepest = Vec2(0, z), region.depth_mm = depth;
    }
    is_open = is_free;
    z += std::max(min_mm_, 0.95 * std::abs(excess));  // stays within the excess of a free point
  }
  for (std::size_t k = 0; k < rings_.size(); ++k) {
    const Ring& ring = rings_[k];
    if (!(ring.depth_mm > depth_mm) || ring.joint_depth_mm > depth_mm) continue;
    found.regions.push_back({ring.point.y(), ring.point.y(), ring.point, ring.depth_mm, k});
  }
  return found;
}

}  // namespace gouge
