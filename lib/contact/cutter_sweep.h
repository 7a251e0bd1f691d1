#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "lib/contact/nearest_instant.h"
#include "lib/motion/motion.h"
#include "lib/tool/compiled_tool.h"

namespace gouge {

/// Returns whether the cutter is a solid of revolution whose profile, from the tip upwards, turns in one direction
/// only.
[[nodiscard]] bool is_convex(const CompiledTool& tool);

/// A flat piece of a surface, seen from one of its sides.
struct SidedPiece {
  std::array<Vec3, 3> corners;
  Vec3 outward;  ///< unit
};

/// Place where a query last succeeded, because the next query often succeeds there too. It changes no result.
struct SweepHint {
  std::uint32_t piece = 0;
  std::size_t work = 0;  ///< number of examined bounds of nodes and motions so far
};

/// Returns an upper bound of the distance of the cutter's points from the tip.
[[nodiscard]] double farthest_mm(const CompiledTool& cutter);

/// The space through which cutters pass on motions: a tree over the motions, in the order in which they were added.
/// Each motion has the number of its move; moves of a path may be left out.
class CutterSweep {
 public:
  /// Adds a motion. Requires motion.is_defined(). `cutter` must have elements and must outlive the sweep. Curves are
  /// replaced by chords that deviate by at most 0.001 mm; every result allows for that. Cost: 200 bytes for each chord,
  /// and one chord for each degree of turn.
  void add(const Motion& motion, const CompiledTool& cutter, std::size_t move);
  /// Builds the tree, after the last motion was added. The cost is linear.
  void index();

  [[nodiscard]] bool is_empty() const { return stretches_.empty(); }

  /// Returns the distance from a point to the nearest cutter, negative inside. It is at most the true distance. It is
  /// lower than that by at most 0.0002 mm, or by the uncertainty of a turning cutter. This does not hold if the true
  /// distance is below `lower_cutoff_mm` or above `upper_cutoff_mm`. The hint is the nearest piece.
  [[nodiscard]] double distance(const Vec3& point, double lower_cutoff_mm, double upper_cutoff_mm,
                                SweepHint& hint) const;

  /// Returns the move during which all points are in the cutter at some instant; kNone if none was found.
  [[nodiscard]] std::size_t covering_move(std::span<const Vec3> points, SweepHint& hint) const;

  /// Returns false if no point of the piece, lifted by `lift_mm`, is ever `deep_mm` or more inside a cutter. Cutters
  /// whose axis is, at their deepest point, on the other side of the piece are excluded.
  [[nodiscard]] bool may_reach(const SidedPiece& piece, double lift_mm, double deep_mm, SweepHint& hint) const;

  /// Returns whether all cutters are convex.
  [[nodiscard]] bool is_convex() const { return is_convex_; }

  /// Returns the radius of the thinnest cutter; infinite if there is none.
  [[nodiscard]] double min_radius_mm() const { return min_radius_mm_; }

 private:
  /// Poses around a middle one: the tip is within beside_mm of a straight way, and the axis turns by at most turn_rad.
  struct Core {
    Pose middle;
    Vec3 half_way = Vec3::Zero();  ///< the way leads from the middle by this, forward and back
    double half_way_mm = 0;        ///< its length
    double beside_mm = 0;          ///< infinite for several cutters
    double turn_rad = 0;
  };
  struct Node {
    Vec3 low = Vec3::Zero(), high = Vec3::Zero();
    Core core;                          ///< surrounds all poses of the node
    std::uint32_t first = 0, last = 0;  ///< range of stretches
    std::uint32_t second = 0;           ///< index of the second half; the first half is the next node; 0: a leaf
  };

  [[nodiscard]] static Core core_of(const CutterStretch& stretch);
  std::uint32_t build(std::uint32_t first, std::uint32_t last);
  void surround(std::uint32_t node);
  [[nodiscard]] double away_mm(const Node& node, std::span<const Vec3> points) const;
  /// The corners of a triangle relative to a point in it.
  using Corners = std::array<Vec3, 3>;
  /// Returns whether a point is certainly more than `within_mm` outside the cutter at all poses around the core. `of` is a
  /// stretch of the same cutter. With `corners`, the answer holds for all points of the triangle about the point.
  [[nodiscard]] static bool is_beyond(const Core& core, const CutterStretch& of, const Vec3& point, double within_mm,
                                      const Corners* corners = nullptr);
  /// Calls `look(stretch)`, the nearer half of a node first, until it returns true. Visits stretches that may be within
  /// `within()` of all `points`, except those around which `skip(core, stretch)` excludes all poses.
  template <typename Within, typename Skip, typename Look>
  bool visit(std::uint32_t node, std::span<const Vec3> points, const Within& within, const Skip& skip, const Look& look,
             std::size_t& work) const;

  std::vector<CutterStretch> stretches_;
  std::vector<Core> cores_;  // of the stretches
  std::vector<Node> nodes_;
  bool is_convex_ = true;
  double min_radius_mm_ = std::numeric_limits<double>::infinity();
};

}  // namespace gouge
