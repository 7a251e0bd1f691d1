#include "lib/check/path_fit.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "lib/base/parallel.h"
#include "lib/base/tolerance.h"
#include "lib/check/reach.h"
#include "lib/check/sweep_filter.h"
#include "lib/check/usual_mistakes.h"
#include "lib/mesh/indexed_mesh.h"
#include "lib/mesh/opposite_half_edges.h"

namespace gouge {
namespace {

constexpr std::size_t kFewestPositions = 10, kFewestChanged = 20;
constexpr std::size_t kMaxSamples = 128, kFirstSamples = 16;
constexpr double kGoldenRatio = 0.6180339887498949;
constexpr std::uint64_t kFitBudget = 20'000;
constexpr double kAccuracy = 0.2;  // share of the touching distance to which contact is computed
constexpr double kDeep = 0.9;      // share of the cutter's radius: an inclined ball is as deep as that when it is sunk
                                   // in to its centre
constexpr double kMost = 0.5;
constexpr double kSuspicious = 0.1;  // share of the positions; if more gouge, the path is suspicious
constexpr double kOften = 0.2;       // share of the positions changed by a mistake that must gouge with it ...
constexpr double kFewLeft = 0.2;     // ... and share of these that may still gouge without it
constexpr double kApart = 0.1;       // maximum share of the positions that touch
constexpr double kExplained = 0.75, kHopeful = 0.6, kStillGouging = 0.1;
constexpr double kMinRise_mm = 1;  // minimum shift along the axis that stock to leave does not explain
constexpr double kSameAxis = 1e-3;
constexpr std::size_t kInsideLooks = 16;

struct Sample {
  Pose pose;
  const ToolVariants* tool = nullptr;
  bool is_gouging = false;
};

enum class Contact { apart, touching, gouging };

/// Returns whether a verdict states how deep the cutter is in the part. It does not if another body is deeper or a head
/// is buried.
bool is_of_cutter(const MoveVerdict& verdict) {
  if (verdict.state == MoveState::buried) return verdict.reason.body != Body::head;
  return !verdict.witness || (verdict.witness->body == Body::cutter && rule_of(verdict.witness->against).is_workpiece);
}

// Returns the radius of the corner next to the tip; for a ball this is the radius of the ball; 0: no rounded corner.
double corner_radius_mm(const CompiledTool& tool) {
  const auto corner = std::find_if(tool.elements.begin(), tool.elements.end(), [](const BoundaryElement& e) {
    return e.kind == ElementKind::arc && e.body == Body::cutter && !e.is_reflex;
  });
  return corner == tool.elements.end() ? 0 : corner->radius_mm;
}

/// Returns the contact of the cutter alone: bodies above it may collide on a path that fits.
Contact contact_of(const Pose& pose, const ToolVariants& tool, const PreparedScene& scene) {
  const double touch = touch_mm(tool);
  const SearchTarget part = target_on(tool.cutting, scene.workpiece());
  const SearchResult result = sweep_and_search(MotionLaw::tool_at(pose), {part},
                                               {{0, kAccuracy * touch, kAccuracy * touch, kFitBudget}, touch});
  if (result.value_mm > 2 * touch) return Contact::gouging;
  return result.has_witness ? Contact::touching : Contact::apart;
}

bool is_core_inside(const Pose& pose, const ToolVariants& tool, const Scene& scene) {
  return is_inside(workpiece_of(scene), pose.tip + tool.bare.core.y() * pose.axis);
}

Scene scaled(const Scene& scene, double factor) {
  std::vector<IndexedMesh> meshes = workpiece_of(scene);
  for (IndexedMesh& mesh : meshes) {
    for (Vec3& vertex : mesh.vertices) vertex *= factor;
  }
  return scene_of_workpiece(std::move(meshes));
}

class FitFinder {
 public:
  FitFinder(const Toolpath& path, const MoveVerdicts& verdicts, const std::vector<const ToolVariants*>& tools,
            const PreparedScene& scene, unsigned threads)
      : path_(path), verdicts_(verdicts), tools_(tools), scene_(scene), threads_(threads) {}

