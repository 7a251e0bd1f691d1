#include "postproc/image/section_panel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "lib/base/tolerance.h"
#include "lib/tool/evaluate.h"
#include "postproc/image/shade.h"
#include "postproc/image/tool_outline.h"

namespace gouge {
namespace {

constexpr int kHatch = 20, kHatchWidth = 2;  // in pixels of a supersampled picture
constexpr int kPieces = 48;  // number of pieces of a straight flank, which a plane beside the axis cuts in a curve

void clipped_line(Page& page, const Area& box, const Vec2& a, const Vec2& b, const Colour& colour, double width,
                  const std::vector<double>& dashes = {}) {
  if (const auto seen = clipped(a, b, box)) page.line((*seen)[0], (*seen)[1], colour, width, dashes);
}

// Returns, for each raster row, the points where an outline crosses it. An odd number has no meaning, so the row is
// dropped.
std::vector<std::vector<double>> crossings(const SectionPanel& panel, const std::vector<SectionLine>& lines, int rows) {
  std::vector<std::vector<double>> out(static_cast<std::size_t>(rows));
  for (const SectionLine& line : lines) {
    const Vec2 a = (panel.place(line.a) - Vec2(panel.area.x, panel.area.y)) * kSupersampling;
    const Vec2 b = (panel.place(line.b) - Vec2(panel.area.x, panel.area.y)) * kSupersampling;
    const double low = std::clamp(std::floor(std::min(a.y(), b.y()) - 1), 0.0, static_cast<double>(rows));
    const double high = std::clamp(std::ceil(std::max(a.y(), b.y()) + 1), 0.0, static_cast<double>(rows));
    for (int row = static_cast<int>(low); row < static_cast<int>(high); ++row) {
      const double y = row + 0.5;
      if ((a.y() > y) == (b.y() > y)) continue;
      out[static_cast<std::size_t>(row)].push_back(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
    }
  }
  for (std::vector<double>& row : out) {
    if (row.size() % 2 != 0) row.clear();
    std::sort(row.begin(), row.end());
  }
  return out;
}

Body body_at(const std::array<BodyRange, 3>& ranges, double z) {
  for (const Body body : {Body::holder, Body::shank}) {
    const BodyRange& range = ranges[static_cast<std::size_t>(body)];
    if (z >= range.low_mm && z <= range.high_mm) return body;
  }
  return Body::cutter;
}

// The inside of an outline, which is read row by row from the left.
class InsideOf {
 public:
  InsideOf(const SectionPanel& panel, const std::vector<SectionLine>& lines, int rows)
      : rows_(crossings(panel, lines, rows)) {}

  void begin_row(int y) {
    row_ = &rows_[static_cast<std::size_t>(y)];
    next_ = 0;
  }
  [[nodiscard]] bool at(int x) {
    while (next_ < row_->size() && (*row_)[next_] <= x + 0.5) ++next_;
    return next_ % 2 == 1;
  }

 private:
  std::vector<std::vector<double>> rows_;
  const std::vector<double>* row_ = nullptr;
  std::size_t next_ = 0;
};

/// The pixels of a panel that show the tool, and the body that they show.
class ToolBodies {
 public:
  ToolBodies(const SectionPanel& panel, double beside_mm, const CompiledTool& tool, int width, int height)
      : panel_(panel),
        beside2_(beside_mm * beside_mm),
        tool_(tool),
        ranges_{body_range(tool, Body::cutter), body_range(tool, Body::shank), body_range(tool, Body::holder)},
        width_(width),
        height_(height),
        is_inside_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0) {
    for (int y = 0; y < height; y += kSquare) {
      for (int x = 0; x < width; x += kSquare) fill(x, y, kSquare);
    }
  }

  /// Returns, for each pixel of a row, whether it shows the tool.
  [[nodiscard]] std::span<const std::uint8_t> row(int y) const {
    return std::span(is_inside_).subspan(index(0, y), static_cast<std::size_t>(width_));
  }
  /// Returns the body in a row, because bodies lie one above the other.
  [[nodiscard]] int body_of_row(int y) const { return static_cast<int>(body_at(ranges_, place(0, y).y())); }

 private:
  static constexpr int kSquare = 64;

  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }
  /// Returns the middle of a pixel, or of a square of pixels (with half values of x and y).
  [[nodiscard]] Vec2 place(double x, double y) const {
    return {panel_.centre.x() + (x + 0.5 - 0.5 * width_) / kSupersampling * panel_.mm_per_unit,
            panel_.centre.y() - (y + 0.5 - 0.5 * height_) / kSupersampling * panel_.mm_per_unit};
  }
  [[nodiscard]] double distance_mm(const Vec2& p) const {
    const double r = beside2_ > 0 ? std::sqrt(p.x() * p.x() + beside2_) : std::abs(p.x());
    return signed_distance_mm(tool_, r, p.y());
  }

