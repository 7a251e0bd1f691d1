#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/samples/program.h"
#include "tests/samples/sample_folder.h"

// Files that a run writes, replaces and keeps: docs/formats/report_folder.md.

namespace gouge::testing_samples::outputs_test {
namespace {

namespace fs = std::filesystem;

class Outputs : public testing::Test {
 protected:
  void SetUp() override { sample_ = open_sample("pocket"); }

  Outcome check(const std::vector<std::string>& more, const std::string& path = "pocket.apt") const {
    return run_gougecheck(sample_.path, sample_.arguments("check", path, more));
  }
  [[nodiscard]] std::string at(const std::string& name) const { return sample_.path + "/" + name; }
  [[nodiscard]] std::string text(const std::string& name) const { return text_of(at(name)); }

  SampleFolder sample_;
};

TEST_F(Outputs, AReportMayBeWrittenAgainAndAgain) {
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(check({"--report", "r"}).exit_status, 1);
    EXPECT_EQ(
        run_gougecheck(sample_.path, sample_.arguments("correct", "pocket.apt", {"-o", "out.apt", "--report", "r"}))
            .exit_status,
        0);
  }
}

TEST_F(Outputs, TheUsersFilesUnderNamesOfAReportAreRefusedBeforeTheWork) {
  fs::create_directories(at("r"));
  for (const char* name : {"moves.csv", "event_9.png", "report.html", "manifest.json"}) {
    write_text(at("r/") + name, "mine");
    const Outcome ran = check({"--report", "r", "--csv", "c.csv"});
    EXPECT_EQ(ran.exit_status, 2) << name;
    EXPECT_NE(ran.err.find(std::string("r: error: a report would replace or remove ") + name), std::string::npos)
        << ran.err;
    EXPECT_EQ(ran.out, "");
    EXPECT_EQ(text(std::string("r/") + name), "mine");
    EXPECT_FALSE(fs::exists(at("c.csv")));
    fs::remove(at("r/") + name);
  }
  write_text(at("r/moves.csv"), "mine");
  EXPECT_EQ(check({"--report", "r", "--force"}).exit_status, 1);
  EXPECT_EQ(check({"--report", "r"}).exit_status, 1);
}

TEST_F(Outputs, NoInputIsReplacedByAReportNotEvenWithForce) {
  fs::create_directories(at("r"));
  fs::copy_file(at("pocket.apt"), at("r/moves.csv"));
  fs::copy_file(at("part.stl"), at("r/event_3.png"));
  fs::copy_file(at("tools.json"), at("r/result.json"));
  const std::string path = text("pocket.apt");
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"check", "r/moves.csv", "--tools", "tools.json", "--part", "part.stl"},
        {"check", "pocket.apt", "--tools", "r/result.json", "--part", "part.stl"},
        {"check", "pocket.apt", "--tools", "tools.json", "--part", "./r/../r/event_3.png"},
        {"check", "pocket.apt", "--tools", "tools.json", "--part", "part.stl", "--fixture", "r/event_3.png"},
        {"check", "pocket.apt", "--tools", "tools.json", "--part", "part.stl", "--head", "r/event_3.png"}}) {
    std::vector<std::string> all = words;
    all.insert(all.end(), {"--report", "r", "--force"});
    const Outcome ran = run_gougecheck(sample_.path, all);
    EXPECT_EQ(ran.exit_status, 2) << ran.err;
    EXPECT_NE(ran.err.find("--report 'r' would replace or remove its file "), std::string::npos) << ran.err;
  }
  EXPECT_EQ(text("r/moves.csv"), path);
  EXPECT_EQ(text("r/event_3.png"), text("part.stl"));
  EXPECT_EQ(text("r/result.json"), text("tools.json"));
}

TEST_F(Outputs, NoOutputIsAFileOfTheReport) {
  const auto refused = [&](const std::vector<std::string>& more) {
    return run_gougecheck(sample_.path, sample_.arguments("correct", "pocket.apt", more));
  };
  const Outcome same = refused({"-o", "r/report.html", "--report", "r"});
  EXPECT_EQ(same.exit_status, 2);
  EXPECT_EQ(
      same.err,
      "gougecheck: error: -o 'r/report.html' is the file report.html of --report as well; name another file [usage]\n");
  EXPECT_EQ(refused({"-o", "r/event_9.png", "--report", "./r/"}).exit_status, 2);
  EXPECT_FALSE(fs::exists(at("r")));
}

