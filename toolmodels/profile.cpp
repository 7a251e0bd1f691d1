#include "toolmodels/profile.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lib/base/tolerance.h"
#include "toolmodels/box_tree.h"
#include "toolmodels/offset_curves.h"

namespace gouge {
namespace {

// limits the messages: the number of crossings may be the square of the number of elements
constexpr std::size_t kMaxNamed = 100;

Vec2 direction_at(const ProfileElement& element, const Vec2& point) {
  const Vec2 out = (point - element.center) / element.radius_mm;
  return element.is_concave ? Vec2(out.y(), -out.x()) : Vec2(-out.y(), out.x());
}

// Returns whether an arc contains its outermost point in a direction, between its ends.
bool reaches(const ProfileElement& arc, const Vec2& direction) {
  ProfileElement part = arc;
  part.b = arc.center + arc.radius_mm * direction;
  return sweep_rad(part) < sweep_rad(arc);
}

bool do_cross(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const auto side = [](const Vec2& p, const Vec2& q, const Vec2& x) {
    return (q.x() - p.x()) * (x.y() - p.y()) - (q.y() - p.y()) * (x.x() - p.x());
  };
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

void verify_element(const ProfileElement& e, double slack, const std::string& name, std::vector<std::string>& broken) {
  if (!e.a.allFinite() || !e.b.allFinite()) broken.push_back(name + " is not finite");
  if ((e.b - e.a).norm() <= slack) broken.push_back(name + " has no length");
  if (e.a.x() < 0 || e.b.x() < 0) broken.push_back(name + " crosses the axis");
  if (!e.is_arc) return;
  if (!(e.radius_mm > 0)) broken.push_back(name + " has no radius");
  if (std::abs((e.a - e.center).norm() - e.radius_mm) > slack ||
      std::abs((e.b - e.center).norm() - e.radius_mm) > slack)
    broken.push_back(name + " does not lie on its circle");
  const Vec2 leftmost = e.center - Vec2(e.radius_mm, 0);
  if (leftmost.x() < -slack && reaches(e, Vec2(-1, 0))) broken.push_back(name + " crosses the axis");
}

std::vector<Vec2> outline_with_owners(const Profile& profile, std::vector<std::size_t>& owner) {
  std::vector<Vec2> points;
  for (std::size_t i = 0; i < profile.elements.size(); ++i) {
    const std::vector<Vec2> part = sample(profile.elements[i], 48);
    for (std::size_t k = 0; k + 1 < part.size(); ++k) {
      points.push_back(part[k]);
      owner.push_back(i);
    }
  }
  points.push_back(profile.elements.back().b);
  return points;
}

double doubled_area(const std::vector<Vec2>& points) {
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2& p = points[i];
    const Vec2& q = points[(i + 1) % points.size()];
    sum += p.x() * q.y() - p.y() * q.x();
  }
  return sum;
}

void verify_shape(const Profile& profile, double slack, std::vector<std::string>& broken) {
  std::vector<std::size_t> owner;
  const std::vector<Vec2> points = outline_with_owners(profile, owner);
  if (doubled_area(points) <= 0) broken.push_back("the solid is not on the left of the contour");
  // A contour may leave the axis at any angle, so points next to its ends may be close to the axis.
  const auto is_near_end = [&](const Vec2& p) {
    return std::min((p - points.front()).norm(), (p - points.back()).norm()) <= 1e3 * slack;
  };
  for (std::size_t i = 1; i + 1 < points.size(); ++i)
    if (points[i].x() <= (is_near_end(points[i]) ? 0 : slack))
      broken.push_back("the contour touches the axis between its ends");
  std::vector<Eigen::AlignedBox2d> boxes;
  for (std::size_t i = 0; i < owner.size(); ++i) boxes.push_back(Eigen::AlignedBox2d(points[i]).extend(points[i + 1]));
  const detail::BoxTree tree(boxes);
  for (std::size_t i = 0; i < owner.size() && broken.size() < kMaxNamed; ++i)
    tree.for_each_meeting(boxes[i], [&](std::size_t j) {
      if (j >= i + 2 && do_cross(points[i], points[i + 1], points[j], points[j + 1]))
        broken.push_back("elements " + std::to_string(owner[i]) + " and " + std::to_string(owner[j]) + " cross");
    });
}

void verify_joints(const Profile& profile, double slack, std::vector<std::string>& broken) {
  std::vector<Eigen::AlignedBox2d> boxes;
  for (const ProfileElement& e : profile.elements) boxes.push_back(detail::box_around(e, 2 * slack));
  const detail::BoxTree tree(boxes);
  for (std::size_t i = 0; i + 1 < profile.elements.size() && broken.size() < kMaxNamed; ++i)
    tree.for_each_meeting(Eigen::AlignedBox2d(profile.elements[i].b), [&](std::size_t j) {
      if (j != i && j != i + 1 && detail::passes(profile.elements[j], profile.elements[i].b, slack))
        broken.push_back("element " + std::to_string(j) + " touches the end of element " + std::to_string(i));
    });
}

}  // namespace

ProfileElement make_segment(Body body, const Vec2& a, const Vec2& b) {
  ProfileElement e;
  e.body = body;
  e.a = a;
  e.b = b;
  return e;
}

ProfileElement make_convex_arc(Body body, const Vec2& a, const Vec2& b, const Vec2& center, double radius_mm) {
  ProfileElement e = make_segment(body, a, b);
  e.is_arc = true;
  e.center = center;
  e.radius_mm = radius_mm;
  return e;
}

ProfileElement make_concave_arc(Body body, const Vec2& a, const Vec2& b, const Vec2& center, double radius_mm) {
  ProfileElement e = make_convex_arc(body, a, b, center, radius_mm);
  e.is_concave = true;
  return e;
}

Vec2 start_direction(const ProfileElement& e) {
  return e.is_arc ? direction_at(e, e.a) : Vec2((e.b - e.a).normalized());
}

Vec2 end_direction(const ProfileElement& e) { return e.is_arc ? direction_at(e, e.b) : Vec2((e.b - e.a).normalized()); }

double sweep_rad(const ProfileElement& e) {
  if (!e.is_arc) return 0;
  const Vec2 u = e.a - e.center;
  const Vec2 v = e.b - e.center;
  double angle = std::atan2(u.x() * v.y() - u.y() * v.x(), u.dot(v));
  if (e.is_concave) angle = -angle;
  return angle > 0 ? angle : angle + 2 * std::numbers::pi;
}

std::vector<Vec2> sample(const ProfileElement& e, int steps) {
  if (!e.is_arc) return {e.a, e.b};
  std::vector<Vec2> points{e.a};
  const double sweep = e.is_concave ? -sweep_rad(e) : sweep_rad(e);
  const Vec2 u = e.a - e.center;
  for (int i = 1; i < steps; ++i) {
    const double angle = sweep * i / steps;
    const double c = std::cos(angle), s = std::sin(angle);
    points.emplace_back(e.center + Vec2(c * u.x() - s * u.y(), s * u.x() + c * u.y()));
  }
  points.push_back(e.b);
  return points;
}

double size_of(const Profile& profile) {
  double size = 0;
  for (const ProfileElement& e : profile.elements)
    size = std::max({size, e.a.cwiseAbs().maxCoeff(), e.b.cwiseAbs().maxCoeff()});
  return size;
}

bool is_single_valued(const Profile& profile) {
  const double slack = Tolerance::kRounding;
  return std::all_of(profile.elements.begin(), profile.elements.end(), [&](const ProfileElement& e) {
    // The height must not fall anywhere along the contour. On an arc of at most half a circle all directions lie
    // between those at its ends. The direction at the middle shows on which side.
    return start_direction(e).y() >= -slack && end_direction(e).y() >= -slack &&
           sweep_rad(e) <= std::numbers::pi + slack && (!e.is_arc || direction_at(e, sample(e, 2)[1]).y() >= -slack);
  });
}

std::vector<std::string> verify_profile(const Profile& profile) {
  std::vector<std::string> broken;
  if (profile.elements.empty()) return {"the contour is empty"};
  const double slack = Tolerance::kRounding * size_of(profile);
  for (std::size_t i = 0; i < profile.elements.size(); ++i)
    verify_element(profile.elements[i], slack, "element " + std::to_string(i), broken);
  for (std::size_t i = 0; i + 1 < profile.elements.size(); ++i)
    if (profile.elements[i].b != profile.elements[i + 1].a)
      broken.push_back("element " + std::to_string(i) + " does not end where the next one starts");
  if (profile.elements.front().a.x() > 0) broken.push_back("the contour does not start on the axis");
  if (profile.elements.back().b.x() > 0) broken.push_back("the contour does not end on the axis");
  if (profile.elements.back().b.y() - profile.elements.front().a.y() <= slack)
    broken.push_back("the contour does not end above its start");
  if (broken.empty()) verify_joints(profile, slack, broken);
  if (broken.empty()) verify_shape(profile, slack, broken);
  return broken;
}

}  // namespace gouge
