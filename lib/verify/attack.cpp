#include "lib/verify/attack.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <queue>
#include <tuple>

#include "lib/base/number_text.h"
#include "lib/verify/claimed_pose.h"
#include "lib/verify/draws.h"
#include "lib/verify/surface_proof.h"

namespace gouge {
namespace {

constexpr std::size_t kMoreSamples = 4'000;

/// A body and a surface that must not be deeper in it than `allowed_mm`. The body is a form of the tool, or the heads
/// (no contour).
struct Target {
  const ToolContour* contour = nullptr;
  const TriangleOrder* surface = nullptr;
  double allowed_mm = 0;
};

class Attack {
 public:
  Attack(const ClaimedScene& scene, const SceneOrders& orders, const ClaimedTools& tools,
         const std::vector<MoveClaim>& claims)
      : scene_(scene), orders_(orders), tools_(tools), claims_(claims) {
    for (const SolidDepth& head : scene.heads) {
      head_box_.extend(head.box());
      looks_per_head_ += head.mesh().triangles.size() / 100;  // the time of each query of a head is linear in its
                                                              // facets
    }
  }

  AttackResult run(const std::vector<bool>& is_proved, double seconds) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point began = Clock::now();
    std::vector<std::size_t> bounded, unproved;
    for (std::size_t i = 0; i < claims_.size(); ++i)
      if (allowed_mm(i)) {
        bounded.push_back(i);
        if (!is_proved[i]) unproved.push_back(i);
      }
    AttackResult result;
    result.moves = bounded.size();
    if (bounded.empty()) return result;
    const auto is_over = [&] {
      const double spent = std::chrono::duration<double>(Clock::now() - began).count();
      const bool is_enough = seconds > 0 ? spent >= seconds : result.samples >= unproved.size() + kMoreSamples;
      return result.samples >= unproved.size() && is_enough;
    };
    while (!is_over() && !result.found) {
      const bool is_turn = result.samples < unproved.size();
      const std::size_t move = is_turn ? unproved[result.samples] : bounded[draws_.below(bounded.size())];
      ++result.samples;
      // First the end of each move without a proof, where a plunge is deepest. Then random instants, with ends among
      // them.
      const double t = is_turn ? 1 : draws_.below(4) == 0 ? static_cast<double>(draws_.below(2)) : draws_.share();
      choose_motion(move);
      result.found = look_at(move, t);
    }
    return result;
  }

 private:
  /// Returns the maximum depth that the claim of a move allows; nothing if it allows any depth.
  [[nodiscard]] std::optional<double> allowed_mm(std::size_t move) const {
    const std::size_t tool = scene_.path.moves[move].tool;
    if (tool >= tools_.size() || !tools_[tool]) return std::nullopt;
    if (claims_clean(claims_[move])) return scene_.largest_clean_mm();
    if (claims_[move].state == ClaimedState::gouge) return claims_[move].depth_upper_mm;
    return std::nullopt;
  }

  std::optional<Counterexample> look_at(std::size_t move, double t) {
    const ClaimedTool& tool = *tools_[scene_.path.moves[move].tool];
    const double allowed = *allowed_mm(move);
    std::vector<Target> targets{{&tool.part, &orders_.parts, allowed}, {&tool.fixture, &orders_.fixtures, allowed}};
    if (claims_clean(claims_[move])) {
      targets.push_back({&tool.clearance, &orders_.parts, scene_.resolution_mm});
      targets.push_back({&tool.clearance, &orders_.fixtures, scene_.resolution_mm});
    }
    for (std::size_t k = 0; k < scene_.limits.size(); ++k) {
      const ClaimedLimit& limit = scene_.limits[k];
      const ToolContour* form = limit.clearance_mm > 0 ? &tool.bare : limit.is_fixture ? &tool.fixture : &tool.part;
      const double deepest = claims_clean(claims_[move]) ? limit.tolerance_mm + scene_.resolution_mm : allowed;
      targets.push_back({form, &orders_.limited[k], deepest - limit.clearance_mm});
    }
    if (!scene_.heads.empty() && draws_.below(looks_per_head_) == 0) {
      targets.push_back({nullptr, &orders_.parts, allowed});
      targets.push_back({nullptr, &orders_.fixtures, allowed});
    }
    for (const Target& target : targets) {
      if (target.surface->root().size() == 0 || (target.contour != nullptr && target.contour->empty())) continue;
      if (auto found = attack(target, move, t)) return found;
    }
    return std::nullopt;
  }

