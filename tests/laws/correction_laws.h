#pragma once

#include <algorithm>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "lib/certify/motion_checker.h"
#include "lib/correct/correct_path.h"
#include "lib/mesh/opposite_half_edges.h"
#include "lib/motion/motion_law.h"
#include "postproc/cldata/rewriting/list_written.h"
#include "tests/support/brute_force.h"

// The laws of a correction, compared with the corrected file as it is read and checked, by means of their own: which
// moves belong together, what the tool meets on a shift, how far a path is off. Nothing of lib/correct/laws.h is used.

namespace gouge::laws {

struct Corrected {
  const Toolpath* before = nullptr;
  const CheckResult* result_before = nullptr;
  const Toolpath* after = nullptr;
  const CheckResult* result_after = nullptr;
  const Correction* correction = nullptr;
  const CheckSetup* setup = nullptr;
  std::optional<double> max_side_shift_mm;
  double max_shift_mm = 20;
  double rapid_clearance_mm = 1;
  const CheckResult* in_stock = nullptr;  ///< that of the corrected path with stock; null: there is no stock
};

struct Figures {
  std::size_t changed = 0, left = 0, gouges_before = 0, gouges_after = 0;
  std::size_t kept_samples = 0, left_path_samples = 0;
  std::size_t listed_samples = 0;          // of left_path_samples, on moves that are listed as left
  std::size_t added = 0;                   // positions
  std::size_t uncut = 0;                   // stretches
  std::size_t rapids = 0, low_rapids = 0;  // that were written, and of these those listed
};

class LawBook {
 public:
  explicit LawBook(const Corrected& c)
      : c_(c), checker_(*c.setup), options_(c.setup->options), scene_(*c.setup->scene.scene) {
    changes_.resize(c.before->moves.size(), nullptr);
    for (const PathChange& change : c.correction->changes) changes_[change.move] = &change;
    std::size_t next = 0;
    for (std::size_t i = 0; i < changes_.size(); ++i) {
      first_.push_back(next);
      next += 1 + (changes_[i] != nullptr ? changes_[i]->inserted_before.size() : 0);
      // The steps of a hole that goes elsewhere.
      const bool goes_on = i > 0 && changes_[i] == nullptr && changes_[i - 1] != nullptr &&
                           changes_[i - 1]->hole_shift_mm && c.before->moves[i].kind == MoveKind::cycle &&
                           c.before->moves[i].statement == c.before->moves[i - 1].statement;
      if (goes_on) changes_[i] = changes_[i - 1];
    }
    first_.push_back(next);
  }

  /// Describes the broken law; empty: none.
  std::vector<std::string> broken(Figures& figures) {
    if (first_.back() != c_.after->moves.size()) return {"the corrected file has another number of moves"};
    for (std::size_t i = 0; i < changes_.size(); ++i) {
      nothing_worse(i);
      listed(i);
      left_to_the_byte(i);
      shift(i, figures);
      keeps_its_path(i, figures);
      rapids_keep_off(i, figures);
      no_rapid_plunges(i);
      const MoveState state = c_.result_before->verdicts[i].state;
      figures.gouges_before += state == MoveState::gouge ? 1U : 0U;
      for (std::size_t k = first_[i]; k < first_[i + 1]; ++k)
        figures.gouges_after += c_.result_after->verdicts[k].state == MoveState::gouge ? 1U : 0U;
    }
    nothing_written_but_what_is_listed();
    figures.changed += c_.correction->changes.size();
    figures.added += c_.after->moves.size() - c_.before->moves.size();
    figures.left += c_.correction->uncorrected.size();
    return std::move(broken_);
  }

 private:
  static constexpr double kRounding_mm = 2e-4;

  void say(char law, std::size_t i, const std::string& what) {
    broken_.push_back(std::string("(") + law + ") move " + std::to_string(i) + ", line " +
                      std::to_string(std::size_t{c_.before->moves[i].line}) + ": " + what);
  }

  static int rank(MoveState state) {
    return state == MoveState::clean ? 0 : state == MoveState::near_miss ? 1 : state == MoveState::gouge ? 2 : 3;
  }

