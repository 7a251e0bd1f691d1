#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "postproc/result/stored_result.h"

namespace gouge {

/// Pairs of equal moves of two paths; kNone for a move without a partner. Apart from kNone both vectors are increasing,
/// and each is the inverse of the other.
struct MotionAlignment {
  std::vector<std::size_t> before_to_after, after_to_before;
};

/// Aligns two lists of motions. Motions that are equal at both ends are paired first. Of the rest, motions that occur
/// exactly once in both lists are paired: the longest sequence of them that has the same order in both. Equal motions
/// next to a pair are paired too. Cost: n log n. Source: B. Cohen's patience diff (2005).
[[nodiscard]] MotionAlignment align_motions(const std::vector<std::string_view>& before,
                                            const std::vector<std::string_view>& after);

/// Maximum distance of two witnesses that count as the same place of the part; the second value holds if they also have
/// the same statement.
inline constexpr double kSamePlace_mm = 1, kSameStatement_mm = 10;

/// Returns whether two findings have the same tool, body and counterpart.
[[nodiscard]] bool is_alike(const EventRecord& a, const EventRecord& b);

/// Returns, for each finding of the new run, the matching findings of the old run, in order. All have the same tool,
/// body and counterpart, or a move of the old finding states the body and counterpart as a further contact. They match
/// by the motions that gouge in both runs. A finding whose motions do not occur in the
/// other run matches by statement and place, then by place alone. If the motions of an old finding are still checked,
/// another motion at its place is a new finding.
[[nodiscard]] std::vector<std::vector<std::size_t>> match_findings(const StoredResult& before,
                                                                   const StoredResult& after,
                                                                   const MotionAlignment& motions);

/// The witnesses of findings by place, for a search near a point that does not examine all of them.
class WitnessGrid {
 public:
  struct Near {
    std::size_t finding = 0;
    const MoveRecord* move = nullptr;
  };

  /// Builds the grid of these findings, for searches up to `reach_mm` (above 0). `result` must outlive it.
  WitnessGrid(const StoredResult& result, const std::vector<std::size_t>& findings, double reach_mm);

  /// Calls `call(near, distance in mm)` for each witness within reach, in an order that depends only on the witnesses.
  template <class Call>
  void for_each_near(const Vec3& point, Call&& call) const {
    const Cell middle = cell_of(point);
    for (int n = 0; n < 27; ++n) {
      const auto found = cells_.find({middle[0] + n % 3 - 1, middle[1] + n / 3 % 3 - 1, middle[2] + n / 9 - 1});
      if (found == cells_.end()) continue;
      for (const Near& near : found->second) {
        const double apart_mm = (near.move->witness->point_mm - point).norm();
        if (apart_mm <= reach_mm_) call(near, apart_mm);
      }
    }
  }

 private:
  using Cell = std::array<std::int64_t, 3>;
  [[nodiscard]] Cell cell_of(const Vec3& point) const;

  double reach_mm_;
  std::map<Cell, std::vector<Near>> cells_;
};

}  // namespace gouge
