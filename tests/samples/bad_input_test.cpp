#include <gtest/gtest.h>

#include <filesystem>

#include "tests/samples/program.h"
#include "tests/samples/sample_folder.h"

// Bad input ends with status 3, one message that names the file, and no output file.

namespace gouge::testing_samples::bad_input_test {
namespace {

struct BadInput {
  std::string name;     ///< of the test
  std::string file;     ///< the file that is bad
  std::string content;  ///< written into it; "-" leaves the file missing
  std::string said;     ///< must stand in the message, besides the file
};

/// Keeps the bytes of the content out of test listings.
void PrintTo(const BadInput& bad, std::ostream* out) { *out << bad.name; }

const std::string kStart = "UNITS/MM\nMULTAX/ON\nLOADTL/1\n";

const std::vector<BadInput>& bad_inputs() {
  static const std::vector<BadInput> kAll = {
      {"ToolpathMissing", "bad.apt", "-", ""},
      {"ToolpathEmpty", "bad.apt", "", ""},
      {"ToolpathBinary", "bad.apt", std::string("GOTO/1,2,3\n\0\0\1\2", 15), ""},
      {"ToolpathWithoutMotion", "bad.apt", kStart, ""},
      {"NumberWithTwoPoints", "bad.apt", kStart + "GOTO/1.2.3,0,0,0,0,1\n", "bad.apt:4: "},
      {"NumberNan", "bad.apt", kStart + "GOTO/nan,0,0,0,0,1\n", "bad.apt:4: "},
      {"NumberTooLarge", "bad.apt", kStart + "GOTO/1e400,0,0,0,0,1\n", "bad.apt:4: "},
      {"FiveNumbers", "bad.apt", kStart + "GOTO/0,0,0\nGOTO/1,2,3,0,1\n", "bad.apt:5: "},
      {"ZeroAxis", "bad.apt", kStart + "GOTO/0,0,90,0,0,0\n", "bad.apt:4: "},
      {"AxisFarFromUnit", "bad.apt", kStart + "GOTO/0,0,90,0,0,1.01\n", "bad.apt:4: "},
      {"PartProgram", "bad.apt", "PARTNO/X\nP1=POINT/0,0,0\nGO/TO,P1\n", ""},
      {"StlMissing", "bad.stl", "-", ""},
      {"StlEmpty", "bad.stl", "", ""},
      {"StlTruncated", "bad.stl", std::string(80, ' ') + std::string("\x02\0\0\0", 4) + std::string(60, '\0'), ""},
      {"StlWithoutTriangles", "bad.stl", std::string(84, '\0'), ""},
      {"StlText", "bad.stl", "this is no mesh\n", ""},
      {"StlNotANumber", "bad.stl",
       "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex nan 0 0\nvertex 0 1 0\n"
       "endloop\nendfacet\nendsolid a\n",
       "bad.stl:5: "},
      {"ToolsMissing", "bad.json", "-", ""},
      {"ToolsNotJson", "bad.json", "{\"units\":", ""},
      {"ToolNegativeLength", "bad.json",
       "{\"units\":\"mm\",\"tools\":[{\"number\":1,\"name\":\"a\",\"cutter\":{\"shape\":\"flat\",\"diameter\":6,"
       "\"length\":-1}}]}",
       "length"},
      {"ToolCornerTooLarge", "bad.json",
       "{\"units\":\"mm\",\"tools\":[{\"number\":1,\"name\":\"a\",\"cutter\":{\"shape\":\"bull_nose\",\"diameter\":6,"
       "\"corner_radius\":4,\"length\":9}}]}",
       "corner_radius"},
  };
  return kAll;
}

class BadInputs : public ::testing::TestWithParam<BadInput> {};

INSTANTIATE_TEST_SUITE_P(Files, BadInputs, ::testing::ValuesIn(bad_inputs()),
                         [](const auto& test) { return test.param.name; });

TEST_P(BadInputs, AreStatus3NameTheFileAndLeaveNoOutput) {
  const BadInput& bad = GetParam();
  const SampleFolder sample = open_sample("needles");
  if (bad.content != "-") write_text(sample.path + "/" + bad.file, bad.content);
  const auto chosen = [&](const std::string& usual) {
    const std::filesystem::path usual_path(usual), bad_path(bad.file);
    return usual_path.extension() == bad_path.extension() ? bad.file : usual;
  };
  for (const std::string command : {"check", "correct"}) {
    std::vector<std::string> arguments = {command,    chosen("needles.apt"),
                                          "--part",   chosen("part.stl"),
                                          "--tools",  chosen("tools.json"),
                                          "--csv",    "out.csv",
                                          "--json",   "out.json",
                                          "--report", "report"};
    if (command == "correct") arguments.insert(arguments.end(), {"-o", "out.apt"});
    const Outcome ran = run_gougecheck(sample.path, arguments);
    EXPECT_EQ(ran.exit_status, 3) << ran.out << ran.err;
    EXPECT_EQ(ran.out, "");
    EXPECT_EQ(ran.err.rfind(bad.file + ":", 0), 0U) << ran.err;
    EXPECT_NE(ran.err.find(bad.said), std::string::npos) << ran.err;
    for (const char* output : {"out.csv", "out.json", "out.apt", "report"}) {
      EXPECT_FALSE(std::filesystem::exists(sample.path + "/" + output)) << output;
    }
  }
}

TEST(OtherBadInput, AnOutputThatCannotBeWrittenIsStatus5) {
  const SampleFolder sample = open_sample("needles");
  const Outcome ran =
      run_gougecheck(sample.path, sample.arguments("check", sample.toolpath(), {"--csv", "no/such/out.csv"}));
  EXPECT_EQ(ran.exit_status, 5);
  EXPECT_NE(ran.err.find("no/such/out.csv"), std::string::npos) << ran.err;
}

TEST(OtherBadInput, AnOutputThatFailsAfterTheWorkIsSaidBelowTheFindings) {
  const SampleFolder sample = open_sample("pocket");
  const std::string options = " pocket.apt --part part.stl --fixture clamp.stl --tools tools.json --csv /dev/full 2>&1";
  for (const char* command : {"check", "correct -o out.apt"}) {
    const Outcome ran = run_script(sample.path, std::string("$GOUGECHECK ") + command + options);
    EXPECT_EQ(ran.exit_status, 5);
    const std::string last = ran.out.substr(ran.out.rfind('\n', ran.out.size() - 2) + 1);
    EXPECT_EQ(last.rfind("/dev/full: error: ", 0), 0U) << last;
    EXPECT_NE(ran.out.find("guarantee: "), std::string::npos) << ran.out;
    EXPECT_EQ(ran.out.find("[file-unwritable]"), ran.out.rfind("[file-unwritable]")) << "once";
  }
}

TEST(OtherBadInput, OutputsThatCannotBeWrittenAreAllFoundBeforeTheWork) {
  const SampleFolder sample = open_sample("needles");
  const std::string said =
      ": error: cannot write the file: the folder nix does not exist; make it first; nothing was written "
      "[file-unwritable]\n";
  const Outcome check = run_gougecheck(
      sample.path,
      sample.arguments("check", "none.apt", {"--csv", "nix/a", "--json", "nix/b", "--certificate", "new"}));
  EXPECT_EQ(check.exit_status, 5);
  EXPECT_EQ(check.err, "nix/b" + said + "nix/a" + said) << "the toolpath was not even looked for";
  const Outcome correct = run_gougecheck(sample.path, sample.arguments("correct", "none.apt", {"-o", "nix/a"}));
  EXPECT_EQ(correct.exit_status, 5);
  EXPECT_EQ(correct.err, "nix/a" + said);
  const std::vector<std::vector<std::string>> others = {{"path", "convert", "none.apt", "-o", "nix/a"},
                                                        {"path", "info", "none.apt", "--json", "nix/a"},
                                                        {"mesh", "none.stl", "--repair", "nix/a"},
                                                        {"tool", "import", "none.json", "-o", "nix/a"}};
  for (const std::vector<std::string>& arguments : others) {
    const Outcome ran = run_gougecheck(sample.path, arguments);
    EXPECT_EQ(ran.exit_status, 5) << arguments[0];
    EXPECT_EQ(ran.err, "nix/a" + said) << arguments[0];
  }
  EXPECT_FALSE(std::filesystem::exists(sample.path + "/new"));
  EXPECT_FALSE(std::filesystem::exists(sample.path + "/nix"));
}

}  // namespace
}  // namespace gouge::testing_samples::bad_input_test
