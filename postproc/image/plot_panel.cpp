#include "postproc/image/plot_panel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "lib/base/number_text.h"
#include "lib/base/tolerance.h"
#include "lib/mesh/indexed_mesh.h"

namespace gouge {
namespace {

constexpr double kLeft = 64, kBottom = 44, kTop = 36, kRight = 24;  // margins, with room for numbers
constexpr double kFont = 16, kSmall = 12, kTick = 6;
constexpr double kCell = 2;  // side of a cell of a shaded part
constexpr int kShades = 8;   // from the darkest to the lightest grey
const Colour kPlotInk{40, 44, 52, 1};
const Colour kGrey{150, 155, 165, 1};

void add_text(Drawing& drawing, const Vec2& at, const std::string& text, TextAnchor anchor, double size = kSmall) {
  drawing.items.emplace_back(DrawnText{at, text, size, kPlotInk, anchor, false});
}

void add_line(Drawing& drawing, const Vec2& a, const Vec2& b, const Colour& colour, double width = 1) {
  drawing.items.emplace_back(DrawnLine{{a, b}, colour, width, false, {}});
}

// Draws ticks at round coordinates of the axis that runs along one edge of the panel.
void draw_ticks(const PlotPanel& panel, LengthUnit unit, bool is_horizontal, Drawing& drawing) {
  // target distance between ticks in drawing units; the actual one is at least half of it
  constexpr double kApart = 90;
  const double per_unit = panel.scale * mm_per(unit);
  const double step = round_length(kApart / per_unit);
  const double low = is_horizontal ? panel.x + kLeft - 8 : panel.y + kTop;
  const double high = is_horizontal ? panel.x + panel.width - 8 : panel.y + panel.height - kBottom + 8;
  const double shift = is_horizontal ? panel.shift.x() : panel.shift.y(), sign = is_horizontal ? 1 : -1;
  const double first = sign * (low - shift) / per_unit, last = sign * (high - shift) / per_unit;
  const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + Tolerance::kRounding)));
  for (double k = std::ceil(std::min(first, last) / step); k * step <= std::max(first, last); ++k) {
    const double at = shift + sign * k * step * per_unit;
    const std::string text = display_text(k * step, decimals);
    if (is_horizontal) {
      const double y = panel.y + panel.height;
      add_line(drawing, {at, y}, {at, y - kTick}, kGrey);
      add_text(drawing, {at, y - kTick - 5}, text, TextAnchor::middle);
    } else {
      add_line(drawing, {panel.x, at}, {panel.x + kTick, at}, kGrey);
      add_text(drawing, {panel.x + kTick + 4, at + 4}, text, TextAnchor::left);
    }
  }
}

// Draws a bar of a round length, about a seventh of the panel, at the upper right.
void draw_scale(const PlotPanel& panel, LengthUnit unit, Drawing& drawing) {
  const double per_unit = panel.scale * mm_per(unit);
  const double length = round_length(panel.width / 5 / per_unit);
  const double b = panel.x + panel.width - 14, a = b - length * per_unit, y = panel.y + 26;
  add_line(drawing, {a, y}, {b, y}, kPlotInk, 2);
  for (const double end : {a, b}) add_line(drawing, {end, y - 4}, {end, y + 4}, kPlotInk);
  const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(length) + Tolerance::kRounding)));
  add_text(drawing, {(a + b) / 2, y - 7}, display_text(length, decimals) + " " + unit_name(unit), TextAnchor::middle);
}

void draw_directions(const PlotPanel& panel, Drawing& drawing) {
  constexpr double kLength = 44;
  const Vec2 origin(panel.x + 64, panel.y + panel.height - 56);
  const std::array<const char*, 3> names = {"x", "y", "z"};
  for (Eigen::Index k = 0; k < 3; ++k) {
    const Vec2 way = panel.flat(Vec3::Unit(k));
    add_line(drawing, origin, origin + kLength * way, kPlotInk, 1.4);
    add_text(drawing, origin + (kLength + 10) * way + Vec2(0, 4), names[static_cast<std::size_t>(k)],
             TextAnchor::middle, 14);
  }
}

