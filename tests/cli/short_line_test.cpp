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

class ShortLine : public ::testing::Test {
 protected:
  ShortLine() {
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
    const Result<Words> made = expand_short_line(words, {"check", "path"});
    return made ? *made : Words{to_text(made.error())};
  }

  testing_support::TemporaryFolder temporary_;
  std::string folder_ = temporary_.path(), path, part, tools;
};

TEST_F(ShortLine, IsACheckWithItsReportBesideTheToolpath) {
  const Words whole = {"gougecheck",          "check", path, "--part", part, "--tools", tools, "--report",
                       folder_ + "/op_report"};
  EXPECT_EQ(expanded({path, part, tools}), whole);
  EXPECT_EQ(expanded({tools, part, path}), whole) << "contents count, not their order";
  EXPECT_EQ(expanded({path, part}),
            (Words{"gougecheck", "check", path, "--part", part, "--report", folder_ + "/op_report"}));
}

TEST_F(ShortLine, TakesTheOptionsOfACheck) {
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

TEST_F(ShortLine, LeavesCommandsAndWordsThatAreNoFiles) {
  for (const Words& words :
       {Words{"check", path}, Words{"path", "info", path}, Words{"chekc", path}, Words{"--help"}, Words{}}) {
    Words whole = words;
    whole.insert(whole.begin(), "gougecheck");
    EXPECT_EQ(expanded(words), whole);
  }
}

TEST_F(ShortLine, NamesFilesThatDoNotFit) {
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
  EXPECT_NE(error({step, tools}).find("none of the files is a toolpath: " + step + " is a STEP file"),
            std::string::npos);
  EXPECT_NE(error({path, part, notes}).find("notes.txt is neither a toolpath nor an STL file"), std::string::npos);
  EXPECT_EQ(expanded({notes, part})[1], "check") << "its reader says what is wrong";
  EXPECT_NE(error({path, part, add("empty.json", "")}).find("empty.json' is empty; expected"), std::string::npos);
}

TEST_F(ShortLine, GivesForeignFilesToTheReaderOfWhatIsMissing) {
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
  EXPECT_NE(expanded({path, part, step}).front().find("part.step is neither a toolpath nor"), std::string::npos);
}

}  // namespace
}  // namespace gouge::short_line_test
