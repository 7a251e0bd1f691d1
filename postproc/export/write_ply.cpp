#include "postproc/export/little_endian.h"
#include "postproc/export/write_scene.h"

namespace gouge {

Result<std::string> write_ply(const ExportScene& scene) {
  constexpr std::size_t kMaxVertices = 0x7FFFFFFF;
  std::size_t vertices = 0, faces = 0;
  for (const ExportMesh& mesh : scene.meshes) {
    if (!mesh.is_measured()) continue;
    vertices += mesh.positions.size();
    faces += mesh.triangles.size();
  }
  if (vertices > kMaxVertices)
    return make_error("scene-too-large", "a .ply file holds 2147483647 vertices at most; name a .vtp file");
  const double mm = mm_per(scene.unit);
  std::string header = "ply\nformat binary_little_endian 1.0\ncomment gougecheck: depth and overcut in ";
  header += unit_name(scene.unit);
  header += ", sampled; mesh 0, 1, ...: parts, then fixtures\nelement vertex " + std::to_string(vertices);
  for (const char* name : {"x", "y", "z"}) header += std::string("\nproperty double ") + name;
  for (const char* name : {"nx", "ny", "nz"}) header += std::string("\nproperty float ") + name;
  for (const char* name : {"red", "green", "blue"}) header += std::string("\nproperty uchar ") + name;
  header += "\nproperty float depth\nproperty float overcut\nproperty int mesh\nelement face " + std::to_string(faces) +
            "\nproperty list uchar int vertex_indices\nend_header\n";
  LittleEndian out;
  for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
    const ExportMesh& mesh = scene.meshes[m];
    if (!mesh.is_measured()) continue;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      out.f64(mesh.positions[v] / mm);
      out.f32(mesh.normals[v]);
      const Colour& c = mesh.colours[v];
      for (const auto channel : {c.r, c.g, c.b}) out.u8(static_cast<std::uint8_t>(channel));
      out.f32(static_cast<float>(static_cast<double>(mesh.depth_mm[v]) / mm));
      out.f32(static_cast<float>(static_cast<double>(mesh.overcut_mm[v]) / mm));
      out.i32(static_cast<std::int32_t>(m));
    }
  }
  std::uint32_t first = 0;
  for (const ExportMesh& mesh : scene.meshes) {
    if (!mesh.is_measured()) continue;
    for (const auto& triangle : mesh.triangles) {
      out.u8(3);
      for (const std::uint32_t corner : triangle) out.u32(first + corner);
    }
    first += static_cast<std::uint32_t>(mesh.positions.size());
  }
  return header + out.bytes();
}

}  // namespace gouge
