#include <gtest/gtest.h>

#include "tests/toolmodels/import/import_helpers.h"

// A number or a name that several tools of one file have, of which the first cannot be imported. The next one must not take
// its place unnoticed: a check with it could be clean although the tool in the machine gouges.

namespace gouge::shared_tools_test {
namespace {

ToolLibrary imported(const Result<ImportedTools>& made) {
  EXPECT_TRUE(made.has_value());
  return made ? made->library : ToolLibrary{};
}

ToolLibrary fusion() {
  const auto tool = [](const char* type, const char* name, const char* lengths) {
    return R"({"type": ")" + std::string(type) + R"(", "unit": "millimeters", "description": ")" + name +
           R"(", "post-process": {"number": 1}, "geometry": {)" + lengths + "}}";
  };
  return imported(import_fusion(
      "f.json",
      R"({"data": [)" + tool("form mill", "A", "") + "," +
          tool("flat end mill", "A", R"("DC": 6, "LCF": 20, "OAL": 60, "LB": 30, "SFDM": 6)") + R"(], "version": 20})",
      {}));
}

ToolLibrary freecad() {
  ImportOptions options;
  options.read_beside = [](const std::string& name) -> Result<std::string> {
    if (name == "none.fctb") return make_error("file-not-found", "there is no such file", name);
    return std::string(
        R"({"name": "A", "shape-type": "Endmill", "parameter": {"Diameter": "6 mm", "CuttingEdgeHeight": "18 mm",
            "Length": "50 mm", "ShankDiameter": "6 mm"}})");
  };
  return imported(import_freecad(
      "f.fctl", R"({"tools": [{"nr": 1, "path": "none.fctb"}, {"nr": 1, "path": "a.fctb"}], "version": 1})", options));
}

ToolLibrary nx() {
  ImportOptions options;
  options.unit = LengthUnit::mm;
  return imported(import_nx("t.dat",
                            "#CLASS END_MILL_NON_INDEXABLE\nFORMAT LIBRF TLNUM DIA FLEN HEI TAPA COR1\n"
                            "DATA | A | 1 | 0 | 20 | 50 | 0 | 0\nDATA | A | 1 | 6 | 20 | 50 | 0 | 0\n",
                            options));
}

ToolLibrary linuxcnc() { return imported(import_linuxcnc("t.tbl", "T1 P1 Z50 ; A\nT1 P2 D6 Z50 ; A\n", {})); }

TEST(SharedTools, ANumberOfSeveralToolsIsSharedAlsoIfOneIsLeftOut) {
  for (const ToolLibrary& library : {fusion(), freecad(), nx(), linuxcnc()}) {
    ASSERT_EQ(library.tools.size(), 1u) << library.file;
    EXPECT_EQ(library.tools[0].number, 1) << library.file;
    EXPECT_TRUE(library.is_shared_number(1)) << library.file;
    EXPECT_FALSE(library.is_shared_number(2)) << library.file;
  }
  for (const ToolLibrary& library : {fusion(), nx(), linuxcnc()}) EXPECT_TRUE(library.is_shared_name("A"));
}

TEST(SharedTools, AWrittenLibraryKeepsTheDoubt) {
  const Result<ToolLibrary> back = read_tool_library("back.json", write_tool_library(fusion()));
  ASSERT_TRUE(back.has_value()) << back.error().message;
  EXPECT_EQ(back->tools.at(0).uncertainty, "the file that it was imported from has several tools of number 1");
}

TEST(SharedTools, ALibraryOfOursNamesSharedNames) {
  const std::string tools =
      R"({"units": "mm", "tools": [{"number": 1, "name": "A", "cutter": {"shape": "flat", "diameter": 6, "length": 30}},
          {"number": 2, "name": "A", "cutter": {"shape": "flat", "diameter": 10, "length": 30}}]})";
  const Result<ToolLibrary> library = read_tool_library("own.json", tools);
  ASSERT_TRUE(library.has_value()) << library.error().message;
  EXPECT_TRUE(library->is_shared_name("A"));
  EXPECT_FALSE(library->is_shared_name("B"));
}

}  // namespace
}  // namespace gouge::shared_tools_test
