#include "cli/short_line.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "lib/base/files.h"
#include "tests/support/shapes.h"
#include "tests/support/stl_text.h"
#include "tests/support/temporary_folder.h"

namespace gouge::short_line_test {
namespace {

namespace fs = std::filesystem;

using Words = std::vector<std::string>;

class ShortCommand : public ::testing::Test {
 protected:
  ShortCommand() {
    path = add("op.cls", "UNITS/MM\nGOTO/0,0,5\n");
    part = add("block.bin", shapes::ascii_stl(shapes::cube()));
    tools =
        add("lib.txt", R"({"units":"mm","tools":[{"number":1,"cutter":{"shape":"ball","diameter":8,"length":20}}]})");
  }

  [[nodiscard]] std::string add(const std::string& name, const std::string& bytes) const {
    EXPECT_TRUE(write_file(folder_ + "/" + name, bytes));
    return folder_ + "/" + name;
  }
  [[nodiscard]] static Words expanded(Words words) {
    words.insert(words.begin(), "gougecheck");
    const ShortLine made = expand_short_line(words, {"check", "path"});
    return made.error ? Words{to_text(*made.error)} : made.words;
  }

  testing_support::TemporaryFolder temporary_;
  std::string folder_ = temporary_.path(), path, part, tools;
};

TEST_F(ShortCommand, IsACheckWithItsReportBesideTheToolpath) {
  const Words whole = {"gougecheck",          "check", path, "--part", part, "--tools", tools, "--report",
                       folder_ + "/op_report"};
  EXPECT_EQ(expanded({path, part, tools}), whole);
  EXPECT_EQ(expanded({tools, part, path}), whole) << "contents count, not their order";
  EXPECT_EQ(expanded({path, part}),
            (Words{"gougecheck", "check", path, "--part", part, "--report", folder_ + "/op_report"}));
}

TEST_F(ShortCommand, TakesTheOptionsOfACheck) {
  EXPECT_EQ(expanded({path, part, "--tolerance", "0.02", "-q"}),
            (Words{"gougecheck", "check", path, "--part", part, "--report", folder_ + "/op_report", "--tolerance",
                   "0.02", "-q"}));
  for (const Words& report : {Words{"--report", "r"}, Words{"--report=r"}}) {
    Words line = {path}, made = {"gougecheck", "check", path};
    line.insert(line.end(), report.begin(), report.end());
    made.insert(made.end(), report.begin(), report.end());
    EXPECT_EQ(expanded(line), made);
  }
  EXPECT_EQ(expanded({"-", part}), (Words{"gougecheck", "check", "-", "--part", part}));
}

TEST_F(ShortCommand, LeavesCommandsAndWordsThatAreNoFiles) {
  for (const Words& words :
       {Words{"check", path}, Words{"path", "info", path}, Words{"chekc", path}, Words{"--help"}, Words{}}) {
    Words whole = words;
    whole.insert(whole.begin(), "gougecheck");
    EXPECT_EQ(expanded(words), whole);
  }
}

TEST_F(ShortCommand, NamesFilesThatDoNotFit) {
  const auto error = [&](const Words& words) { return expanded(words).front(); };
  EXPECT_EQ(error({"none.cls", part}), "none.cls: error: no such file [file-not-found]");
  EXPECT_NE(error({part, tools}).find("none of the files is a toolpath"), std::string::npos);
  EXPECT_NE(error({path, add("b.cls", "GOTO/1,2,3\n"), part}).find("are toolpaths; expected one, or gougecheck batch"),
            std::string::npos);
  EXPECT_NE(error({path, part, add("vise.stl", "damaged")}).find("others with --fixture or --stock"),
            std::string::npos);
  EXPECT_NE(error({path, part, tools, add("b.json", R"({"units":"mm","tools":[]})")}).find("are tool libraries"),
            std::string::npos);
  EXPECT_NE(error({folder_, part}).find("is a folder"), std::string::npos);
  const std::string step = add("part.step", "ISO-10303-21;\nHEADER;\n"), notes = add("notes.txt", "cut it slowly\n");
  EXPECT_NE(error({step}).find("is a STEP file, which holds geometry and no toolpath"), std::string::npos);
  EXPECT_EQ(error({step, tools}), error({step}));
  EXPECT_EQ(expanded({notes, part})[1], "check") << "its reader says what is wrong";
  EXPECT_NE(error({path, part, tools, notes}).find("notes.txt: error: is neither a toolpath nor an STL file"),
            std::string::npos);
}

// What is wrong with a file is a fault of the input. Only a wrong command line has the code usage.
TEST_F(ShortCommand, BlamesTheCommandLineForNoFileThatIsNotRecognised) {
  const std::string png = add("a.png", "\x89PNG\r\n"), empty = add("empty.apt", ""), cad = add("a.CATPart", "V5_CFV2"),
                    utf16 = add("u.apt", std::string("\xff\xfeG\0O\0", 6)), notes = add("notes.txt", "cut it slowly\n"),
                    pointer = add("l.apt", "version https://git-lfs.github.com/spec/v1\n");
  for (const std::string& odd : {png, empty, cad, utf16, notes, pointer}) {
    for (const Words& words : {Words{odd, part}, Words{odd, part, tools}, Words{odd, path}, Words{odd, path, part},
                               Words{odd, path, part, tools}, Words{path, part, odd}, Words{odd, notes, path, part}}) {
      const Words made = expanded(words);
      EXPECT_EQ(made.front().find("[usage]"), std::string::npos) << made.front();
      EXPECT_TRUE(made.size() == 1 || made[1] == "check");
    }
  }
  EXPECT_EQ(expanded({utf16, part, tools})[2], utf16);
  EXPECT_EQ(expanded({cad, empty})[2], empty) << "geometry is the last choice for a toolpath";
  EXPECT_EQ(expanded({path, add("empty.stl", "")})[4], folder_ + "/empty.stl");
  EXPECT_EQ(expanded({path, part, add("empty.json", "")})[5], "--tools");
  EXPECT_EQ(expanded({path, png})[3], "--part") << "a part is missing first";
  EXPECT_EQ(expanded({path, png, "--part", part})[3], "--tools");
  EXPECT_NE(expanded({empty}).front().find("the file is empty; expected APT CL data"), std::string::npos);
}

TEST_F(ShortCommand, NamesAllFilesAndOutputsBesideAnError) {
  const ShortLine made = expand_short_line({"gougecheck", "none.cls", part, tools, "--junit", "j.xml"}, {"check"});
  ASSERT_TRUE(made.error);
  EXPECT_EQ(made.error->code, "file-not-found");
  EXPECT_EQ(made.words, (Words{"gougecheck", "check", "none.cls", "--part", part, "--tools", tools, "--report",
                               "none_report", "--junit", "j.xml"}));
}

TEST_F(ShortCommand, GivesForeignFilesToTheReaderOfWhatIsMissing) {
  const std::string step = add("part.step", "ISO-10303-21;\nHEADER;\n"),
                    xml = add("tools.xml", "<?xml version='1.0'?>");
  const std::string zip = add("part.3mf", std::string("PK\3\4") + std::string(60, ' '));
  const auto made = [&](const Words& words) {
    Words all = expanded(words);
    all.erase(all.begin(), all.begin() + 3);
    all.resize(all.size() - 2);
    return all;
  };
  EXPECT_EQ(made({path, step}), (Words{"--part", step}));
  EXPECT_EQ(made({step, path, tools}), (Words{"--part", step, "--tools", tools}));
  EXPECT_EQ(made({path, part, xml}), (Words{"--part", part, "--tools", xml}));
  EXPECT_EQ(made({path, xml, step}), (Words{"--part", step, "--tools", xml}));
  EXPECT_EQ(made({path, zip}), (Words{"--part", zip}));
  EXPECT_NE(expanded({path, part, step}).front().find("part.step: error: is neither a toolpath nor"),
            std::string::npos);
}

}  // namespace
}  // namespace gouge::short_line_test
