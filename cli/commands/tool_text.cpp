#include "cli/commands/tool_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "lib/base/number_text.h"
#include "lib/base/printable_text.h"
#include "toolmodels/bsp.h"
#include "toolmodels/compile_tool.h"
#include "toolmodels/draw_profile.h"

namespace gouge {
namespace {

std::string in_unit(double value_mm, LengthUnit unit) {
  return exact_text(std::round(value_mm / mm_per(unit) * 1e6) / 1e6);
}

const char* unit_word(LengthUnit unit) { return unit == LengthUnit::inch ? "inches" : "mm"; }

double widest(const std::vector<ToolSegment>& segments) {
  double diameter = 0;
  for (const ToolSegment& s : segments) diameter = std::max({diameter, s.lower_diameter_mm, s.upper_diameter_mm});
  return diameter;
}

double total(const std::vector<ToolSegment>& segments) {
  double length = 0;
  for (const ToolSegment& s : segments) length += s.length_mm;
  return length;
}

std::string segments_text(const ToolAssembly& tool, LengthUnit unit) {
  std::string text;
  for (const PositionedSegment& placed : position_segments(tool)) {
    const ToolSegment& s = placed.segment;
    text += "  " + padded(placed.name, 9) + " z " + in_unit(placed.z_mm, unit) + " to " +
            in_unit(placed.z_mm + s.length_mm, unit) + ", diameter " + in_unit(s.lower_diameter_mm, unit);
    if (std::abs(s.upper_diameter_mm - s.lower_diameter_mm) > 0) text += " to " + in_unit(s.upper_diameter_mm, unit);
    const bool has_own_name = placed.name.rfind(body_name(placed.body), 0) != 0;
    text += (has_own_name ? std::string(", counts as ") + body_name(placed.body) : "") + "\n";
  }
  return text;
}

std::string lengths_text(const ToolAssembly& tool, LengthUnit unit) {
  std::string text;
  if (!tool.holder.empty() || !tool.extensions.empty())
    text += "  stick-out " + in_unit(stickout_mm(tool), unit) + ", tip to what holds the tool\n";
  if (tool.gauge_length_mm > 0) text += "  gauge     " + in_unit(tool.gauge_length_mm, unit) + ", tip to gauge line\n";
  return text;
}

std::string point_text(const Vec2& p, LengthUnit unit) {
  return "(" + in_unit(p.x(), unit) + ", " + in_unit(p.y(), unit) + ")";
}

std::string contour_text(const Profile& profile, LengthUnit unit) {
  std::string text = "  contour (r, z), from the tip:\n";
  for (const ProfileElement& e : profile.elements) {
    text += "    " + padded(body_name(e.body), 8) +
            padded(!e.is_arc      ? "line"
                   : e.is_concave ? "hollow"
                                  : "arc",
                   8) +
            point_text(e.a, unit) + " to " + point_text(e.b, unit);
    if (e.is_arc) text += ", radius " + in_unit(e.radius_mm, unit) + " about " + point_text(e.center, unit);
    text += "\n";
  }
  return text;
}

std::string tree_text(const CompiledTool& tool) {
  if (!tool.stretches.empty()) return "tree of " + std::to_string(tool.stretches.size()) + " stretches";
  return "BSP of " + std::to_string(tool.nodes.size()) + " nodes, depth " + std::to_string(bsp_depth(tool.nodes));
}

}  // namespace

std::string tool_list_text(const ToolLibrary& library) {
  const LengthUnit unit = library.unit;
  using Row = std::array<std::string, 6>;
  std::vector<Row> rows{{"tool", "name", "cutter", "flutes", "assembly", "holder"}};
  for (const ToolAssembly& t : library.tools) {
    const double height = height_mm(t);
    rows.push_back({t.number ? "T" + std::to_string(*t.number) : "-", t.name.empty() ? "-" : t.name,
                    describe_cutter(t.cutter, unit), in_unit(length_mm(t.cutter), unit), in_unit(height, unit),
                    t.holder.empty() ? "none" : "D " + in_unit(widest(t.holder), unit)});
  }
  std::array<std::size_t, 6> widths{};
  for (const Row& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], display_width(printable(row[i])));
  std::string text;
  for (const Row& row : rows) {
    for (std::size_t i = 0; i + 1 < row.size(); ++i) text += padded(row[i], widths[i] + 2);
    text += printable(row.back()) + "\n";
  }
  text += std::to_string(library.tools.size()) + (library.tools.size() == 1 ? " tool" : " tools") + ", lengths in " +
          unit_word(unit) + "\n";
  for (const NamedHolder& holder : library.holders)
    text += "holder \"" + printable(holder.name) + "\": D " + in_unit(widest(holder.segments), unit) + ", length " +
            in_unit(total(holder.segments), unit) + "\n";
  return text;
}

std::string tool_text(const ToolAssembly& tool, LengthUnit unit) {
  const Result<Profile> profile = make_profile(tool);
  if (!profile) return to_text(profile.error()) + "\n";
  const CompiledTool compiled = compile_tool(label(tool), *profile);
  std::string text = printable(label(tool)) + ", lengths in " + unit_word(unit) + "\n";
  text +=
      "  cutter    z 0 to " + in_unit(length_mm(tool.cutter), unit) + ", " + describe_cutter(tool.cutter, unit) + "\n";
  text += segments_text(tool, unit);
  text += lengths_text(tool, unit);
  text += "  assembly  length " + in_unit(height_mm(tool), unit) + ", largest diameter " +
          in_unit(2 * compiled.r_max_mm, unit) + "\n";
  text += contour_text(*profile, unit);
  text +=
      "  compiled  " + std::to_string(compiled.elements.size()) + " boundary elements, " + tree_text(compiled) + "\n";
  return text;
}

}  // namespace gouge
