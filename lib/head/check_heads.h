#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "lib/base/checkpoints.h"
#include "lib/base/paged_memory.h"
#include "lib/base/parallel.h"
#include "lib/check/check_options.h"
#include "lib/check/check_result.h"
#include "lib/check/prepared_scene.h"
#include "lib/head/head_body.h"
#include "lib/head/head_search.h"

namespace gouge {

/// Maximum depth of the surface in each head, for every move of a path, in mm. Requires at least one head.
class HeadUppers {
 public:
  HeadUppers(std::size_t moves, std::size_t heads) : heads_(heads), all_(moves * heads, kNotSwept) {}

  [[nodiscard]] bool is_swept(std::size_t move) const { return !std::isnan(all_[move * heads_]); }
  [[nodiscard]] double of(std::size_t move, std::size_t head) const { return all_[move * heads_ + head]; }
  /// Stores the depths of a move. `uppers_mm` has one value for each head, or is empty if the move was not swept.
  void set(std::size_t move, const std::vector<double>& uppers_mm) {
    for (std::size_t h = 0; h < heads_; ++h) all_[move * heads_ + h] = uppers_mm.empty() ? kNotSwept : uppers_mm[h];
  }

 private:
  static constexpr double kNotSwept = std::numeric_limits<double>::quiet_NaN();

  std::size_t heads_;
  PagedVector<double> all_;
};

/// Checker of heads against the meshes of a scene. The heads and the scene must outlive it.
class HeadChecker {
 public:
  /// Prepares the checker. Requires scene.is_within_reach.
  HeadChecker(const std::vector<HeadBody>& heads, const PreparedScene& scene);
  /// Prepares a checker against one of the obstacles. Only `sweep` and `sweep_all` may be called.
  HeadChecker(const std::vector<HeadBody>& heads, const PreparedScene& scene, Against against);

  /// Combines the result of the heads during a motion with the verdict on the tool. Returns the number of bounds. The
  /// deeper witness stays; a gouge of either is a gouge; the motion is clean only if both are.
  std::uint64_t check(const Motion& motion, const CheckOptions& options, MoveVerdict& verdict) const;

  /// Does the same, except for the test whether a head is inside a solid. Stores the maximum depth of the surface in
  /// each head in `uppers_mm`.
  std::uint64_t sweep(const Motion& motion, const CheckOptions& options, MoveVerdict& verdict,
                      std::vector<double>& uppers_mm) const;

  /// Sweeps several consecutive motions together. Surfaces far from all of them are discarded once.
  ///
  /// Shape    One verdict, one list of uppers and one count of bounds for each motion, as in `sweep`. A verdict may
  ///          differ from that of the single motion in the maximum depth of the surface.
  void sweep_all(std::span<const Motion> motions, const CheckOptions& options, std::span<MoveVerdict* const> verdicts,
                 std::span<std::vector<double>> uppers_mm, std::span<std::uint64_t> bounds) const;

  /// Changes the state of moves that are clean or near: to buried if a head is inside a solid, to not certified if it
  /// may be inside. It corresponds to mark_buried for the tool.
  void mark_buried(const Toolpath& toolpath, const CheckOptions& options, const HeadUppers& uppers_mm,
                   MoveVerdicts& verdicts) const;

  /// Returns how much deeper than `allowed_mm` the heads are at a pose: the minimum distance that they must still move.
  /// It is below the true value by at most `accuracy_mm`. It is 0 only if that is proved and no head is buried. It is
  /// infinite if a head is buried or this is not decided.
  [[nodiscard]] double excess_at(const Pose& pose, const MotionLaw& law, double allowed_mm, double accuracy_mm,
                                 std::uint64_t& bounds) const;

 private:
  /// Surfaces that are searched together, with the permitted depth of heads in them.
  struct Group {
    std::vector<HeadTarget> targets;
    std::optional<MeshLimit> limit;  ///< limit of the only mesh; none: the whole scene, with the tolerance of the check

    [[nodiscard]] double tolerance_mm(const CheckOptions& options) const;
  };

  class AnyTurn;

  HeadChecker(const std::vector<HeadBody>& heads, const PreparedScene& scene,
              std::span<const PreparedObstacle> obstacles);

  /// `reach_mm`: distance by which all surfaces are moved towards the heads.
  void search_group(const Group& group, const HeadBody& head, std::span<const Motion> motions,
                    const CheckOptions& options, std::span<HeadResult> results, double reach_mm = 0) const;
  /// Extends a verdict and the maximum depths to all motions that LawScope::any admits (check_any_turn.cpp). Returns the
  /// number of bounds.
  std::uint64_t check_any_turn(const Motion& motion, const CheckOptions& options, MoveVerdict& verdict,
                               std::vector<double>& uppers_mm) const;
  void join(const HeadResult& found, const Group& group, const CheckOptions& options, const Motion& motion,
            MoveVerdict& verdict) const;
  void take(const HeadResult& found, const Group& group, MoveVerdict& verdict) const;
  void look_inside(const Motion& motion, const std::vector<double>& uppers_mm, MoveVerdict& verdict) const;

  const std::vector<HeadBody>& heads_;
  const SceneSides& sides_;
  std::span<const PreparedObstacle> obstacles_;
  std::vector<Group> groups_;  ///< the first group has all surfaces
};

/// Checks bodies that move with the tool but are not part of its profile, along every move on which the tool was
/// checked. Combines their verdicts with those of `result`. The deeper witness stays; a gouge of either is a gouge; a
/// move is clean only if both are. This is one part of a verdict; lib/certify gives the complete one.
///
/// The guarantee is that of the tool: depth <= true depth <= depth_upper over every instant. Clean means that
/// depth_upper is at most tolerance + resolution, and that no head lies inside a solid (Body::head in the witness).
/// Ensures  The result has the same bits at any number of threads.
void check_heads(const Toolpath& toolpath, const std::vector<HeadBody>& heads, const PreparedScene& scene,
                 const CheckOptions& options, CheckResult& result, const ProgressCall& progress = {},
                 CheckpointStore* kept = nullptr);

}  // namespace gouge
