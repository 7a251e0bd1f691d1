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

namespace {

/// A box or sector in the half plane of the tool: a disc that contains it, its least radius, and its heights.
struct HalfPlanePart {
  double r_mm = 0, z_mm = 0, reach_mm = 0;
  double least_r_mm = 0, half_height_mm = 0;
};

HalfPlanePart half_plane_part(const ToolPiece& piece) {
  HalfPlanePart part;
  part.z_mm = piece.center.z();
  part.half_height_mm = piece.half.z();
  if (piece.is_sector()) {
    // All points are within the extents in radius and height of the middle.
    part.r_mm = piece.center.x();
    part.reach_mm = Vec2(piece.half.x(), piece.half.z()).norm();
    part.least_r_mm = std::max(0.0, piece.center.x() - piece.half.x());
  } else {
    part.r_mm = piece.center.head<2>().norm();
    part.reach_mm = piece.ball_mm();
    part.least_r_mm = (piece.center.cwiseAbs() - piece.half).cwiseMax(0).head<2>().norm();
  }
  return part;
}

// Parts of a range after which a proof along it is given up.
constexpr int kMaxRangeParts = 64;

/// Halves a range of heights until a bound proves each part. Two bounds serve: the radius of deep points is exact along
/// walls that are parallel to the axis, and the distance from the boundary is exact for small ranges of any shape.
class DepthAlong {
 public:
  DepthAlong(const HalfPlanePart& part, const CompiledTool& body, double depth_mm)
      : part_(part), body_(body), depth_mm_(depth_mm) {}

  bool is_no_deeper(double lo_mm, double hi_mm) {
    if (++parts_ > kMaxRangeParts) return false;
    const double middle = 0.5 * (lo_mm + hi_mm);
    const double room = signed_distance_mm(body_, part_.r_mm, part_.z_mm - middle) - part_.reach_mm + depth_mm_;
    if (room < 0) return false;
    if (room >= 0.5 * (hi_mm - lo_mm)) return true;
    const double low = part_.z_mm - part_.half_height_mm - hi_mm, high = part_.z_mm + part_.half_height_mm - lo_mm;
    if (part_.least_r_mm > widest_radius_mm(body_, low, high, depth_mm_) + Tolerance::kRounding_mm) return true;
    return is_no_deeper(lo_mm, middle) && is_no_deeper(middle, hi_mm);
  }

 private:
  const HalfPlanePart& part_;
  const CompiledTool& body_;
  double depth_mm_;
  int parts_ = 0;
};

}  // namespace

double depth_upper_mm(const ToolPiece& piece, const CompiledTool& body, const AxialRange& along) {
  const double half_way = 0.5 * (along.hi_mm - along.lo_mm), middle_way = 0.5 * (along.hi_mm + along.lo_mm);
  if (piece.is_cylinder()) {
    const double low = piece.z_lo_mm - along.hi_mm, high = piece.z_hi_mm - along.lo_mm;
    return std::min({widest_radius_mm(body, low, high), high - body.z_min_mm, body.z_max_mm - low});
  }
  const HalfPlanePart part = half_plane_part(piece);
  return half_way + part.reach_mm - signed_distance_mm(body, part.r_mm, part.z_mm - middle_way);
}

bool is_no_deeper(const ToolPiece& piece, const CompiledTool& body, double depth_mm, const AxialRange& along) {
  if (piece.is_cylinder() || !(along.hi_mm > along.lo_mm)) return false;
  const HalfPlanePart part = half_plane_part(piece);
  return DepthAlong(part, body, depth_mm).is_no_deeper(along.lo_mm, along.hi_mm);
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
