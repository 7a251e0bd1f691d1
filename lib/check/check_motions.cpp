#include "lib/check/check_motions.h"

#include <algorithm>
#include <cmath>

#include "lib/check/check_options.h"
#include "lib/check/reach.h"
#include "lib/check/search_witness.h"
#include "lib/check/sweep_filter.h"
#include "lib/tool/evaluate.h"

namespace gouge {
namespace {

using Targets = std::vector<SearchTarget>;

// Share of the resolution by which the cutter may be less deep than a body of its radius and still be named.
constexpr double kTieShare = 0.1;
constexpr std::uint64_t kTieBudget = 20'000;  // number of bounds to find such a point of the cutter

/// Returns one target for each obstacle, which is compared with the tool form `form_of(rule)`.
template <typename FormOf>
Targets targets_of(const ToolVariants& tool, const PreparedScene& scene, const FormOf& form_of) {
  Targets targets;
  targets.reserve(scene.obstacles().size());
  for (const PreparedObstacle& obstacle : scene.obstacles())
    targets.push_back(target_on(tool.*form_of(obstacle.rule), obstacle));
  return targets;
}

Targets whole_tool(const ToolVariants& tool, const PreparedScene& scene) {
  Targets targets = targets_of(tool, scene, [](const ContactRule& rule) { return rule.form; });
  for (const LimitedMesh& mesh : scene.limited_meshes())
    if (mesh.limit.clearance_mm > 0) targets.push_back(target_on(tool.bare, mesh));
  return targets;
}

/// A limit that is stricter than the tolerance of the check.
struct StrictLimit {
  Targets targets;
  double tolerance_mm = 0;
  const MeshLimit* of_mesh = nullptr;  ///< null: the limit is the clearances of bodies
};

SearchTarget limited_target(const ToolVariants& tool, const LimitedMesh& mesh) {
  return target_on(mesh.limit.clearance_mm > 0 ? tool.bare : tool.*mesh.obstacle->rule.form, mesh);
}

Targets clearance_bodies(const ToolVariants& tool, const PreparedScene& scene) {
  return targets_of(tool, scene, [](const ContactRule& /*rule*/) { return &ToolVariants::with_clearance; });
}

Targets watched_bodies(const ToolVariants& tool, const PreparedScene& scene, MoveKind kind) {
  const bool is_cutting = kind != MoveKind::rapid;
  return targets_of(tool, scene,
                    [&](const ContactRule& rule) { return is_cutting ? rule.form_beside_cuts : rule.form; });
}

std::vector<StrictLimit> strict_limits(const ToolVariants& tool, const PreparedScene& scene,
                                       const CheckOptions& options) {
  std::vector<StrictLimit> all;
  if (!tool.with_clearance.elements.empty()) all.push_back({clearance_bodies(tool, scene), 0, nullptr});
  for (const LimitedMesh& mesh : scene.limited_meshes()) {
    const bool is_stricter = mesh.limit.tolerance_mm < options.tolerance_mm;
    if (is_stricter) all.push_back({{limited_target(tool, mesh)}, mesh.limit.tolerance_mm, &mesh.limit});
  }
  return all;
}

SearchQuery query(const CheckOptions& options, double reach, double tolerance) {
  const double gap = options.gouge_gap_mm > 0 ? options.gouge_gap_mm : options.resolution_mm;
  return {{tolerance, options.resolution_mm, gap, options.budget_per_move}, reach};
}

/// Results of the wide sweep for one move, one for each query; null if the query was not run.
struct Swept {
  const SweptMove* depth = nullptr;
  std::vector<const SweptMove*> limits{};  ///< one for each strict limit, or empty
  const SweptMove* near_miss = nullptr;
};

class MoveChecker {
 public:
  MoveChecker(const Motion& motion, MoveKind kind, const ToolVariants& tool, const PreparedScene& scene,
              const CheckOptions& options, const Targets& whole, std::span<const StrictLimit> limits,
              const Swept& swept)
      : motion_(motion),
        kind_(kind),
        tool_(tool),
        scene_(scene),
        options_(options),
        whole_(whole),
        limits_(limits),
        swept_(swept) {}

  MoveVerdict run() {
    const SearchResult depth = finish(whole_, 0, options_.tolerance_mm, swept_.depth);
    set_depth(depth, whole_);
    // The witness decides, computed as any reader of the file would: the search may differ from it in the last digits.
    const bool is_deep = verdict_.depth_mm > options_.tolerance_mm;
    if (!is_deep && verdict_.depth_upper_mm > options_.tolerance_mm + options_.resolution_mm) is_decided_ = false;
    if (is_deep) {
      verdict_.state = MoveState::gouge;
      name_cutter(depth);
    } else {
      for (std::size_t k = 0; k < limits_.size() && verdict_.state != MoveState::gouge; ++k) check_limit(k, depth);
    }
    if (!is_decided_ && verdict_.state != MoveState::gouge) give_up();
    if (!is_decided_ && verdict_.state == MoveState::gouge) verdict_.reason = out_of_budget();
    if (verdict_.state == MoveState::clean && !options_.is_depth_alone) check_reach();
    if (verdict_.state == MoveState::clean && options_.near_miss_mm > 0) check_near_miss();
    return verdict_;
  }

