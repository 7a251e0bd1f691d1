#include "lib/head/check_heads.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "lib/base/parallel.h"
#include "lib/base/tolerance.h"
#include "lib/check/check_path.h"
#include "lib/check/reach.h"
#include "lib/check/sweep_filter.h"
#include "lib/check/verdict_bytes.h"
#include "lib/head/head_search.h"
#include "lib/motion/motion_law.h"

namespace gouge {
namespace {

constexpr std::size_t kMovesPerChunk = 64;
constexpr std::uint64_t kMaxBounds = 100'000;

void decide(MoveState state, Reason reason, MoveVerdict& verdict) {
  verdict.state = state;
  verdict.reason = std::move(reason);
  verdict.clearance_mm.reset();
}

void decide_side(const SideResult& outcome, MoveVerdict& verdict) {
  if (outcome.side == Side::inside) decide(MoveState::buried, {Reason::Kind::buried, Body::head}, verdict);
  if (outcome.side == Side::unknown)
    decide(MoveState::not_certified, {Reason::Kind::side_unknown, Body::head, 0, outcome.why}, verdict);
}

Reason reason_of(const MeshLimit& limit, double depth_mm) {
  const bool has_clearance = limit.clearance_mm > 0;
  return {has_clearance ? Reason::Kind::mesh_clearance_entered : Reason::Kind::mesh_tolerance_exceeded, Body::head,
          depth_mm};
}

bool is_open_to_judgement(const MoveVerdict& verdict) {
  return verdict.state == MoveState::clean || verdict.state == MoveState::near_miss;
}

// Rejects a move: it becomes not checked, so it is not clean. A gouge of the tool stays a gouge.
void refuse(Reason::Kind reason, MoveVerdict& verdict) {
  if (verdict.state != MoveState::gouge && verdict.state != MoveState::not_checked) verdict = not_checked({reason});
}

/// Returns the positions of the heads at the start and at the end of a move. Requires a motion that is defined.
std::pair<RigidTransform, RigidTransform> ends_of(const Toolpath& toolpath, std::size_t move, const MotionLaw& law) {
  const Motion motion = law.of(toolpath, move);
  const BodyMotion moving(motion);
  return {moving.at(0), moving.at(1)};
}

}  // namespace

HeadChecker::HeadChecker(const std::vector<HeadBody>& heads, const PreparedScene& scene)
    : HeadChecker(heads, scene, scene.obstacles()) {}

HeadChecker::HeadChecker(const std::vector<HeadBody>& heads, const PreparedScene& scene, Against against)
    : HeadChecker(heads, scene, {&scene.obstacle(against), 1}) {}

HeadChecker::HeadChecker(const std::vector<HeadBody>& heads, const PreparedScene& scene,
                         std::span<const PreparedObstacle> obstacles)
    : heads_(heads), sides_(scene.sides()), obstacles_(obstacles) {
  Group all;
  for (const PreparedObstacle& obstacle : obstacles_) all.targets.push_back({&obstacle.tree, 0});
  groups_.push_back(std::move(all));
  for (const LimitedMesh& mesh : scene.limited_meshes()) {
    const bool is_asked = mesh.obstacle >= obstacles_.data() && mesh.obstacle < obstacles_.data() + obstacles_.size();
    if (is_asked) groups_.push_back({{{mesh.tree, mesh.limit.clearance_mm}}, mesh.limit});
  }
}

double HeadChecker::Group::tolerance_mm(const CheckOptions& options) const {
  return limit ? std::min(limit->tolerance_mm, options.tolerance_mm) : options.tolerance_mm;
}

std::uint64_t HeadChecker::check(const Motion& motion, const CheckOptions& options, MoveVerdict& verdict) const {
  std::vector<double> uppers_mm;
  const std::uint64_t bounds = sweep(motion, options, verdict, uppers_mm);
  if (is_open_to_judgement(verdict)) look_inside(motion, uppers_mm, verdict);
  return bounds;
}

std::uint64_t HeadChecker::sweep(const Motion& motion, const CheckOptions& options, MoveVerdict& verdict,
                                 std::vector<double>& uppers_mm) const {
  MoveVerdict* const of = &verdict;
  std::uint64_t bounds = 0;
  sweep_all({&motion, 1}, options, {&of, 1}, {&uppers_mm, 1}, {&bounds, 1});
  return bounds;
}

// Sweeps the other motions without those that are rejected, which would spoil the bounds they share.
void HeadChecker::sweep_all(std::span<const Motion> motions, const CheckOptions& options,
                            std::span<MoveVerdict* const> verdicts, std::span<std::vector<double>> uppers_mm,
                            std::span<std::uint64_t> bounds) const {
  std::vector<Motion> fit;
  std::vector<std::size_t> index;
  for (std::size_t m = 0; m < motions.size(); ++m) {
    uppers_mm[m].clear();
    bounds[m] = 0;
    if (const Reason::Kind unfit = why_unfit(motions[m]); unfit != Reason::Kind::none) {
      refuse(unfit, *verdicts[m]);
      continue;
    }
    fit.push_back(motions[m].alone());
    index.push_back(m);
    if (auto other = motions[m].other()) {
      fit.push_back(*std::move(other));
      index.push_back(m);
    }
  }
  std::vector<HeadResult> results(fit.size());
  for (const HeadBody& head : heads_) {
    for (const Group& group : groups_) {
      search_group(group, head, fit, options, results);
      for (std::size_t k = 0; k < fit.size(); ++k) {
        const std::size_t m = index[k];
        bounds[m] += results[k].bounds;
        const bool is_other = k > 0 && index[k - 1] == m;
        if (!group.limit && is_other) uppers_mm[m].back() = std::max(uppers_mm[m].back(), results[k].depth_upper_mm);
        if (!group.limit && !is_other) uppers_mm[m].push_back(results[k].depth_upper_mm);
        join(results[k], group, options, fit[k], *verdicts[m]);
      }
    }
  }
  for (std::size_t m = 0; m < motions.size(); ++m) {
    const bool is_checked = verdicts[m]->state != MoveState::not_checked;
    if (motions[m].is_any() && is_checked && !uppers_mm[m].empty())
      bounds[m] += check_any_turn(motions[m], options, *verdicts[m], uppers_mm[m]);
  }
}

void HeadChecker::search_group(const Group& group, const HeadBody& head, std::span<const Motion> motions,
                               const CheckOptions& options, std::span<HeadResult> results, double reach_mm) const {
  const SearchGoal goal{group.tolerance_mm(options), options.resolution_mm,
                        std::max(options.resolution_mm, options.gouge_gap_mm),
                        std::min(kMaxBounds, options.budget_per_move)};
  const bool is_covered = !head.cover.pieces.empty();
  std::vector<HeadTarget> farther = group.targets;
  for (HeadTarget& target : farther) target.reach_mm += reach_mm;
  std::vector<SweptMove> swept;
  if (is_covered) {
    std::vector<CoverTarget> targets;
    for (const HeadTarget& target : farther) targets.push_back({&head.cover, target.tree, nullptr, target.reach_mm});
    swept = sweep_covers(motions, targets, {goal, 0});
  }
  for (std::size_t k = 0; k < motions.size(); ++k) {
    const BodyMotion moving(motions[k]);
    results[k] = is_covered ? search_head(moving, head, farther, goal, swept[k].start)
                            : search_head(moving, head, farther, goal);
    if (is_covered) results[k].bounds += swept[k].bounds;
  }
}

double HeadChecker::excess_at(const Pose& pose, const MotionLaw& law, double allowed_mm, double accuracy_mm,
                              std::uint64_t& bounds) const {
  CheckOptions options;
  options.tolerance_mm = allowed_mm;
  options.resolution_mm = accuracy_mm;
  MoveVerdict verdict;
  bounds += check(law.at(pose), options, verdict);
  // Beyond the limit of a mesh, a gouge may be shallower than the depth that is permitted elsewhere.
  if (verdict.state == MoveState::gouge)
    return verdict.depth_mm > allowed_mm ? verdict.depth_mm - allowed_mm : verdict.depth_mm;
  return verdict.state == MoveState::clean ? 0 : std::numeric_limits<double>::infinity();
}

void HeadChecker::join(const HeadResult& found, const Group& group, const CheckOptions& options, const Motion& motion,
                       MoveVerdict& verdict) const {
  const double tolerance_mm = group.tolerance_mm(options);
  verdict.depth_upper_mm = std::max(verdict.depth_upper_mm, found.depth_upper_mm);
  const bool is_gouge = found.depth_mm > tolerance_mm;
  const bool is_open = found.depth_upper_mm > tolerance_mm + options.resolution_mm;
  const bool is_worse = found.has_witness && found.depth_mm > verdict.depth_mm;
  const bool is_taken = is_gouge ? is_worse || verdict.state != MoveState::gouge : is_worse;
  if (is_taken) {
    take(found, group, verdict);
    verdict.witness->turn = motion.shares_at(found.t);
  }
  if (is_gouge) {
    verdict.state = MoveState::gouge;
    verdict.clearance_mm.reset();
    if (!group.limit) verdict.reason = {};
    if (group.limit && is_taken) verdict.reason = reason_of(*group.limit, verdict.depth_mm);
  } else if (is_open && verdict.state != MoveState::gouge && verdict.state != MoveState::buried) {
    verdict.state = MoveState::not_certified;
    verdict.reason = {Reason::Kind::head_out_of_budget};
  }
}

void HeadChecker::take(const HeadResult& found, const Group& group, MoveVerdict& verdict) const {
  const BlockTree& tree = *group.targets[found.target].tree;
  verdict.depth_mm = found.depth_mm;
  Witness w;
  w.t = found.t;
  w.point = found.point;
  w.normal = found.normal;
  w.body = Body::head;
  w.against = group.limit ? group.limit->against : obstacles_[found.target].rule.against;
  w.mesh = static_cast<std::uint32_t>((group.limit ? group.limit->mesh : 0) + tree.mesh_of(found.triangle));
  w.triangle = tree.file_triangle(found.triangle);
  verdict.witness = w;
}

/// Decides whether a head is inside a solid. No surface comes as deep into the head as its cores lie, so each core
/// stays on one side during the whole move.
void HeadChecker::look_inside(const Motion& motion, const std::vector<double>& uppers_mm, MoveVerdict& verdict) const {
  const RigidTransform at = BodyMotion(motion).at(0);
  for (std::size_t h = 0; h < heads_.size() && verdict.state != MoveState::buried; ++h) {
    for (std::size_t k = 0; k < heads_[h].cores.size() && verdict.state != MoveState::buried; ++k) {
      if (heads_[h].core_depths_mm[k] <= uppers_mm[h]) {
        decide(MoveState::not_certified, {Reason::Kind::head_too_thin}, verdict);
      } else {
        decide_side(sides_.side_of({{at.point(heads_[h].cores[k])}, {motion.start().axis}}), verdict);
      }
    }
  }
}

void HeadChecker::mark_buried(const Toolpath& toolpath, const CheckOptions& options, const HeadUppers& uppers_mm,
                              MoveVerdicts& verdicts) const {
  std::vector<std::pair<std::size_t, std::size_t>> cores;  // pairs of head and core
  for (std::size_t h = 0; h < heads_.size(); ++h) {
    for (std::size_t k = 0; k < heads_[h].cores.size(); ++k) cores.emplace_back(h, k);
  }
  const auto core = [&](std::size_t c) -> const Vec3& { return heads_[cores[c].first].cores[cores[c].second]; };
  const auto is_free = [&](std::size_t i, std::size_t c) {
    const auto [h, k] = cores[c];
    return uppers_mm.is_swept(i) && uppers_mm.of(i, h) < heads_[h].core_depths_mm[k];
  };
  FreeChains chains(sides_, verdicts.size() * cores.size());
  RigidTransform before;
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    if (!uppers_mm.is_swept(i)) continue;
    const auto [start, end] = ends_of(toolpath, i, options.law);
    for (std::size_t c = 0; c < cores.size(); ++c) {
      if (!is_free(i, c)) continue;
      chains.add(i * cores.size() + c, end.point(core(c)));
      if (i == 0 || !toolpath.moves[i].has_start) continue;
      chains.add(i * cores.size() + c, start.point(core(c)));
      // A law may turn a head about the tool axis between two moves.
      const bool goes_on =
          is_free(i - 1, c) && (start.point(core(c)) - before.point(core(c))).norm() < Tolerance::kSamePoint_mm;
      if (goes_on) chains.join(i * cores.size() + c, (i - 1) * cores.size() + c);
    }
    before = end;
  }
  const auto is_asked = [&](std::size_t item) { return is_free(item / cores.size(), item % cores.size()); };
  chains.decide(
      options.threads,
      [&](std::size_t item) {
        const std::size_t i = item / cores.size();
        const RigidTransform end = ends_of(toolpath, i, options.law).second;
        return ConnectedPoints{{end.point(core(item % cores.size()))}, {toolpath.moves[i].end.axis}};
      },
      is_asked);
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    if (!uppers_mm.is_swept(i) || !is_open_to_judgement(verdicts[i])) continue;
    for (std::size_t c = 0; c < cores.size() && verdicts[i].state != MoveState::buried; ++c) {
      if (!is_free(i, c)) {
        decide(MoveState::not_certified, {Reason::Kind::head_too_thin}, verdicts[i]);
      } else {
        decide_side(chains.result(i * cores.size() + c), verdicts[i]);
      }
    }
  }
}

