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

/// A convex piece of a tool, in tool coordinates: a cylinder about the axis, or a box. A box that a cylinder was divided
/// into keeps the values of that cylinder. mm.
struct ToolPiece {
  bool is_box = false;
  double z_lo_mm = 0, z_hi_mm = 0, r_mm = 0;        ///< cylinder
  Vec3 center = Vec3::Zero(), half = Vec3::Zero();  ///< box

  [[nodiscard]] double height_mm() const { return is_box ? 2 * half.z() : z_hi_mm - z_lo_mm; }
  [[nodiscard]] Vec3 middle() const { return is_box ? center : Vec3(0, 0, 0.5 * (z_lo_mm + z_hi_mm)); }
  /// Returns the radius of a ball about middle() that contains the piece.
  [[nodiscard]] double ball_mm() const { return is_box ? half.norm() : Vec2(r_mm, 0.5 * height_mm()).norm(); }
  /// Bounds the distance of its points from the tip.
  [[nodiscard]] double reach_mm() const { return middle().norm() + ball_mm(); }
};

/// Discs whose hull contains a piece at both ends of a time interval. At every instant between, each point of the piece
/// is within `slack_mm` of the place that divides the straight way between its places at the ends alike.
struct SweptPiece {
  static constexpr std::size_t kMaxDiscs = 8;
  std::array<Disc, kMaxDiscs> at0, at1;
  std::size_t count = 0;
  double slack_mm = 0;

  [[nodiscard]] std::span<const Disc> start() const { return {at0.data(), count}; }
  [[nodiscard]] std::span<const Disc> end() const { return {at1.data(), count}; }
};

/// Returns the cylinders that contain all points of a body that are at least `depth_mm` inside it.
[[nodiscard]] std::vector<ToolPiece> deep_pieces(const CompiledTool& body, double depth_mm);

/// Ways to divide a piece: a cylinder by its height or into four boxes, a box at the middle of a side.
enum class Division : std::uint8_t { x, y, height, quarters };

/// Adds the parts of a piece. Parts of a cylinder without a point that is `depth_mm` inside the body are left out.
void divide_piece(const ToolPiece& piece, Division division, const CompiledTool& body, double depth_mm,
                  std::vector<ToolPiece>& parts);

/// Narrows a cylinder to the points that are `depth_mm` inside the body; a negative radius: there is none.
void narrow_piece(ToolPiece& cylinder, const CompiledTool& body, double depth_mm);

/// Returns the cylinders from which the pieces were divided, joined where they have the same radius. Boxes are in one frame
/// about the axis; cylinders are in every one. A cylinder also needs fewer questions if the tool follows its own cut.
[[nodiscard]] std::vector<ToolPiece> whole_cylinders(std::vector<ToolPiece> pieces);

/// Bounds the depth of all points of a piece in the body.
[[nodiscard]] double depth_upper_mm(const ToolPiece& piece, const CompiledTool& body);

}  // namespace gouge
