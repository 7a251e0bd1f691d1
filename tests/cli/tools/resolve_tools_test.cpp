#include "cli/tools/resolve_tools.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "postproc/formats/read_toolpath.h"
#include "toolmodels/tool_library.h"

namespace gouge::resolve_tools_test {
namespace {

ToolLibrary library_with_holder() {
  ToolLibrary library;
  ToolAssembly tool;
  tool.number = 2;
  tool.cutter = FlatCutter{12.7, 38.1};
  tool.holder = {{31.75, 1.75 * 25.4, 38.1}};
  library.tools.push_back(tool);
  return library;
}

Toolpath path_in(LengthUnit unit) {
  Toolpath path;
  path.unit = unit;
  path.tools = {PathTool{2, "", {}, 0, 4}};
  return path;
}

TEST(ResolveTools, ReportsTheHolderRoundedAndInThePathsUnit) {
  const ToolLibrary library = library_with_holder();
  const auto described = [&](LengthUnit unit) {
    const Result<ResolvedTools> resolved = resolve_tools(path_in(unit), &library, {}, "");
    EXPECT_TRUE(resolved.has_value());
    return resolved->facts.at(0).description;
  };
  EXPECT_EQ(described(LengthUnit::inch), "flat D 0.5, stick-out 1.5 in, holder to D 1.75 in");
  EXPECT_EQ(described(LengthUnit::mm), "flat D 12.7, stick-out 38.1 mm, holder to D 44.45 mm");
}

TEST(ResolveTools, ReportsADifferenceRoundedAndInThePathsUnit) {
  ToolLibrary library = library_with_holder();
  library.tools.front().cutter = FlatCutter{0.75 * 25.4, 38.1};
  const auto reported = [&](LengthUnit unit) {
    Toolpath path = path_in(unit);
    path.tools.front().cutter.emplace();
    path.tools.front().cutter->d_mm = 0.75;
    path.tools.front().cutter->given = 1;
    const Result<ResolvedTools> resolved = resolve_tools(path, &library, {}, "");
    EXPECT_TRUE(resolved.has_value());
    return resolved->notes.at(0).message;
  };
  EXPECT_EQ(
      reported(LengthUnit::mm),
      "T2 is D 0.75 R 0 mm by the toolpath but D 19.05 R 0 mm by the library, which is what is checked; correct the "
      "library or --tool if another tool is meant");
  EXPECT_EQ(
      reported(LengthUnit::inch),
      "T2 is D 0.029528 R 0 in by the toolpath but D 0.75 R 0 in by the library, which is what is checked; correct the "
      "library or --tool if another tool is meant");
}

/// The differences reported of the tools of `text`, for a library whose T1 is a flat cutter of 10 mm.
std::vector<std::string> differences(const std::string& text) {
  ToolLibrary library;
  ToolAssembly tool;
  tool.number = 1;
  tool.cutter = FlatCutter{10, 30};
  library.tools.push_back(tool);
  const ReadOutcome read = read_toolpath("test.ncl", text);
  EXPECT_TRUE(read.toolpath.has_value());
  std::vector<std::string> reported;
  if (!read.toolpath) return reported;
  const Result<ResolvedTools> resolved = resolve_tools(*read.toolpath, &library, {}, "");
  EXPECT_TRUE(resolved.has_value());
  if (!resolved) return reported;
  Assumptions facts = resolved->assumptions;
  settle(facts, {}, false);
  for (const Diagnostic& warning : open_warnings(facts)) {
    if (warning.code == "tool-differs") reported.push_back(to_text(warning));
  }
  for (const Diagnostic& note : resolved->notes) {
    if (note.code == "tool-differs") reported.push_back(to_text(note));
  }
  return reported;
}

TEST(ResolveTools, TheDiameterThatCreoStatesIsComparedWithTheLibrary) {
  const std::string head = "$$* Pro/CLfile\nUNITS / MM\n", motion = "GOTO / 56, 0, -5\nGOTO / 56, 10, -5\n";
  const std::string first = head + "LOADTL / 1\n$$-> CUTTER / 10.000000\n" + motion;
  EXPECT_EQ(differences(first + "FINI\n").size(), 0U);
  EXPECT_EQ(
      differences(head + "LOADTL / 1\n$$-> CUTTER / 20.0\n" + motion + "FINI\n"),
      (std::vector<std::string>{"test.ncl:4: warning: T1 is D 20 mm by the toolpath but D 10 mm by the library, "
                                "which is what is checked; correct the library or --tool, or state that it is right "
                                "with --assume tool=T1 [tool-differs]"}));
  EXPECT_EQ(differences("$$* Pro/CLfile\n$$-> CUTTER / 20.0\nUNITS / MM\nLOADTL / 1\n" + motion + "FINI\n").size(), 1U);
  EXPECT_EQ(
      differences(first + "$$-> FEATNO / 2\n$$-> CUTTER / 20.0\n" + motion + "FINI\n"),
      (std::vector<std::string>{"test.ncl:8: warning: T1 is D 20 mm by the toolpath but D 10 mm by the library, "
                                "which is what is checked; correct the library or --tool, or state that it is right "
                                "with --assume tool=T1 [tool-differs]"}));
  EXPECT_EQ(differences(first + "$$-> FEATNO / 2\nLOADTL / 2\n$$-> CUTTER / 20.0\n" + motion +
                        "$$-> FEATNO / 3\nLOADTL / 1\n" + motion + "FINI\n")
                .size(),
            0U);
}

TEST(ResolveTools, AToolOfTheSameSizeThatReachesFartherOutIsReported) {
  const auto reported = [](const std::string& cutter, const std::string& head = "") {
    return differences(head + "UNITS/MM\nCUTTER/" + cutter + "\nLOADTL/1\nGOTO/0,0,5\nFINI\n");
  };
  for (const char* same : {"10", "10,0", "10,0,5,0,0,0,28", "10,0,0,0,0,0,30"})
    EXPECT_EQ(reported(same).size(), 0U) << same;
  EXPECT_EQ(reported("10,0,5,0,30,0,28").size(), 0U) << "a cone within the flat cutter";
  EXPECT_EQ(reported("10,0,5,0,0,20,28"),
            (std::vector<std::string>{
                "test.ncl:2: warning: T1 reaches up to 10.1912 mm farther from its axis by the "
                "toolpath than by the library, which is what is checked; correct the library or --tool, "
                "or state that it is right with --assume tool=T1 [tool-differs]"}));
}

TEST(ResolveTools, ALargerToolOfTheLibraryIsReportedAndContradictsNothing) {
  const std::string path = "UNITS/MM\nCUTTER/8\nLOADTL/1\nGOTO/0,0,5\nFINI\n";
  EXPECT_EQ(differences(path), (std::vector<std::string>{
                                   "test.ncl:2: warning: T1 is D 8 R 0 mm by the toolpath but D 10 R 0 mm by the "
                                   "library, which is what is checked; correct the library or --tool if another tool "
                                   "is meant [tool-differs]"}));
}

TEST(ResolveTools, ABallOfTheSameDiameterIsSmallerThanAFlatCutter) {
  ToolLibrary library;
  ToolAssembly tool;
  tool.number = 1;
  tool.cutter = BallCutter{10, 30};
  library.tools.push_back(tool);
  const ReadOutcome read = read_toolpath("t.apt", "UNITS/MM\nCUTTER/10,0\nLOADTL/1\nGOTO/0,0,5\nFINI\n");
  ASSERT_TRUE(read.toolpath.has_value());
  const Result<ResolvedTools> resolved = resolve_tools(*read.toolpath, &library, {}, "");
  ASSERT_TRUE(resolved.has_value());
  EXPECT_EQ(resolved->assumptions.front().basis, Basis::contradicted);
  library.tools.front().cutter = FlatCutter{10, 30};
  EXPECT_EQ(resolve_tools(*read.toolpath, &library, {}, "")->assumptions.front().basis, Basis::derived);
  EXPECT_EQ(resolve_tools(*read.toolpath, &library, {"1=1"}, "")->assumptions.front().basis, Basis::stated);
}

TEST(ResolveTools, AToolNameForNumbersThatThePathDoesNotLoadIsContradicted) {
  const ToolLibrary library = library_with_holder();
  const ReadOutcome read = read_toolpath("t.apt", "UNITS/MM\nCUTTER/10\nLOADTL/5\nGOTO/0,0,5\nFINI\n");
  ASSERT_TRUE(read.toolpath.has_value());
  const auto contradicted = [&](const std::vector<std::string>& names) {
    const Result<ResolvedTools> resolved = resolve_tools(*read.toolpath, &library, names, "");
    return resolved && std::ranges::any_of(resolved->assumptions, [](const Assumption& fact) {
             return fact.code == "tool-not-loaded" && fact.basis == Basis::contradicted;
           });
  };
  EXPECT_TRUE(contradicted({"15=2"}));
  EXPECT_FALSE(contradicted({"5=2"}));
  EXPECT_FALSE(contradicted({"5=2", "15=2"})) << "one list of names may serve many toolpaths";
  EXPECT_FALSE(contradicted({}));
}

TEST(ResolveTools, AToolThatRemovesMoreStockThanThatOfThePathIsContradicted) {
  ToolLibrary library;
  ToolAssembly tool;
  tool.number = 1;
  library.tools.push_back(tool);
  const ReadOutcome read = read_toolpath("t.apt", "UNITS/MM\nCUTTER/10,0,5,0,0,0,30\nLOADTL/1\nGOTO/0,0,5\nFINI\n");
  ASSERT_TRUE(read.toolpath.has_value());
  const auto basis = [&](const Cutter& cutter, ToolUse use) {
    library.tools.front().cutter = cutter;
    return resolve_tools(*read.toolpath, &library, {}, "", use)->assumptions.front().basis;
  };
  EXPECT_EQ(basis(FlatCutter{12, 30}, ToolUse::finds_gouges), Basis::derived);
  EXPECT_EQ(basis(FlatCutter{12, 30}, ToolUse::removes_stock), Basis::contradicted);
  EXPECT_EQ(basis(FlatCutter{10, 30}, ToolUse::removes_stock), Basis::derived);
  EXPECT_EQ(basis(FlatCutter{8, 30}, ToolUse::removes_stock), Basis::contradicted);
}

TEST(ResolveTools, LongerFlutesThanThoseOfThePathRemoveMoreStock) {
  ToolLibrary library;
  ToolAssembly tool;
  tool.number = 1;
  library.tools.push_back(tool);
  ReadOutcome read = read_toolpath("t.apt", "UNITS/MM\nCUTTER/10,0,5,0,0,0,50\nLOADTL/1\nGOTO/0,0,5\nFINI\n");
  ASSERT_TRUE(read.toolpath.has_value());
  read.toolpath->tools.front().flute_length_mm = 30;
  const auto of = [&](double flutes_mm, ToolUse use) {
    library.tools.front().cutter = FlatCutter{10, flutes_mm};
    library.tools.front().shank = {{10, 10, 50 - flutes_mm}};
    return resolve_tools(*read.toolpath, &library, {}, "", use)->assumptions.front();
  };
  EXPECT_EQ(of(40, ToolUse::finds_gouges).basis, Basis::derived);
  EXPECT_EQ(of(30, ToolUse::removes_stock).basis, Basis::derived);
  EXPECT_EQ(of(20, ToolUse::removes_stock).basis, Basis::derived);
  EXPECT_EQ(of(40, ToolUse::removes_stock).basis, Basis::contradicted);
  EXPECT_NE(
      of(40, ToolUse::removes_stock).evidence.find("flutes of 30 mm by the toolpath, and of 40 mm by the library"),
      std::string::npos);
}

TEST(ResolveTools, AToolForMovesWithoutOneIsContradictedWhereThereAreNone) {
  const ToolLibrary library = library_with_holder();
  const auto unused = [&](const std::string& text, const std::vector<std::string>& names) {
    ReadOptions options;
    options.unnamed_tool = names.front();
    const ReadOutcome read = read_toolpath("t.apt", text, options);
    EXPECT_TRUE(read.toolpath.has_value());
    const Result<ResolvedTools> resolved = resolve_tools(*read.toolpath, &library, names, "");
    EXPECT_TRUE(resolved.has_value());
    for (const Assumption& fact : resolved->assumptions)
      if (fact.code == "tool-not-loaded" && fact.basis == Basis::contradicted) return fact.remedy;
    return std::string();
  };
  EXPECT_EQ(unused("UNITS/MM\nCUTTER/10\nLOADTL/5\nGOTO/0,0,5\nFINI\n", {"2"}),
            "write --tool T5=2, or leave --tool out");
  EXPECT_EQ(unused("UNITS/MM\nGOTO/0,0,5\nFINI\n", {"2"}), "");
}

TEST(ResolveTools, AToolOfThePathIsNamedByItsNumberOrItsName) {
  const ToolLibrary library = library_with_holder();
  const std::string named = "TOOL PATH/A,TOOL,FACE_MILL_1\nTLDATA/MILL,40,1,50,0,0\nGOTO/0,0,5,0,0,1\nEND-OF-PATH\n";
  const ReadOutcome read = read_toolpath("t.cls", named);
  ASSERT_TRUE(read.toolpath.has_value());
  const auto codes = [&](const std::string& name) {
    const Result<ResolvedTools> resolved = resolve_tools(*read.toolpath, &library, {name}, "");
    EXPECT_TRUE(resolved.has_value()) << name;
    std::string all = resolved->facts.front().defined_in == library.file ? "library " : "path ";
    for (const Assumption& fact : resolved->assumptions)
      if (fact.code == "tool-not-loaded") all += fact.evidence;
    return all;
  };
  EXPECT_EQ(codes("FACE_MILL_1=2"), "library ");
  EXPECT_EQ(codes("1=2"), "path --tool names T1, and the toolpath loads FACE_MILL_1");
  EXPECT_EQ(codes("FACE_MILL=2"), "path --tool names FACE_MILL, and the toolpath loads FACE_MILL_1");
  EXPECT_FALSE(resolve_tools(*read.toolpath, &library, {"=2"}, "").has_value());
}

/// The fact of T1 of `text` with `library`, which may be null.
Assumption fact_of_tool(const std::string& text, const ToolLibrary* library,
                        const std::vector<std::string>& names = {}) {
  const ReadOutcome read = read_toolpath("t.apt", text);
  EXPECT_TRUE(read.toolpath.has_value());
  const Result<ResolvedTools> resolved = resolve_tools(*read.toolpath, library, names, "");
  EXPECT_TRUE(resolved.has_value());
  return resolved->assumptions.at(0);
}

TEST(ResolveTools, ALengthThatTheToolpathLeavesOutIsADefault) {
  const auto with = [](const std::string& cutter) {
    return fact_of_tool("UNITS/MM\nLOADTL/1\nCUTTER/" + cutter + "\nGOTO/0,0,5\nFINI\n", nullptr);
  };
  EXPECT_EQ(with("10").basis, Basis::by_default);
  EXPECT_EQ(with("10").code, "cutter-length");
  EXPECT_EQ(with("10,0,5,0,0,0,40").basis, Basis::stated);
}

TEST(ResolveTools, ACutterWhoseNumbersContradictEachOtherIsContradicted) {
  // A spot drill with a flat tip of 3 mm, as a CAM system states it.
  const Assumption fact = fact_of_tool("UNITS/MM\nLOADTL/1\nCUTTER/12,0,6,4.5,45,0,40\nGOTO/0,0,5\nFINI\n", nullptr);
  EXPECT_EQ(fact.basis, Basis::contradicted);
  EXPECT_NE(fact.evidence.find("f = 4.5 mm do not place the corner"), std::string::npos) << fact.evidence;
  EXPECT_EQ(fact.code, "cutter-contradiction");
  EXPECT_TRUE(fact.remedy.starts_with("correct the cutter in the toolpath")) << fact.remedy;
}

TEST(ResolveTools, WhatALibraryLeavesOutMakesItsToolUnknown) {
  const std::string path = "UNITS/MM\nLOADTL/1\nGOTO/0,0,5\nFINI\n";
  const auto with = [&](const std::string& keys) {
    const Result<ToolLibrary> library = read_tool_library(
        "lib.json",
        R"({"units": "mm", "tools": [{"number": 1, "name": "A", "cutter": {"shape": "flat", "diameter": 10, "length": 20)" +
            keys);
    EXPECT_TRUE(library.has_value());
    return fact_of_tool(path, &*library);
  };
  EXPECT_EQ(with("}}]}").basis, Basis::derived);
  EXPECT_EQ(with(R"(}, "holders": []}]})").basis, Basis::unknown);
  EXPECT_EQ(with(R"(, "Corner": 2}}]})").basis, Basis::unknown);
  EXPECT_EQ(with(R"(}, "holders": []}]})").code, "tool-doubtful");
}

TEST(ResolveTools, ANumberAndANameOfTwoToolsContradictEachOther) {
  ToolLibrary library;
  for (const auto& [number, name] : {std::pair(1, "s"), {2, "L"}, {3, ""}}) {
    ToolAssembly& tool = library.tools.emplace_back();
    tool.number = number;
    tool.name = name;
    tool.cutter = FlatCutter{number == 2 ? 40.0 : 4.0, 30};
  }
  const auto evidence = [&](const std::string& file, const std::string& text, ToolUse use = ToolUse::finds_gouges) {
    const ReadOutcome read = read_toolpath(file, text);
    EXPECT_TRUE(read.toolpath.has_value());
    const Result<ResolvedTools> resolved = resolve_tools(*read.toolpath, &library, {}, "", use);
    EXPECT_TRUE(resolved.has_value());
    const Assumption& fact = resolved->assumptions.at(0);
    return fact.basis == Basis::contradicted ? fact.evidence : std::string(fact.basis == Basis::derived ? "" : "open");
  };
  const auto apt = [&](const std::string& tool) {
    return evidence("t.apt", "UNITS/MM\n" + tool + "GOTO/0,0,5\nFINI\n");
  };
  const auto nx = [&](const std::string& name, ToolUse use = ToolUse::finds_gouges) {
    return evidence("t.cls", "TOOL PATH/A,TOOL," + name + "\nLOAD/TOOL,1\nGOTO/0,0,5,0,0,1\nEND-OF-PATH\n", use);
  };
  const std::string differ = "T1 is called L by the toolpath but s by the library, which is what is checked";
  EXPECT_EQ(nx("L"), differ);
  EXPECT_EQ(nx("L", ToolUse::removes_stock), differ);
  EXPECT_EQ(nx("s"), "");
  EXPECT_EQ(nx("S"), "");
  EXPECT_EQ(nx("a name that the library has not"), "");
  EXPECT_EQ(apt("TPRINT/L\nLOADTL/1\n"), differ);
  EXPECT_EQ(apt("TPRINT/L,L,L\nLOADTL/1\n"), differ);
  EXPECT_EQ(apt("LOADTL/1\nGOTO/0,0,9\nTPRINT/L\n"), differ);
  EXPECT_EQ(apt("LOAD/TOOL,1,'L'\n"), differ);
  EXPECT_EQ(apt("LOAD/TOOL,1,'l'\n"), "T1 is called l by the toolpath but s by the library, which is what is checked");
  EXPECT_EQ(apt("TPRINT/L\nLOADTL/3\n"),
            "T3 is called L by the toolpath but not by the library, which is what is checked");
  EXPECT_EQ(apt("TPRINT/L\nLOADTL/2\n"), "");
  EXPECT_EQ(apt("TPRINT/L\nLOADTL/7\n"), "") << "found by its name";
}

TEST(ResolveTools, AnUncertainOrMissingHolderMakesItsToolUnknown) {
  ToolLibrary library = library_with_holder();
  library.holders = {
      {"sure", {{40, 40, 50}}}, {"unsure", {{40, 40, 50}}, "it has a key"}, {"empty", {}, "it is empty"}};
  ToolAssembly bare = library.tools.front();
  bare.number = 3;
  bare.holder.clear();
  bare.missing_holder = "its holder has no segments";
  library.tools.push_back(bare);
  const auto fact = [&](int number, const std::string& holder) {
    Toolpath path = path_in(LengthUnit::mm);
    path.tools.front().number = number;
    path.moves.emplace_back().tool = 0;
    const Result<ResolvedTools> resolved = resolve_tools(path, &library, {}, holder);
    EXPECT_TRUE(resolved.has_value());
    return resolved->assumptions.front();
  };
  EXPECT_EQ(fact(2, "unsure").basis, Basis::derived) << "this tool has a holder of its own";
  EXPECT_EQ(fact(3, "").basis, Basis::unknown);
  EXPECT_EQ(fact(3, "").evidence, "T3: its holder has no segments");
  EXPECT_EQ(fact(3, "sure").basis, Basis::derived);
  EXPECT_EQ(fact(3, "unsure").evidence, "T3: holder \"unsure\": it has a key");
  EXPECT_EQ(fact(3, "empty").basis, Basis::unknown);
  EXPECT_EQ(fact(3, "empty").code, "tool-doubtful");
}

TEST(ResolveTools, AnUncertainHolderMakesAToolOfThePathUnknown) {
  ToolLibrary library;
  library.holders = {{"unsure", {{40, 40, 50}}, "it has a key"}};
  Toolpath path = path_in(LengthUnit::mm);
  path.tools.front().cutter = CutterStatement{{10, 0, 5, 0, 0, 0, 30}, 7};
  path.moves.emplace_back().tool = 0;
  EXPECT_EQ(resolve_tools(path, &library, {}, "unsure")->assumptions.front().basis, Basis::unknown);
  EXPECT_EQ(resolve_tools(path, &library, {}, "")->assumptions.front().basis, Basis::stated);
}

TEST(ResolveTools, AToolpathThatStatesALongerToolIsContradicted) {
  ToolLibrary library;
  ToolAssembly& tool = library.tools.emplace_back();
  tool.number = 1;
  tool.cutter = FlatCutter{10, 30};
  const auto fact = [&](const std::string& cutter, const std::vector<ToolSegment>& shank,
                        const std::vector<ToolSegment>& holder) {
    tool.shank = shank;
    tool.holder = holder;
    const ReadOutcome read = read_toolpath("t.apt", "UNITS/MM\nCUTTER/" + cutter + "\nLOADTL/1\nGOTO/0,0,5\nFINI\n");
    EXPECT_TRUE(read.toolpath.has_value());
    return resolve_tools(*read.toolpath, &library, {}, "")->assumptions.front();
  };
  const std::string longer = "10,0,5,0,0,0,60";
  EXPECT_EQ(fact(longer, {}, {}).basis, Basis::contradicted);
  EXPECT_EQ(fact(longer, {}, {}).evidence,
            "T1 is 60 mm long by the toolpath, but ends at 30 mm by the library, which is what is checked");
  EXPECT_EQ(fact("8,0,4,0,0,0,60", {}, {}).basis, Basis::contradicted) << "thinner and longer";
  EXPECT_EQ(fact(longer, {{10, 10, 30}}, {}).basis, Basis::derived) << "a shank of the same radius";
  EXPECT_EQ(fact(longer, {{10, 10, 10}}, {{32, 32, 20}}).basis, Basis::derived) << "the end is in the holder";
  EXPECT_EQ(
      fact(longer, {{10, 10, 10}, {8, 8, 20}}, {}).evidence,
      "T1 reaches up to 1 mm farther from its axis by the toolpath than above its flutes by the library, which is "
      "what is checked");
  EXPECT_EQ(fact("10,0,5,0,0,0,30.004", {}, {}).basis, Basis::derived) << "a rounded length";
  EXPECT_EQ(fact("10,0", {}, {}).basis, Basis::derived) << "an assumed length states nothing";
}

TEST(ResolveTools, LengthsToTheGaugeLineThatDifferContradictEachOther) {
  ToolLibrary library = library_with_holder();
  library.tools[0].gauge_length_mm = 120;
  Toolpath path = path_in(LengthUnit::mm);
  path.moves.emplace_back().tool = 0;
  const auto resolved = [&](GaugeLength length) {
    return *resolve_tools(path, &library, {}, "", ToolUse::finds_gouges, length);
  };
  const auto basis = [&](GaugeLength length) { return resolved(length).assumptions.front().basis; };
  EXPECT_EQ(basis({}), Basis::derived);
  EXPECT_EQ(basis({120}), Basis::derived);
  EXPECT_EQ(basis({100}), Basis::contradicted);
  EXPECT_EQ(resolved({100}).assumptions.front().evidence,
            "T2 is 100 mm long to the gauge line by the stated tool length, but 120 mm by the library");
  EXPECT_EQ(basis({118, 2}), Basis::derived) << "the interval holds the length of the library";
  EXPECT_EQ(basis({119.4}), Basis::derived) << "measured";
  EXPECT_EQ(resolved({119.4}).notes.at(0).code, "tool-differs");
  path.tools[0].gauge_length_mm = 90;
  EXPECT_EQ(basis({120}), Basis::contradicted) << "the length of the tool itself";
  path.tools[0].gauge_length_mm = {};
  path.tools.emplace_back();
  EXPECT_EQ(basis({100}), Basis::derived) << "a length for several tools is that of none";
}

TEST(ResolveTools, ANumberOfSeveralToolsIsUnknownUnlessOneIsNamed) {
  ToolLibrary library = library_with_holder();
  library.shared_numbers = {2};
  const std::string path = "UNITS/MM\nLOADTL/2\nGOTO/0,0,5\nFINI\n";
  EXPECT_EQ(fact_of_tool(path, &library).basis, Basis::unknown);
  EXPECT_EQ(fact_of_tool(path, &library, {"2=2"}).basis, Basis::stated);
}

TEST(ResolveTools, ANameOfSeveralToolsIsUnknownUnlessOneIsNamed) {
  ToolLibrary library = library_with_holder();
  library.tools[0].name = "MILL";
  library.shared_names = {"MILL"};
  const std::string path = "TOOL PATH/OP,TOOL,MILL\nTLDATA/MILL,12.7,0,38.1,0,0\nUNITS/MM\nGOTO/0,0,5\nEND-OF-PATH\n";
  EXPECT_EQ(fact_of_tool(path, &library).basis, Basis::unknown);
  EXPECT_EQ(fact_of_tool(path, &library, {"MILL=2"}).basis, Basis::stated);
}

TEST(ResolveTools, TheDiameterThatNciStatesIsComparedWithTheLibrary) {
  const ToolLibrary library = library_with_holder();
  const auto of_diameter = [&](const std::string& diameter) {
    return fact_of_tool("1050\n9 18 11 26 2026 10 0 0 A.NCI\n1013\n0 " + diameter +
                            " 0. 0. 0. 0 0 0 0\n1002\n0 100 10 2 2 2 0 1000. 500. 0 0 0 0 0. 0. 100. 1000.\n"
                            "0\n0 0. 0. 60. -2. 0\n1\n0 0. 9. 60. 300. 0\n1003\n0 0 0 0\n",
                        &library)
        .basis;
  };
  EXPECT_EQ(of_diameter("12.7"), Basis::derived);
  EXPECT_EQ(of_diameter("40."), Basis::contradicted);
}

TEST(ResolveTools, ToolsOfTheLibraryMayBeNamedByNumber) {
  const ToolLibrary library = library_with_holder();
  Toolpath path = path_in(LengthUnit::mm);
  for (const std::string name : {"2", "T2"}) {
    path.tools = {PathTool{{}, name, {}, 0, 4}};
    const Result<ResolvedTools> alone = resolve_tools(path, &library, {name}, "");
    ASSERT_TRUE(alone.has_value()) << alone.error().message;
    EXPECT_TRUE(alone->assemblies.at(0).has_value()) << name;
    path.tools = {PathTool{7, "", {}, 0, 4}};
    for (const std::string number : {"7=", "T7="}) {
      const Result<ResolvedTools> renamed = resolve_tools(path, &library, {number + name}, "");
      ASSERT_TRUE(renamed.has_value()) << renamed.error().message;
      EXPECT_TRUE(renamed->assemblies.at(0).has_value()) << number << name;
    }
  }
  const Result<ResolvedTools> missing = resolve_tools(path, &library, {"T3"}, "");
  ASSERT_FALSE(missing.has_value());
  EXPECT_EQ(missing.error().message, "--tool 'T3': the library has no tool of that name or number; it has T2");
  const Result<ResolvedTools> twice = resolve_tools(path, &library, {"7=2", "T7=2"}, "");
  ASSERT_FALSE(twice.has_value());
  EXPECT_EQ(twice.error().message, "--tool 'T7=2': tool T7 of the toolpath has one already; expected each tool once");
}

TEST(ResolveTools, ATextThatMeansTwoToolsOfTheLibraryIsRefused) {
  ToolLibrary library = library_with_holder();
  library.file = "tools.json";
  library.tools.push_back(library.tools.front());
  library.tools.back().number = 3;
  library.tools.front().name = "A";
  library.tools.back().name = "2";
  const Toolpath path = path_in(LengthUnit::mm);
  for (const std::string text : {"2", "7=2"}) {
    const Result<ResolvedTools> two = resolve_tools(path, &library, {text}, "");
    ASSERT_FALSE(two.has_value()) << text;
    EXPECT_EQ(two.error().code, "usage");
    EXPECT_EQ(two.error().message, "--tool '" + text +
                                       "': in tools.json, '2' is the number of T2 \"A\" and the name of T3 \"2\"; "
                                       "expected 'A' for the first, or '3' for the second");
  }
  for (const std::string text : {"7=A", "7=3", "7=T2"})
    EXPECT_TRUE(resolve_tools(path, &library, {text}, "").has_value()) << text;
}

TEST(ResolveTools, AnUnknownHolderIsReportedWithTheHoldersThereAre) {
  ToolLibrary library = library_with_holder();
  const auto reported = [&] { return resolve_tools(path_in(LengthUnit::mm), &library, {}, "ER16").error().message; };
  const std::string start =
      "--holder 'ER16': the library has neither a holder nor a tool with a holder of that name; it has ";
  EXPECT_EQ(reported(), start + "none");
  library.holders = {{"ER32", {{40, 40, 50}}}};
  library.tools.front().name = "flat D12.7";
  EXPECT_EQ(reported(), start + "ER32, flat D12.7");
}

}  // namespace
}  // namespace gouge::resolve_tools_test
