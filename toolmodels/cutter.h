#pragma once

#include <string>
#include <variant>

#include "lib/base/diagnostic.h"
#include "lib/base/result.h"
#include "toolmodels/profile.h"

// The shapes of cutters by their catalogue dimensions. Lengths in mm, `length_mm` from the tip to the top of
// the flutes, tip at (0, 0).
//
//   flat      ball       bull_nose     tapered               apt
//   |    |    |    |     |      |      \        /   taper    \            /  beta from the axis
//   |    |    |    |     |      |       \      /   from the   \          /
//   +----+     \__/       \____/         \____/    axis        `--.  .--'    alpha above the tip plane
//                         corner         corner                    `'        corner radius r

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

/// The corner arc of radius c is centred at (diameter/2 - c, c), tangent to the tip plane and to a side that
/// leans outward by `taper_angle_deg` from the axis (inward when negative). c = diameter/2 is the tapered
/// ball.
struct TaperedCutter {
  double diameter_mm = 0, corner_radius_mm = 0, taper_angle_deg = 0, length_mm = 0;
};

/// CUTTER/d,r,e,f,alpha,beta,h. The bottom line rises from the tip by alpha against the tip plane, the side
/// leans outward by beta from the axis, d is the diameter at which these two lines meet, the corner arc of
/// radius r touches both; e and f place its centre. They follow from d, r, alpha and beta, and writers
/// disagree about them, so the geometry is built without them; `apt_contradiction` tells when they differ.
struct AptCutter {
  double d_mm = 0, r_mm = 0, e_mm = 0, f_mm = 0;
  double alpha_deg = 0, beta_deg = 0;
  double h_mm = 0;
};

using Cutter = std::variant<FlatCutter, BallCutter, BullNoseCutter, TaperedCutter, AptCutter>;

/// "flat", "ball", "bull_nose", "tapered", "apt": the word of the library file.
[[nodiscard]] const char* shape_name(const Cutter& cutter);
[[nodiscard]] double length_mm(const Cutter& cutter);

/// Contour of the cutter alone, closed by a flat top at its length.
///
/// Ensures  (1) verify_profile is empty and the contour is single-valued; (2) parts of no length are left
/// out:
///          a bull-nose whose corner radius is half its diameter is the ball, bit for bit.
/// Errors   tool-dimension-not-positive, tool-dimension-too-large, tool-corner-radius-negative,
///          tool-corner-radius-too-large, tool-angle-out-of-range, tool-taper-closes, tool-length-too-short,
///          tool-no-closed-profile. The message names the field and says what would be allowed.
/// Source   design of the tool library (docs/formats/tool_library.md); APT: thesis 2.4.18.2 and CL-data
/// usage.
[[nodiscard]] Result<Profile> make_cutter_profile(const Cutter& cutter);

/// What e and f should be for the other five numbers, when the given ones say something else (both zero means
/// not given); empty when they agree.
[[nodiscard]] std::string apt_contradiction(const AptCutter& cutter);

/// Positive, finite and not absurdly large; the check shared by cutters and segments.
[[nodiscard]] Outcome check_length(const std::string& field, double value_mm);

}  // namespace gouge
