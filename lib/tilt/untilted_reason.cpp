#include "lib/tilt/untilted_reason.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>
#include <vector>

#include "lib/base/number_text.h"
#include "lib/base/parallel.h"
#include "lib/base/tolerance.h"
#include "lib/base/units.h"
#include "lib/path/path_info.h"

namespace gouge {
namespace {

constexpr int kRings = 6;
// Tilts beyond the limits: the first one, the factor to the next, and the largest one.
constexpr double kFirstTilt_rad = 0.25 * kDegree_rad, kNextTilt = 1.5, kLastTilt_rad = 89 * kDegree_rad;
constexpr int kTiltHalvings = 10;
constexpr double kBeside_rad = 0.02;
constexpr double kSame_mm = 1e-4;  // depths that differ by less are equal
constexpr std::size_t kPositionsPerChunk = 4;

/// What the best of some tilts lacks at a position.
struct Missing {
  double depth_mm = 0;  ///< 0: nothing
  Body body = Body::holder;
  Tilt tilt = Tilt::Zero();
};

/// The position of a run that misses most.
struct WorstPosition {
  std::size_t position = 0;
  Missing best;
};

class Examiner {
 public:
  Examiner(const TiltJob& job, const TiltSpace& space)
      : job_(job), space_(space), directions_(tilt_directions(space.task().options.freedom)) {}

  [[nodiscard]] std::string held_back_reason(std::size_t i) const {
    const MoveVerdict verdict = space_.verdict(i, Tilt::Zero());
    const std::string where = space_[i].t > 0 ? "on line " : "at the beginning of line ";
    return "a tilt would have to leave the tool as programmed " + where + line_text(i) + ", and there the " +
           body_name(verdict.witness ? verdict.witness->body : Body::cutter) + " is " + length_text(verdict.depth_mm) +
           " too deep";
  }

  [[nodiscard]] std::string reason() const {
    const WorstPosition worst = find_worst();
    const std::size_t i = worst.position;
    if (!(worst.best.depth_mm > 0))
      return "no tilts " + limits_text() + " were found that are free at each position and between them" +
             beyond_reach_text(worst);
    return "no tilt " + limits_text() + " frees line " + line_text(i) + ": at the best one looked at the " +
           body_name(worst.best.body) + " is " + length_text(worst.best.depth_mm) + " too deep" + cure_text(worst);
  }

 private:
  [[nodiscard]] std::string line_text(std::size_t i) const {
    return std::to_string(job_.path.moves[space_[i].move].line);
  }

  /// Rounds up: the tool lacks no less than stated.
  [[nodiscard]] std::string length_text(double mm) const {
    const bool is_mm = job_.path.unit == LengthUnit::mm;
    const double per_digit = is_mm ? 1e3 : 1e4;
    const double length = std::ceil(mm / mm_per(job_.path.unit) * per_digit - Tolerance::kRounding) / per_digit;
    return display_text(length, is_mm ? 3 : 4) + " " + unit_name(job_.path.unit);
  }

  [[nodiscard]] std::string limits_text() const {
    const TiltOptions& options = space_.task().options;
    std::vector<std::string> limits{"--max-tilt " + display_text(job_.options.max_tilt_rad / kDegree_rad, 3) +
                                    " degrees"};
    if (options.cone) limits.emplace_back("--axis-cone");
    if (options.reach != nullptr) limits.emplace_back("the limits of the machine's joints");
    return "within " + listed(limits, " and ");
  }

  /// Returns what the tool lacks at a tilt. The cutter may be in the part to the tolerance.
  [[nodiscard]] Missing missing_at(std::size_t i, const Tilt& tilt) const {
    const MoveVerdict verdict = space_.verdict(i, tilt);
    if (verdict.state != MoveState::gouge) return {0, Body::holder, tilt};
    const Body body = verdict.witness ? verdict.witness->body : Body::holder;
    const bool is_allowed = body == Body::cutter && verdict.depth_mm <= job_.checker.options().tolerance_mm;
    return {is_allowed ? 0 : verdict.depth_mm, body, tilt};
  }

  /// Returns the best of some tilts, or the first one that lacks no more than `enough_mm`.
  [[nodiscard]] Missing best_at(std::size_t i, Missing best, double enough_mm) const {
    for (const Tilt& direction : directions_) {
      const double most = space_.largest_permitted_rad(i, direction);
      for (int ring = kRings; ring > 0 && most > 0; --ring) {
        const Tilt tilt = most * ring / kRings * direction;
        if (!space_.is_permitted(i, tilt)) continue;
        const Missing now = missing_at(i, tilt);
        if (now.depth_mm < best.depth_mm) best = now;
        if (best.depth_mm <= enough_mm) return best;
      }
    }
    return best;
  }

