#include "lib/verify/outside_check.h"

#include <algorithm>
#include <map>

#include "lib/mesh/opposite_half_edges.h"

namespace gouge {
namespace {

Box3 box_around(std::span<const IndexedMesh> meshes) {
  Box3 box;
  for (const IndexedMesh& mesh : meshes) box.extend(mesh.box());
  return box;
}

/// Stretches of the axis that are deeper in the tool than `min_mm`. Each stretch was sampled with steps shorter than
/// the excess depth of the point before, so all of it is deeper.
using Stretches = std::vector<std::pair<double, double>>;

Stretches deep_stretches(const ToolContour& tool, double min_mm) {
  Stretches all;
  double top = 0;
  for (const ToolContour::Piece& p : tool.pieces()) top = std::max(top, p.z_hi());
  const double shortest = 1e-4 * top;
  bool is_open = false;
  for (double z = 0; z < top;) {
    const double spare = -tool.nearest({0, z}).signed_distance_mm - min_mm;
    if (spare > shortest) {
      if (!is_open) all.emplace_back(z, z);
      all.back().second = z;
      z += 0.99 * spare;
      is_open = true;
    } else {
      z += shortest;
      is_open = false;
    }
  }
  return all;
}

/// Returns whether a stretch reaches into every body.
bool covers_bodies(const ToolContour& tool, const Stretches& stretches) {
  for (const Body body : {Body::cutter, Body::shank, Body::holder}) {
    double lo = 1e300, hi = -1e300;
    for (const ToolContour::Piece& p : tool.pieces()) {
      if (p.body != body) continue;
      lo = std::min(lo, p.z_lo());
      hi = std::max(hi, p.z_hi());
    }
    const bool is_covered = lo > hi || std::any_of(stretches.begin(), stretches.end(),
                                                   [&](const auto& s) { return s.first < hi && lo < s.second; });
    if (!is_covered) return false;
  }
  return true;
}

class OutsideChecker {
 public:
  OutsideChecker(const ClaimedScene& scene, const ClaimedTools& tools, const std::vector<MoveClaim>& claims)
      : scene_(scene), tools_(tools), claims_(claims), boxes_{box_around(scene.parts), box_around(scene.fixtures)} {}

  OutsideCheck run() {
    for (std::size_t i = 0; i < claims_.size();) {
      if (!is_examined(i)) {
        ++i;
        continue;
      }
      std::size_t end = i + 1;
      while (end < claims_.size() && is_examined(end) && is_continued(end)) ++end;
      examine(i, end);
      i = end;
    }
    return std::move(result_);
  }

 private:
  [[nodiscard]] bool is_examined(std::size_t i) const {
    const std::size_t tool = scene_.path.moves[i].tool;
    return claims_clean(claims_[i]) && tool < tools_.size() && tools_[tool];
  }
  [[nodiscard]] bool is_continued(std::size_t i) const {
    const Move& move = scene_.path.moves[i];
    return (move.has_start || move.is_linked) && move.tool == scene_.path.moves[i - 1].tool;
  }

  const Stretches& stretches(std::size_t tool) {
    const auto [at, is_new] = stretches_.try_emplace(tool);
    if (is_new) {
      at->second = deep_stretches(tools_[tool]->bare, scene_.largest_clean_mm());
      if (!covers_bodies(tools_[tool]->bare, at->second)) at->second.clear();
    }
    return at->second;
  }

  [[nodiscard]] bool is_beyond(const std::pair<double, double>& stretch, std::size_t first, std::size_t last,
                               const Box3& box) const {
    for (std::size_t i = first; i < last; ++i) {
      const Pose& pose = scene_.path.moves[i].end;
      for (const double z : {stretch.first, stretch.second})
        if (box.isEmpty() || !box.contains(pose.tip + z * pose.axis)) return true;
    }
    return false;
  }

  void examine(std::size_t first, std::size_t last) {
    const std::size_t count = last - first;
    const Stretches& deep = stretches(scene_.path.moves[first].tool);
    if (deep.empty()) {
      result_.unexamined += count;
      return;
    }
    bool is_proved = true;
    for (const auto& stretch : deep) {
      for (const std::size_t kind : {0U, 1U}) {
        if (is_beyond(stretch, first, last, boxes_[kind])) continue;
        is_proved = false;
        const Pose& pose = scene_.path.moves[first].end;
        const Vec3 point = pose.tip + stretch.second * pose.axis;
        if (!is_inside(kind == 0 ? scene_.parts : scene_.fixtures, point)) continue;
        result_.refuted.push_back({first, 1, point, "the tool is inside a solid, and claimed to be outside"});
        return;
      }
    }
    (is_proved ? result_.proved : result_.sampled) += count;
  }

  const ClaimedScene& scene_;
  const ClaimedTools& tools_;
  const std::vector<MoveClaim>& claims_;
  std::array<Box3, 2> boxes_;
  std::map<std::size_t, Stretches> stretches_;
  OutsideCheck result_;
};

}  // namespace

OutsideCheck check_outside(const ClaimedScene& scene, const ClaimedTools& tools, const std::vector<MoveClaim>& claims) {
  return OutsideChecker(scene, tools, claims).run();
}

}  // namespace gouge
