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

/// Returns whether it is a solid of revolution whose profile turns in one direction only, with contours from the tip
/// up.
[[nodiscard]] bool is_convex(const CompiledTool& tool);

/// A flat piece of surface as seen from one side of it.
struct SidedPiece {
  std::array<Vec3, 3> corners;
  Vec3 outward;  ///< unit
};

/// Place where a query last succeeded, as the next one often succeeds there too. It changes no result.
struct SweepHint {
  std::uint32_t piece = 0;
  std::size_t work = 0;  ///< bounds of nodes and motions examined so far
};

/// Returns a distance from the tip that no point of the cutter exceeds.
[[nodiscard]] double farthest_mm(const CompiledTool& cutter);

/// The space that cutters pass through on motions: a tree over the motions in the order in which they were added.
/// Moves of a path may be taken out of it.
class CutterSweep {
 public:
  /// Requires motion.is_defined(). `cutter`, with elements, must outlive the sweep. Curves are cut into chords that are
  /// off by no more than 0.001 mm, which every result allows for. Cost 200 bytes a chord, and one for each degree of
  /// turn.
  void add(const Motion& motion, const CompiledTool& cutter, std::size_t move);
  /// After the last motion. Cost linear.
  void index();

  [[nodiscard]] bool is_empty() const { return stretches_.empty(); }

  /// Returns the distance from a point to the nearest cutter, negative inside. It is not above the truth. It is not
  /// below it by more than 0.0002 mm, or than a turning cutter leaves open. That does not hold where the truth is below
  /// `lower_cutoff_mm` or above `upper_cutoff_mm`. The hint is the piece that was nearest.
  [[nodiscard]] double distance(const Vec3& point, double lower_cutoff_mm, double upper_cutoff_mm,
                                SweepHint& hint) const;

  /// Returns the move of an instant at which all points are in the cutter; kNone where none was found.
  [[nodiscard]] std::size_t covering_move(std::span<const Vec3> points, SweepHint& hint) const;

  /// Returns false where no point of the piece, lifted by `lift_mm`, is ever inside a cutter by `deep_mm` or more.
  /// Cutters are excepted whose axis, by their deepest point, is on the other side.
  [[nodiscard]] bool may_reach(const SidedPiece& piece, double lift_mm, double deep_mm, SweepHint& hint) const;

  /// Returns false where some of its cutters are not convex.
  [[nodiscard]] bool is_convex() const { return is_convex_; }

  /// Returns the radius of the thinnest cutter; infinite where there is none.
  [[nodiscard]] double min_radius_mm() const { return min_radius_mm_; }

 private:
  struct Node {
    Vec3 low = Vec3::Zero(), high = Vec3::Zero();
    /// A pose among them; at no instant of them is a point of the cutter farther than spread_mm from where it is there.
    Pose middle;
    double spread_mm = 0;               ///< infinite where they have several cutters
    std::uint32_t first = 0, last = 0;  ///< stretches
    std::uint32_t second = 0;           ///< its halves are the next node and this one; 0: a leaf
  };

  std::uint32_t build(std::uint32_t first, std::uint32_t last);
  void surround(Node& node) const;
  [[nodiscard]] double away_mm(const Node& node, std::span<const Vec3> points) const;
  /// Returns whether a point is surely more than `within_mm` outside the cutter at all its instants.
  [[nodiscard]] bool is_beyond(const Node& node, const Vec3& point, double within_mm) const;
  /// Calls `look(stretch)`, the nearer half of a node first, until it returns true. Stretches are visited that may be
  /// no farther from all `points` than `within()` and that no `skip(node)` leaves out.
  template <typename Within, typename Skip, typename Look>
  bool visit(std::uint32_t node, std::span<const Vec3> points, const Within& within, const Skip& skip, const Look& look,
             std::size_t& work) const;

  std::vector<CutterStretch> stretches_;
  std::vector<Node> nodes_;
  bool is_convex_ = true;
  double min_radius_mm_ = std::numeric_limits<double>::infinity();
};

}  // namespace gouge
