#include "lib/tilt/closed_contours.h"

#include <algorithm>
#include <array>

namespace gouge {
namespace {

using PoseKey = std::array<double, 6>;

PoseKey key_of(const Pose& pose) {
  return {pose.tip.x(), pose.tip.y(), pose.tip.z(), pose.axis.x(), pose.axis.y(), pose.axis.z()};
}

}  // namespace

std::vector<Seam> find_seams(const Toolpath& path, const std::vector<bool>& is_named) {
  constexpr std::size_t kLeastMoves = 3;  // of a contour; less is there and back
  const Moves& moves = path.moves;
  std::map<PoseKey, std::size_t> visited;  // of the named ones: the move that ended there last
  for (std::size_t i = 0; i < moves.size(); ++i)
    if (is_named[i]) visited.emplace(key_of(moves[i].end), kNone);
  std::vector<Seam> seams;
  std::size_t since = 0;  // what was visited before counts no more
  const auto visit = [&](std::size_t i) {
    const auto at = visited.find(key_of(moves[i].end));
    if (at == visited.end()) return;
    const bool was_here = at->second != kNone && at->second >= since;
    if (was_here && i - at->second < kLeastMoves) return;
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

void ClosedContours::begin(const std::vector<TiltRun>& runs) {
  programmed_.clear();
  for (const Seam& seam : seams_) {
    for (const std::size_t move : {seam.begin, seam.end}) {
      const bool is_in_run = std::ranges::any_of(runs, [&](const TiltRun& run) {
        return std::ranges::any_of(run.positions, [&](const TiltPosition& at) { return is_end(at, move); });
      });
      if (!is_in_run) programmed_[move] = path_.moves[move].end.axis;
    }
  }
}

bool ClosedContours::give_known(std::vector<TiltPosition>& positions) const {
  bool is_any = false;
  for (const Seam& seam : seams_) {
    for (const auto& [move, other] : {std::pair(seam.begin, seam.end), std::pair(seam.end, seam.begin)}) {
      const auto tilted = tilted_.find(other), stays = programmed_.find(other);
      if (tilted == tilted_.end() && stays == programmed_.end()) continue;
      for (TiltPosition& at : positions) {
        if (!is_end(at, move) || at.is_fixed()) continue;
        at.given = at.tilt_to(tilted != tilted_.end() ? tilted->second : stays->second);
        is_any = true;
      }
    }
  }
  return is_any;
}

std::vector<std::pair<std::size_t, std::size_t>> ClosedContours::loops(
    const std::vector<TiltPosition>& positions) const {
  std::vector<std::pair<std::size_t, std::size_t>> all;
  const auto index_of = [&](std::size_t move) {
    const auto found = std::ranges::find_if(positions, [&](const TiltPosition& at) { return is_end(at, move); });
    return static_cast<std::size_t>(found - positions.begin());
  };
  for (const Seam& seam : seams_) {
    const std::size_t begin = index_of(seam.begin), end = index_of(seam.end);
    if (begin < positions.size() && end < positions.size()) all.emplace_back(begin, end);
  }
  return all;
}

void ClosedContours::learn(const TiltSpace& space, const TiltSequence& tilts) {
  for (std::size_t i = 0; i < space.size(); ++i) {
    for (const Seam& seam : seams_) {
      for (const std::size_t move : {seam.begin, seam.end})
        if (is_end(space[i], move)) tilted_[move] = space[i].axis_for(tilts[i]);
    }
  }
}

}  // namespace gouge
