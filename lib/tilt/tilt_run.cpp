#include "lib/tilt/tilt_run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "lib/base/parallel.h"
#include "lib/base/tolerance.h"
#include "lib/contact/contacts.h"
#include "lib/geom/shortest_turn.h"
#include "lib/path/path_info.h"
#include "lib/tilt/feed_directions.h"

namespace gouge {
namespace {

// Distances at which the cutter counts as touching: the stock of a finishing cut. If a run has no such contact, the
// stock of a roughing cut.
constexpr std::array kContacts_mm = {0.05, 1.0};
constexpr std::array kShares = {0.5, 0.8, 0.95};  // shares of the tolerance: how deep the cutter may be at a position
constexpr double kArm_mm = 10;                    // lever with which a turn of the programmed axis counts as arc length

/// A position of a chain before any measurement there.
struct Station {
  std::size_t move = 0;
  double t = 1;
  double arc_length_mm = 0;
  bool is_reached_clean = true;
};

/// A part of a chain, by arc length in mm.
struct Stretch {
  double begin_mm = 0, end_mm = 0;
  std::size_t first_move = 0, last_move = 0;
};

bool is_tiltable(const TiltJob& job, std::size_t i) {
  const Move& move = job.path.moves[i];
  const bool is_straight = move.kind == MoveKind::feed ||
                           (move.kind == MoveKind::rapid && job.checker.options().law.rapid() == RapidMode::straight);
  const MoveState state = job.result.verdicts[i].state;
  const bool is_verdict_final = state == MoveState::clean || state == MoveState::near_miss ||
                                state == MoveState::gouge || may_be_in_stock(job.result.verdicts[i]);
  return is_straight && is_verdict_final && move.curve_kind == CurveKind::none && move.not_checked_reason.empty() &&
         move.tool != kNone && job.tools[move.tool] != nullptr;
}

/// Moves of one tool. Each begins at the end of the one before.
class Chain {
 public:
  Chain(const TiltJob& job, std::size_t first, std::size_t last, const std::vector<bool>& is_near, double spacing_mm)
      : job_(job), last_move_(last - 1) {
    for (std::size_t i = first; i < last; ++i) add_stations(i, is_near[i] ? spacing_mm : 1e300);
  }

  void add_runs(std::vector<TiltRun>& runs) const {
    for (const Stretch& stretch : stretches()) runs.push_back(run_over(stretch));
  }

 private:
  void add_stations(std::size_t i, double spacing_mm) {
    const Move& move = job_.path.moves[i];
    const bool is_gouge = job_.is_wanted[i];
    if (!move.has_start) {
      stations_.push_back({i, 1, 0, !is_gouge});
      return;
    }
    if (stations_.empty()) stations_.push_back({i, 0, 0, true});
    const Motion motion = law().straight(job_.path.start_of(i), move.end);
    const double way = stations_.back().arc_length_mm;
    const double length = (motion.end().tip - motion.start().tip).norm() + kArm_mm * motion.turn_rad();
    const int pieces = 1 + static_cast<int>(length / spacing_mm);
    bool is_any = false;
    const std::size_t first = stations_.size();
    for (int k = 1; k <= pieces; ++k) {
      const double t = k == pieces ? 1.0 : static_cast<double>(k) / pieces;
      const Motion piece = law().straight(motion.at(t - 1.0 / pieces), motion.at(t));
      const bool is_clean =
          !is_gouge || (pieces > 1 && job_.checker_of(i).is_clean(piece, move.kind, *job_.tools[move.tool],
                                                                  job_.checker.options(), true));
      is_any = is_any || !is_clean;
      stations_.push_back({i, t, way + t * length, is_clean});
    }
    if (!is_gouge || is_any) return;
    for (std::size_t k = first; k < stations_.size(); ++k) stations_[k].is_reached_clean = false;
  }

  /// Returns the stretches that are not clean, extended by the blend on both sides. Overlapping ones are joined.
  [[nodiscard]] std::vector<Stretch> stretches() const {
    const double blend = job_.options.blend_mm;
    std::vector<Stretch> all;
    for (std::size_t k = 0; k < stations_.size(); ++k) {
      const Station& at = stations_[k];
      if (at.is_reached_clean) continue;
      const double begin = stations_[k > 0 ? k - 1 : 0].arc_length_mm - blend, end = at.arc_length_mm + blend;
      if (all.empty() || begin > all.back().end_mm) {
        all.push_back({begin, end, at.move, at.move});
      } else {
        all.back().end_mm = end;
        all.back().last_move = at.move;
      }
    }
    return all;
  }

