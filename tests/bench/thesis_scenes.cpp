#include "tests/bench/thesis_scenes.h"

#include <cmath>

#include "tests/support/scatter.h"
#include "tests/support/solids.h"

namespace gouge::bench {
namespace {

constexpr double kApart_mm = 2;  // without overlap, still within each other's volumes

/// Slides the body in along `axis` until at least `range.least` points are inside; states whether it is not too
/// many.
bool slide_in(PenetrationFinder& finder, const PoseRange& range, const Vec3& axis, RigidTransform& pose) {
  double out_mm = 90, in_mm = 20;
  const auto inside_at = [&](double distance_mm) {
    pose.shift = distance_mm * axis;
    return finder.find(pose).contacts.size();
  };
  const std::size_t wanted = std::max<std::size_t>(range.least, 1);
  for (int i = 0; i < 30; ++i) {
    const double middle = 0.5 * (out_mm + in_mm);
    (inside_at(middle) >= wanted ? in_mm : out_mm) = middle;
  }
  const double distance_mm = range.most == 0 ? out_mm + kApart_mm : in_mm;
  const std::size_t inside = inside_at(distance_mm);
  return inside >= range.least && inside <= range.most;
}

}  // namespace

IndexedMesh make_standing_body(std::size_t rings, std::size_t sectors) {
  return shapes::bumpy_sphere(40, 3, rings, sectors);
}

std::vector<Vec3> make_moving_points() {
  std::vector<Vec3> points = shapes::bumpy_sphere(20, 1, 24, 24).vertices;
  for (Vec3& p : points) p.z() *= 0.2;
  return points;
}

std::vector<PoseRange> table_6a_ranges() {
  return {{"large overlap", 90, 130}, {"grazing contact", 15, 30}, {"no overlap", 0, 0}};
}

std::vector<RigidTransform> find_poses(const DepthBody& body, const PointBody& points, const PoseRange& range,
                                       std::size_t count) {
  PenetrationFinder finder(body, points);
  test::Scatter random(5);
  std::vector<RigidTransform> poses;
  while (poses.size() < count) {
    RigidTransform pose;
    const Vec3 axis = random.direction();
    const Eigen::Quaterniond facing = Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), axis);
    const Eigen::AngleAxisd lean(0.15 * random.in(-1, 1), random.direction()),
        spin(3.1 * random.in(-1, 1), Vec3::UnitZ());
    pose.rotation = (lean * facing * spin).toRotationMatrix();
    if (slide_in(finder, range, axis, pose)) poses.push_back(pose);
  }
  return poses;
}

}  // namespace gouge::bench
