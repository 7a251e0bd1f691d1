#include "toolmodels/assembly.h"

#include "toolmodels/unite.h"

namespace gouge {
namespace {

Diagnostic within(const ToolAssembly& tool, const std::string& field, const Diagnostic& error) {
  Diagnostic told = error;
  told.message = "tool " + label(tool) + ": " + field + ": " + error.message;
  return told;
}

Outcome check_segment(const ToolSegment& s) {
  if (Outcome good = check_length("length", s.length_mm); !good) return good;
  if (Outcome good = check_length("lower_diameter", s.lower_diameter_mm); !good) return good;
  return check_length("upper_diameter", s.upper_diameter_mm);
}

void add_step(Profile& profile, Body body, const Vec2& from, const Vec2& to) {
  if (from != to) profile.elements.push_back(make_segment(body, from, to));
}

Profile stack(Body body, const std::vector<ToolSegment>& segments, double& z) {
  Profile profile;
  Vec2 at(0, z);
  for (const ToolSegment& s : segments) {
    const Vec2 lower(s.lower_diameter_mm / 2, z);
    z += s.length_mm;
    const Vec2 upper(s.upper_diameter_mm / 2, z);
    add_step(profile, body, at, lower);
    profile.elements.push_back(make_segment(body, lower, upper));
    at = upper;
  }
  if (!profile.elements.empty()) add_step(profile, body, at, Vec2(0, z));
  return profile;
}

Outcome check_segments(const ToolAssembly& tool, const std::vector<ToolSegment>& segments, const char* body) {
  for (std::size_t i = 0; i < segments.size(); ++i)
    if (Outcome good = check_segment(segments[i]); !good)
      return within(tool, std::string(body) + " " + std::to_string(i + 1), good.error());
  return Done{};
}

}  // namespace

std::string label(const ToolAssembly& tool) {
  const std::string number = tool.number ? "T" + std::to_string(*tool.number) : "";
  if (tool.name.empty()) return number.empty() ? "without number or name" : number;
  return number + (number.empty() ? "" : " ") + "\"" + tool.name + "\"";
}

Result<BodyProfiles> make_body_profiles(const ToolAssembly& tool) {
  Result<Profile> cutter = make_cutter_profile(tool.cutter);
  if (!cutter) return within(tool, "cutter", cutter.error());
  if (Outcome good = check_segments(tool, tool.shank, "shank"); !good) return good.error();
  if (Outcome good = check_segments(tool, tool.holder, "holder"); !good) return good.error();
  double z = length_mm(tool.cutter);
  BodyProfiles bodies;
  bodies[0] = std::move(*cutter);
  bodies[1] = stack(Body::shank, tool.shank, z);
  bodies[2] = stack(Body::holder, tool.holder, z);
  return bodies;
}

Result<Profile> make_profile(const ToolAssembly& tool) {
  const Result<BodyProfiles> bodies = make_body_profiles(tool);
  if (!bodies) return bodies.error();
  Result<Profile> united = unite({{&(*bodies)[0], 0}, {&(*bodies)[1], 0}, {&(*bodies)[2], 0}});
  if (!united) return within(tool, "bodies", united.error());
  return united;
}

}  // namespace gouge
