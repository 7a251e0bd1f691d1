#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "lib/mesh/load_mesh.h"
#include "tests/support/source_folder.h"

// Parts other people's systems wrote, kept beside the project, not in it. Skipped where they are absent.

namespace gouge::real_parts_test {
namespace {

namespace fs = std::filesystem;

const std::string kParts = source_folder() + "/../shared/data/parts";

std::vector<std::string> part_files() {
  std::vector<std::string> files;
  if (!fs::exists(kParts)) return files;
  for (const auto& entry : fs::recursive_directory_iterator(kParts)) {
    if (entry.is_regular_file()) files.push_back(fs::relative(entry.path(), kParts).string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

TEST(RealParts, EveryFileLoadsOrIsRefusedForTheRightReason) {
  const std::vector<std::string> files = part_files();
  if (files.empty()) GTEST_SKIP() << "real parts absent: " << kParts;
  const std::map<std::string, std::string> refused = {
      {"broken/empty.stl", "stl-no-triangles"},
      {"broken/stl_empty_ascii.stl", "stl-no-triangles"},
      {"broken/stl_empty_bin.stl", "stl-no-triangles"},
  };
  for (const std::string& file : files) {
    const auto loaded = load_mesh(kParts + "/" + file);
    if (const auto expected = refused.find(file); expected != refused.end()) {
      ASSERT_FALSE(loaded.has_value()) << file;
      EXPECT_EQ(loaded.error().code, expected->second) << file;
    } else {
      ASSERT_TRUE(loaded.has_value()) << to_text(loaded.error());
      EXPECT_FALSE(loaded->mesh.triangles.empty()) << file;
    }
  }
}

TEST(RealParts, PartsThatToolpathsBelongToAreSolids) {
  if (part_files().empty()) GTEST_SKIP() << "real parts absent: " << kParts;
  for (const std::string file :
       {"Sacrifice-Board.STL", "SupPetriLED.STL", "Teste-Metrologia.STL", "basemach.STL", "five_axis_part_inch.stl"}) {
    const auto loaded = load_mesh(kParts + "/matched/" + file);
    ASSERT_TRUE(loaded.has_value());
    EXPECT_TRUE(loaded->findings.is_solid()) << file;
    EXPECT_GT(loaded->findings.signed_volume_mm3, 0) << file;
  }
}

TEST(RealParts, OddHeadersAreRead) {
  if (part_files().empty()) GTEST_SKIP() << "real parts absent: " << kParts;
  const std::map<std::string, std::size_t> triangles = {{"ascii_Cube.stl", 12},
                                                        {"ascii_Moon_Chinese.stl", 116},
                                                        {"binary_CubeInvalidUnicode.stl", 12},
                                                        {"binary_HalfDonut.stl", 288},
                                                        {"binary_StarWithEmptyHeader.stl", 68}};
  for (const auto& [file, count] : triangles) {
    const auto loaded = load_mesh(kParts + "/format_quirks/" + file);
    ASSERT_TRUE(loaded.has_value()) << to_text(loaded.error());
    EXPECT_EQ(loaded->mesh.triangles.size() + loaded->findings.degenerate_triangles.count, count) << file;
  }
}

}  // namespace
}  // namespace gouge::real_parts_test
