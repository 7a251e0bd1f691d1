#include "cli/tools/compare_tools.h"

#include <gtest/gtest.h>

#include "cli/tools/resolve_tools.h"
#include "postproc/formats/read_toolpath.h"
#include "toolmodels/tool_library.h"

namespace gouge::compare_tools_test {
namespace {

/// A flat cutter of 10 mm with flutes of 30 mm, a shank to `stickout_mm`, and a holder.
ToolAssembly end_mill(double stickout_mm, std::optional<int> number = 1, const std::string& name = "") {
  ToolAssembly tool;
  tool.number = number;
  tool.name = name;
  tool.cutter = FlatCutter{10, 30};
  tool.shank = {{10, 10, stickout_mm - 30}};
  tool.holder = {{50, 50, 50}};
  return tool;
}

ToolLibrary library_of(const std::vector<ToolAssembly>& tools) {
  ToolLibrary library;
  library.file = "tools.json";
  library.tools = tools;
  return library;
}

ResolvedTools resolved(const std::string& file, const std::string& text, const ToolLibrary* library) {
  const ReadOutcome read = read_toolpath(file, text);
  EXPECT_TRUE(read.toolpath.has_value()) << text;
  if (!read.toolpath) return {};
  Result<ResolvedTools> tools = resolve_tools(*read.toolpath, library, {}, "");
  EXPECT_TRUE(tools.has_value());
  return tools ? *tools : ResolvedTools{};
}

/// The fact `tool` of the last tool of a file.
Assumption last_fact(const std::string& file, const std::string& text, const ToolLibrary* library = nullptr) {
  Assumption last;
  for (const Assumption& fact : resolved(file, text, library).assumptions) {
    if (fact.subject == Subject::tool) last = fact;
  }
  return last;
}

std::string with_two_tools(const std::string& first, const std::string& second) {
  return "UNITS/MM\n" + first + "\nGOTO/0,0,5\nGOTO/9,0,5\n" + second + "\nGOTO/0,0,5\nGOTO/9,0,5\nFINI\n";
}

std::string nx_block(const std::string& tool, const std::string& tldata, const std::string& load) {
  return "TOOL PATH/A,TOOL," + tool + "\nTLDATA/MILL," + tldata + "\nMSYS/0,0,0,1,0,0,0,1,0\n" + load +
         "\nGOTO/0,0,5\nGOTO/9,0,5\nEND-OF-PATH\n";
}

TEST(SharedNumbers, TwoDefinitionsOfOneNumberContradictEachOther) {
  const Assumption fact =
      last_fact("t.apt", with_two_tools("CUTTER/10,0,5,0,0,0,75\nLOADTL/1", "CUTTER/6,0,3,0,0,0,75\nLOADTL/1"));
  EXPECT_EQ(fact.basis, Basis::contradicted);
  EXPECT_EQ(fact.code, "tool-number-shared");
  EXPECT_EQ(fact.evidence,
            "T1 is D 10 R 0 length 75 mm in line 2, and D 6 R 0 length 75 mm in line 6, but a machine has one tool of "
            "that number");
  for (const char* other : {"CUTTER/10,5,0,5,0,0,75", "CUTTER/10,0,5,0,0,20,75", "CUTTER/10,0,5,2.886751,30,0,75",
                            "CUTTER/10,0,5,0,0,0,40", "CUTTER/10.01,0,5.005,0,0,0,75"}) {
    const std::string text = with_two_tools("CUTTER/10,0,5,0,0,0,75\nLOADTL/1", std::string(other) + "\nLOADTL/1");
    EXPECT_EQ(last_fact("t.apt", text).code, "tool-number-shared") << other;
  }
}

TEST(SharedNumbers, RoundingAndFurtherFactsContradictNothing) {
  for (const char* same : {"CUTTER/10.0004,0,5,0,0,0,75", "CUTTER/10,0,5,0,0,0,74.5", "CUTTER/10,0", "CUTTER/10"}) {
    const std::string text = with_two_tools("CUTTER/10,0,5,0,0,0,75\nLOADTL/1", std::string(same) + "\nLOADTL/1");
    EXPECT_NE(last_fact("t.apt", text).basis, Basis::contradicted) << same;
  }
  EXPECT_NE(last_fact("t.apt", with_two_tools("CUTTER/10,0\nLOADTL/1", "CUTTER/6,0\nLOADTL/2")).basis,
            Basis::contradicted);
}

TEST(SharedNumbers, NamesOfNxWithoutANumberOrWithZeroAreFine) {
  const std::string big = "10,0,75,0,0", small = "6,0,75,0,0";
  const auto basis = [&](const std::string& load) {
    return last_fact("t.cls", nx_block("F10", big, load) + nx_block("F6", small, load)).basis;
  };
  EXPECT_EQ(basis("LOAD/TOOL,1"), Basis::contradicted);
  EXPECT_EQ(basis("LOAD/TOOL,0"), Basis::stated);
  EXPECT_EQ(basis("RAPID"), Basis::stated);
  EXPECT_EQ(last_fact("t.cls", nx_block("F10", big, "LOAD/TOOL,1") + nx_block("F10_B", big, "LOAD/TOOL,1")).basis,
            Basis::stated)
      << "one tool under two names";
}

TEST(SharedNumbers, TwoToolsOfTheLibraryForOneNumberContradictEachOther) {
  const std::string path = nx_block("F10", "10,0,75,0,0", "LOAD/TOOL,1") + nx_block("F6", "6,0,75,0,0", "LOAD/TOOL,1");
  ToolAssembly small = end_mill(75, std::nullopt, "F6");
  small.cutter = FlatCutter{6, 30};
  small.shank = {{6, 6, 45}};
  const ToolLibrary by_name = library_of({end_mill(75, std::nullopt, "F10"), small});
  const Assumption fact = last_fact("t.cls", path, &by_name);
  EXPECT_EQ(fact.code, "tool-number-shared");
  EXPECT_EQ(
      fact.evidence,
      "T1 is \"F10\" of the library in line 2, and \"F6\" of the library in line 9, but a machine has one tool of "
      "that number");
  const ToolLibrary by_number = library_of({end_mill(75)});
  EXPECT_EQ(last_fact("t.cls", path, &by_number).basis, Basis::derived) << "the library states which it is";
}

std::string solidworks(const std::string& tool) {
  return "UNITS/MM\nTRNTYP/WORLD,0,0,0\n" + tool + "\nGOTO/0,0,5\nGOTO/9,0,5\nFINI\n";
}

TEST(CompareTools, AStatedStickOutIsComparedWithTheHoldersHeight) {
  const std::string path = solidworks("LOAD/TOOL,1\nCSI_SET_EXTENSION_LENGTH/40.");
  const ToolLibrary longer = library_of({end_mill(75)}), same = library_of({end_mill(40)}),
                    little = library_of({end_mill(40.5)}), shorter = library_of({end_mill(35)});
  const Assumption fact = last_fact("t.apt", path, &longer);
  EXPECT_EQ(fact.basis, Basis::contradicted);
  EXPECT_EQ(fact.evidence,
            "T1 has a stick-out of 40 mm by the toolpath and of 75 mm by the library, which is what is checked");
  EXPECT_EQ(last_fact("t.apt", path, &same).basis, Basis::derived);
  const auto warnings = [&](const ToolLibrary& library) {
    int count = 0;
    for (const Diagnostic& note : resolved("t.apt", path, &library).notes) count += note.code == "tool-differs" ? 1 : 0;
    return count;
  };
  EXPECT_EQ(warnings(same), 0);
  EXPECT_EQ(warnings(little), 1);
  EXPECT_EQ(warnings(shorter), 1);
  EXPECT_EQ(last_fact("t.apt", path, &little).basis, Basis::derived);
  EXPECT_EQ(last_fact("t.apt", path, &shorter).basis, Basis::derived);
  ToolLibrary bare = longer;
  bare.tools.front().holder.clear();
  EXPECT_EQ(last_fact("t.apt", path, &bare).basis, Basis::derived) << "no holder could be lower";
}

TEST(CompareTools, OfTwoStatedStickOutsTheSmallerCounts) {
  const std::string tool = "CUTTER/10.,0,5.,0,0,0,84.\nLOAD/TOOL,1\nCSI_SET_EXTENSION_LENGTH/";
  const ToolLibrary library = library_of({end_mill(60)});
  EXPECT_EQ(last_fact("t.apt", solidworks(tool + "60."), &library).basis, Basis::derived);
  EXPECT_EQ(last_fact("t.apt", solidworks(tool + "60.\nGOTO/0,0,9\n" + tool + "50."), &library).basis,
            Basis::contradicted);
  EXPECT_EQ(last_fact("t.apt",
                      solidworks(tool + "60.\nGOTO/0,0,9\nCUTTER/8.,0,4.,0,0,0,84.\nLOAD/TOOL,2\n"
                                        "CSI_SET_EXTENSION_LENGTH/30."),
                      &library)
                .basis,
            Basis::stated)
      << "the stick-out of another tool";
}

TEST(CompareTools, ALoadedLengthIsNotShorterThanTheStickOut) {
  ToolAssembly tool = end_mill(75);
  const ToolLibrary library = library_of({tool});
  tool.gauge_length_mm = 130;
  const ToolLibrary gauged = library_of({tool});
  for (const char* load : {"LOADTL/1,LENGTH,", "LOAD/TOOL,1,LENGTH,", "TOOLNO/1,LENGTH,"}) {
    const auto basis = [&](const std::string& length, const ToolLibrary& tools) {
      return last_fact("t.apt", "UNITS/MM\n" + (load + length) + "\nGOTO/0,0,5\nGOTO/9,0,5\nFINI\n", &tools).basis;
    };
    EXPECT_EQ(basis("40", library), Basis::contradicted) << load;
    EXPECT_EQ(basis("125", library), Basis::derived) << load;
    EXPECT_EQ(basis("0", library), Basis::derived) << load;
    EXPECT_EQ(basis("130", gauged), Basis::derived) << load;
    EXPECT_EQ(basis("120", gauged), Basis::contradicted) << load;
  }
  EXPECT_EQ(
      last_fact("t.apt", "UNITS/MM\nCUTTER/10,0,5,0,0,0,75\nLOADTL/1,LENGTH,75\nGOTO/0,0,5\nFINI\n", &gauged).basis,
      Basis::derived)
      << "a writer that states the length of the cutter";
}

/// The tools of a path whose only tool is in a tool table, with the library's end mill or another cutter.
ResolvedTools measured(double diameter_mm, ToolUse use, std::optional<double> corner_mm = {},
                       const Cutter& cutter = FlatCutter{10, 30}) {
  ToolLibrary library = library_of({end_mill(75)});
  library.tools.front().cutter = cutter;
  Toolpath path;
  PathTool& tool = path.tools.emplace_back();
  tool.number = 1;
  tool.stated_diameter_mm = diameter_mm;
  tool.in_table = {.file = "l.tbl", .has_diameter = diameter_mm > 0, .corner_mm = corner_mm};
  path.moves.emplace_back().tool = 0;
  return *resolve_tools(path, &library, {}, "", use);
}

TEST(CompareTools, AMeasuredDiameterThatDiffersLittleIsADefault) {
  const auto fact = [](double diameter_mm, ToolUse use = ToolUse::finds_gouges) {
    return measured(diameter_mm, use).assumptions.front();
  };
  EXPECT_EQ(fact(10.003).basis, Basis::by_default);
  EXPECT_EQ(fact(10.003).evidence,
            "T1 is D 10.003 mm by the tool table l.tbl but D 10 mm by the library, which is what is checked; the radii "
            "differ by up to 0.0015 mm");
  EXPECT_EQ(fact(10.0005).basis, Basis::derived);
  EXPECT_EQ(fact(10.02).basis, Basis::by_default);
  EXPECT_EQ(fact(10.022).basis, Basis::contradicted);
  EXPECT_EQ(fact(10.022).evidence,
            "T1 is D 10.022 mm by the tool table l.tbl but D 10 mm by the library, which is what is checked");
  EXPECT_EQ(fact(9.98).basis, Basis::derived) << "it hides no gouge";
  EXPECT_EQ(measured(9.98, ToolUse::finds_gouges).notes.front().code, "tool-differs");
  EXPECT_EQ(fact(9.98, ToolUse::removes_stock).basis, Basis::by_default);
  EXPECT_EQ(fact(9.97, ToolUse::removes_stock).basis, Basis::contradicted);
}

TEST(CompareTools, ACornerRadiusOfATableIsComparedWhereItsCutterMayBeWider) {
  const auto basis = [](const Cutter& cutter, double diameter_mm, std::optional<double> corner_mm,
                        ToolUse use = ToolUse::finds_gouges) {
    return measured(diameter_mm, use, corner_mm, cutter).assumptions.front().basis;
  };
  const BallCutter ball{10, 30};
  const BullNoseCutter bull{10, 2, 30};
  EXPECT_EQ(basis(ball, 10, 5), Basis::derived);
  EXPECT_EQ(basis(ball, 10, {}), Basis::derived) << "the table states no corner";
  EXPECT_EQ(basis(ball, 10, 4), Basis::contradicted);
  EXPECT_EQ(basis(ball, 10, 4.995), Basis::by_default);
  EXPECT_EQ(basis(ball, 9.99, 4.995), Basis::derived) << "a ball within the ball";
  EXPECT_EQ(basis(ball, 10.01, 5.005), Basis::by_default);
  EXPECT_EQ(basis(bull, 10, 1), Basis::contradicted);
  EXPECT_EQ(basis(bull, 0, 1), Basis::contradicted) << "a table without R";
  EXPECT_EQ(basis(bull, 10, 3), Basis::derived) << "it hides no gouge";
  EXPECT_EQ(basis(bull, 10, 3, ToolUse::removes_stock), Basis::contradicted);
  EXPECT_EQ(basis(FlatCutter{10, 30}, 10, 3, ToolUse::removes_stock), Basis::contradicted);
  EXPECT_EQ(basis(FlatCutter{10, 30}, 10, 0, ToolUse::removes_stock), Basis::derived);
  EXPECT_EQ(basis(DrillCutter{10, 118, 30}, 10, 3, ToolUse::removes_stock), Basis::derived) << "a tip without a corner";
  EXPECT_EQ(measured(10, ToolUse::finds_gouges, 1, bull).assumptions.front().evidence,
            "T1 is D 10 R 1 mm by the tool table l.tbl but D 10 R 2 mm by the library, which is what is checked");
}

TEST(CompareTools, ACornerRadiusThatATableLeavesAtZeroIsADefault) {
  const auto fact = [](const Cutter& cutter, double diameter_mm) {
    return measured(diameter_mm, ToolUse::finds_gouges, 0, cutter).assumptions.front();
  };
  EXPECT_EQ(fact(BallCutter{10, 30}, 10).basis, Basis::by_default);
  EXPECT_EQ(fact(BallCutter{10, 30}, 10).evidence,
            "T1 has the corner radius R2 0 in the tool table l.tbl, but 5 mm by the library, which is what is checked");
  EXPECT_EQ(fact(BullNoseCutter{10, 2, 30}, 10).basis, Basis::by_default);
  EXPECT_EQ(fact(BullNoseCutter{10, 2, 30}, 11).basis, Basis::contradicted);
}

TEST(CompareTools, AHolderAboveTheStatedToolIsADefault) {
  const auto basis = [&](const std::string& tldata, double stickout_mm) {
    const ToolLibrary library = library_of({end_mill(stickout_mm)});
    return last_fact("t.cls", nx_block("F10", tldata, "LOAD/TOOL,1"), &library).basis;
  };
  EXPECT_EQ(basis("10,0,40,0,0", 75), Basis::by_default);
  EXPECT_EQ(basis("10,0,30,0,0", 75), Basis::by_default) << "NX states the whole length";
  EXPECT_EQ(basis("10,0,75,0,0", 75), Basis::derived);
  EXPECT_EQ(basis("10,0,74.5,0,0", 75), Basis::derived);
  const ToolLibrary library = library_of({end_mill(75)});
  const auto of_apt = [&](const std::string& height) {
    return last_fact("t.apt", "UNITS/MM\nCUTTER/10,0,5,0,0,0," + height + "\nLOADTL/1\nGOTO/0,0,5\nFINI\n", &library)
        .basis;
  };
  EXPECT_EQ(of_apt("40"), Basis::by_default);
  EXPECT_EQ(of_apt("30"), Basis::derived) << "the length of the flutes, as some CAM systems state it";
}

TEST(LengthRegisters, ARegisterOfAnotherNumberIsListedAndNotOpen) {
  const auto fact = [](const std::string& load) {
    return last_fact("t.apt", "UNITS/MM\nCUTTER/10,0,5,0,0,0,75\n" + load + "\nGOTO/0,0,5\nFINI\n");
  };
  for (const char* load : {"LOADTL/1,ADJUST,5", "LOADTL/1,OSETNO,5", "TOOLNO/1,ADJUST,5", "LOAD/TOOL,1,ADJUST,5",
                           "LOADTL/1\nCUTCOM/ON,LENGTH,5"}) {
    const Assumption of_tool = fact(load);
    EXPECT_EQ(of_tool.basis, Basis::by_default) << load;
    EXPECT_EQ(of_tool.evidence, "T1 takes its length from register 5, which may hold that of another tool") << load;
  }
  for (const char* load : {"LOADTL/1,ADJUST,1", "LOADTL/1,ADJUST,0", "LOADTL/1", "LOADTL/1\nCUTCOM/ON,LENGTH,1",
                           "LOADTL/2,ADJUST,5\nLOADTL/1", "LOADTL/1\nCUTCOM/OFF,LENGTH,5"})
    EXPECT_EQ(fact(load).basis, Basis::stated) << load;
  const std::string both = last_fact("t.apt", "UNITS/MM\nCUTTER/10\nLOADTL/1,ADJUST,5\nGOTO/0,0,5\nFINI\n").evidence;
  EXPECT_NE(both.find("no length"), std::string::npos) << both;
  EXPECT_NE(both.find("register 5"), std::string::npos) << both;
}

}  // namespace
}  // namespace gouge::compare_tools_test