  [[nodiscard]] TiltRun run_over(const Stretch& stretch) const {
    const auto by_way = [](const Station& station) { return station.arc_length_mm; };
    // Find the last station before the stretch and the first one after it.
    const auto behind = std::ranges::upper_bound(stations_, stretch.begin_mm + Tolerance::kSamePoint_mm, {}, by_way);
    const auto begin = behind == stations_.begin() ? behind : behind - 1;
    auto end = std::ranges::lower_bound(stations_, stretch.end_mm - Tolerance::kSamePoint_mm, {}, by_way);
    if (end == stations_.end()) --end;
    TiltRun run;
    run.tool = job_.path.moves[begin->move].tool;
    run.first_wanted = stretch.first_move;
    run.last_wanted = stretch.last_move;
    const Moves& moves = job_.path.moves;
    for (auto at = begin; at <= end; ++at) run.positions.push_back(position_at(*at, begin->arc_length_mm));
    const bool begins_path = !moves[begin->move].has_start;
    const bool ends_path =
        end + 1 == stations_.end() && (last_move_ + 1 == moves.size() || !moves[last_move_ + 1].has_start);
    if (!begins_path || is_clean_at(*begin)) run.positions.front().given = Tilt::Zero();
    if (!ends_path || is_clean_at(*end)) run.positions.back().given = Tilt::Zero();
    return run;
  }

  [[nodiscard]] const MotionLaw& law() const { return job_.checker.options().law; }

  [[nodiscard]] bool is_clean_at(const Station& station) const {
    const Move& move = job_.path.moves[station.move];
    return job_.checker_of(station.move)
        .is_clean(law().at(position_at(station, 0).programmed), move.kind, *job_.tools[move.tool],
                  job_.checker.options(), true);
  }

  [[nodiscard]] TiltPosition position_at(const Station& station, double begin_mm) const {
    const Move& move = job_.path.moves[station.move];
    TiltPosition at;
    at.move = station.move;
    at.origin = job_.origin_of(station.move);
    at.t = station.t;
    at.arc_length_mm = station.arc_length_mm - begin_mm;
    at.kind = move.kind;
    at.programmed = move.end;
    if (station.t < 1) at.programmed = law().straight(job_.path.start_of(station.move), move.end).at(station.t);
    at.is_reached_clean = station.is_reached_clean;
    return at;
  }

  const TiltJob& job_;
  std::size_t last_move_;
  std::vector<Station> stations_;
};

/// Returns the normal of the part where the cutter is in it or near it. A corner of the tool that touches a face has no
/// normal of its own. The face's normal counts there, if the tool is not deeper below the plane of the face.
Vec3 normal_at(const ToolContact& contact, double depth_mm, const Pose& pose, const CompiledTool& cutter) {
  constexpr double kSameDepth_mm = 0.01;
  const Vec3& face = contact.face;
  if (!(face.norm() > 0)) return contact.normal;
  const double along = -face.dot(pose.axis), away = (face + along * pose.axis).norm();
  const double reach = Vec2(away, along).dot(support_stretch(cutter, {away, along}).a);
  const double below = reach - face.dot(pose.tip - contact.point);
  return std::abs(below - depth_mm) <= kSameDepth_mm ? face : contact.normal;
}

/// Returns the normals at the contacts of the cutter, the deepest contact first. Returns none if nothing is that near.
/// One normal represents all similar ones.
std::vector<Vec3> contact_normals(const Pose& pose, const ToolVariants& tool, const BlockTree& parts,
                                  double within_mm) {
  constexpr double kSameNormal = 0.94, kAsDeep_mm = 0.05;
  constexpr std::size_t kMaxNormals = 4;
  std::vector<Vec3> normals;
  std::vector<ToolContact> contacts = find_contacts(pose, tool.cutting, parts, -within_mm);
  std::ranges::stable_sort(contacts, std::greater<>(), &ToolContact::excess_mm);
  for (const ToolContact& contact : contacts) {
    if (contact.excess_mm < contacts.front().excess_mm - kAsDeep_mm || normals.size() == kMaxNormals) break;
    const Vec3 normal = normal_at(contact, contact.excess_mm - within_mm, pose, tool.cutting);
    if (std::ranges::none_of(normals, [&](const Vec3& known) { return known.dot(normal) > kSameNormal; }))
      normals.push_back(normal);
  }
  return normals;
}

class Measurer {
 public:
  Measurer(const TiltJob& job, TiltRun& run) : job_(job), run_(run), tool_(*job.tools[run.tool]) {}

  void run() {
    each_position(
        [this](std::size_t i) { run_.positions[i].tolerance_share = share_at(run_.positions[i].programmed); });
    std::vector<std::vector<Vec3>> normals(run_.positions.size());
    for (const double within_mm : kContacts_mm) {
      each_position([&](std::size_t i) {
        const TiltPosition& at = run_.positions[i];
        if (at.kind != MoveKind::rapid)
          normals[i] = contact_normals(at.programmed, tool_, job_.checker.scene().workpiece_tree(), within_mm);
      });
      if (std::ranges::any_of(normals, [](const auto& some) { return !some.empty(); })) break;
    }
    set_pivots(normals);
    run_ = with_freedom(std::move(run_), job_.options.freedom);
  }

