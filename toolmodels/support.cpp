#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "lib/base/tolerance.h"
#include "lib/geom/vec.h"
#include "toolmodels/bsp.h"
#include "toolmodels/elements.h"
#include "toolmodels/trace_regions.h"

namespace gouge {
namespace {

constexpr double kEndless = 1e300;
constexpr std::size_t kMaxOfAnyContour = 1000;  // maximum number of elements for a test of every pair
constexpr int kHalvings = 40;                   // of an element, to find where it comes before a plane
constexpr double kNearlyHorizontal = 1e-6;      // |n| along r below which a foot may be bounded by a horizontal plane

// The tangent planes of one element. Each has a normal between n0 and n1 and touches the circle about `center` (radius
// 0 for a vertex or a segment). For a segment both normals are equal.
struct Planes {
  Vec2 n0, n1, center;
  double radius_mm;

  // Returns the largest height of p above any of the planes; convex in p.
  [[nodiscard]] double reach(const Vec2& p) const {
    const Vec2 away = p - center;
    const bool is_between = cross(n0, away) > 0 && cross(away, n1) > 0;
    return (is_between ? away.norm() : std::max(n0.dot(away), n1.dot(away))) - radius_mm;
  }
};

class Support {
 public:
  Support(const Profile& profile, std::vector<BoundaryElement>& elements)
      : elements_(elements),
        slack_(Tolerance::kFewRoundings * size_of(profile)),
        stretches_(make_contour_tree(elements)) {
    if (elements.size() <= kMaxBspElements) stretches_.assign(1, {0, static_cast<std::uint32_t>(elements.size())});
  }

  void set_all() {
    for (std::size_t i = 0; i < elements_.size(); ++i)
      if (!elements_[i].is_reflex) elements_[i].support = range(i);
  }

  /// Tests every pair of elements. For a contour that turns back in height.
  void set_all_of_any_contour() {
    for (std::size_t i = 0; i < elements_.size(); ++i)
      if (!elements_[i].is_reflex) elements_[i].support = range_of_any_contour(i);
  }

 private:
  struct Heights {
    double low, high;
  };
  Planes planes(std::size_t i) const {
    const BoundaryElement& e = elements_[i];
    if (e.kind == ElementKind::segment) return {e.normal, e.normal, e.a, 0};
    if (e.kind == ElementKind::arc)
      return {(e.a - e.center).normalized(), (e.b - e.center).normalized(), e.center, e.radius_mm};
    const Vec2 n0 = i > 0 ? normal_at(elements_[i - 1], elements_[i - 1].b) : Vec2(0, -1);
    const Vec2 n1 = i + 1 < elements_.size() ? normal_at(elements_[i + 1], elements_[i + 1].a) : Vec2(0, 1);
    return {n0, n1, e.a, 0};
  }

  // Returns whether the whole element stays behind every one of the planes.
  bool is_behind(const BoundaryElement& e, const Planes& planes) const {
    if (e.kind == ElementKind::arc && !e.is_reflex)
      return planes.reach(e.center) + e.radius_mm <= slack_ ||
             (is_flatter(e, planes) && planes.reach(e.a) <= slack_ && planes.reach(e.b) <= slack_);
    return planes.reach(e.a) <= slack_ && planes.reach(e.b) <= slack_;
  }

  // Returns whether no normal of the arc is among those of the planes. Such an arc has its largest height at one of its
  // ends.
  static bool is_flatter(const BoundaryElement& arc, const Planes& planes) {
    const Vec2 u = arc.a - arc.center;
    const Vec2 v = arc.b - arc.center;
    return cross(planes.n1, u) >= 0 || cross(v, planes.n0) >= 0;
  }

  // Tests the corners of the box: the height above a plane is convex, so it is largest at a corner.
  bool is_all_behind(const ContourStretch& s, const Planes& planes) const {
    const Vec2 left(-s.along.y(), s.along.x());
    for (const double u : {s.low.x(), s.high.x()})
      for (const double v : {s.low.y(), s.high.y()})
        if (!(planes.reach(s.origin + u * s.along + v * left) <= slack_)) return false;
    return true;
  }

  [[nodiscard]] bool is_passed_over(const ContourStretch& s, const Planes& planes) const {
    return stretches_.size() > 1 && is_all_behind(s, planes);
  }