  // (a) and (b)
  void nothing_worse(std::size_t i) {
    const MoveVerdict& was = c_.result_before->verdicts[i];
    for (std::size_t k = first_[i]; k < first_[i + 1]; ++k) {
      const MoveVerdict& is = c_.result_after->verdicts[k];
      if (rank(is.state) > rank(was.state))
        say(was.state == MoveState::clean ? 'a' : 'b', i,
            std::string(state_name(was.state)) + " became " + state_name(is.state));
      if (is.state == MoveState::gouge && was.state == MoveState::gouge && is.depth_mm > was.depth_upper_mm + 1e-9)
        say('b', i, "deeper: " + std::to_string(was.depth_mm) + " became " + std::to_string(is.depth_mm));
      if (is.state == MoveState::gouge) cuts_nothing_new(i, k);
      if (changes_[i] == nullptr || c_.after->moves[k].tool == kNone || ++looked_at_ % one_of(scene_) != 0) continue;
      const ToolVariants* tool = c_.setup->tools[c_.after->moves[k].tool];
      if (tool == nullptr || !c_.after->moves[k].not_checked_reason.empty()) continue;
      const double found = brute_force_depth(options_.law.of(*c_.after, k), *tool, scene_, 6, 0.2).depth_mm;
      const double allowed = was.state == MoveState::gouge ? was.depth_upper_mm : options_.tolerance_mm;
      if (found > allowed + 2 * options_.resolution_mm && was.state != MoveState::buried)
        say('b', i, "brute force finds " + std::to_string(found) + " after " + std::to_string(was.depth_mm));
    }
  }

  /// Returns whether a feed keeps its end, goes to new positions before it, and a rapid that no change touches begins
  /// there.
  bool returns_to_end(std::size_t i) const {
    return c_.before->moves[i].kind == MoveKind::feed && changes_[i] != nullptr && !changes_[i]->new_end &&
           !changes_[i]->inserted_before.empty() && i + 1 < changes_.size() && c_.before->moves[i + 1].has_start &&
           c_.before->moves[i + 1].kind == MoveKind::rapid;
  }

  // (b): what still gouges runs along the programmed motion, or straight between a new and the old place of an end;
  // anywhere else it may cut what it did not.
  void cuts_nothing_new(std::size_t i, std::size_t k) {
    const Move& old = c_.before->moves[i];
    if (!old.has_start || (old.kind != MoveKind::feed && old.kind != MoveKind::rapid) ||
        old.curve_kind != CurveKind::none)
      return;
    const auto off = [](const Vec3& p, const Vec3& a, const Vec3& b) {
      const double length2 = (b - a).squaredNorm();
      const double u = length2 > 0 ? std::clamp((p - a).dot(b - a) / length2, 0.0, 1.0) : 0.0;
      return (a + u * (b - a) - p).norm();
    };
    const Motion piece = options_.law.of(*c_.after, k);
    const Vec3 start = c_.before->start_of(i).tip, end = old.end.tip;
    const Vec3 new_start = c_.after->moves[first_[i] - 1].end.tip, new_end = c_.after->moves[first_[i + 1] - 1].end.tip;
    const Vec3 before_end = returns_to_end(i) ? c_.after->moves[first_[i + 1] - 2].end.tip : end;
    double farthest = 0;
    for (int s = 0; s <= 16; ++s) {
      const Vec3 tip = piece.at(s / 16.0).tip;
      farthest = std::max(farthest, std::min({off(tip, start, end), off(tip, new_start, start), off(tip, end, new_end),
                                              off(tip, before_end, end)}));
    }
    if (farthest > kRounding_mm + 0.01)
      say('b', i, "gouges still, " + std::to_string(farthest) + " mm off its programmed motion");
  }

  // Remaining gouges are listed, with a reason, and nothing else is.
  void listed(std::size_t i) {
    bool is_bad = false;
    const CheckResult& after = c_.in_stock != nullptr ? *c_.in_stock : *c_.result_after;
    for (std::size_t k = first_[i]; k < first_[i + 1]; ++k) {
      const MoveState state = after.verdicts[k].state;
      is_bad = is_bad || state == MoveState::gouge || state == MoveState::buried;
    }
    const auto& list = c_.correction->uncorrected;
    const auto found = std::count_if(list.begin(), list.end(), [&](const Uncorrected& u) {
      return u.move == i && !u.reason.empty() && u.is_changed == (changes_[i] != nullptr);
    });
    if (found != (is_bad ? 1 : 0)) say('c', i, is_bad ? "gouges and is not listed" : "is listed and does not gouge");
  }

