#include "lib/check/search.h"

#include <algorithm>
#include <cmath>

#include "lib/base/tolerance.h"
#include "lib/check/hull_bound.h"
#include "lib/check/sweep_filter.h"
#include "lib/geom/triangle.h"
#include "lib/motion/tool_interval.h"

namespace gouge {
namespace {

/// A part of a triangle during a time interval.
struct Candidate : SearchCandidate {
  std::uint32_t interval = 0;
  SearchSeed seed;
  bool is_time_next = false;
  std::array<Vec3, 3> piece{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
};

class MoveSearch : public BestFirstSearch<MoveSearch, Candidate> {
 public:
  static constexpr bool kDescends = true;

  MoveSearch(const Motion& motion, const std::vector<SearchTarget>& targets, const SearchQuery& query)
      : motion_(motion), intervals_(motion, motion), targets_(targets), query_(query) {}

  SearchResult find(const SearchStart& start) {
    if (start.value_mm > 0) take(start.value_mm, start.t, start.point, start.at);
    prune(start.certified_mm);
    for (const SearchSeed& seed : start.seeds) {
      const std::array<Vec3, 3> corners = targets_[seed.target].tree->corners(seed.triangle);
      for (std::uint32_t s = 0; s < intervals_.segments(); ++s) add_piece(s, seed, corners);
    }
    result_.value_upper_mm = std::max(run(), result_.value_mm);
    result_.is_decided = is_decided();
    return result_;
  }

  [[nodiscard]] double threshold_mm() const { return query_.pruning_threshold_mm(result_.value_mm); }
  [[nodiscard]] bool is_exhausted() const { return result_.bounds > query_.budget; }

  void split(const Candidate& c) {
    if (c.is_time_next) {
      const std::uint32_t half = intervals_.halve(c.interval);
      for (std::uint32_t k = 0; k < 2; ++k) add_piece(half + k, c.seed, c.piece);
    } else {
      const auto [at_end, at_start] = halves(c.piece, longest_edge(c.piece));
      add_piece(c.interval, c.seed, at_start);
      add_piece(c.interval, c.seed, at_end);
    }
  }

 private:
  [[nodiscard]] double reach_mm(std::uint32_t target) const { return query_.reach_mm + targets_[target].reach_mm; }

  void add_piece(std::uint32_t index, const SearchSeed& seed, const std::array<Vec3, 3>& piece) {
    ++result_.bounds;
    const ToolInterval& interval = intervals_[index];
    const PieceBound bound =
        bound_piece(*targets_[seed.target].tool, piece, interval, reach_mm(seed.target), threshold_mm());
    if (bound.value_mm > result_.value_mm)
      take(bound.value_mm, bound.is_at_end ? interval.t1 : interval.t0, piece[bound.corner], seed);
    Candidate c;
    c.upper_mm = bound.upper_mm + Tolerance::kRounding_mm;
    c.interval = index;
    c.seed = seed;
    c.piece = piece;
    c.is_time_next = bound.is_time_next && intervals_.can_halve(index);
    if (c.upper_mm > threshold_mm()) try_middle(c);
    offer(c);
  }

  /// Measures at the middle of the piece at mid interval, where a tool that dips in and out again has contact.
  void try_middle(const Candidate& c) {
    const ToolInterval& interval = intervals_[c.interval];
    const double t = interval.middle();
    const Vec3 p = (c.piece[0] + c.piece[1] + c.piece[2]) / 3.0;
    const ToolFrame frame = tool_frame(motion_, t, interval.segment);
    const ToolSample sample = sample_tool(*targets_[c.seed.target].tool, frame.to_tool(p));
    const double value = reach_mm(c.seed.target) - sample.nearest.signed_distance_mm;
    if (value > result_.value_mm) take(value, t, p, c.seed);
  }

  void take(double value, double t, const Vec3& point, const SearchSeed& at) {
    result_.value_mm = value;
    result_.has_witness = true;
    result_.t = t;
    result_.point = point;
    result_.at = at;
  }

  const Motion& motion_;
  ToolIntervals intervals_;
  const std::vector<SearchTarget>& targets_;
  const SearchQuery& query_;
  SearchResult result_;
};

}  // namespace

SearchResult search_move(const Motion& motion, const std::vector<SearchTarget>& targets, const SearchQuery& query,
                         const SearchStart& start) {
  if (!start.seeds.empty()) return MoveSearch(motion, targets, query).find(start);
  SearchResult result;
  result.value_mm = std::max(0.0, start.value_mm);
  result.has_witness = start.value_mm > 0;
  result.value_upper_mm = std::max(result.value_mm, start.certified_mm);
  result.t = start.t;
  result.point = start.point;
  result.at = start.at;
  return result;
}

SearchResult sweep_and_search(const Motion& motion, const std::vector<SearchTarget>& targets,
                              const SearchQuery& query) {
  const SweptMove swept = sweep_moves({&motion, 1}, targets, query).front();
  SearchResult result = search_move(motion, targets, query, swept.start);
  result.bounds += swept.bounds;
  return result;
}

}  // namespace gouge
