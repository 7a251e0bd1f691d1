#include "cli/output/overwriting.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "cli/output/report_folder.h"
#include "tests/support/temporary_folder.h"

namespace gouge::overwriting_test {
namespace {

namespace fs = std::filesystem;

class Overwriting : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_ + "/b");
    std::ofstream(path()) << "GOTO/0,0,0";
    std::ofstream(part()) << "solid";
  }

  [[nodiscard]] std::string path() const { return folder_ + "/a.apt"; }
  [[nodiscard]] std::string part() const { return folder_ + "/part.stl"; }
  [[nodiscard]] std::string reported(const OutputTable& outputs) const {
    const auto error = find_overwriting({{"the toolpath", path()}, {"the part", part()}}, outputs);
    return error ? error->message : std::string();
  }
  [[nodiscard]] static Output report(const std::string& folder) {
    return {"--report", folder, Output::Kind::report_folder};
  }

  testing_support::TemporaryFolder temporary_;
  std::string folder_ = temporary_.path();
};

TEST_F(Overwriting, OutputsAreNeitherInputsNorOneAnother) {
  const std::string same = folder_ + "/./b/../part.stl";
  EXPECT_EQ(reported({{"--csv", folder_ + "/new.csv"}, {"--json", "-"}, {"--sarif", ""}, {"--junit", "-"}}), "");
  EXPECT_EQ(reported({{"--csv", path()}}), "--csv '" + path() + "' is the toolpath itself; name another file");
  EXPECT_EQ(reported({{"--json", same}}), "--json '" + same + "' is the part itself; name another file");
  EXPECT_EQ(reported({{"--csv", folder_ + "/x"}, {"--json", folder_ + "/b/../x"}}),
            "--json '" + folder_ + "/b/../x' is the file of --csv as well; name another file");
}

TEST_F(Overwriting, NamesThatAreTooLongAreNotOneFile) {
  EXPECT_EQ(reported(asked_for({{"--json", std::string(300, 'a')}, {"--csv", std::string(300, 'b')}})), "");
}

TEST_F(Overwriting, LinksToNothingYetAreSeenThrough) {
  fs::create_symlink("new.csv", folder_ + "/link");
  EXPECT_NE(reported({{"--csv", folder_ + "/link"}, {"--json", folder_ + "/new.csv"}}), "");
  EXPECT_EQ(reported({{"--csv", folder_ + "/link"}, {"--json", folder_ + "/newer.csv"}}), "");
}

TEST_F(Overwriting, EveryInputOfAJobIsSpared) {
  JobArguments job;
  job.path = "path.apt";
  job.parts = {"part.stl"};
  job.fixtures = {"vise.stl"};
  job.heads = {"head.stl"};
  job.tools_file = "tools.json";
  const auto is_refused = [&](const JobArguments& arguments, const std::string& corrected) {
    return find_overwriting(inputs_of(arguments), outputs_of(arguments, corrected)).has_value();
  };
  EXPECT_FALSE(is_refused(job, "corrected.apt"));
  for (const char* file : {"path.apt", "part.stl", "vise.stl", "head.stl", "tools.json"}) {
    EXPECT_TRUE(is_refused(job, file)) << file;
    for (std::string JobArguments::*output :
         {&JobArguments::json_file, &JobArguments::csv_file, &JobArguments::sarif_file, &JobArguments::junit_file}) {
      JobArguments writing = job;
      writing.*output = file;
      EXPECT_TRUE(is_refused(writing, "")) << file;
    }
  }
}

TEST_F(Overwriting, NoFileOfAReportIsAnInputWhateverItsName) {
  const std::string out = folder_ + "/out";
  fs::create_directories(out);
  fs::create_directory_symlink("out", folder_ + "/other");
  EXPECT_EQ(reported({report(out)}), "");
  for (const std::string& name : names_of_report()) {
    const std::string file = out + "/" + name;
    const std::string expected = "--report '" + folder_ + "/other' would replace or remove its file " + name +
                                 ", which is the part '" + part() + "'; name another folder";
    fs::create_hard_link(part(), file);
    EXPECT_EQ(reported({report(folder_ + "/other")}), expected);
    fs::remove(file);
    fs::create_symlink("../part.stl", file);
    EXPECT_EQ(reported({report(folder_ + "/other")}), expected);
    fs::remove(file);
  }
  fs::create_hard_link(part(), out + "/my part.stl");
  EXPECT_EQ(reported({report(out)}), "") << "an input under a name of its own";
}

TEST_F(Overwriting, NoFileOfAReportIsAnotherOutput) {
  const std::string out = folder_ + "/not/made/yet";
  for (const std::string& name : names_of_report()) {
    const std::string file = out + "/../yet/" + name;
    EXPECT_EQ(reported({{"-o", file}, report(out)}),
              "-o '" + file + "' is the file " + name + " of --report as well; name another file");
    EXPECT_EQ(reported({report(out), {"-o", file}}), reported({{"-o", file}, report(out)}));
  }
  EXPECT_EQ(reported({{"--csv", out}, report(out)}),
            "--csv '" + out + "' is the folder of --report as well; name another file");
  EXPECT_EQ(reported({{"--csv", out + "/all.csv"}, report(out)}), "");
}

TEST_F(Overwriting, TheFileOfStandardOutputIsNoOther) {
  const std::string file = folder_ + "/out.csv";
  const int kept = ::dup(STDOUT_FILENO);
  ASSERT_NE(std::freopen(file.c_str(), "w", stdout), nullptr);
  const std::string message = reported({{"--csv", file}}), none = reported({{"--csv", folder_ + "/b/x"}});
  std::fflush(stdout);
  ::dup2(kept, STDOUT_FILENO);
  ::close(kept);
  EXPECT_EQ(message, "--csv '" + file + "' is where standard output goes; name another file");
  EXPECT_EQ(none, "");
}

TEST(OutputTable, EveryOutputIsInTheTable) {
  JobArguments job;
  job.json_file = "j";
  job.csv_file = "c";
  job.sarif_file = "s";
  job.junit_file = "u";
  job.report_folder = "r";
  job.export_files = {"e.glb", "e.ply"};
  std::string files;
  for (const Output& output : outputs_of(job, "o")) files += output.option + "=" + output.file + " ";
  EXPECT_EQ(files, "-o=o --json=j --csv=c --sarif=s --junit=u --report=r --export=e.glb --export=e.ply ");
  EXPECT_TRUE(outputs_of(JobArguments{}, "").empty());
}

TEST(OutputTable, StandardOutputBelongsToOne) {
  EXPECT_FALSE(*is_stdout_taken({{"--csv", "x"}}));
  EXPECT_TRUE(*is_stdout_taken({{"--csv", "-"}, {"--json", "x"}}));
  EXPECT_EQ(is_stdout_taken({{"--csv", "-"}, {"--json", "-"}}).error().code, "usage");
}

}  // namespace
}  // namespace gouge::overwriting_test
