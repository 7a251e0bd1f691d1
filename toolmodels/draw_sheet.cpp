#include <algorithm>
#include <cmath>

#include "lib/base/number_text.h"
#include "toolmodels/compile_tool.h"
#include "toolmodels/draw_parts.h"
#include "toolmodels/draw_profile.h"

namespace gouge {
namespace {

using detail::ProfileView;

constexpr double kFieldWidth = 620, kFieldHeight = 520;
constexpr double kSheetTop = 104, kSheetBottom = 470;  // vertical extent of the pictures within a field
constexpr Colour kSheetInk{25, 28, 35, 1};
constexpr Colour kSheetFaint{170, 174, 182, 1};

std::string number(double value_mm, LengthUnit unit) {
  const double digits = unit == LengthUnit::inch ? 1e4 : 1e3;
  return exact_text(std::round(value_mm / mm_per(unit) * digits) / digits);
}

// Returns the text cut off after `most` characters, so that it fits into a field.
std::string shortened(const std::string& text, std::size_t most) {
  return text.size() <= most ? text : text.substr(0, most - 3) + "...";
}

class Field {
 public:
  Field(Drawing& sheet, const Vec2& corner, const ToolAssembly& tool, LengthUnit unit)
      : sheet_(sheet), corner_(corner), tool_(tool), unit_(unit) {}

  Outcome draw() {
    const Result<BodyProfiles> bodies = make_body_profiles(tool_);
    if (!bodies) return bodies.error();
    const Result<Profile> profile = make_profile(tool_);
    if (!profile) return profile.error();
    draw_frame();
    draw_whole(*bodies);
    draw_cutter((*bodies)[0]);
    return Done{};
  }

 private:
  [[nodiscard]] Vec2 at(double x, double y) const { return corner_ + Vec2(x, y); }

  void draw_frame() {
    const std::vector<Vec2> frame{at(0, 0), at(kFieldWidth, 0), at(kFieldWidth, kFieldHeight), at(0, kFieldHeight)};
    sheet_.items.emplace_back(DrawnLine{frame, kSheetFaint, 1, true, {}});
    detail::draw_text(sheet_, at(20, 40), shortened(label(tool_), 38), 24, TextAnchor::left, true);
    detail::draw_text(sheet_, at(20, 70), shortened(describe_cutter(tool_.cutter, unit_), 62), 17, TextAnchor::left);
    const std::string lengths = "flutes " + number(length_mm(tool_.cutter), unit_) + ", assembly " +
                                number(height_mm(tool_), unit_) + " " + unit_name(unit_) +
                                (tool_.holder.empty() ? ", no holder" : "");
    detail::draw_text(sheet_, at(20, kFieldHeight - 18), lengths, 17, TextAnchor::left);
  }

  void fill(const Profile& body, Body colour, const ProfileView& view) {
    DrawnShape shape;
    shape.fill = detail::lightened(detail::body_colour(colour), 0.25);
    std::vector<Vec2> half;
    for (const ProfileElement& e : body.elements)
      for (const Vec2& p : sample(e, 48)) half.push_back(p);
    for (const Vec2& p : half) shape.points.push_back(view.at(p));
    for (auto p = half.rbegin(); p != half.rend(); ++p) shape.points.push_back(view.mirrored(*p));
    DrawnLine outline{shape.points, kSheetInk, 1.2, true, {}};
    sheet_.items.emplace_back(std::move(shape));
    sheet_.items.emplace_back(std::move(outline));
  }

  [[nodiscard]] ProfileView view_of(const Profile& profile, double left, double right) const {
    const CompiledTool tool = compile_tool("", profile);
    ProfileView view;
    view.scale =
        std::min((right - left) / (2 * tool.r_max_mm), (kSheetBottom - kSheetTop) / (tool.z_max_mm - tool.z_min_mm));
    view.low = Vec2(0, tool.z_min_mm);
    view.high = Vec2(tool.r_max_mm, tool.z_max_mm);
    view.origin = at(0.5 * (left + right), kSheetBottom + view.scale * tool.z_min_mm);
    return view;
  }

  void draw_whole(const BodyProfiles& bodies) {
    const Result<Profile> whole = make_profile(tool_);
    const ProfileView view = view_of(*whole, 24, 224);
    for (std::size_t i = 0; i < bodies.size(); ++i)
      if (!bodies[i].elements.empty()) fill(bodies[i], static_cast<Body>(i), view);
  }

  // Draws the left half plain, and the right half with its regions.
  void draw_cutter(const Profile& cutter) {
    const ProfileView view = view_of(cutter, 270, 590);
    const CompiledTool compiled = compile_tool("", cutter);
    fill(cutter, Body::cutter, view);
    detail::draw_regions(sheet_, compiled, view, false);
    detail::draw_contour(sheet_, cutter, view, 2);
    detail::draw_line(sheet_, view.at(Vec2(0, compiled.z_max_mm)) - Vec2(0, 12),
                      view.at(Vec2(0, compiled.z_min_mm)) + Vec2(0, 12), kSheetInk, 1, {12, 4, 3, 4});
  }

  Drawing& sheet_;
  Vec2 corner_;
  const ToolAssembly& tool_;
  LengthUnit unit_;
};

}  // namespace

Result<Drawing> draw_sheet(const std::vector<const ToolAssembly*>& tools, LengthUnit unit) {
  Drawing sheet;
  const auto columns =
      std::clamp<std::size_t>(static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(tools.size())))), 1, 4);
  const std::size_t rows = (tools.size() + columns - 1) / columns;
  sheet.width = kFieldWidth * static_cast<double>(columns);
  sheet.height = kFieldHeight * static_cast<double>(rows);
  for (std::size_t i = 0; i < tools.size(); ++i) {
    const Vec2 corner(kFieldWidth * static_cast<double>(i % columns), kFieldHeight * static_cast<double>(i / columns));
    if (Outcome drawn = Field(sheet, corner, *tools[i], unit).draw(); !drawn) return drawn.error();
  }
  return sheet;
}

}  // namespace gouge
