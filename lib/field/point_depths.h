#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "lib/base/parallel.h"
#include "lib/check/contact_rule.h"
#include "lib/field/point_tree.h"

namespace gouge {

/// A point of the surface, in part coordinates.
struct FieldPoint {
  Vec3 at = Vec3::Zero();
  Against against = Against::part;  ///< the obstacle of the point
  double clearance_mm = 0;          ///< clearance of its mesh
};

/// Bounds on the depth of all points p of a node in a body, mm: min <= depth <= max, and depth <= at_centre + slope .
/// (p - centre).
struct DepthRange {
  double min_mm = 0, max_mm = 0;
  double at_centre_mm = 0;
  Vec3 slope = Vec3::Zero();
};

/// A body that is queried for balls of one radius. A ball is deepest if one of its points may have a depth that counts,
/// otherwise 0. A bound for a node that is widened by the radius holds for all balls about the points of the node. A
/// group of bodies is queried as one while its bodies are close to each other, even in leaves.
template <class Of>
class AnyDepth {
 public:
  using Memory = typename Of::Memory;
  std::uint32_t parts, first_part;

  AnyDepth(const Of& of, double radius_mm, double max_floor_mm)
      : parts(of.parts),
        first_part(of.first_part),
        of_(of),
        radius_mm_(radius_mm),
        floor_mm_(std::min(of.floor_mm(), max_floor_mm)) {}

  [[nodiscard]] bool is_coarse(const PointTree::Node& node) const { return of_.is_apart(wider(node)); }
  [[nodiscard]] double floor_mm() const { return floor_mm_; }
  [[nodiscard]] DepthRange range_mm(const PointTree::Node& node, double cutoff_mm, Memory& memory) const {
    // The points of a ball lie within its radius of its centre, so they are points of the wider node.
    DepthRange range = of_.range_mm(wider(node), cutoff_mm, memory);
    if (range.slope.isZero(0))
      range.at_centre_mm = range.max_mm;
    else
      range.at_centre_mm += radius_mm_;
    return range;
  }
  [[nodiscard]] double depth_mm(const FieldPoint& centre, double, Memory& memory) const {
    PointTree::Node point;
    point.box.extend(centre.at);
    point.centre = centre.at;
    const bool may_be = of_.range_mm(wider(point), floor_mm(), memory).max_mm > floor_mm();
    return may_be ? static_cast<double>(std::numeric_limits<float>::max()) : 0;
  }

 private:
  [[nodiscard]] PointTree::Node wider(const PointTree::Node& node) const {
    PointTree::Node out;
    const Vec3 more = Vec3::Constant(radius_mm_);
    out.box = Box3(node.box.min() - more, node.box.max() + more);
    out.centre = node.centre;
    out.radius = std::max(0.5 * out.box.diagonal().norm(), node.radius + radius_mm_);
    out.normal = node.normal;
    out.off_mm = node.off_mm + radius_mm_;
    return out;
  }

  const Of& of_;
  double radius_mm_, floor_mm_;
};

/// Makes an AnyDepth of each body. A depth does not count if it is at most the smaller of `max_floor_mm` and the body's
/// own floor.
template <class Of>
[[nodiscard]] std::vector<AnyDepth<Of>> any_depths(const std::vector<Of>& bodies, double radius_mm,
                                                   double max_floor_mm = std::numeric_limits<double>::infinity()) {
  std::vector<AnyDepth<Of>> out;
  out.reserve(bodies.size());
  for (const Of& body : bodies) out.emplace_back(body, radius_mm, max_floor_mm);
  return out;
}

/// The largest depth of each point of a surface in any of many bodies. Points and bodies are halved together. A node of
/// points passes on the bodies that may be the deepest somewhere in it. Its leaves query the bodies with the largest
/// bound first.
class PointDepths {
 public:
  static constexpr double kUnseen = 1.03;  ///< a depth that is at most this many times another looks the same
  /// Builds the tree of the points. It is fast if neighbours in the list are neighbours in space. The points must
  /// outlive it.
  explicit PointDepths(const std::vector<FieldPoint>& points)
      : points_(points), tree_(points.size(), [&](std::size_t i) { return points[i].at; }) {}

  /// Returns the depth of each point in mm, at most 3 % too small; 0 if the point is in no body. The last `roots`
  /// bodies are queried for all points, other bodies only as parts of these.
  ///
  /// A Body has these functions. (1) range_mm(node, cutoff_mm, memory) bounds the node's depth; the bound need not be
  /// exact if it is at most `cutoff_mm`. (2) depth_mm(point, cutoff_mm, memory) returns the depth of a point, if that
  /// is above `cutoff_mm`. (3) floor_mm() returns the depth up to which a depth does not count. The Memory of a body
  /// keeps results from one call for the next call nearby.
  ///
  /// One body may represent several. Then `parts` is their number and `first_part` the first of them, and the range
  /// holds for each. If is_coarse(node), the parts themselves are queried.
  template <class Body>
  [[nodiscard]] std::vector<float> deepest(const std::vector<Body>& bodies, std::size_t roots) const {
    std::vector<float> depth(points_.size(), 0.0F);
    if (tree_.nodes().empty()) return depth;
    Descent<Body> top{*this, bodies, depth};
    for (std::size_t b = bodies.size() - roots; b < bodies.size(); ++b)
      top.candidates.push_back(
          {static_cast<std::uint32_t>(b), {0, std::numeric_limits<double>::infinity(), 0, Vec3::Zero()}});
    std::vector<Task> tasks;
    top.split(0, 0, tasks);
    for_each_chunk(tasks.size(), 1, 0, [&](std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k) {
        Descent<Body> descent{*this, bodies, depth};
        descent.candidates = tasks[k].candidates;
        descent.visit(tasks[k].node, 0);
      }
    });
    return depth;
  }
  template <class Body>
  [[nodiscard]] std::vector<float> deepest(const std::vector<Body>& bodies) const {
    return deepest(bodies, bodies.size());
  }

