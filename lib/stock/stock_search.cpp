#include "lib/stock/stock_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "lib/base/tolerance.h"
#include "lib/motion/motion_interval.h"
#include "lib/tool/evaluate.h"

namespace gouge {

namespace {

// Pieces within the resolution are not divided further. After so many of them that are neither free nor a witness, the
// answer is open.
constexpr std::size_t kMaxOpen = 100;
// Extents below this share of the resolution are not divided to make a piece free.
constexpr double kThin = 0.25;
// The least share of a piece that is cut off if it is beside the stock, and the number of halvings that find it.
constexpr double kWorthTrimming = 0.1;
constexpr int kTrimSteps = 10;
constexpr int kDepthSteps = 24;

struct Candidate {
  ToolPiece piece;
  MotionInterval interval;
};

/// Directions of the tool and its tip at one instant.
struct Place {
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  Vec3 tip = Vec3::Zero();
  [[nodiscard]] Vec3 of(const Vec3& in_tool) const { return axes * in_tool + tip; }
};

/// Adds the discs of a piece at both ends of an interval. A flat box has fewer corners.
void place_piece(const ToolPiece& piece, const Place& a, const Place& b, SweptPiece& swept) {
  swept.count = 0;
  const auto add = [&](const Vec3& at, double radius) {
    swept.at0[swept.count] = {a.of(at), a.axes.col(2), radius};
    swept.at1[swept.count++] = {b.of(at), b.axes.col(2), radius};
  };
  if (!piece.is_box) {
    add({0, 0, piece.z_lo_mm}, piece.r_mm);
    if (piece.z_hi_mm > piece.z_lo_mm) add({0, 0, piece.z_hi_mm}, piece.r_mm);
    return;
  }
  for (int corner = 0; corner < 8; ++corner) {
    bool is_twice = false;
    Vec3 at = piece.center;
    for (int k = 0; k < 3; ++k) {
      const bool is_high = (corner >> k & 1) != 0;
      is_twice = is_twice || (is_high && !(piece.half[k] > 0));
      at[k] += is_high ? piece.half[k] : -piece.half[k];
    }
    if (!is_twice) add(at, 0);
  }
}

/// Returns the part of a piece between two shares of its extent in one direction.
ToolPiece part_of(const ToolPiece& piece, Division d, double from, double to) {
  ToolPiece part = piece;
  if (piece.is_box) {
    const auto k = static_cast<Eigen::Index>(d);
    part.center[k] += piece.half[k] * (from + to - 1);
    part.half[k] *= to - from;
  } else {
    part.z_lo_mm = piece.z_lo_mm + from * piece.height_mm();
    part.z_hi_mm = piece.z_lo_mm + to * piece.height_mm();
  }
  return part;
}

/// Returns the section through the middle of a piece.
ToolPiece flat_piece(const ToolPiece& piece, Division d) { return part_of(piece, d, 0.5, 0.5); }

ToolPiece end_of(const ToolPiece& piece, Division d, bool is_high, double share) {
  return is_high ? part_of(piece, d, 1 - share, 1) : part_of(piece, d, 0, share);
}

ToolPiece without_end(const ToolPiece& piece, Division d, bool is_high, double share) {
  return is_high ? part_of(piece, d, 0, 1 - share) : part_of(piece, d, share, 1);
}

class Search {
 public:
  Search(const StockQuestion& question, const Motion& motion, double depth_mm)
      : q_(question), motion_(motion), depth_mm_(depth_mm), hint_(question.move) {}

  StockAnswer decide(const std::vector<ToolPiece>& pieces, double from, double to) {
    for (std::uint32_t s = 0; s < motion_.segments().size(); ++s) {
      MotionInterval interval = whole_segment(motion_, s);
      if (interval.t0 > to || interval.t1 < from) continue;
      interval.t0 = std::max(interval.t0, from);
      interval.t1 = std::min(interval.t1, to);
      for (const ToolPiece& piece : pieces) waiting_.push_back({piece, interval});
    }
    std::size_t open = 0;
    while (!waiting_.empty()) {
      if (answer_.examined >= q_.options.budget_per_move || open >= kMaxOpen) return answer_;
      const Candidate next = waiting_.back();
      waiting_.pop_back();
      if (depth_upper_mm(next.piece, q_.body) <= depth_mm_ + q_.options.resolution_mm) continue;
      if (is_free(next)) continue;
      if (take_witness(next)) return answer_;
      if (next.piece.ball_mm() + way_mm(next) <= q_.options.resolution_mm) {
        ++open;
      } else {
        divide(next);
      }
    }
    answer_.is_clear = open == 0 && !answer_.unknown_move;
    return answer_;
  }

 private:
  [[nodiscard]] Place place_at(double t, std::uint32_t segment) const {
    return {motion_.axes_at(t), motion_.tip_at(t, segment)};
  }

  /// Bounds the length of the way of every point of the piece.
  [[nodiscard]] double way_mm(const Candidate& c) const {
    return motion_.path_length_mm(c.interval.t0, c.interval.t1, c.interval.segment) +
           c.piece.reach_mm() * motion_.turn_rad(c.interval.t0, c.interval.t1);
  }

