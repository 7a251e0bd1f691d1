#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "lib/stock/disc.h"
#include "lib/tool/compiled_tool.h"

namespace gouge {

/// Shapes of pieces: a cylinder about the axis, or a part of one. A box is between two values of x, y and z, a sector
/// between two radii, two angles and two heights.
enum class PieceShape : std::uint8_t { cylinder, box, sector };

/// A piece of a tool, in tool coordinates. A box and a sector keep the values of their cylinder. mm, rad.
struct ToolPiece {
  PieceShape shape = PieceShape::cylinder;
  double z_lo_mm = 0, z_hi_mm = 0, r_mm = 0;  ///< cylinder
  Vec3 center = Vec3::Zero();                 ///< middle of a box in x, y, z, or of a sector in radius, angle, height
  Vec3 half = Vec3::Zero();                   ///< half of its extents; an angle is below a quarter turn

  [[nodiscard]] bool is_cylinder() const { return shape == PieceShape::cylinder; }
  [[nodiscard]] bool is_sector() const { return shape == PieceShape::sector; }
  [[nodiscard]] double height_mm() const { return is_cylinder() ? z_hi_mm - z_lo_mm : 2 * half.z(); }
  [[nodiscard]] Vec3 middle() const {
    if (is_cylinder()) return {0, 0, 0.5 * (z_lo_mm + z_hi_mm)};
    if (!is_sector()) return center;
    return {center.x() * std::cos(center.y()), center.x() * std::sin(center.y()), center.z()};
  }
  /// Returns the radius of a ball about middle() that contains the piece.
  [[nodiscard]] double ball_mm() const;
  /// Bounds the distance of its points from the tip.
  [[nodiscard]] double reach_mm() const { return middle().norm() + ball_mm(); }
};

/// Discs whose hull contains a piece, in tool coordinates.
struct PieceDiscs {
  static constexpr std::size_t kMax = 8;
  std::array<Disc, kMax> discs;
  std::size_t count = 0;
};

/// Returns both ends of a cylinder, the corners of a box, or those of a prism about a sector. A flat piece has fewer.
[[nodiscard]] PieceDiscs discs_of(const ToolPiece& piece);

/// Discs whose hull contains a piece at both ends of a time interval. At every instant between, each point of the piece
/// is within `slack_mm` of the place that divides the straight way between its places at the ends alike.
struct SweptPiece {
  static constexpr std::size_t kMaxDiscs = PieceDiscs::kMax;
  std::array<Disc, kMaxDiscs> at0, at1;
  std::size_t count = 0;
  double slack_mm = 0;

  [[nodiscard]] std::span<const Disc> start() const { return {at0.data(), count}; }
  [[nodiscard]] std::span<const Disc> end() const { return {at1.data(), count}; }
};

/// Returns the cylinders that contain all points of a body that are at least `depth_mm` inside it.
[[nodiscard]] std::vector<ToolPiece> deep_pieces(const CompiledTool& body, double depth_mm);

/// Ways to divide a piece: a cylinder by its height, into four boxes or into sectors. A box or a sector is divided at the
/// middle of its first extent (x or radius), the second one (y or angle), or its height.
enum class Division : std::uint8_t { first, second, height, boxes, sectors };

/// Number of sectors of a cylinder. Their corners are at 1.08 of its radius.
inline constexpr int kSectors = 8;

/// Returns the extent of a piece in the direction of a division. mm.
[[nodiscard]] double extent_mm(const ToolPiece& piece, Division division);
/// Returns the part of a piece between two shares of its extent, in [0, 1]. A cylinder is divided by its height alone.
[[nodiscard]] ToolPiece part_of(const ToolPiece& piece, Division division, double from, double to);
/// Returns the division of a box or sector that halves its largest extent.
[[nodiscard]] Division longest_extent(const ToolPiece& piece);

/// Heights by which a body is moved along its axis, during a time that is examined at once. A piece then contains the
/// places of the body's points at all of them.
struct AxialRange {
  double lo_mm = 0, hi_mm = 0;
};

/// Adds the parts of a piece. Parts without a point that is `depth_mm` inside the body are left out.
void divide_piece(const ToolPiece& piece, Division division, const CompiledTool& body, double depth_mm,
                  std::vector<ToolPiece>& parts, const AxialRange& along = {});

/// Narrows a cylinder to the points that are `depth_mm` inside the body; a negative radius: there is none.
void narrow_piece(ToolPiece& cylinder, const CompiledTool& body, double depth_mm, const AxialRange& along = {});

/// Returns the cylinders from which the pieces were divided, joined where they have the same radius. Boxes and sectors are in
/// one frame about the axis; cylinders are in every one. A cylinder also needs fewer questions if the tool follows its own cut.
[[nodiscard]] std::vector<ToolPiece> whole_cylinders(std::vector<ToolPiece> pieces);

/// Bounds the depth of all points of a piece in the body. The bound of a box or sector exceeds the depth by the range.
[[nodiscard]] double depth_upper_mm(const ToolPiece& piece, const CompiledTool& body, const AxialRange& along = {});

/// Proves that no point of a box or sector is deeper than `depth_mm` in the body at any height of the range. The range is
/// halved until each part has a proof. False: not proved, or a cylinder, or no range.
/// Cost  Several microseconds at most; one evaluation where the piece is deep in the middle of the range.
[[nodiscard]] bool is_no_deeper(const ToolPiece& piece, const CompiledTool& body, double depth_mm,
                                const AxialRange& along);

}  // namespace gouge
