#include "tests/bench/scene_files.h"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "lib/base/files.h"
#include "lib/base/number_text.h"
#include "lib/mesh/write_stl.h"
#include "toolmodels/tool_library.h"

namespace gouge::bench {
namespace {

constexpr std::size_t kFewStretches = 8;
constexpr double kLift_mm = 60;

std::string position_text(const Pose& pose) {
  std::string text = "GOTO/";
  for (const double x : {pose.tip.x(), pose.tip.y(), pose.tip.z(), pose.axis.x(), pose.axis.y(), pose.axis.z()})
    text += (text.back() == '/' ? " " : ", ") + exact_text(x);
  return text + "\n";
}

std::string path_text(const Workload& work, const std::string& choice) {
  std::string text = "PARTNO/BENCH\nUNITS/MM\nLOADTL/1\nFEDRAT/1000, MMPM\n";
  std::size_t stretches = 0;
  bool was_gouge = false;
  for (std::size_t i = 0; i < work.positions.size(); ++i) {
    const PlacedPose& p = work.positions[i];
    const bool is_gouge = p.lower_mm < -0.005 || p.holder_mm < -0.005;
    if (is_gouge && !was_gouge) ++stretches;
    was_gouge = is_gouge;
    const bool stays = choice == "all" || !is_gouge || (choice == "few" && stretches <= kFewStretches);
    text += position_text({p.pose.tip + (stays ? 0 : kLift_mm) * p.pose.axis, p.pose.axis});
  }
  return text + "FINI\n";
}

}  // namespace

Outcome write_scene_files(const std::string& folder, const WorkloadKey& key, const std::string& choice) {
  const Workload work = make_workload(key);
  ToolLibrary library;
  library.tools = {work.tool.assembly};
  const std::array<std::pair<const char*, std::string>, 3> files = {
      {{"part.stl", binary_stl_bytes(work.scene.parts[0], LengthUnit::mm)},
       {"tools.json", write_tool_library(library)},
       {"path.apt", path_text(work, choice)}}};
  if (Outcome made = make_folder(folder); !made) return made;
  for (const auto& [name, bytes] : files) {
    if (Outcome written = write_file(folder + "/" + name, bytes); !written) return written;
  }
  return Done{};
}

IndexedMesh make_head(double bottom_mm, int around, int steps) {
  constexpr double kRadius_mm = 16, kRounding_mm = 6, kHeight_mm = 60, kQuarter = std::numbers::pi / 2;
  std::vector<std::array<double, 2>> contour = {{0, bottom_mm}};
  for (int i = 0; i <= steps; ++i) {
    const double a = i * kQuarter / steps;
    contour.push_back({kRadius_mm - kRounding_mm * (1 - std::sin(a)), bottom_mm + kRounding_mm * (1 - std::cos(a))});
  }
  for (int i = 0; i <= steps; ++i) {
    const double a = i * kQuarter / steps;
    contour.push_back(
        {kRadius_mm - kRounding_mm * (1 - std::cos(a)), bottom_mm + kHeight_mm - kRounding_mm * (1 - std::sin(a))});
  }
  contour.push_back({0, bottom_mm + kHeight_mm});
  const auto rings = static_cast<std::uint32_t>(contour.size());
  const auto sides = static_cast<std::uint32_t>(around);
  IndexedMesh mesh;
  for (const auto& [r, z] : contour) {
    for (int k = 0; k < (r > 0 ? around : 1); ++k) {
      const double a = 4 * kQuarter * k / around;
      mesh.vertices.push_back({r * std::cos(a), r * std::sin(a), z});
    }
  }
  const auto vertex = [&](std::uint32_t ring, std::uint32_t k) {  // the first and the last ring are one vertex
    return ring == 0 ? 0 : ring + 1 == rings ? 1 + (rings - 2) * sides : 1 + (ring - 1) * sides + k % sides;
  };
  for (std::uint32_t i = 0; i + 1 < rings; ++i) {
    for (std::uint32_t k = 0; k < sides; ++k) {
      if (i > 0) mesh.triangles.push_back({vertex(i, k), vertex(i, k + 1), vertex(i + 1, k + 1)});
      if (i + 2 < rings) mesh.triangles.push_back({vertex(i, k), vertex(i + 1, k + 1), vertex(i + 1, k)});
    }
  }
  return mesh;
}

Outcome write_head_file(const std::string& file, double bottom_mm, int around, int steps) {
  return write_file(file, binary_stl_bytes(make_head(bottom_mm, around, steps), LengthUnit::mm));
}

}  // namespace gouge::bench