namespace {

// Checks the heads on the straight path to a single position; check_path checks the tool.
void check_links(const Toolpath& toolpath, const HeadChecker& checker, const CheckOptions& options,
                 MoveVerdicts& verdicts) {
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    const std::optional<Motion> link = options.law.link_of(toolpath, i);
    if (!link || !is_open_to_judgement(verdicts[i])) continue;
    MoveVerdict verdict;
    std::vector<double> uppers_mm;
    checker.sweep(*link, options, verdict, uppers_mm);
    if (verdict.state == MoveState::clean) continue;
    verdicts[i] = not_checked(link_reason(toolpath, i));
  }
}

/// Result of the heads' search for one move.
struct HeadStep {
  std::uint64_t bounds = 0;
  std::vector<double> uppers_mm;
  MoveVerdict verdict;
};

}  // namespace

void check_heads(const Toolpath& toolpath, const std::vector<HeadBody>& heads, const PreparedScene& scene,
                 const CheckOptions& options, CheckResult& result, const ProgressCall& progress,
                 CheckpointStore* kept) {
  if (heads.empty()) return;
  const Reason::Kind unfit = scene.is_within_reach ? why_unfit(options) : Reason::Kind::out_of_reach;
  if (unfit != Reason::Kind::none) {
    for (MoveVerdict& verdict : result.verdicts) refuse(unfit, verdict);
    return;
  }
  const HeadChecker checker(heads, scene);
  PagedVector<std::uint64_t> bounds(result.verdicts.size(), 0);
  HeadUppers uppers_mm(result.verdicts.size(), heads.size());
  const auto sweep = [&](std::size_t first, std::size_t last) {
    std::vector<std::size_t> moves;
    std::vector<Motion> motions;
    std::vector<MoveVerdict*> verdicts;
    for (std::size_t i = first; i < last; ++i) {
      if (result.verdicts[i].state == MoveState::not_checked) continue;
      moves.push_back(i);
      motions.push_back(options.law.of(toolpath, i));
      verdicts.push_back(&result.verdicts[i]);
    }
    std::vector<std::vector<double>> uppers_of(moves.size());
    std::vector<std::uint64_t> spent(moves.size(), 0);
    checker.sweep_all(motions, options, verdicts, uppers_of, spent);
    for (std::size_t k = 0; k < moves.size(); ++k) {
      bounds[moves[k]] = spent[k];
      uppers_mm.set(moves[k], uppers_of[k]);
    }
  };
  CheckpointForm form;
  form.write = [&](std::size_t first, std::size_t last) {
    std::string bytes;
    for (std::size_t i = first; i < last; ++i) {
      append_bytes(bounds[i], bytes);
      for (std::size_t h = 0; h < heads.size(); ++h) append_bytes(uppers_mm.of(i, h), bytes);
      append_bytes(result.verdicts[i], bytes);
    }
    return bytes;
  };
  form.read = [&](std::size_t first, std::size_t last, std::string_view bytes) {
    std::vector<HeadStep> read(last - first);
    bool is_whole = true;
    for (HeadStep& step : read) {
      step.uppers_mm.resize(heads.size());
      is_whole = is_whole && take_bytes(bytes, step.bounds);
      for (double& upper : step.uppers_mm) is_whole = is_whole && take_bytes(bytes, upper);
      is_whole = is_whole && take_bytes(bytes, step.verdict) && is_of_meshes(step.verdict, *scene.scene);
    }
    if (!is_whole || !bytes.empty()) return false;
    for (std::size_t i = first; i < last; ++i) {
      HeadStep& step = read[i - first];
      bounds[i] = step.bounds;
      uppers_mm.set(i, step.uppers_mm);
      result.verdicts[i] = std::move(step.verdict);
    }
    return true;
  };
  for_each_checkpointed_chunk(result.verdicts.size(), kMovesPerChunk, options.threads, "checking heads", progress, kept,
                              form, sweep);
  checker.mark_buried(toolpath, options, uppers_mm, result.verdicts);
  check_links(toolpath, checker, options, result.verdicts);
  for (const std::uint64_t b : bounds) result.evaluations += b;
}

}  // namespace gouge
