#include "lib/penetration/nearest_foot.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "lib/mesh/winding.h"

namespace gouge {
namespace {

constexpr float kSingle = 4.0F / (1 << 24), kFilterSlack = 8;

double box_distance2(const float* box, const Vec3& p) {
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    const double out =
        std::max({static_cast<double>(box[i]) - p[i], p[i] - static_cast<double>(box[i + 3]), 0.0});
    sum += out * out;
  }
  return sum;
}

class Search {
 public:
  Search(const DepthBody& body, const Vec3& point, double within_mm)
      : body_(body),
        point_(point),
        best2_(within_mm * within_mm),
        x_(static_cast<float>(point.x())),
        y_(static_cast<float>(point.y())),
        z_(static_cast<float>(point.z())),
        slack_(body.slack_mm + kSingle * static_cast<float>(point.cwiseAbs().maxCoeff())) {}

  std::optional<SurfaceFoot> run() {
    if (body_.tree.nodes.empty()) return std::nullopt;
    visit(0);
    if (!has_foot_) return std::nullopt;
    return signed_foot(body_, point_, place_, foot_);
  }

 private:
  void visit(std::uint32_t index) {
    const KdopNode& node = body_.tree.nodes[index];
    if (node.children == 0) {
      for (std::uint32_t k = 0; k < node.item_count; ++k) offer(node.first + k);
      return;
    }
    std::array<std::pair<double, std::uint32_t>, 8> near;
    std::size_t count = 0;
    for (std::uint32_t child = node.first; child < node.first + node.children; ++child) {
      double distance2 = box_distance2(body_.boxes.data() + 6 * std::size_t{child}, point_);
      if (distance2 > best2_) continue;
      distance2 = std::max(distance2, disc_distance2(body_.discs[child]));
      if (distance2 > best2_) continue;
      std::size_t at = count++;
      for (; at > 0 && near[at - 1].first > distance2; --at) near[at] = near[at - 1];
      near[at] = {distance2, child};
    }
    for (std::size_t k = 0; k < count; ++k) {
      if (near[k].first <= best2_) visit(near[k].second);
    }
  }

  [[nodiscard]] double disc_distance2(const NodeDisc& disc) const {
    const float off = disc.n[0] * x_ + disc.n[1] * y_ + disc.n[2] * z_ - disc.o;
    const float over = std::max(0.0F, std::abs(off) - disc.half);
    const float dx = x_ - disc.c[0], dy = y_ - disc.c[1], dz = z_ - disc.c[2];
    // Seen along the normal the facets lie within r of the centre.
    const float away = disc.n[0] * dx + disc.n[1] * dy + disc.n[2] * dz;
    const float across2 = (dx * dx + dy * dy + dz * dz) * (1 - 1e-6F) - away * away;
    const float beyond = across2 > disc.r * disc.r ? std::sqrt(across2) - disc.r : 0;
    const float least = std::sqrt(over * over + beyond * beyond) - kFilterSlack * slack_;
    return least > 0 ? static_cast<double>(least) * static_cast<double>(least) : 0;
  }

  void offer(std::uint32_t place) {
    const FacetRecord& f = body_.facets[place];
    const float h = f.n[0] * x_ + f.n[1] * y_ + f.n[2] * z_ - f.o;
    const float dx = x_ - f.c[0], dy = y_ - f.c[1], dz = z_ - f.c[2];
    const double least = static_cast<double>(
        FacetRecord::least_distance(h, dx * dx + dy * dy + dz * dz, f.r) - kFilterSlack * slack_);
    if (least > 0 && least * least > best2_) return;
    const TriangleFoot foot = closest_on_triangle(point_, body_.corners[place]);
    const bool is_nearer = has_foot_ ? foot.distance2_mm2 < best2_ : foot.distance2_mm2 <= best2_;
    if (!is_nearer) return;
    best2_ = foot.distance2_mm2;
    foot_ = foot;
    place_ = place;
    has_foot_ = true;
  }

  const DepthBody& body_;
  const Vec3& point_;
  double best2_;
  float x_, y_, z_;
  float slack_;  ///< single precision may be off by this; the point may be farther out than the body
  TriangleFoot foot_;
  std::uint32_t place_ = 0;
  bool has_foot_ = false;
};

}  // namespace

SurfaceFoot signed_foot(const DepthBody& body, const Vec3& point, std::uint32_t place,
                        const TriangleFoot& foot) {
  SurfaceFoot answer;
  answer.point = foot.point;
  answer.triangle = body.tree.order[place];
  answer.place = place;
  answer.distance_mm = std::sqrt(foot.distance2_mm2);
  const Vec3 way = point - foot.point;
  const Vec3 outward = body.sign.outward(answer.triangle, foot.feature, foot.index);
  const double side = way.dot(outward);
  answer.is_inside = outward.squaredNorm() > 0 ? side < 0 : std::abs(winding_number(body.mesh, point)) > 0.5;
  answer.normal = body.sign.face(answer.triangle);
  if (answer.distance_mm > 0) answer.normal = (answer.is_inside ? -1.0 : 1.0) / answer.distance_mm * way;
  return answer;
}

std::optional<SurfaceFoot> nearest_foot(const DepthBody& body, const Vec3& point, double within_mm) {
  return Search(body, point, within_mm).run();
}

bool facets_within(const DepthBody& body, const Vec3& point, double radius_mm, std::size_t most,
                   std::vector<std::uint32_t>& places) {
  const double radius2 = radius_mm * radius_mm;
  const std::size_t before = places.size();
  std::vector<std::uint32_t> open(body.tree.nodes.empty() ? 0 : 1, 0);
  while (!open.empty()) {
    const std::uint32_t index = open.back();
    open.pop_back();
    if (box_distance2(body.boxes.data() + 6 * std::size_t{index}, point) > radius2) continue;
    const KdopNode& node = body.tree.nodes[index];
    for (std::uint32_t k = 0; k < node.children; ++k) open.push_back(node.first + k);
    for (std::uint32_t k = 0; node.children == 0 && k < node.item_count; ++k) {
      if (closest_on_triangle(point, body.corners[node.first + k]).distance2_mm2 > radius2) continue;
      places.push_back(node.first + k);
      if (places.size() - before > most) return false;
    }
  }
  return true;
}

}  // namespace gouge
