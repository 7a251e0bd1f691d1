#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "tests/samples/csv.h"
#include "tests/samples/program.h"
#include "tests/samples/sample_folder.h"
#include "tests/samples/small_shop.h"

// Exit statuses and streams, as docs/exit_codes.md guarantees them.

namespace gouge::testing_samples::command_line_test {
namespace {

TEST(CommandLine, WithoutACommandOrWithAnUnknownOneIsStatus2) {
  const std::string folder = fresh_folder();
  EXPECT_EQ(run_gougecheck(folder, {}).exit_status, 2);
  const Outcome unknown = run_gougecheck(folder, {"chekc", "a.apt"});
  EXPECT_EQ(unknown.exit_status, 2);
  EXPECT_EQ(unknown.out, "");
  EXPECT_NE(unknown.err, "");
}

TEST(CommandLine, MissingAndUnknownOptionsAreStatus2) {
  const SampleFolder sample = open_sample("needles");
  const std::string path = sample.toolpath();
  EXPECT_EQ(run_gougecheck(sample.path, {"check", path}).exit_status, 2) << "no part";
  EXPECT_EQ(run_gougecheck(sample.path, {"check", "--part", "part.stl"}).exit_status, 2) << "no toolpath";
  EXPECT_EQ(run_gougecheck(sample.path, {"correct", path, "--part", "part.stl"}).exit_status, 2) << "no output";
  EXPECT_EQ(run_gougecheck(sample.path, sample.arguments("check", path, {"--no-such-option"})).exit_status, 2);
  for (const std::string tolerance : {"-1", "abc", "nan", "1e400", "1e300", "100000.1", "5000in", ""}) {
    const Outcome ran = run_gougecheck(sample.path, sample.arguments("check", path, {"--tolerance", tolerance}));
    EXPECT_EQ(ran.exit_status, 2) << "tolerance " << tolerance;
    EXPECT_NE(ran.err.find("--tolerance"), std::string::npos) << ran.err;
  }
}

TEST(CommandLine, HelpIsStatus0AndHasAnExamplePerCommand) {
  const std::string folder = fresh_folder();
  EXPECT_EQ(run_gougecheck(folder, {"--help"}).exit_status, 0);
  for (const std::string command : {"check", "correct", "mesh", "tool", "path"}) {
    const Outcome ran = run_gougecheck(folder, {command, "--help"});
    EXPECT_EQ(ran.exit_status, 0) << command;
    EXPECT_NE(ran.out.find("gougecheck " + command), std::string::npos) << command << ran.out;
    EXPECT_EQ(ran.err, "") << command;
  }
}

// Every command pays for libraries that are loaded before main: with OpenCV's imgcodecs it was 141 libraries and 0.05 s.
TEST(CommandLine, LoadsFewLibraries) {
  ::setenv("LD_TRACE_LOADED_OBJECTS", "1", 1);  // the dynamic loader lists them instead of running the program
  const Outcome ran = run_gougecheck(fresh_folder(), {"--version"});
  ::unsetenv("LD_TRACE_LOADED_OBJECTS");
  const auto count = std::count(ran.out.begin(), ran.out.end(), '\n');
  EXPECT_GT(count, 5) << ran.out;
  EXPECT_LT(count, 40) << ran.out;
  EXPECT_EQ(ran.out.find("libgdal"), std::string::npos) << ran.out;
}

TEST(CommandLine, CsvOnStandardOutputIsAlone) {
  const SampleFolder sample = open_sample("pocket");
  const Outcome ran = run_gougecheck(sample.path, sample.arguments("check", sample.toolpath(), {"--csv", "-"}));
  EXPECT_EQ(ran.exit_status, 1);
  EXPECT_EQ(ran.out.rfind(kCsvHeader, 0), 0U) << ran.out.substr(0, 200);
  EXPECT_EQ(parse_csv(ran.out).size(), sample.expected.at("moves").get<std::size_t>() + 1);
}

TEST(CommandLine, JsonOnStandardOutputIsAlone) {
  const SampleFolder sample = open_sample("pocket");
  const Outcome ran = run_gougecheck(sample.path, sample.arguments("check", sample.toolpath(), {"--json", "-"}));
  EXPECT_EQ(ran.exit_status, 1);
  EXPECT_TRUE(nlohmann::json::accept(ran.out)) << ran.out.substr(0, 200);
}

TEST(CommandLine, AToolpathOnStandardOutputIsAlone) {
  const SampleFolder sample = open_sample("between_rib");
  const std::string path = sample.toolpath();
  const Outcome in_file =
      run_gougecheck(sample.path, sample.arguments("correct", path, {"-o", "corrected.apt", "--csv", "all.csv"}));
  const Outcome alone =
      run_gougecheck(sample.path, sample.arguments("correct", path, {"-o", "-", "--csv", "again.csv"}));
  EXPECT_EQ(alone.exit_status, in_file.exit_status);
  EXPECT_TRUE(alone.out == text_of(sample.path + "/corrected.apt")) << alone.out;
  EXPECT_EQ(text_of(sample.path + "/again.csv"), text_of(sample.path + "/all.csv"));
  const Outcome two = run_gougecheck(sample.path, sample.arguments("correct", path, {"-o", "-", "--json", "-"}));
  EXPECT_EQ(two.exit_status, 2);
  EXPECT_EQ(two.out, "");
  EXPECT_NE(two.err.find("only one output can go to standard output"), std::string::npos) << two.err;
  const Outcome copied = run_gougecheck(sample.path, {"path", "convert", path, "-o", "-"});
  EXPECT_EQ(copied.exit_status, 0);
  EXPECT_TRUE(copied.out == text_of(sample.path + "/" + path)) << copied.out;
  const Outcome mesh = run_gougecheck(sample.path, {"mesh", "part.stl", "--repair", "-"});
  EXPECT_EQ(mesh.exit_status, 2) << mesh.err;
  EXPECT_EQ(run_gougecheck(sample.path, sample.arguments("check", path, {"--report", "-"})).exit_status, 2);
  EXPECT_FALSE(std::filesystem::exists(sample.path + "/-"));
}

TEST(CommandLine, ACorrectionReportsHowTheAxisTurns) {
  const SampleFolder swing = open_sample("between_swing");
  const auto correct = [](const SampleFolder& sample, const std::vector<std::string>& options) {
    std::vector<std::string> all = {"-o", "corrected.apt", "--json", "result.json"};
    all.insert(all.end(), options.begin(), options.end());
    return run_gougecheck(sample.path, sample.arguments("correct", sample.toolpath(), all));
  };
  const Outcome ran = correct(swing, {"--max-rotary-speed", "600", "--strategy", "axis"});
  EXPECT_EQ(ran.exit_status, 0) << ran.err;
  EXPECT_NE(ran.out.find("\naxis turns: up to "), std::string::npos) << ran.out;
  const nlohmann::json report = nlohmann::json::parse(text_of(swing.path + "/result.json"));
  EXPECT_EQ(report["options"]["more"]["max-rotary-speed"], "600");
  const nlohmann::json& quality = report["correction"]["quality"];
  EXPECT_EQ(quality["before"]["turns_on_the_spot"], 1) << "60 degrees at 10 degrees a second";
  EXPECT_NEAR(quality["before"]["feed_seconds_with_max_rotary_speed"].get<double>(), 6, 1e-3);
  EXPECT_GT(quality["after"]["feed_seconds"].get<double>(), quality["before"]["feed_seconds"].get<double>());
  EXPECT_EQ(quality["positions"]["tilted"], 0) << "positions were lifted along axes that the motion passes";
  const SampleFolder upright = open_sample("between_rib");
  const Outcome silent = correct(upright, {});
  EXPECT_EQ(silent.out.find("axis turns"), std::string::npos) << silent.out;
  EXPECT_EQ(silent.out.find("feed time"), std::string::npos) << silent.out;
}

TEST(CommandLine, AStrategyIsGivenOnceForAllAndOnceForABody) {
  const SampleFolder sample = open_sample("between_swing");
  const auto status = [&](std::vector<std::string> options) {
    options.insert(options.end(), {"-o", "corrected.apt"});
    return run_gougecheck(sample.path, sample.arguments("correct", sample.toolpath(), options)).exit_status;
  };
  EXPECT_EQ(status({"--strategy", "holder=tilt", "--strategy", "holder=axis"}), 2);
  EXPECT_EQ(status({"--strategy", "auto", "--strategy", "trim"}), 2);
  EXPECT_EQ(status({"--strategy", "holder=axis", "--strategy", "auto"}), 0);
}

TEST(CommandLine, AToolpathMayComeAfterTheOptionsThatAreRepeatable) {
  const SampleFolder sample = open_sample("between_rib");
  const Outcome ran =
      run_gougecheck(sample.path, {"check", "--tools", "tools.json", "--part", "part.stl", sample.toolpath()});
  EXPECT_EQ(ran.exit_status, 1) << ran.err;
  const Outcome both = run_gougecheck(sample.path, sample.arguments("check", sample.toolpath(), {"-q", "-v"}));
  EXPECT_EQ(both.exit_status, 2);
  EXPECT_EQ(both.err, "gougecheck: error: -q and -v exclude each other; expected one of them [usage]\n");
}

TEST(CommandLine, QuietPrintsNothingButKeepsTheStatus) {
  const SampleFolder sample = open_sample("between_rib");
  const Outcome ran = run_gougecheck(sample.path, sample.arguments("check", sample.toolpath(), {"-q"}));
  EXPECT_EQ(ran.exit_status, 1);
  EXPECT_EQ(ran.out, "");
}

TEST(CommandLine, VerboseShowsThePeakMemoryToPeopleOnly) {
  const SampleFolder sample = open_sample("needles");
  const std::string path = sample.toolpath();
  const Outcome reported = run_gougecheck(sample.path, sample.arguments("check", path, {"-v", "--json", "-"}));
  const std::size_t at = reported.err.find("memory: ");
  ASSERT_NE(at, std::string::npos) << reported.err;
  EXPECT_GT(std::stoul(reported.err.substr(at + 8)), 2U);
  EXPECT_NE(reported.err.find(" MB at the peak\n"), std::string::npos) << reported.err;
  EXPECT_EQ(reported.out.find("at the peak"), std::string::npos);
  const Outcome plain = run_gougecheck(sample.path, sample.arguments("check", path, {"--json", "-"}));
  EXPECT_EQ(plain.out, reported.out);
  EXPECT_EQ(plain.err.find("memory: "), std::string::npos) << plain.err;
}

TEST(CommandLine, AMoveThatCannotBeCheckedIsStatus4) {
  const SampleFolder sample = open_sample("needles");
  // From one axis to the opposite one the great circle is not determined.
  write_text(sample.path + "/turn.apt", "UNITS/MM\nMULTAX/ON\nLOADTL/1\nGOTO/0,0,500,0,0,1\nGOTO/0,0,510,0,0,-1\n");
  const Outcome ran = run_gougecheck(sample.path, sample.arguments("check", "turn.apt", {"--csv", "all.csv"}));
  EXPECT_EQ(ran.exit_status, 4) << ran.out << ran.err;
  const std::vector<MoveRow> rows = parse_moves(text_of(sample.path + "/all.csv"));
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].state, "clean");
  EXPECT_EQ(rows[1].state, "not-checked");
  EXPECT_EQ(rows[1].depth + rows[1].depth_upper, "");
}

