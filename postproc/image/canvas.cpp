#include "postproc/image/canvas.h"

#include <png.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <optional>
#include <string_view>

#include "lib/base/large_pages.h"
#include "postproc/image/ascii_text.h"
#include "postproc/image/font.h"
#include "postproc/image/mask_painter.h"
#include "postproc/image/render_drawing.h"

// Pictures are painted kSupersampling times larger and then averaged down.

// This file uses libpng's simplified interface, which returns its errors as text. The full interface would jump over
// destructors.

namespace gouge {

namespace {

constexpr double kLargestSide = 16384;
constexpr double kCapHeightOfSize = 0.70;   // of the font's size, as in common sans-serif fonts
constexpr double kCapHeightOfEm = 0.729;    // the same for DejaVu Sans, relative to the em square
constexpr double kHersheyCapHeight = 21.0;  // in the units of Hershey's stroke letters at scale 1

// An area of the enlarged picture; x and y may lie outside of the picture.
struct PixelArea {
  int x = 0, y = 0, width = 0, height = 0;

  [[nodiscard]] bool is_empty() const { return width <= 0 || height <= 0; }
  [[nodiscard]] PixelArea within(int w, int h) const {
    const int left = std::max(x, 0), top = std::max(y, 0);
    return {left, top, std::min(x + width, w) - left, std::min(y + height, h) - top};
  }
};

MaskPoint mask_point(const Vec2& p) {
  // Far outside the picture the exact value of a coordinate does not matter. The limit keeps it within the painter's
  // integers.
  const auto to_units = [](double x) {
    return static_cast<int>(
        std::lround(std::clamp(x, -4.0 * kLargestSide, 4.0 * kLargestSide) * kSupersampling * kMaskUnits));
  };
  // Picture units begin at the left top corner of a pixel, but the painter's begin at its centre.
  return {to_units(p.x()) - kMaskUnits / 2, to_units(p.y()) - kMaskUnits / 2};
}

std::vector<MaskPoint> mask_points(const std::vector<Vec2>& points) {
  std::vector<MaskPoint> out;
  out.reserve(points.size());
  for (const Vec2& p : points) out.push_back(mask_point(p));
  return out;
}

void shift_to(const PixelArea& seen, std::vector<MaskPoint>& points) {
  for (MaskPoint& p : points) {
    p.x -= seen.x * kMaskUnits;
    p.y -= seen.y * kMaskUnits;
  }
}

// Cuts a line into the strokes of its dash pattern. An empty or invalid pattern leaves it whole.
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

// A painter of one picture. It keeps its first error, which png() returns.
class Painter {
 public:
  Painter(const MaskPainter& masks, int width, int height, const Colour& background)
      : masks_(masks), width_(width * kSupersampling), height_(height * kSupersampling) {
    const std::size_t bytes = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) * 3;
    reserve_large(rgb_, bytes);
    rgb_.resize(bytes, background.r);
    if (background.r == background.g && background.g == background.b) return;
    for (std::size_t i = 0; i < rgb_.size(); i += 3) {
      rgb_[i] = static_cast<std::uint8_t>(background.r);
      rgb_[i + 1] = static_cast<std::uint8_t>(background.g);
      rgb_[i + 2] = static_cast<std::uint8_t>(background.b);
    }
  }

  void paint(const PlacedRaster& placed) {
    if (placed.raster.rgb.empty()) return;
    const Raster& raster = placed.raster;
    const PixelArea target{placed.x * kSupersampling, placed.y * kSupersampling, raster.width, raster.height};
    const PixelArea seen = target.within(width_, height_);
    if (seen.is_empty()) return;
    for (int y = 0; y < seen.height; ++y) {
      const std::size_t first =
          static_cast<std::size_t>(seen.y - target.y + y) * static_cast<std::size_t>(raster.width) +
          static_cast<std::size_t>(seen.x - target.x);
      std::copy_n(raster.rgb.data() + 3 * first, 3 * static_cast<std::size_t>(seen.width), pixel(seen.x, seen.y + y));
    }
  }

