#include "lib/tilt/smooth_tilts.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>

#include "lib/base/parallel.h"
#include "lib/base/units.h"
#include "lib/tilt/tilt_curve.h"

namespace gouge {
namespace {

constexpr double kInward_rad = 0.5 * kDegree_rad;   // step by which a tilt is reduced
constexpr double kExact_rad = 0.01 * kDegree_rad;   // accuracy of the minimum tilt
constexpr double kBeyond_rad = 0.03 * kDegree_rad;  // maximum excess of the curve's tilt over the largest reduced tilt
constexpr double kMore_rad = 0.01 * kDegree_rad;    // a reduced tilt is increased by 3, 9, 27, ... times this
constexpr double kDigit_rad = 0x1p-27;              // digit to which tilts are rounded; about 7e-9
constexpr int kFewAtATime = 30;            // rounds in which only the worst position of a stretch becomes an anchor
constexpr std::size_t kMaxLetGo = 40;      // maximum number of anchors whose removal is tried
constexpr std::size_t kMaxLooks = 20'000;  // maximum number of positions that these trials examine
constexpr std::size_t kChunk = 8;

class Smoother {
 public:
  Smoother(const TiltSpace& space, const TiltSequence& proven, unsigned threads)
      : space_(space), proven_(proven), threads_(threads), proofs_(space) {
    for (std::size_t i = 0; i < space.size(); ++i) arc_lengths_mm_.push_back(space[i].arc_length_mm);
  }

  TiltSequence run() {
    draw_in();
    kept_.assign(space_.size(), kFree);
    for (std::size_t i = 0; i < space_.size(); ++i) {
      if (space_[i].is_fixed()) kept_[i] = kProven;
    }
    for (int round = 0;; ++round) {
      const TiltSequence tilts = curve();
      const std::vector<char> is_refused = refused(tilts);
      if (is_free(is_refused)) break;
      add_anchors(tilts, is_refused, round < kFewAtATime);
    }
    let_go();
    return curve();
  }

 private:
  // Levels of the constraint on a position: none; the reduced tilt; in between, a growing part of the way to the proved
  // tilt; the proved tilt.
  static constexpr int kFree = 0, kDrawnIn = 1, kProven = 7;

  void draw_in() {
    drawn_in_ = proven_;
    for_each_chunk(space_.size(), kChunk, threads_, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) drawn_in_[i] = drawn_in(i);
    });
    for (const Tilt& tilt : drawn_in_) largest_rad_ = std::max(largest_rad_, tilt.norm());
  }

  [[nodiscard]] Tilt drawn_in(std::size_t i) const {
    const double angle = proven_[i].norm();
    if (!(angle > 0) || space_[i].is_fixed()) return proven_[i];
    const Tilt way = proven_[i] / angle;
    double good = angle, bad = angle;
    while (good > 0) {
      bad = std::max(0.0, good - kInward_rad);
      if (!space_.is_free(i, bad * way)) break;
      good = bad;
    }
    while (good - bad > kExact_rad) {
      const double middle = 0.5 * (good + bad);
      (space_.is_free(i, middle * way) ? good : bad) = middle;
    }
    return good * way;
  }

  [[nodiscard]] Tilt wanted(std::size_t i) const {
    if (kept_[i] <= kDrawnIn) return drawn_in_[i];
    const Tilt back = proven_[i] - drawn_in_[i];
    const double more_rad = kMore_rad * std::pow(3, kept_[i] - kDrawnIn);
    return kept_[i] == kProven || back.norm() <= more_rad ? proven_[i]
                                                          : Tilt(drawn_in_[i] + more_rad * back.normalized());
  }

  [[nodiscard]] TiltSequence curve() const {
    std::vector<TiltAnchor> anchors;
    for (std::size_t i = 0; i < space_.size(); ++i) {
      // Positions at one place share one value of the curve.
      const bool is_apart = anchors.empty() || arc_lengths_mm_[i] > arc_lengths_mm_[anchors.back().position];
      if (kept_[i] != kFree && is_apart) anchors.push_back({i, wanted(i)});
    }
    if (anchors.empty()) anchors.push_back({0, Tilt::Zero()});
    TiltSequence tilts = curve_through(anchors, arc_lengths_mm_, space_[0].stays_programmed(),
                                       space_[space_.size() - 1].stays_programmed());
    // Round tilts to digits finer than those of any file. So the negligible effect of a distant anchor becomes no
    // change at all.
    for (Tilt& tilt : tilts) tilt = (tilt / kDigit_rad).array().round() * kDigit_rad;
    for (std::size_t i = 0; i < space_.size(); ++i) {
      if (kept_[i] != kFree) tilts[i] = wanted(i);
    }
    const bool is_one_way = space_.task().options.freedom != TiltFreedom::both;
    if (is_one_way) {
      // Both ends and all anchors lie on one line. So the curve lies on it too, up to rounding.
      const Eigen::Index other = space_.task().options.freedom == TiltFreedom::lead ? 1 : 0;
      for (Tilt& tilt : tilts) tilt[other] = 0;
    }
    return tilts;
  }

  enum Refused : char { kNothing, kPosition, kMotion };

  [[nodiscard]] static bool is_free(const std::vector<char>& is_refused) {
    return std::ranges::all_of(is_refused, [](char refused) { return refused == kNothing; });
  }

