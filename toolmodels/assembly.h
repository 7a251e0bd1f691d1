#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "lib/base/result.h"
#include "toolmodels/cutter.h"
#include "toolmodels/profile.h"

// A tool assembly by its dimensions: cutter, shank segments, extensions and holder segments. Each stands on the one
// before. Diameters may grow and shrink, with or without a step between segments (thesis 2.4.18.3).

namespace gouge {

/// A cylinder or frustum.
struct ToolSegment {
  double lower_diameter_mm = 0, upper_diameter_mm = 0, length_mm = 0;
};

/// An extension or arbor between shank and holder. For clearances it counts as shank or as holder.
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
  /// Stick-out of the tool from its lowest extension or holder. The shank above that height is inside, and left out. 0:
  /// extensions and holder stand on the end of the shank.
  double stickout_mm = 0;
  double gauge_length_mm = 0;  ///< tip to gauge line; compared with a stated tool length. 0: not given
  bool cuts = true;            ///< false: it removes no stock, for example a probe
  /// Length of an extension of the cutter above its flutes, with the diameter of their top. Only extended_up sets it;
  /// library files do not contain it.
  double cutter_goes_on_mm = 0;
  /// States why the tool may be another one than described: a part of its description was left out or is missing. Empty:
  /// it is certain.
  std::string uncertainty{};
  /// States why the holder that the file names is not part of the tool; empty: the file names none, or it is there. The
  /// tool is uncertain as long as it has no holder.
  std::string missing_holder{};
};

/// The closed contour of each body, at its position in the tool; the index is Body. A contour without elements: the
/// tool has no such body.
using BodyProfiles = std::array<Profile, 3>;

/// Errors   (1) Those of make_cutter_profile. (2) For a segment tool-dimension-not-positive, tool-dimension-too-large.
///          (3) tool-stickout: the stick-out is shorter than the flutes, or longer than the shank. (4) tool-extension:
///          an extension that counts as shank stands above one that counts as holder. The message begins with the tool
///          and the field ("tool T3 "slot": shank 2: ...").
[[nodiscard]] Result<BodyProfiles> make_body_profiles(const ToolAssembly& tool);

/// Returns the contour of the whole assembly without growth; faces between bodies are not part of it.
/// Ensures  verify_profile is empty.
/// Errors   Those of make_body_profiles, and those of unite.
[[nodiscard]] Result<Profile> make_profile(const ToolAssembly& tool);

/// A segment at its position, cut off at the lowest extension or holder that it stands in.
struct PositionedSegment {
  Body body = Body::shank;
  std::string name;  ///< "shank 2", "arbor 1", "holder 3"
  ToolSegment segment;
  double z_mm = 0;  ///< height of its lower end
};

/// Returns every segment above the cutter, from the tip side up. Requires a tool that make_body_profiles accepts.
[[nodiscard]] std::vector<PositionedSegment> position_segments(const ToolAssembly& tool);

/// Returns the length from the tip to the lowest extension or holder, or to the top if the tool has neither. Requires a
/// tool that make_body_profiles accepts.
[[nodiscard]] double stickout_mm(const ToolAssembly& tool);
/// Returns the length from tip to top.
[[nodiscard]] double height_mm(const ToolAssembly& tool);

/// Returns the tool with its top body extended to `height_mm` above the tip, with the diameter of its upper end. A tool
/// that is already that high stays the same. The top body of a tool of flutes alone is the cutter.
///
/// Ensures  Let `height_mm` be at least the largest distance of a point of the scene from any tip, plus the largest
///          radius of the tool. Then depths are equal to those of a tool that continues without end: no point comes
///          nearer to the new top than to its side. Proof: docs/guide/tools.md.
[[nodiscard]] ToolAssembly extended_up(const ToolAssembly& tool, double height_mm);

/// Returns the tool with a stick-out that is larger by `longer_mm`. Extensions and holder move up. A shank that is too
/// short is extended with the diameter of its upper end. A tool of flutes alone gets a shank.
[[nodiscard]] ToolAssembly with_longer_stickout(const ToolAssembly& tool, double longer_mm);

/// Returns the height up to which flutes and shank reach: the maximum stick-out; see ToolAssembly::stickout_mm.
[[nodiscard]] double shank_end_mm(const ToolAssembly& tool);

/// Returns the name of the tool in messages and pictures: T3 "slot", T3, or "slot".
[[nodiscard]] std::string label(const ToolAssembly& tool);

}  // namespace gouge
