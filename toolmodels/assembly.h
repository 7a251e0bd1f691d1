#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "lib/base/result.h"
#include "toolmodels/cutter.h"
#include "toolmodels/profile.h"

// A tool assembly by its dimensions: cutter, then shank segments, then holder segments, each standing on the
// one before. Diameters may grow and shrink, with or without a step between segments (thesis 2.4.18.3).

namespace gouge {

/// A cylinder or frustum.
struct ToolSegment {
  double lower_diameter_mm = 0, upper_diameter_mm = 0, length_mm = 0;
};

struct ToolAssembly {
  std::optional<int> number;
  std::string name;
  Cutter cutter;
  std::vector<ToolSegment> shank;   ///< from the cutter up; may be empty
  std::vector<ToolSegment> holder;  ///< from the shank up; may be empty
};

/// Per body its own closed contour at its place; index by Body. No elements: the tool has no such body.
using BodyProfiles = std::array<Profile, 3>;

/// Errors   those of make_cutter_profile, and for a segment tool-dimension-not-positive,
///          tool-dimension-too-large; the message begins with the tool and the field ("tool T3 "slot": shank
///          2: ...").
[[nodiscard]] Result<BodyProfiles> make_body_profiles(const ToolAssembly& tool);

/// The contour of the whole assembly without growth; faces between bodies vanish.
/// Ensures  verify_profile is empty.  Errors as make_body_profiles.
[[nodiscard]] Result<Profile> make_profile(const ToolAssembly& tool);

/// How messages and pictures call the tool: T3 "slot", T3, or "slot".
[[nodiscard]] std::string label(const ToolAssembly& tool);

}  // namespace gouge
