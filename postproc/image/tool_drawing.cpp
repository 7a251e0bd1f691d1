#include "postproc/image/tool_drawing.h"

#include <algorithm>
#include <array>

#include "lib/base/number_text.h"
#include "postproc/image/tool_outline.h"
#include "postproc/report/report_text.h"

namespace gouge {
namespace {

constexpr double kWidth = 104, kHeight = 176, kMargin = 4;  // pixels of the page
constexpr std::array kClasses = {"cutter", "shank", "holder", "head"};

/// The box of an outline in mm.
struct Extent {
  double radius_mm = 0, low_mm = 0, high_mm = 0;
};

Extent extent_of(const std::vector<OutlineRun>& runs) {
  Extent box{0, runs.front().points.front().y(), runs.front().points.front().y()};
  for (const OutlineRun& run : runs) {
    for (const Vec2& p : run.points) {
      box.radius_mm = std::max(box.radius_mm, p.x());
      box.low_mm = std::min(box.low_mm, p.y());
      box.high_mm = std::max(box.high_mm, p.y());
    }
  }
  return box;
}

// Returns the region between a run and its mirror image, in pixels.
std::string region_of(const OutlineRun& run, const Extent& box, double scale) {
  std::string points;
  const auto add = [&](double r_mm, double z_mm) {
    points += (points.empty() ? "" : " ") + fixed_text(kWidth / 2 + r_mm * scale, 2) + "," +
              fixed_text(kMargin + (box.high_mm - z_mm) * scale, 2);
  };
  for (const Vec2& p : run.points) add(p.x(), p.y());
  for (auto p = run.points.rbegin(); p != run.points.rend(); ++p) add(-p->x(), p->y());
  const std::size_t body = std::min<std::size_t>(static_cast<std::size_t>(run.body), kClasses.size() - 1);
  return std::string("<polygon class=\"") + kClasses[body] + "\" points=\"" + points + "\"/>";
}

}  // namespace

std::string tool_drawing(const CompiledTool& tool, const std::string& label) {
  const std::vector<OutlineRun> runs = tool_outline(tool);
  if (runs.empty() || runs.front().points.empty()) return {};
  const Extent box = extent_of(runs);
  const double length_mm = box.high_mm - box.low_mm;
  if (box.radius_mm <= 0 || length_mm <= 0) return {};
  const double scale = std::min((kWidth - 2 * kMargin) / (2 * box.radius_mm), (kHeight - 2 * kMargin) / length_mm);
  const double height = length_mm * scale + 2 * kMargin;
  std::string svg = "<svg role=\"img\" aria-label=\"" + xml_escaped(label) + "\" width=\"" + fixed_text(kWidth, 0) +
                    "\" height=\"" + fixed_text(height, 0) + "\" viewBox=\"0 0 " + fixed_text(kWidth, 0) + " " +
                    fixed_text(height, 2) + "\">";
  for (const OutlineRun& run : runs) svg += region_of(run, box, scale);
  const std::string middle = fixed_text(kWidth / 2, 2);
  return svg + "<line class=\"axis\" x1=\"" + middle + "\" y1=\"0\" x2=\"" + middle + "\" y2=\"" +
         fixed_text(height, 2) + "\"/></svg>";
}

}  // namespace gouge
