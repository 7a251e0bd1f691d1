#include "toolmodels/assembly.h"

#include <algorithm>

#include "lib/base/tolerance.h"
#include "toolmodels/cutter_shapes.h"
#include "toolmodels/unite.h"

namespace gouge {
namespace {

using detail::mm;

Diagnostic named_within(const ToolAssembly& tool, const std::string& field, const Diagnostic& error) {
  Diagnostic reported = error;
  reported.message = "tool " + label(tool) + ": " + (field.empty() ? "" : field + ": ") + error.message;
  return reported;
}

Outcome check_segment(const ToolSegment& s) {
  if (Outcome good = check_length("length", s.length_mm); !good) return good;
  if (Outcome good = check_length("lower_diameter", s.lower_diameter_mm); !good) return good;
  return check_length("upper_diameter", s.upper_diameter_mm);
}

void add_step(Profile& profile, Body body, const Vec2& from, const Vec2& to) {
  if (from != to) profile.elements.push_back(make_segment(body, from, to));
}

Profile stack(Body body, const std::vector<PositionedSegment>& segments) {
  Profile profile;
  Vec2 at = Vec2::Zero();
  for (const PositionedSegment& s : segments) {
    if (s.body != body) continue;
    if (profile.elements.empty()) at = Vec2(0, s.z_mm);
    const Vec2 lower(s.segment.lower_diameter_mm / 2, s.z_mm);
    const Vec2 upper(s.segment.upper_diameter_mm / 2, s.z_mm + s.segment.length_mm);
    add_step(profile, body, at, Vec2(lower.x(), at.y()));
    profile.elements.push_back(make_segment(body, Vec2(lower.x(), at.y()), upper));
    at = upper;
  }
  if (!profile.elements.empty()) add_step(profile, body, at, Vec2(0, at.y()));
  return profile;
}

Outcome check_segments(const ToolAssembly& tool, const std::vector<ToolSegment>& segments, const std::string& body) {
  for (std::size_t i = 0; i < segments.size(); ++i)
    if (Outcome good = check_segment(segments[i]); !good)
      return named_within(tool, body + " " + std::to_string(i + 1), good.error());
  return Done{};
}

std::string name_of(const ToolExtension& extension) { return extension.name.empty() ? "extension" : extension.name; }

Outcome check_extensions(const ToolAssembly& tool) {
  bool is_holder_below = false;
  for (const ToolExtension& e : tool.extensions) {
    if (Outcome good = check_segments(tool, e.segments, "extension \"" + name_of(e) + "\""); !good) return good;
    if (is_holder_below && e.counts_as == Body::shank)
      return named_within(
          tool, "extension \"" + name_of(e) + "\"",
          make_error("tool-extension",
                     "counts as shank, but stands on one that counts as holder; let this one count as holder too"));
    is_holder_below = is_holder_below || e.counts_as == Body::holder;
  }
  return Done{};
}

// Extends the cutter upwards by `length_mm`, with the diameter of its upper end.
void go_on(Profile& cutter, double length_mm) {
  if (!(length_mm > 0)) return;
  const Vec2 top = cutter.elements.back().a;
  const Vec2 end(top.x(), top.y() + length_mm);
  cutter.elements.back() = make_segment(Body::cutter, top, end);
  cutter.elements.push_back(make_segment(Body::cutter, end, Vec2(0, end.y())));
}

/// Returns the diameter of the flutes at their top; 0 if the flutes have no valid profile.
double flutes_width_mm(const Cutter& cutter) {
  const Result<Profile> flutes = make_cutter_profile(cutter);
  return flutes ? 2 * flutes->elements.back().a.x() : 0;
}

bool is_held(const ToolAssembly& tool) { return !tool.extensions.empty() || !tool.holder.empty(); }

Outcome check_stickout(const ToolAssembly& tool) {
  if (Outcome good = detail::check_not_negative("stickout", tool.stickout_mm); !good)
    return named_within(tool, "", good.error());
  if (Outcome good = detail::check_not_negative("gauge_length", tool.gauge_length_mm); !good)
    return named_within(tool, "", good.error());
  if (!(tool.stickout_mm > 0)) return Done{};
  const double flutes = length_mm(tool.cutter), end = shank_end_mm(tool);
  if (tool.stickout_mm < flutes - Tolerance::kSamePoint_mm)
    return named_within(
        tool, "",
        make_error("tool-stickout", "stickout " + mm(tool.stickout_mm) + " is less than the length of the flutes, " +
                                        mm(flutes) + ": the holder would swallow the cutter; give at least that"));
  if (tool.stickout_mm > end + Tolerance::kSamePoint_mm)
    return named_within(
        tool, "",
        make_error("tool-stickout", "stickout " + mm(tool.stickout_mm) + " is more than flutes and shank reach, " +
                                        mm(end) + "; give at most that, or a longer shank"));
  return Done{};
}

class Placer {
 public:
  explicit Placer(const ToolAssembly& tool) : z_(length_mm(tool.cutter)) {
    const bool is_cut = tool.stickout_mm > 0 && is_held(tool);
    add(Body::shank, "shank", tool.shank, is_cut ? tool.stickout_mm : 1e300);
    if (is_cut) z_ = tool.stickout_mm;
    for (const ToolExtension& e : tool.extensions) add(e.counts_as, name_of(e), e.segments, 1e300);
    add(Body::holder, "holder", tool.holder, 1e300);
  }

