#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "postproc/image/ascii_text.h"
#include "postproc/image/encode_png.h"
#include "postproc/image/font.h"
#include "postproc/image/render_drawing.h"

// The only file that knows OpenCV. Everything is painted kSupersampling times larger and averaged down.

namespace gouge {
namespace {

constexpr int kSubpixelBits = 4;
constexpr double kLargestSide = 16384;
constexpr double kCapHeightOfSize = 0.70;   // of the font's size, as in common sans-serif fonts
constexpr double kCapHeightOfEm = 0.729;    // of DejaVu Sans
constexpr double kHersheyCapHeight = 21.0;  // of FONT_HERSHEY_SIMPLEX at scale 1

cv::Scalar bgr(const Colour& c) {
  return {static_cast<double>(c.b), static_cast<double>(c.g), static_cast<double>(c.r)};
}

cv::Point fixed_point(const Vec2& p) {
  // Far outside the picture a coordinate only has to stay outside; this keeps it within OpenCV's integers.
  const auto to_fixed = [](double x) {
    return static_cast<int>(
        std::lround(std::clamp(x, -4.0 * kLargestSide, 4.0 * kLargestSide) * kSupersampling * (1 << kSubpixelBits)));
  };
  // Picture units count from the left top corner of a pixel, OpenCV's from its centre.
  return {to_fixed(p.x()) - (1 << (kSubpixelBits - 1)), to_fixed(p.y()) - (1 << (kSubpixelBits - 1))};
}

std::vector<cv::Point> fixed_points(const std::vector<Vec2>& points) {
  std::vector<cv::Point> out;
  out.reserve(points.size());
  for (const Vec2& p : points) out.push_back(fixed_point(p));
  return out;
}

// Cuts a line into the strokes its dash pattern leaves. An empty or useless pattern leaves it whole.
std::vector<std::vector<Vec2>> cut_dashes(const DrawnLine& line) {
  std::vector<Vec2> points = line.points;
  if (line.is_closed && !points.empty()) points.push_back(points.front());
  double period = 0;
  for (const double d : line.dashes) period += d;
  if (line.dashes.empty() || !(period > 0.5)) return {points};
  std::vector<std::vector<Vec2>> strokes;
  std::size_t dash = 0;
  double left = line.dashes[0];
  bool is_pen_down = true;
  std::vector<Vec2> stroke{points.empty() ? Vec2(0, 0) : points[0]};
  for (std::size_t i = 1; i < points.size(); ++i) {
    Vec2 at = points[i - 1];
    double rest = (points[i] - at).norm();
    const Vec2 along = rest > 0 ? Vec2((points[i] - at) / rest) : Vec2(0, 0);
    while (rest > left) {
      at += along * left;
      rest -= left;
      if (is_pen_down) {
        stroke.push_back(at);
        strokes.push_back(stroke);
      }
      stroke.assign(1, at);
      is_pen_down = !is_pen_down;
      dash = (dash + 1) % line.dashes.size();
      left = std::max(line.dashes[dash], 0.25);
    }
    left -= rest;
    if (is_pen_down) stroke.push_back(points[i]);
  }
  if (is_pen_down && stroke.size() > 1) strokes.push_back(stroke);
  return strokes;
}

class Painter {
 public:
  Painter(int width, int height, const Colour& background)
      : image_(height * kSupersampling, width * kSupersampling, CV_8UC3, bgr(background)) {
    // Threads are started by for_each_chunk alone, which knows how many may be and does without.
    cv::setNumThreads(1);
  }

  void paint(const PlacedRaster& placed) {
    if (placed.raster.rgb.empty()) return;
    cv::Mat rgb(placed.raster.height, placed.raster.width, CV_8UC3,
                const_cast<std::uint8_t*>(placed.raster.rgb.data()));
    const cv::Rect target(placed.x * kSupersampling, placed.y * kSupersampling, rgb.cols, rgb.rows);
    const cv::Rect seen = target & cv::Rect(0, 0, image_.cols, image_.rows);
    if (seen.empty()) return;
    const cv::Rect source(seen.x - target.x, seen.y - target.y, seen.width, seen.height);
    cv::Mat view = image_(seen);
    cv::cvtColor(rgb(source), view, cv::COLOR_RGB2BGR);
  }

