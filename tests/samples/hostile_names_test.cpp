#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "lib/base/printable_text.h"
#include "tests/samples/program.h"
#include "tests/samples/sample_folder.h"

// Names of files, tools, holders and operations, and words of a toolpath, that try to drive the terminal or
// to forge a line of their own. Whatever command names them, each line it prints is its own and holds nothing
// a terminal obeys.

namespace gouge::testing_samples::hostile_names_test {
namespace {

namespace fs = std::filesystem;

// Clears the screen, sets the title, returns the cursor, begins lines, turns directions, hides, is no UTF-8.
const std::string kNasty =
    "\x1B[2J\x1B]0;t\x07\rFORGED: clean\nFORGED: clean\t\xC2\x9B"
    "31m\u202Egpj\u2066\u200B\u2028\x7F\x08\xFF\xC3";
// The part that a toolpath may hold: a control byte makes it no text, a line separator of Unicode an error.
const std::string kNastyText =
    "\xC2\x9B"
    "31m\u202Egpj\u2066\u200B FORGED: clean";
// The same for JSON, which must be UTF-8.
const char* const kNastyJson =
    "\\u001b[2J\\u001b]0;t\\u0007\\rFORGED: clean\\nFORGED: "
    "clean\\t\\u009b31m\\u202egpj\\u2066\\u200b\\u2028\\u007f\\u0000";

void expect_harmless(const std::string& text, const std::string& what) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    EXPECT_EQ(line, printable(line)) << what;
    EXPECT_NE(line.rfind("FORGED", 0), 0U) << what << ": " << line;
  }
}

class HostileNames : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fresh_folder();
    write_text(folder_ + "/" + path_, "PARTNO/" + kNasty + "\nUNITS/MM\nPPRINT/" + kNasty + "\n$$-> FEATNO / " +
                                          kNasty + "\nWORD" + kNasty + "/1\nTOOL PATH/" + kNasty + ",TOOL," + kNasty +
                                          "\nLOADTL/1\nRAPID\nGOTO/0,0,50\nFEDRAT/100\n" +
                                          "GOTO/5,5,-1\nGOTO/5,5,\x1B[2J\nCYCLE/" + kNasty + "\nGOTO/6,6,-2\nFINI\n");
    write_text(folder_ + "/" + plain_, "TOOL PATH/" + kNastyText + ",TOOL," + kNastyText +
                                           "\nTLDATA/MILL,10.,0.,40.,0.,0.\nPPRINT/" + kNastyText +
                                           "\nGOTO/0.,0.,50.,0.,0.,1.\nGOTO/5.,5.,-1.\nWORD" + kNastyText +
                                           "/1\nGOTO/9.,5.,-1.\nEND-OF-PATH\n");
    write_text(folder_ + "/" + part_, stl());
    write_text(folder_ + "/" + tools_, library("1"));
    write_text(folder_ + "/bad" + tools_, library("\"" + std::string(kNastyJson) + "\""));
  }

  // A square of two triangles at z = 0: the tool gouges it.
  [[nodiscard]] static std::string stl() {
    const std::string head = "facet normal 0 0 1\nouter loop\n", tail = "endloop\nendfacet\n";
    return "solid " + kNasty.substr(0, 8) + "\n" + head + "vertex -20 -20 0\nvertex 30 -20 0\nvertex 30 30 0\n" + tail +
           head + "vertex -20 -20 0\nvertex 30 30 0\nvertex -20 30 0\n" + tail + "endsolid\n";
  }

  [[nodiscard]] static std::string library(const std::string& number) {
    const std::string name = kNastyJson;
    const std::string segment = R"([{"lower_diameter":30,"upper_diameter":30,"length":20}])";
    return R"({"units":"mm","holders":[{"name":")" + name + R"(","segments":)" + segment + R"(}],"tools":[{"number":)" +
           number + R"(,"name":")" + name +
           R"(","cutter":{"shape":"ball","diameter":10,"length":30},"extensions":[{"name":")" + name +
           R"(","segments":)" + segment + R"(}],"holder":")" + name + R"(","strange )" + name + R"(":1}]})";
  }

  Outcome run(const std::vector<std::string>& arguments) {
    const Outcome ran = run_gougecheck(folder_, arguments);
    const std::string what = testing::PrintToString(arguments);
    EXPECT_GE(ran.exit_status, 0) << what;
    EXPECT_NE(ran.out + ran.err, "") << what << " prints something to look at";
    expect_harmless(ran.out, what);
    expect_harmless(ran.err, what);
    return ran;
  }

  std::string folder_;
  const std::string path_ = "p" + kNasty + ".apt", plain_ = "q" + kNasty + ".apt", part_ = "s" + kNasty + ".stl",
                    tools_ = "t" + kNasty + ".json";
};