  /// Places the piece at both ends of its interval.
  [[nodiscard]] SweptPiece swept_by(const Candidate& c) const {
    const MotionInterval& i = c.interval;
    SweptPiece swept;
    const double size = c.piece.ball_mm() + way_mm(c);
    const bool is_flat = c.piece.is_box && !(c.piece.half.minCoeff() > 0);
    if (size <= q_.options.resolution_mm && !is_flat) {
      // The middle at one instant stands for the whole.
      swept.slack_mm = size;
      swept.at0[0] = {place_at(i.middle(), i.segment).of(c.piece.middle()), Vec3::UnitZ(), 0};
      swept.at1[0] = swept.at0[0];
      swept.count = 1;
    } else {
      const MotionRates rates = motion_.rates(i.t0, i.t1, i.segment);
      swept.slack_mm = rates.tip_sag_mm + rates.axis_acceleration_rad() / 8 * c.piece.reach_mm();
      place_piece(c.piece, place_at(i.t0, i.segment), place_at(i.t1, i.segment), swept);
    }
    return swept;
  }

  [[nodiscard]] bool is_beside_stock(const SweptPiece& swept) const {
    std::array<Disc, 2 * SweptPiece::kMaxDiscs> both;
    const auto end = std::copy_n(swept.at0.begin(), swept.count, both.begin());
    std::copy_n(swept.at1.begin(), swept.count, end);
    return q_.stock.is_clear_of({both.data(), 2 * swept.count}, swept.slack_mm - q_.options.resolution_mm);
  }

  /// Proves that no stock is left in the piece during its interval.
  bool is_free(const Candidate& c) {
    ++answer_.examined;
    const SweptPiece swept = swept_by(c);
    if (is_beside_stock(swept)) return true;
    if (q_.is_cutting && q_.history.is_removed_by(q_.move, c.interval.t0, swept)) return true;
    return q_.history.is_removed(swept, q_.move, hint_);
  }

  /// Cuts off what is beside the stock during the whole interval. Returns whether that is worth a cut.
  [[nodiscard]] bool trim(Candidate& c) const {
    bool is_smaller = false;
    for (const Division d : {Division::height, Division::x, Division::y}) {
      if (!c.piece.is_box && d != Division::height) break;
      for (const bool is_high : {false, true}) {
        const double share = share_beside_stock(c, d, is_high);
        if (share < kWorthTrimming) continue;
        c.piece = without_end(c.piece, d, is_high, share);
        is_smaller = true;
      }
    }
    return is_smaller;
  }

  /// Returns the share of the piece, from one of its ends, that is beside the stock.
  [[nodiscard]] double share_beside_stock(const Candidate& c, Division d, bool is_high) const {
    const auto is_beside = [&](double share) {
      return is_beside_stock(swept_by({end_of(c.piece, d, is_high, share), c.interval}));
    };
    if (!is_beside(kWorthTrimming)) return 0;
    double share = kWorthTrimming, above = 1;
    for (int k = 0; k < kTrimSteps; ++k) {
      const double middle = 0.5 * (share + above);
      (is_beside(middle) ? share : above) = middle;
    }
    return share;
  }

  /// Takes the middle of the piece at the middle of the interval as the witness if it is one.
  bool take_witness(const Candidate& c) {
    const double t = c.interval.middle();
    const Vec3 in_tool = c.piece.middle();
    const double depth = -signed_distance_mm(q_.body, in_tool.head<2>().norm(), in_tool.z());
    if (!(depth > depth_mm_)) return false;
    const Vec3 point = place_at(t, c.interval.segment).of(in_tool);
    if (!q_.stock.contains(point)) return false;
    if (const std::optional<std::size_t> unknown = q_.history.unknown_near(point, q_.move)) {
      answer_.unknown_move = unknown;
      return false;
    }
    if (q_.is_cutting && !q_.history.is_missed_by(q_.move, t, point)) return false;
    if (!q_.history.is_untouched(point, q_.move, touch_hint_)) return false;
    answer_.witness = StockWitness{depth, t, point};
    return true;
  }

  /// Divides the piece or the time, whichever makes the parts free soonest: a direction in which the piece, made flat, is
  /// free at the middle instant. If none is, the longest extent is halved.
  void divide(Candidate c) {
    if (trim(c)) return waiting_.push_back(c);
    if (!c.piece.is_box && cut_out_section(c)) return;
    const double way = way_mm(c);
    Candidate still = c;
    still.interval.t0 = still.interval.t1 = c.interval.middle();
    if (way > Tolerance::kRounding_mm && is_free(still)) return halve_time(c);
    const std::optional<Division> flat = free_when_flat(still);
    if (flat) return way > extent_mm(c.piece, *flat) ? halve_time(c) : halve_piece(c, *flat);
    Division longest = c.piece.is_box ? Division::x : Division::height;
    if (c.piece.is_box) {
      for (const Division d : {Division::y, Division::height})
        if (extent_mm(c.piece, d) > extent_mm(c.piece, longest)) longest = d;
    } else if (c.piece.height_mm() < 0.5 * c.piece.r_mm) {
      longest = Division::quarters;
    }
    if (way > extent_mm(c.piece, longest)) return halve_time(c);
    halve_piece(c, longest);
  }

