#include "tests/bench/penetration/safe_depth.h"

#include <algorithm>
#include <cmath>

#include "lib/geom/point_triangle.h"
#include "tests/bench/penetration/normal_methods.h"

namespace gouge {
namespace {

using Corners = std::array<Vec3, 3>;

// A piece this small against its distance fixes the bound to about a tenth; halving stops there.
constexpr double kSmallPiece = 0.05;
constexpr int kDeepestHalving = 12;
constexpr double kOpposed = 1e-6;  // right angles are not

/// Smallest ball that touches a facet (or a vertex) and the rest of the surface.
class BallSearch {
 public:
  explicit BallSearch(const DepthBody& body) : body_(body) {}

  /// Balls about `foot - r normal`. Lowers `radius` to the smallest found and states whether it did.
  bool lower(const Corners& foot, const Vec3& normal, const TriangleCorners& own, double& radius) {
    foot_ = &foot;
    normal_ = &normal;
    own_ = own;
    radius_ = radius;
    const Vec3 centre = (foot[0] + foot[1] + foot[2]) / 3.0;
    double wide = 0;
    for (const Vec3& corner : foot) wide = std::max(wide, (corner - centre).norm());
    centre_ = centre;
    wide_ = wide;
    const double before = radius_;
    if (!body_.tree.nodes.empty()) visit(0);
    radius = radius_;
    return radius_ < before;
  }

 private:
  void visit(std::uint32_t index) {
    const float* const box = body_.boxes.data() + 6 * std::size_t{index};
    double out2 = 0, lowest = 0;
    for (int i = 0; i < 3; ++i) {
      const double low = static_cast<double>(box[i]), high = static_cast<double>(box[i + 3]);
      const double out = std::max({low - centre_[i], centre_[i] - high, 0.0});
      out2 += out * out;
      lowest += (*normal_)[i] * ((*normal_)[i] > 0 ? low : high);
    }
    const double reach = wide_ + 2 * radius_;
    if (out2 >= reach * reach || lowest >= normal_->dot((*foot_)[0])) return;
    const KdopNode& node = body_.tree.nodes[index];
    for (std::uint32_t k = 0; k < (node.children > 0 ? node.children : 0U); ++k) visit(node.first + k);
    for (std::uint32_t k = 0; node.children == 0 && k < node.item_count; ++k) {
      if (is_obstacle(body_.tree.order[node.first + k])) meet(body_.corners[node.first + k], 0);
    }
  }

  /// Facets that lean the same way end each other's cells by collapse; only opposed ones come from the other
  /// side.
  [[nodiscard]] bool is_obstacle(std::uint32_t triangle) const {
    if (!(body_.surface.face_normal(triangle).dot(*normal_) < -kOpposed)) return false;
    for (const Corner c : body_.mesh().triangles[triangle]) {
      if (std::find(own_.begin(), own_.end(), c) != own_.end()) return false;
    }
    return true;
  }

  /// |g - x|^2 / (2 h) over points g of `piece`, h their height below the foot's plane.
  void meet(const Corners& piece, int halvings) {
    const Vec3 centre = (piece[0] + piece[1] + piece[2]) / 3.0;
    double wide = 0, deepest = 0;
    for (const Vec3& corner : piece) {
      wide = std::max(wide, (corner - centre).norm());
      deepest = std::max(deepest, normal_->dot((*foot_)[0] - corner));
    }
    if (!(deepest > 0)) return;
    const double distance = std::sqrt(closest_on_triangle(centre, *foot_).distance2_mm2);
    const double least = std::max(0.0, distance - wide);
    const double bound = least * least / (2 * deepest);
    if (bound >= radius_) return;
    if (wide <= kSmallPiece * distance || halvings == kDeepestHalving) {
      radius_ = bound;
      return;
    }
    const Vec3 ab = 0.5 * (piece[0] + piece[1]), bc = 0.5 * (piece[1] + piece[2]), ca = 0.5 * (piece[2] + piece[0]);
    meet({piece[0], ab, ca}, halvings + 1);
    meet({ab, piece[1], bc}, halvings + 1);
    meet({ca, bc, piece[2]}, halvings + 1);
    meet({ab, bc, ca}, halvings + 1);
  }

  const DepthBody& body_;
  const Corners* foot_ = nullptr;
  const Vec3* normal_ = nullptr;
  std::array<Corner, 3> own_{};
  Vec3 centre_ = Vec3::Zero();
  double wide_ = 0, radius_ = 0;
};

}  // namespace

SafeDepth largest_safe_depth(const DepthBody& body, double asked_mm) {
  SafeDepth safe{asked_mm, SafeDepthLimit::asked, 0};
  for (std::uint32_t t = 0; t < body.mesh().triangles.size(); ++t) {
    const double collapse = collapse_depth_mm(body.mesh(), body.offsets, t);
    if (collapse < safe.depth_mm) safe = {collapse, SafeDepthLimit::collapse, t};
  }
  BallSearch balls(body);
  for (std::uint32_t t = 0; t < body.mesh().triangles.size(); ++t) {
    const TriangleCorners& c = body.mesh().triangles[t];
    const Corners facet = {body.mesh().vertices[c[0]], body.mesh().vertices[c[1]], body.mesh().vertices[c[2]]};
    const bool is_nearer = balls.lower(facet, body.surface.face_normal(t), c, safe.depth_mm);
    if (is_nearer) safe = {safe.depth_mm, SafeDepthLimit::obstacle, t};
  }
  return safe;
}

}  // namespace gouge
