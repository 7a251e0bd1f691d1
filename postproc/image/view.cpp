#include "postproc/image/view.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/base/tolerance.h"
#include "postproc/image/heat_map.h"
#include "postproc/image/material_left.h"
#include "postproc/image/picture_events.h"

namespace gouge {

View make_view(const Vec3& toward, const Vec3& up_hint, int width, int height) {
  View view;
  view.toward = toward.normalized();
  Vec3 right = up_hint.cross(view.toward);
  // In a view along the hint, "up" is open. People then expect y, and after that x.
  if (right.norm() < Tolerance::kNoSide) right = Vec3::UnitY().cross(view.toward);
  if (right.norm() < Tolerance::kNoSide) right = Vec3::UnitX().cross(view.toward);
  view.right = right.normalized();
  view.up = view.toward.cross(view.right);
  view.width = width;
  view.height = height;
  return view;
}

void fit_view(View& view, std::span<const std::span<const Vec3>> points, double margin) {
  constexpr double kFar = std::numeric_limits<double>::max();
  Vec3 low(kFar, kFar, kFar);
  Vec3 high = -low;
  for (const std::span<const Vec3> some : points) {
    for (const Vec3& p : some) {
      const Vec3 q(p.dot(view.right), p.dot(view.up), p.dot(view.toward));
      low = low.cwiseMin(q);
      high = high.cwiseMax(q);
    }
  }
  if (!(low.x() <= high.x())) low = high = Vec3::Zero();
  const Vec3 middle = 0.5 * (low + high);
  view.centre = view.right * middle.x() + view.up * middle.y() + view.toward * middle.z();
  const double inner = 1 - 2 * margin;
  view.mm_per_pixel = std::max({(high.x() - low.x()) / (inner * view.width),
                                (high.y() - low.y()) / (inner * view.height), Tolerance::kRounding});
}

namespace {

constexpr double kDistinctCosine = 0.643;  // cosine of 50 degrees
constexpr std::size_t kMaxWitnessesSeen = 400;
constexpr double kClear = 0.01;  // relative to the size of the parts: surfaces this close to a point do not hide it

struct Candidate {
  Vec3 toward;
  double gouged = 0;
  double score = 0;
};

Vec3 mean_axis(const Toolpath& toolpath) {
  Vec3 sum = Vec3::Zero();
  for (const Move& move : toolpath.moves) sum += move.end.axis;
  return sum.norm() > Tolerance::kNoSide ? Vec3(sum.normalized()) : Vec3(Vec3::UnitZ());
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

// Returns the weight of the gouged surface that is visible.
double gouged_area(const CheckedToolpath& input, const std::vector<GougeWitness>& gouges, const Vec3& toward,
                   double clear_mm) {
  double area = 0;
  for (const GougeWitness& gouge : gouges) {
    if (is_in_sight(input, gouge.at, toward, clear_mm)) area += gouge.weight;
  }
  return area;
}

}  // namespace

std::vector<Vec3> choose_directions(const CheckedToolpath& input, const PictureScene& scene,
                                    const std::vector<PictureEvent>& events, std::size_t count) {
  const Vec3 axis = mean_axis(*input.toolpath);
  std::vector<GougeWitness> gouges = gouge_witnesses(input, kMaxWitnessesSeen);
  if (gouges.empty()) gouges = material_witnesses(*input.result, kMaxWitnessesSeen);
  const double clear_mm = kClear * scene.part_size_mm();
  std::vector<Candidate> all = candidates(axis);
  double max_gouged = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    Candidate& c = all[i];
    c.gouged = gouged_area(input, gouges, c.toward, clear_mm);
    double weight = 0;
    double seen = 0;
    for (const PictureEvent& event : events) {
      const double share = 1.0 / event.rank;
      weight += share;
      if (is_in_sight(input, event.at, c.toward, clear_mm)) seen += share;
    }
    max_gouged = std::max(max_gouged, c.gouged);
    c.score = weight > 0 ? 0.6 * seen / weight : 0;
    c.score += 0.25 * c.toward.dot(axis);      // people know the view from the tool's side
    if (i < 8) c.score += 0.45;                // a body is easier to recognise from a corner than from a face
    if (c.toward.z() > -0.1) c.score += 0.15;  // people examine parts from above
    c.score -= 1e-3 * static_cast<double>(i);
  }
  for (Candidate& c : all) c.score += max_gouged > 0 ? c.gouged / max_gouged : 0;
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