 private:
  void each_position(const std::function<void(std::size_t)>& what) const {
    for_each_chunk(run_.positions.size(), 4, job_.checker.options().threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) what(i);
    });
  }

  [[nodiscard]] double share_at(const Pose& pose) const {
    const double tolerance = job_.checker.options().tolerance_mm;
    const auto is_enough = [&](double share) {
      return largest_excess(pose, tool_.cutting, job_.checker.scene(), share * tolerance, Tolerance::kCorrection_mm) <=
             0;
    };
    const auto found = std::ranges::find_if(kShares, is_enough);
    return found == kShares.end() ? kShares.back() : *found;
  }

  /// Gives every position a pivot. A position without contact uses the nearest contact of the run. Otherwise the tip
  /// would leap where a contact begins or ends.
  void set_pivots(const std::vector<std::vector<Vec3>>& normals) {
    const std::size_t count = normals.size();
    std::vector<std::size_t> nearest(count, kNone);
    const auto spread = [&](std::size_t i, std::size_t& last) {
      if (!normals[i].empty()) last = i;
      const auto away = [&](std::size_t k) {
        return k == kNone ? 1e300 : std::abs(run_.positions[i].arc_length_mm - run_.positions[k].arc_length_mm);
      };
      if (away(last) < away(nearest[i])) nearest[i] = last;
    };
    std::size_t last = kNone;
    for (std::size_t i = 0; i < count; ++i) spread(i, last);
    last = kNone;
    for (std::size_t i = count; i-- > 0;) spread(i, last);
    for (std::size_t i = 0; i < count; ++i) {
      TiltPosition& at = run_.positions[i];
      at.pivot =
          ContactPivot(at.programmed, tool_.cutting, nearest[i] == kNone ? std::vector<Vec3>() : normals[nearest[i]]);
    }
  }

  const TiltJob& job_;
  TiltRun& run_;
  const ToolVariants& tool_;
};

}  // namespace

// The directions turn only as much as the axis turns. For a lead or side tilt the first one follows the feed.
TiltRun with_freedom(TiltRun run, TiltFreedom freedom) {
  std::vector<TiltPosition>& all = run.positions;
  Vec3 first = all.front().programmed.axis.unitOrthogonal();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Vec3& axis = all[i].programmed.axis;
    const Vec3& before = all[i > 0 ? i - 1 : 0].programmed.axis;
    first = shortest_turn(before, axis) * first;
    first = (first - first.dot(axis) * axis).normalized();
    all[i].first = first;
  }
  if (freedom != TiltFreedom::both) follow_feed(all);
  for (TiltPosition& at : all) at.second = at.programmed.axis.cross(at.first);
  return run;
}

std::vector<bool> moves_near(const Toolpath& path, const std::vector<bool>& is_wanted, double arc_length_mm) {
  constexpr double kFar_mm = 1e300;
  std::vector<bool> is_near = is_wanted;
  double away_mm = kFar_mm;
  const auto visit = [&](std::size_t i) {
    if (is_wanted[i]) {
      away_mm = 0;
    } else if (away_mm <= arc_length_mm) {
      is_near[i] = true;
      if (path.moves[i].has_start) away_mm += move_length_mm(path, i);
    }
  };
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    if (!path.moves[i].has_start) away_mm = kFar_mm;
    visit(i);
  }
  away_mm = kFar_mm;
  for (std::size_t i = path.moves.size(); i-- > 0;) {
    visit(i);
    if (!path.moves[i].has_start) away_mm = kFar_mm;
  }
  return is_near;
}

std::vector<TiltRun> find_tilt_runs(const TiltJob& job, double spacing_mm) {
  const std::vector<bool> is_near = moves_near(job.path, job.is_wanted, job.options.blend_mm);
  const Moves& moves = job.path.moves;
  std::vector<TiltRun> runs;
  for (std::size_t first = 0, last = 0; first < moves.size(); first = last) {
    last = first + 1;
    if (!is_tiltable(job, first)) continue;
    const auto continues = [&](std::size_t i) {
      return moves[i].has_start && is_tiltable(job, i) && moves[i].tool == moves[first].tool;
    };
    bool is_any = job.is_wanted[first];
    for (; last < moves.size() && continues(last); ++last) is_any = is_any || job.is_wanted[last];
    if (is_any) Chain(job, first, last, is_near, spacing_mm).add_runs(runs);
  }
  for (TiltRun& run : runs) Measurer(job, run).run();
  return runs;
}

}  // namespace gouge