  [[nodiscard]] std::uint64_t bounds() const { return bounds_; }

 private:
  SearchResult finish(const Targets& targets, double reach, double tolerance, const SweptMove* swept) {
    if (swept == nullptr) return ask(targets, reach, tolerance);
    const SearchResult outcome = search_move(motion_, targets, query(options_, reach, tolerance), swept->start);
    bounds_ += outcome.bounds + swept->bounds;
    is_decided_ = is_decided_ && outcome.is_decided;
    return outcome;
  }

  SearchResult ask(const Targets& targets, double reach, double tolerance) {
    const SearchResult outcome = sweep_and_search(motion_, targets, query(options_, reach, tolerance));
    bounds_ += outcome.bounds;
    is_decided_ = is_decided_ && outcome.is_decided;
    return outcome;
  }

  void set_depth(const SearchResult& outcome, const Targets& targets) {
    verdict_.depth_mm = 0;
    verdict_.depth_upper_mm = outcome.value_upper_mm;
    verdict_.witness.reset();
    if (!outcome.has_witness) return;
    const SearchTarget& target = targets[outcome.at.target];
    const ToolPoint position = locate(motion_, outcome);
    const ToolDistance at = evaluate(*target.tool, position.r, position.z);
    if (!(at.signed_distance_mm < target.reach_mm)) return;
    verdict_.depth_mm = target.reach_mm - at.signed_distance_mm;
    verdict_.depth_upper_mm = std::max(verdict_.depth_upper_mm, verdict_.depth_mm);
    verdict_.witness = make_witness(motion_, outcome, target, position, at);
    verdict_.reason = {};
    if (target.reach_mm > 0)
      verdict_.reason = {Reason::Kind::mesh_clearance_entered, verdict_.witness->body, verdict_.depth_mm};
  }

  // Names the cutter where it is as deep as a shank of its radius at the same instant, for example beside a wall. The
  // depth stays within its bounds.
  void name_cutter(const SearchResult& outcome) {
    if (!verdict_.witness || verdict_.witness->body == Body::cutter) return;
    const SearchTarget& target = whole_[outcome.at.target];
    const double tie = kTieShare * options_.resolution_mm;
    const ToolPoint above = locate(motion_, outcome);
    const BoundaryElement& element = target.tool->elements[evaluate(*target.tool, above.r, above.z).element];
    if (target.reach_mm > 0 || std::abs(element.a.x() - tool_.cutting.r_max_mm) > tie) return;
    const double upper_allows = verdict_.depth_upper_mm - query(options_, 0, 0).gap_mm;
    const double least = std::max(verdict_.depth_mm - tie, std::min(verdict_.depth_mm, upper_allows));
    const SearchTarget cutter{&tool_.cutting, target.tree, target.against, 0, target.first_mesh};
    SearchResult found =
        sweep_and_search(MotionLaw::tool_at(above.pose), {cutter}, {{least - tie, tie, tie, kTieBudget}, 0});
    bounds_ += found.bounds;
    if (!found.has_witness) return;
    found.t = outcome.t;
    const ToolPoint position = locate(motion_, found);
    const ToolDistance at = evaluate(*target.tool, position.r, position.z);
    if (target.tool->elements[at.element].body != Body::cutter || -at.signed_distance_mm < least) return;
    verdict_.depth_mm = -at.signed_distance_mm;
    verdict_.depth_upper_mm = std::max(verdict_.depth_upper_mm, verdict_.depth_mm);
    verdict_.witness = make_witness(motion_, found, target, position, at);
  }

  // A depth beyond a strict limit is a gouge, so the whole depth is then computed to the resolution.
  void check_limit(std::size_t index, const SearchResult& depth) {
    const StrictLimit& limit = limits_[index];
    const SweptMove* swept = swept_.limits.empty() ? nullptr : swept_.limits[index];
    const SearchResult entered = finish(limit.targets, 0, limit.tolerance_mm, swept);
    if (!entered.has_witness) return;
    const SearchTarget& target = limit.targets[entered.at.target];
    const ToolPoint position = locate(motion_, entered);
    const double depth_mm = target.reach_mm - signed_distance_mm(*target.tool, position.r, position.z);
    if (!(depth_mm > limit.tolerance_mm)) {
      // The tool touches, and apart from rounding no point is beyond the limit.
      if (entered.value_upper_mm > limit.tolerance_mm + options_.resolution_mm) is_decided_ = false;
      return;
    }
    const bool is_closed = depth.value_upper_mm - depth.value_mm <= options_.resolution_mm;
    const SearchResult closed = is_closed ? depth : ask(whole_, 0, 0);
    set_depth(closed, whole_);
    verdict_.state = MoveState::gouge;
    show_limit(limit, entered);
  }

