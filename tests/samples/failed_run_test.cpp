#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/samples/program.h"
#include "tests/samples/small_shop.h"

// --junit and --sarif of runs that end without a result. A build server must not show the results of an earlier run.

namespace gouge::testing_samples::failed_run_test {
namespace {

using Words = std::vector<std::string>;

const std::string kOld = "of an earlier run";

class FailedRun : public testing::Test {
 protected:
  FailedRun() {
    shop_.write("a.apt", path_text(stations()));
    shop_.write("part.stl", plate_stl());
  }

  [[nodiscard]] Outcome run(Words words) const {
    shop_.write("j.xml", kOld);
    shop_.write("s.sarif", kOld);
    words.insert(words.end(), {"--junit", "j.xml", "--sarif", "s.sarif"});
    return shop_.run(words);
  }

  // Expects that the run ends with this status, and that both files state it with the code.
  void expect_stated(const Words& words, int status, const std::string& code) const {
    const Outcome ran = run(words);
    const std::string line = testing::PrintToString(words) + "\n" + ran.err;
    EXPECT_EQ(ran.exit_status, status) << line;
    EXPECT_NE(ran.err.find("[" + code + "]"), std::string::npos) << line;
    const std::string junit = shop_.read("j.xml");
    EXPECT_NE(junit.find("<error message=\"exit status " + std::to_string(status)), std::string::npos) << line << junit;
    EXPECT_NE(junit.find("[" + code + "]"), std::string::npos) << line << junit;
    ASSERT_TRUE(nlohmann::json::accept(shop_.read("s.sarif"))) << line;
    const nlohmann::json invocation = shop_.json("s.sarif").at("runs").at(0).at("invocations").at(0);
    EXPECT_EQ(invocation.at("executionSuccessful"), false) << line;
    EXPECT_EQ(invocation.at("toolExecutionNotifications").at(0).at("descriptor").at("id"), code) << line;
  }

  SmallShop shop_;
};

TEST_F(FailedRun, IsStatedInEachFormOfTheCommand) {
  shop_.write("empty.stl", "");
  shop_.write("empty.apt", "");
  shop_.write("u16.apt", std::string("\xff\xfeG\0O\0", 6));
  shop_.write("a.png", "\x89PNG\r\n\x1a\n");
  ASSERT_EQ(shop_.run_script("mkdir folder.apt").exit_status, 0);
  struct Fault {
    std::string path, part, code;
  };
  for (const Fault& fault : {Fault{"none.apt", "part.stl", "file-not-found"},
                             {"a.apt", "none.stl", "file-not-found"},
                             {"folder.apt", "part.stl", "file-is-folder"},
                             {"a.apt", "folder.apt", "file-is-folder"},
                             {"empty.apt", "part.stl", "path-empty"},
                             {"a.apt", "empty.stl", "stl-empty"},
                             {"u16.apt", "part.stl", "path-not-cl-data"},
                             {"a.png", "part.stl", "path-not-cl-data"}}) {
    expect_stated({fault.path, fault.part}, 3, fault.code);
    expect_stated({"check", fault.path, "--part", fault.part}, 3, fault.code);
    expect_stated({"correct", fault.path, "--part", fault.part, "-o", "o.apt"}, 3, fault.code);
  }
  expect_stated({"a.apt", "part.stl", "none.json"}, 3, "file-not-found");
  expect_stated({"empty.apt"}, 3, "path-empty");
  expect_stated({"u16.apt"}, 3, "path-not-cl-data");
  expect_stated({"check", "a.apt", "--part", "part.stl", "--tools", "none.json"}, 3, "file-not-found");
}

TEST_F(FailedRun, NamesTheToolpathAsACleanRunDoes) {
  const std::string name = "name=\"gougecheck a.apt\"";
  ASSERT_EQ(run({"a.apt", "part.stl"}).exit_status, 0);
  EXPECT_NE(shop_.read("j.xml").find(name), std::string::npos) << shop_.read("j.xml");
  ASSERT_EQ(run({"a.apt", "none.stl"}).exit_status, 3);
  EXPECT_NE(shop_.read("j.xml").find(name), std::string::npos) << shop_.read("j.xml");
}

TEST_F(FailedRun, IsStatedIfTheProjectFileIsWrong) {
  for (const auto& [text, code] : {std::pair("{\"part\":", "project-syntax"),
                                   {R"({"part": "part.stl", "tolerence": 1})", "project-option"},
                                   {R"({"part": "part.stl", "tolerance": "x"})", "project-option"},
                                   {R"({"part": "part.stl", "threads": "x"})", "project-option"}}) {
    shop_.write("gougecheck.json", text);
    expect_stated({"check", "a.apt"}, 3, code);
    expect_stated({"./a.apt"}, 3, code);
    expect_stated({"correct", "a.apt", "-o", "o.apt"}, 3, code);
  }
}

TEST_F(FailedRun, IsStatedIfAnotherOutputCannotBeWritten) {
  expect_stated({"check", "a.apt", "--part", "part.stl", "--json", "none/r.json"}, 5, "file-unwritable");
  expect_stated({"a.apt", "part.stl", "--report", "none/" + std::string(300, 'x')}, 5, "folder-unwritable");
  const Outcome full = shop_.run_script("$GOUGECHECK check a.apt --part part.stl --junit j.xml > /dev/full");
  EXPECT_EQ(full.exit_status, 5);
  EXPECT_NE(shop_.read("j.xml").find("[output-unwritable]"), std::string::npos) << shop_.read("j.xml");
}

TEST_F(FailedRun, LeavesTheFilesOfAWrongCommandLine) {
  for (const Words& words : {Words{"a.apt", "part.stl", "--wrong"}, Words{"none.apt", "part.stl", "--wrong"},
                             Words{"check", "none.apt"}, Words{"check", "a.apt", "--part", "part.stl", "-q", "-v"}}) {
    (void)run(words);
    EXPECT_EQ(shop_.read("j.xml"), kOld) << testing::PrintToString(words);
    EXPECT_EQ(shop_.read("s.sarif"), kOld);
  }
}

TEST_F(FailedRun, ReplacesNoInput) {
  const std::string part = shop_.read("part.stl");
  EXPECT_EQ(shop_.run({"none.apt", "part.stl", "--junit", "part.stl"}).exit_status, 3);
  EXPECT_EQ(shop_.read("part.stl"), part);
  shop_.write("a.nc", "%\nG21\nG0 X0 Y0\nG1 Z-1 F100\nG1 X5\nM30\n%\n");
  const std::string program = shop_.read("a.nc");
  EXPECT_NE(shop_.run({"correct", "a.nc", "--part", "part.stl", "--control", "fanuc", "-o", "o.nc", "--junit", "a.nc"})
                .exit_status,
            0);
  EXPECT_EQ(shop_.read("a.nc"), program);
  const Outcome printed = shop_.run({"none.apt", "part.stl", "--junit", "-"});
  EXPECT_NE(printed.out.find("exit status 3; none.apt: error: no such file"), std::string::npos) << printed.out;
  EXPECT_EQ(shop_.run({"none.apt", "part.stl", "--junit", "-", "--sarif", "-"}).out, "");
}

}  // namespace
}  // namespace gouge::testing_samples::failed_run_test