TEST_F(HostileNames, OfCheckAndCorrect) {
  const std::vector<std::string> check = {"check", plain_, "--part", part_, "--tools", tools_, "-v"};
  const auto with = [](std::vector<std::string> words, const std::vector<std::string>& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
  };
  const Outcome found = run(check);
  EXPECT_EQ(found.exit_status, 1) << found.out << found.err;
  EXPECT_NE(found.out.find("q\\x1b[2J"), std::string::npos) << "the name is shown, as an escape";
  run(with(check, {"--near-miss", "100"}));
  run(with(check, {"--fixture", part_, "--report", "r" + kNasty}));
  run({"check", path_, "--part", part_, "--tools", tools_, "-v"});
  run({"correct", plain_, "--part", part_, "--tools", tools_, "-v", "-o", "o" + kNasty, "--report", "rc" + kNasty});
  run({"correct", plain_, "--part", part_, "--tools", tools_, "-v", "-o", "o2" + kNasty, "--max-shift", "0.1"});
}

TEST_F(HostileNames, OfToolCommands) {
  EXPECT_EQ(run({"tool", "list", "--tools", tools_}).exit_status, 0);
  EXPECT_EQ(run({"tool", "show", "--tools", tools_}).exit_status, 0);
  run({"tool", "list", "--tools", "bad" + tools_});
  run({"tool", "show", "--tools", tools_, "--tool", kNasty});
  run({"tool", "draw", "--tools", tools_, "-o", kNasty});
  run({"tool", "import", tools_, "-o", "i" + kNasty});
  write_text(folder_ + "/f" + kNasty, R"({"data":[{"type":"ball end mill","description":")" + std::string(kNastyJson) +
                                          R"(","unit":"millimeters","geometry":{"DC":6,"LCF":12,"OAL":50,"LB":20},)" +
                                          R"("post-process":{"number":3}}],"version":1})");
  EXPECT_EQ(run({"tool", "import", "f" + kNasty, "-o", "i2" + kNasty}).exit_status, 0);
}

TEST_F(HostileNames, OfPathAndMeshCommands) {
  run({"path", "info", path_});
  EXPECT_EQ(run({"path", "info", plain_}).exit_status, 0);
  run({"path", "convert", path_, "-o", "c" + kNasty, "--to", "apt"});
  run({"path", "convert", path_, "-o", kNasty + "/c"});
  run({"path", "plot", path_, "-o", kNasty});
  run({"mesh", part_});
  run({"mesh", part_, "--repair", "m" + kNasty, "--fill-holes", "--weld", "0.01"});
  write_text(folder_ + "/" + kNasty + ".stl", "solid a\n" + kNasty + "\n");
  run({"mesh", kNasty + ".stl"});
}

TEST_F(HostileNames, OfWrongCommandLines) {
  run({kNasty});
  run({"tool", kNasty});
  run({"check", "--" + kNasty});
  run({"check", "--" + kNasty + "=" + kNasty});
  run({"check", plain_, "--part", part_, kNasty});
  run({"check", "no" + kNasty, "--part", "no" + kNasty, "--tools", "no" + kNasty});
  for (const char* option :
       {"--tolerance",      "--resolution", "--clearance", "--place",   "--stl-units",  "--rapid",  "--threads",
        "--progress",       "--tool",       "--holder",    "--dialect", "--path-units", "--cutcom", "--near-miss",
        "--stock-to-leave", "--part",       "--fixture",   "--head",    "--json",       "--report"}) {
    const std::string value =
        std::string(option) == "--json" || std::string(option) == "--report" ? "/no/" + kNasty : kNasty;
    run({"check", plain_, "--part", part_, "--tools", tools_, option, value});
  }
  for (const char* option : {"--strategy", "--max-shift", "--max-side-shift", "--rapid-clearance"})
    run({"correct", plain_, "--part", part_, "--tools", tools_, "-o", "o", option, kNasty});
}

}  // namespace
}  // namespace gouge::testing_samples::hostile_names_test
