#include "toolmodels/from_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lib/base/number_text.h"

namespace gouge {
namespace {

double tangent_of(double degrees) { return std::tan(degrees * (std::numbers::pi / 180)); }

std::string cutter_mm(double value) { return exact_text(std::round(value * 1e6) / 1e6) + " mm"; }

// Returns the largest height that the corner can reach. The part above it is the side.
double tip_height(const AptCutter& c) {
  return c.d_mm / 2 * tangent_of(std::clamp(c.alpha_deg, 0.0, 89.0)) + 2 * c.r_mm;
}

double assumed_height(const AptCutter& c) {
  const double usual = std::max({5 * c.d_mm, 50.0, 2 * tip_height(c)});
  if (c.beta_deg >= 0 || c.beta_deg <= -89) return usual;
  return std::min(usual, 0.9 * (c.d_mm / 2) / tangent_of(-c.beta_deg));
}

// Returns whether the height is only that of the tip. Writers that do not know the height of the tool state this one.
bool ends_within_tip(AptCutter cutter) {
  constexpr double kShorter = 1 - 1e-6;
  cutter.h_mm *= kShorter;
  const Result<Profile> profile = make_cutter_profile(cutter);
  return !profile && (profile.error().code == "tool-length-too-short");
}

// Divides the contour at the flute length. The part above does not cut, and becomes the shank.
void split_shank(ToolAssembly& tool, AptCutter cutter, double flute_length_mm) {
  const Result<Profile> whole = make_cutter_profile(cutter);
  const double height = cutter.h_mm;
  cutter.h_mm = flute_length_mm;
  const Result<Profile> flutes = make_cutter_profile(cutter);
  if (!whole || !flutes) return;
  tool.cutter = cutter;
  tool.shank = {{2 * flutes->elements.back().a.x(), 2 * whole->elements.back().a.x(), height - flute_length_mm}};
}

}  // namespace

Result<ToolFromPath> make_tool_from_path(const PathTool& tool, const std::vector<ToolSegment>& holder) {
  ToolFromPath made;
  made.tool.number = tool.number;
  made.tool.name = tool.name;
  made.tool.holder = holder;
  const AptCutter& c = *tool.cutter;
  AptCutter cutter = c;
  if (!(cutter.h_mm > 0)) cutter.h_mm = tool.flute_length_mm;
  // Part of a longer tool is inside the holder. A tool without a holder keeps it: nothing is missed.
  if (tool.stickout_mm > 0 && !holder.empty() && tool.stickout_mm < cutter.h_mm) cutter.h_mm = tool.stickout_mm;
  const std::string who = "tool " + label(made.tool) + ": ";
  if (!(cutter.h_mm > 0) || ends_within_tip(cutter)) {
    cutter.h_mm = assumed_height(c);
    made.is_length_stated = false;
    const std::string found = c.h_mm > 0 ? "its height h = " + cutter_mm(c.h_mm) + " ends within the tip"
                                         : "the file gives the cutter no length";
    made.notes.push_back(make_note("cutter-length", who + found + "; it is checked up to " + cutter_mm(cutter.h_mm)));
  }
  if (const std::string contradiction = apt_contradiction(cutter); !contradiction.empty())
    made.notes.push_back(make_warning("cutter-contradiction", who + contradiction));
  made.tool.cutter = cutter;
  if (tool.flute_length_mm > 0 && tool.flute_length_mm < cutter.h_mm)
    split_shank(made.tool, cutter, tool.flute_length_mm);
  if (const Result<BodyProfiles> bodies = make_body_profiles(made.tool); !bodies) return bodies.error();
  return made;
}

}  // namespace gouge
