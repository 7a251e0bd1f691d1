#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "lib/mesh/load_mesh.h"
#include "lib/validate/repair_mesh.h"
#include "tests/support/source_folder.h"

// Parts other people's systems wrote, kept beside the project, not in it. Skipped where they are absent.

namespace gouge::real_parts_test {
namespace {

namespace fs = std::filesystem;

const std::string kParts = source_folder() + "/../shared/data/parts";

TEST(RealPartsValidation, EveryReadablePartIsJudgedAndRepairNeverHidesADefect) {
  if (!fs::exists(kParts)) GTEST_SKIP() << "real parts absent: " << kParts;
  std::size_t judged_count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(kParts)) {
    if (!entry.is_regular_file() || entry.file_size() > 1000000) continue;
    const auto loaded = load_mesh(entry.path().string());
    if (!loaded) continue;
    ++judged_count;
    const MeshValidation judged = validate_mesh(loaded->mesh, loaded->findings);
    EXPECT_EQ(judged.trouble, "") << entry.path();
    if (judged.is_sound()) continue;
    const Result<MeshRepair> repair = repair_mesh(loaded->mesh, judged, {});
    ASSERT_TRUE(repair.has_value()) << entry.path() << to_text(repair.error());
    const bool is_better = repair->after.defects() < judged.defects() && repair->after.trouble.empty();
    EXPECT_EQ(repair->is_better(), is_better) << entry.path();
    RecordProperty(entry.path().filename().string(),
                   std::to_string(judged.defects()) + " -> " + std::to_string(repair->after.defects()));
  }
  EXPECT_GT(judged_count, 15U);
}

TEST(RealPartsValidation, MachinedPartsAreSound) {
  if (!fs::exists(kParts)) GTEST_SKIP() << "real parts absent: " << kParts;
  for (const std::string file : {"matched/basemach.STL", "matched/Teste-Metrologia.STL"}) {
    const auto loaded = load_mesh(kParts + "/" + file);
    ASSERT_TRUE(loaded.has_value());
    EXPECT_TRUE(validate_mesh(loaded->mesh, loaded->findings).is_sound()) << file;
  }
}

}  // namespace
}  // namespace gouge::real_parts_test
