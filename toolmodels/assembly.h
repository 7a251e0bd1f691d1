#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "lib/base/result.h"
#include "toolmodels/cutter.h"
#include "toolmodels/profile.h"

// A tool assembly by its dimensions: cutter, shank segments, extensions, holder segments, each standing on
// the one before. Diameters may grow and shrink, with or without a step between segments (thesis 2.4.18.3).

namespace gouge {

/// A cylinder or frustum.
struct ToolSegment {
  double lower_diameter_mm = 0, upper_diameter_mm = 0, length_mm = 0;
};

/// An extension or arbor between shank and holder. For clearances it counts as one of the two.
struct ToolExtension {
  std::string name;
  Body counts_as = Body::holder;  ///< shank or holder
  std::vector<ToolSegment> segments;
};

struct ToolAssembly {
  std::optional<int> number{};
  std::string name{};
  Cutter cutter{};
  std::vector<ToolSegment> shank{};   ///< from the cutter up; may be empty
  std::vector<ToolSegment> holder{};  ///< from the shank (or the extensions) up; may be empty
  std::vector<ToolExtension> extensions{};
  /// Stick-out of the tool from its lowest extension or holder. The shank above is inside and left out. 0: they stand
  /// on the shank's end.
  double stickout_mm = 0;
  double gauge_length_mm = 0;  ///< tip to gauge line; reported, not checked. 0: not given
  /// Length of the cutter above its flutes, as wide as they end: set by extended_up alone, in no library file.
  double cutter_goes_on_mm = 0;
  /// Names the part of its description that was left out and may be a body; empty: none. Not written to library files.
  std::string uncertainty{};
};

/// Per body its own closed contour at its position; index by Body. No elements: the tool has no such body.
using BodyProfiles = std::array<Profile, 3>;

/// Errors   (1) Those of make_cutter_profile. (2) For a segment tool-dimension-not-positive, tool-dimension-too-large.
///          (3) tool-stickout: less than the flutes, or more than the shank reaches. (4) tool-extension: one that
///          counts as shank above one that counts as holder. The message begins with the tool and the field ("tool T3
///          "slot": shank 2: ...").
[[nodiscard]] Result<BodyProfiles> make_body_profiles(const ToolAssembly& tool);

/// Returns the contour of the whole assembly without growth; faces between bodies vanish.
/// Ensures  verify_profile is empty.  Errors as make_body_profiles, and those of unite.
[[nodiscard]] Result<Profile> make_profile(const ToolAssembly& tool);

/// A segment at its position, cut where the tool goes into what holds it.
struct PositionedSegment {
  Body body = Body::shank;
  std::string name;  ///< "shank 2", "arbor 1", "holder 3"
  ToolSegment segment;
  double z_mm = 0;  ///< of its lower end
};

/// Returns every segment above the cutter, from the tip side up. Requires a tool that make_body_profiles accepts.
[[nodiscard]] std::vector<PositionedSegment> position_segments(const ToolAssembly& tool);

/// Returns the length from the tip to the lowest extension or holder; to the top when there is neither. Requires as
/// position_segments.
[[nodiscard]] double stickout_mm(const ToolAssembly& tool);
/// Returns the length from tip to top.
[[nodiscard]] double height_mm(const ToolAssembly& tool);

/// Returns the tool with its top body extended, as wide as it ends, until `height_mm` above the tip (when it is not
/// that high already). For a tool of flutes alone that is the cutter.
///
/// Ensures  Let height be at least the largest distance of a point of the scene from any tip, plus the tool's largest
///          radius. Then depths are those of the tool that goes on without end: no point comes nearer to the new top
///          than to its side. Proof: docs/guide/tools.md.
[[nodiscard]] ToolAssembly extended_up(const ToolAssembly& tool, double height_mm);

/// Returns the tool standing out `longer_mm` farther. Extensions and holder go up. The shank below them goes on, as
/// wide as it ends, where it is not long enough. A tool of flutes alone gets a shank.
[[nodiscard]] ToolAssembly with_longer_stickout(const ToolAssembly& tool, double longer_mm);

/// Flutes and shank, as far as what holds them may let them stand out; see ToolAssembly::stickout_mm.
[[nodiscard]] double shank_end_mm(const ToolAssembly& tool);

/// Returns how messages and pictures call the tool: T3 "slot", T3, or "slot".
[[nodiscard]] std::string label(const ToolAssembly& tool);

}  // namespace gouge
