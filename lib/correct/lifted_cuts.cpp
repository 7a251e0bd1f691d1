#include "lib/correct/lifted_cuts.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/correct/laws.h"
#include "lib/motion/motion_law.h"
#include "lib/path/path_info.h"
#include "lib/path/run_kind.h"

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
    return !runs_rapid(move) && move.kind != MoveKind::cycle && move.has_start && move.tool != kNone &&
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

}  // namespace

std::vector<Uncut> find_lifted_cuts(const Toolpath& path, const Correction& correction, const Toolpath& after,
                                    const CheckSetup& setup) {
  if (correction.changes.empty()) return {};
  return LiftedCuts(path, correction, after, setup).find();
}

}  // namespace gouge
