#include "postproc/image/thin_lines.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lib/base/tolerance.h"
#include "lib/geom/triangle.h"

namespace gouge {
namespace {

constexpr double kSame = 0.1;        // in picture units: a tenth of a pixel is invisible
constexpr double kCellsPerUnit = 2;  // finer than the width of a line
// maximum number of points that one segment replaces; it bounds the work for each
constexpr std::size_t kMaxPassed = 64;
constexpr std::uint8_t kNoInk = 255;

}  // namespace

ThinLines::ThinLines(const Vec2& low, const Vec2& high) : low_(low) {
  columns_ = static_cast<std::size_t>(std::ceil(kCellsPerUnit * (high - low).x()));
  rows_ = static_cast<std::size_t>(std::ceil(kCellsPerUnit * (high - low).y()));
  top_ink_.assign(columns_ * rows_, kNoInk);
}

void ThinLines::add(const std::vector<Vec2>& points, std::uint8_t ink, const DrawnLine& style) {
  if (points.size() < 2) return;
  const bool goes_on =
      ink == ink_ && !passed_.empty() && (passed_.back() - points.front()).norm() <= Tolerance::kSamePoint_mm;
  if (!goes_on) {
    end_stroke();
    ink_ = ink;
    style_ = style;
    style_.points.clear();
    passed_.assign(1, points.front());
    kept_.assign(1, points.front());
  }
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Vec2& p = points[i];
    const bool is_near = std::all_of(passed_.begin(), passed_.end(),
                                     [&](const Vec2& q) { return distance_to_segment(q, kept_.back(), p) <= kSame; });
    if (passed_.size() > 1 && (!is_near || passed_.size() >= kMaxPassed)) {
      kept_.push_back(passed_.back());
      passed_.assign(1, kept_.back());
    }
    passed_.push_back(p);
  }
}

void ThinLines::end_stroke() {
  if (passed_.size() > 1) kept_.push_back(passed_.back());
  is_joined_ = false;
  for (std::size_t i = 1; i < kept_.size(); ++i) draw(kept_[i - 1], kept_[i]);
  passed_.clear();
  kept_.clear();
}

void ThinLines::draw(const Vec2& a, const Vec2& b) {
  if (!cover(a, b)) {
    is_joined_ = false;
    return;
  }
  if (!is_joined_) {
    lines_.push_back(style_);
    lines_.back().points.push_back(a);
  }
  lines_.back().points.push_back(b);
  is_joined_ = true;
}

// Inks the cells under the segment. Returns false if all of them had this ink already.
bool ThinLines::cover(const Vec2& a, const Vec2& b) {
  const int steps = std::max(1, static_cast<int>(std::ceil(2 * kCellsPerUnit * (b - a).norm())));
  bool is_new = false;
  for (int k = 0; k <= steps; ++k) {
    const Vec2 cell = kCellsPerUnit * (a + (b - a) * (static_cast<double>(k) / steps) - low_);
    const bool is_inside = cell.x() >= 0 && cell.y() >= 0 && cell.x() < static_cast<double>(columns_) &&
                           cell.y() < static_cast<double>(rows_);
    if (!is_inside) {
      is_new = true;
      continue;
    }
    std::uint8_t& ink = top_ink_[static_cast<std::size_t>(cell.y()) * columns_ + static_cast<std::size_t>(cell.x())];
    is_new = is_new || ink != ink_;
    ink = ink_;
  }
  return is_new;
}

std::vector<DrawnLine> ThinLines::take() {
  end_stroke();
  return std::exchange(lines_, {});
}

}  // namespace gouge
