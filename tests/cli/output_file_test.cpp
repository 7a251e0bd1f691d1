#include "cli/output/output_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "lib/base/files.h"
#include "tests/support/other_user.h"
#include "tests/support/temporary_folder.h"

namespace gouge::output_file_test {
namespace {

namespace fs = std::filesystem;

class OutputFile : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_ + "/there");
    std::ofstream(folder_ + "/old.csv") << "old";
  }

  [[nodiscard]] std::string reported(const std::string& file) const {
    const Diagnostics errors = find_unwritable({{"--csv", file}});
    return errors.empty() ? std::string() : errors.front().message;
  }

  testing_support::TemporaryFolder temporary_;
  std::string folder_ = temporary_.path();
};

TEST_F(OutputFile, WhatCannotBeWrittenIsFoundBefore) {
  const auto sentence = [](const std::string& why) {
    return "cannot write the file: " + why + "; nothing was written";
  };
  EXPECT_EQ(reported(folder_ + "/nix/all.csv"),
            sentence("the folder " + folder_ + "/nix does not exist; make it first"));
  EXPECT_EQ(reported(folder_ + "/there"), sentence("it is a folder"));
  EXPECT_EQ(reported(folder_ + "/old.csv/all.csv"), sentence(folder_ + "/old.csv is a file; expected a folder"));
  EXPECT_EQ(reported(folder_ + "/nix/"), sentence("it is the name of a folder; expected a file"));
  fs::create_symlink("circle", folder_ + "/circle");
  EXPECT_EQ(reported(folder_ + "/circle"), sentence("its symbolic links go in a circle"));
  fs::create_symlink("nix/all.csv", folder_ + "/link");
  EXPECT_EQ(reported(folder_ + "/link"), sentence("the folder " + folder_ + "/nix does not exist; make it first"));
  ::chmod((folder_ + "/there").c_str(), 0555);
  EXPECT_EQ(testing_support::as_nobody([&] {
              return reported(folder_ + "/there/all.csv") ==
                             sentence("the folder " + folder_ + "/there: Permission denied")
                         ? 0
                         : 1;
            }),
            0);
}

TEST_F(OutputFile, AFileOfAnotherUserOrWriteProtectedIsRefusedBefore) {
  ::chmod(folder_.c_str(), 0777);
  ::chmod((folder_ + "/old.csv").c_str(), 0444);
  if (::geteuid() != 0) {
    EXPECT_NE(reported(folder_ + "/old.csv").find("it is write-protected"), std::string::npos);
    return;
  }
  const auto is_reported = [&](const char* why) {
    return testing_support::as_nobody(
        [&] { return reported(folder_ + "/old.csv").find(why) == std::string::npos ? 1 : 0; });
  };
  EXPECT_EQ(is_reported("it is write-protected"), 0);
  ::chmod((folder_ + "/old.csv").c_str(), 0666);
  EXPECT_EQ(is_reported("it belongs to another user"), 0);
  ASSERT_EQ(::chown((folder_ + "/old.csv").c_str(), testing_support::kNobody, 4), 0);
  EXPECT_EQ(is_reported("its group is not one of yours"), 0);
}

TEST_F(OutputFile, WhatCanBeWrittenIsLeftAsItIs) {
  for (const std::string& file : {folder_ + "/old.csv", folder_ + "/new.csv", folder_ + "/there/new.csv",
                                  std::string("new.csv"), std::string("-"), std::string("/dev/null")})
    EXPECT_EQ(reported(file), "") << file;
  JobArguments job;
  job.report_folder = folder_ + "/report/of/today";
  EXPECT_TRUE(find_unwritable(outputs_of(job, "")).empty());
  EXPECT_FALSE(fs::exists(folder_ + "/report"));
  EXPECT_FALSE(fs::exists(folder_ + "/new.csv"));
  EXPECT_EQ(*read_file(folder_ + "/old.csv"), "old");
}

TEST_F(OutputFile, EveryOutputOfAJobIsLookedAt) {
  const std::string bad = folder_ + "/nix/x";
  EXPECT_EQ(find_unwritable(outputs_of(JobArguments{}, bad)).size(), 1U);
  for (std::string JobArguments::*output :
       {&JobArguments::json_file, &JobArguments::csv_file, &JobArguments::sarif_file, &JobArguments::junit_file}) {
    JobArguments job;
    job.*output = bad;
    EXPECT_EQ(find_unwritable(outputs_of(job, bad)).size(), 2U);
  }
  JobArguments job;
  job.report_folder = folder_ + "/old.csv/report";
  const Diagnostics errors = find_unwritable(outputs_of(job, ""));
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors.front().code, "folder-unwritable");
  EXPECT_EQ(errors.front().message,
            "cannot make the report: a file of the name " + folder_ + "/old.csv exists; nothing was written");
}

TEST_F(OutputFile, ADashIsStandardOutput) {
  std::ostringstream out;
  EXPECT_TRUE(write_output("-", "text", out).has_value());
  EXPECT_EQ(out.str(), "text");
  EXPECT_TRUE(write_output(folder_ + "/new.csv", "more", out).has_value());
  EXPECT_EQ(out.str(), "text");
  EXPECT_EQ(*read_file(folder_ + "/new.csv"), "more");
}

TEST_F(OutputFile, OutputsAppearTogetherOrNotAtAll) {
  std::ostringstream out;
  {
    PendingOutputs failing;
    EXPECT_TRUE(failing.add(folder_ + "/old.csv", "new").has_value());
    EXPECT_TRUE(failing.add("-", "text").has_value());
    EXPECT_FALSE(failing.add(folder_ + "/nix/x", "new").has_value());
  }
  EXPECT_EQ(*read_file(folder_ + "/old.csv"), "old");
  PendingOutputs pending;
  EXPECT_TRUE(pending.add(folder_ + "/old.csv", "new").has_value());
  EXPECT_TRUE(pending.add("-", "text").has_value());
  EXPECT_EQ(out.str() + *read_file(folder_ + "/old.csv"), "old");
  EXPECT_TRUE(pending.commit(out).has_value());
  EXPECT_EQ(out.str() + *read_file(folder_ + "/old.csv"), "textnew");
}

TEST_F(OutputFile, DataThatStandardOutputDoesNotTakeAreAFailure) {
  std::ostringstream out;
  out.setstate(std::ios::badbit);
  EXPECT_EQ(write_output("-", "text", out).error().code, "output-unwritable");
}

}  // namespace
}  // namespace gouge::output_file_test
