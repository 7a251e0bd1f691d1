#include <gtest/gtest.h>

#include <algorithm>

#include "tests/samples/program.h"
#include "tests/samples/sample_folder.h"

// Libraries that the program loads.

namespace gouge::testing_samples::start_test {
namespace {

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

}  // namespace
}  // namespace gouge::testing_samples::start_test