  PathFit run() {
    gather();
    if (cuts_.size() < kFewestPositions || scene_.workpiece_tree().nodes.empty() || !scene_.is_within_reach)
      return fit_;
    if (is_too_deep()) fit_.kind = PathFit::Kind::too_deep;
    take_samples();
    const bool is_suspicious = static_cast<double>(fit_.gouging) >= kSuspicious * static_cast<double>(cuts_.size());
    const bool is_apart = !is_suspicious && touches_seldom();
    if (!is_suspicious && !is_apart) return fit_;
    explain(is_apart);
    if (fit_.explanation && fit_.kind == PathFit::Kind::fits)
      fit_.kind = is_apart ? PathFit::Kind::apart : PathFit::Kind::mistaken;
    return fit_;
  }

 private:
  struct Attempt {
    double share = 0;
    bool is_of_all = true;
  };

  void gather() {
    cuts_.reserve(path_.moves.size());
    std::vector<std::size_t> hidden;  // moves whose verdict does not state how deep the cutter is in the part
    for (std::size_t i = 0; i < path_.moves.size(); ++i) {
      const Move& move = path_.moves[i];
      const MoveVerdict& verdict = verdicts_[i];
      const bool is_cut = move.kind != MoveKind::rapid && move.tool < tools_.size() && tools_[move.tool] != nullptr &&
                          !tools_[move.tool]->cutting.elements.empty() && verdict.state != MoveState::not_checked &&
                          verdict.state != MoveState::not_certified;
      if (!is_cut) continue;
      cuts_.push_back(i);
      ++operations_[move.operation].first;
      if (is_of_cutter(verdict)) {
        count(i, is_deep(i), is_gouging(i));
      } else {
        hidden.push_back(i);
      }
    }
    measure_hidden(hidden);
    fit_.positions = cuts_.size();
  }

  void count(std::size_t move, bool is_deep, bool is_gouging) {
    fit_.deep += is_deep ? 1U : 0U;
    fit_.gouging += is_gouging ? 1U : 0U;
    operations_[path_.moves[move].operation].second += is_deep ? 1U : 0U;
  }

  /// Measures the cutter at some of these moves. Each result also counts for the moves since the previous one.
  void measure_hidden(const std::vector<std::size_t>& hidden) {
    const std::size_t stride = 1 + hidden.size() / kMaxSamples;
    for (std::size_t first = 0; first < hidden.size(); first += stride) {
      const std::size_t last = std::min(first + stride, hidden.size());
      const std::size_t measured = hidden[last - 1];
      const bool deep = is_cutter_deep(measured), gouging = deep || is_cutter_gouging(measured);
      for (std::size_t k = first; k < last; ++k) count(hidden[k], deep, gouging);
    }
  }

  /// Returns whether the cutter is deep. Requires is_of_cutter.
  [[nodiscard]] bool is_deep(std::size_t move) const {
    const MoveVerdict& verdict = verdicts_[move];
    return verdict.state == MoveState::buried ||
           verdict.depth_mm >= kDeep * tools_[path_.moves[move].tool]->bare.core_depth_mm;
  }

  [[nodiscard]] bool is_cutter_deep(std::size_t move) const {
    const Pose& pose = path_.moves[move].end;
    const ToolVariants& tool = *tools_[path_.moves[move].tool];
    // If no surface is near, the cutter may be deep inside.
    if (contact_of(pose, tool, scene_) == Contact::apart) return is_core_inside(pose, tool, *scene_.scene);
    const double deep = kDeep * tool.bare.core_depth_mm, gap = kAccuracy * deep;
    const SearchTarget part = target_on(tool.cutting, scene_.workpiece());
    return sweep_and_search(MotionLaw::tool_at(pose), {part}, {{deep, gap, gap, kFitBudget}, 0}).value_mm > deep;
  }

  [[nodiscard]] bool is_cutter_gouging(std::size_t move) const {
    return contact_of(path_.moves[move].end, *tools_[path_.moves[move].tool], scene_) == Contact::gouging;
  }

  /// Returns whether the cutter gouges. Requires is_of_cutter.
  [[nodiscard]] bool is_gouging(std::size_t move) const {
    const MoveVerdict& verdict = verdicts_[move];
    return verdict.state == MoveState::buried || verdict.depth_mm > touch_mm(*tools_[path_.moves[move].tool]);
  }

