#include <gtest/gtest.h>

#include <filesystem>

#include "tests/samples/program.h"
#include "tests/samples/sample_folder.h"

// Limits of the system end in a message and status 5, or are none.

namespace gouge::testing_samples::limits_test {
namespace {

class Limits : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fresh_folder();
    write_text(
        folder_ + "/a.cls",
        "TOOL PATH/A,TOOL,T\nTLDATA/MILL,10.,0.,40.,0.,0.\nGOTO/2.,2.,9.,0.,0.,1.\nGOTO/2.,2.,-1.\nEND-OF-PATH\n");
    write_text(folder_ + "/a.stl",
               "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 9 0 0\nvertex 0 9 "
               "0\nendloop\nendfacet\nendsolid\n");
  }

  std::string folder_;
};

TEST_F(Limits, ThreadsBeyondAnyMachineAreRefused) {
  for (const char* command : {"check", "correct"}) {
    const Outcome outcome = run_gougecheck(folder_, {command, "a.cls", "--part", "a.stl", "--threads", "1000000",
                                                     std::string(command) == "check" ? "--csv" : "-o", "out"});
    EXPECT_EQ(outcome.exit_status, 2);
    EXPECT_EQ(outcome.err,
              "gougecheck: error: --threads '1000000': expected at most 1024, or 0 for all the machine has "
              "[too-many-threads]\n");
    EXPECT_FALSE(std::filesystem::exists(folder_ + "/out"));
  }
  EXPECT_EQ(run_gougecheck(folder_, {"check", "a.cls", "--part", "a.stl", "--threads", "1024"}).exit_status, 1);
}

#if !defined(GOUGE_SANITIZED)  // sanitizers map terabytes
TEST_F(Limits, LittleAddressSpaceEndsInAMessageOrInTheVerdict) {
  bool is_done = false, is_refused = false;
  // Below some 50 MB the system cannot load the program at all.
  for (const int megabytes : {80, 100, 130, 160, 200, 300, 1000}) {
    const auto [status, out, err] =
        run_script(folder_, "ulimit -v " + std::to_string(megabytes * 1'000'000 / 1024) +
                                "; exec $GOUGECHECK check a.cls --part a.stl --report report");
    if (status == 1) {
      is_done = true;
      continue;
    }
    EXPECT_EQ(status, 5) << megabytes << " MB: " << err;
    EXPECT_NE(err.find("[out-of-memory]"), std::string::npos) << megabytes << " MB: " << err;
    EXPECT_FALSE(is_done) << "less was enough";
    is_refused = true;
  }
  EXPECT_TRUE(is_done);
  EXPECT_TRUE(is_refused);
}
#endif

}  // namespace
}  // namespace gouge::testing_samples::limits_test
