#include "postproc/image/choose_views.h"

#include <algorithm>

#include "postproc/image/pixel_points.h"

namespace gouge {
namespace {

constexpr double kDistinctCosine = 0.643;  // of 50 degrees
constexpr int kProbeWidth = 200;
constexpr int kProbeHeight = 160;

struct Candidate {
  Vec3 toward;
  double gouged = 0;
  double score = 0;
};

Vec3 mean_axis(const Toolpath& toolpath) {
  Vec3 sum = Vec3::Zero();
  for (const Move& move : toolpath.moves) sum += move.end.axis;
  return sum.norm() > 1e-6 ? Vec3(sum.normalized()) : Vec3(Vec3::UnitZ());
}

std::vector<Candidate> candidates(const Vec3& axis) {
  std::vector<Candidate> out;
  for (const double z : {1.0, -1.0}) {
    for (const double y : {-1.0, 1.0}) {
      for (const double x : {1.0, -1.0}) out.push_back({Vec3(0.85 * x, 1.15 * y, 0.95 * z).normalized(), 0, 0});
    }
  }
  out.push_back({axis, 0, 0});
  for (const int k : {2, 1, 0}) {
    for (const double sign : {1.0, -1.0}) {
      Vec3 toward = Vec3::Zero();
      toward[k] = sign;
      out.push_back({toward, 0, 0});
    }
  }
  return out;
}

// Area of gouged surface that is seen, on the surface and not on the picture, so that slanted views are not
// put at a disadvantage.
double gouged_area(const PictureScene& scene, const DepthField& field, const SurfaceBuffer& buffer) {
  const std::vector<float> depth = depth_on_pixels(field, scene, buffer);
  const double pixel = buffer.view.mm_per_pixel * buffer.view.mm_per_pixel;
  double area = 0;
  for (int y = 0; y < buffer.view.height; ++y) {
    for (int x = 0; x < buffer.view.width; ++x) {
      if (!(depth[buffer.index(x, y)] > 0)) continue;
      area += pixel / std::max(0.3, normal_at(scene, buffer, x, y).dot(buffer.view.toward));
    }
  }
  return area;
}

}  // namespace

std::vector<Vec3> choose_directions(const CheckedToolpath& input, const PictureScene& scene, const DepthField& field,
                                    const std::vector<PictureEvent>& events, std::size_t count) {
  const Vec3 axis = mean_axis(*input.toolpath);
  const std::vector<Vec3> points = scene.part_points();
  std::vector<Candidate> all = candidates(axis);
  double most_gouged = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    Candidate& c = all[i];
    View view = make_view(c.toward, Vec3::UnitZ(), kProbeWidth, kProbeHeight);
    fit_view(view, points, 0.03);
    const SurfaceBuffer buffer = draw_surface(scene, view);
    c.gouged = gouged_area(scene, field, buffer);
    double weight = 0;
    double seen = 0;
    for (const PictureEvent& event : events) {
      const double share = 1.0 / event.number;
      weight += share;
      if (is_visible(buffer, event.at, 2 * view.mm_per_pixel)) seen += share;
    }
    most_gouged = std::max(most_gouged, c.gouged);
    c.score = weight > 0 ? 0.6 * seen / weight : 0;
    c.score += 0.25 * c.toward.dot(axis);      // the side the tool comes from is the one people know
    if (i < 8) c.score += 0.45;                // corners show a body better than faces do
    if (c.toward.z() > -0.1) c.score += 0.15;  // people look at parts from above
    c.score -= 1e-3 * static_cast<double>(i);
  }
  for (Candidate& c : all) c.score += most_gouged > 0 ? c.gouged / most_gouged : 0;
  std::stable_sort(all.begin(), all.end(), [](const Candidate& a, const Candidate& b) { return a.score > b.score; });
  std::vector<Vec3> chosen;
  for (const Candidate& c : all) {
    const bool is_distinct = std::none_of(chosen.begin(), chosen.end(),
                                          [&](const Vec3& other) { return other.dot(c.toward) > kDistinctCosine; });
    if (is_distinct && chosen.size() < count) chosen.push_back(c.toward);
  }
  return chosen;
}

}  // namespace gouge
