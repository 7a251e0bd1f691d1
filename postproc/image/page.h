#pragma once

#include <string>
#include <vector>

#include "lib/drawing/drawing.h"
#include "postproc/image/colour_scale.h"
#include "postproc/image/raster.h"
#include "postproc/image/view.h"

// Titles, scales and labels that all pictures use. Coordinates are in picture units.

namespace gouge {

inline constexpr int kPageWidth = 1600;
inline constexpr int kPageHeight = 1000;

struct Area {
  double x = 0, y = 0, width = 0, height = 0;
  [[nodiscard]] double right() const { return x + width; }
  [[nodiscard]] double bottom() const { return y + height; }
  [[nodiscard]] Vec2 middle() const { return {x + 0.5 * width, y + 0.5 * height}; }
};

struct Page {
  Drawing drawing;
  std::vector<PlacedRaster> rasters;
  std::vector<Area> taken;  ///< areas of labels, which later labels do not cover

  void line(const Vec2& a, const Vec2& b, const Colour& colour, double width = 1, std::vector<double> dashes = {});
  void shape(std::vector<Vec2> points, const Colour& fill);
  void box(const Area& area, const Colour& fill);
  void frame(const Area& area, const Colour& colour, double width = 1);
  void disc(const Vec2& centre, double radius, const Colour& fill);
  void text(const Vec2& at, const std::string& words, double size, const Colour& colour,
            TextAnchor anchor = TextAnchor::left, bool is_bold = false);
  /// Adds the number of a finding in the middle of a disc, small enough to stay on it.
  void number_on_disc(const Vec2& centre, double radius, std::size_t number, const Colour& colour);
};

/// Returns a page with its title and up to two lines below it, all shortened to fit.
[[nodiscard]] Page make_page(const std::string& title, const std::string& verdict, const Colour& verdict_colour,
                             const std::vector<std::string>& lines);

/// Returns `words`, shortened with "..." in the middle if they are wider than `width`, but never within a number.
[[nodiscard]] std::string fitted(const std::string& words, double size, double width, bool is_bold = false);

/// Returns `size`, or a smaller size at which `words` are at most as wide as `width`, for texts that must not be
/// shortened.
[[nodiscard]] double fitting_size(const std::string& words, double size, double width, bool is_bold = false);

/// Adds a vertical bar with numbers, grey below the tolerance.
void add_colour_bar(Page& page, const Area& area, const ColourScale& scale, LengthUnit unit, const std::string& title);
/// Adds the bar of material left, without a title. It continues a bar of depths downwards: its zero is at the top of `area`.
void add_left_bar(Page& page, const Area& area, const ColourScale& scale, LengthUnit unit);
/// Adds a bar of a round length in the view's scale, with its left end at `at`. The pixels of the view are supersampled
/// ones. `max_width` limits the bar without its words.
void add_scale_bar(Page& page, const Vec2& at, const View& view, LengthUnit unit, double max_width);
/// Returns the width of the bar with its words.
[[nodiscard]] double scale_bar_width(const View& view, LengthUnit unit, double max_width);
/// Adds the directions of x, y and z in the view.
void add_triad(Page& page, const Vec2& at, const View& view, double size);

/// Returns the point of a picture for a point of a view whose raster is at `area`.
[[nodiscard]] inline Vec2 on_page(const Area& area, const Vec3& projected) {
  return {area.x + projected.x() / kSupersampling, area.y + projected.y() / kSupersampling};
}

/// Adds a numbered disc beside `target`, with a line to it. It covers no other label, and stays within `area`.
void add_marker(Page& page, const Area& area, const Vec2& target, std::size_t number, bool is_hidden);

}  // namespace gouge
