#include "toolmodels/import/catalogue_cutter.h"

#include <algorithm>
#include <cmath>

#include "toolmodels/cutter_shapes.h"
#include "toolmodels/import/catalogue_special.h"

namespace gouge {
namespace {

using enum Dimension;
using detail::radians;

class CutterMaker : CatalogueMaker {
 public:
  using CatalogueMaker::CatalogueMaker;

  Result<CatalogueCutter> make(CatalogueShape shape) {
    if (Outcome good = check_signs(); !good) return good.error();
    if (Outcome good = need(diameter, "diameter"); !good) return good.error();
    const bool may_lack_flutes =
        shape == CatalogueShape::chamfer || shape == CatalogueShape::lollipop || shape == CatalogueShape::probe;
    if (!may_lack_flutes)
      if (Outcome good = need(flute_length, "flute length"); !good) return good.error();
    const Result<Cutter> made = dispatch(shape);
    if (!made) return made.error();
    const Result<Profile> profile = make_cutter_profile(*made);
    if (!profile) return profile.error();
    return CatalogueCutter{*made, 2 * profile->elements.back().a.x()};
  }

 private:
  Result<Cutter> dispatch(CatalogueShape shape) {
    if (shape == CatalogueShape::flat) return flat();
    if (shape == CatalogueShape::ball) return ball();
    if (shape == CatalogueShape::bull_nose) return bull_nose();
    if (shape == CatalogueShape::tapered) return tapered();
    if (shape == CatalogueShape::tapered_ball) return tapered_ball();
    if (shape == CatalogueShape::chamfer) return chamfer();
    if (shape == CatalogueShape::drill) return drill();
    if (shape == CatalogueShape::face) return face();
    if (shape == CatalogueShape::full) return full();
    if (shape == CatalogueShape::five_numbers) return five_numbers();
    return make_special_cutter(shape, d_, notes_);
  }

  Outcome check_signs() const {
    for (int i = 0; i < static_cast<int>(Dimension::count); ++i) {
      const auto dimension = static_cast<Dimension>(i);
      const std::optional<Given>& given = d_[dimension];
      if (!given) continue;
      const bool may_be_negative = dimension == taper_angle || dimension == bottom_angle;
      if (!std::isfinite(given->value) || (given->value < 0 && !may_be_negative))
        return make_error("import-field", d_.text(dimension) + " is not possible; it must not be negative");
    }
    return Done{};
  }

  Outcome need(Dimension dimension, const std::string& what) const {
    if (d_[dimension]) return Done{};
    return missing(what);
  }

  Cutter flat() {
    if (at(corner_radius) > kAgree_mm)
      contradiction(d_.text(corner_radius) +
                    " on a flat end mill; built with a sharp corner, which is the larger tool");
    return FlatCutter{at(diameter), at(flute_length)};
  }

  Cutter ball() {
    if (d_[corner_radius] && std::abs(at(corner_radius) - at(diameter) / 2) > kAgree_mm && at(corner_radius) > 0)
      contradiction(d_.text(corner_radius) + " is not half of " + d_.text(diameter) +
                    "; built as a ball of that diameter");
    return BallCutter{at(diameter), at(flute_length)};
  }

  Result<Cutter> bull_nose() {
    if (Outcome good = need(corner_radius, "corner radius"); !good) return good.error();
    check_tip(at(diameter) - 2 * at(corner_radius), "diameter and corner radius");
    return Cutter(BullNoseCutter{at(diameter), at(corner_radius), at(flute_length)});
  }

  // Reports a tip diameter that differs from the one that follows from the other numbers. The shape is built from those
  // alone.
  void check_tip(double expected_mm, const std::string& believed) {
    if (!d_[tip_diameter] || std::abs(at(tip_diameter) - expected_mm) <= kAgree_mm) return;
    contradiction(d_.text(tip_diameter) + " does not follow from the other numbers, which give " +
                  mm_text(std::max(expected_mm, 0.0)) + "; built from " + believed);
  }

  Outcome check_taper() const {
    if (Outcome good = need(taper_angle, "taper angle"); !good) return good;
    if (at(taper_angle) > 0 && at(taper_angle) < 90) return Done{};
    return make_error("import-field",
                      d_.text(taper_angle) + " is not possible; the angle between side and axis lies between 0 and 90");
  }

