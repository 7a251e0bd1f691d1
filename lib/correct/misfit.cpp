#include "lib/correct/misfit.h"

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <utility>

#include "lib/base/parallel.h"
#include "lib/check/sweep_filter.h"
#include "lib/correct/motion_checker.h"
#include "lib/geom/rigid_transform.h"

namespace gouge {
namespace {

constexpr std::size_t kFewestPositions = 4, kMostPositions = 200, kPositionsPerChunk = 8;
constexpr double kAsDeepAsRadius = 0.98;  // depth saturates at the radius, and is known to the resolution
constexpr double kTouchShare = 0.1;       // of the radius: how far off or deep a position may be that touches
constexpr double kTouch_mm = 0.1;         // at least
constexpr double kAccuracy_mm = 0.01;
constexpr std::uint64_t kBudget = 50'000;
constexpr double kSuspicious = 0.1;  // this share of deep positions is looked into
constexpr double kExplains = 0.8;   // this share of the positions must touch, ...
constexpr double kMoreThanIs = 0.3;  // ... this much more than without the change
constexpr double kMmPerInch = 25.4;

using Positions = std::vector<std::size_t>;  // moves
using PoseChange = std::function<Pose(const Pose&, const ToolForms&)>;

struct Mistake {
  std::string without;
  PoseChange change;
};

class MisfitSearch {
 public:
  MisfitSearch(const Toolpath& path, const std::vector<const ToolForms*>& tools, const PreparedScene& scene,
               const CheckOptions& options)
      : path_(path), tools_(tools), scene_(scene), options_(options), checker_(scene, options, nullptr) {}

  std::optional<Misfit> run() const {
    for (const Positions& all : operations()) {
      const Positions some = spread(all);
      const std::size_t deep = count(some, [&](std::size_t move) { return is_deep(move); });
      if (static_cast<double>(deep) < kSuspicious * static_cast<double>(some.size())) continue;
      Misfit misfit;
      misfit.first_move = all.front();
      misfit.positions = some.size();
      misfit.deep = deep;
      misfit.share_touching = share_touching(some, scene_, [](const Pose& pose, const ToolForms&) { return pose; });
      explain(some, misfit);
      if (2 * deep > some.size() || misfit.explanation) return misfit;
    }
    return std::nullopt;
  }

 private:
  [[nodiscard]] bool is_cut(const Move& move) const {
    return move.kind != MoveKind::rapid && move.not_checked_reason.empty() && move.tool < tools_.size() &&
           tools_[move.tool] != nullptr && move.end.tip.cwiseAbs().maxCoeff() <= kFarthest_mm;
  }

  // In the order in which they begin.
  [[nodiscard]] std::vector<Positions> operations() const {
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> place;
    std::vector<Positions> all;
    for (std::size_t i = 0; i < path_.moves.size(); ++i) {
      const Move& move = path_.moves[i];
      if (!is_cut(move)) continue;
      const auto [found, is_new] = place.try_emplace({move.tool, move.operation}, all.size());
      if (is_new) all.emplace_back();
      all[found->second].push_back(i);
    }
    std::erase_if(all, [](const Positions& p) { return p.size() < kFewestPositions; });
    return all;
  }

  static Positions spread(const Positions& all) {
    const std::size_t wanted = std::min(all.size(), kMostPositions);
    Positions some;
    for (std::size_t k = 0; k < wanted; ++k) some.push_back(all[(2 * k + 1) * all.size() / (2 * wanted)]);
    return some;
  }

  std::size_t count(const Positions& moves, const std::function<bool(std::size_t)>& holds) const {
    std::vector<char> is_so(moves.size(), 0);
    for_each_chunk(moves.size(), kPositionsPerChunk, options_.threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k) is_so[k] = holds(moves[k]) ? 1 : 0;
    });
    return static_cast<std::size_t>(std::count(is_so.begin(), is_so.end(), 1));
  }

  [[nodiscard]] bool is_deep(std::size_t index) const {
    const Move& move = path_.moves[index];
    const ToolForms& tool = *tools_[move.tool];
    CheckOptions options = options_;
    options.tolerance_mm = kAsDeepAsRadius * tool.bare.core_depth_mm;
    options.near_miss_mm = 0;
    options.gouge_gap_mm = tool.bare.core_depth_mm;
    const SearchTarget part{&tool.against_part, &scene_.parts, Against::part};
    const SearchAnswer answer = sweep_and_search(Motion(move.end), {part},
                                                 {0, options.tolerance_mm, kAccuracy_mm, options.gouge_gap_mm, kBudget});
    return answer.value_mm > options.tolerance_mm || checker_.side_of(move.end, tool) == Side::inside;
  }

