#include "lib/overcut/measure_overcut.h"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "lib/base/parallel.h"
#include "lib/check/overcut_gap.h"
#include "lib/check/verdict_bytes.h"
#include "lib/motion/motion.h"
#include "lib/motion/motion_law.h"
#include "lib/overcut/overcut_search.h"
#include "lib/overcut/swept_solid.h"
#include "lib/overcut/swept_tool.h"
#include "lib/tool/free_regions.h"
#include "lib/tool/inscribed_balls.h"

namespace gouge {
namespace {

constexpr std::size_t kCellsOfOthers = 2'000;  // maximum number of cells for a move that is not the worst of its
                                               // finding

constexpr double kSlack_mm = 0.1 * kOvercutGap_mm;
constexpr double kRegionRounding = 2e-5;  // share of the height: twice the length that RegionFinder ignores

/// A bound of an overcut that follows from the depth of the move.
struct KnownOvercut {
  double upper_mm = 0;            ///< upper bound of the distance below the surface for all points of the tool outside
                                  ///< of the zones
  std::vector<Box2> sharp_zones;  ///< zones of the tool's half plane
};

/// The reach of a tool below a surface, derived from the depth of the surface in the tool. Except near sharp corners,
/// and where the tool is thin, the reach does not exceed the depth. The part of the tool that the surface does not
/// reach is outside. A ball inscribed there leads from every other point to the surface.
/// Proof: docs/method/overcut.md, section 2.
class DepthBound {
 public:
  /// Prepares the bound. Cost: some thousand evaluations of the tool, which must outlive it.
  explicit DepthBound(const CompiledTool& tool);

  /// Returns the bound for a motion during which the surface of `part` is nowhere deeper in the tool than
  /// `depth_upper_mm`. Returns nothing if the depth does not bound the reach. That is so for a tool that turns back in
  /// height, is thinner than twice the depth, or has a core in the part.
  /// Requires the boundary of a solid.
  [[nodiscard]] std::optional<KnownOvercut> at(double depth_upper_mm, const Motion& motion, const Surface& part) const;

 private:
  const CompiledTool& tool_;
  InscribedBalls balls_;
  RegionFinder regions_;
};

DepthBound::DepthBound(const CompiledTool& tool) : tool_(tool), balls_(tool, kSlack_mm), regions_(tool) {}

std::optional<KnownOvercut> DepthBound::at(double depth_upper_mm, const Motion& motion, const Surface& part) const {
  if (!balls_.is_single_valued()) return std::nullopt;
  const FreeRegions free = regions_.at(depth_upper_mm);
  const Pose pose = motion.at(0);
  const Vec3 across = pose.axis.unitOrthogonal();
  const auto is_outside = [&](const FreeRegion& region) {
    const Vec3 deepest = pose.tip + region.deepest.y() * pose.axis + region.deepest.x() * across;
    return !part.closest_point(deepest)->is_inside;
  };
  if (free.regions.empty() || !std::all_of(free.regions.begin(), free.regions.end(), is_outside)) return std::nullopt;
  const double deeper = depth_upper_mm + kRegionRounding * (tool_.z_max_mm - tool_.z_min_mm);
  return KnownOvercut{depth_upper_mm + kSlack_mm, balls_.sharp_zones(deeper)};
}

/// The measurement of the overcuts of one path's gouging moves.
class Measuring {
 public:
  Measuring(const Toolpath& toolpath, const std::vector<const ToolVariants*>& tools, const PreparedScene& scene,
            const CheckOptions& options, const std::vector<HeadBody>& heads, CheckResult& result)
      : toolpath_(toolpath), tools_(tools), scene_(scene), options_(options), heads_(heads), result_(result) {}

  void run(const ProgressCall& progress, CheckpointStore* kept) {
    is_worst_.resize(result_.verdicts.size(), false);
    for (const Event& event : result_.events) is_worst_[event.worst_move] = true;
    for (std::size_t i = 0; i < result_.verdicts.size(); ++i) {
      if (is_asked(i)) prepare(i);
    }
    for_each_checkpointed_chunk(gouges_.size(), 4, options_.threads, "measuring overcuts", progress, kept, form(),
                                [&](std::size_t first, std::size_t last) {
                                  for (std::size_t k = first; k < last; ++k) measure(gouges_[k]);
                                });
    result_.worst_overcut_mm = 0;
    for (const std::size_t i : gouges_)
      result_.worst_overcut_mm = std::max(result_.worst_overcut_mm, result_.verdicts[i].overcut_mm());
  }

