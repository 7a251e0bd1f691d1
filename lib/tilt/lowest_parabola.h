#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "lib/tilt/tilt_space.h"

namespace gouge {

/// Tilts sorted into rows and columns. On a lattice many tilts share a few of them.
class TiltRows {
 public:
  explicit TiltRows(const std::vector<Tilt>& tilts);

 private:
  friend class LowestParabolas;
  struct At {
    double x = 0, y = 0;
    std::uint32_t tilt = 0, column = 0;
  };
  std::vector<At> by_row_, by_column_;  // sorted by y, then by x; sorted by x, then by y
  std::vector<double> columns_;         // the x of each column
};

/// A search for each tilt `to`: the tilt `from` with the minimum height(from) + steepness * |to - from|^2. Of equal
/// ones at one place, it takes the first.
///
/// Two passes compute lower envelopes of parabolas: along the rows of `from`, and then along the columns of `to`.
/// Cost     Linear in the tilts and in rows times columns.
/// Source   Felzenszwalb and Huttenlocher 2012, Distance transforms of sampled functions.
class LowestParabolas {
 public:
  static constexpr std::uint32_t kNoTilt = std::numeric_limits<std::uint32_t>::max();

  /// Returns a tilt of `from` for each tilt of `to`; kNoTilt if all heights are infinite. Requires one height for each
  /// tilt of `from`, finite or infinite, and steepness > 0.
  [[nodiscard]] const std::vector<std::uint32_t>& find(const TiltRows& from, const std::vector<double>& heights,
                                                       double steepness, const TiltRows& to);

 private:
  struct Parabola {
    double at = 0, lifted = 0;  // place of its minimum, and its value at 0 in units of the steepness
    double begin = 0;           // start of the stretch on which it is the lowest
    std::uint32_t tilt = 0;
  };
  void clear() { envelope_.clear(); }
  void add(double at, double height, std::uint32_t tilt);
  /// Returns the lowest of the added parabolas. Requires at least one.
  template <typename Where, typename Found>
  void look(std::size_t count, const Where& where, const Found& found) const;

  std::vector<Parabola> envelope_;
  std::vector<double> row_y_, row_heights_;  // of the rows with finite heights; their values at the columns of `to`
  std::vector<std::uint32_t> row_tilts_, found_;
};

}  // namespace gouge
