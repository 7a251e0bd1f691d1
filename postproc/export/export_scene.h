#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "lib/base/units.h"
#include "lib/check/verdict.h"
#include "lib/drawing/drawing.h"
#include "lib/geom/vec.h"

namespace gouge {

/// Role of a mesh in an exported scene. The values are written to VTP files.
enum class ExportKind : std::uint8_t { part = 0, fixture = 1, path = 2, tool = 3, head = 4 };

/// A surface with the findings on it, as values at its vertices. mm, part coordinates.
struct ExportMesh {
  std::string name;  ///< for a part, fixture or head: as the user named its file
  ExportKind kind = ExportKind::part;
  std::vector<Vec3> positions;
  std::vector<Eigen::Vector3f> normals;  ///< of unit length
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<float> depth_mm, overcut_mm;  ///< 0: no gouge, or no known overcut; 0 for tools and heads
  std::vector<Colour> colours;              ///< the colours of the report's pictures

  [[nodiscard]] bool is_measured() const { return kind == ExportKind::part || kind == ExportKind::fixture; }
};

/// Consecutive moves with the same state, as a line of at least two points.
struct ExportLine {
  MoveState state = MoveState::clean;
  bool is_rapid = false;
  std::vector<Vec3> points;
  std::vector<std::size_t> moves;  ///< move of each segment: one less than points
};

struct ExportScene {
  LengthUnit unit = LengthUnit::mm;  ///< unit of the toolpath
  std::vector<ExportMesh> meshes;    ///< parts, fixtures, then tools and heads; meshes without triangles are left out
  std::vector<ExportLine> lines;     ///< the path of the tip
};

}  // namespace gouge
