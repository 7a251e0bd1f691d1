#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "tests/samples/box_stl.h"
#include "tests/samples/program.h"
#include "tests/samples/sample_folder.h"
#include "tests/samples/sealed_result.h"

// Remaining stock, as users see it.

namespace gouge::testing_samples::stock_test {
namespace {

using Json = nlohmann::json;

constexpr double kResolution_mm = 0.05;

class StockSample : public testing::Test {
 protected:
  Outcome run(const std::string& sample, const std::vector<std::string>& more) {
    sample_ = open_sample(sample);
    return run_again(more);
  }
  [[nodiscard]] Outcome run_again(const std::vector<std::string>& more) const {
    return run_gougecheck(sample_.path, sample_.arguments("check", sample_.toolpath(), more));
  }
  [[nodiscard]] Json json_of(const std::string& file) const { return Json::parse(text_of(sample_.path + "/" + file)); }

  SampleFolder sample_;
};

/// A program that cuts the way of the rapid of `rapid_stock` at y = 30, from above or from below.
std::string slot_program(bool is_from_below) {
  const std::string at = is_from_below ? ", -30, -0.5, 0, 0, 1\n" : ", 30, -5, 0, 0, 1\n";
  return "UNITS/MM\nMULTAX/ON\nLOADTL/1\nFEDRAT/1000, MMPM\nRAPID\nGOTO/-60" + at + "GOTO/130" + at + "FINI\n";
}

TEST_F(StockSample, ARapidThroughMaterialIsFoundWithItsFirstContact) {
  EXPECT_EQ(run("rapid_stock", {}).exit_status, 0);
  const Outcome ran = run_again({"--stock", "part+5", "--json", "check.json"});
  EXPECT_EQ(ran.exit_status, 1) << ran.err;
  EXPECT_NE(ran.out.find("rapid into stock: "), std::string::npos) << ran.out;
  const Json report = json_of("check.json");
  ASSERT_EQ(report.at("moves").size(), 1U);
  const Json& move = report.at("moves").at(0);
  EXPECT_EQ(move.at("witness").at("against"), "stock");
  EXPECT_LE(move.at("depth").get<double>(), 5 + 1e-9);
  EXPECT_GE(move.at("depth").get<double>(), 4);
  EXPECT_GE(move.at("depth_upper").get<double>(), 5 - 3 * kResolution_mm);
  // The tool runs from x = 120 to -40. The offset of the part is round, and at the height of its face, 5 mm above the part, it
  // begins at x = 80. The tool is 0.1 mm deep there at the height of its tip, where the offset begins at x = 85.
  const Json& contact = report.at("stock").at("contacts").at(0);
  const double exact = (120 - 89.9) / 160;
  EXPECT_LE(contact.at("clear_until").get<double>(), exact + 2 * kResolution_mm / 160);
  EXPECT_GE(contact.at("contact_at").get<double>(), exact - 1e-9);
  EXPECT_NEAR(contact.at("missed_by").get<double>(), 15, 1e-6);
  EXPECT_EQ(report.at("stock").at("examined").get<int>(), 7);
  EXPECT_EQ(report.at("stock").at("clear").get<int>(), 6);
}

TEST_F(StockSample, ComparisonsJudgeFindingsInStockByTheStrictnessOfTheirCheck) {
  ASSERT_EQ(run("rapid_stock", {"--stock", "part+5", "--json", "a.json", "-q"}).exit_status, 1);
  for (const auto& [options, status, text] :
       {std::tuple(std::vector<std::string>{"--stock", "part+5", "--stock-tolerance", "9"}, 4,
                   "the tolerance of the stock is 9 mm, 0.1 mm before"),
        {{}, 4, "no stock is given"},
        {{"--stock", "box"}, 0, "note: --stock is box, part+5 before"}}) {
    std::vector<std::string> words = options;
    words.insert(words.end(), {"--json", "b.json", "-q"});
    (void)run_again(words);
    const Outcome ran = run_gougecheck(sample_.path, {"compare", "a.json", "b.json"});
    EXPECT_EQ(ran.exit_status, status) << ran.out;
    EXPECT_NE(ran.out.find(text), std::string::npos) << ran.out;
  }
}

TEST_F(StockSample, RapidsThatAreSkippedAreNotExamined) {
  ASSERT_NE(run("rapid_stock", {"--stock", "part+5", "--rapid", "skip", "--json", "a.json", "-q"}).exit_status, 1);
  const Json stock = json_of("a.json").at("stock");
  EXPECT_TRUE(stock.at("contacts").empty());
  EXPECT_EQ(stock.at("examined"), stock.at("clear"));
}

TEST_F(StockSample, AHolderInAnUncutWallIsFound) {
  EXPECT_EQ(run("holder_stock", {}).exit_status, 0);
  const Outcome ran = run_again({"--stock", "box", "--json", "check.json"});
  EXPECT_EQ(ran.exit_status, 1) << ran.err;
  EXPECT_NE(ran.out.find("holder in stock: "), std::string::npos) << ran.out;
  const Json report = json_of("check.json");
  const Json& first = report.at("moves").at(0);
  EXPECT_EQ(first.at("kind"), "feed");
  EXPECT_EQ(first.at("witness").at("body"), "holder");
  EXPECT_LE(first.at("depth").get<double>(), 8 + 1e-9);
  EXPECT_GE(first.at("depth_upper").get<double>(), 8 - 3 * kResolution_mm);
  // A cure from parts and fixtures would not free it from stock.
  const Outcome cured = run_again({"--stock", "box", "--find-cures"});
  EXPECT_EQ(cured.out.find("cured by"), std::string::npos) << cured.out;
}

TEST_F(StockSample, TheMaterialOfAFileIsChecked) {
  ASSERT_EQ(run("rapid_stock", {}).exit_status, 0);
  // The part is as low as the slot: as the stock it leaves nothing to meet.
  EXPECT_EQ(run_again({"--stock", "part.stl"}).exit_status, 0);
  EXPECT_EQ(run_again({"--stock", "box"}).exit_status, 0);
  EXPECT_EQ(run_again({"--stock", "box=5"}).exit_status, 1);
  EXPECT_EQ(run_again({"--stock", "box=0.09"}).exit_status, 0);
  EXPECT_EQ(run_again({"--stock", "box=5", "--stock-tolerance", "6"}).exit_status, 0);
}

TEST_F(StockSample, AStockThatDoesNotHoldThePartProvesNothing) {
  ASSERT_EQ(run("rapid_stock", {}).exit_status, 0);
  write_text(sample_.path + "/far.stl", box_stl({1000, 1000, 0}, {1010, 1010, 10}));
  const Outcome far = run_again({"--stock", "far.stl"});
  EXPECT_EQ(far.exit_status, 4) << far.out;
  EXPECT_NE(far.out.find("stock (contradicted): the part reaches"), std::string::npos) << far.out;
  EXPECT_EQ(run_again({"--stock", "far.stl", "--assume", "stock"}).exit_status, 0);
}

TEST_F(StockSample, FindingsInStockAreNotAccepted) {
  ASSERT_EQ(run("holder_stock", {"--stock", "box", "--json", "result.json"}).exit_status, 1);
  const Outcome listed = run_gougecheck(sample_.path, {"accept", "result.json"});
  EXPECT_NE(listed.out.find(" into stock, "), std::string::npos) << listed.out;
  const Outcome ran = run_gougecheck(
      sample_.path, {"accept", "result.json", "--finding", "1", "--reason", "x", "--by", "y", "-o", "a.json"});
  EXPECT_EQ(ran.exit_status, 3);
  EXPECT_NE(ran.err.find("meets remaining stock"), std::string::npos) << ran.err;
}

TEST_F(StockSample, TheResultIsTheSameAtAnyNumberOfThreads) {
  ASSERT_EQ(run("holder_stock", {"--stock", "box", "--threads", "1", "--csv", "one.csv"}).exit_status, 1);
  ASSERT_EQ(run_again({"--stock", "box", "--threads", "3", "--csv", "three.csv"}).exit_status, 1);
  EXPECT_EQ(text_of(sample_.path + "/one.csv"), text_of(sample_.path + "/three.csv"));
}

TEST_F(StockSample, AllOutputsHaveTheFinding) {
  ASSERT_EQ(run("rapid_stock",
                {"--stock", "part+5", "--sarif", "r.sarif", "--junit", "r.xml", "--csv", "r.csv", "--report", "report"})
                .exit_status,
            1);
  for (const char* file : {"r.sarif", "r.xml", "report/report.html"})
    EXPECT_NE(text_of(sample_.path + "/" + file).find("rapid into stock"), std::string::npos) << file;
  EXPECT_NE(text_of(sample_.path + "/r.csv").find(",stock,"), std::string::npos);
}

TEST_F(StockSample, WhatItDoesNotCoverIsRefused) {
  ASSERT_EQ(run("rapid_stock", {"--stock", "part+5"}).exit_status, 1);
  for (const std::vector<std::string>& more :
       {std::vector<std::string>{"--stock", "box=x"}, std::vector<std::string>{"--stock", "part+-1"},
        std::vector<std::string>{"--stock", "box", "--stock-resolution", "0"}}) {
    const Outcome ran = run_again(more);
    EXPECT_EQ(ran.exit_status, 2) << ran.err;
    EXPECT_NE(ran.err.find("--stock"), std::string::npos) << ran.err;
  }
  EXPECT_EQ(run_again({"--stock", "missing.stl"}).exit_status, 3);
  const Outcome overwritten = run_again({"--stock", "part.stl", "--json", "part.stl"});
  EXPECT_EQ(overwritten.exit_status, 2) << overwritten.err;
}

TEST_F(StockSample, DepthsHoldForAllMotionsThatTolerancesAndLawsPermit) {
  const std::vector<std::string> plain{"--stock", "box", "--tolerance", "0.2", "--json", "check.json"};
  ASSERT_EQ(run("holder_stock", plain).exit_status, 1);
  const double depth = json_of("check.json").at("moves").at(0).at("depth").get<double>();
  const double upper = json_of("check.json").at("moves").at(0).at("depth_upper").get<double>();
  for (const std::vector<std::string>& more :
       {std::vector<std::string>{"--tip-tolerance", "0.05", "--axis-tolerance", "0.05"},
        std::vector<std::string>{"--machine", "preset:haas-umc750", "--rapid-law", "documented"}}) {
    std::vector<std::string> all = plain;
    all.insert(all.end(), more.begin(), more.end());
    const Outcome ran = run_again(all);
    EXPECT_EQ(ran.exit_status, 1) << ran.err;
    EXPECT_NE(ran.out.find("holder in stock"), std::string::npos) << ran.out;
    const Json move = json_of("check.json").at("moves").at(0);
    EXPECT_LE(move.at("depth").get<double>(), upper);
    EXPECT_GT(move.at("depth").get<double>(), 0.9 * depth);
    EXPECT_GE(move.at("depth_upper").get<double>(), depth);
    const Outcome verified = run_gougecheck(sample_.path, {"verify", "check.json"});
    EXPECT_EQ(verified.exit_status, 0) << verified.out << verified.err;
  }
}

TEST_F(StockSample, VerifyTestsTheWitnessesAndTheClearMoves) {
  ASSERT_EQ(run("rapid_stock", {"--stock", "part+5"}).exit_status, 1);
  write_text(sample_.path + "/op10.apt", slot_program(false));
  const auto verified = [&](const std::string& change) {
    Json report = json_of("check.json");
    Json& more = report.at("options").at("more");
    if (change == "depth")
      report.at("moves").at(0).at("depth") = report.at("moves").at(0).at("depth").get<double>() + 0.01;
    if (change == "smaller stock") more.at("stock") = "part+4";
    if (change == "other cut") more.at("before") = "op10.apt";
    if (change == "moved cut") more.at("before") = "op10.apt,place=0,2,0";
    write_text(sample_.path + "/claim.json", sealed(report));
    return run_gougecheck(sample_.path, {"verify", "claim.json"});
  };
  ASSERT_EQ(run_again({"--stock", "part+5", "--before", "op10.apt,place=0,2,0", "--json", "check.json"}).exit_status,
            1);
  const Outcome found = verified("");
  EXPECT_EQ(found.exit_status, 0) << found.out << found.err;
  EXPECT_NE(found.out.find("1 witness in the stock"), std::string::npos) << found.out;
  EXPECT_NE(verified("depth").out.find("deep, and said to be"), std::string::npos);
  EXPECT_NE(verified("smaller stock").out.find("outside of the stock"), std::string::npos);
  EXPECT_NE(verified("other cut").out.find("of op10.apt was there before"), std::string::npos);
  ASSERT_EQ(run_again({"--stock", "part+5", "--before", "op10.apt", "--json", "check.json"}).exit_status, 0);
  EXPECT_EQ(verified("").exit_status, 0);
  const Outcome false_clean = verified("moved cut");
  EXPECT_EQ(false_clean.exit_status, 1);
  EXPECT_NE(false_clean.out.find("stock is left"), std::string::npos) << false_clean.out;
}

TEST_F(StockSample, CertificatesProveTheClaimsAboutPartAndStock) {
  for (const auto& [sample, stock] : {std::pair("rapid_stock", "part+5"), std::pair("holder_stock", "box")}) {
    ASSERT_EQ(run(sample, {"--stock", stock, "--json", "check.json", "--certificate", "proofs.gcp"}).exit_status, 1);
    const Outcome ran = run_gougecheck(sample_.path, {"verify", "check.json", "--certificate", "proofs.gcp"});
    EXPECT_EQ(ran.exit_status, 0) << ran.out << ran.err;
    EXPECT_NE(ran.out.find("proved clean against parts and fixtures, at every instant"), std::string::npos) << ran.out;
    const bool is_all_proved = std::string_view(sample) == "rapid_stock";
    const std::string moves = is_all_proved ? "7 moves" : "12 moves";
    EXPECT_NE(ran.out.find(moves + " proved to meet no remaining stock"), std::string::npos) << ran.out;
    EXPECT_EQ(ran.out.find("result: verified") != std::string::npos, is_all_proved) << ran.out;
  }
}

TEST_F(StockSample, ACertificateProvesNoDepthBelowTheOneOfItsCheck) {
  const std::vector<std::string> more{"--stock", "part+5", "--json", "check.json", "--certificate", "proofs.gcp"};
  ASSERT_EQ(run("rapid_stock", more).exit_status, 1);
  Json report = json_of("check.json");
  Json& move = report.at("moves").at(0);
  move.at("depth_upper") = move.at("depth");
  write_text(sample_.path + "/claim.json", sealed(report));
  const Outcome ran = run_gougecheck(sample_.path, {"verify", "claim.json", "--certificate", "proofs.gcp"});
  EXPECT_EQ(ran.exit_status, 1) << ran.out << ran.err;
  EXPECT_NE(ran.out.find("refuted: what the proof names"), std::string::npos) << ran.out;
}

TEST_F(StockSample, VerifyAcceptsTheHolderInTheWall) {
  ASSERT_EQ(run("holder_stock", {"--stock", "box", "--json", "check.json"}).exit_status, 1);
  const Outcome ran = run_gougecheck(sample_.path, {"verify", "check.json"});
  EXPECT_EQ(ran.exit_status, 0) << ran.out << ran.err;
}

TEST_F(StockSample, AnOpenStockIsRefused) {
  ASSERT_EQ(run("rapid_stock", {}).exit_status, 0);
  write_text(sample_.path + "/open.stl",
             "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 9 0 0\nvertex 0 9 0\nendloop\nendfacet\n"
             "endsolid s\n");
  const Outcome ran = run_again({"--stock", "open.stl"});
  EXPECT_EQ(ran.exit_status, 3);
  EXPECT_NE(ran.err.find("[stock-open-mesh]"), std::string::npos) << ran.err;
}

TEST_F(StockSample, AnEarlierProgramRemovesWhatItCut) {
  ASSERT_EQ(run("rapid_stock", {"--stock", "part+5"}).exit_status, 1);
  write_text(sample_.path + "/op10.apt", slot_program(false));
  write_text(sample_.path + "/below.apt", slot_program(true));
  const auto after = [&](const std::string& program) {
    return run_again({"--stock", "part+5", "--before", program, "--json", "check.json"});
  };
  EXPECT_EQ(after("op10.apt").exit_status, 0);
  EXPECT_EQ(after("op10.apt,tools=tools.json").exit_status, 0);
  EXPECT_EQ(after("below.apt").exit_status, 1);
  EXPECT_EQ(after("below.apt,place=0,0,0,180,0,0").exit_status, 0);
  // Moved aside, it leaves a wall. The finding names the file of the nearest cut.
  const Outcome beside = after("op10.apt,place=0,1,0");
  EXPECT_EQ(beside.exit_status, 1);
  EXPECT_NE(beside.out.find("line 7 of op10.apt, misses it by"), std::string::npos) << beside.out;
  const Json report = json_of("check.json");
  EXPECT_EQ(report.at("stock").at("contacts").at(0).at("cut_file"), "op10.apt");
  EXPECT_EQ(report.at("inputs").at(3).at("role"), "before");
}

TEST_F(StockSample, AnEarlierProgramIsReadWithCare) {
  ASSERT_EQ(run("rapid_stock", {"--stock", "part+5"}).exit_status, 1);
  write_text(sample_.path + "/op10.apt", slot_program(false));
  write_text(sample_.path + "/other.json",
             R"({"units":"mm","tools":[{"number":7,"cutter":{"shape":"flat","diameter":10,"length":25}}]})");
  const auto after = [&](const std::string& program) { return run_again({"--stock", "part+5", "--before", program}); };
  EXPECT_EQ(after("missing.apt").exit_status, 3);
  EXPECT_EQ(after("op10.apt,tools=missing.json").exit_status, 3);
  EXPECT_EQ(after("op10.apt,place=0,0").exit_status, 2);
  EXPECT_EQ(after(",tools=tools.json").exit_status, 2);
  const Outcome undefined = after("op10.apt,tools=other.json");
  EXPECT_EQ(undefined.exit_status, 3);
  EXPECT_NE(undefined.err.find("[no-tool]"), std::string::npos) << undefined.err;
  EXPECT_EQ(run_again({"--before", "op10.apt"}).exit_status, 2);
  EXPECT_EQ(run_again({"--stock", "part+5", "--before", "op10.apt", "--json", "op10.apt"}).exit_status, 2);
  // Half a program ends without its end mark. What it would have cut further is not known.
  write_text(sample_.path + "/half.apt", slot_program(false).substr(0, slot_program(false).size() - 12));
  const Outcome half = after("half.apt");
  EXPECT_NE(half.exit_status, 0) << half.out;
  // Where the motion depends on the machine, the program cannot be placed elsewhere.
  const Outcome placed = run_again({"--stock", "part+5", "--before", "op10.apt,place=0,0,1", "--rapid", "dogleg"});
  EXPECT_EQ(placed.exit_status, 3);
  EXPECT_NE(placed.err.find("[before-place]"), std::string::npos) << placed.err;
}

TEST_F(StockSample, AToolThatDoesNotCutMeetsTheMaterial) {
  ASSERT_EQ(run("rapid_stock", {}).exit_status, 0);
  write_text(
      sample_.path + "/probe.json",
      R"({"units":"mm","tools":[{"number":1,"cuts":false,"cutter":{"shape":"flat","diameter":10,"length":25}}]})");
  write_text(sample_.path + "/op10.apt", slot_program(false));
  const Outcome ran = run_gougecheck(
      sample_.path, {"check", "op10.apt", "--part", "part.stl", "--tools", "probe.json", "--stock", "part+5"});
  EXPECT_EQ(ran.exit_status, 1) << ran.err;
  EXPECT_NE(ran.out.find("cutter in stock: "), std::string::npos) << ran.out;
}

TEST_F(StockSample, MovesWithSeveralPermittedMotionsAreExamined) {
  ASSERT_LE(run("pole_crossing", {}).exit_status, 1);
  const auto examined = [&](const std::string& law) {
    EXPECT_NE(run_again({"--stock", "box=5", "--machine", "preset:linuxcnc-xyzac-trt", "--feed-law", law, "--json",
                         "check.json"})
                  .exit_status,
              0);
    return json_of("check.json").at("stock").at("examined").get<int>();
  };
  for (const char* law : {"axis", "documented"}) EXPECT_EQ(examined(law), 2) << law;
}

TEST_F(StockSample, AProjectFileNamesEarlierPrograms) {
  ASSERT_EQ(run("rapid_stock", {}).exit_status, 0);
  write_text(sample_.path + "/op10.apt", slot_program(false));
  const Outcome ran = run_script(sample_.path,
                                 "mkdir sub && cp rapid_stock.apt sub/ && cd sub && echo '{\"part\": \"part.stl\", "
                                 "\"tools\": \"tools.json\", \"stock\": \"part+5\", \"before\": "
                                 "[\"op10.apt,tools=tools.json\"]}' > ../gougecheck.json && "
                                 "\"$GOUGECHECK\" check rapid_stock.apt");
  EXPECT_EQ(ran.exit_status, 0) << ran.err << ran.out;
}

TEST_F(StockSample, AProjectFileNamesTheStock) {
  ASSERT_EQ(run("rapid_stock", {}).exit_status, 0);
  write_text(sample_.path + "/gougecheck.json", R"({"part": "part.stl", "tools": "tools.json", "stock": "part+5"})");
  EXPECT_EQ(run_gougecheck(sample_.path, {"check", sample_.toolpath()}).exit_status, 1);
  write_text(sample_.path + "/gougecheck.json", R"({"part": "part.stl", "tools": "tools.json", "stock": "part.stl"})");
  EXPECT_EQ(run_gougecheck(sample_.path, {"check", sample_.toolpath()}).exit_status, 0);
}

TEST_F(StockSample, APartNamedLikeAShapeIsFoundBesideItsProjectFile) {
  ASSERT_EQ(run("rapid_stock", {}).exit_status, 0);
  const Outcome ran = run_script(sample_.path,
                                 "cp part.stl part+x.stl && mkdir sub && cp rapid_stock.apt sub/ && cd sub && echo "
                                 "'{\"part\": \"part+x.stl\", \"tools\": \"tools.json\", \"stock\": \"part+5\"}' > "
                                 "../gougecheck.json && \"$GOUGECHECK\" check rapid_stock.apt");
  EXPECT_EQ(ran.exit_status, 1) << ran.err;
}

TEST_F(StockSample, TheMeshesOfWhatIsLeftAreSoundAndStockOfTheNextSetUp) {
  const std::vector<std::string> writing{"--stock",       "box=5",    "--stock-cell", "1.5",
                                         "--write-stock", "left.stl", "--json",       "check.json"};
  ASSERT_EQ(run("rapid_stock", writing).exit_status, 1);
  const Json left = json_of("check.json").at("stock").at("left");
  EXPECT_GE(left.at("perhaps_mm3").get<double>(), left.at("surely_mm3").get<double>());
  EXPECT_LE(left.at("cell").get<double>(), 1.5);
  EXPECT_GT(left.at("apart").get<double>(), 4);  // the rapid went through 5 mm of material
  for (const std::string mesh : {"left.stl", "left.surely.stl"}) {
    EXPECT_EQ(run_gougecheck(sample_.path, {"mesh", mesh, "--json", "mesh.json"}).exit_status, 0) << mesh;
    EXPECT_NEAR(json_of("mesh.json").at("mesh").at("volume").get<double>(),
                left.at(mesh == "left.stl" ? "perhaps_mm3" : "surely_mm3").get<double>(), 1)
        << mesh;
  }
  const Outcome again = run_again({"--stock", "left.stl"});
  EXPECT_EQ(again.exit_status, 1) << again.out;
  EXPECT_NE(again.out.find("stock: 6 of 7 moves"), std::string::npos) << again.out;
  // Meshes have the place of the part: written and read with the same place, they give the same volume.
  ASSERT_EQ(run_again({"--stock", "box=5", "--stock-cell", "1.5", "--write-stock", "placed.stl", "--place", "1,2,3",
                       "--json", "placed.json"})
                .exit_status,
            1);
  ASSERT_EQ(run_again({"--stock", "placed.stl", "--place", "1,2,3", "--stock-cell", "1.5", "--write-stock",
                       "second.stl", "--json", "second.json"})
                .exit_status,
            1);
  const Json placed = json_of("placed.json").at("stock").at("left"),
             second = json_of("second.json").at("stock").at("left");
  EXPECT_GE(second.at("perhaps_mm3").get<double>(), placed.at("perhaps_mm3").get<double>());
  EXPECT_LT(second.at("perhaps_mm3").get<double>(), placed.at("perhaps_mm3").get<double>() * 1.02);
}

TEST_F(StockSample, TheMeshesAreTheSameAtAnyNumberOfThreads) {
  ASSERT_EQ(run("holder_stock", {"--stock", "box", "--threads", "1", "--write-stock", "one.stl"}).exit_status, 1);
  ASSERT_EQ(run_again({"--stock", "box", "--threads", "3", "--write-stock", "three.stl"}).exit_status, 1);
  EXPECT_EQ(text_of(sample_.path + "/one.stl"), text_of(sample_.path + "/three.stl"));
  EXPECT_EQ(text_of(sample_.path + "/one.surely.stl"), text_of(sample_.path + "/three.surely.stl"));
}

TEST_F(StockSample, WrongFilesAndCellsOfTheMeshesAreRefused) {
  ASSERT_EQ(run("rapid_stock", {}).exit_status, 0);
  write_text(sample_.path + "/raw.surely.stl", text_of(sample_.path + "/part.stl"));
  for (const std::vector<std::string>& more : std::vector<std::vector<std::string>>{
           {"--write-stock", "left.stl"},
           {"--stock", "box", "--write-stock", "-"},
           {"--stock", "box", "--write-stock", "left.obj"},
           {"--stock", "box", "--write-stock", ".stl"},
           {"--stock", "box", "--write-stock", "part.stl"},
           {"--stock", "raw.surely.stl", "--write-stock", "raw.stl"},
           {"--stock", "box", "--write-stock", "left.stl", "--json", "left.surely.stl"},
           {"--stock", "box", "--stock-cell", "0.01", "--write-stock", "left.stl"},
           {"--stock", "box", "--stock-cell", "x"}}) {
    const Outcome ran = run_again(more);
    EXPECT_EQ(ran.exit_status, 2) << more.back() << ": " << ran.err;
  }
  const Outcome fine = run_again(
      {"--stock", "box", "--stock-resolution", "0.001", "--stock-cell", "0.002", "--write-stock", "left.stl"});
  EXPECT_EQ(fine.exit_status, 3);
  EXPECT_NE(fine.err.find("[stock-cells-too-many]"), std::string::npos) << fine.err;
  EXPECT_EQ(text_of(sample_.path + "/left.stl"), "");
  write_text(sample_.path + "/gougecheck.json",
             R"({"part": "part.stl", "tools": "tools.json", "stock": "box", "write-stock": "left.stl"})");
  const Outcome project = run_gougecheck(sample_.path, {"check", sample_.toolpath()});
  EXPECT_NE(project.err.find("[project-option]"), std::string::npos) << project.err;
}

TEST_F(StockSample, OfStockThatIsCutAwayNoMeshIsWritten) {
  ASSERT_EQ(run("rapid_stock", {}).exit_status, 0);
  write_text(
      sample_.path + "/tiny.stl",
      "solid t\nfacet normal 0 0 -1\nouter loop\nvertex 30 9 -4\nvertex 30 11 -4\nvertex 32 9 -4\nendloop\nendfacet\n"
      "facet normal 0 -1 0\nouter loop\nvertex 30 9 -4\nvertex 32 9 -4\nvertex 30 9 -2\nendloop\nendfacet\n"
      "facet normal -1 0 0\nouter loop\nvertex 30 9 -4\nvertex 30 9 -2\nvertex 30 11 -4\nendloop\nendfacet\n"
      "facet normal 1 1 1\nouter loop\nvertex 32 9 -4\nvertex 30 11 -4\nvertex 30 9 -2\nendloop\nendfacet\n"
      "endsolid t\n");
  const Outcome ran = run_again({"--stock", "tiny.stl", "--assume", "stock", "--write-stock", "left.stl", "-v"});
  EXPECT_EQ(ran.exit_status, 0) << ran.err;
  EXPECT_NE(ran.err.find("[stock-nothing-left]"), std::string::npos) << ran.err;
  EXPECT_NE(ran.out.find("nothing is left of the stock"), std::string::npos) << ran.out;
  EXPECT_EQ(text_of(sample_.path + "/left.stl"), "");
}

TEST_F(StockSample, ARapidStraightUpFromAnOwnCutIsClear) {
  ASSERT_EQ(run("rapid_stock", {}).exit_status, 0);
  write_text(sample_.path + "/block.stl", box_stl({0, 0, -20}, {80, 60, 0}));
  write_text(sample_.path + "/ball.json", R"({"units": "mm", "tools": [{"number": 1, "name": "ball",
      "cutter": {"shape": "ball", "diameter": 10, "length": 30}}]})");
  write_text(sample_.path + "/up.apt",
             "UNITS/MM\nMULTAX/ON\nLOADTL/1\nRAPID\nGOTO/30,30,30\nFEDRAT/800\nGOTO/30,30,0\nGOTO/60,30,0\nRAPID\n"
             "GOTO/60,30,30\nRAPID\nGOTO/60,30,0\nFINI\n");
  const Outcome ran = run_gougecheck(
      sample_.path, {"check", "up.apt", "--part", "block.stl", "--tools", "ball.json", "--stock", "box=2"});
  EXPECT_EQ(ran.exit_status, 0) << ran.out << ran.err;
}

}  // namespace
}  // namespace gouge::testing_samples::stock_test
