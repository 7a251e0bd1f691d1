#include "lib/check/buried.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>

#include "lib/base/tolerance.h"
#include "lib/check/check_options.h"
#include "lib/check/scene_sides.h"
#include "lib/tool/free_regions.h"

namespace gouge {
namespace {

/// The regions of one tool, for depths that several moves share.
class ToolRegions {
 public:
  ToolRegions(const CompiledTool& tool, double usual_mm, int halvings)
      : finder_(tool), usual_mm_(usual_mm), finest_(std::min(kFinest, -halvings)) {}

  /// Returns the regions for a depth of at least `depth_mm`; for exactly `depth_mm` if a body would have no point at
  /// the larger depth. The result stays valid.
  const FreeRegions& at(double depth_mm) {
    const FreeRegions& rounded = stored(rounded_up(depth_mm));
    return rounded.covers_all() || depth_mm > usual_mm_ ? rounded : stored(depth_mm);
  }

 private:
  [[nodiscard]] double rounded_up(double depth_mm) const {
    if (!(depth_mm > 0) || !(usual_mm_ > 0) || std::isinf(depth_mm)) return std::max(depth_mm, 0.0);
    const int power =
        std::max(finest_, static_cast<int>(std::ceil(2 * std::log2(depth_mm / usual_mm_) - Tolerance::kRounding)));
    return std::max(depth_mm, usual_mm_ * std::exp2(0.5 * power));
  }
  const FreeRegions& stored(double depth_mm) {
    std::unique_ptr<FreeRegions>& slot = stored_[depth_mm];
    if (!slot) slot = std::make_unique<FreeRegions>(finder_.at(depth_mm));
    return *slot;
  }

  static constexpr int kFinest = -6;

  RegionFinder finder_;
  double usual_mm_;
  int finest_;  // exponent of the finest shared depth; a tool with less certified depth has regions of that depth
  std::map<double, std::unique_ptr<FreeRegions>> stored_;
};

class BuriedMarker {
 public:
  BuriedMarker(const Toolpath& toolpath, const std::vector<const ToolVariants*>& tools, const PreparedScene& scene,
               const CheckOptions& options, MoveVerdicts& verdicts)
      : toolpath_(toolpath), tools_(tools), scene_(scene), options_(options), verdicts_(verdicts) {}

  void mark() {
    find_regions();
    FreeChains chains(scene_.sides(), first_.back());
    for (std::size_t i = 0; i < verdicts_.size(); ++i) add(i, chains);
    chains.decide(options_.threads, [this](std::size_t item) { return points_of(item); });
    for (std::size_t i = 0; i < verdicts_.size(); ++i) {
      const MoveState state = verdicts_[i].state;
      if (state == MoveState::clean || state == MoveState::near_miss || is_thin_feature(verdicts_[i])) judge(i, chains);
    }
  }

 private:
  [[nodiscard]] bool is_proved(std::size_t i) const {
    const MoveState state = verdicts_[i].state;
    return is_thin_feature(verdicts_[i]) || (state != MoveState::not_checked && state != MoveState::not_certified);
  }

  void find_regions() {
    std::map<std::size_t, ToolRegions*> by_tool;
    regions_.assign(verdicts_.size(), nullptr);
    first_.assign(verdicts_.size() + 1, 0);
    for (std::size_t i = 0; i < verdicts_.size(); ++i) {
      if (is_proved(i)) {
        const std::size_t tool = toolpath_.moves[i].tool;
        ToolRegions*& own = by_tool[tool];
        if (own == nullptr) {
          const CertifiedDepth sure = certified_depth(*tools_[tool], scene_, options_);
          own_regions_.push_back(std::make_unique<ToolRegions>(
              tools_[tool]->bare, options_.tolerance_mm + options_.resolution_mm, sure.halvings));
          own = own_regions_.back().get();
        }
        regions_[i] = &own->at(verdicts_[i].depth_upper_mm);
      }
      first_[i + 1] = first_[i];
      if (regions_[i] != nullptr) first_[i + 1] += static_cast<std::uint32_t>(regions_[i]->regions.size());
    }
  }

  void add(std::size_t i, FreeChains& chains) const {
    if (regions_[i] == nullptr) return;
    const Move& move = toolpath_.moves[i];
    const bool has_start = move.has_start && i > 0;
    if (has_start) join_with_previous(i, chains);
    // The previous move added the same regions at its end, which is the start of this one.
    const bool is_start_new = has_start && regions_[i - 1] != regions_[i];
    add_points(i, move.end, chains);
    if (is_start_new) add_points(i, toolpath_.start_of(i), chains);
  }

  // The final pose of a move is the first pose of the next move.
  void join_with_previous(std::size_t i, FreeChains& chains) const {
    if (regions_[i - 1] == nullptr || toolpath_.moves[i - 1].tool != toolpath_.moves[i].tool) return;
    const std::vector<FreeRegion>&own = regions_[i]->regions, &before = regions_[i - 1]->regions;
    for (std::size_t k = 0; k < own.size(); ++k) {
      for (std::size_t l = 0; l < before.size(); ++l) {
        if (own[k].meets(before[l])) chains.join(first_[i] + k, first_[i - 1] + l);
      }
    }
  }