TEST(CommandLine, WithoutAnyToolDefinedNothingIsWrittenAndTheStatusIs3) {
  const SampleFolder sample = open_sample("needles");
  write_text(sample.path + "/t9.apt", "UNITS/MM\nLOADTL/9\nGOTO/0,0,10\nGOTO/0,0,20\n");
  const Outcome ran = run_gougecheck(sample.path, sample.arguments("check", "t9.apt", {"--csv", "all.csv"}));
  EXPECT_EQ(ran.exit_status, 3) << ran.out << ran.err;
  EXPECT_NE(ran.err.find("t9.apt:2: error: no tool of the toolpath is defined"), std::string::npos) << ran.err;
  EXPECT_FALSE(std::filesystem::exists(sample.path + "/all.csv"));
}

TEST(CommandLine, AToolThatDiffersFromTheLibraryIsReported) {
  const SampleFolder sample = open_sample("needles");
  write_text(sample.path + "/d99.apt", "UNITS/MM\nCUTTER/99\nLOADTL/1\nGOTO/0,0,50\n");
  const Outcome ran = run_gougecheck(sample.path, sample.arguments("check", "d99.apt", {}));
  EXPECT_EQ(ran.exit_status, 4) << ran.out << ran.err;
  EXPECT_NE(ran.err.find("warning: T1 is D 99"), std::string::npos) << ran.err;
  EXPECT_NE(ran.out.find("not established: tool T1 (contradicted)"), std::string::npos) << ran.out;
  const Outcome stated = run_gougecheck(
      sample.path, sample.arguments("check", "d99.apt", {"--assume", "tool=T1", "--assume", "placement"}));
  EXPECT_EQ(stated.exit_status, 0) << stated.out << stated.err;
  const Outcome quiet = run_gougecheck(sample.path, sample.arguments("check", "d99.apt", {"-q"}));
  EXPECT_NE(quiet.err.find("warning: T1 is D 99"), std::string::npos) << "open facts are never lost";
}

