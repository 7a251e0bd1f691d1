#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "tests/samples/program.h"
#include "tests/samples/sample_folder.h"

// What the program loads, and what it does where a part of it cannot be loaded.

namespace gouge::testing_samples {
namespace {

namespace fs = std::filesystem;

#if !defined(GOUGE_SANITIZED)  // sanitizers bring libraries of their own
TEST(Start, LoadsFewLibrariesAndNoneOfThosePicturesAndRanksNeed) {
  const std::string folder = fresh_folder();
  const Outcome loaded = run_script(folder, "LD_TRACE_LOADED_OBJECTS=1 \"$GOUGECHECK\" --version");
  ASSERT_EQ(loaded.exit_status, 0) << loaded.err;
  ASSERT_NE(loaded.out.find("libstdc++"), std::string::npos) << loaded.out;
  EXPECT_LE(std::count(loaded.out.begin(), loaded.out.end(), '\n'), 25) << loaded.out;
  for (const char* library : {"libopencv", "libmpi", "libX11", "liblapack"})
    EXPECT_EQ(loaded.out.find(library), std::string::npos) << loaded.out;
}
#endif

TEST(Start, WithoutItsModuleForPicturesItChecksAllTheSameAndRefusesReportsBeforeTheWork) {
  const SampleFolder sample = open_sample("between_rib");
  fs::create_directories(sample.path + "/alone");
  // A copy of the program alone, as somebody takes it to another machine.
  const std::string alone = "cp \"$GOUGECHECK\" alone/gougecheck && alone/gougecheck check " + sample.toolpath() +
                            " --tools tools.json --part part.stl ";
  const Outcome checked = run_script(sample.path, alone + "--csv moves.csv");
  EXPECT_EQ(checked.exit_status, 1) << checked.err;
  EXPECT_TRUE(fs::exists(sample.path + "/moves.csv"));
  const Outcome refused = run_script(sample.path, alone + "--csv other.csv --report r");
  EXPECT_EQ(refused.exit_status, 5);
  EXPECT_NE(refused.err.find("gougecheck_pictures.so"), std::string::npos) << refused.err;
  EXPECT_NE(refused.err.find("[module-missing]"), std::string::npos) << refused.err;
  EXPECT_EQ(refused.out, "");
  EXPECT_FALSE(fs::exists(sample.path + "/other.csv") || fs::exists(sample.path + "/r"));
}

}  // namespace
}  // namespace gouge::testing_samples
