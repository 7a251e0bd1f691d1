#pragma once

#include <vector>

#include "lib/field/depth_field.h"
#include "lib/surface/surface.h"

namespace gouge {

/// Distance that the gouging moves of a path reach below the part's surface, at any point of it. Let n be the normal at
/// the point p. The distance is the largest s for which p - s n is in the tool and p is its closest point of the
/// surface. If the tool is deeper in the part than its own thickness, this distance is still correct, while the tool's
/// depth stays at its maximum.
///
/// If the overcut is unknown, the depth replaces it. This applies to surfaces that are not closed, and to places where
/// only a clearance or stock to leave is entered. It also applies to heads, which are too thick for their depth to
/// reach its maximum. Overcuts are sampled for pictures, like depths; they guarantee nothing.
class OvercutField {
 public:
  /// Prepares the field. All arguments, and the objects they point to, must outlive it.
  OvercutField(const CheckedToolpath& input, const DepthField& depths);
  ~OvercutField();
  OvercutField(const OvercutField&) = delete;
  OvercutField& operator=(const OvercutField&) = delete;

  /// Returns whether no move has an overcut; then only depths can be shown.
  [[nodiscard]] bool is_empty() const { return largest_mm_ <= 0; }

  struct Ray {
    Vec3 at = Vec3::Zero();        ///< a point of the surface
    Vec3 inward = -Vec3::UnitZ();  ///< unit direction into the part
    std::size_t mesh = 0;          ///< index of the mesh, counted through all obstacles
  };
  /// Returns, for each ball of that radius about a centre, whether any ray that begins in it may have an overcut or a
  /// depth. If not, `at` is 0 there.
  [[nodiscard]] std::vector<std::uint8_t> may_be_deep(const std::vector<Vec3>& centres, double radius_mm) const;

  /// Returns, for each ray, only the overcut in mm; 0 if the tool does not reach that far or the overcut is unknown.
  [[nodiscard]] std::vector<float> overcut_at(const std::vector<Ray>& rays) const;
  /// Returns, for each ray, the overcut or, if it is unknown, the depth in mm; 0 if nothing gouges there.
  [[nodiscard]] std::vector<float> at(const std::vector<Ray>& rays) const;

 private:
  class RayTree;
  [[nodiscard]] double margin_mm(const Surface& solid, const Ray& ray, double max_mm) const;

  class SweptPose;
  std::vector<SweptPose> swept_;        ///< poses, followed by groups of neighbours
  std::size_t roots_ = 0;               ///< number of last groups that together represent all
  std::vector<const Surface*> solids_;  ///< by mesh; null if the mesh is not queried
  std::vector<Against> obstacles_;      ///< obstacle of each mesh
  double largest_mm_ = 0, tolerance_mm_ = 0;
  double reach_mm_ = 0;  ///< maximum length of a ray
  const DepthField& depths_;
};

}  // namespace gouge