TEST(CommandLine, AToolWithoutADefinitionBesideOthersIsStatus4) {
  const SampleFolder sample = open_sample("needles");
  write_text(sample.path + "/t9.apt", "UNITS/MM\nLOADTL/9\nGOTO/0,0,10\nGOTO/0,0,20\nLOADTL/1\nGOTO/0,0,50\n");
  const Outcome ran = run_gougecheck(sample.path, sample.arguments("check", "t9.apt", {"--csv", "all.csv"}));
  EXPECT_EQ(ran.exit_status, 4) << ran.out << ran.err;
  EXPECT_NE(ran.out.find("not checked: the tool has no definition"), std::string::npos) << ran.out << ran.err;
  const std::vector<MoveRow> rows = parse_moves(text_of(sample.path + "/all.csv"));
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0].state, "not-checked");
  EXPECT_EQ(rows[1].state, "not-checked");
  EXPECT_EQ(rows[2].state, "clean");
}

// Bare lists of positions name no tool.
TEST(CommandLine, AToolNameAloneIsForMovesThatNameNoTool) {
  const SampleFolder sample = open_sample("between_rib");
  write_text(sample.path + "/list.txt", "GOTO/-20.0 0.0 5.0 0.0 0.0 1.0\nGOTO/20.0 0.0 5.0 0.0 0.0 1.0\n");
  const Outcome without = run_gougecheck(sample.path, sample.arguments("check", "list.txt", {}));
  EXPECT_EQ(without.exit_status, 3);
  EXPECT_NE(without.err.find("with --tool NAME where the file names none"), std::string::npos) << without.err;
  const Outcome with = run_gougecheck(sample.path, sample.arguments("check", "list.txt", {"--tool", "flat D10", "-v"}));
  EXPECT_EQ(with.exit_status, 1) << with.err;
  EXPECT_NE(with.out.find("list.txt:2: gouge: 3.000 mm cutter"), std::string::npos) << with.out;
  EXPECT_NE(with.err.find("2 moves for which the file names no tool: \"flat D10\" as asked"), std::string::npos)
      << with.err;
  const Outcome corrected = run_gougecheck(
      sample.path,
      sample.arguments("correct", "list.txt", {"--tool", "flat D10", "--path-units", "mm", "-o", "lifted.txt"}));
  EXPECT_EQ(corrected.exit_status, 0) << corrected.out << corrected.err;
  const Outcome unknown = run_gougecheck(sample.path, sample.arguments("check", "list.txt", {"--tool", "ball D3"}));
  EXPECT_EQ(unknown.exit_status, 2);
  const Outcome twice =
      run_gougecheck(sample.path, sample.arguments("check", "list.txt", {"--tool", "flat D10", "--tool", "flat D10"}));
  EXPECT_EQ(twice.exit_status, 2);
  EXPECT_NE(twice.err.find("--tool 'flat D10': expected N=NAME"), std::string::npos) << twice.err;
}

