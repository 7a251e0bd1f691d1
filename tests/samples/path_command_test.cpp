#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "tests/samples/program.h"
#include "tests/samples/sample_folder.h"
#include "tests/samples/small_shop.h"
#include "tests/support/source_folder.h"

// `gougecheck path` as a user sees it, on a small file of every dialect and on real files where these are at hand.

namespace gouge::testing_samples::path_command_test {
namespace {

namespace fs = std::filesystem;

const std::string kCorpus = source_folder() + "/tests/corpus/cl";
const std::string kReal = source_folder() + "/../shared/data/toolpaths";

std::vector<std::string> files_below(const std::string& folder) {
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

nlohmann::json info(const std::string& folder, const std::string& file) {
  const Outcome ran = run_gougecheck(folder, {"path", "info", file, "--json", "-"});
  EXPECT_EQ(ran.exit_status, 0) << ran.err;
  return nlohmann::json::parse(ran.out, nullptr, false);
}

TEST(PathInfo, ReadsClDataAsSuchBesideAControl) {
  const std::string folder = fresh_folder();
  write_text(folder + "/a.apt", "PARTNO/A\nUNITS/MM\nCUTTER/10,0,5,0,0,0,40\nGOTO/0,0,50\nGOTO/0,0,5\nFINI\n");
  write_text(folder + "/a.nc", "G21 G90 G17 G94 G40 G49 G80\nG0 X0. Y0. Z50.\nG1 Z5. F100.\nM30\n");
  const Outcome data = run_gougecheck(folder, {"path", "info", "a.apt", "--control", "haas"});
  EXPECT_NE(data.out.find("apt (APT CL data)"), std::string::npos) << data.out << data.err;
  const Outcome program = run_gougecheck(folder, {"path", "info", "a.nc", "--control", "haas"});
  EXPECT_NE(program.out.find("gcode (G-code)"), std::string::npos) << program.out << program.err;
  const Outcome compared = run_gougecheck(
      folder, {"compare", "--paths", "a.apt", "a.nc", "--control", "haas", "--joint-rapid-law", "joint"});
  EXPECT_EQ(compared.exit_status, 0) << compared.out << compared.err;
}

TEST(PathInfo, StatesTheRangeOfTheToolAxis) {
  const SmallShop shop;
  shop.write("up.apt", path_text(stations()));
  const Outcome constant = shop.run({"path", "info", "up.apt", "--json", "up.json"});
  EXPECT_NE(constant.out.find("1: the tool axis is 0, 0, 1 at all positions\n"), std::string::npos) << constant.out;
  EXPECT_EQ(shop.json("up.json").at("first_axis"), nlohmann::json({0, 0, 1}));
  EXPECT_EQ(shop.json("up.json").at("largest_tilt_deg"), 0);
  shop.write("tilted.apt", "UNITS/MM\nMULTAX\nGOTO/0,0,0,0,0,1\nGOTO/1,0,0,0.6,0,0.8\nGOTO/2,0,0,1,0,0\nFINI\n");
  const Outcome tilted = shop.run({"path", "info", "tilted.apt", "--json", "tilted.json"});
  EXPECT_NE(tilted.out.find("3: the first tool axis is 0, 0, 1, the largest tilt from it 90 degrees in line 5\n"),
            std::string::npos)
      << tilted.out;
  EXPECT_EQ(shop.json("tilted.json").at("largest_tilt_line"), 5);
}

TEST(PathInfo, NamesTheOptionOfBlocksAtTheStart) {
  const SmallShop shop;
  shop.write("a.nc", "G21 G90 G17 G54\nG0 X0 Y0 Z5\nG1 Z1 F100\nM30\n");
  const auto error_of = [&](const std::string& block) {
    return shop.run({"path", "info", "a.nc", "--control", "haas", "--start", block}).err;
  };
  EXPECT_NE(error_of("G41").find("by G41 in the blocks at the start (--start)"), std::string::npos) << error_of("G41");
  EXPECT_NE(error_of("G999").find("--start, or start of the machine: 'G999': G999 is not in the table"),
            std::string::npos)
      << error_of("G999");
}

TEST(PathInfo, WarnsOfAnUnknownUnit) {
  const std::string folder = fresh_folder();
  write_text(folder + "/a.apt", "PARTNO/A\nGOTO/0,0,50\nGOTO/0,0,5\nFINI\n");
  const Outcome ran = run_gougecheck(folder, {"path", "info", "a.apt"});
  EXPECT_NE(ran.err.find("give --path-units mm or --path-units inch [path-unit]"), std::string::npos) << ran.err;
}

TEST(PathConvert, WithoutATargetIsTheIdentityOnEveryDialect) {
  const std::string folder = fresh_folder();
  std::size_t files = 0;
  for (const std::string& file : files_below(kCorpus)) {
    const Outcome ran = run_gougecheck(folder, {"path", "convert", file, "-o", "same"});
    EXPECT_EQ(ran.exit_status, 0) << file << ran.err;
    EXPECT_TRUE(text_of(folder + "/same") == text_of(file)) << file;
    ++files;
  }
  EXPECT_GE(files, 13U);
}

TEST(PathConvert, WithoutATargetIsTheIdentityOnRealFilesOrRefusesWhatIsNoClData) {
  if (!fs::exists(kReal)) GTEST_SKIP() << "no real toolpaths beside the checkout (" << kReal << ")";
  const std::string folder = fresh_folder();
  std::size_t same = 0, refused = 0;
  for (const std::string& file : files_below(kReal)) {
    const Outcome ran = run_gougecheck(folder, {"path", "convert", file, "-o", "same"});
    if (ran.exit_status == 0) {
      EXPECT_TRUE(text_of(folder + "/same") == text_of(file)) << file;
      ++same;
    } else {
      EXPECT_EQ(ran.exit_status, 3) << file << ran.err;
      ++refused;
    }
  }
  EXPECT_EQ(same, 29U);
  EXPECT_EQ(refused, 5U);  // three part programs, a table of words, a file without motion
}

TEST(PathConvert, WarnsOfRapidsThatRunAxisByAxis) {
  const std::string folder = fresh_folder();
  write_text(folder + "/c.nc",
             "G17 G21 G90 G40 G49 G80 G94\nG0 B0. C0.\nT1 M6\nG0 X-20. Y50.\nG43 Z50. H1\nG0 Z5.\nG1 X50. F500.\n"
             "G0 X120. Y-20. Z1.\nG0 X20. Y0.\nG0 Z50.\nM30\n");
  const auto converted = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all = {
        "path",          "convert", "c.nc", "-o", "c.apt", "--control", "fanuc", "--machine", "preset:haas-umc750",
        "--tool-length", "100"};
    all.insert(all.end(), more.begin(), more.end());
    const Outcome ran = run_gougecheck(folder, all);
    EXPECT_EQ(ran.exit_status, 0) << ran.err;
    return ran.err;
  };
  const std::string by_rate = converted({"--to", "apt", "--joint-rapid-law", "independent"});
  EXPECT_NE(
      by_rate.find("c.nc:8: warning: 2 rapid moves of several axes written as straight: in the program, each axis "
                   "runs at its own rate; check the output with --rapid dogleg"),
      std::string::npos)
      << by_rate;
  EXPECT_EQ(converted({"--to", "apt", "--joint-rapid-law", "joint"}).find("convert-rapid"), std::string::npos);
  EXPECT_EQ(converted({"--joint-rapid-law", "independent"}).find("convert-rapid"), std::string::npos) << "a copy";
}

TEST(PathConvert, WarnsOfDoubtsThatTheOutputDoesNotState) {
  const SmallShop shop;
  const auto warning = [&](const std::string& text) {
    shop.write("in.apt", text);
    const Outcome ran = shop.run({"path", "convert", "in.apt", "-o", "out.ncl", "--to", "apt-creo"});
    EXPECT_EQ(ran.exit_status, 0) << ran.err;
    return ran.err;
  };
  const std::string whole = path_text(stations());
  EXPECT_EQ(warning(whole).find("path-cut-short"), std::string::npos);
  EXPECT_NE(warning(whole.substr(0, whole.find("FINI"))).find("[path-cut-short]"), std::string::npos);
  for (const std::string text : {"INSERT CYCLE832(0.5)\n", "INSERT ORIAXES\n"}) {
    EXPECT_NE(warning(path_text(stations(), kHead + text)).find("[convert-control]"), std::string::npos) << text;
  }
}

TEST(PathConvert, KeepsMotionToolsAndArcsOnTheWayThroughOtherDialects) {
  const SampleFolder sample = open_sample("arcs_nx");
  const nlohmann::json before = info(sample.path, sample.toolpath());
  for (const char* dialect : {"nx-clsf", "apt-creo", "apt-catia", "apt-solidworks-cam", "camworks-clt", "apt-autodesk",
                              "apt-camplete", "apt-mori"}) {
    const Outcome ran =
        run_gougecheck(sample.path, {"path", "convert", sample.toolpath(), "-o", "other", "--to", dialect});
    ASSERT_EQ(ran.exit_status, 0) << dialect << ran.err;
    const nlohmann::json after = info(sample.path, "other");
    EXPECT_EQ(after.at("dialect"), dialect);
    EXPECT_EQ(after.at("moves"), before.at("moves")) << dialect;
    EXPECT_EQ(after.at("moves_by_kind").at("arc"), 2) << dialect;
    EXPECT_NEAR(after.at("feed_length").get<double>(), before.at("feed_length").get<double>(), 1e-3) << dialect;
    const Outcome checked = run_gougecheck(sample.path, sample.arguments("check", "other"));
    EXPECT_EQ(checked.exit_status, 1) << dialect << checked.err;
    EXPECT_EQ(checked.out.find("dialect (contradicted)"), std::string::npos) << dialect << checked.out;
    EXPECT_NE(checked.out.find("0.214 mm"), std::string::npos) << dialect << checked.out;
  }
}

TEST(PathCommand, RefusesToWriteOverItsInputAndUnknownDialects) {
  const SampleFolder sample = open_sample("arcs_nx");
  const Outcome over =
      run_gougecheck(sample.path, {"path", "convert", sample.toolpath(), "-o", "./" + sample.toolpath()});
  EXPECT_EQ(over.exit_status, 2);
  EXPECT_NE(over.err.find("is the toolpath itself"), std::string::npos) << over.err;
  EXPECT_EQ(run_gougecheck(sample.path, {"path", "convert", sample.toolpath(), "-o", "a", "--to", "fanuc"}).exit_status,
            2);
  const Outcome nci =
      run_gougecheck(sample.path, {"path", "convert", sample.toolpath(), "-o", "a", "--to", "mastercam-nci"});
  EXPECT_EQ(nci.exit_status, 2);
  EXPECT_NE(nci.err.find("mastercam-nci can be read but not written"), std::string::npos) << nci.err;
  EXPECT_EQ(run_gougecheck(sample.path, {"path", "info", sample.toolpath(), "--dialect", "fanuc"}).exit_status, 2);
  EXPECT_FALSE(fs::exists(sample.path + "/a"));
}

TEST(PathPlot, WritesPicturesOfBothKinds) {
  const SampleFolder sample = open_sample("arcs_nx");
  const Outcome with_part =
      run_gougecheck(sample.path, {"path", "plot", sample.toolpath(), "--part", "part.stl", "-o", "with_part.svg"});
  EXPECT_EQ(with_part.exit_status, 0) << with_part.err;
  EXPECT_EQ(
      run_gougecheck(sample.path, {"path", "plot", sample.toolpath(), "--part", "none.stl", "-o", "x.svg"}).exit_status,
      3);
  EXPECT_EQ(run_gougecheck(sample.path, {"path", "plot", sample.toolpath(), "--part", "part.stl", "-o", "part.stl"})
                .exit_status,
            2)
      << "a part is an input";
  for (const auto& [file, start] : {std::pair{"plot.png", "\x89PNG"}, std::pair{"plot.svg", "<svg"}}) {
    EXPECT_EQ(run_gougecheck(sample.path, {"path", "plot", sample.toolpath(), "-o", file}).exit_status, 0);
    EXPECT_NE(text_of(sample.path + "/" + file).substr(0, 200).find(start), std::string::npos) << file;
  }
}

// A program of three axes needs no machine: the law of its rapids is stated alone.
TEST(PathCommand, TakesTheLawOfRapidsWithoutAMachine) {
  const std::string folder = fresh_folder();
  write_text(folder + "/a.h",
             "BEGIN PGM A MM\nTOOL CALL 1 Z S5000\nL Z+50 R0 FMAX M3\nL X+0 Y+0 R0 FMAX\n"
             "L X+10 Y+20 R0 FMAX\nL Z-1 R0 F100\nL X+20 R0 F200\nM30\nEND PGM A MM\n");
  const auto info = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words = {"path", "info", "a.h", "--control", "heidenhain"};
    words.insert(words.end(), more.begin(), more.end());
    return run_gougecheck(folder, words).out;
  };
  EXPECT_NE(info({}).find("expected --joint-rapid-law joint"), std::string::npos) << info({});
  EXPECT_EQ(info({"--joint-rapid-law", "joint"}).find("expected --joint-rapid-law"), std::string::npos);
}

TEST(PathCommand, CountsTheWaysOfCycles) {
  const std::string folder = fresh_folder();
  write_text(folder + "/a.cls",
             "TOOL PATH/D,TOOL,T\nTLDATA/DRILL,MILL,10.0,0.0,50.0,118.0,30.0\nMSYS/0,0,0,1,0,0,0,1,0\nLOAD/TOOL,1\n"
             "RAPID\nGOTO/0,0,20,0,0,1\nCYCLE/DRILL,RAPTO,2.0,FEDTO,-5.0,RTRCTO,20.0,MMPM,100.0\n"
             "GOTO/0,0,0\nGOTO/50,0,0\nCYCLE/OFF\nRAPID\nGOTO/50,0,20\nEND-OF-PATH\n");
  const Outcome ran = run_gougecheck(folder, {"path", "info", "a.cls", "--path-units", "mm"});
  EXPECT_NE(ran.out.find(" cycle"), std::string::npos) << ran.out << ran.err;
  EXPECT_EQ(ran.out.find(" 0 mm feed"), std::string::npos) << ran.out << ran.err;
}

}  // namespace
}  // namespace gouge::testing_samples::path_command_test