  void operator()(const DrawnLine& line) {
    if (line.points.size() < 2) return;
    const double width = line.width * kSupersampling;
    const int thickness = std::max(1, static_cast<int>(std::lround(width)));
    Colour colour = line.colour;
    if (width < 1) colour.opacity *= width;
    std::vector<std::vector<MaskPoint>> strokes;
    for (const std::vector<Vec2>& stroke : cut_dashes(line)) strokes.push_back(mask_points(stroke));
    std::vector<MaskPoint> all;
    for (const auto& stroke : strokes) all.insert(all.end(), stroke.begin(), stroke.end());
    blend(bounds(all, thickness + 2), colour, [&](Mask& mask, const PixelArea& seen) {
      for (auto& stroke : strokes) shift_to(seen, stroke);
      return masks_.draw(mask, strokes, thickness);
    });
  }

  void operator()(const DrawnShape& shape) {
    if (shape.points.size() < 3) return;
    std::vector<MaskPoint> outline = mask_points(shape.points);
    blend(bounds(outline, 2), shape.fill, [&](Mask& mask, const PixelArea& seen) {
      shift_to(seen, outline);
      return masks_.fill(mask, outline);
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
    // The base line is between two pixels of the picture, so that letters that end there are sharp.
    const int base = static_cast<int>(std::lround(std::clamp(text.at.y(), -1e5, 1e5))) * kSupersampling;
    const PixelArea area{static_cast<int>(whole) + letters.left, base + letters.top, letters.width, letters.height};
    blend(area, text.colour, [&](Mask& mask, const PixelArea& seen) -> Outcome {
      for (int y = 0; y < seen.height; ++y) {
        const auto row = letters.grey.begin() + (seen.y - area.y + y) * std::ptrdiff_t{letters.width} + seen.x - area.x;
        std::copy(row, row + seen.width, mask.grey.begin() + std::ptrdiff_t{y} * seen.width);
      }
      return Done{};
    });
  }

  // Draws text if no font is installed: with stroke letters, which are only ASCII.
  void draw_strokes(const DrawnText& text) {
    const std::string ascii = ascii_text(text.text);
    const int thickness = stroke_of(text.size, text.is_bold);
    const double width = text_width(ascii, text.size, text.is_bold) * kSupersampling;
    const double anchor = share_before(text.anchor);
    const int x = static_cast<int>(std::lround(std::clamp(text.at.x(), -1e5, 1e5) * kSupersampling - anchor * width));
    const int y = static_cast<int>(std::lround(std::clamp(text.at.y(), -1e5, 1e5) * kSupersampling));
    const int high = static_cast<int>(std::lround(text.size * kSupersampling)) + 4;
    blend({x - high, y - high, static_cast<int>(width) + 2 * high, 2 * high}, text.colour,
          [&](Mask& mask, const PixelArea& seen) {
            return masks_.write(mask, ascii, x - seen.x, y - seen.y, scale_of(text.size), thickness);
          });
  }

  [[nodiscard]] Result<std::string> png() const {
    if (failure_) return *failure_;
    std::vector<std::uint8_t> small;
    const Outcome shrunk = masks_.shrink(rgb_, width_, height_, kSupersampling, small);
    if (!shrunk) return shrunk.error();
    return encode_png(small.data(), width_ / kSupersampling, height_ / kSupersampling);
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
  static PixelArea bounds(const std::vector<MaskPoint>& points, int margin) {
    if (points.empty()) return {};
    MaskPoint least = points.front(), most = points.front();
    for (const MaskPoint& p : points) {
      least = {std::min(least.x, p.x), std::min(least.y, p.y)};
      most = {std::max(most.x, p.x), std::max(most.y, p.y)};
    }
    return {least.x / kMaskUnits - margin - 1, least.y / kMaskUnits - margin - 1,
            (most.x - least.x + 1) / kMaskUnits + 2 * margin + 3, (most.y - least.y + 1) / kMaskUnits + 2 * margin + 3};
  }

  [[nodiscard]] std::uint8_t* pixel(int x, int y) {
    return rgb_.data() +
           (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)) * 3;
  }

  // Returns the number of levels that are 0 before the first other one, or a part of that number.
  static int untouched_of(const std::uint8_t* levels, int count) {
    constexpr int kTogether = 8;
    int untouched = 0;
    for (; untouched + kTogether <= count; untouched += kTogether) {
      std::uint64_t together = 0;
      std::memcpy(&together, levels + untouched, sizeof together);
      if (together != 0) break;
    }
    return untouched > 0 || *levels != 0 ? untouched : 1;
  }

  // Paints `draw` into a mask over `area`, and lays the colour over the picture through the mask. So overlapping
  // strokes of one item do not add up.
  template <class Draw>
  void blend(const PixelArea& area, const Colour& colour, const Draw& draw) {
    const PixelArea seen = area.within(width_, height_);
    if (failure_ || area.is_empty() || seen.is_empty() || !(colour.opacity > 0)) return;
    Mask mask(seen.width, seen.height);
    const Outcome drawn = draw(mask, seen);
    if (!drawn) {
      failure_ = drawn.error();
      return;
    }
    const int opacity = static_cast<int>(std::lround(std::clamp(colour.opacity, 0.0, 1.0) * 256));
    const std::array<int, 3> paint{colour.r, colour.g, colour.b};
    const std::uint8_t* level = mask.grey.data();
    for (int y = 0; y < seen.height; ++y) {
      std::uint8_t* at = pixel(seen.x, seen.y + y);
      for (int x = 0; x < seen.width; ++x, at += 3, ++level) {
        const int untouched = untouched_of(level, seen.width - x);  // this skips most of the mask of a frame
        if (untouched > 0) {
          x += untouched - 1;
          at += 3 * (untouched - 1);
          level += untouched - 1;
          continue;
        }
        const int alpha = *level * opacity;  // its maximum is 255 * 256
        for (std::size_t k = 0; k < 3; ++k)
          at[k] = static_cast<std::uint8_t>((at[k] * (65280 - alpha) + paint[k] * alpha + 32640) / 65280);
      }
    }
  }

  const MaskPainter& masks_;
  int width_, height_;  // size of the enlarged picture
  std::vector<std::uint8_t> rgb_;
  std::optional<Diagnostic> failure_;
};

}  // namespace

double text_width(const std::string& text, double size, bool is_bold) {
  if (installed_font().has_letters()) return installed_font().width(text, is_bold) * Painter::em_of(size);
  const Result<const MaskPainter*> masks = mask_painter();
  if (!masks) return 0;  // render_png reports the error
  return (*masks)->width(ascii_text(text), Painter::scale_of(size)) / kSupersampling +
         (is_bold ? static_cast<double>(Painter::stroke_of(size, true)) / kSupersampling : 0.0);
}

Result<std::string> render_png(const Drawing& drawing) { return render_png(drawing, {}); }

Result<std::string> render_png(const Drawing& drawing, const std::vector<PlacedRaster>& underlay) {
  if (!(drawing.width >= 1 && drawing.width <= kLargestSide && drawing.height >= 1 && drawing.height <= kLargestSide)) {
    return make_error("picture-size", "a picture must have from 1 to 16384 pixels a side");
  }
  const Result<const MaskPainter*> masks = mask_painter();
  if (!masks) return masks.error();
  Painter painter(**masks, static_cast<int>(std::ceil(drawing.width)), static_cast<int>(std::ceil(drawing.height)),
                  drawing.background);
  for (const PlacedRaster& placed : underlay) painter.paint(placed);
  for (const auto& item : drawing.items) std::visit(painter, item);
  if (const auto trouble = installed_font().trouble()) return *trouble;
  return painter.png();
}

Result<std::string> encode_png(const std::uint8_t* rgb, int width, int height) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(height);
  image.format = PNG_FORMAT_RGB;
  // This takes a third of the time, for files that are 5 to 20 % larger.
  image.flags = PNG_IMAGE_FLAG_FAST;
  // The maximum size of the file. A request to libpng for its actual size would compress it twice.
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string bytes(size, '\0');
  constexpr int kRowsAsTheyAre = 0;
  if (png_image_write_to_memory(&image, bytes.data(), &size, 0, rgb, kRowsAsTheyAre, nullptr) == 0) {
    // The texts are "out of memory" from libpng and "insufficient memory" from zlib.
    const bool is_memory = std::string_view(image.message).find("memory") != std::string_view::npos;
    return make_error(is_memory ? "out-of-memory" : "picture-not-encoded",
                      std::string("the picture could not be encoded: ") + image.message);
  }
  bytes.resize(size);
  bytes.shrink_to_fit();
  return bytes;
}

}  // namespace gouge