  // Returns the last element before number `end`, or the first from number `begin` on, that is not behind the planes.
  std::optional<std::size_t> last_ahead(std::size_t stretch, std::size_t end, const Planes& planes) const {
    const ContourStretch& s = stretches_[stretch];
    if (s.first >= end || is_passed_over(s, planes)) return std::nullopt;
    if (s.second == 0) {
      for (std::size_t j = std::min<std::size_t>(s.last, end); j-- > s.first;)
        if (!is_behind(elements_[j], planes)) return j;
      return std::nullopt;
    }
    const auto later = last_ahead(s.second, end, planes);
    return later ? later : last_ahead(stretch + 1, end, planes);
  }
  std::optional<std::size_t> first_ahead(std::size_t stretch, std::size_t begin, const Planes& planes) const {
    const ContourStretch& s = stretches_[stretch];
    if (s.last <= begin || is_passed_over(s, planes)) return std::nullopt;
    if (s.second == 0) {
      for (std::size_t j = std::max<std::size_t>(s.first, begin); j < s.last; ++j)
        if (!is_behind(elements_[j], planes)) return j;
      return std::nullopt;
    }
    const auto earlier = first_ahead(stretch + 1, begin, planes);
    return earlier ? earlier : first_ahead(s.second, begin, planes);
  }

  enum class End { a, b };

  // Returns the height up to which an element stays behind the planes, starting from the end `from`. If the element
  // comes before them at once, that is the height of this end. The search halves the element. Its result is proved, but
  // may not be the largest.
  double behind_until(const BoundaryElement& e, const Planes& planes, End from) const {
    BoundaryElement part = e;
    const Vec2& start = from == End::a ? part.a : part.b;
    Vec2& end = from == End::a ? part.b : part.a;
    double behind = 0, ahead = 1;
    for (int k = 0; k < kHalvings; ++k) {
      const double middle = 0.5 * (behind + ahead);
      end = point_at(e, from == End::a ? middle : 1 - middle);
      (is_behind(part, planes) ? behind : ahead) = middle;
    }
    return behind > 0 ? point_at(e, from == End::a ? behind : 1 - behind).y() : start.y();
  }

  // Returns the point at a share of the way from a to b. On an arc, which is less than half a circle, the share is that
  // of the angle.
  static Vec2 point_at(const BoundaryElement& e, double share) {
    if (e.kind != ElementKind::arc) return e.a + share * (e.b - e.a);
    const Vec2 u = e.a - e.center, v = e.b - e.center;
    const double angle = share * std::atan2(cross(u, v), u.dot(v));
    return e.center + Eigen::Rotation2Dd(angle) * u;
  }

  SupportRange range(std::size_t i) const {
    const Planes own = planes(i);
    if (own.n0.x() < Tolerance::kSameDirection && own.n1.x() < Tolerance::kSameDirection && own.n0.dot(own.n1) > 0)
      return own.n0.y() < 0 ? below_step(i) : above_step(i);
    SupportRange claim{-kEndless, kEndless, 0};
    if (const auto j = last_ahead(0, i, own)) claim.z_lo_mm = behind_until(elements_[*j], own, End::b);
    if (const auto j = first_ahead(0, i + 1, own)) claim.z_hi_mm = behind_until(elements_[*j], own, End::a);
    if (own.n0.x() < kNearlyHorizontal && own.n0.y() < 0) claim.r_min_mm = radius_below(i);
    if (own.n1.x() < kNearlyHorizontal && own.n1.y() > 0) claim.r_min_mm = std::max(claim.r_min_mm, radius_above(i));
    return claim;
  }

  // Returns the planes if at least one of their normals does not point to the axis; else nothing.
  static std::optional<Planes> outward(Planes planes) {
    if (planes.n0.x() < 0 && planes.n1.x() < 0) return std::nullopt;
    if (planes.n0.x() < 0) planes.n0 = Vec2(0, -1);
    if (planes.n1.x() < 0) planes.n1 = Vec2(0, 1);
    return planes;
  }

  // Returns a triangle about an arc: its ends, and the point where the tangents there meet. For other elements it is
  // the two ends.
  static std::array<Vec2, 3> corners_about(const BoundaryElement& e) {
    if (e.kind != ElementKind::arc) return {e.a, e.b, e.b};
    const Vec2 middle = 0.5 * (e.a + e.b) - e.center;
    return {e.a, e.b, Vec2(e.center + e.radius_mm * e.radius_mm / middle.squaredNorm() * middle)};
  }

