#include "lib/tilt/closed_contours.h"

#include <algorithm>
#include <array>
#include <set>

namespace gouge {
namespace {

using PoseKey = std::array<double, 6>;

PoseKey key_of(const Pose& pose) {
  return {pose.tip.x(), pose.tip.y(), pose.tip.z(), pose.axis.x(), pose.axis.y(), pose.axis.z()};
}

}  // namespace

std::vector<Seam> find_seams(const Toolpath& path, const std::vector<bool>& is_named) {
  constexpr std::size_t kMinMoves = 3;  // minimum of a contour; fewer moves go there and back
  const Moves& moves = path.moves;
  std::map<PoseKey, std::size_t> visited;  // for the named moves: the pose at an end, and the last move that ended
                                           // there
  for (std::size_t i = 0; i < moves.size(); ++i)
    if (is_named[i]) visited.emplace(key_of(moves[i].end), kNone);
  std::vector<Seam> seams;
  std::size_t since = 0;  // visits of earlier moves do not count
  const auto visit = [&](std::size_t i) {
    const auto at = visited.find(key_of(moves[i].end));
    if (at == visited.end()) return;
    const bool was_here = at->second != kNone && at->second >= since;
    if (was_here && i - at->second < kMinMoves) return;
    if (was_here) {
      seams.push_back({at->second, i});
      since = i;
    }
    at->second = i;
  };
  for (std::size_t i = 0; i < moves.size(); ++i) {
    const bool continues = i > 0 && moves[i].has_start && moves[i].kind == MoveKind::feed &&
                           moves[i].curve_kind == CurveKind::none && moves[i].tool == moves[i - 1].tool;
    if (!continues) since = i;
    visit(i);
  }
  return seams;
}

ClosedContours::ClosedContours(const TiltJob& job) : path_(job.path) {
  for (const Seam& seam : find_seams(path_, moves_near(path_, job.is_wanted, job.options.blend_mm))) {
    other_end_.emplace(seam.begin, seam.end);
    other_end_.emplace(seam.end, seam.begin);
  }
}

void ClosedContours::begin(const std::vector<TiltRun>& runs) {
  std::set<std::size_t> in_runs;
  for (const TiltRun& run : runs) {
    for (const TiltPosition& at : run.positions)
      if (is_end(at)) in_runs.insert(at.move);
  }
  for (const auto& [move, other] : other_end_)
    if (!in_runs.contains(move)) axes_.try_emplace(move, path_.moves[move].end.axis);
}

std::optional<std::vector<TiltPosition>> ClosedContours::with_known(const std::vector<TiltPosition>& positions) const {
  std::optional<std::vector<TiltPosition>> known;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (!is_end(positions[i]) || positions[i].is_fixed()) continue;
    const auto [first, last] = other_end_.equal_range(positions[i].move);
    const auto found = std::find_if(first, last, [&](const auto& ends) { return axes_.contains(ends.second); });
    if (found == last) continue;
    if (!known) known = positions;
    (*known)[i].given = positions[i].tilt_to(axes_.at(found->second));
  }
  return known;
}

std::vector<std::pair<std::size_t, std::size_t>> ClosedContours::loops(const TiltSpace& space) const {
  std::vector<std::pair<std::size_t, std::size_t>> all;
  std::map<std::size_t, std::size_t> seen;  // positions of the run by their moves
  for (std::size_t i = 0; i < space.size(); ++i) {
    if (!is_end(space[i])) continue;
    const auto [first, last] = other_end_.equal_range(space[i].move);
    for (auto ends = first; ends != last; ++ends) {
      if (const auto begin = seen.find(ends->second); begin != seen.end()) all.emplace_back(begin->second, i);
    }
    seen.emplace(space[i].move, i);
  }
  return all;
}

void ClosedContours::learn(const TiltSpace& space, const TiltSequence& tilts) {
  for (std::size_t i = 0; i < space.size(); ++i)
    if (is_end(space[i])) axes_.insert_or_assign(space[i].move, space[i].axis_for(tilts[i]));
}

}  // namespace gouge
