#include "toolmodels/import/catalogue_special.h"

#include <algorithm>
#include <cmath>

#include "toolmodels/cutter_shapes.h"

namespace gouge {
namespace {

using enum Dimension;
using detail::radians;
using SegmentShape = ProfilePoint::SegmentShape;

class SpecialMaker : CatalogueMaker {
 public:
  using CatalogueMaker::CatalogueMaker;

  Result<Cutter> make(CatalogueShape shape) {
    if (shape == CatalogueShape::slot) return slot();
    if (shape == CatalogueShape::saw) return saw();
    if (shape == CatalogueShape::dovetail) return dovetail();
    if (shape == CatalogueShape::lollipop || shape == CatalogueShape::probe) return lollipop();
    if (shape == CatalogueShape::radius) return radius();
    if (shape == CatalogueShape::center_drill) return center_drill();
    if (shape == CatalogueShape::barrel) return barrel();
    if (shape == CatalogueShape::oval) return oval();
    if (shape == CatalogueShape::lens) return lens();
    return taper_segment();
  }

 private:
  Outcome need(std::initializer_list<std::pair<Dimension, const char*>> dimensions) const {
    for (const auto& [dimension, what] : dimensions)
      if (!(at(dimension) > 0)) return missing(what);
    return Done{};
  }

  // Returns the radius of the corner at the tip, which has two names in catalogues.
  [[nodiscard]] double lower_corner() const { return at(lower_radius) > 0 ? at(lower_radius) : at(corner_radius); }

  void check_neck(double expected_mm, const std::string& follows_from) {
    if (!(at(shoulder_diameter) > 0) || std::abs(at(shoulder_diameter) - expected_mm) <= kAgree_mm) return;
    contradiction(d_.text(shoulder_diameter) + ", but " + follows_from + " give " + mm_text(expected_mm) +
                  " at the top of the flutes; built from these");
  }

  Result<Cutter> slot() {
    if (Outcome good = need({{flute_length, "cutting width"}}); !good) return good.error();
    return Cutter(TSlotCutter{at(diameter), lower_corner(), at(upper_radius), at(flute_length)});
  }

  Result<Cutter> saw() {
    if (Outcome good = need({{flute_length, "blade thickness"}}); !good) return good.error();
    if (at(cap_height) > 0)
      guess("the cap of " + d_.text(cap_diameter) + " is taken to be below the blade, the tip at its bottom");
    return Cutter(SlittingSawCutter{at(diameter), at(flute_length), at(cap_diameter), at(cap_height)});
  }

  // Builds a dovetail cutter; the diameter is that of the bottom. If the file gives the whole angle instead of half of
  // it, the neck does not agree.
  Result<Cutter> dovetail() {
    if (Outcome good = need({{flute_length, "flute length"}, {taper_angle, "taper angle"}}); !good) return good.error();
    check_neck(at(diameter) - 2 * at(flute_length) * std::tan(radians(at(taper_angle))),
               d_.text(diameter) + ", " + d_.text(flute_length) + " and a side leaning inward by " +
                   degrees_text(at(taper_angle)));
    return Cutter(DovetailCutter{at(diameter), at(corner_radius), at(taper_angle), at(flute_length)});
  }

  Result<Cutter> lollipop() {
    const double r = at(diameter) / 2, flutes = at(flute_length);
    if (at(corner_radius) > 0 && std::abs(at(corner_radius) - r) > kAgree_mm)
      contradiction(d_.text(corner_radius) + " is not half of " + d_.text(diameter) +
                    "; built as a ball of that diameter");
    if (flutes > r && flutes < 2 * r) return Cutter(LollipopCutter{at(diameter), 0, flutes});
    const Dimension neck = at(shoulder_diameter) > 0 ? shoulder_diameter : shank_diameter;
    if (Outcome good = need({{neck, "neck diameter"}}); !good) return good.error();
    if (flutes > 0)
      guess(d_.text(flute_length) +
            " does not end within the upper half of the ball; the ball is taken to end at the neck, " + d_.text(neck));
    return Cutter(LollipopCutter{at(diameter), at(neck), 0});
  }

  // Builds a cutter that rounds an edge; the diameter is that of the small end.
  Result<Cutter> radius() {
    if (Outcome good = need({{flute_length, "flute length"}, {corner_radius, "radius"}}); !good) return good.error();
    check_neck(at(diameter) + 2 * at(corner_radius), d_.text(diameter) + " and " + d_.text(corner_radius));
    return Cutter(RadiusCutter{at(diameter), at(tip_length), at(corner_radius), 0, at(flute_length)});
  }

  // Builds the pilot with its point, then a cone of the included angle up to the body.
  Result<Cutter> center_drill() {
    if (Outcome good = need({{flute_length, "flute length"},
                             {point_angle, "point angle"},
                             {tip_diameter, "tip diameter"},
                             {tip_length, "tip length"},
                             {taper_angle, "angle of the cone"}});
        !good)
      return good.error();
    const double pilot = at(tip_diameter) / 2, r = at(diameter) / 2;
    guess(d_.text(taper_angle) + " is taken as the included angle of the cone above the pilot");
    const double point = pilot / std::tan(radians(at(point_angle) / 2));
    const double cone = at(tip_length) + (r - pilot) / std::tan(radians(at(taper_angle) / 2));
    return Cutter(ProfileCutter{{{SegmentShape::straight, 0, 0, 0},
                                 {SegmentShape::straight, pilot, point, 0},
                                 {SegmentShape::straight, pilot, at(tip_length), 0},
                                 {SegmentShape::straight, r, cone, 0},
                                 {SegmentShape::straight, r, std::max(at(flute_length), cone), 0}}});
  }

