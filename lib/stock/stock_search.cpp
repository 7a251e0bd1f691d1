#include "lib/stock/stock_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "lib/base/tolerance.h"
#include "lib/motion/body_motion.h"
#include "lib/motion/motion_interval.h"
#include "lib/stock/piece_placer.h"
#include "lib/tool/evaluate.h"

namespace gouge {

namespace {

// Pieces within the resolution are not divided further. After so many of them that are neither free nor a witness, the
// answer is open.
constexpr std::size_t kMaxOpen = 100, kMaxOpenAgain = 8;
// Extents below this share of the resolution are not divided to make a piece free.
constexpr double kThin = 0.25;
// The least share of a piece that is cut off if it is beside the stock, and the number of halvings that find it.
constexpr double kWorthTrimming = 0.1;
constexpr int kTrimSteps = 10;

// Sectors fit round walls, boxes the straight seams between passes. Sectors are tried first, with this part of the budget.
constexpr std::uint64_t kFirstShare = 4;
// Parts of the time that are searched once more where the answer is open.
constexpr int kTimesAgain = 4;
constexpr std::uint64_t kShareAgain = 16;

struct Candidate {
  ToolPiece piece;
  MotionInterval interval;
};

/// The time [from, to] of a move along the axis that is examined at once, with the way along it.
struct Column {
  AxialRange range;
  double from = 0, to = 0, along_mm = 0;
};
// Number of instants at which the depth of a point in a column is evaluated.
constexpr int kColumnInstants = 64;

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
  /// `parts`: what low cylinders are cut into.
  Search(const StockQuestion& question, const Motion& motion, double depth_mm, PieceShape parts, std::uint64_t budget,
         std::size_t max_open = kMaxOpen)
      : q_(question),
        motion_(motion),
        depth_mm_(depth_mm),
        parts_shape_(parts),
        budget_(budget),
        max_open_(max_open),
        hints_(question.hints != nullptr ? *question.hints : own_hints_),
        departure_(question.history.departure_from(motion)),
        placer_(motion, departure_, question.options.resolution_mm, question.head != nullptr) {}

  StockAnswer decide(const std::vector<ToolPiece>& pieces, double from, double to) {
    if (take_column(pieces, from, to)) return run();
    for (std::uint32_t s = 0; s < motion_.segments().size(); ++s) {
      MotionInterval interval = whole_segment(motion_, s);
      if (interval.t0 > to || interval.t1 < from) continue;
      interval.t0 = std::max(interval.t0, from);
      interval.t1 = std::min(interval.t1, to);
      for (const ToolPiece& piece : pieces) waiting_.push_back({piece, interval});
    }
    return run();
  }

 private:
  /// If the tool moves along its axis and does not cut, its bodies pass the same space as longer ones at rest. Then the
  /// whole time is examined at once. Returns whether it is so.
  bool take_column(const std::vector<ToolPiece>& pieces, double from, double to) {
    if (q_.is_cutting || !departure_.is_none() || motion_.is_alone() || motion_.segments().size() > 1 ||
        motion_.turn_rad() > 0)
      return false;
    if (q_.head != nullptr && BodyMotion(motion_).turn_rad() * q_.head->reach_mm() > Tolerance::kRounding_mm)
      return false;
    const Vec3 axis = motion_.at(from).axis, way = motion_.tip_at(to, 0) - motion_.tip_at(from, 0);
    const double along = way.dot(axis);
    const bool is_axial = (way - along * axis).norm() < Tolerance::kRounding_mm &&
                          motion_.path_length_mm(from, to, 0) < std::abs(along) + Tolerance::kRounding_mm;
    if (!is_axial || !(std::abs(along) > 0)) return false;
    column_ = Column{{std::min(0.0, along), std::max(0.0, along)}, from, to, along};
    MotionInterval rest = whole_segment(motion_, 0);
    rest.t0 = rest.t1 = from;
    for (ToolPiece piece : pieces) {
      piece.z_lo_mm += column_.range.lo_mm;
      piece.z_hi_mm += column_.range.hi_mm;
      waiting_.push_back({piece, rest});
    }
    return true;
  }

  StockAnswer run() {
    std::size_t open = 0;
    while (!waiting_.empty()) {
      if (open >= max_open_) return answer_;
      if (answer_.examined >= budget_) {
        answer_.is_out_of_budget = true;
        return answer_;
      }
      const Candidate next = waiting_.back();
      waiting_.pop_back();
      if (depth_upper_mm(next.piece, q_.body, column_.range) <= depth_mm_ + q_.options.resolution_mm) continue;
      if (q_.head != nullptr && is_outside_head(next.piece)) continue;
      if (is_free(next)) continue;
      if (take_witness(next)) return answer_;
      if (is_no_deeper(next.piece, q_.body, depth_mm_ + q_.options.resolution_mm, column_.range)) continue;
      if (q_.is_clear_alone && is_left(next)) return answer_;
      if (!divide(next)) ++open;
    }
    answer_.is_clear = open == 0 && !answer_.unknown;
    return answer_;
  }

