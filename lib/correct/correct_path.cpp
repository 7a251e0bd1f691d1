#include "lib/correct/correct_path.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "lib/correct/laws.h"
#include "lib/correct/low_rapids.h"
#include "lib/correct/measure_stock.h"
#include "lib/correct/plan_holes.h"
#include "lib/correct/proposer.h"
#include "lib/motion/motion_law.h"
#include "lib/path/path_info.h"

namespace gouge {
namespace {

constexpr double kSample_mm = 0.5;
constexpr std::size_t kMaxSamples = 400, kChords = 32;

double distance_mm(const Vec3& point, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double length2 = along.squaredNorm();
  const double t = length2 > 0 ? std::clamp((point - a).dot(along) / length2, 0.0, 1.0) : 0;
  return (a + t * along - point).norm();
}

class LiftedCuts {
 public:
  LiftedCuts(const Toolpath& path, const Correction& correction, const Toolpath& after, const CheckSetup& setup)
      : path_(path), after_(after), setup_(setup), spans_(moves_after(path.moves.size(), correction.changes)) {
    is_changed_.assign(path.moves.size() + 1, false);
    for (const PathChange& change : correction.changes) {
      if (change.hole_shift_mm) continue;
      is_changed_[change.move] = true;
      if (change.new_end) is_changed_[change.move + 1] = true;
    }
    for (const Uncut& uncut : correction.uncut)
      std::fill(is_changed_.begin() + static_cast<std::ptrdiff_t>(uncut.first_move),
                is_changed_.begin() + static_cast<std::ptrdiff_t>(uncut.last_move + 1), false);
  }

  [[nodiscard]] std::vector<Uncut> find() const {
    std::vector<Uncut> lifted;
    for (std::size_t i = 0; i < path_.moves.size(); ++i) {
      if (!is_changed_[i] || !is_cut(i)) continue;
      const double lost = lost_mm(i);
      if (!(lost > 0)) continue;
      const bool goes_on = !lifted.empty() && lifted.back().last_move + 1 == i;
      if (!goes_on) lifted.push_back({.first_move = i, .kind = Uncut::Kind::lifted});
      lifted.back().last_move = i;
      lifted.back().length_mm += lost;
      const Pose& end = after_.moves[spans_[i].last - 1].end;
      lifted.back().positions += (end.tip - path_.moves[i].end.tip).norm() > limit_mm(i) ? 1U : 0U;
    }
    return lifted;
  }

 private:
  [[nodiscard]] bool is_cut(std::size_t i) const {
    const Move& move = path_.moves[i];
    return move.kind != MoveKind::rapid && move.kind != MoveKind::cycle && move.has_start && move.tool != kNone &&
           setup_.tools[move.tool] != nullptr && move.not_checked_reason.empty();
  }
  [[nodiscard]] const MotionLaw& law() const { return setup_.options.law; }
  [[nodiscard]] double limit_mm(std::size_t i) const { return setup_.tools[path_.moves[i].tool]->bare.core_depth_mm; }

  /// Returns the length of the programmed motion from which the new motions deviate by more than the limit.
  [[nodiscard]] double lost_mm(std::size_t i) const {
    const Motion motion = law().of(path_, i);
    if (!motion.is_defined()) return 0;
    const std::vector<Vec3> way = way_of(spans_[i]);
    const double length = move_length_mm(path_, i);
    const auto wanted = static_cast<std::size_t>(std::ceil(length / kSample_mm));
    const std::size_t count = std::clamp<std::size_t>(wanted, 1, kMaxSamples);
    std::size_t far = 0;
    for (std::size_t s = 0; s < count; ++s) {
      const Vec3 tip = motion.at((static_cast<double>(s) + 0.5) / static_cast<double>(count)).tip;
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t k = 1; k < way.size(); ++k) least = std::min(least, distance_mm(tip, way[k - 1], way[k]));
      far += least > limit_mm(i) ? 1U : 0U;
    }
    return length * static_cast<double>(far) / static_cast<double>(count);
  }

