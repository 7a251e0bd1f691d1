#pragma once

#include <optional>

#include "toolmodels/cutter.h"

// The dimensions of every shape, with their names in the library file. The reader, the writer and the descriptions use
// this one list.

namespace gouge::detail {

enum class FieldKind { length, angle };

/// A field of a shape. `otherwise` is its value if the file leaves it out; empty: the field is required.
struct CutterField {
  const char* key;
  FieldKind kind;
  double* value;
  std::optional<double> otherwise;
};

template <class Visit>
void visit_fields(Cutter& cutter, const Visit& visit) {
  using enum FieldKind;
  const auto needed = [&](const char* key, double& value, FieldKind kind = length) {
    visit(CutterField{key, kind, &value, std::nullopt});
  };
  const auto optional = [&](const char* key, double& value, FieldKind kind = length) {
    visit(CutterField{key, kind, &value, 0.0});
  };
  struct Visitor {
    const decltype(needed)& need;
    const decltype(optional)& may;
    void operator()(FlatCutter& c) const { need("diameter", c.diameter_mm), need("length", c.length_mm); }
    void operator()(BallCutter& c) const { need("diameter", c.diameter_mm), need("length", c.length_mm); }
    void operator()(BullNoseCutter& c) const {
      need("diameter", c.diameter_mm), need("corner_radius", c.corner_radius_mm), need("length", c.length_mm);
    }
    void operator()(TaperedCutter& c) const {
      need("diameter", c.diameter_mm), need("corner_radius", c.corner_radius_mm);
      need("taper_angle", c.taper_angle_deg, angle), need("length", c.length_mm);
    }
    void operator()(AptCutter& c) const {
      need("d", c.d_mm), may("r", c.r_mm), may("e", c.e_mm), may("f", c.f_mm);
      may("alpha", c.alpha_deg, angle), may("beta", c.beta_deg, angle), need("h", c.h_mm);
    }
    void operator()(DrillCutter& c) const {
      need("diameter", c.diameter_mm), need("point_angle", c.point_angle_deg, angle);
      need("length", c.length_mm);
    }
    void operator()(ChamferCutter& c) const {
      need("diameter", c.diameter_mm), may("tip_diameter", c.tip_diameter_mm);
      need("taper_angle", c.taper_angle_deg, angle), may("length", c.length_mm);
    }
    void operator()(LollipopCutter& c) const {
      need("diameter", c.diameter_mm), may("neck_diameter", c.neck_diameter_mm), may("length", c.length_mm);
    }
    void operator()(TSlotCutter& c) const {
      need("diameter", c.diameter_mm), may("corner_radius", c.corner_radius_mm);
      may("upper_radius", c.upper_radius_mm), need("length", c.length_mm);
    }
    void operator()(SlittingSawCutter& c) const {
      need("diameter", c.diameter_mm), need("thickness", c.thickness_mm);
      may("cap_diameter", c.cap_diameter_mm), may("cap_height", c.cap_height_mm);
    }
    void operator()(DovetailCutter& c) const {
      need("diameter", c.diameter_mm), may("corner_radius", c.corner_radius_mm);
      need("taper_angle", c.taper_angle_deg, angle), need("length", c.length_mm);
    }
    void operator()(BarrelCutter& c) const {
      need("diameter", c.diameter_mm), need("profile_radius", c.profile_radius_mm);
      may("corner_radius", c.corner_radius_mm), may("taper_angle", c.taper_angle_deg, angle);
      need("axial_distance", c.axial_distance_mm), need("length", c.length_mm);
    }
    void operator()(OvalCutter& c) const {
      need("diameter", c.diameter_mm), need("corner_radius", c.corner_radius_mm);
      need("profile_radius", c.profile_radius_mm), need("length", c.length_mm);
    }
    void operator()(LensCutter& c) const {
      need("diameter", c.diameter_mm), need("profile_radius", c.profile_radius_mm);
      may("corner_radius", c.corner_radius_mm), need("length", c.length_mm);
    }
    void operator()(FaceMillCutter& c) const {
      need("diameter", c.diameter_mm), may("corner_radius", c.corner_radius_mm);
      may("taper_angle", c.taper_angle_deg, angle), may("largest_diameter", c.largest_diameter_mm);
      may("recess_diameter", c.recess_diameter_mm), may("recess_depth", c.recess_depth_mm);
      need("length", c.length_mm);
    }
    void operator()(RadiusCutter& c) const {
      need("tip_diameter", c.tip_diameter_mm), may("tip_length", c.tip_length_mm);
      need("profile_radius", c.profile_radius_mm), may("diameter", c.diameter_mm);
      need("length", c.length_mm);
    }
    void operator()(ProfileCutter&) const {}
  };
  std::visit(Visitor{needed, optional}, cutter);
}

}  // namespace gouge::detail
