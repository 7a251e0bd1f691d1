#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "lib/base/parallel.h"
#include "lib/base/result.h"
#include "lib/stock/excess_search.h"

namespace gouge {

/// A place of the part's surface where more material than asked may be left.
struct ExcessPlace {
  HighestColumn highest;                      ///< its height is 0 if nothing is proved
  double area_mm2 = 0, area_upper_mm2 = 0;    ///< of its columns that are higher than asked
  CutMove unknown;                            ///< without a proof: a move whose motion is not known and may reach it
  std::uint32_t first_piece = 0, pieces = 0;  ///< its pieces in ExcessResult::left

  [[nodiscard]] bool is_proved() const { return highest.height_mm > 0; }
};

/// The material that a program leaves on a part.
struct ExcessResult {
  std::vector<ExcessPlace> places;  ///< proved ones first, the highest first
  std::vector<LeftPiece> left;      ///< pieces of facets, place by place
  double surface_mm2 = 0;           ///< area of the part

  [[nodiscard]] double area_mm2() const;
  [[nodiscard]] double area_upper_mm2() const;
};

/// Finds where more than `height_mm` of material is left on the parts after all moves of a path. The material on a point of
/// a facet is the column along the facet's normal up to the first point that is removed, beside the stock, or nearer to
/// another point of a part. So the height of a column is the distance of its top from the part.
///
/// Requires height_mm > 0, and resolution_mm that of the history.
/// Ensures  (1) A column that is higher than asked + resolution, with cutters wider and the stock smaller by the
///          resolution, stands in one of the places. (2) A place with a height has a column of that height that is stock and that no tool
///          touched. (3) area_mm2 has only such columns, and area_upper_mm2 has all of (1). (4) The result is the same at
///          any number of threads.
/// Cost     Some microseconds for each piece of a facet; pieces are about as large as the area that one move cuts.
/// Source   docs/method/stock.md.
[[nodiscard]] ExcessResult find_excess(const ExcessQuestion& question, double height_mm, unsigned threads,
                                       const ProgressCall& progress = {});

/// The column above the middle of a piece of a facet, for pictures.
struct ColumnSample {
  std::array<Vec3, 3> corners{};
  double height_mm = 0;  ///< proved
};

/// Returns the columns of the pieces of a result, which are divided to `size_mm` or to about `most` pieces. Columns up to
/// `height_mm` are left out.
[[nodiscard]] std::vector<ColumnSample> sample_columns(const ExcessQuestion& question, const ExcessResult& result,
                                                       double height_mm, double size_mm, std::size_t most,
                                                       unsigned threads);

}  // namespace gouge