  /// Returns the tips of the motions that replaced a move, with chords for curves.
  [[nodiscard]] std::vector<Vec3> way_of(const MovesAfter& span) const {
    std::vector<Vec3> way;
    for (std::size_t k = span.first; k < span.last; ++k) {
      const Move& move = after_.moves[k];
      if (way.empty()) way.push_back(move.has_start ? after_.start_of(k).tip : move.end.tip);
      const Motion motion = law().of(after_, k);
      const std::size_t chords = motion.is_straight() || !motion.is_defined() ? 1 : kChords;
      for (std::size_t s = 1; s < chords; ++s)
        way.push_back(motion.at(static_cast<double>(s) / static_cast<double>(chords)).tip);
      way.push_back(move.end.tip);
    }
    return way;
  }

  const Toolpath& path_;
  const Toolpath& after_;
  const CheckSetup& setup_;
  std::vector<MovesAfter> spans_;
  std::vector<bool> is_changed_;
};

// Returns the stretches of cuts that a correction lifted or shifted from their programmed place by more than the
// cutter's radius. The tool passes elsewhere and leaves that stock. The order is that of the path.
//
// Requires `after` to be `path` with the changes.
// Ensures  The length is that of the programmed feeds. For each move it is accurate to half a millimetre, or to 1/400
//          of a longer move. Cycles, rapids and stretches that are already left out (Correction::uncut) are not
//          examined.
// Cost     Some hundred distances for each changed move.
std::vector<Uncut> find_lifted_cuts(const Toolpath& path, const Correction& correction, const Toolpath& after,
                                    const CheckSetup& setup) {
  if (correction.changes.empty()) return {};
  return LiftedCuts(path, correction, after, setup).find();
}

constexpr int kRounds = 6;  // number of rounds that take back worse changes, before all changes are taken back
constexpr const char* kLeftForLaws = "a change here would make a move of the written file worse";
constexpr const char* kUnwritable = "the file's records do not allow this change: ";

/// Returns the changed moves of a line, if the error names only the line and not the change that cannot be written.
std::vector<std::size_t> moves_of_line(const Toolpath& path, const std::vector<PathChange>& changes, std::size_t line) {
  std::vector<std::size_t> moves;
  for (const PathChange& change : changes) {
    const std::size_t next = std::min(change.move + 1, path.moves.size() - 1);
    if (path.moves[change.move].line == line || path.moves[next].line == line) moves.push_back(change.move);
  }
  return moves;
}

bool is_bad(const MoveVerdict& verdict) {
  return verdict.state == MoveState::gouge || verdict.state == MoveState::buried;
}

/// Returns every move that is bad at the end, with its known reason or the usual one.
std::vector<Uncorrected> list_remaining(const Toolpath& path, const CheckResult& before, const Correction& correction,
                                        const CheckResult& after) {
  std::vector<const Uncorrected*> known(path.moves.size(), nullptr);
  for (const Uncorrected& left : correction.uncorrected) known[left.move] = &left;
  std::vector<bool> is_changed(path.moves.size(), false);
  for (const PathChange& change : correction.changes) {
    const std::size_t last = change.hole_shift_mm ? end_of_hole(path, change.move) : change.move + 1;
    std::fill(is_changed.begin() + static_cast<std::ptrdiff_t>(change.move),
              is_changed.begin() + static_cast<std::ptrdiff_t>(last), true);
  }
  const std::vector<MovesAfter> spans = moves_after(path.moves.size(), correction.changes);
  std::vector<Uncorrected> remaining;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const MoveVerdict* worst = nullptr;
    for (std::size_t k = spans[i].first; k < spans[i].last; ++k) {
      const MoveVerdict& verdict = after.verdicts[k];
      if (is_bad(verdict) && (worst == nullptr || verdict.depth_mm > worst->depth_mm)) worst = &verdict;
    }
    if (worst == nullptr) continue;
    const double depth = is_changed[i] ? worst->depth_mm : before.verdicts[i].depth_mm;
    const std::string reason = known[i] != nullptr ? known[i]->reason : usual_reason(path.moves[i], *worst);
    remaining.push_back({i, path.moves[i].line, worst->state == MoveState::gouge ? depth : 0, reason, is_changed[i]});
  }
  return remaining;
}