  std::vector<PositionedSegment> take() { return std::move(placed_); }

 private:
  void add(Body body, const std::string& name, const std::vector<ToolSegment>& segments, double end_mm) {
    for (std::size_t i = 0; i < segments.size(); ++i) {
      ToolSegment s = segments[i];
      if (z_ >= end_mm - Tolerance::kSamePoint_mm) return;
      if (z_ + s.length_mm > end_mm) {
        s.upper_diameter_mm =
            s.lower_diameter_mm + (s.upper_diameter_mm - s.lower_diameter_mm) * ((end_mm - z_) / s.length_mm);
        s.length_mm = end_mm - z_;
      }
      placed_.push_back({body, name + " " + std::to_string(i + 1), s, z_});
      z_ += s.length_mm;
    }
  }

  double z_;
  std::vector<PositionedSegment> placed_;
};

}  // namespace

std::string label(const ToolAssembly& tool) {
  const std::string number = tool.number ? "T" + std::to_string(*tool.number) : "";
  if (tool.name.empty()) return number.empty() ? "without number or name" : number;
  return number + (number.empty() ? "" : " ") + "\"" + tool.name + "\"";
}

std::vector<PositionedSegment> position_segments(const ToolAssembly& tool) { return Placer(tool).take(); }

double stickout_mm(const ToolAssembly& tool) {
  return tool.stickout_mm > 0 && is_held(tool) ? tool.stickout_mm : shank_end_mm(tool);
}

double height_mm(const ToolAssembly& tool) {
  const std::vector<PositionedSegment> placed = position_segments(tool);
  return placed.empty() ? length_mm(tool.cutter) + tool.cutter_goes_on_mm
                        : placed.back().z_mm + placed.back().segment.length_mm;
}

Result<BodyProfiles> make_body_profiles(const ToolAssembly& tool) {
  Result<Profile> cutter = make_cutter_profile(tool.cutter);
  if (!cutter) return named_within(tool, "cutter", cutter.error());
  if (Outcome good = check_segments(tool, tool.shank, "shank"); !good) return good.error();
  if (Outcome good = check_extensions(tool); !good) return good.error();
  if (Outcome good = check_segments(tool, tool.holder, "holder"); !good) return good.error();
  if (Outcome good = check_stickout(tool); !good) return good.error();
  const std::vector<PositionedSegment> placed = position_segments(tool);
  BodyProfiles bodies;
  go_on(*cutter, tool.cutter_goes_on_mm);
  bodies[0] = std::move(*cutter);
  bodies[1] = stack(Body::shank, placed);
  bodies[2] = stack(Body::holder, placed);
  return bodies;
}

Result<Profile> make_profile(const ToolAssembly& tool) {
  const Result<BodyProfiles> bodies = make_body_profiles(tool);
  if (!bodies) return bodies.error();
  Result<Profile> united = unite({{&(*bodies)[0], 0}, {&(*bodies)[1], 0}, {&(*bodies)[2], 0}});
  if (!united) return named_within(tool, "", united.error());
  return united;
}

double shank_end_mm(const ToolAssembly& tool) {
  double z = length_mm(tool.cutter);
  for (const ToolSegment& s : tool.shank) z += s.length_mm;
  return z;
}

ToolAssembly with_longer_stickout(const ToolAssembly& tool, double longer_mm) {
  ToolAssembly longer = tool;
  if (!(longer_mm > 0)) return longer;
  const double wanted = is_held(tool) ? stickout_mm(tool) + longer_mm : shank_end_mm(tool) + longer_mm;
  const double missing = wanted - shank_end_mm(tool);
  const double width = tool.shank.empty() ? flutes_width_mm(tool.cutter) : tool.shank.back().upper_diameter_mm;
  if (missing > 0 && width > 0) longer.shank.push_back({width, width, missing});
  if (is_held(tool)) longer.stickout_mm = std::min(wanted, shank_end_mm(longer));
  if (tool.gauge_length_mm > 0) longer.gauge_length_mm += longer_mm;
  return longer;
}

ToolAssembly extended_up(const ToolAssembly& tool, double top_mm) {
  ToolAssembly longer = tool;
  const double height = height_mm(tool);
  if (height >= top_mm) return longer;
  const std::vector<PositionedSegment> placed = position_segments(tool);
  if (placed.empty()) {
    if (flutes_width_mm(tool.cutter) > 0) longer.cutter_goes_on_mm = top_mm - height;
    return longer;
  }
  const double width = placed.back().segment.upper_diameter_mm;
  const ToolSegment more{width, width, top_mm - height};
  if (!tool.holder.empty())
    longer.holder.push_back(more);
  else if (!tool.extensions.empty())
    longer.extensions.back().segments.push_back(more);
  else
    longer.shank.push_back(more);
  return longer;
}

}  // namespace gouge