  /// Proves that no point of the piece is deep in the head, at any height of a column. The depth changes by no more than the
  /// way between two points; for larger pieces a box about them is tried instead.
  [[nodiscard]] bool is_outside_head(const ToolPiece& piece) const {
    const double most_mm = depth_mm_ + q_.options.resolution_mm, half_way = 0.5 * (range().hi_mm - range().lo_mm);
    if (piece.ball_mm() + half_way <= most_mm) {
      const Vec3 middle = piece.middle() - 0.5 * (range().hi_mm + range().lo_mm) * Vec3::UnitZ();
      return piece.ball_mm() + half_way - q_.head->signed_distance_mm(middle) <= most_mm;
    }
    const PieceDiscs in_tool = discs_of(piece);
    std::array<Disc, 2 * PieceDiscs::kMax> both;
    for (std::size_t k = 0; k < in_tool.count; ++k) {
      both[2 * k] = both[2 * k + 1] = in_tool.discs[k];
      both[2 * k].center.z() -= range().lo_mm;
      both[2 * k + 1].center.z() -= range().hi_mm;
    }
    return q_.head->is_no_deeper({both.data(), 2 * in_tool.count}, most_mm);
  }

  [[nodiscard]] const AxialRange& range() const { return column_.range; }

  [[nodiscard]] bool is_beside_stock(const SweptPiece& swept) const {
    std::array<Disc, 2 * SweptPiece::kMaxDiscs> both;
    const auto end = std::copy_n(swept.at0.begin(), swept.count, both.begin());
    std::copy_n(swept.at1.begin(), swept.count, end);
    return q_.stock.is_clear_of({both.data(), 2 * swept.count}, swept.slack_mm - q_.options.resolution_mm);
  }

  /// Proves that no stock is left in the piece during its interval.
  bool is_free(const Candidate& c) {
    ++answer_.examined;
    const SweptPiece swept = placer_.swept_by(c.piece, c.interval);
    if (q_.history.is_removed_by_hint(swept, q_.move, hints_.removed) || is_beside_stock(swept)) return true;
    if (q_.is_cutting && q_.history.is_removed_by(q_.move, c.interval.t0, swept)) return true;
    return q_.history.find_removal(swept, q_.move, hints_.removed);
  }

