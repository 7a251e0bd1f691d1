#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <span>

#include "lib/base/tolerance.h"
#include "lib/geom/pose.h"
#include "lib/tool/compiled_tool.h"

namespace gouge {

/// Accuracy of the distance at the nearest instant.
inline constexpr double kInstantGap_mm = Tolerance::kCorrection_mm;

/// A cutter on a stretch of its motion, from t = 0 to 1. The tip moves on a straight line at constant speed, and the
/// axis on the great circle at constant rate.
struct CutterStretch {
  Pose start, end;
  double angle_rad = 0;  ///< angle between the axes
  double off_mm = 0;     ///< maximum deviation of the tip from the straight line, if the stretch represents a curve
  const CompiledTool* cutter = nullptr;
  std::size_t move = 0;
  bool is_convex = true;  ///< whether the cutter is convex
};

/// Closest approach of a cutter to some points: the signed distance of the point that is farthest from it at that
/// instant.
/// Method and proof: docs/method/tilting.md, "Distances over instants".
class NearestInstant {
 public:
  /// Prepares the search for one to three points together. The stretch must outlive the object.
  NearestInstant(const CutterStretch& stretch, std::span<const Vec3> points);
  /// Prepares the search for one point. The bound is the minimum distance of all points of the triangle around it;
  /// `corners` are the triangle's corners relative to the point.
  NearestInstant(const CutterStretch& stretch, const Vec3& middle, const std::array<Vec3, 3>& corners);

  /// Searches until one of these conditions holds.
  /// (1) An instant is found at which the distance is `lower_cutoff_mm` or less.
  /// (2) The distance is known to be more than `upper_cutoff_mm` at all instants.
  /// (3) The minimum is known to 0.0002 mm, plus the uncertainty of the turn.
  /// Cost: two to five distances; for a cutter that is not convex up to some thousand.
  void search(double lower_cutoff_mm, double upper_cutoff_mm);

  /// Returns an upper bound of the minimum: the distance is that or less at some instant.
  [[nodiscard]] double found_mm() const { return found_mm_ + slack_mm_; }
  /// Returns a lower bound of the distance at all instants.
  [[nodiscard]] double bound_mm() const { return std::min(bound_mm_, found_mm_) - slack_mm_; }

 private:
  /// A point in the cutter's frame: across + t across_change beside the axis, and z + t z_change along it.
  struct Way {
    Vec3 across, across_change;
    double z = 0, z_change = 0;
  };
  /// A value at instant t. At any other instant t' the value is at least `least` + slope (t' - t).
  struct Look {
    double t = 0, value = 0, least = 0, slope = 0;
  };

  void add(const Vec3& point);
  [[nodiscard]] Look look(double t);
  [[nodiscard]] bool is_settled(double under_mm, double min_mm) const;
  void search_convex();
  void halve(const Look& first, const Look& last, int level);

  const CutterStretch& stretch_;
  std::array<Way, 3> ways_;
  std::size_t count_ = 0;
  const std::array<Vec3, 3>* corners_ = nullptr;
  double radius_mm_ = 0;  // radius of the triangle
  double speed_mm_ = 0;   // maximum speed of a point in the cutter's frame
  double slack_mm_ = 0;
  double lower_cutoff_mm_ = 0, upper_cutoff_mm_ = 0;
  double found_mm_ = std::numeric_limits<double>::infinity(), bound_mm_ = std::numeric_limits<double>::infinity();
};

}  // namespace gouge