  static std::string_view bytes(const Toolpath& path, std::size_t move) {
    const SourceStatement& span = path.statements[path.moves[move].statement];
    return std::string_view(path.source).substr(span.first_byte, span.last_byte - span.first_byte);
  }

  // A record of a move that no change touches is the same to the byte; what GODLTA and modal words need is its
  // neighbour's.
  void left_to_the_byte(std::size_t i) {
    if (changes_[i] != nullptr || c_.before->moves[i].statement == kNone) return;
    for (std::size_t k = 0; k < changes_.size(); ++k) {
      if (changes_[k] != nullptr && c_.before->moves[k].statement == c_.before->moves[i].statement) return;
    }
    if (bytes(*c_.before, i) != bytes(*c_.after, first_[i + 1] - 1)) say('c', i, "a record that is left was rewritten");
    if (c_.before->moves[i].end.tip != c_.after->moves[first_[i + 1] - 1].end.tip)
      say('c', i, "a position that is left moved");
  }

  // (c): without what is listed as changed or removed, and what as added, both files are the same statements.
  void nothing_written_but_what_is_listed() {
    const auto all = list_written(*c_.before, c_.correction->changes, *c_.after);
    std::vector<std::size_t> gone, come;
    std::size_t changed = 0;
    for (const WrittenStatement& w : all) {
      (w.kind == WrittenKind::added ? come : gone).push_back(w.line);
      changed += w.kind == WrittenKind::changed ? 1U : 0U;
    }
    const auto rest = [](const Toolpath& path, const std::vector<std::size_t>& lines, std::size_t& left_out) {
      std::vector<std::string_view> texts;
      for (const SourceStatement& span : path.statements) {
        const bool is_listed = std::find(lines.begin(), lines.end(), std::size_t{span.line}) != lines.end();
        left_out += is_listed ? 1U : 0U;
        if (!is_listed)
          texts.push_back(std::string_view(path.source).substr(span.first_byte, span.last_byte - span.first_byte));
      }
      return texts;
    };
    std::size_t gone_count = 0, come_count = 0;
    const auto before = rest(*c_.before, gone, gone_count), after = rest(*c_.after, come, come_count);
    std::size_t i = 0, skipped = 0;  // what is changed stands in the new file unlisted
    for (const std::string_view text : after) {
      if (i < before.size() && text == before[i]) {
        ++i;
      } else {
        ++skipped;
      }
    }
    if (i != before.size() || skipped != changed)
      broken_.push_back("(c) records differ that are not listed as written");
  }

  double depth_at(const Pose& pose, const ToolVariants& tool) const {
    return checker_.measure(pose, MoveKind::feed, tool).depth_mm;
  }

  bool is_inside(const Pose& pose, const ToolVariants& tool) const {
    const Vec3 core = pose.tip + tool.bare.core.y() * pose.axis;
    for (const auto* meshes : {&scene_.parts, &scene_.fixtures}) {
      for (const IndexedMesh& mesh : *meshes) {
        if (std::abs(winding_number(mesh, core)) > 0.9) return true;
      }
    }
    return false;
  }

  /// Left out on purpose: its positions are no shifted ones, and the path is not kept to. That every motion of it is as
  /// lawful as others (a, b, c) is tested all the same.
  bool is_uncut(std::size_t i) const {
    return std::ranges::any_of(c_.correction->uncut, [i](const Uncut& u) {
      return u.kind == Uncut::Kind::left_out && i >= u.first_move && i <= u.last_move;
    });
  }