  /// Cuts off what is beside the stock during the whole interval. Returns whether that is worth a cut.
  bool trim(Candidate& c) {
    bool is_smaller = false;
    for (const Division d : {Division::height, Division::first, Division::second}) {
      if (c.piece.is_cylinder() && d != Division::height) break;
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
  [[nodiscard]] double share_beside_stock(const Candidate& c, Division d, bool is_high) {
    const auto is_beside = [&](double share) {
      return is_beside_stock(placer_.swept_by(end_of(c.piece, d, is_high, share), c.interval));
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
    const Vec3 in_tool = c.piece.middle(),
               point = placer_.place_at(c.interval.middle(), c.interval.segment).of(in_tool);
    const auto [t, depth] = deepest_instant(c, in_tool);
    if (!(depth > depth_mm_)) return false;
    if (!q_.stock.contains(point)) return false;
    if (const CutMove unknown = q_.history.unknown_near(point, q_.move)) {
      answer_.unknown = unknown;
      return false;
    }
    if (q_.is_cutting && !q_.history.is_missed_by(q_.move, t, point)) return false;
    if (!q_.history.is_untouched(point, q_.move, hints_.touched)) return false;
    answer_.witness = StockWitness{depth, t, point};
    return true;
  }

  /// Returns whether the middle of a piece is deep in the body and in the stock, and no earlier cutter removed it. If it is
  /// deeper by more than the resolution, no proof can succeed; else one may, after many more pieces.
  bool is_left(const Candidate& c) {
    const Vec3 in_tool = c.piece.middle();
    const auto [t, depth] = deepest_instant(c, in_tool);
    if (!(depth > depth_mm_)) return false;
    SweptPiece alone;
    alone.count = 1;
    alone.at0[0] = alone.at1[0] = {placer_.place_at(c.interval.middle(), c.interval.segment).of(in_tool)};
    if (!q_.stock.contains(alone.at0[0].center)) return false;
    if (q_.is_cutting && q_.history.is_removed_by(q_.move, t, alone)) return false;
    return !q_.history.is_removed(alone, q_.move, hints_.removed);
  }

  /// Returns an instant at which a point is deep in the body, and its depth then. Only in a column is there a choice.
  [[nodiscard]] std::pair<double, double> deepest_instant(const Candidate& c, const Vec3& in_tool) const {
    const double r = in_tool.head<2>().norm();
    const auto depth_at = [&](double z) {
      if (q_.head != nullptr) return -q_.head->signed_distance_mm({in_tool.x(), in_tool.y(), z});
      return -signed_distance_mm(q_.body, r, z);
    };
    // The point is at least that deep wherever the tool departs to.
    const double off = departure_.at_mm(in_tool.norm());
    std::pair<double, double> deepest(c.interval.middle(), depth_at(in_tool.z()) - off);
    if (!(std::abs(column_.along_mm) > 0)) return deepest;
    for (int k = 1; k <= kColumnInstants; ++k) {
      const double share = static_cast<double>(k) / kColumnInstants;
      const double depth = depth_at(in_tool.z() - share * column_.along_mm);
      if (depth > deepest.second) deepest = {column_.from + share * (column_.to - column_.from), depth};
    }
    return deepest;
  }

  /// Divides the time if the piece is free at the middle instant. Otherwise no shorter time about that instant can be
  /// free, so the piece is divided: in a direction in which it is free once it is flat, else across its longest extent.
  /// False: it is as small as the resolution.
  bool divide(Candidate c) {
    const bool is_small = c.piece.ball_mm() <= q_.options.resolution_mm;
    const double way = placer_.way_mm(c.piece, c.interval);
    if (is_small && c.piece.ball_mm() + way <= q_.options.resolution_mm) return false;
    if (!is_small && trim(c)) {
      waiting_.push_back(c);
      return true;
    }
    if (!is_small && c.piece.is_cylinder() && cut_out_section(c)) return true;
    Candidate still = c;
    still.interval.t0 = still.interval.t1 = c.interval.middle();
    if (way > Tolerance::kRounding_mm && is_free(still)) {
      halve_time(c);
      return true;
    }
    if (is_small) return false;
    halve_piece(c, free_when_flat(still).value_or(longest_of(c.piece)));
    return true;
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
      narrow_piece(rest.piece, q_.body, depth_mm_, column_.range);
      if (rest.piece.r_mm >= 0) waiting_.push_back(rest);
    }
    return true;
  }

  /// Returns the share of a cylinder from its middle towards an end (0 or 1) that the cutter of the last proof removed.
  [[nodiscard]] double share_removed(const Candidate& c, double end) {
    const auto is_removed = [&](double share) {
      const double from = std::min(0.5, 0.5 + (2 * end - 1) * share), to = std::max(0.5, 0.5 + (2 * end - 1) * share);
      return hints_.removed.program->is_removed_by(
          hints_.removed.move, 1, placer_.swept_by(part_of(c.piece, Division::height, from, to), c.interval));
    };
    if (!hints_.removed) return 0;
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
    for (const Division d : {Division::height, Division::first, Division::second}) {
      if (piece.is_cylinder() && d != Division::height) break;
      const double extent = extent_mm(piece, d);
      if (extent <= kThin * q_.options.resolution_mm || (best && extent <= extent_mm(piece, *best))) continue;
      if (is_free({flat_piece(piece, d), still.interval})) best = d;
    }
    return best;
  }

  /// A cylinder that is low beside its radius is cut into the parts of this search.
  [[nodiscard]] Division longest_of(const ToolPiece& piece) const {
    if (!piece.is_cylinder()) return longest_extent(piece);
    if (!(piece.height_mm() < 0.5 * piece.r_mm)) return Division::height;
    return parts_shape_ == PieceShape::sector ? Division::sectors : Division::boxes;
  }

  void halve_time(const Candidate& c) {
    for (const MotionInterval& half : halves(c.interval)) waiting_.push_back({c.piece, half});
  }

  void halve_piece(const Candidate& c, Division d) {
    parts_.clear();
    divide_piece(c.piece, d, q_.body, depth_mm_, parts_, column_.range);
    for (const ToolPiece& part : parts_) waiting_.push_back({part, c.interval});
  }

  const StockQuestion& q_;
  const Motion& motion_;
  double depth_mm_;
  PieceShape parts_shape_;
  std::uint64_t budget_;
  std::size_t max_open_;
  StockHints own_hints_;
  StockHints& hints_;
  Departure departure_;
  PiecePlacer placer_;
  Column column_;
  std::vector<Candidate> waiting_;
  std::vector<ToolPiece> parts_;
  StockAnswer answer_;
};

}  // namespace

StockAnswer find_stock(const StockQuestion& question, const Motion& motion, const std::vector<ToolPiece>& pieces,
                       double from, double to, double depth_mm) {
  const std::uint64_t budget = question.budget;
  StockAnswer answer =
      Search(question, motion, depth_mm, PieceShape::sector, budget / kFirstShare).decide(pieces, from, to);
  const auto search_again = [&](PieceShape shape, double begin, double end, std::uint64_t most, std::size_t max_open) {
    const std::uint64_t before = answer.examined;
    answer = Search(question, motion, depth_mm, shape, most, max_open).decide(pieces, begin, end);
    answer.examined += before;
  };
  if (answer.is_out_of_budget && !answer.unknown) search_again(PieceShape::box, from, to, budget, kMaxOpen);
  if (answer.is_clear || answer.witness || answer.is_out_of_budget) return answer;
  // A tool touched the material at one instant. At others a witness may still be found.
  const StockAnswer open = answer;
  for (int k = 0; k < kTimesAgain; ++k) {
    const double step = (to - from) / kTimesAgain;
    search_again(PieceShape::sector, from + k * step, from + (k + 1) * step, budget / kShareAgain, kMaxOpenAgain);
    if (answer.witness) return answer;
  }
  const std::uint64_t examined = answer.examined;
  answer = open;
  answer.examined = examined;
  return answer;
}

}  // namespace gouge