  Result<Cutter> barrel() {
    if (Outcome good = need(
            {{flute_length, "flute length"}, {profile_radius, "profile radius"}, {axial_distance, "axial distance"}});
        !good)
      return good.error();
    if (at(upper_radius) > 0)
      guess(d_.text(upper_radius) +
            " at the top of the flank is left out; built with a sharp corner, which is the larger tool");
    return Cutter(
        BarrelCutter{at(diameter), at(profile_radius), lower_corner(), 0, at(axial_distance), at(flute_length)});
  }

  // Builds an oval. Some files leave the radius of the tip out. It then follows from the flute length, as the flutes
  // end where the flank touches the cylinder.
  Result<Cutter> oval() {
    if (Outcome good = need({{flute_length, "flute length"}, {profile_radius, "profile radius"}}); !good)
      return good.error();
    double r = lower_corner();
    if (!(r > 0)) {
      const double big = at(profile_radius), inset = big - at(diameter) / 2, l = at(flute_length);
      r = (big * big - inset * inset - l * l) / (2 * (big - l));
      if (!(big > l && r > 0 && r <= at(diameter) / 2))
        return make_error("import-field", "the file gives no radius of the tip, and none follows from " +
                                              d_.text(profile_radius) + ", " + d_.text(diameter) + " and " +
                                              d_.text(flute_length));
      guess("no radius of the tip is given; taken as " + mm_text(r) + ", with which the flank ends at " +
            d_.text(flute_length));
    }
    return Cutter(OvalCutter{at(diameter), r, at(profile_radius), at(flute_length)});
  }

  Result<Cutter> lens() {
    if (Outcome good = need({{flute_length, "flute length"}, {profile_radius, "profile radius"}}); !good)
      return good.error();
    double corner = lower_corner();
    const double from_tip = (at(diameter) - at(tip_diameter)) / 2;
    if (corner > at(diameter) / 2 && at(tip_diameter) > 0 && from_tip > 0) {
      contradiction("corner radius " + mm_text(corner) + " is larger than half of " + d_.text(diameter) +
                    "; built with " + mm_text(from_tip) + ", which follows from " + d_.text(tip_diameter));
      corner = from_tip;
    }
    return Cutter(LensCutter{at(diameter), at(profile_radius), corner, at(flute_length)});
  }

  // Builds a tapered segment cutter. The arcs of the tip and of the upper end lie where a straight flank of the taper
  // angle would touch them. The arc of the flank touches both.
  Result<Cutter> taper_segment() {
    if (Outcome good =
            need({{flute_length, "flute length"}, {profile_radius, "profile radius"}, {taper_angle, "taper angle"}});
        !good)
      return good.error();
    const double r1 = lower_corner(), r2 = at(upper_radius), big = at(profile_radius);
    const double sine = std::sin(radians(at(taper_angle))), cosine = std::cos(radians(at(taper_angle)));
    const Vec2 c1(at(tip_diameter) / 2, r1);
    const double x2 = at(diameter) / 2 - r2;
    const Vec2 c2(x2, ((x2 - c1.x()) * cosine + r2 - r1 * (1 - sine)) / sine);
    const Vec2 between = c2 - c1;
    const double distance = between.norm(), p = big - r1, q = big - r2;
    const double along = 0.5 * (distance + (p - q) * (p + q) / distance), away2 = (p - along) * (p + along);
    if (!(p > 0 && q > 0 && away2 > 0 && c2.y() > c1.y()))
      return make_error("import-field",
                        "no flank of " + d_.text(profile_radius) +
                            " touches the tip and the upper end; check it against the other dimensions");
    const Vec2 u = between / distance;
    const Vec2 center = c1 + along * u + std::sqrt(away2) * Vec2(-u.y(), u.x());
    const Vec2 t1 = center + big / p * (c1 - center), t2 = center + big / q * (c2 - center);
    const double top = std::max(at(flute_length), c2.y());
    if (at(flute_length) < c2.y() - 0.01)
      contradiction(d_.text(flute_length) + " ends below the upper end of the flank at " + mm_text(c2.y()) +
                    "; built up to there");
    guess("the flank is taken to touch tip and upper end as a straight one leaning " + d_.text(taper_angle) + " would");
    ProfileCutter made{{{SegmentShape::straight, 0, 0, 0}}};
    if (c1.x() > 0) made.points.push_back({SegmentShape::straight, c1.x(), 0, 0});
    if (r1 > 0) made.points.push_back({SegmentShape::convex, t1.x(), t1.y(), r1});
    made.points.push_back({SegmentShape::convex, t2.x(), t2.y(), big});
    if (r2 > 0) made.points.push_back({SegmentShape::convex, at(diameter) / 2, c2.y(), r2});
    made.points.push_back({SegmentShape::straight, at(diameter) / 2, top, 0});
    return Cutter(made);
  }
};

}  // namespace

Result<Cutter> make_special_cutter(CatalogueShape shape, const Dimensions& dimensions, Diagnostics& notes) {
  return SpecialMaker(dimensions, notes).make(shape);
}

}  // namespace gouge
