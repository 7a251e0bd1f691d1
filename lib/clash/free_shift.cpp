#include "lib/clash/free_shift.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/penetration/find_penetration.h"
#include "lib/penetration/point_body.h"

namespace gouge {
namespace {

constexpr std::size_t kPointsOfSurface = 4000;  // approximate number of points besides the vertices
constexpr double kMinDepth_mm = 0.01;           // minimum depth of the volumes
constexpr double kReach = 3;                    // a point farther from the other body than this many depths is left out

/// The points of one body that are in the other, for shifts of the one.
class PointsInside {
 public:
  PointsInside(const Surface& points_of, const Surface& in, double depth_mm)
      : body_(build_depth_body(in, options(depth_mm))),
        points_(build_point_body(points_near(points_of.mesh(), in.mesh().box(), depth_mm))),
        finder_(body_, points_) {}

  void add_contacts(const Vec3& shift, bool is_of_b, std::vector<Contact>& contacts) {
    for (const PointContact& found : finder_.find({Eigen::Matrix3d::Identity(), shift}).contacts) {
      contacts.push_back(found.contact);
      if (!is_of_b) contacts.back().normal = -found.contact.normal;
    }
  }

 private:
  static DepthBodyOptions options(double depth_mm) {
    DepthBodyOptions options;
    options.depth_mm = depth_mm;
    return options;
  }

  static std::vector<Vec3> points_near(const IndexedMesh& mesh, Box3 box, double depth_mm) {
    double area = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      area += 0.5 * (mesh.corner(t, 1) - mesh.corner(t, 0)).cross(mesh.corner(t, 2) - mesh.corner(t, 0)).norm();
    const double spacing = std::sqrt(area / kPointsOfSurface);
    const Vec3 reach = Vec3::Constant(kReach * depth_mm);
    box = Box3(Vec3(box.min() - reach), Vec3(box.max() + reach));
    std::vector<Vec3> points = surface_points(mesh, spacing);
    std::erase_if(points, [&](const Vec3& point) { return !box.contains(point); });
    if (points.empty()) points.push_back(mesh.vertices.front());
    return points;
  }

  DepthBody body_;
  PointBody points_;
  PenetrationFinder finder_;
};

/// Returns the shortest of the shifts along the axes, in both directions, that take the boxes apart.
Vec3 shift_of_boxes(const Box3& a, const Box3& b, double apart_mm) {
  Vec3 best = Vec3::Zero();
  double shortest = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    for (const double shift : {a.max()[axis] - b.min()[axis] + apart_mm, a.min()[axis] - b.max()[axis] - apart_mm}) {
      if (!(std::abs(shift) < shortest)) continue;
      shortest = std::abs(shift);
      best = shift * Vec3::Unit(axis);
    }
  }
  return best;
}

class Shifter {
 public:
  Shifter(const ClashBody& a, const ClashBody& b, const Clash& found, const ClashOptions& options)
      : a_(a),
        b_(b),
        options_(options),
        of_b_(b.boundary(), a.boundary(), reach_mm(found)),
        of_a_(a.boundary(), b.boundary(), reach_mm(found)) {
    // A proof is enough here; bodies that are not free need only some point that gives a direction.
    options_.gap_mm = std::max(options.gap_mm, 0.1 * found.depth_mm);
  }

  std::optional<FreeShift> run() {
    CorrectionOptions correction;
    correction.free_mm = options_.tolerance_mm + options_.resolution_mm;
    const FreeingShift found = correct_until_free([this](const Vec3& shift) { return contacts_at(shift); }, correction);
    const bool is_proved = state_ == ClashState::free || state_ == ClashState::touching;
    if (found.end != CorrectionEnd::free || !is_proved) return std::nullopt;
    return FreeShift{found.shift, true, found.iterations, state_};
  }

 private:
  static double reach_mm(const Clash& found) { return std::max(found.depth_mm, kMinDepth_mm); }

  /// Returns the contacts at a shift. Each is deeper by the tolerance and the resolution, so that the corrections do
  /// not approach the limit in ever smaller steps.
  std::vector<Contact> contacts_at(const Vec3& shift) {
    std::vector<Contact> contacts;
    of_b_.add_contacts(shift, true, contacts);
    of_a_.add_contacts(-shift, false, contacts);
    const bool is_any_deep = std::any_of(contacts.begin(), contacts.end(), [this](const Contact& contact) {
      return contact.depth_mm > options_.tolerance_mm;
    });
    if (!is_any_deep) {
      const Clash clash = find_clash(a_, b_, shift, options_);
      state_ = clash.state;
      if (clash.state != ClashState::penetrating) return {};
      contacts.insert(contacts.end(), clash.deepest.begin(), clash.deepest.end());
    }
    for (Contact& contact : contacts) contact.depth_mm += options_.tolerance_mm + options_.resolution_mm;
    return contacts;
  }

  const ClashBody& a_;
  const ClashBody& b_;
  ClashOptions options_;
  PointsInside of_b_, of_a_;
  ClashState state_ = ClashState::not_certified;
};

}  // namespace

FreeShift find_free_shift(const ClashBody& a, const ClashBody& b, const Clash& found, const ClashOptions& options) {
  FreeShift boxes;
  boxes.is_weighted = false;
  boxes.shift = shift_of_boxes(a.whole().mesh().box(), b.whole().mesh().box(), options.resolution_mm);
  boxes.state = find_clash(a, b, boxes.shift, options).state;
  if (!a.is_solid() || !b.is_solid()) return boxes;
  const std::optional<FreeShift> weighted = Shifter(a, b, found, options).run();
  return weighted && weighted->shift.norm() < boxes.shift.norm() ? *weighted : boxes;
}

}  // namespace gouge