  // (d) and the bounds of (e), at many places of the straight shift.
  void shift(std::size_t i, Figures&) {
    if (changes_[i] == nullptr || !changes_[i]->new_end || is_uncut(i)) return;
    const Move& old = c_.before->moves[i];
    const ToolVariants* tool = c_.setup->tools[old.tool];
    const Pose to = c_.after->moves[first_[i + 1] - 1].end;
    // A tilt about the contact is no shift: tilt_law_test.cpp examines those.
    constexpr double kDigitsOfAxis = 1e-5;
    if ((to.axis - old.end.axis).norm() > kDigitsOfAxis) return;
    const Vec3 displacement = to.tip - old.end.tip;
    const double start = depth_at(old.end, *tool);
    if (displacement.norm() > c_.max_shift_mm + kRounding_mm)
      say('e', i, "shifted by " + std::to_string(displacement.norm()));
    const double side = (displacement - displacement.dot(old.end.axis) * old.end.axis).norm();
    if (side > c_.max_side_shift_mm.value_or(2 * start) + kRounding_mm)
      say('e', i, "shifted sideways by " + std::to_string(side) + " for a depth of " + std::to_string(start));
    for (int k = 1; k <= 12; ++k) {
      const Pose there{old.end.tip + k / 12.0 * displacement, old.end.axis};
      const double depth = depth_at(there, *tool);
      if (depth > start + 2 * options_.resolution_mm)
        say('d', i, "on its shift it is " + std::to_string(depth) + " deep, at the start " + std::to_string(start));
      if (depth <= 0 && is_inside(there, *tool)) say('d', i, "on its shift the tool is buried");
    }
  }

  // (e): where the programmed motion is clean for a while, the new one runs along it.
  void keeps_its_path(std::size_t i, Figures& figures) {
    if (is_uncut(i)) return;
    const Move& old = c_.before->moves[i];
    const bool is_changed =
        changes_[i] != nullptr || (i > 0 && old.has_start && changes_[i - 1] != nullptr && changes_[i - 1]->new_end);
    if (!is_changed || !old.has_start || old.kind != MoveKind::feed) return;
    const ToolVariants* tool = c_.setup->tools[old.tool];
    const Motion motion = options_.law.of(*c_.before, i);
    constexpr int kSamples = 16;
    for (int s = 1; s + 1 < kSamples; ++s) {
      const double t = static_cast<double>(s) / kSamples, around = 1.5 / kSamples;
      const Motion part =
          options_.law.straight(motion.at(std::max(0.0, t - around)), motion.at(std::min(1.0, t + around)));
      CheckOptions strict = options_;
      strict.tolerance_mm *= 0.5;
      if (checker_.check(part, old.kind, *tool, strict, true).state != MoveState::clean) continue;
      if (is_inside(motion.at(t), *tool)) continue;
      ++figures.kept_samples;
      double off = 1e9;
      for (std::size_t k = first_[i]; k < first_[i + 1]; ++k) {
        const Vec3 a = c_.after->moves[k - 1].end.tip, b = c_.after->moves[k].end.tip, p = motion.at(t).tip;
        const double length2 = (b - a).squaredNorm();
        const double u = length2 > 0 ? std::clamp((p - a).dot(b - a) / length2, 0.0, 1.0) : 0.0;
        off = std::min(off, (a + u * (b - a) - p).norm());
      }
      if (off <= options_.tolerance_mm + kRounding_mm) continue;
      ++figures.left_path_samples;
      const auto& list = c_.correction->uncorrected;
      figures.listed_samples +=
          std::any_of(list.begin(), list.end(), [i](const Uncorrected& u) { return u.move == i; });
    }
  }

  /// The nearest that a tool comes to parts and fixtures, up to `max_mm`; negative inside. No smaller than the truth,
  /// and larger by what lies between the instants and 0.02 mm at most.
  double nearest(const Motion& motion, const ToolVariants& tool, double max_mm) const {
    constexpr int kInstants = 24;
    double depth = -max_mm;
    for (int s = 0; s <= kInstants; ++s) {
      const Pose pose = motion.at(static_cast<double>(s) / kInstants);
      for (const bool is_part : {true, false}) {
        for (const IndexedMesh& mesh : is_part ? scene_.parts : scene_.fixtures) {
          for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
            brute_force::search(is_part ? tool.against_part : tool.against_fixture, pose,
                                {mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)}, 0.02, depth);
        }
      }
    }
    return -depth;
  }

