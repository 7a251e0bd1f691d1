#include "postproc/export/little_endian.h"
#include "postproc/export/write_scene.h"
#include "postproc/report/report_text.h"

namespace gouge {
namespace {

/// The arrays of a PolyData: points of the surfaces, then of the path. Lines precede triangles, which is the order of
/// cells in VTK.
class PolyData {
 public:
  explicit PolyData(const ExportScene& scene) : mm_(mm_per(scene.unit)) {
    for (std::size_t m = 0; m < scene.meshes.size(); ++m) add_points(scene.meshes[m]);
    for (const ExportLine& line : scene.lines) add_line(line);
    std::uint32_t first = 0;
    for (std::size_t m = 0; m < scene.meshes.size(); ++m) first = add_triangles(scene.meshes[m], m, first);
  }

  [[nodiscard]] std::string text() const {
    const std::string counts = "NumberOfPoints=\"" + std::to_string(points_count_) +
                               "\" NumberOfVerts=\"0\" NumberOfLines=\"" + std::to_string(line_count_) +
                               "\" NumberOfStrips=\"0\" NumberOfPolys=\"" + std::to_string(triangle_count_) + "\"";
    return "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
           "header_type=\"UInt64\">\n<PolyData>\n<Piece " +
           counts + ">\n<PointData Scalars=\"overcut\">\n" + array("Float32", "depth", 1, depth_) +
           array("Float32", "overcut", 1, overcut_) + "</PointData>\n<CellData>\n" + array("Int32", "kind", 1, kind_) +
           array("Int32", "mesh", 1, mesh_) + array("Int32", "state", 1, state_) + array("Int64", "move", 1, move_) +
           "</CellData>\n<Points>\n" + array("Float64", "Points", 3, points_) + "</Points>\n<Lines>\n" +
           array("Int64", "connectivity", 1, line_corners_) + array("Int64", "offsets", 1, line_ends_) +
           "</Lines>\n<Polys>\n" + array("Int64", "connectivity", 1, corners_) + array("Int64", "offsets", 1, ends_) +
           "</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n";
  }

 private:
  void add_points(const ExportMesh& mesh) {
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      points_.f64(mesh.positions[v] / mm_);
      depth_.f32(static_cast<float>(static_cast<double>(mesh.depth_mm[v]) / mm_));
      overcut_.f32(static_cast<float>(static_cast<double>(mesh.overcut_mm[v]) / mm_));
    }
    points_count_ += mesh.positions.size();
  }

  // Adds a line. Each segment is a cell, so that each has its move.
  void add_line(const ExportLine& line) {
    for (std::size_t k = 0; k < line.points.size(); ++k) {
      points_.f64(line.points[k] / mm_);
      depth_.f32(0);
      overcut_.f32(0);
      if (k == 0) continue;
      line_corners_.u64(points_count_ + k - 1);
      line_corners_.u64(points_count_ + k);
      line_ends_.u64(2 * ++line_count_);
      add_cell(ExportKind::path, -1, static_cast<std::int32_t>(line.state),
               static_cast<std::int64_t>(line.moves[k - 1]));
    }
    points_count_ += line.points.size();
  }

  std::uint32_t add_triangles(const ExportMesh& mesh, std::size_t index, std::uint32_t first) {
    for (const auto& triangle : mesh.triangles) {
      for (const std::uint32_t corner : triangle) corners_.u64(std::uint64_t{first} + corner);
      ends_.u64(3 * ++triangle_count_);
      add_cell(mesh.kind, static_cast<std::int32_t>(index), -1, -1);
    }
    return first + static_cast<std::uint32_t>(mesh.positions.size());
  }

  void add_cell(ExportKind kind, std::int32_t mesh, std::int32_t state, std::int64_t move) {
    kind_.i32(static_cast<std::int32_t>(kind));
    mesh_.i32(mesh);
    state_.i32(state);
    move_.i64(move);
  }

  static std::string array(const char* type, const char* name, int components, const LittleEndian& data) {
    LittleEndian size;
    size.u64(data.bytes().size());
    return std::string("<DataArray type=\"") + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" +
           std::to_string(components) + "\" format=\"binary\">" + base64(size.bytes() + data.bytes()) +
           "</DataArray>\n";
  }

  double mm_;
  std::size_t points_count_ = 0, line_count_ = 0, triangle_count_ = 0;
  LittleEndian points_, depth_, overcut_, line_corners_, line_ends_, corners_, ends_, kind_, mesh_, state_, move_;
};

}  // namespace

Result<std::string> write_vtp(const ExportScene& scene) { return PolyData(scene).text(); }

}  // namespace gouge