  // The distance of a pixel in a square differs from that of the square's middle by at most the pixel's distance from
  // the middle.
  void fill(int x, int y, int side) {
    if (x >= width_ || y >= height_) return;
    const double middle = 0.5 * (side - 1);
    const double distance = distance_mm(place(x + middle, y + middle));
    const double reach = 1.5 * middle / kSupersampling * panel_.mm_per_unit;
    if (side == 1 || std::abs(distance) > reach) {
      if (distance >= 0) return;
      for (int row = y; row < std::min(y + side, height_); ++row) {
        const auto first = is_inside_.begin() + static_cast<std::ptrdiff_t>(index(x, row));
        std::fill(first, first + (std::min(x + side, width_) - x), std::uint8_t{1});
      }
      return;
    }
    const int half = side / 2;
    for (int k = 0; k < 4; ++k) fill(x + k % 2 * half, y + k / 2 * half, half);
  }

  const SectionPanel& panel_;
  double beside2_;
  const CompiledTool& tool_;
  std::array<BodyRange, 3> ranges_;
  int width_, height_;
  std::vector<std::uint8_t> is_inside_;
};

using Pixel = std::array<std::uint8_t, 3>;

constexpr std::size_t kKindsOfTool = 4;  // none, and the three bodies

/// The colour of every kind of pixel. There are few kinds, so each colour is mixed once, not for every pixel.
class SectionColours {
 public:
  SectionColours() {
    for (std::size_t k = 0; k < colours_.size(); ++k) colours_[k] = mixed(k);
  }
  /// Returns the colour; `tool_body` is -1 if there is no tool.
  [[nodiscard]] const Pixel& at(bool is_material, bool is_hatch, bool is_head, int tool_body) const {
    return colours_[index(is_material, is_hatch, is_head, tool_body)];
  }

 private:
  static std::size_t index(bool is_material, bool is_hatch, bool is_head, int tool_body) {
    return ((is_material ? 4U : 0U) + (is_hatch ? 2U : 0U) + (is_head ? 1U : 0U)) * kKindsOfTool +
           static_cast<std::size_t>(tool_body + 1);
  }

  static Pixel mixed(std::size_t index) {
    const int tool_body = static_cast<int>(index % kKindsOfTool) - 1;
    const std::size_t flags = index / kKindsOfTool;
    const bool is_material = (flags & 4U) != 0, is_hatch = (flags & 2U) != 0, is_head = (flags & 1U) != 0;
    Raster one(1, 1, 255, 255, 255);
    std::uint8_t* const pixel = one.pixel(0, 0);
    if (is_material) {
      const Colour colour = is_hatch ? Colour{150, 158, 166, 1} : Colour{214, 218, 222, 1};
      pixel[0] = colour.r;
      pixel[1] = colour.g;
      pixel[2] = colour.b;
    }
    if ((tool_body >= 0 || is_head) && is_material) {
      blend_pixel(one, 0, 0, kAlarm, 0.62);
    } else {
      if (is_head) blend_pixel(one, 0, 0, body_colour(static_cast<int>(Body::head)), 0.26);
      if (tool_body >= 0) blend_pixel(one, 0, 0, body_colour(tool_body), 0.26);
    }
    return {pixel[0], pixel[1], pixel[2]};
  }

  std::array<Pixel, 8 * kKindsOfTool> colours_;
};

Raster paint_panel(const SectionPanel& panel, const Section& section, bool is_closed, const CompiledTool& tool) {
  const int width = static_cast<int>(panel.area.width) * kSupersampling;
  const int height = static_cast<int>(panel.area.height) * kSupersampling;
  Raster raster(width, height, 255, 255, 255);
  InsideOf material(panel, is_closed ? section.lines : std::vector<SectionLine>{}, height);
  std::vector<InsideOf> heads;
  for (const std::vector<SectionLine>& lines : section.heads) heads.emplace_back(panel, lines, height);
  const ToolBodies bodies(panel, section.plane.beside_mm, tool, width, height);
  const SectionColours colours;
  for (int y = 0; y < height; ++y) {
    material.begin_row(y);
    for (InsideOf& head : heads) head.begin_row(y);
    const std::span<const std::uint8_t> is_inside = bodies.row(y);
    const int body = bodies.body_of_row(y);
    std::uint8_t* pixel = raster.pixel(0, y);
    for (int x = 0, hatch = y % kHatch; x < width; ++x, pixel += 3, hatch = hatch + 1 == kHatch ? 0 : hatch + 1) {
      bool is_head = false;
      for (InsideOf& head : heads) is_head = head.at(x) || is_head;
      const int tool_body = is_inside[static_cast<std::size_t>(x)] != 0 ? body : -1;
      const Pixel& colour = colours.at(material.at(x), hatch < kHatchWidth, is_head, tool_body);
      pixel[0] = colour[0];
      pixel[1] = colour[1];
      pixel[2] = colour[2];
    }
  }
  return raster;
}

// Returns the profile (r, z) as the plane shows it, with |u| in place of r. Points nearer to the axis than the plane
// are left out.
std::vector<std::array<Vec2, 2>> seen_profile(const std::vector<Vec2>& points, double beside_mm) {
  std::vector<std::array<Vec2, 2>> out;
  const double least = std::abs(beside_mm);
  const auto seen = [&](const Vec2& p) { return Vec2(std::sqrt(std::max(0.0, p.x() * p.x() - least * least)), p.y()); };
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Vec2& from = points[i];
    const Vec2& to = points[i + 1];
    if (!(least > 0)) {
      out.push_back({from, to});
      continue;
    }
    for (int k = 0; k < kPieces; ++k) {
      Vec2 a = from + (to - from) * (static_cast<double>(k) / kPieces);
      Vec2 b = from + (to - from) * (static_cast<double>(k + 1) / kPieces);
      if (a.x() < least && b.x() < least) continue;
      if ((a.x() < least) != (b.x() < least)) {
        const Vec2 edge = a + (b - a) * ((least - a.x()) / (b.x() - a.x()));
        (a.x() < least ? a : b) = edge;
      }
      out.push_back({seen(a), seen(b)});
    }
  }
  return out;
}