  void operator()(const DrawnLine& line) {
    if (line.points.size() < 2) return;
    const double width = line.width * kSupersampling;
    const int thickness = std::max(1, static_cast<int>(std::lround(width)));
    Colour colour = line.colour;
    if (width < 1) colour.opacity *= width;
    std::vector<std::vector<cv::Point>> strokes;
    for (const std::vector<Vec2>& stroke : cut_dashes(line)) strokes.push_back(fixed_points(stroke));
    std::vector<cv::Point> all;
    for (const auto& stroke : strokes) all.insert(all.end(), stroke.begin(), stroke.end());
    blend(bounds(all, thickness + 2), colour, [&](cv::Mat& mask, const cv::Point& shift) {
      for (auto& stroke : strokes) {
        for (cv::Point& p : stroke) p -= shift;
        cv::polylines(mask, stroke, false, cv::Scalar(255), thickness, cv::LINE_AA, kSubpixelBits);
      }
    });
  }

  void operator()(const DrawnShape& shape) {
    if (shape.points.size() < 3) return;
    std::vector<cv::Point> outline = fixed_points(shape.points);
    blend(bounds(outline, 2), shape.fill, [&](cv::Mat& mask, const cv::Point& shift) {
      for (cv::Point& p : outline) p -= shift;
      cv::fillPoly(mask, std::vector<std::vector<cv::Point>>{outline}, cv::Scalar(255), cv::LINE_AA, kSubpixelBits);
    });
  }

  void operator()(const DrawnText& text) {
    if (text.text.empty() || !(text.size > 0)) return;
    if (!installed_font().has_letters()) return draw_strokes(text);
    const double size = em_of(text.size) * kSupersampling;
    const double left = std::clamp(text.at.x(), -1e5, 1e5) * kSupersampling -
                        share_before(text.anchor) * installed_font().width(text.text, text.is_bold) * size;
    const double whole = std::floor(left);
    const TextMask letters = installed_font().draw(text.text, std::min(size, 4096.0), text.is_bold, left - whole);
    // The base line lies between two pixels of the picture: feet that end there are sharp.
    const int base = static_cast<int>(std::lround(std::clamp(text.at.y(), -1e5, 1e5))) * kSupersampling;
    const cv::Rect area(static_cast<int>(whole) + letters.left, base + letters.top, letters.width, letters.height);
    blend(area, text.colour, [&](cv::Mat& mask, const cv::Point&) {
      const cv::Rect seen = area & cv::Rect(0, 0, image_.cols, image_.rows);
      const cv::Mat greys(letters.height, letters.width, CV_8UC1, const_cast<std::uint8_t*>(letters.grey.data()));
      greys(cv::Rect(seen.tl() - area.tl(), seen.size())).copyTo(mask);
    });
  }

  // Without any font installed: OpenCV's letters of strokes, which are ASCII only.
  void draw_strokes(const DrawnText& text) {
    const std::string ascii = ascii_text(text.text);
    const int thickness = stroke_of(text.size, text.is_bold);
    const double width = text_width(ascii, text.size, text.is_bold) * kSupersampling;
    const double anchor = share_before(text.anchor);
    const cv::Point at(
        static_cast<int>(std::lround(std::clamp(text.at.x(), -1e5, 1e5) * kSupersampling - anchor * width)),
        static_cast<int>(std::lround(std::clamp(text.at.y(), -1e5, 1e5) * kSupersampling)));
    const int high = static_cast<int>(std::lround(text.size * kSupersampling)) + 4;
    const cv::Rect area(at.x - high, at.y - high, static_cast<int>(width) + 2 * high, 2 * high);
    blend(area, text.colour, [&](cv::Mat& mask, const cv::Point&) {
      const cv::Point origin = at - (area & cv::Rect(0, 0, image_.cols, image_.rows)).tl();
      cv::putText(mask, ascii, origin, cv::FONT_HERSHEY_SIMPLEX, scale_of(text.size), cv::Scalar(255), thickness,
                  cv::LINE_AA);
    });
  }

  [[nodiscard]] Result<std::string> png() const {
    cv::Mat small;
    cv::resize(image_, small, cv::Size(image_.cols / kSupersampling, image_.rows / kSupersampling), 0, 0,
               cv::INTER_AREA);
    return encode_png(small.ptr<std::uint8_t>(), small.cols, small.rows);
  }

