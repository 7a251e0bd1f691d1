#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "lib/geom/vec.h"
#include "lib/path/curve.h"
#include "postproc/cldata/language/arguments.h"
#include "postproc/cldata/language/dialect.h"

// CIRCLE, MOVARC and TLON of CATIA as arcs between two tips. Every dialect has its own sense of rotation; evidence for
// each is in docs/formats/arcs.md.

namespace gouge {

/// Reasons not to check an arc. The texts are shown to the user.
struct ArcProblems {
  static constexpr const char* kForm = "an arc statement that is not understood";
  static constexpr const char* kStart = "an arc from a position that is not known";
  static constexpr const char* kRadius = "the arc's start, end and radius do not lie on one circle";
  static constexpr const char* kPoint = "the arc's radius is 0";
  static constexpr const char* kTiny = "the arc is either next to nothing or a full circle: its numbers do not decide";
  static constexpr const char* kAngle = "the angle the arc states does not lead to its end";
  static constexpr const char* kTimes =
      "TIMES on an arc that does not end above its start: whether its part of a turn counts as one the file does not "
      "say";
  static constexpr const char* kSlope = "the arc does not rise as far as its ARCSLP states";
  static constexpr const char* kTangent = "the arc's start direction (INDIRV) does not touch its circle";
  static constexpr const char* kHalf = "the arc's length and its ON,INTOF word contradict each other";
  static constexpr const char* kXzPlane =
      "an arc in the XZ plane of Mastercam NCI: sources do not say which way round it runs";
  static constexpr const char* kBothSenses = "the arc is said to run clockwise and counter-clockwise";
  static constexpr const char* kSense = "nothing in the file states which way round its arcs run";
};

/// Content of an arc statement, in mm and in the frame of its numbers.
struct ArcStatement {
  Vec3 center = Vec3::Zero();
  Vec3 axis = Vec3::UnitZ();  ///< of unit length
  std::optional<double> radius_mm;
  std::optional<double> sweep_rad;  ///< the stated sweep, without sign
  int turns = 1;                    ///< number of turns in TIMES
  double rounding_mm = 0;           ///< maximum error of its numbers and of those of its ends
  ArcSense sense = ArcSense::unknown;
  std::string_view problem;  ///< one of ArcProblems: then the other members have no meaning; empty: none
};

/// Returns an arc of which only `problem` is known.
[[nodiscard]] ArcStatement unreadable_arc(std::string_view problem);

/// Reads CIRCLE/ or MOVARC/ in the sense of `dialect`.
[[nodiscard]] ArcStatement read_arc(const Dialect& dialect, std::span<const Argument> arguments, double mm_per_unit);

/// A TLON of CATIA: TLON,GOFWD/(CIRCLE/center,r),ON[,2,INTOF],(LINE/center,end). The circle lies in the plane of
/// `tangent` (INDIRV) and the direction from the centre to `start`. It leaves the start along `tangent`.
struct TlonStatement {
  Vec3 center = Vec3::Zero(), end = Vec3::Zero();
  double radius_mm = 0;
  double rounding_mm = 0;       ///< maximum error of each number
  bool is_beyond_half = false;  ///< ON,2,INTOF: the second crossing of the line
};

/// Returns whether circle and line are given by numbers, beside any words. Then the statement is not from a part
/// program.
[[nodiscard]] bool is_tlon_of_numbers(std::span<const Argument> arguments);

/// Reads a TLON; returns nothing for any other form.
[[nodiscard]] std::optional<TlonStatement> read_tlon(std::span<const Argument> arguments, double mm_per_unit);

[[nodiscard]] ArcStatement arc_of_tlon(const TlonStatement& tlon, const Vec3& start,
                                       const std::optional<Vec3>& tangent);

/// The arc of a statement between two tips, or the reason why there is none.
struct ArcFit {
  PathArc arc;
  std::string_view problem;    ///< one of ArcProblems; empty: none
  double radius_error_mm = 0;  ///< disagreement of start, end and the stated radius
};

/// Fits the arc of a statement between two tips.
/// Ensures  The sweep ends at `end` exactly; start = end is a full circle.
/// Errors   Each is a `problem`. (1) kForm and similar ones from the statement. (2) kRadius: the distances of start and
///          end from the axis differ by more than 0.008 mm. Or the stated radius differs from one of them by more than
///          twice that difference, and by more than six times the rounding of the numbers. This rounding error is taken
///          as at least 0.001 mm and at most 0.008 mm. (3) kPoint, kTiny, kAngle, kTimes, and kSense if the sense is
///          unknown.
[[nodiscard]] ArcFit fit_arc(const ArcStatement& statement, const Vec3& start, const Vec3& end);

/// Returns whether the arc fits between both tips with either sense, so that only the sense decides. That is so for a
/// stated half turn, for a whole turn of a helix, and for any arc without a stated sweep.
[[nodiscard]] bool fits_both_ways(ArcStatement statement, const Vec3& start, const Vec3& end);

/// Returns the unit direction in which a right-handed arc passes `tip`.
[[nodiscard]] Vec3 arc_tangent(const ArcStatement& statement, const Vec3& tip);

}  // namespace gouge
