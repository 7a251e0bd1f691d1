#pragma once

#include <string>
#include <variant>
#include <vector>

#include "lib/geom/vec.h"

// A picture as plain data: lines, filled shapes and text in picture units (x right, y DOWN). Modules that have
// something to show make one; postproc/image turns it into PNG (OpenCV) or SVG.

namespace gouge {

struct Colour {
  unsigned char r = 0, g = 0, b = 0;
  double opacity = 1;
};

struct DrawnLine {
  std::vector<Vec2> points;
  Colour colour;
  double width = 1;
  bool is_closed = false;
  std::vector<double> dashes;  ///< empty: solid
};

struct DrawnShape {
  std::vector<Vec2> points;  ///< outline of a filled polygon
  Colour fill;
};

enum class TextAnchor { left, middle, right };

struct DrawnText {
  Vec2 at = Vec2::Zero();  ///< anchor point of the text, on its base line
  std::string text;
  double size = 14;  ///< height of the font in picture units
  Colour colour;
  TextAnchor anchor = TextAnchor::left;
  bool is_bold = false;
};

struct Drawing {
  double width = 800, height = 600;
  Colour background{255, 255, 255, 1};
  std::vector<std::variant<DrawnLine, DrawnShape, DrawnText>> items;  ///< painted in this order
};

}  // namespace gouge
