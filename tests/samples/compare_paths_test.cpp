#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/samples/small_shop.h"

// `gougecheck compare --paths` as a person would judge it.

namespace gouge::testing_samples::compare_paths_test {
namespace {

/// The head of a program, and a plunge.
const std::string kProgramHead =
    "%\nO1\nG21 G17 G90 G40 G80 G94\nT1 M6\nG54\nG0 X10. Y10.\nG43 H1 Z40.\nG1 Z1. F500.\n";

class ComparePaths : public testing::Test {
 protected:
  [[nodiscard]] Outcome compare(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments = {"compare", "--paths"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return shop_.run(arguments);
  }
  static void expect_text(const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  }

  SmallShop shop_;
};

TEST_F(ComparePaths, ReadingsOfAPathAreComparedAsJson) {
  const std::string feeds = "UNITS/MM\nGOTO/0,0,0\nFEDRAT/100,MMPM\nGOTO/1,0,0\nFEDRAT/200,MMPM\nGOTO/2,0,0\nFINI\n";
  shop_.write("a.apt", feeds);
  std::string faster = feeds;
  faster.replace(faster.find("200"), 3, "220");
  shop_.write("b.apt", faster);
  const Outcome ran = shop_.run({"compare", "--paths", "a.apt", "b.apt", "--json", "-"});
  EXPECT_EQ(ran.exit_status, 0) << ran.err;
  const auto json = nlohmann::json::parse(ran.out);
  EXPECT_EQ(json["format"], "gougecheck-path-comparison");
  EXPECT_EQ(json["before_against_after"]["tip"]["mm"], 0);
  EXPECT_EQ(json["before_against_after"]["other_feed_rates"],
            nlohmann::json({{"count", 1}, {"line", 6}, {"nearest_line", 6}}));
  EXPECT_EQ(json["before_against_after"]["feed_rates_not_compared"], nlohmann::json({{"count", 0}}));
  const Outcome text = shop_.run({"compare", "--paths", "a.apt", "b.apt"});
  EXPECT_NE(text.out.find("1, first feed 200 mm/min at a.apt:6, nearest b.apt:6: feed 220 mm/min"), std::string::npos)
      << text.out;
  EXPECT_TRUE(text.out.ends_with("same: no tip or axis differs by more than 0.001 mm; 1 feed rate differs\n"))
      << text.out;
  EXPECT_EQ(shop_.run({"compare", "--paths", "a.apt", "b.apt", "--json", "a.apt"}).exit_status, 2);
  EXPECT_EQ(shop_.read("a.apt"), feeds);
}

TEST_F(ComparePaths, AFeedInPlaceOfALostRetractIsADifference) {
  const std::string head = "UNITS/MM\nGOTO/0,0,0\nGOTO/10,0,0\n", tail = "GOTO/50,0,0\nGOTO/60,0,0\nFINI\n";
  shop_.write("a.apt", head + "RAPID\nGOTO/10,0,40\nRAPID\nGOTO/50,0,40\n" + tail);
  shop_.write("b.apt", head + tail);
  const Outcome ran = compare({"a.apt", "b.apt"});
  EXPECT_EQ(ran.exit_status, 1) << ran.err;
  expect_text(ran.out, " mm on the way to the position at b.apt:4, nearest a.apt:");
}

// A helix of 5 turns passes the beginning, the middle and the end of one of 1 turn.
TEST_F(ComparePaths, AHelixOfMoreTurnsIsADifference) {
  const auto helix = [](const std::string& turns) {
    return kProgramHead + "G3 X10. Y10. Z-19. I5. J0. P" + turns + "\nM30\n%\n";
  };
  shop_.write("one.nc", helix("1"));
  shop_.write("five.nc", helix("5"));
  const std::vector<std::string> exact_stop = {"--control", "linuxcnc", "--start", "G61"};
  const auto against = [&](const std::string& other) {
    std::vector<std::string> arguments = {"one.nc", other};
    arguments.insert(arguments.end(), exact_stop.begin(), exact_stop.end());
    return compare(arguments);
  };
  const Outcome same = against("one.nc"), differs = against("five.nc");
  EXPECT_EQ(same.exit_status, 0) << same.out << same.err;
  EXPECT_EQ(differs.exit_status, 1) << differs.out << differs.err;
}

TEST_F(ComparePaths, FeedRatesThatAreNotKnownAreNamed) {
  shop_.write("a.apt", "UNITS/MM\nGOTO/0,0,0\nFEDRAT/100,MMPM\nGOTO/1,0,0\nGOTO/2,0,0\nFINI\n");
  shop_.write("b.apt", "UNITS/MM\nGOTO/0,0,0\nGOTO/1,0,0\nGOTO/2,0,0\nFINI\n");
  const Outcome ran = shop_.run({"compare", "--paths", "a.apt", "b.apt"});
  EXPECT_EQ(ran.exit_status, 0) << ran.err;
  EXPECT_NE(ran.out.find("  feed rates not compared         2, first feed 100 mm/min at a.apt:4, nearest b.apt:3: not "
                         "known\n"),
            std::string::npos)
      << ran.out;
}

TEST_F(ComparePaths, AReadingInAnotherUnitOrPlaceIsExplained) {
  const auto write = [&](const char* name, const std::string& unit, const std::string& z) {
    shop_.write(name, "UNITS/" + unit + "\nFEDRAT/100,MMPM\nGOTO/0,0," + z + "\nGOTO/10,0," + z + "\nGOTO/10,7," + z +
                          "\nGOTO/3,2," + z + "\nFINI\n");
  };
  write("mm.apt", "MM", "1");
  write("inch.apt", "INCHES", "1");
  write("higher.apt", "MM", "1.5");
  const Outcome unit = shop_.run({"compare", "--paths", "inch.apt", "mm.apt", "--json", "c.json"});
  EXPECT_EQ(unit.exit_status, 1);
  expect_text(unit.out,
              "OLD is NEW times 25.4: inch.apt:1 states inches (UNITS/INCHES), mm.apt:1 states mm (UNITS/MM); one of "
              "the files was written in a wrong unit\n");
  EXPECT_EQ(unit.out.find("--path-units"), std::string::npos) << unit.out;
  EXPECT_EQ(shop_.json("c.json").at("relation").at("factor"), 1 / 25.4);
  const Outcome place = shop_.run({"compare", "--paths", "mm.apt", "higher.apt"});
  EXPECT_NE(place.out.find("NEW is OLD shifted by (0, 0, 0.5) mm"), std::string::npos) << place.out;
}

TEST_F(ComparePaths, AUnitOfTheCommandLineIsAdvisedForFilesThatStateNone) {
  const std::string positions = "GOTO/0,0,1\nGOTO/10,0,1\nGOTO/10,7,1\nGOTO/3,2,1\nFINI\n";
  shop_.write("none.apt", positions);
  shop_.write("inch.apt", "UNITS/INCHES\n" + positions);
  expect_text(
      compare({"none.apt", "inch.apt"}).out,
      "NEW is OLD times 25.4: inch.apt:1 states inches (UNITS/INCHES), and OLD states no unit (--path-units)\n");
  expect_text(compare({"inch.apt", "none.apt"}).out, "and NEW states no unit (--new-path-units)\n");
  expect_text(compare({"none.apt", "none.apt", "--new-path-units", "inch"}).out,
              "NEW is OLD times 25.4: one is read in a wrong unit (--path-units, --new-path-units)\n");
  const Outcome both = compare({"none.apt", "inch.apt", "--path-units", "mm"});
  EXPECT_EQ(both.exit_status, 3);
  expect_text(both.err, "inch.apt:1: error: the file states inches");
  expect_text(both.err, "it is given for both files: give --new-path-units with the unit of this one too");
  EXPECT_EQ(compare({"none.apt", "inch.apt", "--path-units", "inch"}).exit_status, 0);
  const Outcome alone = compare({"none.apt", "inch.apt", "--new-path-units", "mm"});
  EXPECT_EQ(alone.exit_status, 3);
  expect_text(alone.err, "expected --new-path-units only for files that state none");
}

TEST_F(ComparePaths, AUnitOfTheCommandLineDoesNotContradictAProgram) {
  shop_.write("a.apt", "UNITS/MM\nGOTO/10,10,40\nGOTO/10,10,1\nFINI\n");
  shop_.write("a.nc", kProgramHead + "M30\n%\n");
  const Outcome ran =
      compare({"a.apt", "a.nc", "--new-control", "fanuc", "--new-offset", "G54=0,0,0", "--new-path-units", "inch"});
  EXPECT_EQ(ran.exit_status, 3);
  expect_text(ran.err,
              "a.nc:3: error: the program states mm (G21), the command line another unit; expected "
              "--new-path-units only for files that state none [path-unit]");
}

/// A plunge, a cut and a retract; `before_cut` and `before_retract` may make rapids of the last two.
std::string cut_text(const std::string& before_cut, const std::string& before_retract, const char* unit = "MM") {
  return std::string("PARTNO/T\nUNITS/") + unit + "\nLOADTL/1\nRAPID\nGOTO/10,10,40\nFEDRAT/500,MMPM\nGOTO/10,10,1\n" +
         before_cut + "GOTO/30,10,0\n" + before_retract + "GOTO/30,10,40\nFINI\n";
}

TEST_F(ComparePaths, AFeedThatBecameARapidIsADifferenceOfItsOwn) {
  for (const char* unit : {"MM", "INCHES"}) {
    shop_.write("a.apt", cut_text("", "", unit));
    shop_.write("b.apt", cut_text("", "RAPID\n", unit));
    const Outcome ran = compare({"a.apt", "b.apt", "--json", "c.json"});
    EXPECT_EQ(ran.exit_status, 1) << ran.err;
    expect_text(ran.out,
                "  feeds that are rapids in NEW    1, first: a feed in OLD at line 9 is a rapid in NEW at line 10; it "
                "is a retract along the tool axis\n");
    expect_text(ran.out, "differs: 1 feed of one toolpath is a rapid in the other; no tip or axis differs");
    const auto json = shop_.json("c.json");
    EXPECT_EQ(json["before_against_after"]["rapids_in_other"],
              nlohmann::json({{"count", 1}, {"retracts", 1}, {"line", 9}, {"nearest_line", 10}}));
    EXPECT_EQ(json["after_against_before"]["rapids_in_other"], nlohmann::json({{"count", 0}, {"retracts", 0}}));
    EXPECT_LT(json["before_against_after"]["tip"]["mm"].get<double>(), 1e-9);
    expect_text(compare({"b.apt", "a.apt"}).out, "a feed in NEW at line 9 is a rapid in OLD at line 10");
  }
}

TEST_F(ComparePaths, ACutThatBecameARapidIsFoundBetweenFeeds) {
  shop_.write("a.apt", cut_text("", ""));
  shop_.write("b.apt", cut_text("RAPID\n", "FEDRAT/500,MMPM\n"));
  const Outcome ran = compare({"a.apt", "b.apt"});
  EXPECT_EQ(ran.exit_status, 1) << ran.err;
  expect_text(ran.out, "1, first: a feed in OLD at line 8 is a rapid in NEW at line 9\n");
}

TEST_F(ComparePaths, AProgramWithARapidInPlaceOfAFeedDiffers) {
  shop_.write("a.apt", cut_text("", "RAPID\n"));
  shop_.write("same.nc", kProgramHead + "G1 X30. Z0.\nG0 Z40.\nM30\n%\n");
  shop_.write("other.nc", kProgramHead + "G0 X30. Z0.\nG0 Z40.\nM30\n%\n");
  const auto ran = [&](const std::string& program) {
    return compare({"a.apt", program, "--control", "haas", "--joint-rapid-law", "joint"});
  };
  EXPECT_EQ(ran("same.nc").exit_status, 0) << ran("same.nc").out << ran("same.nc").err;
  const Outcome other = ran("other.nc");
  EXPECT_EQ(other.exit_status, 1);
  expect_text(other.out, "a feed in OLD at line 8 is a rapid in NEW at line 9\n");
}

TEST_F(ComparePaths, MovesThatAreNotComparedAreNamedForEachFile) {
  shop_.write("a.apt", cut_text("", ""));
  shop_.write("b.apt", cut_text("", "FROBNI/1\n"));
  const Outcome ran = compare({"a.apt", "b.apt", "--json", "c.json"});
  expect_text(ran.out, "rapids in OLD                     1, first a.apt:5: only feeds are compared\n");
  expect_text(ran.out, "moves not checked in NEW          ");
  const auto json = shop_.json("c.json");
  EXPECT_EQ(json["left_out_before"],
            nlohmann::json({{"not_checked", {{"count", 0}}}, {"rapids", {{"count", 1}, {"line", 5}}}}));
  const auto unchecked = json["left_out_after"]["not_checked"];
  EXPECT_EQ(unchecked["count"], json["not_compared"]);
  expect_text(ran.out,
              "first b.apt:" + unchecked["line"].dump() + ": " + unchecked["reason"].get<std::string>() + "\n");
}

TEST_F(ComparePaths, TheFileWithoutFeedsIsNamedWithItsReason) {
  shop_.write("a.apt", cut_text("", ""));
  shop_.write("rapids.apt", "UNITS/MM\nRAPID\nGOTO/1,2,3\nRAPID\nGOTO/3,3,3\nFINI\n");
  for (const auto& [one, other] : {std::pair("a.apt", "rapids.apt"), std::pair("rapids.apt", "a.apt")}) {
    const Outcome ran = compare({one, other});
    EXPECT_EQ(ran.exit_status, 3);
    EXPECT_EQ(ran.err,
              "rapids.apt: error: holds no feed that is checked, so nothing can be compared: all its moves are rapids "
              "[path-no-motion]\n");
  }
  shop_.write("turned.nc",
              "%\nO1\nG21 G17 G90 G40 G80 G94\nT1 M6\nG54\nG0 B0. C0.\nG43 H1 Z100.\nG0 X5. Y5. Z100.\n"
              "G1 X20. Y3. Z20. B15. F500.\nM30\n%\n");
  const Outcome ran = compare({"a.apt", "turned.nc", "--machine", "preset:haas-umc750", "--joint-rapid-law", "joint",
                               "--rotary-turns", "as-programmed"});
  EXPECT_EQ(ran.exit_status, 3);
  expect_text(ran.err,
              "turned.nc:9: error: holds no feed that is checked, so nothing can be compared; the first reason: ");
  expect_text(ran.err, "expected --joint-point B=X,Y,Z [path-no-motion]\n");
}

// The ends of both arcs are the same, so only positions within them differ.
TEST_F(ComparePaths, AnArcOfTheOtherSenseDiffers) {
  const auto write = [&](const char* name, const std::string& block) {
    shop_.write(name, kProgramHead + block + "\nG1 Y30.\nG0 Z40.\nM30\n%\n");
  };
  write("arc.nc", "G2 X30. Y10. I10. J0.");
  write("other.nc", "G3 X30. Y10. I10. J0.");
  write("halves.nc", "G2 X20. Y20. I10. J0.\nG2 X30. Y10. I0. J-10.");
  write("line.nc", "G1 X30.");
  const auto status = [&](const char* file) {
    return compare({"arc.nc", file, "--control", "fanuc", "--joint-rapid-law", "joint"}).exit_status;
  };
  EXPECT_EQ(status("arc.nc"), 0);
  EXPECT_EQ(status("halves.nc"), 0);
  EXPECT_EQ(status("other.nc"), 1);
  EXPECT_EQ(status("line.nc"), 1);
}

TEST_F(ComparePaths, FactsOfNewAloneHaveAPrefix) {
  shop_.write("f.nc", kProgramHead + "G1 X30. Z0.\nG0 Z40.\nM30\n%\n");
  shop_.write("h.h",
              "0 BEGIN PGM T MM\n1 TOOL CALL 1 Z S1000\n2 L X+10 Y+10 R0 FMAX\n3 L Z+40 R0 FMAX\n4 L Z+1 R0 F500\n"
              "5 L X+30 Z+0 R0 F500\n6 L Z+40 R0 FMAX\n7 M30\n8 END PGM T MM\n");
  const std::vector<std::string> files = {"f.nc", "h.h", "--control", "fanuc", "--joint-rapid-law", "joint"};
  const auto with = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all = files;
    all.insert(all.end(), more.begin(), more.end());
    return compare(all);
  };
  EXPECT_EQ(with({"--new-control", "heidenhain"}).exit_status, 0) << with({"--new-control", "heidenhain"}).err;
  expect_text(with({}).err, "expected --new-control heidenhain");
  const Outcome wrong = with({"--new-control", "heidenhain", "--new-offset", "G54"});
  EXPECT_EQ(wrong.exit_status, 2);
  expect_text(wrong.err, "error: --new-offset 'G54': expected");
  // A start block of Fanuc is no fact of the Heidenhain program.
  EXPECT_EQ(with({"--start", "G90", "--new-control", "heidenhain"}).exit_status, 0);
  EXPECT_EQ(
      compare({"h.h", "f.nc", "--control", "heidenhain", "--new-control", "haas", "--new-joint-rapid-law", "joint"})
          .exit_status,
      0);
}

TEST_F(ComparePaths, OptionsOfToolpathsNeedPaths) {
  for (const char* option : {"--control", "--new-control"}) {
    const Outcome ran = shop_.run({"compare", "a.json", "b.json", option, "haas"});
    EXPECT_EQ(ran.exit_status, 2);
    expect_text(ran.err, std::string(option) + " requires --paths");
  }
}

TEST_F(ComparePaths, PassesInAnotherOrderDiffer) {
  const auto write = [&](const char* name, const std::vector<int>& places) {
    std::string text = "PARTNO/T\nUNITS/MM\n";
    for (const int y : places) {
      const std::string at = "," + std::to_string(y) + ",";
      text += "RAPID\nGOTO/0" + at + "20\nFEDRAT/500,MMPM\nGOTO/0" + at + "0\nGOTO/20" + at + "1\nRAPID\nGOTO/20" + at +
              "20\n";
    }
    shop_.write(name, text + "FINI\n");
  };
  write("a.apt", {0, 2, 4});
  write("b.apt", {0, 4, 2});
  const Outcome ran = compare({"a.apt", "b.apt", "--json", "c.json"});
  EXPECT_EQ(ran.exit_status, 1);
  expect_text(ran.out, "order                             differs from line 13 of OLD and line 13 of NEW on\n");
  expect_text(ran.out, "differs: the order of positions; no tip or axis differs by more than 0.001 mm\n");
  EXPECT_EQ(shop_.json("c.json")["order"],
            nlohmann::json({{"positions", 6}, {"is_same", false}, {"line", 13}, {"nearest_line", 13}}));
  const Outcome same = compare({"a.apt", "a.apt"});
  EXPECT_EQ(same.exit_status, 0);
  expect_text(same.out, "order                             the same at 6 positions that each file reaches once\n");
}

}  // namespace
}  // namespace gouge::testing_samples::compare_paths_test