  [[nodiscard]] bool is_too_deep() const {
    const auto bad = std::count_if(operations_.begin(), operations_.end(), [](const auto& operation) {
      return static_cast<double>(operation.second.second) > kMost * static_cast<double>(operation.second.first);
    });
    return static_cast<double>(fit_.deep) > kMost * static_cast<double>(cuts_.size()) &&
           static_cast<double>(bad) > kMost * static_cast<double>(operations_.size());
  }

  void take_samples() {
    const std::size_t count = std::min(cuts_.size(), kMaxSamples);
    for (std::size_t k = 0; k < count; ++k) {
      const double at = 0.5 + kGoldenRatio * static_cast<double>(k);
      const auto n = static_cast<double>(cuts_.size());
      const std::size_t chosen = count == cuts_.size() ? k : static_cast<std::size_t>((at - std::floor(at)) * n);
      const std::size_t move = cuts_[std::min(chosen, cuts_.size() - 1)];
      const bool gouging = is_of_cutter(verdicts_[move]) ? is_gouging(move) : is_cutter_gouging(move);
      samples_.push_back({path_.moves[move].end, tools_[path_.moves[move].tool], gouging});
    }
  }

  [[nodiscard]] bool touches_seldom() const {
    std::size_t touching = 0;
    const std::size_t count = std::min(samples_.size(), 2 * kFirstSamples);
    for (std::size_t i = 0; i < count; ++i)
      touching += contact_of(samples_[i].pose, *samples_[i].tool, scene_) != Contact::apart ? 1U : 0U;
    return static_cast<double>(touching) <= kApart * static_cast<double>(count);
  }

  void explain(bool is_apart) {
    const std::vector<UndoneMistake> mistakes = usual_mistakes(path_.unit);
    std::vector<std::optional<Attempt>> attempts(mistakes.size());
    for_each_chunk(mistakes.size(), 1, threads_, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) attempts[i] = attempt(mistakes[i], is_apart);
    });
    for (std::size_t i = 0; i < mistakes.size(); ++i) {
      if (!attempts[i] || (fit_.explanation && attempts[i]->share <= fit_.explanation->share)) continue;
      fit_.explanation = PathFit::Explanation{mistakes[i].text, attempts[i]->share, attempts[i]->is_of_all};
    }
  }

  [[nodiscard]] std::optional<Attempt> attempt(const UndoneMistake& mistake, bool is_apart) const {
    const bool is_rise = std::abs(mistake.corner_radii) > 0;
    const bool is_fitting_else = fit_.kind == PathFit::Kind::fits && !is_apart;  // otherwise the path may be a shallow
                                                                                 // undercut
    std::vector<Sample> changed;
    std::size_t gouging = 0;
    for (const Sample& sample : samples_) {
      const double corner = corner_radius_mm(sample.tool->bare);
      if (is_rise && corner < std::max(kMinRise_mm, is_fitting_else ? 0.5 * sample.tool->bare.core_depth_mm : 0))
        continue;
      const Pose pose = mistake.pose(sample.pose, corner);
      const bool is_changed = (pose.tip - sample.pose.tip).norm() > touch_mm(*sample.tool) ||
                              (pose.axis - sample.pose.axis).norm() > kSameAxis || std::abs(mistake.part_scale - 1) > 0;
      if (!is_changed) continue;
      changed.push_back({pose, sample.tool, sample.is_gouging});
      gouging += sample.is_gouging ? 1U : 0U;
    }
    if (changed.size() < (is_fitting_else ? kFewestChanged : kFewestPositions) || !is_size_better(mistake))
      return std::nullopt;
    const bool is_needed = is_apart || static_cast<double>(gouging) >= kOften * static_cast<double>(changed.size());
    if (!is_needed) return std::nullopt;
    const double allowed = fit_.kind == PathFit::Kind::too_deep || is_apart
                               ? kStillGouging * static_cast<double>(changed.size())
                               : kFewLeft * static_cast<double>(gouging);
    const bool is_of_all = changed.size() == samples_.size();
    if (!(std::abs(mistake.part_scale - 1) > 0)) return try_at(changed, allowed, is_of_all, scene_);
    if (!is_hopeful(changed, mistake.part_scale)) return std::nullopt;
    const Scene other = scaled(*scene_.scene, mistake.part_scale);
    return try_at(changed, allowed, is_of_all, prepare_scene(other, 1));
  }