  /// Returns the position whose best tilt lacks most. The deepest positions as programmed come first, so the others need
  /// few checks.
  [[nodiscard]] WorstPosition find_worst() const {
    std::vector<Missing> programmed(space_.size());
    for_each_chunk(space_.size(), kPositionsPerChunk, job_.checker.options().threads,
                   [&](std::size_t first, std::size_t last) {
                     for (std::size_t i = first; i < last; ++i) programmed[i] = missing_at(i, Tilt::Zero());
                   });
    std::vector<std::size_t> order(space_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    // Of positions that are equally deep the first one in the path is named.
    std::ranges::stable_sort(order, std::greater<>(),
                             [&](std::size_t i) { return std::round(programmed[i].depth_mm / kSame_mm); });
    WorstPosition worst{order.front(), {}};
    for (const std::size_t i : order) {
      if (programmed[i].depth_mm <= worst.best.depth_mm - kSame_mm) break;
      if (space_[i].is_fixed()) continue;
      const Missing again = space_.is_permitted(i, worst.best.tilt) ? missing_at(i, worst.best.tilt) : programmed[i];
      if (again.depth_mm <= worst.best.depth_mm + kSame_mm) continue;
      const Missing best =
          best_at(i, again.depth_mm < programmed[i].depth_mm ? again : programmed[i], worst.best.depth_mm);
      if (best.depth_mm > worst.best.depth_mm + kSame_mm) worst = {i, best};
    }
    return worst;
  }

  /// Returns the smallest tilt beyond the limits that is proved free at a position, in one of the directions.
  [[nodiscard]] std::optional<Tilt> find_free_tilt(std::size_t i) const {
    TiltTask task = space_.task();
    task.options.max_tilt_rad = kLastTilt_rad;
    task.options.cone.reset();
    task.options.reach.reset();
    const TiltSpace alone({space_[i]}, task);
    RefusingPoints refusing;
    std::optional<Tilt> least;
    for (double angle = kFirstTilt_rad; !least && angle < kLastTilt_rad; angle *= kNextTilt) {
      for (const Tilt& direction : directions_) {
        double free = angle, blocked = angle / kNextTilt;
        if (!alone.is_free(0, free * direction, &refusing)) continue;
        for (int k = 0; k < kTiltHalvings; ++k) {
          const double middle = 0.5 * (free + blocked);
          (alone.is_free(0, middle * direction, &refusing) ? free : blocked) = middle;
        }
        if (!least || free < least->norm()) least = free * direction;
      }
    }
    return least;
  }

  /// Returns the tilt that would free the worst position, and the limit that prevents it.
  [[nodiscard]] std::string cure_text(const WorstPosition& worst) const {
    const std::optional<Tilt> free = find_free_tilt(worst.position);
    if (!free || space_.is_permitted(worst.position, *free)) return beyond_reach_text(worst);
    // The search keeps a margin to its limit.
    constexpr double kMargin = 1.001, kDigits = 100;
    const double degrees = (free->norm() * kMargin + kLimitMargin_rad) / kDegree_rad;
    const std::string text = "; " + display_text(std::ceil(degrees * kDigits) / kDigits, 2) + " degrees would free it";
    const std::string joint = space_.why_not_reached(worst.position, *free);
    if (!joint.empty()) return text + ", but " + joint;
    const auto& cone = space_.task().options.cone;
    const bool is_outside =
        cone && angle_between_rad(space_[worst.position].axis_for(*free), cone->axis) > cone->half_angle_rad;
    return text + (is_outside ? ", outside --axis-cone" : "");
  }

  /// Names the joint that keeps the machine from the largest tilts of a position; empty: none does.
  [[nodiscard]] std::string beyond_reach_text(const WorstPosition& worst) const {
    const double most = job_.options.max_tilt_rad;
    std::vector<Tilt> looked;
    if (worst.best.tilt.norm() > 0) looked.emplace_back(worst.best.tilt.normalized());
    looked.insert(looked.end(), directions_.begin(), directions_.end());
    // Beside the directions, because two turns of a joint may be equally near in them.
    const Eigen::Rotation2Dd beside(kBeside_rad);
    for (const Tilt& direction : looked) {
      const std::string joint = space_.why_not_reached(worst.position, most * (beside * direction));
      if (!joint.empty()) return "; a larger tilt is out of reach: " + joint;
    }
    return {};
  }

  const TiltJob& job_;
  const TiltSpace& space_;
  std::vector<Tilt> directions_;  // unit
};

}  // namespace

std::string untilted_reason(const TiltJob& job, const TiltSpace& space, const LatticeResult& found) {
  const Examiner examiner(job, space);
  return found.held_back ? examiner.held_back_reason(*found.held_back) : examiner.reason();
}

}  // namespace gouge