  void add_points(std::size_t i, const Pose& pose, FreeChains& chains) const {
    const std::vector<FreeRegion>& own = regions_[i]->regions;
    for (std::size_t k = 0; k < own.size(); ++k) {
      if (chains.is_settled(first_[i] + k)) continue;
      for (const Vec3& point : points_at(pose, own[k])) chains.add(first_[i] + k, point);
    }
  }

  /// A few points, without memory of their own: millions of moves have some.
  struct FewPoints {
    std::array<Vec3, 4> all;
    std::size_t count = 0;
    [[nodiscard]] const Vec3* begin() const { return all.data(); }
    [[nodiscard]] const Vec3* end() const { return all.data() + count; }
  };

  /// Returns points of a region at a pose: the deepest point, and both ends of a stretch or four points of a ring.
  static FewPoints points_at(const Pose& pose, const FreeRegion& region) {
    const Vec3 middle = pose.tip + region.deepest.y() * pose.axis;
    if (region.ring == FreeRegion::kNoRing) {
      constexpr double kWithin = 0.999;
      const double z = region.deepest.y();
      return {{middle, middle + kWithin * (region.z_hi_mm - z) * pose.axis,
               middle + kWithin * (region.z_lo_mm - z) * pose.axis},
              3};
    }
    const Vec3 e1 = pose.axis.unitOrthogonal(), e2 = pose.axis.cross(e1);
    const double r = region.deepest.x();
    return {{middle + r * e1, middle - r * e1, middle + r * e2, middle - r * e2}, 4};
  }

  [[nodiscard]] ConnectedPoints points_of(std::size_t item) const {
    const auto after = std::upper_bound(first_.begin(), first_.end(), item);
    const auto i = static_cast<std::size_t>(after - first_.begin()) - 1;
    const Pose& pose = toolpath_.moves[i].end;
    const FewPoints points = points_at(pose, regions_[i]->regions[item - first_[i]]);
    return {{points.begin(), points.end()}, {pose.axis}};
  }

  void judge(std::size_t i, FreeChains& chains) {
    const FreeRegions& found = *regions_[i];
    MoveVerdict& verdict = verdicts_[i];
    std::optional<Reason> unknown;
    for (std::size_t k = 0; k < found.regions.size(); ++k) {
      const FreeRegion& region = found.regions[k];
      const SideResult& outcome = chains.result(first_[i] + k);
      if (outcome.side == Side::outside) continue;
      const Body body = body_of(i, region);
      // If the tolerance lets the surface come far into the tool, the move is neither buried nor clean.
      if (outcome.side == Side::inside && 2 * verdict.depth_upper_mm <= region.depth_mm) {
        verdict.state = MoveState::buried;
        verdict.reason = {Reason::Kind::buried, body};
        return;
      }
      if (unknown) continue;
      unknown = outcome.side == Side::inside ? Reason{Reason::Kind::body_too_thin, body}
                                             : Reason{Reason::Kind::side_unknown, body, 0, outcome.why};
    }
    if (!unknown && found.covers_all() && !found.regions.empty()) return;
    verdict.state = MoveState::not_certified;
    verdict.reason = unknown.value_or(Reason{Reason::Kind::body_too_thin, found.uncovered()});
    verdict.clearance_mm.reset();
  }

  /// Returns the cutter if the region reaches down to it; else the lowest body in the region.
  [[nodiscard]] Body body_of(std::size_t i, const FreeRegion& region) const {
    Body lowest = Body::holder;
    for (const BoundaryElement& e : tools_[toolpath_.moves[i].tool]->bare.elements) {
      const bool is_at = std::min(e.a.y(), e.b.y()) <= region.z_hi_mm && std::max(e.a.y(), e.b.y()) >= region.z_lo_mm;
      if (is_at && e.body < lowest) lowest = e.body;
    }
    return lowest;
  }

  const Toolpath& toolpath_;
  const std::vector<const ToolVariants*>& tools_;
  const PreparedScene& scene_;
  const CheckOptions& options_;
  MoveVerdicts& verdicts_;
  std::vector<std::unique_ptr<ToolRegions>> own_regions_;
  PagedVector<const FreeRegions*> regions_;  // for each move; null without a proof
  PagedVector<std::uint32_t> first_;         // for each move: the number of its first region
};

}  // namespace

bool is_thin_feature(const MoveVerdict& verdict) {
  return verdict.state == MoveState::not_certified && verdict.reason.is(Reason::Kind::thin_feature);
}

void mark_buried(const Toolpath& toolpath, const std::vector<const ToolVariants*>& tools, const PreparedScene& scene,
                 const CheckOptions& options, MoveVerdicts& verdicts) {
  BuriedMarker(toolpath, tools, scene, options, verdicts).mark();
}

}  // namespace gouge
