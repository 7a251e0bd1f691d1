#pragma once

namespace gouge {

/// Differences up to which numbers mean the same. Each has its derivation; algorithms have parameters of their own
/// beside them. lib/verify, which shares nothing with what it verifies, has its own.
///
/// Notation: u = 2^-53 = 1.1e-16 is the relative rounding of a double, 2^-24 = 6.0e-8 that of a float.
struct Tolerance {
  // Rounding of doubles.

  /// For lengths, mm. Coordinates reach 1e5 mm (lib/check/reach.h), so one addition rounds by 1.1e-11 mm at most.
  /// Numbers that are compared result from fewer than 50 additions.
  static constexpr double kRounding_mm = 1e-9;
  /// Points that were computed in two ways are one, mm. As above; no tool, part or position has details this small.
  static constexpr double kSamePoint_mm = 1e-9;
  /// Directions are one: of a component of unit vectors, or of the sine of the angle between them. Digits of files end
  /// at 1e-7; 1e-9 rad moves a point 1 m away by 1e-6 mm, which is what a witness is exact to.
  static constexpr double kSameDirection = 1e-9;
  /// For a quantity computed in two ways, relative to it, as a long sum or by an iteration.
  static constexpr double kRounding = 1e-9;
  /// For nested constructions (offsets, intersections, unions), relative to the size of the whole. Each construction
  /// loses at most 1e3 u / sine of the angle that it depends on. No angle is below 1e-3.
  static constexpr double kConstruction = 1e-10;
  /// For fewer than 1,000 operations, relative to their operands.
  static constexpr double kFewRoundings = 1e-12;
  /// Unit vectors are the same but for the rounding of a normalization or a rotation.
  static constexpr double kExactDirection = 1e-12;
  /// A vector that is shorter, in mm or as a unit vector's remainder, is rounding and has no direction.
  static constexpr double kNoDirection = 1e-12;
  /// A determinant of unit directions that is less has no solution worth the name: 100 u.
  static constexpr double kSingular = 1e-14;

  // Rounding of floats.

  /// Twice what a float rounds a number by, relative to it.
  static constexpr double kSingleRounding = 1.2e-7;
  /// For sums of a dozen floats, relative to the largest.
  static constexpr double kSingleSum = 1e-6;

  // Geometry.

  /// Witnesses are exact to this, mm: docs/method/certified_sweep.md.
  static constexpr double kWitness_mm = 1e-6;
  /// A direction that leads away from an axis by a smaller sine has no side of it worth keeping.
  static constexpr double kNoSide = 1e-6;
  /// Elements of an outline that turn by a smaller sine are tangent. Shapes are computed to 1e-9; drawings are not.
  static constexpr double kTangent = 1e-7;

  // Digits of files.

  /// Positions in files have three decimals or more, mm: two of them that differ by less may be one.
  static constexpr double kFilePoint_mm = 1e-3;
  /// Tool axes in files have five decimals or more.
  static constexpr double kFileAxis = 1e-5;
  /// A vector in a file that is longer or shorter than 1 by more is not a unit vector.
  static constexpr double kUnitVectorError = 1e-3;
  /// Corrections are computed to this, mm: less than one digit of a file with three decimals, in both its ends.
  static constexpr double kCorrection_mm = 2e-4;
};

}  // namespace gouge
