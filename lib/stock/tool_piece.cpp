#include "lib/stock/tool_piece.h"

#include <algorithm>
#include <cmath>

#include "lib/base/tolerance.h"
#include "lib/stock/widest_radius.h"
#include "lib/tool/evaluate.h"

namespace gouge {

namespace {

/// Adds a cylinder; it continues the last one if it begins there with the same radius.
void append(const ToolPiece& piece, std::vector<ToolPiece>& pieces) {
  const bool continues = !pieces.empty() && std::abs(pieces.back().r_mm - piece.r_mm) <= Tolerance::kRounding_mm &&
                         !(pieces.back().z_hi_mm < piece.z_lo_mm);
  if (!continues) return pieces.push_back(piece);
  pieces.back().z_hi_mm = std::max(pieces.back().z_hi_mm, piece.z_hi_mm);
  pieces.back().r_mm = std::max(pieces.back().r_mm, piece.r_mm);
}

}  // namespace

std::vector<ToolPiece> whole_cylinders(std::vector<ToolPiece> pieces) {
  for (ToolPiece& piece : pieces) piece.is_box = false;
  std::sort(pieces.begin(), pieces.end(), [](const ToolPiece& a, const ToolPiece& b) {
    return a.z_lo_mm < b.z_lo_mm || (!(b.z_lo_mm < a.z_lo_mm) && a.r_mm > b.r_mm);
  });
  std::vector<ToolPiece> whole;
  for (const ToolPiece& piece : pieces) append(piece, whole);
  return whole;
}

std::vector<ToolPiece> deep_pieces(const CompiledTool& body, double depth_mm) {
  const double low = body.z_min_mm + depth_mm, high = body.z_max_mm - depth_mm;
  std::vector<ToolPiece> pieces;
  if (body.elements.empty() || !(high > low)) return pieces;
  std::vector<double> heights{low, high};
  for (const BoundaryElement& e : body.elements) {
    // Beyond a step the solid within the depth of it belongs to the other side.
    for (const double z : {e.a.y() - depth_mm, e.a.y(), e.a.y() + depth_mm})
      heights.push_back(std::clamp(z, low, high));
  }
  std::sort(heights.begin(), heights.end());
  for (std::size_t k = 0; k + 1 < heights.size(); ++k) {
    if (!(heights[k + 1] - heights[k] > Tolerance::kRounding_mm) && k + 2 < heights.size()) {
      heights[k + 1] = heights[k];
      continue;
    }
    ToolPiece piece;
    piece.z_lo_mm = heights[k];
    piece.z_hi_mm = heights[k + 1];
    piece.r_mm = widest_radius_mm(body, piece.z_lo_mm, piece.z_hi_mm, depth_mm);
    if (!(piece.r_mm >= 0)) continue;
    append(piece, pieces);
  }
  return pieces;
}

void narrow_piece(ToolPiece& cylinder, const CompiledTool& body, double depth_mm) {
  cylinder.r_mm = std::min(cylinder.r_mm, widest_radius_mm(body, cylinder.z_lo_mm, cylinder.z_hi_mm, depth_mm));
}

void divide_piece(const ToolPiece& piece, Division division, const CompiledTool& body, double depth_mm,
                  std::vector<ToolPiece>& parts) {
  ToolPiece part = piece;
  if (piece.is_box) {
    const auto side = static_cast<Eigen::Index>(division);
    part.half[side] *= 0.5;
    for (const double sign : {-1.0, 1.0}) {
      part.center[side] = piece.center[side] + sign * part.half[side];
      parts.push_back(part);
    }
  } else if (division == Division::height) {
    const double middle = piece.middle().z();
    for (const auto& [low, high] : {std::pair(piece.z_lo_mm, middle), std::pair(middle, piece.z_hi_mm)}) {
      part.z_lo_mm = low;
      part.z_hi_mm = high;
      part.r_mm = piece.r_mm;
      narrow_piece(part, body, depth_mm);
      if (part.r_mm >= 0) parts.push_back(part);
    }
  } else {
    part.is_box = true;
    const double half = 0.5 * piece.r_mm;
    part.half = Vec3(half, half, 0.5 * piece.height_mm());
    for (const double x : {-half, half})
      for (const double y : {-half, half}) {
        part.center = Vec3(x, y, piece.middle().z());
        parts.push_back(part);
      }
  }
}

double depth_upper_mm(const ToolPiece& piece, const CompiledTool& body) {
  if (piece.is_box) {
    return -signed_distance_mm(body, piece.center.head<2>().norm(), piece.center.z()) + piece.ball_mm();
  }
  const double widest = widest_radius_mm(body, piece.z_lo_mm, piece.z_hi_mm);
  return std::min({widest, piece.z_hi_mm - body.z_min_mm, body.z_max_mm - piece.z_lo_mm});
}

}  // namespace gouge
