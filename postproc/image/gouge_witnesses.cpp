#include "postproc/image/gouge_witnesses.h"

#include <algorithm>
#include <cmath>

#include "lib/field/field_instants.h"
#include "lib/hierarchy/sight.h"
#include "lib/motion/motion_law.h"

namespace gouge {

std::vector<GougeWitness> gouge_witnesses(const CheckedToolpath& input, std::size_t most) {
  std::vector<std::size_t> gouging;
  const MoveVerdicts& verdicts = input.result->verdicts;
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    if (verdicts[i].state == MoveState::gouge && verdicts[i].witness) gouging.push_back(i);
  }
  std::vector<GougeWitness> out;
  const std::size_t every = gouging.size() / std::max<std::size_t>(most, 1) + 1;
  for (std::size_t k = 0; k < gouging.size(); k += every) {
    const MoveVerdict& verdict = verdicts[gouging[k]];
    const Motion motion = input.options.law.of(*input.toolpath, gouging[k]);
    const double travel = motion.is_defined() ? path_length_mm(motion) : 0;
    // A trace is about as wide as the root of its depth.
    const double weight = std::max(travel, verdict.depth_mm) * std::sqrt(std::max(verdict.depth_mm, 0.0));
    out.push_back({verdict.witness->point, verdict.witness->normal, weight});
  }
  return out;
}

bool is_in_sight(const CheckedToolpath& input, const Vec3& point, const Vec3& toward, double clear_mm) {
  return std::ranges::none_of(input.prepared->obstacles(), [&](const PreparedObstacle& obstacle) {
    return is_hidden(obstacle.tree, point, toward, clear_mm);
  });
}

}  // namespace gouge