/// The shades of the nearest surfaces, cell by cell.
class ShadedCells {
 public:
  explicit ShadedCells(const PlotPanel& panel)
      : panel_(panel),
        columns_(static_cast<int>(panel.width / kCell)),
        rows_(static_cast<int>(panel.height / kCell)),
        depths_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_),
                -std::numeric_limits<float>::infinity()),
        shades_(depths_.size(), 0) {}

  void add(const IndexedMesh& mesh) {
    const Vec3 view = panel_.right.cross(panel_.up);  // direction towards the eye
    const Vec3 light = (view + 0.5 * panel_.up - 0.4 * panel_.right).normalized();
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
      std::array<Vec3, 3> corners;
      for (std::size_t c = 0; c < 3; ++c) {
        const Vec3& p = mesh.corner(k, c);
        const Vec2 at = panel_.at(p);
        corners[c] = {(at.x() - panel_.x) / kCell, (at.y() - panel_.y) / kCell, p.dot(view)};
      }
      const double lit = std::abs(face_normal(mesh, k).dot(light));
      add(corners, static_cast<std::uint8_t>(1 + std::min(kShades - 1.0, std::floor(lit * kShades))));
    }
  }

  void draw(Drawing& drawing) const {
    for (int row = 0; row < rows_; ++row) {
      for (int column = 0; column < columns_;) {
        const std::uint8_t shade = shades_[cell(column, row)];
        const int begin = column;
        while (column < columns_ && shades_[cell(column, row)] == shade) ++column;
        if (shade == 0) continue;
        const auto grey = static_cast<unsigned char>(168 + 9 * shade);
        const double a = panel_.x + begin * kCell, b = panel_.x + column * kCell, y = panel_.y + row * kCell;
        drawing.items.emplace_back(DrawnShape{{{a, y}, {b, y}, {b, y + kCell}, {a, y + kCell}}, {grey, grey, grey, 1}});
      }
    }
  }

 private:
  [[nodiscard]] std::size_t cell(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  }

  // Adds the shade to every cell whose centre the triangle covers.
  void add(const std::array<Vec3, 3>& p, std::uint8_t shade) {
    const double area = (p[1].x() - p[0].x()) * (p[2].y() - p[0].y()) - (p[2].x() - p[0].x()) * (p[1].y() - p[0].y());
    if (!(std::abs(area) > 0)) return;
    const auto [left, right] = std::minmax({p[0].x(), p[1].x(), p[2].x()});
    const auto [top, bottom] = std::minmax({p[0].y(), p[1].y(), p[2].y()});
    const int first_row = first(top), last_row = last(bottom, rows_);
    const int first_column = first(left), last_column = last(right, columns_);
    for (int row = first_row; row <= last_row; ++row) {
      for (int column = first_column; column <= last_column; ++column) {
        const double x = column + 0.5, y = row + 0.5;
        const double b = ((x - p[0].x()) * (p[2].y() - p[0].y()) - (p[2].x() - p[0].x()) * (y - p[0].y())) / area;
        const double c = ((p[1].x() - p[0].x()) * (y - p[0].y()) - (x - p[0].x()) * (p[1].y() - p[0].y())) / area;
        if (b < 0 || c < 0 || b + c > 1) continue;
        const auto depth = static_cast<float>(p[0].z() + b * (p[1].z() - p[0].z()) + c * (p[2].z() - p[0].z()));
        const std::size_t at = cell(column, row);
        if (depth <= depths_[at]) continue;
        depths_[at] = depth;
        shades_[at] = shade;
      }
    }
  }

  static int first(double low) { return static_cast<int>(std::max(0.0, std::floor(low - 0.5))); }
  static int last(double high, int count) { return static_cast<int>(std::min(count - 1.0, std::ceil(high))); }

  const PlotPanel& panel_;
  int columns_, rows_;
  std::vector<float> depths_;
  std::vector<std::uint8_t> shades_;
};

}  // namespace

bool PlotPanel::is_along_axes() const {
  return right.cwiseAbs().maxCoeff() > 1 - Tolerance::kRounding && up.cwiseAbs().maxCoeff() > 1 - Tolerance::kRounding;
}

void PlotPanel::fit(const Box3& box) {
  Vec2 low = flat(box.min()), high = low;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec2 p = flat(box.corner(static_cast<Box3::CornerType>(corner)));
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Vec2 size = (high - low).cwiseMax(Tolerance::kSamePoint_mm);
  const double left = is_along_axes() ? kLeft : kRight;
  scale = std::min((width - left - kRight) / size.x(), (height - kTop - kBottom) / size.y());
  shift = Vec2(x + (width + left - kRight) / 2, y + (height + kTop - kBottom) / 2) - scale * 0.5 * (low + high);
}

void draw_frame(const PlotPanel& panel, LengthUnit unit, Drawing& drawing) {
  const Vec2 a(panel.x, panel.y), b(panel.x + panel.width, panel.y + panel.height);
  drawing.items.emplace_back(DrawnLine{{a, {b.x(), a.y()}, b, {a.x(), b.y()}}, kGrey, 1, true, {}});
  add_text(drawing, {panel.x + 8, panel.y + 22}, panel.name, TextAnchor::left, kFont);
  draw_scale(panel, unit, drawing);
  if (!panel.is_along_axes()) return draw_directions(panel, drawing);
  draw_ticks(panel, unit, true, drawing);
  draw_ticks(panel, unit, false, drawing);
}

void draw_parts(const PlotPanel& panel, const std::vector<IndexedMesh>& parts, Drawing& drawing) {
  if (parts.empty()) return;
  ShadedCells cells(panel);
  for (const IndexedMesh& part : parts) cells.add(part);
  cells.draw(drawing);
}

double round_length(double length) {
  const double power = std::pow(10, std::floor(std::log10(length) + Tolerance::kRounding));
  for (const double digit : {5.0, 2.0}) {
    if (digit * power <= length * (1 + Tolerance::kRounding)) return digit * power;
  }
  return power;
}

}  // namespace gouge
