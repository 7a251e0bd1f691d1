#pragma once

#include <vector>

#include "lib/field/depth_field.h"
#include "lib/surface/surface.h"

namespace gouge {

/// Distance of the gouging moves of a path below the part's surface, at any point of it. Let n be the normal at the
/// point p. The distance is the largest s for which p - s n is in the tool and p is its closest point of the surface.
/// Where the tool is deeper in the part than it is thick, this is still how deep it reaches; the tool's depth saturates
/// there.
///
/// Where the overcut is unknown, the depth replaces it. That is so on surfaces that are not closed, and where only a
/// clearance or stock to leave is entered. It is also so for heads, which are too thick for their depth to saturate.
/// Sampled, for pictures, as depths are; it guarantees nothing.
class OvercutField {
 public:
  /// All arguments, and what they point at, must outlive it.
  OvercutField(const CheckedToolpath& input, const DepthField& depths);
  ~OvercutField();
  OvercutField(const OvercutField&) = delete;
  OvercutField& operator=(const OvercutField&) = delete;

  /// Returns whether no move has an overcut: depths are all there is to show.
  [[nodiscard]] bool is_empty() const { return largest_mm_ <= 0; }

  struct Ray {
    Vec3 at = Vec3::Zero();        ///< on the surface
    Vec3 inward = -Vec3::UnitZ();  ///< unit
    std::size_t mesh = 0;          ///< counted through all obstacles
  };
  /// Returns for each ball of that radius about a centre whether any ray that begins in it may have an overcut or a
  /// depth. Where not, `at` is 0.
  [[nodiscard]] std::vector<std::uint8_t> may_be_deep(const std::vector<Vec3>& centres, double radius_mm) const;

  /// Returns for each ray the overcut alone, mm; 0 where the tool does not reach or the overcut is unknown.
  [[nodiscard]] std::vector<float> overcut_at(const std::vector<Ray>& rays) const;
  /// Returns for each ray the overcut, or where it is unknown the depth, mm; 0 where nothing gouges.
  [[nodiscard]] std::vector<float> at(const std::vector<Ray>& rays) const;

 private:
  class RayTree;
  [[nodiscard]] double margin_mm(const Surface& solid, const Ray& ray, double max_mm) const;

  class SweptPose;
  std::vector<SweptPose> swept_;        ///< and groups of neighbours behind them
  std::size_t roots_ = 0;               ///< so many of the last represent all
  std::vector<const Surface*> solids_;  ///< by mesh; null where there is no query
  std::vector<Against> obstacles_;      ///< by mesh
  double largest_mm_ = 0, tolerance_mm_ = 0;
  double reach_mm_ = 0;  ///< no ray is followed farther
  const DepthField& depths_;
};

}  // namespace gouge
