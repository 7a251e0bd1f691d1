#pragma once

#include <string>

#include "lib/base/tolerance.h"
#include "toolmodels/cutter.h"

// Functions that build the contours of the shapes, by family, and the checks that they share.

namespace gouge::detail {

constexpr double kLargest_mm = 1e5;  ///< this limit keeps all later squares far from overflow
/// a dimension this close to a limit, relative to it, is at the limit
constexpr double kRelativeSlack = Tolerance::kRounding;

/// Returns "12.5 mm", rounded to digits that are useful for a reader.
[[nodiscard]] std::string mm(double value_mm);
[[nodiscard]] double radians(double degrees);
[[nodiscard]] double sine(double degrees);
/// Returns the cosine, exact at 0 and 90 degrees.
[[nodiscard]] double cosine(double degrees);

/// Checks an optional dimension: 0 or more, finite and not absurdly large.
[[nodiscard]] Outcome check_not_negative(const std::string& field, double value_mm);
/// Checks that an angle lies between two limits, both excluded.
[[nodiscard]] Outcome check_angle(const std::string& field, double value_deg, double low_deg, double high_deg);
[[nodiscard]] Outcome check_corner_radius(double radius_mm, double diameter_mm);

/// Reports that the flutes end within `what`, such as "the tip".
[[nodiscard]] Diagnostic too_short(double length_mm, const std::string& what, double at_min_mm);
/// Reports dimensions that exclude each other.
[[nodiscard]] Diagnostic contradict(const std::string& message);

/// Builds a contour from parts, each of which begins at the end of the one before; parts of length 0 are left out.
class ContourMaker {
 public:
  ContourMaker(const Vec2& start, double size_mm) : at_(start), slack_(kRelativeSlack * size_mm) {}

  void line_to(const Vec2& to);
  void arc_to(const Vec2& to, const Vec2& center, double radius_mm, bool is_concave = false);
  /// Joins the contour to the axis by a horizontal line and checks it as a whole. An error states that it is broken at
  /// `what`.
  [[nodiscard]] Result<Profile> close(const std::string& what);

 private:
  [[nodiscard]] bool is_here(const Vec2& to) const { return (to - at_).norm() <= slack_; }

  Vec2 at_;
  double slack_;
  Profile profile_;
};

/// A corner of a polygon, with the radius of its rounding.
struct RoundedCorner {
  Vec2 at = Vec2::Zero();
  double radius_mm = 0;
};

/// Returns the polygon, which begins and ends on the axis, with its corners rounded. Requires radii small enough that
/// neighbouring arcs do not overlap; the caller checks this and names the dimensions.
[[nodiscard]] Result<Profile> make_rounded(const std::vector<RoundedCorner>& corners, const std::string& what);

[[nodiscard]] Result<Profile> make_shape(const FlatCutter& cutter);
[[nodiscard]] Result<Profile> make_shape(const BallCutter& cutter);
[[nodiscard]] Result<Profile> make_shape(const BullNoseCutter& cutter);
[[nodiscard]] Result<Profile> make_shape(const TaperedCutter& cutter);
[[nodiscard]] Result<Profile> make_shape(const DovetailCutter& cutter);
[[nodiscard]] Result<Profile> make_shape(const AptCutter& cutter);
[[nodiscard]] Result<Profile> make_shape(const DrillCutter& cutter);
[[nodiscard]] Result<Profile> make_shape(const ChamferCutter& cutter);
[[nodiscard]] Result<Profile> make_shape(const TSlotCutter& cutter);
[[nodiscard]] Result<Profile> make_shape(const SlittingSawCutter& cutter);
[[nodiscard]] Result<Profile> make_shape(const FaceMillCutter& cutter);
[[nodiscard]] Result<Profile> make_shape(const RadiusCutter& cutter);
[[nodiscard]] Result<Profile> make_shape(const LollipopCutter& cutter);
[[nodiscard]] Result<Profile> make_shape(const BarrelCutter& cutter);
[[nodiscard]] Result<Profile> make_shape(const OvalCutter& cutter);
[[nodiscard]] Result<Profile> make_shape(const LensCutter& cutter);
[[nodiscard]] Result<Profile> make_shape(const ProfileCutter& cutter);

/// Returns the height at which the cone of a chamfer mill reaches its diameter, or the ball of a lollipop its neck.
[[nodiscard]] double cone_height_mm(const ChamferCutter& cutter);
[[nodiscard]] double ball_height_mm(const LollipopCutter& cutter);

}  // namespace gouge::detail
