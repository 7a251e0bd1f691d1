#pragma once

#include <cstdint>
#include <vector>

#include "lib/drawing/drawing.h"

namespace gouge {

/// Lines of a drawing without invisible ones, so that the picture of a path of a million moves has only a few
/// megabytes. Strokes that continue in the same ink become one line. Points nearer than a tenth of a picture unit to
/// the line without them are left out. So are segments that lie on those last drawn in the same ink. Lines keep their
/// order.
class ThinLines {
 public:
  /// Requires a finite area, at least 1 wide and high. Lines may leave it. Parts outside never count as covered.
  ThinLines(const Vec2& low, const Vec2& high);

  /// Adds the stroke through `points`, drawn like `style` (whose own points are ignored). Strokes of one `ink` look
  /// alike.
  void add(const std::vector<Vec2>& points, std::uint8_t ink, const DrawnLine& style);

  [[nodiscard]] std::vector<DrawnLine> take();

 private:
  void end_stroke();
  void draw(const Vec2& a, const Vec2& b);
  bool cover(const Vec2& a, const Vec2& b);

  Vec2 low_;
  std::size_t columns_ = 0, rows_ = 0;
  std::vector<std::uint8_t> top_ink_;  // ink of every cell; 255: none
  std::uint8_t ink_ = 255;
  DrawnLine style_;
  std::vector<Vec2> passed_;  // points since the last one that was kept, which is the first of them
  std::vector<Vec2> kept_;
  bool is_joined_ = false;  // whether the next segment continues the last line
  std::vector<DrawnLine> lines_;
};

}  // namespace gouge
