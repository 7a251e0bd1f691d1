#include "lib/overcut/measure_overcut.h"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "lib/base/parallel.h"
#include "lib/check/verdict_bytes.h"
#include "lib/motion/motion.h"
#include "lib/motion/motion_law.h"
#include "lib/overcut/depth_bound.h"
#include "lib/overcut/overcut_search.h"
#include "lib/overcut/swept_solid.h"
#include "lib/overcut/swept_tool.h"

namespace gouge {
namespace {

constexpr std::size_t kCellsOfOthers = 2'000;  // maximum number of cells for a move that is not the worst of its
                                               // finding

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
    depth_bounds_.try_emplace(tool, tools_[tool]->bare).first->second.prepare(result_.verdicts[move].depth_upper_mm);
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
    const auto join = [&](SweptSolid&& moving) {
      OvercutOptions search;
      if (!is_worst_[move]) search = {kCellsOfOthers, true};
      const Overcut found = find_overcut(moving, part, seed, verdict.witness->t, search);
      const OvercutBounds before = verdict.overcut.value_or({});
      verdict.overcut =
          OvercutBounds{std::max(before.lower_mm, found.depth_mm), std::max(before.upper_mm, found.depth_upper_mm)};
    };
    for (const Motion& one : motions_of(motion)) {
      if (verdict.witness->body == Body::head) {
        for (const HeadBody& body : heads_) join(SweptHead(one, body));
        continue;
      }
      join(SweptTool(one, tools_[tool]->bare, depth_bounds_.at(tool).at(verdict.depth_upper_mm, one, part)));
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