 private:
  struct Candidate {
    std::uint32_t body = 0;
    DepthRange range;
    /// The depth of any point p of the node, and of the nodes below it, is at most at_origin_mm + range.slope . p.
    double at_origin_mm = std::numeric_limits<double>::infinity();
  };
  struct Task {
    std::size_t node = 0;
    std::vector<Candidate> candidates;
  };

  template <class Body>
  struct Descent {
    Descent(const PointDepths& of, const std::vector<Body>& all, std::vector<float>& found)
        : field(of), bodies(all), depth(found), memories(all.size()) {}

    const PointDepths& field;
    const std::vector<Body>& bodies;
    std::vector<float>& depth;
    std::vector<typename Body::Memory> memories;
    std::vector<Candidate> candidates;  ///< the candidates of a node follow those of its parent
    double min_mm = 0;                  ///< largest lower bound in the current node; `champion` has it
    std::size_t champion = 0;

    /// Descends to the blocks, which become tasks.
    void split(std::size_t at, std::size_t first, std::vector<Task>& tasks) {
      const PointTree::Node& node = field.tree_.nodes()[at];
      if (node.is_block) {
        tasks.push_back({at, {candidates.begin() + static_cast<std::ptrdiff_t>(first), candidates.end()}});
        return;
      }
      const std::size_t own = shortlist(node, first);
      if (candidates.size() > own) {
        split(node.child, own, tasks);
        split(node.child + 1, own, tasks);
      }
      candidates.resize(own);
    }

    // Visits a node, and makes a shortlist only at every second level: along Morton's curve the nodes between are half
    // squares.
    void visit(std::size_t at, std::size_t first, bool is_half = false) {
      const PointTree::Node& node = field.tree_.nodes()[at];
      if (is_half && node.child != 0) {
        visit(node.child, first);
        visit(node.child + 1, first);
        return;
      }
      const std::size_t own = shortlist(node, first);
      if (candidates.size() > own) {
        if (node.child != 0) {
          visit(node.child, own, true);
          visit(node.child + 1, own, true);
        } else {
          look(node, own);
        }
      }
      candidates.resize(own);
    }

    // Appends those candidates of the parent that may be the deepest somewhere in the node. The one with the largest
    // lower bound always stays and comes first. Returns the index of the first appended one.
    std::size_t shortlist(const PointTree::Node& node, std::size_t first) {
      const std::size_t own = candidates.size();
      min_mm = 0;
      champion = own;
      for (std::size_t k = first; k < own; ++k) propose(node, candidates[k]);
      if (candidates.size() == own) return own;
      if (min_mm > 0) std::swap(candidates[own], candidates[champion]);
      const auto begin = candidates.begin() + static_cast<std::ptrdiff_t>(own);
      candidates.erase(
          std::remove_if(begin + 1, candidates.end(), [&](const Candidate& one) { return one.range.max_mm <= min_mm; }),
          candidates.end());
      return own;
    }

    void propose(const PointTree::Node& node, const Candidate& parent) {
      const Body& body = bodies[parent.body];
      const double cutoff_mm = std::max(body.floor_mm(), min_mm);
      if (parent.range.max_mm <= cutoff_mm || max_by(parent, node) <= cutoff_mm) return;
      DepthRange range = body.range_mm(node, cutoff_mm, memories[parent.body]);
      if (range.max_mm <= cutoff_mm) return;
      range.max_mm = std::min(parent.range.max_mm, range.max_mm);
      if (body.parts > 0 && body.is_coarse(node)) {
        const double at_origin_mm = range.at_centre_mm - range.slope.dot(node.centre);
        for (std::uint32_t k = 0; k < body.parts; ++k) propose(node, {body.first_part + k, range, at_origin_mm});
        return;
      }
      if (range.min_mm > min_mm) {
        min_mm = range.min_mm;
        champion = candidates.size();
      }
      candidates.push_back({parent.body, range, range.at_centre_mm - range.slope.dot(node.centre)});
    }

    // Bounds the node by the plane of the parent's candidate. This is far cheaper than a query of the body.
    static double max_by(const Candidate& parent, const PointTree::Node& node) {
      return parent.at_origin_mm + parent.range.slope.dot(node.centre) + PointTree::reach_mm(node, parent.range.slope);
    }

    void look(const PointTree::Node& node, std::size_t own) {
      std::sort(candidates.begin() + static_cast<std::ptrdiff_t>(own), candidates.end(),
                [](const Candidate& a, const Candidate& b) {
                  const double x = a.range.at_centre_mm, y = b.range.at_centre_mm;
                  return x > y || (x >= y && a.body < b.body);
                });
      for (std::size_t k = own; k < candidates.size(); ++k) {
        const Candidate& one = candidates[k];
        const Body& body = bodies[one.body];
        for (std::size_t i = node.first; i < node.last; ++i) {
          const FieldPoint& point = field.points_[i];
          const double cutoff_mm = std::max(body.floor_mm(), kUnseen * static_cast<double>(depth[i]));
          if (one.at_origin_mm + one.range.slope.dot(point.at) <= cutoff_mm) continue;
          depth[i] = std::max(depth[i], static_cast<float>(body.depth_mm(point, cutoff_mm, memories[one.body])));
        }
      }
    }
  };

  const std::vector<FieldPoint>& points_;
  PointTree tree_;
};

}  // namespace gouge