 private:
  [[nodiscard]] CheckpointForm form() const {
    CheckpointForm form;
    form.write = [this](std::size_t first, std::size_t last) {
      std::string bytes;
      for (std::size_t k = first; k < last; ++k) append_bytes(result_.verdicts[gouges_[k]], bytes);
      return bytes;
    };
    form.read = [this](std::size_t first, std::size_t last, std::string_view bytes) {
      std::vector<MoveVerdict> read(last - first);
      bool is_whole = true;
      for (MoveVerdict& verdict : read)
        is_whole = is_whole && take_bytes(bytes, verdict) && is_of_meshes(verdict, *scene_.scene);
      if (!is_whole || !bytes.empty()) return false;
      for (std::size_t k = first; k < last; ++k) result_.verdicts[gouges_[k]] = std::move(read[k - first]);
      return true;
    };
    return form;
  }

  [[nodiscard]] const Surface& surface_of(const MoveVerdict& verdict) const {
    return scene_.surface(verdict.witness->against, verdict.witness->mesh);
  }

  [[nodiscard]] bool is_asked(std::size_t move) const {
    const MoveVerdict& verdict = result_.verdicts[move];
    return verdict.state == MoveState::gouge && verdict.witness && tools_[toolpath_.moves[move].tool] != nullptr;
  }

  /// Prepares a move. Data that is made once and shared is made here, so that it is not made within a single thread of
  /// the measurement.
  void prepare(std::size_t move) {
    const Surface& surface = surface_of(result_.verdicts[move]);
    if (!surface.boundary().is_solid()) return;
    static_cast<void>(surface.boundary().tree());
    gouges_.push_back(move);
    const std::size_t tool = toolpath_.moves[move].tool;
    depth_bounds_.try_emplace(tool, tools_[tool]->bare);
  }

  /// Returns the motions that the law admits for a move.
  static std::vector<Motion> motions_of(const Motion& motion) {
    std::vector<Motion> all{motion.alone()};
    if (auto other = motion.other()) all.push_back(*std::move(other));
    return all;
  }

  void measure(std::size_t move) const {
    MoveVerdict& verdict = result_.verdicts[move];
    const std::size_t tool = toolpath_.moves[move].tool;
    const Motion motion = options_.law.of(toolpath_, move);
    if (motion.is_any()) return;  // no bound covers the overcut of all motions
    const Surface& part = surface_of(verdict).boundary();
    // The place of the tool's boundary at the depth of the witness.
    const Vec3 seed = verdict.witness->point - verdict.depth_mm * verdict.witness->normal;
    const auto join = [&](SweptSolid&& moving, double rounded_bound_mm) {
      OvercutOptions search;
      if (!is_worst_[move]) search.max_cells = kCellsOfOthers;
      search.rounded_bound_mm = rounded_bound_mm;
      const Overcut found = find_overcut(moving, part, seed, verdict.witness->t, search);
      const OvercutBounds before = verdict.overcut.value_or({});
      verdict.overcut =
          OvercutBounds{std::max(before.lower_mm, found.depth_mm), std::max(before.upper_mm, found.depth_upper_mm)};
    };
    for (const Motion& one : motions_of(motion)) {
      if (verdict.witness->body == Body::head) {
        for (const HeadBody& body : heads_) join(SweptHead(one, body), kUnknown_mm);
        continue;
      }
      std::optional<KnownOvercut> known = depth_bounds_.at(tool).at(verdict.depth_upper_mm, one, part);
      const double rounded_bound = known ? known->upper_mm : kUnknown_mm;
      join(SweptTool(one, tools_[tool]->bare, known ? std::optional(std::move(known->sharp_zones)) : std::nullopt),
           rounded_bound);
    }
  }

  const Toolpath& toolpath_;
  const std::vector<const ToolVariants*>& tools_;
  const PreparedScene& scene_;
  const CheckOptions& options_;
  const std::vector<HeadBody>& heads_;
  CheckResult& result_;
  std::vector<bool> is_worst_;  // by move
  PagedVector<std::size_t> gouges_;
  std::map<std::size_t, DepthBound> depth_bounds_;  // by tool
};

}  // namespace

void measure_overcuts(const Toolpath& toolpath, const std::vector<const ToolVariants*>& tools,
                      const PreparedScene& scene, const CheckOptions& options, CheckResult& result,
                      const std::vector<HeadBody>& heads, const ProgressCall& progress, CheckpointStore* kept) {
  Measuring(toolpath, tools, scene, options, heads, result).run(progress, kept);
}

}  // namespace gouge