TEST_F(Outputs, WhenOneOutputCannotBeWrittenNoneIs) {
  // A name that is too long is found only when it is written.
  const Outcome ran = check({"--csv", "c.csv", "--report", "r/" + std::string(300, 'x'), "--json", "j.json"});
  EXPECT_EQ(ran.exit_status, 5);
  EXPECT_NE(ran.out.find("moves: "), std::string::npos) << "the findings are printed all the same";
  for (const char* name : {"c.csv", "j.json", "r"}) EXPECT_FALSE(fs::exists(at(name))) << name;
}

TEST_F(Outputs, TheFileOfStandardOutputIsRefused) {
  const Outcome ran =
      run_script(sample_.path, "$GOUGECHECK check pocket.apt --tools tools.json --part part.stl --csv x.txt >x.txt");
  EXPECT_EQ(ran.exit_status, 2);
  EXPECT_EQ(ran.err, "gougecheck: error: --csv 'x.txt' is where standard output goes; name another file [usage]\n");
}

TEST_F(Outputs, ToolsAreDrawnIntoNoInput) {
  fs::copy_file(at("tools.json"), at("tools.svg"));
  const Outcome ran = run_gougecheck(sample_.path, {"tool", "draw", "--tools", "tools.svg", "-o", "./tools.svg"});
  EXPECT_EQ(ran.exit_status, 2) << ran.err;
  EXPECT_EQ(text("tools.svg"), text("tools.json"));
}

TEST_F(Outputs, AnImportSparesEveryFileOfTheLibrary) {
  write_text(at("shop.fctl"), R"({"label": "shop", "tools": [{"nr": 1, "path": "ball.fctb"}], "version": 1})");
  write_text(at("ball.fctb"), R"({"version": 2, "name": "ball", "shape": "ballend.fcstd", "parameter":
    {"CuttingEdgeHeight": "20 mm", "Diameter": "5 mm", "Length": "50 mm", "ShankDiameter": "5 mm"}, "attribute": {}})");
  const std::string bit = text("ball.fctb");
  const Outcome good = run_gougecheck(sample_.path, {"tool", "import", "shop.fctl", "-o", "new.json"});
  EXPECT_EQ(good.exit_status, 0) << good.err;
  const Outcome ran = run_gougecheck(sample_.path, {"tool", "import", "shop.fctl", "-o", "ball.fctb"});
  EXPECT_EQ(ran.exit_status, 2) << ran.err;
  EXPECT_EQ(text("ball.fctb"), bit);
}

// Otherwise a build server would show the results of an earlier run.
TEST_F(Outputs, FilesForBuildServersStateThatARunEndedWithoutAResult) {
  write_text(at("j.xml"), "of an earlier run");
  write_text(at("s.sarif"), "of an earlier run");
  const Outcome ran = check({"--junit", "j.xml", "--sarif", "s.sarif", "--json", "r.json"}, "missing.apt");
  EXPECT_EQ(ran.exit_status, 3);
  EXPECT_NE(text("j.xml").find("<error message=\"exit status 3; missing.apt: error: no such file [file-not-found]\"/>"),
            std::string::npos)
      << text("j.xml");
  const auto invocation = nlohmann::json::parse(text("s.sarif")).at("runs").at(0).at("invocations").at(0);
  EXPECT_EQ(invocation.at("executionSuccessful"), false);
  EXPECT_EQ(invocation.at("toolExecutionNotifications").at(0).at("descriptor").at("id"), "file-not-found");
  EXPECT_FALSE(fs::exists(at("r.json")));
  const Outcome printed = check({"--junit", "-"}, "missing.apt");
  EXPECT_EQ(printed.out, text("j.xml"));
}

}  // namespace
}  // namespace gouge::testing_samples::outputs_test