  Result<Cutter> tapered() {
    if (Outcome good = check_taper(); !good) return good.error();
    const double beta = radians(at(taper_angle)), r = at(corner_radius);
    check_tip(std::max(0.0, at(diameter) + 2 * r * (std::sin(beta) - 1) / std::cos(beta)),
              "diameter, corner radius and taper angle");
    const double top = at(diameter) + 2 * at(flute_length) * std::tan(beta);
    if (at(shoulder_diameter) > 0 && std::abs(at(shoulder_diameter) - top) > kAgree_mm)
      contradiction(d_.text(shoulder_diameter) + ", but a side leaning " + d_.text(taper_angle) + " from the axis is " +
                    mm_text(top) + " wide at the top of the flutes; built with that angle");
    if (r > 0) return Cutter(AptCutter{at(diameter), r, 0, 0, 0, at(taper_angle), at(flute_length)});
    return Cutter(TaperedCutter{at(diameter), 0, at(taper_angle), at(flute_length)});
  }

  Result<Cutter> tapered_ball() {
    if (Outcome good = check_taper(); !good) return good.error();
    const double beta = radians(at(taper_angle)), r = at(diameter) / 2;
    const double top = 2 * (r / std::cos(beta) + (at(flute_length) - r) * std::tan(beta));
    if (at(largest_diameter) > 0 && std::abs(at(largest_diameter) - top) > kAgree_mm)
      contradiction(d_.text(largest_diameter) + ", but a side leaning " + degrees_text(at(taper_angle)) +
                    " from the axis is " + mm_text(top) + " wide at the top of the flutes; built with that angle");
    return Cutter(TaperedCutter{at(diameter), r, at(taper_angle), at(flute_length)});
  }

  Result<Cutter> chamfer() {
    if (Outcome good = check_taper(); !good) return good.error();
    const double d = at(diameter), tip = at(tip_diameter), half = at(taper_angle);
    if (!(d > 0)) return make_error("import-field", d_.text(diameter) + " is not possible; it must be greater than 0");
    if (tip >= d)
      return make_error("import-field", d_.text(tip_diameter) + " is not less than " + d_.text(diameter) +
                                            "; the diameter of a chamfer mill is its largest");
    if (at(corner_radius) > kAgree_mm)
      contradiction(d_.text(corner_radius) +
                    " at the tip is left out; built with a sharp corner, which is the larger tool");
    const double cone_mm = (d - tip) / 2 / std::tan(radians(half));
    double flutes_mm = at(flute_length);
    if (flutes_mm < cone_mm - kAgree_mm) {
      const std::string cone = d_.text(diameter) + " at z = " + mm_text(cone_mm);
      if (d_[flute_length])
        contradiction(d_.text(flute_length) + " ends below the top of the cone, which reaches " + cone +
                      "; built up to there");
      else
        guess("no flute length is given; the flutes end where the cone reaches " + cone);
      flutes_mm = cone_mm;
    }
    if (flutes_mm <= cone_mm + kAgree_mm) flutes_mm = 0;
    return Cutter(ChamferCutter{d, tip, half, flutes_mm});
  }

  Result<Cutter> drill() {
    if (Outcome good = need(point_angle, "point angle"); !good) return good.error();
    const double sigma = at(point_angle);
    if (!(sigma > 0 && sigma <= 180))
      return make_error("import-field",
                        d_.text(point_angle) + " is not possible; the angle of a point lies between 0 and 180");
    return Cutter(DrillCutter{at(diameter), sigma, at(flute_length)});
  }

  Result<Cutter> face() {
    const bool is_wider = at(largest_diameter) > at(diameter) + kAgree_mm;
    if (!(at(taper_angle) > 0)) {
      if (is_wider)
        return make_error("import-field", d_.text(largest_diameter) + " is greater than " + d_.text(diameter) +
                                              ", but the file gives no angle of the edge between them");
      return at(corner_radius) > 0 ? bull_nose() : Result<Cutter>(flat());
    }
    if (is_wider)
      return Cutter(FaceMillCutter{at(diameter), at(corner_radius), at(taper_angle), at(largest_diameter), 0, 0,
                                   at(flute_length)});
    guess("no largest diameter is given; the edge is taken to lean by " + d_.text(taper_angle) +
          " up to the top of the flutes");
    return Cutter(AptCutter{at(diameter), at(corner_radius), 0, 0, 0, at(taper_angle), at(flute_length)});
  }

  Cutter full() {
    guess("taken as a full cylinder of " + d_.text(diameter) + " along its flutes, which is the larger tool");
    return FlatCutter{at(diameter), at(flute_length)};
  }

  Result<Cutter> five_numbers() {
    if (!(at(bottom_angle) > 0) && std::abs(at(taper_angle)) <= 0) {
      if (at(corner_radius) > 0) return bull_nose();
      return flat();
    }
    return Cutter(
        AptCutter{at(diameter), at(corner_radius), 0, 0, at(bottom_angle), at(taper_angle), at(flute_length)});
  }
};

}  // namespace

Result<CatalogueCutter> make_catalogue_cutter(CatalogueShape shape, const Dimensions& dimensions, Diagnostics& notes) {
  return CutterMaker(dimensions, notes).make(shape);
}

}  // namespace gouge