  static double share_before(TextAnchor anchor) {
    return anchor == TextAnchor::left ? 0 : anchor == TextAnchor::middle ? 0.5 : 1;
  }
  static double em_of(double size) { return size * kCapHeightOfSize / kCapHeightOfEm; }
  static double scale_of(double size) { return size * kCapHeightOfSize * kSupersampling / kHersheyCapHeight; }
  static int stroke_of(double size, bool is_bold) {
    return std::max(1, static_cast<int>(std::lround(size * kSupersampling * (is_bold ? 0.115 : 0.07))));
  }

 private:
  static cv::Rect bounds(const std::vector<cv::Point>& fixed, int margin) {
    cv::Rect box = cv::boundingRect(fixed);
    const int one = 1 << kSubpixelBits;
    return {box.x / one - margin - 1, box.y / one - margin - 1, box.width / one + 2 * margin + 3,
            box.height / one + 2 * margin + 3};
  }

  // Paints `draw` into a mask over `area` and lays the colour over the image through it, so that overlapping
  // strokes of one item do not add up.
  template <class Draw>
  void blend(const cv::Rect& area, const Colour& colour, const Draw& draw) {
    const cv::Rect seen = area & cv::Rect(0, 0, image_.cols, image_.rows);
    if (seen.empty() || !(colour.opacity > 0)) return;
    cv::Mat mask(seen.size(), CV_8UC1, cv::Scalar(0));
    const int one = 1 << kSubpixelBits;
    draw(mask, cv::Point(seen.x * one, seen.y * one));
    const int opacity = static_cast<int>(std::lround(std::clamp(colour.opacity, 0.0, 1.0) * 256));
    const std::array<int, 3> paint{colour.b, colour.g, colour.r};
    for (int y = 0; y < seen.height; ++y) {
      const unsigned char* m = mask.ptr<unsigned char>(y);
      unsigned char* pixel = image_.ptr<unsigned char>(seen.y + y) + 3 * seen.x;
      for (int x = 0; x < seen.width; ++x, pixel += 3) {
        if (m[x] == 0) continue;
        const int alpha = m[x] * opacity;  // of 255 * 256
        for (std::size_t k = 0; k < 3; ++k) {
          pixel[k] = static_cast<unsigned char>((pixel[k] * (65280 - alpha) + paint[k] * alpha + 32640) / 65280);
        }
      }
    }
  }

  cv::Mat image_;
};

}  // namespace

double text_width(const std::string& text, double size, bool is_bold) {
  if (installed_font().has_letters()) return installed_font().width(text, is_bold) * Painter::em_of(size);
  int base_line = 0;
  // At a fixed large scale, so that widths grow smoothly with the size.
  const cv::Size box = cv::getTextSize(ascii_text(text), cv::FONT_HERSHEY_SIMPLEX, 4, 1, &base_line);
  return box.width * Painter::scale_of(size) / 4 / kSupersampling +
         (is_bold ? static_cast<double>(Painter::stroke_of(size, true)) / kSupersampling : 0.0);
}

Result<std::string> render_png(const Drawing& drawing) { return render_png(drawing, {}); }

Result<std::string> render_png(const Drawing& drawing, const std::vector<PlacedRaster>& underlay) {
  if (!(drawing.width >= 1 && drawing.width <= kLargestSide && drawing.height >= 1 && drawing.height <= kLargestSide)) {
    return make_error("picture-size", "a picture must have from 1 to 16384 pixels a side");
  }
  try {
    Painter painter(static_cast<int>(std::ceil(drawing.width)), static_cast<int>(std::ceil(drawing.height)),
                    drawing.background);
    for (const PlacedRaster& placed : underlay) painter.paint(placed);
    for (const auto& item : drawing.items) std::visit(painter, item);
    if (const auto trouble = installed_font().trouble()) return *trouble;
    return painter.png();
  } catch (const cv::Exception& failure) {
    const bool is_memory = failure.code == cv::Error::StsNoMem;
    return make_error(is_memory ? "out-of-memory" : "picture-not-encoded",
                      std::string("the picture could not be painted: ") + failure.what());
  }
}

}  // namespace gouge
