#include <algorithm>
#include <cmath>
#include <optional>

#include "lib/geom/cross.h"
#include "toolmodels/bsp.h"
#include "toolmodels/contour_tree.h"
#include "toolmodels/elements.h"

namespace gouge {
namespace {

constexpr double kEndless = 1e300;
constexpr double kSupportSlack = 1e-12;     // of the size
constexpr double kHorizontal = 1e-9;        // |n.r| below this: the plane is horizontal
constexpr double kNearlyHorizontal = 1e-6;  // below this a foot may be bounded by a horizontal plane

// The tangent planes of one element: all have a normal between n0 and n1 and touch the circle about `center`
// (radius 0 for a vertex, and for a segment, whose two normals are one).
struct Planes {
  Vec2 n0, n1, center;
  double radius_mm;

  // Largest height of p above any of the planes; convex in p.
  [[nodiscard]] double reach(const Vec2& p) const {
    const Vec2 away = p - center;
    const bool is_between = cross(n0, away) > 0 && cross(away, n1) > 0;
    return (is_between ? away.norm() : std::max(n0.dot(away), n1.dot(away))) - radius_mm;
  }
};

class Support {
 public:
  Support(const Profile& profile, std::vector<BoundaryElement>& elements)
      : elements_(elements), slack_(kSupportSlack * size_of(profile)), stretches_(make_contour_tree(elements)) {
    if (elements.size() <= kMostBspElements) stretches_.assign(1, {0, static_cast<std::uint32_t>(elements.size())});
  }

  void set_all() {
    for (std::size_t i = 0; i < elements_.size(); ++i)
      if (!elements_[i].is_reflex) elements_[i].support = range(i);
  }

 private:
  Planes planes(std::size_t i) const {
    const BoundaryElement& e = elements_[i];
    if (e.kind == ElementKind::segment) return {e.normal, e.normal, e.a, 0};
    if (e.kind == ElementKind::arc)
      return {(e.a - e.center).normalized(), (e.b - e.center).normalized(), e.center, e.radius_mm};
    const Vec2 n0 = i > 0 ? normal_at(elements_[i - 1], elements_[i - 1].b) : Vec2(0, -1);
    const Vec2 n1 = i + 1 < elements_.size() ? normal_at(elements_[i + 1], elements_[i + 1].a) : Vec2(0, 1);
    return {n0, n1, e.a, 0};
  }

  // Whether the whole element stays behind every one of the planes.
  bool is_behind(const BoundaryElement& e, const Planes& planes) const {
    if (e.kind == ElementKind::arc && !e.is_reflex)
      return planes.reach(e.center) + e.radius_mm <= slack_ ||
             (is_flatter(e, planes) && planes.reach(e.a) <= slack_ && planes.reach(e.b) <= slack_);
    return planes.reach(e.a) <= slack_ && planes.reach(e.b) <= slack_;
  }

  // An arc none of whose normals is among those of the planes is highest at one of its ends.
  static bool is_flatter(const BoundaryElement& arc, const Planes& planes) {
    const Vec2 u = arc.a - arc.center;
    const Vec2 v = arc.b - arc.center;
    return cross(planes.n1, u) >= 0 || cross(v, planes.n0) >= 0;
  }

  // The height above a plane is convex, so it is largest at a corner of the box.
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

  // The last element before number `end`, and the first from number `begin` on, that is not behind the planes.
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

  SupportRange range(std::size_t i) const {
    const Planes own = planes(i);
    if (own.n0.x() < kHorizontal && own.n1.x() < kHorizontal && own.n0.dot(own.n1) > 0)
      return own.n0.y() < 0 ? below_step(i) : above_step(i);
    SupportRange claim{-kEndless, kEndless, 0};
    if (const auto j = last_ahead(0, i, own)) claim.z_lo_mm = elements_[*j].b.y();
    if (const auto j = first_ahead(0, i + 1, own)) claim.z_hi_mm = elements_[*j].a.y();
    if (own.n0.x() < kNearlyHorizontal && own.n0.y() < 0) claim.r_min_mm = radius_below(i);
    if (own.n1.x() < kNearlyHorizontal && own.n1.y() > 0) claim.r_min_mm = std::max(claim.r_min_mm, radius_above(i));
    return claim;
  }

  // Radius of the solid just below the height at which element i begins: 0 when nothing is below.
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

  // A horizontal face looking down: outside the radius below it a point above it may leave through it, and a
  // point below it is free as long as nothing down there is wider.
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
  std::vector<ContourStretch> stretches_;  // of few elements one, which is never passed over
};

// The lowest point of an element: an end, or for an arc the point below its centre.
Vec2 lowest_of(const ProfileElement& e) {
  Vec2 lowest = e.b.y() < e.a.y() ? e.b : e.a;
  const Vec2 pole = e.center - Vec2(0, e.radius_mm);
  if (!e.is_arc || pole.y() >= lowest.y()) return lowest;
  ProfileElement part = e;
  part.b = pole;
  return sweep_rad(part) < sweep_rad(e) ? pole : lowest;
}

// From the axis level to the lowest point, then along the contour; nothing when the rest has two radii at one
// height. The contour before that point stays within: it starts on the axis, above the fill, and crosses
// nothing.
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

// The planes of a vertex are those between its neighbours' normals, so these must be the same too.
bool has_same_planes(const std::vector<BoundaryElement>& p, std::size_t i, const std::vector<BoundaryElement>& q,
                     std::size_t j) {
  if (!is_same(p[i], q[j])) return false;
  if (p[i].kind != ElementKind::vertex) return true;
  return i > 0 && j > 0 && i + 1 < p.size() && j + 1 < q.size() && is_same(p[i - 1], q[j - 1]) &&
         is_same(p[i + 1], q[j + 1]);
}

}  // namespace

void set_support_ranges(const Profile& profile, std::vector<BoundaryElement>& elements) {
  if (is_single_valued(profile)) return Support(profile, elements).set_all();
  // A solid is never deeper than a larger one, so what bounds the tool with its underside filled up to the
  // lowest rim bounds the tool.
  const std::optional<Profile> filled = with_filled_underside(profile);
  if (!filled) return;
  std::vector<BoundaryElement> outer = make_elements(*filled);
  Support(*filled, outer).set_all();
  // Both contours run through the elements they share in one order, the filled one from some element on.
  for (std::size_t i = 0, j = 0; i < elements.size(); ++i) {
    std::size_t k = j;
    while (k < outer.size() && !has_same_planes(elements, i, outer, k)) ++k;
    if (k == outer.size()) continue;
    elements[i].support = outer[k].support;
    j = k + 1;
  }
}

}  // namespace gouge
