#include "lib/path/axis_tilt.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "lib/path/chords.h"
#include "lib/path/draw_tilt_curve.h"
#include "lib/path/path_info.h"
#include "lib/path/programmed_axis.h"

namespace gouge {
namespace {

constexpr double kGap_mm = 2;

/// Moves [first, last) and how long their path is.
struct MoveSpan {
  std::size_t first = 0, last = 0;
  double length_mm = 0;
};

class TiltedSpans {
 public:
  TiltedSpans(const Toolpath& after, const std::vector<double>& tilts) : after_(after), tilts_(tilts) {}

  [[nodiscard]] std::vector<MoveSpan> find() {
    for (std::size_t k = 0; k < tilts_.size(); ++k) {
      const bool has_start = after_.moves[k].has_start;
      const bool is_tilted =
          tilts_[k] > AxisTilts::kLeast_rad || (has_start && k > 0 && tilts_[k - 1] > AxisTilts::kLeast_rad);
      const double length_mm = has_start ? move_length_mm(after_, k) : 0;
      if (!has_start) is_open_ = false;
      if (is_tilted)
        extend(k, length_mm);
      else
        gap_mm_ += length_mm;
    }
    return std::move(spans_);
  }

 private:
  void extend(std::size_t k, double length_mm) {
    if (!is_open_ || gap_mm_ > kGap_mm) {
      spans_.push_back({k, k, 0});
    } else {
      spans_.back().length_mm += gap_mm_;
    }
    spans_.back().last = k + 1;
    spans_.back().length_mm += length_mm;
    gap_mm_ = 0;
    is_open_ = true;
  }

  const Toolpath& after_;
  const std::vector<double>& tilts_;
  std::vector<MoveSpan> spans_;
  double gap_mm_ = 0;
  bool is_open_ = false;
};

std::vector<MoveSpan> longest(std::vector<MoveSpan> spans, std::size_t most) {
  if (spans.size() <= most) return spans;
  std::vector<std::size_t> order(spans.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return spans[a].length_mm > spans[b].length_mm; });
  order.resize(most);
  std::sort(order.begin(), order.end());
  std::vector<MoveSpan> kept;
  kept.reserve(most);
  for (const std::size_t i : order) kept.push_back(spans[i]);
  return kept;
}

}  // namespace

AxisTilts find_axis_tilts(const Toolpath& before, const Toolpath& after, const std::vector<std::size_t>& origins,
                          std::size_t most_runs) {
  AxisTilts found;
  if (origins.size() != after.moves.size()) return found;
  const std::vector<Vec3> programmed = programmed_axes(before, after, origins);
  std::vector<double> tilts(programmed.size());
  for (std::size_t k = 0; k < programmed.size(); ++k) {
    tilts[k] = angle_between_rad(programmed[k], after.moves[k].end.axis);
    if (!(tilts[k] > AxisTilts::kLeast_rad)) continue;
    ++found.positions;
    found.tilt_rad.take(tilts[k], k);
  }
  const std::vector<MoveSpan> spans = TiltedSpans(after, tilts).find();
  for (const MoveSpan& span : longest(spans, most_runs)) {
    TiltedRun run = draw_tilt_curve(after, programmed, span.first, span.last);
    for (std::size_t k = span.first; k < span.last; ++k) run.tilt_rad.take(tilts[k], k);
    found.runs.push_back(std::move(run));
  }
  found.runs_left_out = spans.size() - found.runs.size();
  return found;
}

}  // namespace gouge