  // (g): a rapid that was written keeps the clearance, or is listed with no more than it keeps; over what is left uncut
  // it keeps it.
  void rapids_keep_off(std::size_t i, Figures& figures) {
    const bool is_start_moved = i > 0 && c_.before->moves[i].has_start && changes_[i - 1] != nullptr &&
                                (changes_[i - 1]->new_end || changes_[i - 1]->hole_shift_mm);
    if (changes_[i] == nullptr && !is_start_moved) return;
    const auto& list = c_.correction->low_rapids;
    const auto found = std::ranges::find(list, i, &LowRapid::move);
    const double claimed = found == list.end() ? c_.rapid_clearance_mm : found->keeps_mm;
    figures.low_rapids += found == list.end() ? 0U : 1U;
    const Move& old = c_.before->moves[i];
    const bool is_programmed = old.kind == MoveKind::rapid && first_[i + 1] - first_[i] == 1;
    for (std::size_t k = first_[i]; k < first_[i + 1]; ++k) {
      const Move& move = c_.after->moves[k];
      if (move.kind != MoveKind::rapid || !move.not_checked_reason.empty()) continue;
      const ToolVariants* tool = c_.setup->tools[move.tool];
      if (tool == nullptr || ++rapids_seen_ % one_of(scene_) != 0) continue;
      ++figures.rapids;
      const Motion motion = options_.law.of(*c_.after, k);
      const double keeps = nearest(motion, *tool, c_.rapid_clearance_mm);
      if (keeps >= claimed - 2 * options_.resolution_mm) continue;
      const double kept = nearest(options_.law.of(*c_.before, i), *tool, c_.rapid_clearance_mm);
      if (is_programmed && found == list.end() && keeps >= kept - 0.01) continue;
      say('g', i, "a rapid keeps " + std::to_string(keeps) + ", not " + std::to_string(claimed));
    }
    if (is_uncut(i) && old.kind != MoveKind::rapid && found != list.end())
      say('g', i, "a rapid over what is left uncut does not keep the clearance");
  }

  // (g): a rapid that was written ends no deeper than it begins, or within the tolerance. Only a programmed rapid may
  // lead to its programmed end, however deep that is. In stock no rapid goes back to its programmed start, and a rapid in
  // place of a feed is clear.
  void no_rapid_plunges(std::size_t i) {
    const Move& old = c_.before->moves[i];
    const auto is_open = [](MoveState state) { return state != MoveState::clean && state != MoveState::near_miss; };
    for (std::size_t k = first_[i]; k < first_[i + 1]; ++k) {
      const Move& move = c_.after->moves[k];
      const bool is_as_programmed = old.kind == MoveKind::rapid && (move.end.tip - old.end.tip).norm() <= kRounding_mm;
      if (move.kind != MoveKind::rapid || !move.has_start || is_as_programmed) continue;
      const ToolVariants* tool = c_.setup->tools[move.tool];
      if (tool == nullptr || !move.not_checked_reason.empty()) continue;
      const double start = depth_at(c_.after->start_of(k), *tool), end = depth_at(move.end, *tool);
      if (end > std::max(start, options_.tolerance_mm) + 2 * options_.resolution_mm)
        say('g', i, "a rapid that was written ends " + std::to_string(end) + " deep");
      const bool is_in_stock = c_.in_stock != nullptr && c_.in_stock->verdicts[k].state == MoveState::gouge;
      if (is_in_stock && old.has_start && (move.end.tip - c_.before->start_of(i).tip).norm() <= kRounding_mm)
        say('g', i, "a rapid that was written goes back into the stock");
      if (c_.in_stock != nullptr && old.kind == MoveKind::feed && is_open(c_.in_stock->verdicts[k].state))
        say('g', i, "a rapid in place of a feed may meet stock");
    }
  }

  // Brute force examines every triangle: at all moves of small scenes, at some of large ones.
  static std::size_t one_of(const Scene& scene) {
    std::size_t triangles = 0;
    for (const IndexedMesh& mesh : scene.parts) triangles += mesh.triangles.size();
    return 1 + triangles / 20;
  }

  const Corrected& c_;
  MotionChecker checker_;
  const CheckOptions& options_;
  const Scene& scene_;
  std::size_t looked_at_ = 0, rapids_seen_ = 0;
  std::vector<const PathChange*> changes_;
  std::vector<std::size_t> first_;  // the first move of the corrected path that each move became
  std::vector<std::string> broken_;
};

}  // namespace gouge::laws
