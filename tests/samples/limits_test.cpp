#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

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

  // With an address space of at most `bytes`: what ulimit -v sets.
  [[nodiscard]] int status_within(rlim_t bytes, const std::vector<std::string>& arguments) const {
    const pid_t child = ::fork();
    if (child == 0) {
      const rlimit most{bytes, bytes};
      if (::setrlimit(RLIMIT_AS, &most) != 0) ::_exit(99);
      ::_exit(run_gougecheck(folder_, arguments).exit_status);
    }
    int status = 0;
    if (::waitpid(child, &status, 0) != child || !WIFEXITED(status)) return -1;
    return WEXITSTATUS(status);
  }

  std::string folder_;
};

TEST_F(Limits, ThreadsBeyondAnyMachineAreRefused) {
  for (const char* command : {"check", "correct"}) {
    const Outcome outcome = run_gougecheck(folder_, {command, "a.cls", "--part", "a.stl", "--threads", "1000000",
                                                     std::string(command) == "check" ? "--csv" : "-o", "out"});
    EXPECT_EQ(outcome.exit_status, 5);
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
  for (const rlim_t megabytes : {80U, 100U, 130U, 160U, 200U, 300U, 1000U}) {
    const int status =
        status_within(megabytes * 1'000'000, {"check", "a.cls", "--part", "a.stl", "--report", "report"});
    const std::string err = text_of(folder_ + "/.stderr");
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