  // Returns the range of heights. An arc reaches beyond the heights of its ends only if it contains a pole.
  static Heights heights_of(const BoundaryElement& e) {
    const bool has_pole = e.kind == ElementKind::arc && (e.a.x() < e.center.x()) != (e.b.x() < e.center.x());
    const bool is_low = has_pole && 0.5 * (e.a + e.b).y() < e.center.y();
    const double low = std::min(e.a.y(), e.b.y()), high = std::max(e.a.y(), e.b.y());
    return {is_low ? e.center.y() - e.radius_mm : low, has_pole && !is_low ? e.center.y() + e.radius_mm : high};
  }

  // No point of a solid is farther from the axis than all points of its contour at the same height. So it suffices that
  // all of the contour at the heights of the range is behind the planes.
  SupportRange range_of_any_contour(std::size_t i) const {
    const std::optional<Planes> own = outward(planes(i));
    if (!own) return {};
    const double begin = (own->center + own->radius_mm * own->n0).y(),
                 end = (own->center + own->radius_mm * own->n1).y();
    const bool is_segment = elements_[i].kind == ElementKind::segment;
    const Heights at = is_segment ? heights_of(elements_[i]) : Heights{std::min(begin, end), std::max(begin, end)};
    SupportRange claim{-kEndless, kEndless, 0};
    for (std::size_t j = 0; j < elements_.size(); ++j) {
      const BoundaryElement& e = elements_[j];
      if (j == i || (e.is_reflex ? is_triangle_behind(e, *own) : is_behind(e, *own))) continue;
      const Heights ahead = heights_of(e);
      if (ahead.high <= at.low + slack_) {
        claim.z_lo_mm = std::max(claim.z_lo_mm, ahead.high);
      } else if (ahead.low >= at.high - slack_) {
        claim.z_hi_mm = std::min(claim.z_hi_mm, ahead.low);
      } else {
        return {};
      }
    }
    if (own->n0.x() < kNearlyHorizontal && own->n0.y() < 0) claim.r_min_mm = widest_beside(i, at.low, -1);
    if (own->n1.x() < kNearlyHorizontal && own->n1.y() > 0)
      claim.r_min_mm = std::max(claim.r_min_mm, widest_beside(i, at.high, 1));
    return claim;
  }

  bool is_triangle_behind(const BoundaryElement& e, const Planes& planes) const {
    const std::array<Vec2, 3> corners = corners_about(e);
    return std::ranges::all_of(corners, [&](const Vec2& p) { return planes.reach(p) <= slack_; });
  }

  // Returns an upper bound of the radius of the contour without element i, just above a height or just below it.
  double widest_beside(std::size_t i, double z, int up) const {
    double widest = 0;
    for (std::size_t j = 0; j < elements_.size(); ++j) {
      if (j == i) continue;
      const BoundaryElement& e = elements_[j];
      const Heights of = heights_of(e);
      const bool is_beside =
          up > 0 ? of.low <= z + slack_ && of.high > z + slack_ : of.high >= z - slack_ && of.low < z - slack_;
      if (!is_beside) continue;
      const std::array<Vec2, 3> corners = corners_about(e);
      double radius = std::max({corners[0].x(), corners[1].x(), corners[2].x()});
      if (e.kind == ElementKind::segment)
        radius = e.a.x() + std::clamp((z - e.a.y()) / (e.b.y() - e.a.y()), 0.0, 1.0) * (e.b.x() - e.a.x()) + slack_;
      widest = std::max(widest, radius);
    }
    return widest;
  }

  // Returns the radius of the solid just below the height at which element i begins; 0 if there is nothing below.
  double radius_below(std::size_t i) const {
    const double z = elements_[i].a.y();
    for (std::size_t j = i; j-- > 0;)
      if (elements_[j].a.y() < z - slack_) return elements_[j].b.x();
    return 0;
  }
  double radius_above(std::size_t i) const {
    const double z = elements_[i].b.y();
    for (std::size_t j = i + 1; j < elements_.size(); ++j)
      if (elements_[j].b.y() > z + slack_) return elements_[j].a.x();
    return 0;
  }

  static double widest(const BoundaryElement& e) {
    const double ends = std::max(e.a.x(), e.b.x());
    if (e.kind != ElementKind::arc || e.is_reflex) return ends;
    const bool has_equator = e.a.y() < e.center.y() && e.center.y() < e.b.y();
    return has_equator ? e.center.x() + e.radius_mm : ends;
  }

