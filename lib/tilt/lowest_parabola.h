#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "lib/tilt/tilt_space.h"

namespace gouge {

/// Tilts by the rows and columns that they lie in: many in few on a lattice.
class TiltRows {
 public:
  explicit TiltRows(const std::vector<Tilt>& tilts);

 private:
  friend class LowestParabolas;
  struct At {
    double x = 0, y = 0;
    std::uint32_t tilt = 0, column = 0;
  };
  std::vector<At> by_row_, by_column_;  // in the order of y, then of x; in that of x, then of y
  std::vector<double> columns_;         // x of each
};

/// Finds for each tilt `to` the tilt `from` with the least height(from) + steepness * |to - from|^2; of equal ones that
/// are at one place the first.
///
/// Two passes of lower envelopes of parabolas, along the rows of `from` and then along the columns of `to`.
/// Cost     Linear in the tilts and in rows times columns.
/// Source   Felzenszwalb and Huttenlocher 2012, Distance transforms of sampled functions.
class LowestParabolas {
 public:
  static constexpr std::uint32_t kNoTilt = std::numeric_limits<std::uint32_t>::max();

  /// Requires heights that are finite or infinite, one a tilt, and steepness > 0. kNoTilt where all are infinite.
  [[nodiscard]] const std::vector<std::uint32_t>& find(const TiltRows& from, const std::vector<double>& heights,
                                                       double steepness, const TiltRows& to);

 private:
  struct Parabola {
    double at = 0, lifted = 0;  // where it is least, and its value at 0 in units of the steepness
    double begin = 0;           // from where on it is the lowest
    std::uint32_t tilt = 0;
  };
  void clear() { envelope_.clear(); }
  void add(double at, double height, std::uint32_t tilt);
  /// Lowest of those added. Requires at least one.
  template <typename Where, typename Found>
  void look(std::size_t count, const Where& where, const Found& found) const;

  std::vector<Parabola> envelope_;
  std::vector<double> row_y_, row_heights_;  // of the rows with any, and at each of them the columns of `to`
  std::vector<std::uint32_t> row_tilts_, found_;
};

}  // namespace gouge
