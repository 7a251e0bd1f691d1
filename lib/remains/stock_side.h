#pragma once

#include <cstddef>

#include "lib/stock/cut_history.h"
#include "lib/stock/stock_solid.h"

namespace gouge {

/// One side of the boundary of the remaining stock: the space where material is surely gone, or where it is surely there.
class StockSide {
 public:
  virtual ~StockSide() = default;

  /// A guess how far a point is on this side, and the direction in which that grows.
  struct Value {
    double mm = 0;  ///< positive on this side, more than the inset from the boundary
    Vec3 rise = Vec3::UnitZ();
  };
  /// Returns the value; exact only where it is within `within_mm` of 0. Nothing is proved with it.
  [[nodiscard]] virtual Value at(const Vec3& point, double within_mm) const = 0;
  /// Returns false if values alone decide, for a picture.
  [[nodiscard]] virtual bool is_proved() const { return true; }
  /// Proves that a region is on this side. `hint` is a move that is tried first; the result does not depend on it.
  [[nodiscard]] virtual bool proves(const HullRegion& region, CutMove& hint) const = 0;
  /// Returns whether proves_widened may succeed where proves does not.
  [[nodiscard]] virtual bool has_slivers() const = 0;
  /// Proves the same if cutters count as wider by the resolution and the stock as smaller. It is for material between
  /// cuts that is thinner than twice the resolution.
  [[nodiscard]] virtual bool proves_widened(const HullRegion& region, CutMove& hint) const = 0;
};

/// The remaining stock after the first moves of a path.
struct StockAfter {
  const CutHistory& history;
  const StockSolid& stock;
  std::size_t before = 0;    ///< only moves before this one count
  double resolution_mm = 0;  ///< that of the history
  double rounding_mm = 0;    ///< regions are proved with this much more on all sides
  double inset_mm = 0;       ///< distance from the boundary at which values are 0
};

/// The space outside of the stock, or in one cutter during an earlier cut.
class GoneSide : public StockSide {
 public:
  explicit GoneSide(const StockAfter& after) : after_(after) {}
  [[nodiscard]] Value at(const Vec3& point, double within_mm) const override;
  [[nodiscard]] bool proves(const HullRegion& region, CutMove& hint) const override;
  [[nodiscard]] bool has_slivers() const override { return true; }
  [[nodiscard]] bool proves_widened(const HullRegion& region, CutMove& hint) const override;

 private:
  StockAfter after_;
};

/// The same space as values alone show it. Nothing is proved: it serves only for pictures.
class PicturedGoneSide : public GoneSide {
 public:
  using GoneSide::GoneSide;
  [[nodiscard]] bool is_proved() const override { return false; }
};

/// The space in the stock that no tool reached, with all its bodies.
class ThereSide : public StockSide {
 public:
  explicit ThereSide(const StockAfter& after) : after_(after) {}
  [[nodiscard]] Value at(const Vec3& point, double within_mm) const override;
  [[nodiscard]] bool proves(const HullRegion& region, CutMove& hint) const override;
  [[nodiscard]] bool has_slivers() const override { return false; }
  [[nodiscard]] bool proves_widened(const HullRegion&, CutMove&) const override { return false; }

 private:
  StockAfter after_;
};

}  // namespace gouge