void draw_outline(Page& page, const SectionPanel& panel, double beside_mm, const CompiledTool& tool, bool is_dashed) {
  for (const OutlineRun& run : tool_outline(tool)) {
    const Colour colour = is_dashed ? kSoftInk : body_colour(static_cast<int>(run.body));
    for (const auto& [from, to] : seen_profile(run.points, beside_mm)) {
      for (const double side : {1.0, -1.0}) {
        const Vec2 a(side * from.x(), from.y());
        const Vec2 b(side * to.x(), to.y());
        clipped_line(page, panel.area, panel.place(a), panel.place(b), colour, is_dashed ? 1.2 : 2,
                     is_dashed ? std::vector<double>{6, 4} : std::vector<double>{});
      }
    }
  }
}

// Draws dashes along lines that consist of short pieces.
void draw_clearance(Page& page, const SectionPanel& panel, double beside_mm, const CompiledTool& tool,
                    double clearance_mm) {
  constexpr double kDash = 6, kGap = 4;
  for (const std::vector<Vec2>& points : outline_at(tool, clearance_mm)) {
    double along = 0;
    for (const auto& line : seen_profile(points, beside_mm)) {
      const Vec2 from = line[0], to = line[1];
      const double length = (to - from).norm() / panel.mm_per_unit;
      for (double begin = 0; begin < length;) {
        const double in_period = std::fmod(along + begin, kDash + kGap);
        const bool is_dash = in_period < kDash;
        const double end =
            std::min(length, begin + (is_dash ? kDash : kDash + kGap) - in_period + Tolerance::kRounding);
        for (const double side : is_dash ? std::vector<double>{1, -1} : std::vector<double>{}) {
          const auto place = [&](double share) {
            const Vec2 p = from + (to - from) * (share / length);
            return panel.place({side * p.x(), p.y()});
          };
          clipped_line(page, panel.area, place(begin), place(end), kSoftInk, 1.2);
        }
        begin = end;
      }
      along += length;
    }
  }
}

bool is_offset(const CompiledTool& bare, const CompiledTool& checked) {
  return std::abs(bare.r_max_mm - checked.r_max_mm) > Tolerance::kSamePoint_mm ||
         std::abs(bare.z_min_mm - checked.z_min_mm) > Tolerance::kSamePoint_mm ||
         bare.elements.size() != checked.elements.size();
}

}  // namespace

void draw_section(Page& page, const SectionPanel& panel, const Section& section, bool is_closed,
                  const CompiledTool& bare, const CompiledTool& checked, double clearance_mm) {
  page.rasters.push_back({static_cast<int>(panel.area.x), static_cast<int>(panel.area.y),
                          paint_panel(panel, section, is_closed, checked.elements.empty() ? bare : checked)});
  for (const SectionLine& line : section.lines) {
    clipped_line(page, panel.area, panel.place(line.a), panel.place(line.b),
                 line.is_fixture ? Colour{70, 92, 118, 1} : kInk, 1.8);
  }
  for (const std::vector<SectionLine>& head : section.heads) {
    for (const SectionLine& line : head)
      clipped_line(page, panel.area, panel.place(line.a), panel.place(line.b),
                   body_colour(static_cast<int>(Body::head)), 2);
  }
  const double beside = section.plane.beside_mm;
  draw_outline(page, panel, beside, bare, false);
  if (!checked.elements.empty() && is_offset(bare, checked)) draw_outline(page, panel, beside, checked, true);
  if (clearance_mm > 0) draw_clearance(page, panel, beside, bare, clearance_mm);
  clipped_line(page, panel.area, panel.place({0, bare.z_min_mm - 1e3}), panel.place({0, bare.z_max_mm + 1e3}), kSoftInk,
               1, {14, 4, 3, 4});
}

}  // namespace gouge