TEST(CommandLine, OptionsWithoutEffectAreStatedBesideTheVerdict) {
  const SmallShop shop;
  const std::string text = path_text(stations());
  const auto noted = [&](const std::vector<std::string>& more) {
    const Outcome ran = shop.check("a", text, more);
    EXPECT_EQ(ran.exit_status, 0) << ran.err;
    const std::size_t at = ran.out.find("no effect: ");
    return at == std::string::npos ? std::string() : ran.out.substr(at, ran.out.find('\n', at) - at);
  };
  EXPECT_EQ(noted({"--offset", "G54=1,2,3", "--plain-numbers", "units"}), "no effect: the toolpath is CL data");
  EXPECT_EQ(noted({"--tool-length", "100"}), "no effect: no --machine is given");
  EXPECT_EQ(noted({"--assume", "tool=T7"}), "no effect: there is tool=T1");
  EXPECT_EQ(noted({"--assume", "tool=T1"}), "");
  EXPECT_EQ(noted({"--assume", "stock"}), "") << "it serves several paths";
}

TEST(CommandLine, AProgramIsNotCorrectedWhateverItStillNeeds) {
  const SmallShop shop;
  shop.write("p.nc", "%\nO1\nG21 G90 G17 G94\nG0 A90. X0 Y0 Z5.\nG1 Z1. F100\nM30\n%\n");
  shop.write("part.stl", plate_stl());
  for (const std::string name : {"p.nc", "-"}) {
    const Outcome ran =
        shop.run_script("$GOUGECHECK correct " + name + " --part part.stl --control haas -o x.nc < p.nc");
    EXPECT_EQ(ran.exit_status, 3);
    EXPECT_TRUE(name == "-" || ran.err.find("[write-gcode]") != std::string::npos) << ran.err;
  }
}

TEST(CommandLine, ALargerToleranceTurnsAShallowGougeClean) {
  const SampleFolder sample = open_sample("big_triangles");
  EXPECT_EQ(
      run_gougecheck(sample.path, sample.arguments("check", sample.toolpath(), {"--tolerance", "0.2"})).exit_status, 0);
  EXPECT_EQ(
      run_gougecheck(sample.path, sample.arguments("check", sample.toolpath(), {"--tolerance", "0.05"})).exit_status,
      1);
}

TEST(CommandLine, ReportsLeavePicturesAndAPageInTheFolder) {
  const SampleFolder sample = open_sample("between_rib");
  const Outcome ran = run_gougecheck(sample.path, sample.arguments("check", sample.toolpath(), {"--report", "report"}));
  EXPECT_EQ(ran.exit_status, 1) << ran.err;
  std::size_t pictures = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(sample.path + "/report")) {
    if (entry.path().extension() != ".png") continue;
    ++pictures;
    EXPECT_EQ(text_of(entry.path().string()).substr(1, 3), "PNG") << entry.path();
  }
  EXPECT_GE(pictures, 2U);
}

}  // namespace
}  // namespace gouge::testing_samples::command_line_test
