#include "lib/overcut/measure_overcut.h"

#include <algorithm>

#include "lib/base/parallel.h"
#include "lib/check/path_motion.h"
#include "lib/overcut/overcut_search.h"
#include "lib/overcut/swept_head.h"
#include "lib/overcut/swept_tool.h"

namespace gouge {
namespace {

// The whole search costs a millisecond a move and more, the check itself a small part of that; the worst move
// of a finding is worth it, the others get what a short search finds.
constexpr std::size_t kCellsOfOthers = 64;

std::vector<bool> worst_moves(const CheckResult& result) {
  std::vector<bool> is_worst(result.verdicts.size(), false);
  for (const Event& event : result.events) is_worst[event.worst_move] = true;
  return is_worst;
}

}  // namespace

void measure_overcuts(const Toolpath& toolpath, const std::vector<const ToolVariants*>& tools,
                      const PreparedScene& scene, const CheckOptions& options, CheckResult& result,
                      const std::vector<HeadBody>& heads) {
  std::vector<std::size_t> gouges;
  for (std::size_t i = 0; i < result.verdicts.size(); ++i) {
    const MoveVerdict& v = result.verdicts[i];
    if (v.state != MoveState::gouge || !v.witness) continue;
    gouges.push_back(i);
    static_cast<void>(scene.surface(v.witness->against, v.witness->mesh));  // made by all threads, not within one
  }
  const std::vector<bool> is_worst = worst_moves(result);
  for_each_chunk(gouges.size(), 4, options.threads, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) {
      MoveVerdict& verdict = result.verdicts[gouges[k]];
      const Move& move = toolpath.moves[gouges[k]];
      const DepthBody& solid = scene.surface(verdict.witness->against, verdict.witness->mesh);
      if (!solid.is_solid || tools[move.tool] == nullptr) continue;
      const Motion motion = motion_of(toolpath, gouges[k], options.rapid);
      // Where the tool's boundary comes to lie once the witness is followed through the tool.
      const Vec3 seed = verdict.witness->point - verdict.depth_mm * verdict.witness->normal;
      OvercutOptions search;
      if (!is_worst[gouges[k]]) search.most_cells = kCellsOfOthers;
      const auto join = [&](const SweptSolid& moving) {
        const Overcut found = find_overcut(moving, solid, seed, verdict.witness->t, search);
        verdict.overcut_mm = std::max(verdict.overcut_mm.value_or(0), found.depth_mm);
        verdict.overcut_upper_mm = std::max(verdict.overcut_upper_mm, found.depth_upper_mm);
      };
      if (verdict.witness->body != Body::head) {
        join(SweptTool(motion, tools[move.tool]->bare));
        continue;
      }
      for (const HeadBody& body : heads) join(SweptHead(motion, body));
    }
  });
  result.worst_overcut_mm = 0;
  for (const std::size_t i : gouges)
    result.worst_overcut_mm = std::max(result.worst_overcut_mm, result.verdicts[i].overcut_mm.value_or(0));
}

}  // namespace gouge
