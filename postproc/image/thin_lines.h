#pragma once

#include <cstdint>
#include <vector>

#include "lib/drawing/drawing.h"

namespace gouge {

/// Lines of a drawing without the invisible ones, so that a path of a million moves makes a picture of a few megabytes.
/// Strokes that go on in the same ink are one line. Points nearer than a tenth of a picture unit to the line without
/// them are left out. So are segments that lie on the last ones drawn in the same ink. Lines keep their order.
class ThinLines {
 public:
  /// Requires a finite area, at least 1 wide and high. Lines may leave it. Parts outside are never left out as covered.
  ThinLines(const Vec2& low, const Vec2& high);

  /// The stroke through `points`, drawn like `style` (whose own points do not count). Strokes of one `ink` look alike.
  void add(const std::vector<Vec2>& points, std::uint8_t ink, const DrawnLine& style);

  [[nodiscard]] std::vector<DrawnLine> take();

 private:
  void end_stroke();
  void draw(const Vec2& a, const Vec2& b);
  bool cover(const Vec2& a, const Vec2& b);

  Vec2 low_;
  std::size_t columns_ = 0, rows_ = 0;
  std::vector<std::uint8_t> top_ink_;  // of every cell, 255 for none
  std::uint8_t ink_ = 255;
  DrawnLine style_;
  std::vector<Vec2> passed_;  // since the last point that was kept, which is the first
  std::vector<Vec2> kept_;
  bool is_joined_ = false;  // to the last line
  std::vector<DrawnLine> lines_;
};

}  // namespace gouge