  // A body beyond its limit is the evidence, although another body may be deeper within the tolerance.
  void show_limit(const StrictLimit& limit, const SearchResult& entered) {
    const SearchTarget& target = limit.targets[entered.at.target];
    const ToolPoint position = locate(motion_, entered);
    const ToolDistance at = evaluate(*target.tool, position.r, position.z);
    const CompiledTool& whole_form = limit.of_mesh == nullptr ? tool_.*rule_of(target.against).form : *target.tool;
    const double depth = target.reach_mm - signed_distance_mm(whole_form, position.r, position.z);
    verdict_.reason = {reason_of(limit), target.tool->elements[at.element].body, entered.value_mm};
    if (!(depth > 0)) return;
    verdict_.depth_mm = depth;
    verdict_.witness = make_witness(motion_, entered, target, position, at);
  }

  static Reason::Kind reason_of(const StrictLimit& limit) {
    if (limit.of_mesh == nullptr) return Reason::Kind::clearance_entered;
    return limit.of_mesh->clearance_mm > 0 ? Reason::Kind::mesh_clearance_entered
                                           : Reason::Kind::mesh_tolerance_exceeded;
  }

  // Within the tolerance, a blade or a pointed tool may still reach far into a solid. For such a tool a smaller depth
  // must be proved (docs/method/inside_outside.md, section 4).
  void check_reach() {
    const CertifiedDepth sure = certified_depth(tool_, scene_, options_);
    if (verdict_.depth_upper_mm <= sure.depth_mm) return;
    const double share = std::exp2(-0.5 * sure.halvings);
    SearchQuery less = query(options_, 0, share * options_.tolerance_mm);
    less.resolution_mm *= share;
    less.gap_mm = kAnyGap_mm;
    // If no depth is certain, the surface must be proved to keep clear of the tool.
    if (!(sure.depth_mm > 0))
      less = {{0, 0.5 * options_.resolution_mm, kAnyGap_mm, less.budget}, options_.resolution_mm};
    const SearchResult outcome = sweep_and_search(motion_, whole_, less);
    bounds_ += outcome.bounds;
    const double upper = std::max(0.0, outcome.value_upper_mm - less.reach_mm);
    if (outcome.value_mm <= less.tolerance_mm && outcome.is_decided) {
      verdict_.depth_upper_mm = std::max(verdict_.depth_mm, std::min(verdict_.depth_upper_mm, upper));
      return;
    }
    verdict_.state = MoveState::not_certified;
    verdict_.reason = outcome.value_mm > less.tolerance_mm
                          ? Reason{Reason::Kind::thin_feature, Body::cutter, sure.reach_mm}
                          : out_of_budget();
  }

  void give_up() {
    verdict_.state = MoveState::not_certified;
    verdict_.reason = out_of_budget();
  }

  [[nodiscard]] Reason out_of_budget() const {
    return {Reason::Kind::out_of_budget, Body::cutter, static_cast<double>(options_.budget_per_move)};
  }

  void check_near_miss() {
    const Targets watched = watched_bodies(tool_, scene_, kind_);
    const SearchResult outcome = finish(watched, options_.near_miss_mm, 0, swept_.near_miss);
    if (!outcome.has_witness) {
      if (!is_decided_) give_up();
      return;
    }
    verdict_.state = MoveState::near_miss;
    if (!is_decided_) verdict_.reason = out_of_budget();
    verdict_.clearance_mm = std::max(0.0, options_.near_miss_mm - outcome.value_mm);
    if (verdict_.witness) return;
    const ToolPoint position = locate(motion_, outcome);
    // The surface may be in the tool, but no deeper than the tolerance: there the check for gouges stopped.
    const SearchTarget all = whole_[outcome.at.target];
    const ToolDistance in_all = evaluate(*all.tool, position.r, position.z);
    const SearchTarget& target = in_all.signed_distance_mm < 0 ? all : watched[outcome.at.target];
    verdict_.witness = make_witness(motion_, outcome, target, position, evaluate(*target.tool, position.r, position.z));
    verdict_.depth_mm = std::max(verdict_.depth_mm, -in_all.signed_distance_mm);
    verdict_.depth_upper_mm = std::max(verdict_.depth_upper_mm, verdict_.depth_mm);
  }