  /// If the section through the middle of a cylinder is free, cuts out all that the same earlier cutter removed above and
  /// below it. Returns whether that was worth a cut.
  bool cut_out_section(const Candidate& c) {
    if (c.piece.height_mm() <= kThin * q_.options.resolution_mm) return false;
    if (!is_free({flat_piece(c.piece, Division::height), c.interval})) return false;
    const double below = share_removed(c, 0), above = share_removed(c, 1);
    if (below + above < kWorthTrimming) return false;
    for (const auto& [from, to] : {std::pair(0.5 + above, 1.0), std::pair(0.0, 0.5 - below)}) {
      if (!(to > from)) continue;
      Candidate rest = c;
      rest.piece = part_of(c.piece, Division::height, from, to);
      narrow_piece(rest.piece, q_.body, depth_mm_);
      if (rest.piece.r_mm >= 0) waiting_.push_back(rest);
    }
    return true;
  }

  /// Returns the share of a cylinder from its middle towards an end (0 or 1) that the cutter of the last proof removed.
  [[nodiscard]] double share_removed(const Candidate& c, double end) const {
    const auto is_removed = [&](double share) {
      const double from = std::min(0.5, 0.5 + (2 * end - 1) * share), to = std::max(0.5, 0.5 + (2 * end - 1) * share);
      return q_.history.is_removed_by(hint_, 1, swept_by({part_of(c.piece, Division::height, from, to), c.interval}));
    };
    if (hint_ >= q_.move) return 0;
    if (is_removed(0.5)) return 0.5;
    double share = 0, beyond = 0.5;
    for (int k = 0; k < kTrimSteps; ++k) {
      const double middle = 0.5 * (share + beyond);
      (is_removed(middle) ? share : beyond) = middle;
    }
    return share;
  }

  /// Returns the direction of largest extent in which the piece, made flat, is free.
  std::optional<Division> free_when_flat(const Candidate& still) {
    const ToolPiece& piece = still.piece;
    std::optional<Division> best;
    for (const Division d : {Division::height, Division::x, Division::y}) {
      if (!piece.is_box && d != Division::height) break;
      const double extent = extent_mm(piece, d);
      if (extent <= kThin * q_.options.resolution_mm || (best && extent <= extent_mm(piece, *best))) continue;
      if (is_free({flat_piece(piece, d), still.interval})) best = d;
    }
    return best;
  }

  [[nodiscard]] static double extent_mm(const ToolPiece& piece, Division d) {
    if (d == Division::quarters) return 2 * piece.r_mm;
    if (d == Division::height) return piece.height_mm();
    return 2 * piece.half[static_cast<Eigen::Index>(d)];
  }

  void halve_time(const Candidate& c) {
    for (const MotionInterval& half : halves(c.interval)) waiting_.push_back({c.piece, half});
  }

  void halve_piece(const Candidate& c, Division d) {
    parts_.clear();
    divide_piece(c.piece, d, q_.body, depth_mm_, parts_);
    for (const ToolPiece& part : parts_) waiting_.push_back({part, c.interval});
  }

  const StockQuestion& q_;
  const Motion& motion_;
  double depth_mm_;
  std::size_t hint_, touch_hint_ = kNone;
  std::vector<Candidate> waiting_;
  std::vector<ToolPiece> parts_;
  StockAnswer answer_;
};

}  // namespace

StockAnswer find_stock(const StockQuestion& question, const Motion& motion, const std::vector<ToolPiece>& pieces,
                       double from, double to, double depth_mm) {
  return Search(question, motion, depth_mm).decide(pieces, from, to);
}

StockDepth find_depth(const StockQuestion& question, const Motion& motion, const StockWitness& known, double upper_mm) {
  StockDepth deepest{known, upper_mm};
  std::uint64_t examined = 0;
  for (int k = 0; k < kDepthSteps && examined < question.options.budget_per_move; ++k) {
    const double depth = deepest.witness.depth_mm, gap = deepest.upper_mm - depth;
    if (gap <= depth_gap_mm(depth, question.options)) break;
    const double next = depth + std::min(0.5 * gap, depth);
    const StockAnswer answer = find_stock(question, motion, deep_pieces(question.body, next), 0, 1, next);
    examined += answer.examined;
    if (answer.witness) {
      deepest.witness = *answer.witness;
    } else if (answer.is_clear) {
      deepest.upper_mm = std::min(deepest.upper_mm, next + question.options.resolution_mm);
    } else {
      break;
    }
  }
  return deepest;
}

double depth_gap_mm(double depth_mm, const StockOptions& options) {
  constexpr double kShare = 0.1;
  return std::max(2 * options.resolution_mm, kShare * depth_mm);
}

Body body_at(const CompiledTool& tool, const Pose& pose, const Vec3& point) {
  const Vec3 from_tip = point - pose.tip;
  const double z = from_tip.dot(pose.axis);
  return tool.elements[evaluate(tool, (from_tip - z * pose.axis).norm(), z).element].body;
}

}  // namespace gouge