  // Returns whether the sizes of path and part agree better without the mistake; a part is about as large as the region
  // that is cut. The test is necessary because positions drawn together touch everything that one of them touches.
  [[nodiscard]] bool is_size_better(const UndoneMistake& mistake) const {
    const double scale = std::cbrt(std::abs(mistake.tip.determinant())) / mistake.part_scale;
    if (std::abs(scale - 1) < Tolerance::kRounding) return true;
    Box3 cuts;
    for (const std::size_t move : cuts_) cuts.extend(path_.moves[move].end.tip);
    const double ratio = cuts.diagonal().norm() / box_of(scene_.workpiece().meshes).diagonal().norm();
    return ratio > 0 && std::abs(std::log(ratio * scale)) < std::abs(std::log(ratio));
  }

  // Returns whether enough tips are near the scaled part. This quick test comes before a tree of the scaled part is
  // built.
  [[nodiscard]] bool is_hopeful(const std::vector<Sample>& samples, double part_scale) const {
    const Box3 box = box_of(scene_.workpiece().meshes);
    const Box3 scaled_box(Vec3(part_scale * box.min()), Vec3(part_scale * box.max()));
    const auto near = std::count_if(samples.begin(), samples.end(), [&](const Sample& sample) {
      const double reach = sample.tool->bare.r_max_mm + touch_mm(*sample.tool);
      return scaled_box.squaredExteriorDistance(sample.pose.tip) <= reach * reach;
    });
    return static_cast<double>(near) >= kHopeful * static_cast<double>(samples.size());
  }

  [[nodiscard]] static std::optional<Attempt> try_at(const std::vector<Sample>& samples, double gouging_allowed,
                                                     bool is_of_all, const PreparedScene& scene) {
    if (!scene.is_within_reach) return std::nullopt;
    std::vector<const Sample*> touching;
    std::size_t gouging = 0, next_look = kFirstSamples;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      if (i == next_look) {
        if (static_cast<double>(touching.size()) < kHopeful * static_cast<double>(i)) return std::nullopt;
        next_look *= 2;
      }
      const Vec3& tip = samples[i].pose.tip;
      if (!is_within_reach(tip)) return std::nullopt;
      const Contact contact = contact_of(samples[i].pose, *samples[i].tool, scene);
      if (contact == Contact::touching) touching.push_back(&samples[i]);
      gouging += contact == Contact::gouging ? 1U : 0U;
    }
    const auto count = static_cast<double>(samples.size());
    const double share = static_cast<double>(touching.size()) / count;
    if (share < kExplained || static_cast<double>(gouging) > gouging_allowed) return std::nullopt;
    const std::size_t looks = std::min(touching.size(), kInsideLooks);
    std::size_t inside = 0;
    for (std::size_t i = 0; i < looks; ++i)
      inside += is_core_inside(touching[i]->pose, *touching[i]->tool, *scene.scene) ? 1U : 0U;
    if (static_cast<double>(inside) > kStillGouging * static_cast<double>(looks)) return std::nullopt;
    return Attempt{share, is_of_all};
  }

  const Toolpath& path_;
  const MoveVerdicts& verdicts_;
  const std::vector<const ToolVariants*>& tools_;
  const PreparedScene& scene_;
  unsigned threads_;
  PathFit fit_;
  PagedVector<SmallIndex> cuts_;
  std::map<std::size_t, std::pair<std::size_t, std::size_t>> operations_;  // number of cuts, and number of cuts that
                                                                           // are too deep
  std::vector<Sample> samples_;
};

}  // namespace

double touch_mm(const ToolVariants& tool) { return std::clamp(0.05 * tool.bare.core_depth_mm, 0.02, 0.5); }

PathFit find_path_fit(const Toolpath& toolpath, const MoveVerdicts& verdicts,
                      const std::vector<const ToolVariants*>& tools, const PreparedScene& scene, unsigned threads) {
  return FitFinder(toolpath, verdicts, tools, scene, threads).run();
}

}  // namespace gouge