  /// The pose of the tool, or the frame of the heads, at one instant.
  struct Place {
    Pose pose;
    RigidTransform heads;
  };

  [[nodiscard]] Place place(const Target& target, std::size_t move, double t) const {
    const std::optional<TurnShares> turn = turn_at(t);
    if (target.contour == nullptr) return {{}, head_frame(scene_, move, t, turn)};
    return {claimed_pose(scene_, move, t, turn), {}};
  }

  /// Returns where the rotary joints are at t, on the motion that is examined.
  [[nodiscard]] std::optional<TurnShares> turn_at(double t) const {
    return is_even_ ? std::optional(TurnShares{t, t}) : resting_;
  }

  /// Chooses one of the motions that the law of a move admits.
  void choose_motion(std::size_t move) {
    const ClaimedRun run = claimed_run_of(scene_, move);
    is_even_ = run == ClaimedRun::documented && draws_.below(2) == 0;
    resting_.reset();
    if (run == ClaimedRun::any && draws_.below(4) != 0) resting_ = TurnShares{draws_.share(), draws_.share()};
  }

  [[nodiscard]] double depth(const Target& target, const Place& place, const Vec3& point) const {
    if (target.contour == nullptr) return depth_in_heads(scene_, place.heads, point);
    return -target.contour->nearest(in_tool(place.pose, point)).signed_distance_mm;
  }

  /// Returns a bound of the depth of all points within `radius` of `center`.
  [[nodiscard]] double max_depth(const Target& target, const Place& place, const Vec3& center, double radius) const {
    if (target.contour != nullptr) return depth(target, place, center) + radius;
    return radius - head_box_.exteriorDistance(place.heads.inverse().point(center));
  }

  /// A node of the triangle order, or a part of one triangle.
  struct Piece {
    double max_mm = 0;  ///< bound of the depth of its points
    TriangleOrder::Node node;
    std::array<Vec3, 3> corners;  ///< of a part of the single triangle of `node`
  };

  /// The deepest point found at one instant.
  struct Deepest {
    double depth_mm = -1e300;
    Vec3 point = Vec3::Zero();
    std::uint32_t triangle = 0;  ///< its position in the triangle order
  };

  /// Returns the deepest found point. Examines first the part that may be deepest; divides nodes and triangles. Stops
  /// when a point is deeper than allowed, no point can be deeper, or many parts were examined.
  [[nodiscard]] Deepest find_deepest(const Target& target, std::size_t move, double t) const {
    constexpr std::size_t kLooks = 300;
    const auto is_less = [](const Piece& a, const Piece& b) { return a.max_mm < b.max_mm; };
    std::priority_queue<Piece, std::vector<Piece>, decltype(is_less)> open(is_less);
    Deepest best;
    const Place here = place(target, move, t);
    const auto offer_triangle = [&](const TriangleOrder::Node& node, const std::array<Vec3, 3>& c) {
      const Vec3 center = (c[0] + c[1] + c[2]) / 3;
      double radius = 0;
      for (const Vec3& p : c) radius = std::max(radius, (p - center).norm());
      const double at_center = depth(target, here, center);
      if (at_center > best.depth_mm) best = {at_center, center, node.first};
      const double most = target.contour != nullptr ? at_center + radius : max_depth(target, here, center, radius);
      if (most > target.allowed_mm) open.push({most, node, c});
    };
    const auto offer = [&](const TriangleOrder::Node& node) {
      if (node.size() == 1) return offer_triangle(node, target.surface->corners(node.first));
      const TriangleOrder::Extent& extent = target.surface->extent(node);
      const double most = max_depth(target, here, extent.center, extent.half.norm());
      if (most > target.allowed_mm) open.push({most, node, {}});
    };
    offer(target.surface->root());
    for (std::size_t looks = 0; !open.empty() && looks < kLooks; ++looks) {
      if (best.depth_mm > target.allowed_mm + kProofSlack_mm) break;
      const Piece piece = open.top();
      open.pop();
      if (piece.node.size() > 1) {
        offer({piece.node.first, piece.node.middle()});
        offer({piece.node.middle(), piece.node.last});
        continue;
      }
      const std::array<Vec3, 3>& c = piece.corners;
      std::size_t k = 0;  // start of the longest edge, which ends at the next corner
      for (const std::size_t i : {1U, 2U})
        if ((c[(i + 1) % 3] - c[i]).squaredNorm() > (c[(k + 1) % 3] - c[k]).squaredNorm()) k = i;
      const Vec3 &from = c[k], &to = c[(k + 1) % 3], &apex = c[(k + 2) % 3], middle = (from + to) / 2;
      offer_triangle(piece.node, {from, middle, apex});
      offer_triangle(piece.node, {middle, to, apex});
    }
    return best;
  }

