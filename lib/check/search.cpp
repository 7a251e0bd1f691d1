#include "lib/check/search.h"

#include <algorithm>
#include <cmath>

#include "lib/check/hull_bound.h"
#include "lib/check/time_spans.h"

namespace gouge {
namespace {

// Covers the rounding of coordinates up to 1e5 mm in all bounds together.
constexpr double kRounding_mm = 1e-9;

/// A piece of a triangle, over a time span, with its upper bound.
struct Candidate {
  double upper_mm = 0;
  std::uint32_t serial = 0;  ///< ties are taken in the order they came up
  std::uint32_t span = 0;
  SearchSeed seed;
  bool is_time_next = false;
  std::array<Vec3, 3> piece{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
};

bool comes_later(const Candidate& a, const Candidate& b) {
  if (a.upper_mm < b.upper_mm) return true;
  return !(b.upper_mm < a.upper_mm) && a.serial > b.serial;
}

class Search {
 public:
  Search(const Motion& motion, const std::vector<SearchTarget>& targets, const SearchQuestion& question)
      : spans_(motion), targets_(targets), question_(question) {}

  SearchAnswer run(const SearchStart& start) {
    if (start.value_mm > 0) take(start.value_mm, start.t, start.point, start.at);
    discarded_mm_ = std::max(0.0, start.settled_mm);
    for (const SearchSeed& seed : start.seeds) {
      const std::array<Vec3, 3> corners = targets_[seed.target].tree->corners(seed.triangle);
      for (const std::uint32_t span : spans_.roots()) add_piece(span, seed, corners);
    }
    for (const Candidate& c : cut_) keep(c);
    while (!heap_.empty() && heap_.front().upper_mm > settled()) {
      if (answer_.bounds > question_.budget) {
        answer_.is_decided = false;
        break;
      }
      dive();
    }
    if (!heap_.empty()) discarded_mm_ = std::max(discarded_mm_, heap_.front().upper_mm);
    answer_.value_upper_mm = std::max({answer_.value_mm, discarded_mm_, 0.0});
    return answer_;
  }

 private:
  // From the most promising candidate straight down to where its best part is decided: a measured value close
  // to the bound comes early, even where many candidates promise the same.
  void dive() {
    std::pop_heap(heap_.begin(), heap_.end(), comes_later);
    Candidate next = heap_.back();
    heap_.pop_back();
    for (;;) {
      cut_.clear();
      expand(next);
      std::size_t best = 0;
      for (std::size_t k = 1; k < cut_.size(); ++k) {
        if (comes_later(cut_[best], cut_[k])) best = k;
      }
      for (std::size_t k = 0; k < cut_.size(); ++k) {
        if (k != best) keep(cut_[k]);
      }
      if (cut_.empty()) return;
      if (cut_[best].upper_mm <= settled() || answer_.bounds > question_.budget) return keep(cut_[best]);
      next = cut_[best];
    }
  }

  void keep(const Candidate& c) {
    if (c.upper_mm <= settled()) {
      discarded_mm_ = std::max(discarded_mm_, c.upper_mm);
      return;
    }
    heap_.push_back(c);
    std::push_heap(heap_.begin(), heap_.end(), comes_later);
  }

  /// Candidates whose bound is not above this need no further look.
  [[nodiscard]] double settled() const {
    const bool is_above = answer_.value_mm > question_.tolerance_mm;
    return is_above ? answer_.value_mm + question_.gap_mm : question_.tolerance_mm + question_.resolution_mm;
  }

  void offer(const Candidate& c) {
    if (c.upper_mm <= settled()) {
      discarded_mm_ = std::max(discarded_mm_, c.upper_mm);
      return;
    }
    cut_.push_back(c);
    cut_.back().serial = serial_++;
  }

  void add_piece(std::uint32_t span_index, const SearchSeed& seed, const std::array<Vec3, 3>& piece) {
    ++answer_.bounds;
    const TimeSpan& span = spans_.span(span_index);
    const PieceBound bound = bound_piece(*targets_[seed.target].tool, piece, span, question_.reach_mm, settled());
    if (bound.value_mm > answer_.value_mm)
      take(bound.value_mm, bound.is_at_end ? span.t1 : span.t0, piece[bound.corner], seed);
    Candidate c;
    c.upper_mm = bound.upper_mm + kRounding_mm;
    c.span = span_index;
    c.seed = seed;
    c.piece = piece;
    c.is_time_next = bound.is_time_next && spans_.can_halve(span_index);
    if (c.upper_mm > settled()) try_middle(c);
    offer(c);
  }

  /// The middle of the piece at mid span: where a tool that dips in and out again is met.
  void try_middle(const Candidate& c) {
    const TimeSpan& span = spans_.span(c.span);
    const double t = 0.5 * (span.t0 + span.t1);
    const Vec3 p = (c.piece[0] + c.piece[1] + c.piece[2]) / 3.0;
    const ToolFrame frame = spans_.frame_at(t, span.stretch);
    const ToolSample sample = sample_tool(*targets_[c.seed.target].tool, frame.to_tool(p));
    const double value = question_.reach_mm - sample.answer.signed_distance_mm;
    if (value > answer_.value_mm) take(value, t, p, c.seed);
  }

  void take(double value, double t, const Vec3& point, const SearchSeed& at) {
    answer_.value_mm = value;
    answer_.has_witness = true;
    answer_.t = t;
    answer_.point = point;
    answer_.at = at;
  }

  void expand(const Candidate& c) {
    if (!c.is_time_next) return halve_piece(c);
    const std::uint32_t half = spans_.halve(c.span);
    for (std::uint32_t k = 0; k < 2; ++k) add_piece(half + k, c.seed, c.piece);
  }

  void halve_piece(const Candidate& c) {
    std::size_t longest = 0;
    double length2 = -1;
    for (std::size_t k = 0; k < 3; ++k) {
      const double l2 = (c.piece[(k + 1) % 3] - c.piece[k]).squaredNorm();
      if (l2 > length2) {
        length2 = l2;
        longest = k;
      }
    }
    const Vec3 middle = 0.5 * (c.piece[longest] + c.piece[(longest + 1) % 3]);
    std::array<Vec3, 3> half = c.piece;
    half[(longest + 1) % 3] = middle;
    add_piece(c.span, c.seed, half);
    half = c.piece;
    half[longest] = middle;
    add_piece(c.span, c.seed, half);
  }

  TimeSpans spans_;
  const std::vector<SearchTarget>& targets_;
  const SearchQuestion& question_;
  std::vector<Candidate> heap_;
  std::vector<Candidate> cut_;  ///< what the last cut made, not yet kept
  std::uint32_t serial_ = 0;
  double discarded_mm_ = 0;
  SearchAnswer answer_;
};

}  // namespace

SearchAnswer search_move(const Motion& motion, const std::vector<SearchTarget>& targets,
                         const SearchQuestion& question, const SearchStart& start) {
  if (!start.seeds.empty()) return Search(motion, targets, question).run(start);
  SearchAnswer answer;
  answer.value_mm = std::max(0.0, start.value_mm);
  answer.has_witness = start.value_mm > 0;
  answer.value_upper_mm = std::max(answer.value_mm, start.settled_mm);
  answer.t = start.t;
  answer.point = start.point;
  answer.at = start.at;
  return answer;
}

}  // namespace gouge