  // Computes the range of a horizontal face that looks down. A point above the face may leave through it if it is
  // outside the radius of the solid below. A point below the face is free if nothing below it is wider.
  SupportRange below_step(std::size_t i) const {
    SupportRange claim{-kEndless, kEndless, radius_below(i)};
    const double z = elements_[i].a.y();
    for (std::size_t j = i; j-- > 0;)
      if (elements_[j].a.y() < z - slack_ && widest(elements_[j]) > claim.r_min_mm + slack_) {
        claim.z_lo_mm = elements_[j].b.y();
        break;
      }
    return claim;
  }
  SupportRange above_step(std::size_t i) const {
    SupportRange claim{-kEndless, kEndless, radius_above(i)};
    const double z = elements_[i].b.y();
    for (std::size_t j = i + 1; j < elements_.size(); ++j)
      if (elements_[j].b.y() > z + slack_ && widest(elements_[j]) > claim.r_min_mm + slack_) {
        claim.z_hi_mm = elements_[j].a.y();
        break;
      }
    return claim;
  }

  std::vector<BoundaryElement>& elements_;
  double slack_;
  std::vector<ContourStretch> stretches_;  // few elements are one stretch, which is never skipped
};

// Returns the lowest point of an element: an end, or for an arc possibly the point below its centre.
Vec2 lowest_of(const ProfileElement& e) {
  Vec2 lowest = e.b.y() < e.a.y() ? e.b : e.a;
  const Vec2 pole = e.center - Vec2(0, e.radius_mm);
  if (!e.is_arc || pole.y() >= lowest.y()) return lowest;
  ProfileElement part = e;
  part.b = pole;
  return sweep_rad(part) < sweep_rad(e) ? pole : lowest;
}

// Returns the contour with a horizontal line from the axis to its lowest point instead of the part before that point.
// Returns nothing if the rest has two radii at one height. The replaced part is within the fill: it starts on the axis,
// above the line, and crosses nothing.
std::optional<Profile> with_filled_underside(const Profile& profile) {
  const std::vector<ProfileElement>& parts = profile.elements;
  std::size_t first = 0;
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (lowest_of(parts[i]).y() < lowest_of(parts[first]).y()) first = i;
  const Vec2 rim = lowest_of(parts[first]);
  Profile filled;
  filled.elements.push_back(make_segment(parts[first].body, Vec2(0, rim.y()), rim));
  if (rim != parts[first].b) {
    filled.elements.push_back(parts[first]);
    filled.elements.back().a = rim;
  }
  filled.elements.insert(filled.elements.end(), parts.begin() + static_cast<std::ptrdiff_t>(first) + 1, parts.end());
  if (!verify_profile(filled).empty() || !is_single_valued(filled)) return std::nullopt;
  return filled;
}

bool is_same(const BoundaryElement& e, const BoundaryElement& o) {
  return e.kind == o.kind && e.is_reflex == o.is_reflex && e.a == o.a && e.b == o.b && e.center == o.center;
}

// Returns whether both elements have the same planes. The planes of a vertex lie between its neighbours' normals, so
// these must be equal too.
bool has_same_planes(const std::vector<BoundaryElement>& p, std::size_t i, const std::vector<BoundaryElement>& q,
                     std::size_t j) {
  if (!is_same(p[i], q[j])) return false;
  if (p[i].kind != ElementKind::vertex) return true;
  return i > 0 && j > 0 && i + 1 < p.size() && j + 1 < q.size() && is_same(p[i - 1], q[j - 1]) &&
         is_same(p[i + 1], q[j + 1]);
}

// Sets the ranges of a contour of many elements that turns back in height to those with its underside filled. A solid
// is never deeper than a larger one.
void set_ranges_of_filled(const Profile& profile, std::vector<BoundaryElement>& elements) {
  const std::optional<Profile> filled = with_filled_underside(profile);
  if (!filled) return;
  std::vector<BoundaryElement> outer = make_elements(*filled);
  Support(*filled, outer).set_all();
  // The elements that both contours share have the same order in both.
  for (std::size_t i = 0, j = 0; i < elements.size(); ++i) {
    std::size_t k = j;
    while (k < outer.size() && !has_same_planes(elements, i, outer, k)) ++k;
    if (k == outer.size()) continue;
    elements[i].support = outer[k].support;
    j = k + 1;
  }
}

}  // namespace

void set_support_ranges(const Profile& profile, std::vector<BoundaryElement>& elements) {
  if (is_single_valued(profile)) return Support(profile, elements).set_all();
  if (elements.size() <= kMaxOfAnyContour) return Support(profile, elements).set_all_of_any_contour();
  set_ranges_of_filled(profile, elements);
}

}  // namespace gouge
