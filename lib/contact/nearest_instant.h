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

/// To which the distance at the nearest instant is found.
inline constexpr double kInstantGap_mm = Tolerance::kCorrection_mm;

/// A cutter on a stretch of its motion, from t = 0 to 1. The tip moves on a straight line at constant speed, the axis
/// on the great circle at constant rate.
struct CutterStretch {
  Pose start, end;
  double angle_rad = 0;  ///< between the axes
  double off_mm = 0;     ///< the tip is no farther from there, where the stretch represents a curve
  const CompiledTool* cutter = nullptr;
  std::size_t move = 0;
  bool is_convex = true;  ///< the cutter
};

/// Closest approach of a cutter to some points: the signed distance of the point that is then farthest from it.
/// Method and proof: docs/method/tilting.md, "Distances over instants".
class NearestInstant {
 public:
  /// Finds the instant for one to three points at once. The stretch must outlive it.
  NearestInstant(const CutterStretch& stretch, std::span<const Vec3> points);
  /// Finds the instant for a point. The bound is the minimum distance of all points of the triangle about it, whose
  /// corners are at `corners` from there.
  NearestInstant(const CutterStretch& stretch, const Vec3& middle, const std::array<Vec3, 3>& corners);

  /// Searches until one of these holds.
  /// (1) An instant is found at which the distance is `lower_cutoff_mm` or less.
  /// (2) The distance is known to be more than `upper_cutoff_mm` at all instants.
  /// (3) The minimum is known to 0.0002 mm and what the turn leaves open.
  /// Cost: two to five distances; for a cutter that is not convex up to some thousand.
  void search(double lower_cutoff_mm, double upper_cutoff_mm);

  /// Returns a distance that is reached, or undercut, at some instant.
  [[nodiscard]] double found_mm() const { return found_mm_ + slack_mm_; }
  /// Returns a distance that is undercut at no instant.
  [[nodiscard]] double bound_mm() const { return std::min(bound_mm_, found_mm_) - slack_mm_; }

 private:
  /// A point in the cutter's frame, as across + t across_change beside the axis and z + t z_change along it.
  struct Way {
    Vec3 across, across_change;
    double z = 0, z_change = 0;
  };
  /// A value that is never below `least` + slope (t' - t) at any other instant t'.
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
  double radius_mm_ = 0;  // of the triangle
  double speed_mm_ = 0;   // no point runs farther in the cutter's frame
  double slack_mm_ = 0;
  double lower_cutoff_mm_ = 0, upper_cutoff_mm_ = 0;
  double found_mm_ = std::numeric_limits<double>::infinity(), bound_mm_ = std::numeric_limits<double>::infinity();
};

}  // namespace gouge
