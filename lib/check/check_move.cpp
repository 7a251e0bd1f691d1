#include "lib/check/check_move.h"

#include <algorithm>
#include <utility>

#include "lib/check/check_any_turn.h"
#include "lib/check/check_motions.h"

namespace gouge {
namespace {

/// Order of the states of two motions of one move: the state with the higher rank is that of the move.
int rank_of(const MoveVerdict& verdict) {
  switch (verdict.state) {
    case MoveState::clean:
      return 0;
    case MoveState::near_miss:
      return 1;
    case MoveState::not_certified:
      return 2;
    case MoveState::not_checked:
      return 3;
    case MoveState::buried:
      return 4;
    case MoveState::gouge:
      return 5;
  }
  return 5;
}

bool is_worse_verdict(const MoveVerdict& a, const MoveVerdict& b) {
  if (rank_of(a) != rank_of(b)) return rank_of(a) > rank_of(b);
  if (a.clearance_mm && b.clearance_mm) return *a.clearance_mm < *b.clearance_mm;
  return a.depth_mm > b.depth_mm;
}

/// Joins the verdict of another motion of the same move: the worse one stays, and the bound covers both.
void join_verdict(MoveVerdict&& other, MoveVerdict& verdict) {
  const double upper_mm = std::max(verdict.depth_upper_mm, other.depth_upper_mm);
  if (is_worse_verdict(other, verdict)) verdict = std::move(other);
  verdict.depth_upper_mm = upper_mm;
}

bool admits_others(const Motion& motion) { return motion.has_other() || motion.is_any(); }

}  // namespace

MoveVerdict check_move(const Motion& motion, MoveKind kind, const ToolVariants& tool, const PreparedScene& scene,
                       const CheckOptions& options, std::uint64_t* bounds) {
  MoveVerdict verdict;
  std::uint64_t spent = 0;
  check_moves({&motion, 1}, {&kind, 1}, tool, scene, options, {&verdict, 1}, {&spent, 1});
  if (bounds != nullptr) *bounds += spent;
  return verdict;
}

void check_moves(std::span<const Motion> motions, std::span<const MoveKind> kinds, const ToolVariants& tool,
                 const PreparedScene& scene, const CheckOptions& options, std::span<MoveVerdict> verdicts,
                 std::span<std::uint64_t> bounds) {
  if (std::ranges::none_of(motions, admits_others))
    return check_motions(motions, kinds, tool, scene, options, verdicts, bounds);
  std::vector<Motion> all;
  std::vector<MoveKind> kind_of;
  std::vector<std::size_t> move_of;
  const auto add = [&](Motion&& motion, std::size_t move) {
    all.push_back(std::move(motion));
    kind_of.push_back(kinds[move]);
    move_of.push_back(move);
  };
  for (std::size_t m = 0; m < motions.size(); ++m) {
    add(motions[m].alone(), m);
    if (auto other = motions[m].other()) add(*std::move(other), m);
  }
  std::vector<MoveVerdict> found(all.size());
  std::vector<std::uint64_t> spent(all.size(), 0);
  check_motions(all, kind_of, tool, scene, options, found, spent);
  for (std::size_t k = 0; k < all.size(); ++k) {
    const std::size_t m = move_of[k];
    bounds[m] += spent[k];
    if (k > 0 && move_of[k - 1] == m)
      join_verdict(std::move(found[k]), verdicts[m]);
    else
      verdicts[m] = std::move(found[k]);
  }
  check_any_turns(motions, kinds, tool, scene, options, verdicts, bounds);
}

}  // namespace gouge
