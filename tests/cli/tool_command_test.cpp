#include "cli/commands/tool_command.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "lib/base/exit_code.h"
#include "lib/base/files.h"
#include "tests/support/temporary_folder.h"

namespace gouge::tool_command_test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kLibrary = R"({"units":"mm","tools":[
{"number":1,"name":"ball D10","cutter":{"shape":"ball","diameter":10,"length":30},
 "shank":[{"lower_diameter":10,"upper_diameter":10,"length":20}],
 "holder":[{"lower_diameter":32,"upper_diameter":40,"length":40}]},
{"number":12,"cutter":{"shape":"tapered","diameter":4,"corner_radius":1,"taper_angle":5,"length":20}}],
"holders":[{"name":"ER16","segments":[{"lower_diameter":28,"upper_diameter":28,"length":33}]}]})";

struct Reported {
  int status = 0;
  std::string out, err;
};

class ToolCommand : public testing::Test {
 protected:
  void SetUp() override { EXPECT_TRUE(write_file(path("shop.json"), kLibrary).has_value()); }

  [[nodiscard]] std::string path(const std::string& name) const { return folder_.at(name); }

  [[nodiscard]] Reported run(ToolAction action, const std::string& tool = "", const std::string& output = "") const {
    std::ostringstream out, err;
    const int status = run_tool({action, {}, path("shop.json"), tool, output}, out, err);
    return {status, out.str(), err.str()};
  }

 private:
  testing_support::TemporaryFolder folder_;
};

TEST_F(ToolCommand, ListIsATableOfTheLibrary) {
  const Reported reported = run(ToolAction::list);
  EXPECT_EQ(reported.status, kExitClean);
  EXPECT_EQ(reported.err, "");
  EXPECT_EQ(reported.out,
            "tool  name      cutter                       flutes  assembly  holder\n"
            "T1    ball D10  ball D 10                    30      90        D 40\n"
            "T12   -         tapered D 4 R 1 taper 5 deg  20      20        none\n"
            "2 tools, lengths in mm\n"
            "holder \"ER16\": D 28, length 33\n");
}

TEST_F(ToolCommand, ShowShowsBodiesAndContour) {
  const Reported reported = run(ToolAction::show, "1");
  EXPECT_EQ(reported.status, kExitClean);
  EXPECT_EQ(reported.out,
            "T1 \"ball D10\", lengths in mm\n"
            "  cutter    z 0 to 30, ball D 10\n"
            "  shank 1   z 30 to 50, diameter 10\n"
            "  holder 1  z 50 to 90, diameter 32 to 40\n"
            "  stick-out 50, tip to what holds the tool\n"
            "  assembly  length 90, largest diameter 40\n"
            "  contour (r, z), from the tip:\n"
            "    cutter  arc     (0, 0) to (5, 5), radius 5 about (0, 5)\n"
            "    cutter  line    (5, 5) to (5, 30)\n"
            "    shank   line    (5, 30) to (5, 50)\n"
            "    holder  line    (5, 50) to (16, 50)\n"
            "    holder  line    (16, 50) to (20, 90)\n"
            "    holder  line    (20, 90) to (0, 90)\n" +
                reported.out.substr(reported.out.find("  compiled")));
}

TEST_F(ToolCommand, AToolIsFoundByNumberByTAndNumberAndByName) {
  const std::string by_number = run(ToolAction::show, "1").out;
  EXPECT_EQ(run(ToolAction::show, "T1").out, by_number);
  EXPECT_EQ(run(ToolAction::show, "ball D10").out, by_number);
  EXPECT_NE(run(ToolAction::show).out, by_number) << "without --tool every tool is reported";
}

TEST_F(ToolCommand, AToolThatIsNotThereIsAWrongCommandLine) {
  const Reported reported = run(ToolAction::show, "3");
  EXPECT_EQ(reported.status, kExitUsage);
  EXPECT_EQ(reported.out, "");
  EXPECT_EQ(reported.err, "gougecheck: error: --tool '3': " + path("shop.json") +
                              " has no tool of that number or name; see gougecheck tool list [usage]\n");
}

TEST_F(ToolCommand, DrawWritesPngAndSvg) {
  EXPECT_EQ(run(ToolAction::draw, "1", path("t.png")).status, kExitClean);
  EXPECT_EQ(read_file(path("t.png"))->substr(1, 3), "PNG");
  EXPECT_EQ(run(ToolAction::draw, "1", path("t.SVG")).status, kExitClean);
  EXPECT_NE(read_file(path("t.SVG"))->find("<svg"), std::string::npos);
  EXPECT_EQ(run(ToolAction::draw, "", path("all.png")).status, kExitClean) << "the whole library on one sheet";
}

TEST_F(ToolCommand, DrawNeedsAPictureFile) {
  const Reported reported = run(ToolAction::draw, "1", path("t.pdf"));
  EXPECT_EQ(reported.status, kExitUsage);
  EXPECT_EQ(reported.err,
            "gougecheck: error: -o '" + path("t.pdf") + "': the picture must be a .png or an .svg file [usage]\n");
  EXPECT_FALSE(fs::exists(path("t.pdf")));
  EXPECT_EQ(run(ToolAction::draw, "1", path("none/t.png")).status, kExitInternal);
}

TEST_F(ToolCommand, ABadLibraryIsInvalidInput) {
  EXPECT_TRUE(write_file(path("shop.json"), "{").has_value());
  const Reported reported = run(ToolAction::list);
  EXPECT_EQ(reported.status, kExitInput);
  EXPECT_EQ(reported.out, "");
  EXPECT_NE(reported.err.find("shop.json:1: error: this is not JSON"), std::string::npos) << reported.err;
  fs::remove(path("shop.json"));
  EXPECT_EQ(run(ToolAction::list).status, kExitInput);
}

}  // namespace
}  // namespace gouge::tool_command_test
