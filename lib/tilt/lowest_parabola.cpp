#include "lib/tilt/lowest_parabola.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace gouge {
namespace {

constexpr double kEverywhere = std::numeric_limits<double>::infinity();

}  // namespace

// Tilts of a lattice arrive in the order of its columns, and most of them are in the row after the one before.
TiltRows::TiltRows(const std::vector<Tilt>& tilts) {
  by_column_.reserve(tilts.size());
  for (const Tilt& tilt : tilts)
    by_column_.push_back({tilt.x(), tilt.y(), static_cast<std::uint32_t>(by_column_.size())});
  const auto column_order = [](const At& at) { return std::tuple(at.x, at.y, at.tilt); };
  if (!std::ranges::is_sorted(by_column_, {}, column_order)) std::ranges::sort(by_column_, {}, column_order);
  std::vector<double> rows;
  for (const At& at : by_column_) {
    if (columns_.empty() || at.x > columns_.back()) columns_.push_back(at.x);
    const auto row = std::ranges::lower_bound(rows, at.y);
    if (row == rows.end() || *row > at.y) rows.insert(row, at.y);
  }
  std::vector<std::uint32_t> row_of, ends(rows.size() + 1, 0);
  row_of.reserve(by_column_.size());
  for (std::size_t row = 0; const At& at : by_column_) {
    if (++row >= rows.size() || rows[row] < at.y || rows[row] > at.y)
      row = static_cast<std::size_t>(std::ranges::lower_bound(rows, at.y) - rows.begin());
    row_of.push_back(static_cast<std::uint32_t>(row));
    ++ends[row + 1];
  }
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  by_row_.resize(by_column_.size());
  for (std::size_t k = 0, column = 0; k < by_column_.size(); ++k) {
    if (by_column_[k].x > columns_[column]) ++column;
    by_column_[k].column = static_cast<std::uint32_t>(column);
    by_row_[ends[row_of[k]]++] = by_column_[k];
  }
}

// Places ascend. For equal places the minimum height is kept; for equal heights the first tilt.
void LowestParabolas::add(double at, double height, std::uint32_t tilt) {
  const double lifted = height + at * at;
  double begin = -kEverywhere;
  while (!envelope_.empty()) {
    const Parabola& last = envelope_.back();
    if (last.at < at) {
      begin = (lifted - last.lifted) / (2 * (at - last.at));
      if (begin > last.begin) break;
    } else if (!(lifted < last.lifted)) {
      return;
    }
    envelope_.pop_back();
    begin = -kEverywhere;
  }
  envelope_.push_back({at, lifted, begin, tilt});
}

template <typename Where, typename Found>
void LowestParabolas::look(std::size_t count, const Where& where, const Found& found) const {
  std::size_t lowest = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const double x = where(k);
    while (lowest + 1 < envelope_.size() && envelope_[lowest + 1].begin <= x) ++lowest;
    const Parabola& parabola = envelope_[lowest];
    found(k, parabola.lifted + x * (x - 2 * parabola.at), parabola.tilt);
  }
}

const std::vector<std::uint32_t>& LowestParabolas::find(const TiltRows& from, const std::vector<double>& heights,
                                                        double steepness, const TiltRows& to) {
  const std::size_t columns = to.columns_.size();
  row_y_.clear();
  row_heights_.clear();
  row_tilts_.clear();
  for (std::size_t first = 0, last = 0; first < from.by_row_.size(); first = last) {
    clear();
    const double y = from.by_row_[first].y;
    for (; last < from.by_row_.size() && !(from.by_row_[last].y > y); ++last) {
      const TiltRows::At& at = from.by_row_[last];
      if (heights[at.tilt] < kEverywhere) add(at.x, heights[at.tilt] / steepness, at.tilt);
    }
    if (envelope_.empty()) continue;
    row_y_.push_back(y);
    look(
        columns, [&](std::size_t k) { return to.columns_[k]; },
        [&](std::size_t, double height, std::uint32_t tilt) {
          row_heights_.push_back(height);
          row_tilts_.push_back(tilt);
        });
  }
  found_.assign(to.by_column_.size(), kNoTilt);
  if (row_y_.empty()) return found_;
  for (std::size_t first = 0, last = 0; first < to.by_column_.size(); first = last) {
    const std::size_t column = to.by_column_[first].column;
    while (last < to.by_column_.size() && to.by_column_[last].column == column) ++last;
    clear();
    for (std::size_t row = 0; row < row_y_.size(); ++row)
      add(row_y_[row], row_heights_[row * columns + column], static_cast<std::uint32_t>(row));
    look(
        last - first, [&](std::size_t k) { return to.by_column_[first + k].y; },
        [&](std::size_t k, double, std::uint32_t row) {
          found_[to.by_column_[first + k].tilt] = row_tilts_[row * columns + column];
        });
  }
  return found_;
}

}  // namespace gouge
