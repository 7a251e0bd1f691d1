#include "postproc/image/render_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "lib/base/number_text.h"
#include "postproc/report/report_text.h"

namespace gouge {
namespace {

// Returns a number with two decimals. That is finer than any screen or printer at these sizes, and keeps the files
// small.
std::string number(double value) {
  std::string text = fixed_text(value, 2);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string hex_colour(const Colour& c) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text = "#";
  for (const unsigned char part : {c.r, c.g, c.b}) {
    text += kDigits[part / 16];
    text += kDigits[part % 16];
  }
  return text;
}

std::string opacity(std::string_view attribute, const Colour& c) {
  if (c.opacity >= 1) return {};
  return " " + std::string(attribute) + "=\"" + number(std::max(c.opacity, 0.0)) + "\"";
}

std::string point_list(const std::vector<Vec2>& points) {
  std::string out;
  for (const Vec2& p : points) {
    if (!std::isfinite(p.x()) || !std::isfinite(p.y())) continue;
    if (!out.empty()) out += ' ';
    out += number(p.x()) + "," + number(p.y());
  }
  return out;
}

struct SvgPainter {
  std::string out;

  void operator()(const DrawnLine& line) {
    out += line.is_closed ? "<polygon" : "<polyline";
    out += " points=\"" + point_list(line.points) + "\" fill=\"none\" stroke=\"" + hex_colour(line.colour) +
           "\" stroke-width=\"" + number(line.width) + "\" stroke-linejoin=\"round\" stroke-linecap=\"round\"" +
           opacity("stroke-opacity", line.colour);
    if (!line.dashes.empty()) {
      out += " stroke-dasharray=\"";
      for (std::size_t i = 0; i < line.dashes.size(); ++i) out += (i > 0 ? " " : "") + number(line.dashes[i]);
      out += "\"";
    }
    out += "/>\n";
  }

  void operator()(const DrawnShape& shape) {
    out += "<polygon points=\"" + point_list(shape.points) + "\" fill=\"" + hex_colour(shape.fill) + "\"" +
           opacity("fill-opacity", shape.fill) + "/>\n";
  }

  void operator()(const DrawnText& text) {
    static constexpr std::array<std::string_view, 3> kAnchors{"start", "middle", "end"};
    out += "<text x=\"" + number(text.at.x()) + "\" y=\"" + number(text.at.y()) + "\" font-size=\"" +
           number(text.size) + "\" fill=\"" + hex_colour(text.colour) + "\"" + opacity("fill-opacity", text.colour);
    if (text.anchor != TextAnchor::left) {
      out += " text-anchor=\"" + std::string(kAnchors[static_cast<std::size_t>(text.anchor)]) + "\"";
    }
    if (text.is_bold) out += " font-weight=\"bold\"";
    out += ">" + xml_escaped(text.text) + "</text>\n";
  }
};

}  // namespace

std::string render_svg(const Drawing& drawing) {
  const std::string width = number(drawing.width);
  const std::string height = number(drawing.height);
  SvgPainter painter;
  painter.out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" +
                width + "\" height=\"" + height + "\" viewBox=\"0 0 " + width + " " + height +
                "\" font-family=\"Helvetica, Arial, 'DejaVu Sans', sans-serif\">\n<rect width=\"" + width +
                "\" height=\"" + height + "\" fill=\"" + hex_colour(drawing.background) + "\"" +
                opacity("fill-opacity", drawing.background) + "/>\n";
  for (const auto& item : drawing.items) std::visit(painter, item);
  painter.out += "</svg>\n";
  return painter.out;
}

}  // namespace gouge
