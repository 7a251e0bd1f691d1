#include "lib/verify/attack.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <queue>

#include "lib/base/number_text.h"
#include "lib/verify/surface_proof.h"

namespace gouge {
namespace {

constexpr std::size_t kMoreSamples = 4'000;

/// S. Vigna's SplitMix64.
class Draws {
 public:
  double share() { return static_cast<double>(next() >> 11) * 0x1p-53; }
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(share() * static_cast<double>(count)); }

 private:
  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15U);
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31U);
  }
  std::uint64_t state_ = 20260101;
};

/// What must not be deeper than `allowed_mm`: a form of the tool, or the heads (no contour).
struct Target {
  const ToolContour* contour = nullptr;
  const TriangleOrder* surface = nullptr;
  double allowed_mm = 0;
};

class Attack {
 public:
  Attack(const ClaimedScene& scene, const ClaimedTools& tools, const std::vector<MoveClaim>& claims)
      : scene_(scene), tools_(tools), claims_(claims), parts_(scene.parts), fixtures_(scene.fixtures) {
    for (const IndexedMesh* head : scene.heads) {
      head_box_.extend(head->box());
      looks_per_head_ += head->triangles.size() / 100;  // a look at a head takes time linear in its facets
    }
  }

  AttackResult run(double seconds) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point began = Clock::now();
    std::vector<std::size_t> bounded;
    for (std::size_t i = 0; i < claims_.size(); ++i)
      if (allowed_mm(i)) bounded.push_back(i);
    AttackResult result;
    result.moves = bounded.size();
    if (bounded.empty()) return result;
    const auto is_over = [&] {
      const double spent = std::chrono::duration<double>(Clock::now() - began).count();
      return result.samples >= bounded.size() && (seconds > 0 ? spent >= seconds : result.samples >= most(bounded));
    };
    while (!is_over() && !result.found) {
      const bool is_turn = result.samples < bounded.size();
      const std::size_t move = bounded[is_turn ? result.samples : draws_.below(bounded.size())];
      ++result.samples;
      result.found = look_at(move, draws_.below(4) == 0 ? static_cast<double>(draws_.below(2)) : draws_.share());
    }
    return result;
  }

 private:
  static std::size_t most(const std::vector<std::size_t>& bounded) { return bounded.size() + kMoreSamples; }

  /// What the claim says no point is deeper than; nothing where it says nothing.
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
    std::vector<Target> targets{{&tool.part, &parts_, allowed}, {&tool.fixture, &fixtures_, allowed}};
    if (claims_clean(claims_[move])) {
      targets.push_back({&tool.clearance, &parts_, scene_.resolution_mm});
      targets.push_back({&tool.clearance, &fixtures_, scene_.resolution_mm});
    }
    if (!scene_.heads.empty() && draws_.below(looks_per_head_) == 0) {
      targets.push_back({nullptr, &parts_, allowed});
      targets.push_back({nullptr, &fixtures_, allowed});
    }
    for (const Target& target : targets) {
      if (target.surface->root().size() == 0 || (target.contour != nullptr && target.contour->empty())) continue;
      if (auto found = attack(target, move, t)) return found;
    }
    return std::nullopt;
  }

  [[nodiscard]] double depth(const Target& target, std::size_t move, double t, const Vec3& point) const {
    if (target.contour == nullptr) return depth_in_heads(scene_, head_frame(scene_, move, t), point);
    const Pose pose = pose_at(scene_.path, move, t, scene_.is_dogleg);
    return -target.contour->nearest(in_tool(pose, point)).signed_distance_mm;
  }

  /// No point within `radius` of `center` is deeper.
  [[nodiscard]] double most_depth(const Target& target, std::size_t move, double t, const Vec3& center,
                                  double radius) const {
    if (target.contour != nullptr) return depth(target, move, t, center) + radius;
    const Vec3 q = head_frame(scene_, move, t).inverse().point(center);
    return radius - head_box_.exteriorDistance(q);
  }

  /// The triangles that come deepest at t, by nodes in the order of what they may hold.
  [[nodiscard]] std::vector<std::uint32_t> deepest(const Target& target, std::size_t move, double t) {
    constexpr std::size_t kLooks = 200, kTriangles = 3;
    using Entry = std::pair<double, std::pair<std::uint32_t, std::uint32_t>>;
    std::priority_queue<Entry> open;
    const TriangleOrder::Node root = target.surface->root();
    open.push({1e300, {root.first, root.last}});
    std::vector<std::uint32_t> found;
    for (std::size_t looks = 0; !open.empty() && looks < kLooks && found.size() < kTriangles; ++looks) {
      const TriangleOrder::Node node{open.top().second.first, open.top().second.second};
      open.pop();
      if (node.size() == 1) {
        found.push_back(node.first);
        continue;
      }
      for (const TriangleOrder::Node& half :
           {TriangleOrder::Node{node.first, node.middle()}, TriangleOrder::Node{node.middle(), node.last}}) {
        Vec3 center = Vec3::Zero();
        double radius = 0;
        if (half.size() == 1) {
          const std::array<Vec3, 3> c = target.surface->corners(half.first);
          center = (c[0] + c[1] + c[2]) / 3;
          for (const Vec3& p : c) radius = std::max(radius, (p - center).norm());
        } else {
          center = target.surface->extent(half).center;
          radius = target.surface->extent(half).half.norm();
        }
        const double most = most_depth(target, move, t, center, radius);
        if (most > target.allowed_mm) open.push({most, {half.first, half.last}});
      }
    }
    return found;
  }

  std::optional<Counterexample> attack(const Target& target, std::size_t move, double t) {
    for (const std::uint32_t triangle : deepest(target, move, t)) {
      const std::array<Vec3, 3> c = target.surface->corners(triangle);
      // The share of two corners and the instant: uphill in steps that shrink, from the best corner and the
      // middle.
      std::array<double, 3> best{1 / 3.0, 1 / 3.0, t};
      const auto point = [&](const std::array<double, 3>& at) {
        return Vec3(c[0] + at[0] * (c[1] - c[0]) + at[1] * (c[2] - c[0]));
      };
      const auto value = [&](const std::array<double, 3>& at) { return depth(target, move, at[2], point(at)); };
      double most = value(best);
      const auto take = [&](std::array<double, 3> at) {
        for (double& x : at) x = std::clamp(x, 0.0, 1.0);
        if (at[0] + at[1] > 1) return;
        const double here = value(at);
        if (here > most) {
          most = here;
          best = at;
        }
      };
      for (const auto& [a, b] : {std::pair(0.0, 0.0), std::pair(1.0, 0.0), std::pair(0.0, 1.0)}) take({a, b, t});
      const double finest = target.contour != nullptr ? 1e-4 : 0.05;
      for (double step = 0.25; step > finest; step /= 2)
        for (std::size_t k = 0; k < 3; ++k)
          for (const double way : {-step, step}) {
            std::array<double, 3> at = best;
            at[k] += way;
            take(at);
          }
      if (most > target.allowed_mm + kProofSlack_mm) {
        const std::string body = target.contour == nullptr ? "the head" : "the tool";
        return Counterexample{move, best[2], point(best),
                              "the surface is " + people_text(most, 6) + " mm deep in " + body +
                                  ", and claimed to be at most " + people_text(target.allowed_mm, 6) + " mm"};
      }
    }
    return std::nullopt;
  }

  const ClaimedScene& scene_;
  const ClaimedTools& tools_;
  const std::vector<MoveClaim>& claims_;
  TriangleOrder parts_, fixtures_;
  Box3 head_box_;
  std::size_t looks_per_head_ = 4;
  Draws draws_;
};

}  // namespace

AttackResult attack_claims(const ClaimedScene& scene, const ClaimedTools& tools, const std::vector<MoveClaim>& claims,
                           double seconds) {
  return Attack(scene, tools, claims).run(seconds);
}

}  // namespace gouge
