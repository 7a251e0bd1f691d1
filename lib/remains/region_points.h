#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "lib/remains/cell_grid.h"
#include "lib/remains/proved_cells.h"
#include "lib/remains/stock_side.h"
#include "lib/stock/hull_region.h"

namespace gouge {

/// The surface of a region within the cells of a grid: which corners belong to the region, and the points of the surface
/// on edges, on faces and in cells.
class RegionPoints {
 public:
  struct Corner {
    double value_mm = 0;
    bool is_in = false;  ///< in the region
  };
  /// The face of a cell, with the point of the surface on it.
  struct FacePoint {
    Vec3 at = Vec3::Zero();
    bool is_straight = false;  ///< on the segment between the points of both cells
  };

  RegionPoints(const CellGrid& grid, const StockSide& side, double inset_mm);

  /// Finds the values of corners that are not known; returns those that are new.
  std::vector<std::uint64_t> add_corners(const std::vector<std::uint64_t>& corners, const CellWork& work);
  /// Finds the points in divided cells and on their edges that are not known.
  void add_points(const std::vector<std::uint64_t>& cells, const CellWork& work);
  /// Takes a corner out of the region.
  void take_out(std::uint64_t corner);
  [[nodiscard]] bool can_pull_back(const GridIndex& cell) const;
  /// Moves the points of a cell towards the region. Returns whether that was possible.
  [[nodiscard]] bool pull_back(const GridIndex& cell);

  [[nodiscard]] const CellGrid& grid() const { return grid_; }
  [[nodiscard]] const Corner& corner(std::uint64_t key) const { return corners_.at(key); }
  [[nodiscard]] bool is_in(const GridIndex& corner) const { return corners_.at(grid_key(corner)).is_in; }
  /// Returns which corners of a cell are in the region, as bits. Their values must be known.
  [[nodiscard]] unsigned corners_in(const GridIndex& cell) const;
  /// Returns the surface's point on the edge from a corner along an axis; one end is in the region and one is not.
  [[nodiscard]] Vec3 on_edge(const GridIndex& corner, std::size_t axis) const;
  /// Returns the point on the face between a cell and the one before it along an axis. Both are divided.
  [[nodiscard]] FacePoint on_face(const GridIndex& cell, std::size_t axis) const;
  [[nodiscard]] Vec3 in_cell(const GridIndex& cell) const;
  /// Returns the part of a cell that is in the region, as convex pieces.
  [[nodiscard]] std::vector<HullRegion> pieces(const GridIndex& cell) const;

 private:
  struct EdgePoint {
    Vec3 at = Vec3::Zero(), rise = Vec3::UnitZ();
  };
  using Keys = std::vector<std::uint64_t>;

  [[nodiscard]] double value_at(const Vec3& corner) const;
  [[nodiscard]] EdgePoint cross(const GridIndex& corner, std::size_t axis) const;
  [[nodiscard]] Vec3 feature_of(const GridIndex& cell) const;
  [[nodiscard]] int pull_of(const GridIndex& cell) const;
  [[nodiscard]] Vec3 kept_within(const GridIndex& cell, const Vec3& point) const;

  CellGrid grid_;
  const StockSide& side_;
  double inset_mm_;
  double within_mm_;  // farther than this no value is needed
  double margin_;  // least distance of points from the ends of their edge, from the rim of their face; share of a cell
  std::unordered_map<std::uint64_t, Corner, GridHash> corners_;
  std::array<std::unordered_map<std::uint64_t, EdgePoint, GridHash>, 3> edges_;
  std::unordered_map<std::uint64_t, Vec3, GridHash> features_;
  std::unordered_map<std::uint64_t, int, GridHash> pulls_;
};

}  // namespace gouge
