#include "cli/tools/identities.h"

#include <algorithm>
#include <cmath>

#include "lib/base/number_text.h"
#include "lib/base/sha256.h"
#include "toolmodels/profile.h"

namespace gouge {
namespace {

constexpr std::size_t kDigits = 32;

/// Conversion from inches changes the last digits of a dimension, but by far less than a step.
constexpr double kStepsPerMm = 1e6;

std::string steps_text(double value_mm) { return ' ' + std::to_string(std::llround(value_mm * kStepsPerMm)); }

std::string contour_text(const Profile& profile) {
  std::string text;
  for (const ProfileElement& e : profile.elements) {
    text += body_name(e.body);
    for (const Vec2& point : {e.a, e.b}) text += steps_text(point.x()) + steps_text(point.y());
    if (e.is_arc)
      text += (e.is_concave ? " concave" : " convex") + steps_text(e.center.x()) + steps_text(e.center.y()) +
              steps_text(e.radius_mm);
    text += '\n';
  }
  return text;
}

}  // namespace

std::string placement_identity(const RigidTransform& place, LengthUnit stl_unit) {
  std::string text = unit_name(stl_unit);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) text += ' ' + exact_text(place.rotation(row, column));
    text += ' ' + exact_text(place.shift[row]);
  }
  return sha256_of(text).substr(0, kDigits);
}

void identify_tool(const ToolAssembly& tool, bool is_extended_up, ToolFacts& facts) {
  const auto counts_as = [&](Body body) {
    return std::ranges::any_of(tool.extensions, [&](const ToolExtension& one) { return one.counts_as == body; });
  };
  facts.bodies = {Body::cutter};
  if (!tool.shank.empty() || counts_as(Body::shank)) facts.bodies.push_back(Body::shank);
  if (!tool.holder.empty() || counts_as(Body::holder)) facts.bodies.push_back(Body::holder);
  const Result<BodyProfiles> profiles = make_body_profiles(tool);
  if (!profiles) return;
  std::string text = std::string(tool.cuts ? "cuts" : "cuts nothing") + (is_extended_up ? ", extended up\n" : "\n");
  for (const Profile& profile : *profiles) text += contour_text(profile);
  facts.identity = sha256_of(text).substr(0, kDigits);
}

}  // namespace gouge