  [[nodiscard]] std::vector<char> refused(const TiltSequence& tilts) {
    std::vector<char> is_refused(space_.size(), kNothing);
    for_each_chunk(space_.size(), kChunk, threads_, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) is_refused[i] = is_position_free(i, tilts) ? kNothing : kPosition;
    });
    if (!is_free(is_refused)) return is_refused;
    for_each_chunk(space_.size() - 1, kChunk, threads_, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        if (!is_motion_free(i, tilts)) is_refused[i] = kMotion;
      }
    });
    return is_refused;
  }

  /// Returns whether all positions and motions are free. Examines those near `about` first: tilts changed most there,
  /// so rejections are likely.
  [[nodiscard]] bool is_free_about(std::size_t about, const TiltSequence& tilts) {
    const auto distance = [about](std::size_t i) { return i > about ? i - about : about - i; };
    std::vector<std::size_t> outwards(space_.size());
    std::iota(outwards.begin(), outwards.end(), std::size_t{0});
    std::ranges::stable_sort(outwards, {}, distance);
    const auto is_free_everywhere = [&](const auto& is_free_at) {
      std::atomic<bool> is_refused = false;
      for_each_chunk(outwards.size(), kChunk, threads_, [&](std::size_t first, std::size_t last) {
        for (std::size_t k = first; k < last && !is_refused; ++k) {
          if (!is_free_at(outwards[k])) is_refused = true;
        }
      });
      return !is_refused;
    };
    return is_free_everywhere([&](std::size_t i) { return is_position_free(i, tilts); }) &&
           is_free_everywhere([&](std::size_t i) { return i + 1 == space_.size() || is_motion_free(i, tilts); });
  }

  [[nodiscard]] bool is_motion_free(std::size_t i, const TiltSequence& tilts) {
    return proofs_.is_free_after(i, tilts[i], tilts[i + 1]);
  }

  [[nodiscard]] bool is_position_free(std::size_t i, const TiltSequence& tilts) {
    if (kept_[i] == kDrawnIn || kept_[i] == kProven) return true;
    if (kept_[i] != kFree) return proofs_.is_free(i, tilts[i]);
    return tilts[i].norm() <= largest_rad_ + kBeyond_rad && proofs_.is_free(i, tilts[i]);
  }

  void add_anchors(const TiltSequence& tilts, const std::vector<char>& is_refused, bool is_worst_alone) {
    for (std::size_t first = 0, last = 0; first < space_.size(); first = last) {
      for (last = first; last < space_.size() && is_refused[last] == is_refused[first]; ++last) {
      }
      if (is_refused[first] == kNothing) continue;
      if (is_refused[first] == kMotion) {
        for (std::size_t i = first; i < last; ++i) keep_more_of(i, tilts);
      } else if (is_worst_alone) {
        keep_more(worst_of(tilts, first, last));
      } else {
        for (std::size_t i = first; i < last; ++i) keep_more(i);
      }
    }
  }

  /// Raises the constraint at the end of the motion with the smaller tilt. If that end is at its proved tilt, raises it
  /// at the other end.
  void keep_more_of(std::size_t i, const TiltSequence& tilts) {
    const std::size_t less = tilts[i].norm() < tilts[i + 1].norm() ? i : i + 1, other = i + i + 1 - less;
    keep_more(kept_[less] < kProven ? less : other);
  }

  void keep_more(std::size_t i) { kept_[i] = std::min(kept_[i] + 1, kProven); }

  /// Returns the position whose tilt differs most from the wanted tilt; among neighbours with equal differences, the
  /// middle one.
  [[nodiscard]] std::size_t worst_of(const TiltSequence& tilts, std::size_t first, std::size_t last) const {
    constexpr double kSame = 0.999;
    const auto miss = [&](std::size_t i) { return (tilts[i] - wanted(i)).norm(); };
    double most = 0;
    for (std::size_t i = first; i < last; ++i) most = std::max(most, miss(i));
    std::size_t from = first;
    while (miss(from) < kSame * most) ++from;
    std::size_t to = from;
    while (to + 1 < last && miss(to + 1) >= kSame * most) ++to;
    return (from + to) / 2;
  }

  void let_go() {
    std::size_t tried = 0;
    double least = roughness(curve(), arc_lengths_mm_);
    const std::size_t most = std::min(kMaxLetGo, 1 + kMaxLooks / space_.size());
    for (std::size_t i = 1; i + 1 < space_.size() && tried < most; ++i) {
      if (kept_[i] == kFree || space_[i].is_fixed()) continue;
      ++tried;
      const int was = kept_[i];
      kept_[i] = kFree;
      const TiltSequence tilts = curve();
      const double now = roughness(tilts, arc_lengths_mm_);
      if (now < least && is_free_about(i, tilts)) {
        least = now;
      } else {
        kept_[i] = was;
      }
    }
  }

  const TiltSpace& space_;
  const TiltSequence& proven_;
  unsigned threads_;
  std::vector<double> arc_lengths_mm_;
  TiltSequence drawn_in_;
  double largest_rad_ = 0;  // maximum of the reduced tilts
  std::vector<int> kept_;
  TiltProofs proofs_;
};

}  // namespace

TiltSequence smooth_tilts(const TiltSpace& space, const TiltSequence& proven, unsigned threads) {
  return Smoother(space, proven, threads).run();
}

}  // namespace gouge