  /// Moves from a point to deeper ones, over its triangle and over time, in decreasing steps.
  [[nodiscard]] std::pair<Deepest, double> climb(const Target& target, std::size_t move, double t, Deepest best) const {
    const std::array<Vec3, 3> c = target.surface->corners(best.triangle);
    const Vec3 u = c[1] - c[0], v = c[2] - c[0];
    const Vec3 from = best.point - c[0], normal = u.cross(v);
    const double area2 = normal.squaredNorm();
    if (!(area2 > 0)) return {best, t};
    std::array<double, 3> at{from.cross(v).dot(normal) / area2, u.cross(from).dot(normal) / area2, t};
    const auto take = [&](std::array<double, 3> next) {
      for (double& x : next) x = std::clamp(x, 0.0, 1.0);
      if (next[0] + next[1] > 1) return;
      const Vec3 point = c[0] + next[0] * u + next[1] * v;
      const double here = depth(target, place(target, move, next[2]), point);
      if (!(here > best.depth_mm)) return;
      best.depth_mm = here;
      best.point = point;
      at = next;
    };
    const double finest = target.contour != nullptr ? 1e-4 : 0.05;
    for (double step = 0.25; step > finest; step /= 2)
      for (std::size_t k = 0; k < 3; ++k)
        for (const double way : {-step, step}) {
          std::array<double, 3> next = at;
          next[k] += way;
          take(next);
        }
    return {best, at[2]};
  }

  std::optional<Counterexample> attack(const Target& target, std::size_t move, double t) {
    Deepest deepest = find_deepest(target, move, t);
    if (deepest.depth_mm <= -1e300) return std::nullopt;
    std::tie(deepest, t) = climb(target, move, t, deepest);
    if (!(deepest.depth_mm > target.allowed_mm + kProofSlack_mm)) return std::nullopt;
    const std::string body = target.contour == nullptr ? "the head" : "the tool";
    return Counterexample{move, t, deepest.point,
                          "the surface is " + display_text(deepest.depth_mm, 6) + " mm deep in " + body +
                              ", and claimed to be at most " + display_text(target.allowed_mm, 6) + " mm"};
  }

  const ClaimedScene& scene_;
  const SceneOrders& orders_;
  const ClaimedTools& tools_;
  const std::vector<MoveClaim>& claims_;
  Box3 head_box_;
  std::size_t looks_per_head_ = 4;
  Draws draws_;
  bool is_even_ = false;               // the joints run evenly, on a law that also admits the great circle
  std::optional<TurnShares> resting_;  // the rotary joints rest there
};

}  // namespace

AttackResult attack_claims(const ClaimedScene& scene, const SceneOrders& orders, const ClaimedTools& tools,
                           const std::vector<MoveClaim>& claims, const std::vector<bool>& is_proved, double seconds) {
  return Attack(scene, orders, tools, claims).run(is_proved, seconds);
}

}  // namespace gouge
