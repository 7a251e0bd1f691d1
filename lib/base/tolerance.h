#pragma once

namespace gouge {

/// Differences up to which two numbers count as equal. Each has its derivation. Algorithms have further parameters of
/// their own. lib/verify shares nothing with the code that it verifies, so it has its own tolerances.
///
/// Notation: u = 2^-53 = 1.1e-16 is the relative rounding of a double, 2^-24 = 6.0e-8 that of a float.
struct Tolerance {
  // Rounding of doubles.

  /// Rounding of lengths, mm. Coordinates reach 1e5 mm (lib/check/reach.h), so one addition rounds by at most 1.1e-11
  /// mm. Numbers that are compared result from fewer than 50 additions.
  static constexpr double kRounding_mm = 1e-9;
  /// Distance of two points that are the same, but were computed in two ways, mm. The derivation is that of
  /// kRounding_mm; no tool, part or position has details this small.
  static constexpr double kSamePoint_mm = 1e-9;
  /// Difference of directions that count as equal: of a component of unit vectors, or of the sine of their angle.
  /// Digits of files end at 1e-7. An angle of 1e-9 rad moves a point at 1 m by 1e-6 mm, the accuracy of a witness.
  static constexpr double kSameDirection = 1e-9;
  /// Relative difference of a quantity that was computed in two ways, such as a long sum or an iteration.
  static constexpr double kRounding = 1e-9;
  /// Rounding of nested constructions (offsets, intersections, unions), relative to the size of the whole. Each
  /// construction loses at most 1e3 u / sine of the angle that it depends on. No angle is below 1e-3.
  static constexpr double kConstruction = 1e-10;
  /// Rounding of fewer than 1,000 operations, relative to their operands.
  static constexpr double kFewRoundings = 1e-12;
  /// Difference of unit vectors that are equal up to the rounding of a normalization or a rotation.
  static constexpr double kExactDirection = 1e-12;
  /// Length below which a vector is rounding and has no direction: in mm, or as the remainder of a unit vector.
  static constexpr double kNoDirection = 1e-12;
  /// Determinant of unit directions below which a solution is meaningless: 100 u.
  static constexpr double kSingular = 1e-14;

  // Rounding of floats.

  /// Twice the relative rounding of a number to a float.
  static constexpr double kSingleRounding = 1.2e-7;
  /// Rounding of sums of a dozen floats, relative to the largest.
  static constexpr double kSingleSum = 1e-6;

  // Geometry.

  /// Accuracy of witnesses, mm: docs/method/certified_sweep.md.
  static constexpr double kWitness_mm = 1e-6;
  /// Sine of the angle to an axis below which a direction is on no definite side of the axis.
  static constexpr double kNoSide = 1e-6;
  /// Sine of the turn below which two elements of an outline are tangent. Shapes are computed to 1e-9; drawings are
  /// less accurate.
  static constexpr double kTangent = 1e-7;

  // Digits of files.

  /// Difference below which two positions in files may be the same, mm: files have three decimals or more.
  static constexpr double kFilePoint_mm = 1e-3;
  /// Difference of tool axes in files, which have five decimals or more.
  static constexpr double kFileAxis = 1e-5;
  /// Maximum difference of a vector's length from 1 for a unit vector in a file.
  static constexpr double kUnitVectorError = 1e-3;
  /// Accuracy of corrections, mm: even with the errors of both ends, less than one digit of a file with three decimals.
  static constexpr double kCorrection_mm = 2e-4;
};

}  // namespace gouge