// Keeps the assumptions on the position of part and path. The correction does not move them relative to each other. A
// path that was lifted from the part does not show anything different; a path that did not fit still does not fit.
void keep_place(const CheckResult& before, CheckResult& after) {
  for (const Subject fact : {Subject::mesh_unit, Subject::placement})
    copy_facts(fact, before.assumptions, after.assumptions);
}

void add_lifted_cuts(const Toolpath& path, const Toolpath& after, const CheckSetup& setup, Correction& correction) {
  const std::vector<Uncut> lifted = find_lifted_cuts(path, correction, after, setup);
  correction.uncut.insert(correction.uncut.end(), lifted.begin(), lifted.end());
  std::ranges::stable_sort(correction.uncut, {}, &Uncut::first_move);
}

/// Fills in the lines of all stretches.
template <typename Stretch>
void add_lines(const Toolpath& path, std::vector<Stretch>& stretches) {
  for (Stretch& stretch : stretches) {
    stretch.first_line = path.moves[stretch.first_move].line;
    stretch.last_line = path.moves[stretch.last_move].line;
  }
}

}  // namespace

Correction correct_path(const Toolpath& toolpath, const CheckResult& result, const CheckSetup& setup,
                        const CorrectOptions& correct, const ProgressCall& progress) {
  return Proposer(toolpath, result, setup, correct, progress).propose(progress);
}

Result<LawfulCorrection> correct_lawfully(const Toolpath& toolpath, const CheckResult& result, const CheckSetup& setup,
                                          const CorrectOptions& correct, const RewritePath& rewrite,
                                          const ProgressCall& progress) {
  Proposer proposer(toolpath, result, setup, correct, progress);
  for (int round = 0;; ++round) {
    Correction correction = proposer.propose(progress);
    Result<Toolpath> changed = rewrite(correction.changes);
    if (!changed && correction.changes.empty()) return changed.error();
    std::vector<std::size_t> worse;
    std::string reason = kLeftForLaws;
    if (changed) {
      ChangedPath after{std::move(*changed), {}};
      after.result = check_moves(after.path, setup, progress);
      worse = find_worse({&toolpath, &result}, correction.changes, {&after.path, &after.result}, setup.options);
      if (worse.empty()) {
        correction.uncorrected = list_remaining(toolpath, result, correction, after.result);
        if (progress) progress("measuring what is left", 0, 1);
        correction.stock = measure_stock(toolpath, correction, after.path, setup, correct);
        assess(after.path, setup, after.result);
        keep_place(result, after.result);
        add_lifted_cuts(toolpath, after.path, setup, correction);
        correction.low_rapids = find_low_rapids(toolpath, correction, after.path, setup, correct);
        add_lines(toolpath, correction.uncut);
        add_lines(toolpath, correction.stock);
        return LawfulCorrection{std::move(correction), std::move(after)};
      }
      if (correction.changes.empty()) {
        return make_error("correct-law",
                          "the file as it was written without a change reads or checks otherwise; nothing was written",
                          toolpath.file, toolpath.moves[worse.front()].line);
      }
    } else {
      worse = moves_of_line(toolpath, correction.changes, changed.error().line);
      reason = kUnwritable + changed.error().message;
    }
    // A worse move that no change touches is an effect of other changes. Only taking all of them back certainly ends
    // that.
    const bool is_touched = std::any_of(worse.begin(), worse.end(), [&](std::size_t i) {
      return std::any_of(correction.changes.begin(), correction.changes.end(),
                         [&](const PathChange& c) { return c.move == i || c.move + 1 == i; });
    });
    if (round >= kRounds || !is_touched) {
      proposer.keep_all(reason);
    } else {
      for (const std::size_t i : worse) {
        if (!proposer.give_up_arc(correction.changes, i)) proposer.keep(i, reason);
      }
    }
  }
}

}  // namespace gouge
