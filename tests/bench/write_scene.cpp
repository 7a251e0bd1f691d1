#include <cstdio>
#include <string>

#include "tests/bench/scene_files.h"

// Writes one case of the benchmark as files (scene_files.h):
//
//   write_scene FOLDER TRIANGLES [ball|bull|taper] [wavy|unseen] [all|clean|few]

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
  if (const gouge::Outcome written = write_scene_files(word(1), key, count > 5 ? word(5) : "all"); !written) {
    std::fprintf(stderr, "%s\n", to_text(written.error()).c_str());
    return 1;
  }
  return 0;
}
