#include <array>
#include <cstdio>
#include <string>
#include <utility>

#include "lib/base/files.h"
#include "lib/base/number_text.h"
#include "lib/mesh/write_stl.h"
#include "tests/bench/workload.h"
#include "toolmodels/tool_library.h"

// Writes one case of the benchmark as the files a user has, so that the whole command can be measured:
//
//   write_scene FOLDER TRIANGLES [ball|bull|taper] [wavy|unseen] [all|clean|few]
//
// part.stl, tools.json and path.apt of the workload's moves: all of them; clean: positions that gouge lifted along the
// tool's axis; few: only the first eight stretches of them left where they are.

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

int write(const std::string& folder, const WorkloadKey& key, const std::string& choice) {
  const Workload work = make_workload(key);
  ToolLibrary library;
  library.tools = {work.tool.assembly};
  const std::array<std::pair<const char*, std::string>, 3> files = {
      {{"part.stl", binary_stl_bytes(work.scene.parts[0], LengthUnit::mm)},
       {"tools.json", write_tool_library(library)},
       {"path.apt", path_text(work, choice)}}};
  if (!make_folder(folder)) return 1;
  for (const auto& [name, bytes] : files) {
    if (const Outcome written = write_file(folder + "/" + name, bytes); !written) {
      std::fprintf(stderr, "%s\n", to_text(written.error()).c_str());
      return 1;
    }
  }
  return 0;
}

}  // namespace
}  // namespace gouge::bench

int main(int count, char** words) {
  using namespace gouge::bench;
  if (count < 3) {
    std::fprintf(stderr, "write_scene FOLDER TRIANGLES [ball|bull|taper] [wavy|unseen] [all|clean|few]\n");
    return 2;
  }
  const auto word = [&](int k) { return std::string(k < count ? words[k] : ""); };
  WorkloadKey key;
  key.triangles = std::stoul(word(2));
  key.tool = word(3) == "bull" ? ToolKind::bull : word(3) == "taper" ? ToolKind::taper : ToolKind::ball;
  key.part = word(4) == "unseen" ? BenchPart::unseen : BenchPart::wavy;
  return write(word(1), key, count > 5 ? word(5) : "all");
}