  const Motion& motion_;
  MoveKind kind_;
  const ToolVariants& tool_;
  const PreparedScene& scene_;
  const CheckOptions& options_;
  const Targets& whole_;
  std::span<const StrictLimit> limits_;
  Swept swept_;
  MoveVerdict verdict_;
  bool is_decided_ = true;
  std::uint64_t bounds_ = 0;
};

// Returns why the motion cannot be checked in this scene with these options; Kind::none if it can.
Reason::Kind why_not(const Motion& motion, const ToolVariants& tool, const PreparedScene& scene,
                     const CheckOptions& options) {
  if (!scene.is_within_reach) return Reason::Kind::out_of_reach;
  if (const Reason::Kind unfit = why_unfit(tool); unfit != Reason::Kind::none) return unfit;
  const Reason::Kind unfit = why_unfit(options);
  return unfit == Reason::Kind::none ? why_unfit(motion) : unfit;
}

// Sweeps the other motions without those that cannot be checked, which would spoil the bounds they share.
void check_fit_moves(std::span<const Motion> motions, std::span<const MoveKind> kinds, const ToolVariants& tool,
                     const PreparedScene& scene, const CheckOptions& options, std::span<MoveVerdict> verdicts,
                     std::span<std::uint64_t> bounds) {
  std::vector<std::size_t> near;
  std::vector<Motion> near_motions;
  std::vector<MoveKind> near_kinds;
  for (std::size_t m = 0; m < motions.size(); ++m) {
    if (const Reason::Kind reason = why_not(motions[m], tool, scene, options); reason != Reason::Kind::none) {
      verdicts[m] = not_checked({reason});
      continue;
    }
    near.push_back(m);
    near_motions.push_back(motions[m]);
    near_kinds.push_back(kinds[m]);
  }
  std::vector<MoveVerdict> found(near.size());
  std::vector<std::uint64_t> spent(near.size(), 0);
  if (!near.empty()) check_motions(near_motions, near_kinds, tool, scene, options, found, spent);
  for (std::size_t k = 0; k < near.size(); ++k) {
    verdicts[near[k]] = std::move(found[k]);
    bounds[near[k]] += spent[k];
  }
}

}  // namespace

void check_motions(std::span<const Motion> motions, std::span<const MoveKind> kinds, const ToolVariants& tool,
                   const PreparedScene& scene, const CheckOptions& options, std::span<MoveVerdict> verdicts,
                   std::span<std::uint64_t> bounds) {
  const bool are_fit = scene.is_within_reach && why_unfit(options) == Reason::Kind::none &&
                       why_unfit(tool) == Reason::Kind::none &&
                       std::all_of(motions.begin(), motions.end(),
                                   [](const Motion& motion) { return why_unfit(motion) == Reason::Kind::none; });
  if (!are_fit) return check_fit_moves(motions, kinds, tool, scene, options, verdicts, bounds);
  const Targets whole = whole_tool(tool, scene);
  const std::vector<StrictLimit> limits = strict_limits(tool, scene, options);
  std::vector<std::vector<SweptMove>> beyond;  // one for each limit
  std::vector<SweptMove> near_feed, near_rapid;
  const SearchQuery deep = query(options, 0, options.tolerance_mm);
  const std::vector<SweptMove> depth = sweep_moves(motions, whole, deep);
  // If all motions gouge, no further result is needed.
  const bool is_verdict_final =
      std::ranges::all_of(depth, [&](const SweptMove& swept) { return deep.is_met_by(swept.start.value_mm); });
  for (std::size_t k = 0; k < limits.size() && !is_verdict_final; ++k)
    beyond.push_back(sweep_moves(motions, limits[k].targets, query(options, 0, limits[k].tolerance_mm)));
  if (!is_verdict_final && options.near_miss_mm > 0) {
    const SearchQuery near = query(options, options.near_miss_mm, 0);
    const auto is_rapid = [](MoveKind kind) { return kind == MoveKind::rapid; };
    if (!std::ranges::all_of(kinds, is_rapid))
      near_feed = sweep_moves(motions, watched_bodies(tool, scene, MoveKind::feed), near);
    if (std::ranges::any_of(kinds, is_rapid))
      near_rapid = sweep_moves(motions, watched_bodies(tool, scene, MoveKind::rapid), near);
  }
  for (std::size_t m = 0; m < motions.size(); ++m) {
    Swept swept{&depth[m]};
    for (const std::vector<SweptMove>& of_limit : beyond) swept.limits.push_back(&of_limit[m]);
    if (const std::vector<SweptMove>& near = kinds[m] == MoveKind::rapid ? near_rapid : near_feed; !near.empty())
      swept.near_miss = &near[m];
    MoveChecker checker(motions[m], kinds[m], tool, scene, options, whole, limits, swept);
    verdicts[m] = checker.run();
    bounds[m] += checker.bounds();
  }
}

}  // namespace gouge
