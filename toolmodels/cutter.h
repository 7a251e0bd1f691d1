#pragma once

#include <string>
#include <variant>
#include <vector>

#include "lib/base/diagnostic.h"
#include "lib/base/result.h"
#include "lib/path/apt_cutter.h"
#include "toolmodels/profile.h"

// The shapes of cutters by their catalogue dimensions. Lengths are in mm and angles in degrees. The tip is at (0, 0),
// and `length_mm` is the length from the tip to the top of the flutes. An optional field that is not given is 0.
// Sketches: docs/formats/tool_library.md.

namespace gouge {

struct FlatCutter {
  double diameter_mm = 0, length_mm = 0;
};

struct BallCutter {
  double diameter_mm = 0, length_mm = 0;
};

struct BullNoseCutter {
  double diameter_mm = 0, corner_radius_mm = 0, length_mm = 0;
};

/// A cutter with a corner arc of radius c, centred at (diameter/2 - c, c). The arc is tangent to the tip plane and to a
/// side that leans outward by `taper_angle_deg` from the axis (inward when negative). With c = diameter/2 it is the
/// tapered ball.
struct TaperedCutter {
  double diameter_mm = 0, corner_radius_mm = 0, taper_angle_deg = 0, length_mm = 0;
};

/// A conical point with the included angle `point_angle_deg`, then a cylinder.
struct DrillCutter {
  double diameter_mm = 0, point_angle_deg = 0, length_mm = 0;
};

/// A cone from `tip_diameter_mm` (0: a point) up to the largest diameter, then a cylinder.
struct ChamferCutter {
  double diameter_mm = 0, tip_diameter_mm = 0;
  double taper_angle_deg = 0;  ///< between side and axis: half of the included angle
  double length_mm = 0;        ///< 0: the flutes end where the cone reaches the diameter
};

/// A ball that ends at the height at which its width is that of the neck.
struct LollipopCutter {
  double diameter_mm = 0;
  double neck_diameter_mm = 0;  ///< 0: the ball ends at `length_mm`
  double length_mm = 0;         ///< 0: the ball ends at the neck
};

struct TSlotCutter {
  double diameter_mm = 0, corner_radius_mm = 0, upper_radius_mm = 0, length_mm = 0;
};

/// A blade, with the head of its screw below it if the tool has one. The tip is then the bottom of the screw.
struct SlittingSawCutter {
  double diameter_mm = 0, thickness_mm = 0, cap_diameter_mm = 0, cap_height_mm = 0;
};

/// A cutter that is widest at the bottom; its sides lean inward by `taper_angle_deg` from the axis.
struct DovetailCutter {
  double diameter_mm = 0, corner_radius_mm = 0, taper_angle_deg = 0, length_mm = 0;
};

/// A cutter whose flank is an arc of `profile_radius_mm`. At the height `axial_distance_mm` its diameter is
/// `diameter_mm`, and the flank leans outward by `taper_angle_deg` (0: this is its widest point). A corner arc touches
/// the flank and the tip plane.
struct BarrelCutter {
  double diameter_mm = 0, profile_radius_mm = 0, corner_radius_mm = 0, taper_angle_deg = 0;
  double axial_distance_mm = 0, length_mm = 0;
};

/// A ball of `corner_radius_mm` at the tip, then a flank arc that touches both the ball and the cylinder of the
/// diameter.
struct OvalCutter {
  double diameter_mm = 0, corner_radius_mm = 0, profile_radius_mm = 0, length_mm = 0;
};

/// A bottom arc of `profile_radius_mm` about the axis, then a corner arc that touches both the bottom arc and the
/// cylinder.
struct LensCutter {
  double diameter_mm = 0, profile_radius_mm = 0, corner_radius_mm = 0, length_mm = 0;
};

/// A bottom, a corner, an edge that leans outward by `taper_angle_deg` up to `largest_diameter_mm`, then a cylinder.
/// `diameter_mm` is the diameter at which the edge, extended downwards, meets the tip plane. The underside may be
/// hollow.
struct FaceMillCutter {
  double diameter_mm = 0, corner_radius_mm = 0, taper_angle_deg = 0, largest_diameter_mm = 0;
  double recess_diameter_mm = 0, recess_depth_mm = 0, length_mm = 0;
};

/// A cutter that rounds an outer edge: a concave quarter circle of `profile_radius_mm` runs from the tip outward.
struct RadiusCutter {
  double tip_diameter_mm = 0, tip_length_mm = 0, profile_radius_mm = 0;
  double diameter_mm = 0;  ///< 0: the diameter at which the arc ends
  double length_mm = 0;
};

/// A point of a free profile, with the shape of the contour between the previous point and this one.
struct ProfilePoint {
  enum class SegmentShape { straight, convex, concave } shape = SegmentShape::straight;
  double r_mm = 0, z_mm = 0;
  double radius_mm = 0;  ///< of an arc; the arc is the shorter one between the two points
};

/// A contour given from the tip side up. An end that is not on the axis is joined to it by a horizontal line.
struct ProfileCutter {
  std::vector<ProfilePoint> points;
};

using Cutter = std::variant<FlatCutter, BallCutter, BullNoseCutter, TaperedCutter, AptCutter, DrillCutter,
                            ChamferCutter, LollipopCutter, TSlotCutter, SlittingSawCutter, DovetailCutter, BarrelCutter,
                            OvalCutter, LensCutter, FaceMillCutter, RadiusCutter, ProfileCutter>;

/// Returns the word for the shape in the library file: "flat", "ball", "bull_nose", ...
[[nodiscard]] const char* shape_name(const Cutter& cutter);
/// Returns one cutter without dimensions for every shape, in the order of the variant.
[[nodiscard]] const std::vector<Cutter>& every_shape();
/// Returns the height of the flutes' top. For a shape whose length may be left out, the height is computed from the
/// other dimensions. The result means nothing for a cutter that make_cutter_profile refuses.
[[nodiscard]] double length_mm(const Cutter& cutter);

/// Diameter and corner radius of the cutter's catalogue entry, as in CUTTER/d,r.
struct NominalSize {
  double diameter_mm = 0, corner_radius_mm = 0;
};
[[nodiscard]] NominalSize nominal_size(const Cutter& cutter);

/// Makes the contour of the cutter alone, closed by a flat top at its length.
///
/// Ensures  (1) The result of verify_profile is empty. (2) The contour is single-valued, except for a hollow bottom and
///          free profiles. (3) Parts of no length are left out: a bull-nose whose corner radius is half its diameter is
///          the ball, bit for bit.
/// Errors   Codes: tool-dimension-not-positive, tool-dimension-negative, tool-dimension-too-large,
///          tool-corner-radius-negative, tool-corner-radius-too-large, tool-angle-out-of-range, tool-taper-closes,
///          tool-length-too-short, tool-dimensions-contradict, tool-no-closed-profile, tool-profile-broken. The message
///          names the field and states what would be allowed.
/// Source   Design of the tool library (docs/formats/tool_library.md); APT: thesis 2.4.18.2 and CL-data usage.
[[nodiscard]] Result<Profile> make_cutter_profile(const Cutter& cutter);

/// Returns the values of e and f that follow from the other five numbers if the given values differ from them; empty if
/// they agree. If both are 0, they are not given. As some writers use e for the diameter of the flat tip, that value
/// agrees too.
[[nodiscard]] std::string apt_contradiction(const AptCutter& cutter);

/// Checks that a length is positive, finite and not absurdly large, for cutters and segments.
[[nodiscard]] Outcome check_length(const std::string& field, double value_mm);

}  // namespace gouge
