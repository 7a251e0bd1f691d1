#include "cli/tools/shared_numbers.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cli/tools/compare_tools.h"
#include "lib/base/number_text.h"
#include "lib/base/tolerance.h"
#include "lib/base/units.h"
#include "toolmodels/silhouette.h"

namespace gouge {
namespace {

constexpr double kOutline_mm = 5e-3;
constexpr double kSameLength_mm = 1;  // lengths that differ by less may be measured ones
constexpr double kSameAngle_deg = 1e-3;

std::vector<bool> tools_with_checked_moves(const Toolpath& path) {
  std::vector<bool> is_checked(path.tools.size(), false);
  for (const Move& move : path.moves) {
    if (move.tool != kNone && (move.not_checked_reason.empty() || move.is_covered())) is_checked[move.tool] = true;
  }
  return is_checked;
}

// Returns whether two statements of the path define different cutters. One that states no length adds nothing.
bool is_other_cutter(const CutterStatement& a, const CutterStatement& b) {
  const auto differs = [](double x, double y, double tolerance) { return std::abs(x - y) > tolerance; };
  if (differs(a.d_mm, b.d_mm, Tolerance::kFilePoint_mm) || differs(a.r_mm, b.r_mm, Tolerance::kFilePoint_mm))
    return true;
  if (differs(a.alpha_deg, b.alpha_deg, kSameAngle_deg) || differs(a.beta_deg, b.beta_deg, kSameAngle_deg)) return true;
  return a.h_mm > 0 && b.h_mm > 0 && differs(a.h_mm, b.h_mm, kSameLength_mm);
}

bool is_other_outline(const ToolAssembly& a, const ToolAssembly& b) {
  const double top = std::min(height_mm(a), height_mm(b)) - kOutline_mm;
  return std::max(reach_beyond_mm(a, b, 0, top), reach_beyond_mm(b, a, 0, top)) > kOutline_mm;
}

std::string number_in(double mm, LengthUnit unit) { return exact_text(std::round(mm / mm_per(unit) * 1e6) / 1e6); }

std::string angle_text(const char* name, double degrees) {
  return std::abs(degrees) > 0 ? std::string(" ") + name + " " + exact_text(degrees) : std::string();
}

}  // namespace

SharedNumbers::SharedNumbers(const Toolpath& path) : path_(path), is_checked_(tools_with_checked_moves(path)) {}

bool SharedNumbers::is_other(const Taken& a, const Taken& b) const {
  if (a.known != nullptr && a.known == b.known) return false;
  if (a.known == nullptr && b.known == nullptr) return is_other_cutter(*a.tool->cutter, *b.tool->cutter);
  if (is_other_outline(a.assembly, b.assembly)) return true;
  return a.known != nullptr && b.known != nullptr &&
         std::abs(height_mm(a.assembly) - height_mm(b.assembly)) > kSameLength_mm;
}

std::string SharedNumbers::describe(const Taken& taken) const {
  const std::string place = " in line " + std::to_string(taken.tool->line);
  if (taken.known != nullptr) return label(*taken.known) + " of the library" + place;
  const CutterStatement& c = *taken.tool->cutter;
  std::string text = "D " + number_in(c.d_mm, path_.unit) + " R " + number_in(c.r_mm, path_.unit);
  if (c.h_mm > 0) text += " length " + number_in(c.h_mm, path_.unit);
  return text + " " + unit_name(path_.unit) + angle_text("tip angle", c.alpha_deg) +
         angle_text("flank angle", c.beta_deg) + place;
}

std::string SharedNumbers::take(std::size_t tool, const ToolAssembly& assembly, const ToolAssembly* known) {
  const PathTool& stated = path_.tools[tool];
  if (stated.number.value_or(0) == 0 || !is_checked_[tool]) return {};
  taken_.push_back({&stated, assembly, known});
  const Taken& last = taken_.back();
  for (const Taken& other : taken_) {
    if (other.tool->number != stated.number || &other == &last || !is_other(other, last)) continue;
    return name_of(stated) + " is " + describe(other) + ", and " + describe(last) +
           ", but a machine has one tool of that number";
  }
  return {};
}

}  // namespace gouge
