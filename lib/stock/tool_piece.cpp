#include "lib/stock/tool_piece.h"

#include <algorithm>
#include <cmath>
#include <numbers>

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
  for (ToolPiece& piece : pieces) piece.shape = PieceShape::cylinder;
  std::sort(pieces.begin(), pieces.end(), [](const ToolPiece& a, const ToolPiece& b) {
    return a.z_lo_mm < b.z_lo_mm || (!(b.z_lo_mm < a.z_lo_mm) && a.r_mm > b.r_mm);
  });
  std::vector<ToolPiece> whole;
  for (const ToolPiece& piece : pieces) append(piece, whole);
  return whole;
}

ToolPiece part_of(const ToolPiece& piece, Division d, double from, double to) {
  ToolPiece part = piece;
  if (!piece.is_cylinder()) {
    const auto k = static_cast<Eigen::Index>(d);
    part.center[k] += piece.half[k] * (from + to - 1);
    part.half[k] *= to - from;
  } else {
    part.z_lo_mm = piece.z_lo_mm + from * piece.height_mm();
    part.z_hi_mm = piece.z_lo_mm + to * piece.height_mm();
  }
  return part;
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

void narrow_piece(ToolPiece& cylinder, const CompiledTool& body, double depth_mm, const AxialRange& along) {
  cylinder.r_mm = std::min(
      cylinder.r_mm, widest_radius_mm(body, cylinder.z_lo_mm - along.hi_mm, cylinder.z_hi_mm - along.lo_mm, depth_mm));
}

double extent_mm(const ToolPiece& piece, Division division) {
  if (division == Division::height) return piece.height_mm();
  if (piece.is_cylinder()) return 2 * piece.r_mm;
  if (piece.is_sector() && division == Division::second)
    return 2 * piece.half.y() * (piece.center.x() + piece.half.x());
  return 2 * piece.half[static_cast<Eigen::Index>(division)];
}

Division longest_extent(const ToolPiece& piece) {
  Division longest = Division::first;
  for (const Division d : {Division::second, Division::height})
    if (extent_mm(piece, d) > extent_mm(piece, longest)) longest = d;
  return longest;
}

namespace {

void halve_height(const ToolPiece& cylinder, const CompiledTool& body, double depth_mm, const AxialRange& along,
                  std::vector<ToolPiece>& parts) {
  const double middle = cylinder.middle().z();
  for (const auto& [low, high] : {std::pair(cylinder.z_lo_mm, middle), std::pair(middle, cylinder.z_hi_mm)}) {
    ToolPiece part = cylinder;
    part.z_lo_mm = low;
    part.z_hi_mm = high;
    narrow_piece(part, body, depth_mm, along);
    if (part.r_mm >= 0) parts.push_back(part);
  }
}

void cut_boxes(const ToolPiece& cylinder, std::vector<ToolPiece>& parts) {
  ToolPiece part = cylinder;
  part.shape = PieceShape::box;
  const double half = 0.5 * cylinder.r_mm;
  part.half = Vec3(half, half, 0.5 * cylinder.height_mm());
  for (const double x : {-half, half})
    for (const double y : {-half, half}) {
      part.center = Vec3(x, y, cylinder.middle().z());
      parts.push_back(part);
    }
}

void cut_sectors(const ToolPiece& cylinder, std::vector<ToolPiece>& parts) {
  ToolPiece part = cylinder;
  part.shape = PieceShape::sector;
  const double half_angle = std::numbers::pi / kSectors;
  part.half = Vec3(0.5 * cylinder.r_mm, half_angle, 0.5 * cylinder.height_mm());
  for (int k = 0; k < kSectors; ++k) {
    part.center = Vec3(0.5 * cylinder.r_mm, (2 * k + 1) * half_angle, cylinder.middle().z());
    parts.push_back(part);
  }
}

}  // namespace

void divide_piece(const ToolPiece& piece, Division division, const CompiledTool& body, double depth_mm,
                  std::vector<ToolPiece>& parts, const AxialRange& along) {
  if (division == Division::boxes) return cut_boxes(piece, parts);
  if (division == Division::sectors) return cut_sectors(piece, parts);
  if (piece.is_cylinder()) return halve_height(piece, body, depth_mm, along, parts);
  ToolPiece part = piece;
  const auto extent = static_cast<Eigen::Index>(division);
  part.half[extent] *= 0.5;
  for (const double sign : {-1.0, 1.0}) {
    part.center[extent] = piece.center[extent] + sign * part.half[extent];
    parts.push_back(part);
  }
}

double depth_upper_mm(const ToolPiece& piece, const CompiledTool& body, const AxialRange& along) {
  const double half_way = 0.5 * (along.hi_mm - along.lo_mm), middle_way = 0.5 * (along.hi_mm + along.lo_mm);
  if (piece.is_cylinder()) {
    const double low = piece.z_lo_mm - along.hi_mm, high = piece.z_hi_mm - along.lo_mm;
    return std::min({widest_radius_mm(body, low, high), high - body.z_min_mm, body.z_max_mm - low});
  }
  // All points of a sector are within its extents in radius and height of its middle, in the half plane of the tool.
  const double r = piece.is_sector() ? piece.center.x() : piece.center.head<2>().norm();
  const double reach = piece.is_sector() ? Vec2(piece.half.x(), piece.half.z()).norm() : piece.ball_mm();
  return half_way + reach - signed_distance_mm(body, r, piece.center.z() - middle_way);
}

namespace {

/// Corners of the prism about a sector across the axis, as seen from its middle direction: outward and sideways.
/// The tangents at both ends of the outer arc meet at its radius divided by the cosine of half the angle; the corners are
/// as far out. The chord of the inner arc is inside the sector's own.
struct SectorCorners {
  Vec2 outer, inner;
};

SectorCorners corners_of(const ToolPiece& sector) {
  const double sine = std::sin(sector.half.y()), cosine = std::cos(sector.half.y());
  const double outer = sector.center.x() + sector.half.x(), inner = std::max(0.0, sector.center.x() - sector.half.x());
  return {Vec2(outer, outer * sine / cosine), Vec2(inner * cosine, inner * sine)};
}

void add_sector(const ToolPiece& sector, PieceDiscs& all) {
  const SectorCorners corners = corners_of(sector);
  const Vec3 out(std::cos(sector.center.y()), std::sin(sector.center.y()), 0), side(-out.y(), out.x(), 0);
  const auto add = [&](const Vec2& corner) {
    for (const double y : {corner.y(), -corner.y()}) {
      const Vec3 at = corner.x() * out + y * side;
      for (const double z : {sector.center.z() - sector.half.z(), sector.center.z() + sector.half.z()}) {
        all.discs[all.count++] = {at + Vec3(0, 0, z), Vec3::UnitZ(), 0};
        if (!(sector.half.z() > 0)) break;
      }
      if (!(sector.half.y() > 0)) break;
    }
  };
  add(corners.outer);
  if (sector.half.x() > 0) add(corners.inner);
}

}  // namespace

double ToolPiece::ball_mm() const {
  if (is_cylinder()) return Vec2(r_mm, 0.5 * height_mm()).norm();
  if (!is_sector()) return half.norm();
  const SectorCorners corners = corners_of(*this);
  const Vec2 from(center.x(), 0);
  const double across = std::max((corners.outer - from).squaredNorm(), (corners.inner - from).squaredNorm());
  return std::sqrt(across + half.z() * half.z());
}

PieceDiscs discs_of(const ToolPiece& piece) {
  PieceDiscs all;
  const auto add = [&](const Vec3& at, double radius) { all.discs[all.count++] = {at, Vec3::UnitZ(), radius}; };
  if (piece.is_sector()) {
    add_sector(piece, all);
  } else if (piece.is_cylinder()) {
    add({0, 0, piece.z_lo_mm}, piece.r_mm);
    if (piece.z_hi_mm > piece.z_lo_mm) add({0, 0, piece.z_hi_mm}, piece.r_mm);
  } else {
    for (int corner = 0; corner < 8; ++corner) {
      bool is_twice = false;
      Vec3 at = piece.center;
      for (int k = 0; k < 3; ++k) {
        const bool is_high = (corner >> k & 1) != 0;
        is_twice = is_twice || (is_high && !(piece.half[k] > 0));
        at[k] += is_high ? piece.half[k] : -piece.half[k];
      }
      if (!is_twice) add(at, 0);
    }
  }
  return all;
}

}  // namespace gouge