  double share_touching(const Positions& moves, const PreparedScene& scene, const PoseChange& change) const {
    const MotionChecker checker(scene, options_, nullptr);
    const std::size_t touching = count(moves, [&](std::size_t index) {
      const ToolForms& tool = *tools_[path_.moves[index].tool];
      const Pose pose = change(path_.moves[index].end, tool);
      const double reach = std::max(kTouch_mm, kTouchShare * tool.bare.core_depth_mm);
      const SearchTarget part{&tool.against_part, &scene.parts, Against::part};
      const SearchAnswer answer =
          sweep_and_search(Motion(pose), {part}, {reach, 0, kAccuracy_mm, kAccuracy_mm, kBudget});
      return answer.has_witness && answer.value_mm <= 2 * reach && checker.side_of(pose, tool) != Side::inside;
    });
    return static_cast<double>(touching) / static_cast<double>(moves.size());
  }

  static std::vector<Mistake> mistakes() {
    std::vector<Mistake> all;
    const auto axis = [&](const char* name, const Vec3& sign) {
      all.push_back({std::string("with ") + name + " negated", [sign](const Pose& p, const ToolForms&) {
                       return Pose{p.tip, p.axis.cwiseProduct(sign)};
                     }});
    };
    axis("I", {-1, 1, 1});
    axis("J", {1, -1, 1});
    axis("K", {1, 1, -1});
    axis("the whole tool axis", {-1, -1, -1});
    for (const double sign : {-1.0, 1.0}) {
      all.push_back({sign < 0 ? "with the positions read as the centre of the cutter's end instead of its tip"
                              : "with the positions a cutter's radius higher along the tool axis",
                     [sign](const Pose& p, const ToolForms& tool) {
                       return Pose{p.tip + sign * tool.bare.core_depth_mm * p.axis, p.axis};
                     }});
    }
    const std::array<const char*, 3> names = {"X", "Y", "Z"};
    for (Eigen::Index k = 0; k < 3; ++k) {
      for (const int degrees : {90, 180, 270}) {
        // The part turned is the path turned back.
        Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
        Eigen::Matrix3d quarter = Eigen::AngleAxisd(-M_PI / 2, Vec3::Unit(k)).toRotationMatrix();
        quarter = quarter.array().round().matrix();
        for (int q = 0; q < degrees / 90; ++q) turn = quarter * turn;
        const RigidTransform back{turn, Vec3::Zero()};
        all.push_back({"with the part rotated by " + std::to_string(degrees) + " degrees about " +
                           names[static_cast<std::size_t>(k)],
                       [back](const Pose& p, const ToolForms&) { return back.pose(p); }});
      }
    }
    return all;
  }

  static Scene scaled(const Scene& scene, double factor) {
    Scene made{scene.parts, {}};
    for (IndexedMesh& mesh : made.parts) {
      for (Vec3& v : mesh.vertices) v *= factor;
    }
    return made;
  }

  void explain(const Positions& moves, Misfit& misfit) const {
    const auto take = [&misfit](const std::string& without, double share) {
      const double best = misfit.explanation ? misfit.explanation->share : 0;
      if (share >= kExplains && share >= misfit.share_touching + kMoreThanIs && share > best)
        misfit.explanation = Explanation{without, share};
    };
    for (const Mistake& mistake : mistakes()) take(mistake.without, share_touching(moves, scene_, mistake.change));
    for (const double factor : {kMmPerInch, 1 / kMmPerInch}) {
      const Scene other = scaled(*scene_.scene, factor);
      const PreparedScene prepared = prepare_scene(other, options_.threads);
      if (!prepared.is_within_reach) continue;
      take(factor > 1 ? "with the part 25.4 times as large, as if one of both were in inches"
                      : "with the part 25.4 times as small, as if one of both were in inches",
           share_touching(moves, prepared, [](const Pose& pose, const ToolForms&) { return pose; }));
    }
  }

  const Toolpath& path_;
  const std::vector<const ToolForms*>& tools_;
  const PreparedScene& scene_;
  const CheckOptions& options_;
  MotionChecker checker_;
};

}  // namespace

std::optional<Misfit> find_misfit(const Toolpath& path, const std::vector<const ToolForms*>& tools,
                                  const PreparedScene& scene, const CheckOptions& options) {
  if (scene.parts.nodes.empty() || !scene.is_within_reach) return std::nullopt;
  return MisfitSearch(path, tools, scene, options).run();
}

}  // namespace gouge
