#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "lib/base/printable_text.h"
#include "postproc/export/little_endian.h"
#include "postproc/export/write_scene.h"
#include "postproc/image/colour_scale.h"
#include "postproc/report/report_model.h"
#include "postproc/report/report_text.h"

namespace gouge {
namespace {

using Json = nlohmann::ordered_json;

// Constants of the glTF 2.0 specification.
constexpr int kFloat = 5126, kUnsignedInt = 5125, kUnsignedShort = 5123;
constexpr int kArrayBuffer = 34962, kElementBuffer = 34963;
constexpr int kLines = 1, kTriangles = 4;
constexpr std::uint32_t kMagic = 0x46546C67, kVersion = 2, kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;
constexpr std::uint16_t kMaxShort = 65535;
constexpr std::uint64_t kMaxBytes = 0xFFFFFFFF;

// Converts a colour channel of a picture, which is meant for a screen (IEC 61966-2-1), to the linear one of glTF.
double linear(double channel) {
  const double c = channel / 255;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

Colour colour_of(MoveState state, bool is_rapid) {
  switch (state) {
    case MoveState::gouge:
    case MoveState::buried:
      return kAlarm;
    case MoveState::not_checked:
    case MoveState::not_certified:
      return {166, 110, 12, 1};
    default:
      return is_rapid ? kSoftInk : kCalm;
  }
}

class GlbWriter {
 public:
  explicit GlbWriter(const ExportScene& scene) : scene_(scene) {}

  Result<std::string> run() {
    Json children = Json::array();
    if (!scene_.meshes.empty()) {
      materials_.push_back({{"name", "surface"},
                            {"doubleSided", true},
                            {"pbrMetallicRoughness", {{"metallicFactor", 0}, {"roughnessFactor", 0.8}}}});
    }
    for (const ExportMesh& mesh : scene_.meshes) children.push_back(add_node(mesh.name, add_surface(mesh)));
    add_path(children);
    Json root = {{"name", "gougecheck"}};
    // This maps x to x, y to -z and z to y, and millimetres to metres.
    root["rotation"] = {-std::sqrt(0.5), 0, 0, std::sqrt(0.5)};
    root["scale"] = {0.001, 0.001, 0.001};
    if (!children.empty()) root["children"] = children;
    nodes_.push_back(root);
    return file();
  }

 private:
  std::size_t add_node(const std::string& name, std::size_t mesh) {
    nodes_.push_back({{"name", valid_utf8(name)}, {"mesh", mesh}});
    return nodes_.size() - 1;
  }

  std::size_t add_accessor(const LittleEndian& data, int target, int component, const char* type, std::size_t count) {
    views_.push_back(
        {{"buffer", 0}, {"byteOffset", binary_.size()}, {"byteLength", data.bytes().size()}, {"target", target}});
    binary_ += data.bytes();
    binary_.resize((binary_.size() + 3) / 4 * 4, '\0');
    accessors_.push_back(
        {{"bufferView", views_.size() - 1}, {"componentType", component}, {"count", count}, {"type", type}});
    return accessors_.size() - 1;
  }

  // Adds positions with their minimum and maximum, computed from the written values.
  std::size_t add_positions(const std::vector<Vec3>& points) {
    LittleEndian data;
    Eigen::Vector3f least = points.front().cast<float>(), most = least;
    for (const Vec3& p : points) {
      const Eigen::Vector3f v = p.cast<float>();
      least = least.cwiseMin(v);
      most = most.cwiseMax(v);
      data.f32(v);
    }
    const std::size_t index = add_accessor(data, kArrayBuffer, kFloat, "VEC3", points.size());
    accessors_[index]["min"] = {least.x(), least.y(), least.z()};
    accessors_[index]["max"] = {most.x(), most.y(), most.z()};
    return index;
  }

  std::size_t add_numbers(const std::vector<float>& values) {
    LittleEndian data;
    for (const float value : values) data.f32(value);
    return add_accessor(data, kArrayBuffer, kFloat, "SCALAR", values.size());
  }

  std::size_t add_surface(const ExportMesh& mesh) {
    LittleEndian normals, colours, corners;
    for (const Eigen::Vector3f& n : mesh.normals) normals.f32(n);
    for (const Colour& c : mesh.colours) {
      for (const double channel : {double(c.r), double(c.g), double(c.b)})
        colours.u16(static_cast<std::uint16_t>(std::lround(kMaxShort * linear(channel))));
      colours.u16(kMaxShort);
    }
    for (const auto& triangle : mesh.triangles) {
      for (const std::uint32_t corner : triangle) corners.u32(corner);
    }
    Json attributes = {{"POSITION", add_positions(mesh.positions)},
                       {"NORMAL", add_accessor(normals, kArrayBuffer, kFloat, "VEC3", mesh.normals.size())}};
    const std::size_t colour = add_accessor(colours, kArrayBuffer, kUnsignedShort, "VEC4", mesh.colours.size());
    accessors_[colour]["normalized"] = true;
    attributes["COLOR_0"] = colour;
    if (mesh.is_measured()) {
      attributes["_DEPTH"] = add_numbers(mesh.depth_mm);
      attributes["_OVERCUT"] = add_numbers(mesh.overcut_mm);
    }
    const std::size_t indices =
        add_accessor(corners, kElementBuffer, kUnsignedInt, "SCALAR", 3 * mesh.triangles.size());
    return add_mesh(mesh.name,
                    {{"attributes", attributes}, {"indices", indices}, {"mode", kTriangles}, {"material", 0}});
  }

  std::size_t add_mesh(const std::string& name, const Json& primitive) {
    meshes_.push_back({{"name", valid_utf8(name)}, {"primitives", Json::array({primitive})}});
    return meshes_.size() - 1;
  }

  // Adds the path. All lines of one state and kind are one mesh, so that a viewer can hide them together.
  void add_path(Json& children) {
    std::map<std::pair<MoveState, bool>, std::vector<const ExportLine*>> groups;
    for (const ExportLine& line : scene_.lines) groups[{line.state, line.is_rapid}].push_back(&line);
    for (const auto& [key, lines] : groups) {
      std::vector<Vec3> points;
      LittleEndian ends;
      std::size_t count = 0;
      for (const ExportLine* line : lines) {
        for (std::size_t k = 1; k < line->points.size(); ++k) {
          ends.u32(static_cast<std::uint32_t>(points.size() + k - 1));
          ends.u32(static_cast<std::uint32_t>(points.size() + k));
          count += 2;
        }
        points.insert(points.end(), line->points.begin(), line->points.end());
      }
      const std::string name = std::string("path, ") + state_name(key.first) + (key.second ? ", rapid" : "");
      const Colour c = colour_of(key.first, key.second);
      materials_.push_back({{"name", name},
                            {"pbrMetallicRoughness",
                             {{"baseColorFactor", {linear(c.r), linear(c.g), linear(c.b), 1}},
                              {"metallicFactor", 0},
                              {"roughnessFactor", 1}}}});
      const Json primitive = {{"attributes", {{"POSITION", add_positions(points)}}},
                              {"indices", add_accessor(ends, kElementBuffer, kUnsignedInt, "SCALAR", count)},
                              {"mode", kLines},
                              {"material", materials_.size() - 1}};
      children.push_back(add_node(name, add_mesh(name, primitive)));
    }
  }

  // Returns the file. An empty list is not allowed in glTF, so it is left out.
  [[nodiscard]] Result<std::string> file() const {
    Json json = {{"asset", {{"version", "2.0"}, {"generator", std::string(kProgramName) + " " + kProgramVersion}}},
                 {"scene", 0},
                 {"scenes", Json::array({{{"nodes", Json::array({nodes_.size() - 1})}}})},
                 {"nodes", nodes_}};
    if (!meshes_.empty()) {
      json["materials"] = materials_;
      json["meshes"] = meshes_;
      json["accessors"] = accessors_;
      json["bufferViews"] = views_;
      json["buffers"] = Json::array({{{"byteLength", binary_.size()}}});
    }
    std::string text = json.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    LittleEndian out;
    const std::size_t binary = binary_.empty() ? 0 : 8 + binary_.size();
    if (12 + 8 + text.size() + binary > kMaxBytes)
      return make_error("scene-too-large", "a .glb file holds 4 GiB at most; name a .vtp or .ply file");
    out.u32(kMagic);
    out.u32(kVersion);
    out.u32(static_cast<std::uint32_t>(12 + 8 + text.size() + binary));
    out.u32(static_cast<std::uint32_t>(text.size()));
    out.u32(kJsonChunk);
    std::string bytes = out.bytes() + text;
    if (binary_.empty()) return bytes;
    LittleEndian chunk;
    chunk.u32(static_cast<std::uint32_t>(binary_.size()));
    chunk.u32(kBinaryChunk);
    return bytes + chunk.bytes() + binary_;
  }

  const ExportScene& scene_;
  Json nodes_ = Json::array(), meshes_ = Json::array(), materials_ = Json::array(), accessors_ = Json::array(),
       views_ = Json::array();
  std::string binary_;
};

}  // namespace

Result<std::string> write_glb(const ExportScene& scene) { return GlbWriter(scene).run(); }

}  // namespace gouge
