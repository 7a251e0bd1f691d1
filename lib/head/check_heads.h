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

/// Maximum depth of the surface in each head, of every move of a path, mm. Requires a head.
class HeadUppers {
 public:
  HeadUppers(std::size_t moves, std::size_t heads) : heads_(heads), all_(moves * heads, kNotSwept) {}

  [[nodiscard]] bool is_swept(std::size_t move) const { return !std::isnan(all_[move * heads_]); }
  [[nodiscard]] double of(std::size_t move, std::size_t head) const { return all_[move * heads_ + head]; }
  /// `uppers_mm`: one of each head, or empty where the move was not swept.
  void set(std::size_t move, const std::vector<double>& uppers_mm) {
    for (std::size_t h = 0; h < heads_; ++h) all_[move * heads_ + h] = uppers_mm.empty() ? kNotSwept : uppers_mm[h];
  }

 private:
  static constexpr double kNotSwept = std::numeric_limits<double>::quiet_NaN();

  std::size_t heads_;
  PagedVector<double> all_;
};

/// Heads against the meshes of a scene, which must both outlive it.
class HeadChecker {
 public:
  /// Requires scene.is_within_reach.
  HeadChecker(const std::vector<HeadBody>& heads, const PreparedScene& scene);

  /// Joins what the heads do during a motion to the tool's verdict on it; returns the bounds it took. The
  /// deeper witness stays, a gouge of either is a gouge, and the motion is clean only if both are.
  std::uint64_t check(const Motion& motion, const CheckOptions& options, MoveVerdict& verdict) const;

  /// The same but for whether a head is inside a solid; how deep the surface may be in each head goes to `uppers_mm`.
  std::uint64_t sweep(const Motion& motion, const CheckOptions& options, MoveVerdict& verdict,
                      std::vector<double>& uppers_mm) const;

  /// Sweeps motions one after the other, together. Surfaces far from all of them are discarded once.
  ///
  /// Shape    One verdict, one list of uppers and one count of bounds a motion, as of `sweep`. A verdict may differ
  ///          from that of the motion alone in how deep the surface may be.
  void sweep_all(std::span<const Motion> motions, const CheckOptions& options, std::span<MoveVerdict* const> verdicts,
                 std::span<std::vector<double>> uppers_mm, std::span<std::uint64_t> bounds) const;

  /// Turns moves that are clean or near into buried or not certified where a head is inside a solid or may be. Does as
  /// mark_buried does for the tool.
  void mark_buried(const Toolpath& toolpath, const CheckOptions& options, const HeadUppers& uppers_mm,
                   MoveVerdicts& verdicts) const;

  /// Returns how much deeper than `allowed_mm` the heads are at a pose: the minimum distance that they must still move.
  /// It is below the truth by `accuracy_mm` at most. 0 only when that is proved and no head is buried. Infinite when
  /// one is buried, or when it could not be decided.
  [[nodiscard]] double excess_at(const Pose& pose, const MotionLaw& law, double allowed_mm, double accuracy_mm,
                                 std::uint64_t& bounds) const;

 private:
  /// Surfaces searched together, and the depth that heads may have in them.
  struct Group {
    std::vector<HeadTarget> targets;
    std::optional<MeshLimit> limit;  ///< of the one mesh; none: all of the scene, with the tolerance of the check

    [[nodiscard]] double tolerance_mm(const CheckOptions& options) const;
  };

  void search_group(const Group& group, const HeadBody& head, std::span<const Motion> motions,
                    const CheckOptions& options, std::span<HeadResult> results) const;
  void join(const HeadResult& found, const Group& group, const CheckOptions& options, MoveVerdict& verdict) const;
  void take(const HeadResult& found, const Group& group, MoveVerdict& verdict) const;
  void look_inside(const Motion& motion, const std::vector<double>& uppers_mm, MoveVerdict& verdict) const;

  const std::vector<HeadBody>& heads_;
  const SceneSides& sides_;
  std::span<const PreparedObstacle> obstacles_;
  std::vector<Group> groups_;  ///< first the one of all surfaces
};

/// Checks bodies that move with the tool, and that its profile does not hold, along every move on which the tool was
/// checked. Joins their verdicts to those of `result`. The deeper witness stays, a gouge of either is a gouge, and a
/// move is clean only if both are. Their share of a verdict: lib/certify has the whole.
///
/// The guarantee is the tool's: depth <= true depth <= depth_upper over every instant. Clean means that depth_upper is
/// at most tolerance + resolution and that no head lies inside a solid (Body::head in the witness).
/// Ensures  The same bits at any number of threads.
void check_heads(const Toolpath& toolpath, const std::vector<HeadBody>& heads, const PreparedScene& scene,
                 const CheckOptions& options, CheckResult& result, const ProgressCall& progress = {},
                 CheckpointStore* kept = nullptr);

}  // namespace gouge
