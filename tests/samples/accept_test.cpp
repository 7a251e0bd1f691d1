#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/samples/small_shop.h"

// `gougecheck accept` and `check --baseline`: what is accepted is distinguished, and every way in which an acceptance could
// hide another gouge. Each expectation was written down before the program was run.

namespace gouge::testing_samples::accept_test {
namespace {

using Words = std::vector<std::string>;

const std::vector<Station> kDeep = {{40, -0.2}, {50, -0.2}};

class Accept : public testing::Test {
 protected:
  Outcome accept(const std::string& result, const std::string& number, const Words& more = {}) {
    Words words = {"accept", result,      "--finding", number,       "--reason", "stock allowance",
                   "--by",   "R. Miller", "--date",    "2026-11-23", "-o",       "accepted.json"};
    words.insert(words.end(), more.begin(), more.end());
    return shop_.run(words);
  }
  /// The gouge of kDeep, found and accepted.
  void accept_deep() {
    ASSERT_EQ(shop_.check("a", path_text(stations(kDeep))).exit_status, 1);
    const Outcome ran = accept("a.json", "1");
    ASSERT_EQ(ran.exit_status, 0) << ran.err;
  }
  Outcome check(const std::string& text, Words more = {}) {
    more.insert(more.end(), {"--baseline", "accepted.json"});
    return shop_.check("b", text, more);
  }
  /// That nothing of it is accepted, and why.
  void expect_refused(const Outcome& ran, const std::string& why) {
    EXPECT_EQ(ran.exit_status, 1) << ran.out << ran.err;
    EXPECT_EQ(ran.out.find("accepted gouge"), std::string::npos) << ran.out;
    EXPECT_NE(ran.out.find(why), std::string::npos) << ran.out;
    EXPECT_EQ(shop_.json("b.json").at("verdict"), "gouges");
  }

  SmallShop shop_;
};

TEST_F(Accept, AnAcceptedGougeIsCountedApartAndNeverClean) {
  accept_deep();
  const Outcome ran = check(path_text(stations(kDeep)), {"--sarif", "b.sarif", "--junit", "b.xml", "--report", "out"});
  EXPECT_EQ(ran.exit_status, 0) << ran.out << ran.err;
  EXPECT_NE(ran.out.find("path.apt:13: accepted gouge: 0.200 mm cutter T1 at ("), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("\n  accepted by R. Miller on 2026-11-23: stock allowance\n"), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("\n1 accepted gouge: no other gouge in 13 moves, the deepest 0.200 mm at line 13\n"),
            std::string::npos)
      << ran.out;
  EXPECT_NE(ran.out.find("\nacceptances of accepted.json: 1 applied, 0 with nothing left to accept, 0 void\n"),
            std::string::npos)
      << ran.out;
  EXPECT_EQ(ran.out.find("\nclean"), std::string::npos);
  const nlohmann::json json = shop_.json("b.json");
  EXPECT_EQ(json.at("verdict"), "accepted-gouges");
  EXPECT_EQ(json.at("exit_status"), 0);
  EXPECT_EQ(json.at("baseline").at("accepted_findings"), 1);
  EXPECT_EQ(json.at("events").at(0).at("acceptance").at("is_accepted"), true);
  EXPECT_GT(json.at("totals").at("gouge"), 0) << "what it is it stays";
  const nlohmann::json found = shop_.json("b.sarif").at("runs").at(0).at("results").at(0);
  EXPECT_EQ(found.at("baselineState"), "unchanged");
  EXPECT_EQ(found.at("suppressions").at(0).at("status"), "accepted");
  EXPECT_EQ(found.at("suppressions").at(0).at("kind"), "external");
  const std::string junit = shop_.read("b.xml");
  EXPECT_NE(junit.find("failures=\"0\""), std::string::npos) << junit;
  EXPECT_NE(junit.find("accepted gouge: 0.200 mm"), std::string::npos) << junit;
  const std::string page = shop_.read("out/report.html");
  EXPECT_NE(page.find("<strong>1 accepted gouge</strong>"), std::string::npos);
  EXPECT_NE(page.find("R. Miller"), std::string::npos);
  EXPECT_EQ(page.find("banner clean"), std::string::npos);
}

TEST_F(Accept, WithoutABaselineNothingChanges) {
  accept_deep();
  EXPECT_EQ(shop_.check("b", path_text(stations(kDeep)), {"--sarif", "b.sarif"}).exit_status, 1);
  EXPECT_FALSE(shop_.json("b.sarif").at("runs").at(0).at("results").at(0).contains("baselineState"));
  EXPECT_TRUE(shop_.json("b.json").at("baseline").is_null());
}

TEST_F(Accept, LinesInsertedBeforeDoNotVoidIt) {
  accept_deep();
  const std::string head = std::string(kHead) + "PPRINT/MORE\nRAPID\nGOTO/0,0,50\nGOTO/10,0,50\n";
  EXPECT_EQ(check(path_text(stations(kDeep), head)).exit_status, 0);
}

TEST_F(Accept, AGougeElsewhereStaysOne) {
  accept_deep();
  const Outcome ran = check(path_text(stations({{40, -0.2}, {50, -0.2}, {80, -0.1}})), {"--sarif", "b.sarif"});
  EXPECT_EQ(ran.exit_status, 1);
  EXPECT_NE(ran.out.find("; 1 of these findings accepted"), std::string::npos) << ran.out;
  const nlohmann::json results = shop_.json("b.sarif").at("runs").at(0).at("results");
  EXPECT_EQ(results.at(0).at("baselineState"), "unchanged");
  EXPECT_EQ(results.at(1).at("baselineState"), "new");
  EXPECT_EQ(results.at(1).at("suppressions"), nlohmann::json::array());
}

TEST_F(Accept, WiderDeeperOrMovedIsNotAccepted) {
  accept_deep();
  expect_refused(check(path_text(stations({{40, -0.2}, {50, -0.2}, {60, -0.1}}))), "not accepted: ");
  expect_refused(check(path_text(stations({{40, -0.3}, {50, -0.2}}))), "not accepted: ");
  expect_refused(check(path_text(stations({{40, -0.3}, {50, -0.3}}))), "gouges: ");
  expect_refused(check(path_text(stations({{60, -0.2}, {70, -0.2}}))), "gouges: ");
}

// Each of the two halves is made of accepted motions alone, and so is the whole where both are accepted.
TEST_F(Accept, WhatSplitsOrMergesIsAcceptedOnlyWhereEveryMotionIs) {
  const std::vector<Station> wide = {{20, -0.2}, {30, -0.2}, {40, -0.2}, {50, -0.2}, {60, -0.2}, {70, -0.2}};
  std::vector<Station> apart = wide;
  apart[2].z = apart[3].z = 1;
  ASSERT_EQ(shop_.check("two", path_text(stations(apart))).exit_status, 1);
  ASSERT_EQ(accept("two.json", "1").exit_status, 0);
  EXPECT_EQ(check(path_text(stations(apart))).exit_status, 1) << "one of two";
  ASSERT_EQ(accept("two.json", "2").exit_status, 0);
  EXPECT_EQ(check(path_text(stations(apart))).exit_status, 0);
  expect_refused(check(path_text(stations(wide))), "not accepted: ");
}

TEST_F(Accept, TheSameMotionMayNotGougeMoreOften) {
  accept_deep();
  std::vector<Station> twice = stations(kDeep);
  const std::vector<Station> again = {{30, 1}, {30, 0}, {40, -0.2}, {50, -0.2}, {60, 0}};
  twice.insert(twice.end(), again.begin(), again.end());
  const Outcome ran = check(path_text(twice));
  EXPECT_EQ(ran.exit_status, 1);
  EXPECT_NE(ran.out.find("gouges more often than was accepted"), std::string::npos) << ran.out;
  // Nor by an acceptance that is there twice.
  const nlohmann::json once = shop_.json("accepted.json");
  nlohmann::json doubled = once;
  doubled["accepted"].push_back(once["accepted"][0]);
  shop_.write("accepted.json", doubled.dump());
  const Outcome refused = check(path_text(twice));
  EXPECT_EQ(refused.exit_status, 3);
  EXPECT_NE(refused.err.find("[accepted-edited]"), std::string::npos) << refused.err;
}

TEST_F(Accept, AnotherMotionAtTheSamePlaceIsAGougeOfItsOwn) {
  accept_deep();
  std::vector<Station> more = stations(kDeep);
  more.push_back({60, 0});
  more.push_back({45, -0.1});
  EXPECT_EQ(check(path_text(more)).exit_status, 1);
}

TEST_F(Accept, AChangedSetupVoidsItAndSaysWhat) {
  accept_deep();
  const std::string path = path_text(stations(kDeep));
  shop_.write("other.stl", plate_stl(3));
  expect_refused(check(path, {"--part", "other.stl"}), "void: path.apt:13: 0.200 mm cutter T1");
  expect_refused(check(path, {"--part", "other.stl"}), "the part is another one");
  expect_refused(check(path, {"--part", "part.stl", "--fixture", "part.stl"}), "the fixtures are others");
  expect_refused(check(path, {"--tolerance", "0.02"}), "the tolerance is 0.02 mm, 0.01 mm when it was accepted");
  expect_refused(check(path, {"--tolerance", "0.005"}), "the tolerance is 0.005 mm");
  expect_refused(check(path, {"--stock-to-leave", "0.01"}), "the stock to leave is 0.01 mm");
  expect_refused(check(path, {"--place", "0,0,0.001"}), "the STL files are placed elsewhere");
  expect_refused(check(path_text(stations(kDeep), "PARTNO/SHOP\nUNITS/MM\nCUTTER/12\nLOADTL/1\n")),
                 "T1 has other dimensions");
  EXPECT_EQ(check(path, {"--place", "0,0,0"}).exit_status, 0) << "where it was, in other words";
}

TEST_F(Accept, WhatIsNotCheckedCannotBeAcceptedAway) {
  accept_deep();
  const std::string path = path_text(stations(kDeep));
  const std::size_t at = path.find("GOTO/80.000000");
  const Outcome ran = check(path.substr(0, at) + "FROBNI/1\n" + path.substr(at));
  EXPECT_EQ(ran.exit_status, 4) << ran.out;
  EXPECT_NE(ran.out.find("not fully checked: no other gouge found"), std::string::npos) << ran.out;
  EXPECT_EQ(shop_.json("b.json").at("verdict"), "not-fully-checked");
}

TEST_F(Accept, AcceptedGougesThatAreGoneAreSaid) {
  accept_deep();
  const Outcome ran = check(path_text(stations()));
  EXPECT_EQ(ran.exit_status, 0);
  EXPECT_NE(ran.out.find("\nclean: "), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("0 applied, 1 with nothing left to accept, 0 void"), std::string::npos) << ran.out;
}

TEST_F(Accept, ABuriedToolCannotBeAccepted) {
  const Outcome found =
      shop_.check("a", "PARTNO/SHOP\nUNITS/MM\nCUTTER/2,0,0,0,0,0,5\nLOADTL/1\nGOTO/50,50,-12\nGOTO/60,50,-12\nFINI\n");
  ASSERT_EQ(found.exit_status, 1) << found.out;
  ASSERT_NE(found.out.find("buried"), std::string::npos) << found.out;
  const Outcome ran = accept("a.json", "1");
  EXPECT_EQ(ran.exit_status, 3);
  EXPECT_NE(ran.err.find("the tool is buried"), std::string::npos) << ran.err;
  EXPECT_NE(ran.err.find("[accept-impossible]"), std::string::npos) << ran.err;
}

TEST_F(Accept, TheFileLosesNothingAndTakesNothingTwice) {
  ASSERT_EQ(shop_.check("a", path_text(stations({{30, -0.2}, {70, -0.1}}))).exit_status, 1);
  ASSERT_EQ(accept("a.json", "1").exit_status, 0);
  const std::string before = shop_.read("accepted.json");
  const Outcome twice = accept("a.json", "1");
  EXPECT_EQ(twice.exit_status, 3);
  EXPECT_NE(twice.err.find("[accept-twice]"), std::string::npos) << twice.err;
  EXPECT_EQ(accept("a.json", "9").exit_status, 2);
  EXPECT_EQ(shop_.read("accepted.json"), before);
  ASSERT_EQ(accept("a.json", "2").exit_status, 0);
  EXPECT_EQ(shop_.json("accepted.json").at("accepted").size(), 2U);
  EXPECT_EQ(shop_.json("accepted.json").at("accepted").at(0), nlohmann::json::parse(before).at("accepted").at(0));
  shop_.write("notes.json", "{\"mine\": 1}\n");
  EXPECT_EQ(accept("a.json", "1", {"-o", "notes.json"}).exit_status, 2) << "-o twice";
  const Outcome foreign =
      shop_.run({"accept", "a.json", "--finding", "1", "--reason", "r", "--by", "b", "-o", "notes.json"});
  EXPECT_EQ(foreign.exit_status, 3);
  EXPECT_EQ(shop_.read("notes.json"), "{\"mine\": 1}\n");
  EXPECT_EQ(shop_.run({"accept", "a.json", "--finding", "1", "--reason", "r", "--by", "b", "-o", "a.json"}).exit_status,
            2);
}

TEST_F(Accept, NamesAreOneLine) {
  ASSERT_EQ(shop_.check("a", path_text(stations(kDeep))).exit_status, 1);
  const Outcome ran = shop_.run({"accept", "a.json", "--all", "--reason", "r", "--by", "R.\nMiller", "-o", "f.json"});
  EXPECT_EQ(ran.exit_status, 2);
  EXPECT_NE(ran.err.find("expected one line of text in UTF-8"), std::string::npos) << ran.err;
}

TEST_F(Accept, AddsToNoPipe) {
  ASSERT_EQ(shop_.check("a", path_text(stations(kDeep))).exit_status, 1);
  ASSERT_EQ(shop_.run_script("mkfifo accepted.json").exit_status, 0);
  const Outcome ran = accept("a.json", "1");
  EXPECT_EQ(ran.exit_status, 3);
  EXPECT_EQ(ran.err,
            "accepted.json: error: is a pipe; expected a file that accepted findings can be added to "
            "[accepted-format]\n");
}

TEST_F(Accept, OtherProgramsMaySaveTheFileWithAnotherNotationOfItsNumbers) {
  accept_deep();
  std::string text = shop_.read("accepted.json");
  for (const char* const key : {"stock_to_leave_mm", "shank_clearance_mm", "holder_clearance_mm"}) {
    const std::string whole = std::string("\"") + key + "\": 0";
    const std::size_t at = text.find(whole);
    ASSERT_NE(at, std::string::npos) << text;
    text.insert(at + whole.size(), ".0");
  }
  shop_.write("accepted.json", text);
  EXPECT_EQ(check(path_text(stations(kDeep))).exit_status, 0);
  shop_.write("accepted.json", nlohmann::json::parse(text).dump());
  EXPECT_EQ(check(path_text(stations(kDeep))).exit_status, 0) << "in one line, with its keys in another order";
}

TEST_F(Accept, NumbersEditedByHandAreRefused) {
  accept_deep();
  const std::string whole = shop_.read("accepted.json"), path = path_text(stations({{40, -0.5}, {50, -0.2}}));
  const auto refused = [&](const std::string& from, const std::string& to, const std::string& code) {
    std::string edited = whole;
    const std::size_t at = edited.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    edited.replace(at, from.size(), to);
    shop_.write("accepted.json", edited);
    const Outcome ran = check(path);
    EXPECT_EQ(ran.exit_status, 3) << ran.out;
    EXPECT_NE(ran.err.find(code), std::string::npos) << ran.err;
    EXPECT_EQ(accept("a.json", "1").exit_status, 3) << "nothing is added to it either";
  };
  refused("\"depth_upper_mm\": 0.2", "\"depth_upper_mm\": 9.2", "[accepted-edited]");
  refused("\"depth_upper_mm\": 0.2", "\"depth_upper_mm\": 1e999", "[accepted-syntax]");
  refused("\"depth_upper_mm\": 0.2", "\"depth_upper_mm\": NaN", "[accepted-syntax]");
  refused("\"depth_mm\": 0.2", "\"depth_mm\": -0.2", "[accepted-field]");
  refused("\"passes\": 1", "\"passes\": 7", "[accepted-edited]");
  refused("\"reason\": \"stock", "\"reason\": \"no stock", "[accepted-edited]");
  refused("\"seal\"", "\"deal\"", "[accepted-field]");
  refused("gougecheck-accepted", "gougecheck-rejected", "[accepted-format]");
}

TEST_F(Accept, OptionsAreAskedForByName) {
  ASSERT_EQ(shop_.check("a", path_text(stations(kDeep))).exit_status, 1);
  const auto error_of = [&](const Words& words) {
    const Outcome ran = shop_.run(words);
    EXPECT_EQ(ran.exit_status, 2);
    return ran.err;
  };
  EXPECT_NE(error_of({"accept", "a.json", "--finding", "1", "--by", "b", "-o", "f"}).find("needs --reason"),
            std::string::npos);
  EXPECT_NE(
      error_of({"accept", "a.json", "--finding", "1", "--reason", " ", "--by", "b", "-o", "f"}).find("needs --reason"),
      std::string::npos);
  EXPECT_NE(error_of({"accept", "a.json", "--finding", "1", "--reason", "r", "-o", "f"}).find("needs --reviewer"),
            std::string::npos);
  EXPECT_NE(error_of({"accept", "a.json", "--finding", "1", "--reason", "r", "--by", "b"}).find("needs -o"),
            std::string::npos);
  EXPECT_NE(error_of({"accept", "a.json", "--finding", "1", "--reason", "r", "--by", "b", "-o", "f", "--date", "today"})
                .find("a day like"),
            std::string::npos);
  EXPECT_NE(error_of({"accept", "a.json", "--reason", "r"}).find("needs --finding"), std::string::npos);
  for (const char* number : {"-1", "1.5", "99999999999999999999", "one", "3-1", "1-", "1-2-3", "0-99999999"})
    EXPECT_NE(error_of({"accept", "a.json", "--finding", number})
                  .find("--finding '" + std::string(number) + "': expected the number of a finding, or a range"),
              std::string::npos)
        << number;
  const Outcome listed = shop_.run({"accept", "a.json"});
  EXPECT_EQ(listed.exit_status, 0);
  EXPECT_NE(listed.out.find("1  path.apt:13: 0.200 mm cutter T1 at ("), std::string::npos) << listed.out;
}

TEST_F(Accept, AllFindingsAreAcceptedAtOnce) {
  const std::string text = path_text(stations({{40, -0.2}, {50, -0.2}, {60, 1}, {70, 1}, {80, -0.3}, {85, -0.3}}));
  ASSERT_EQ(shop_.check("a", text).exit_status, 1);
  const std::size_t count = shop_.json("a.json").at("events").size();
  ASSERT_GE(count, 2U);
  const Words words = {"accept", "a.json", "--all",      "--reason", "prototype",    "--by",
                       "R. M.",  "--date", "2026-11-23", "-o",       "accepted.json"};
  const Outcome ran = shop_.run(words);
  EXPECT_EQ(ran.exit_status, 0) << ran.out << ran.err;
  EXPECT_EQ(shop_.json("accepted.json").at("accepted").size(), count);
  const Outcome again = shop_.run(words);
  EXPECT_EQ(again.exit_status, 0) << again.err;
  EXPECT_EQ(again.out, std::to_string(count) + " findings accepted before\naccepted.json has " + std::to_string(count) +
                           " accepted findings\n");
  EXPECT_EQ(check(text).exit_status, 0);
}

TEST_F(Accept, ADateInTheFutureIsAWarning) {
  ASSERT_EQ(shop_.check("a", path_text(stations({{40, -0.2}, {50, -0.2}}))).exit_status, 1);
  const auto accepted_on = [&](const std::string& date, const std::string& file) {
    return shop_.run({"accept", "a.json", "--all", "--reason", "r", "--by", "b", "-o", file, "--date", date});
  };
  const Outcome early = accepted_on("2199-01-01", "early.json");
  EXPECT_EQ(early.exit_status, 0);
  EXPECT_NE(early.err.find("warning: --date 2199-01-01 is in the future; today is "), std::string::npos) << early.err;
  EXPECT_EQ(accepted_on("2001-01-01", "past.json").err, "");
}

TEST_F(Accept, AllOfACleanResultIsAnEmptyFile) {
  ASSERT_EQ(shop_.check("a", path_text(stations())).exit_status, 0);
  const Outcome ran = shop_.run({"accept", "a.json", "--all", "--reason", "r", "--by", "b", "-o", "accepted.json"});
  EXPECT_EQ(ran.exit_status, 0) << ran.err;
  EXPECT_EQ(ran.out, "nothing to accept\naccepted.json has 0 accepted findings\n");
  EXPECT_EQ(check(path_text(stations())).exit_status, 0);
}

TEST_F(Accept, SeveralNumbersMayStandInOneWord) {
  const std::string text = path_text(stations({{40, -0.2}, {50, -0.2}, {60, 1}, {70, 1}, {80, -0.3}, {85, -0.3}}));
  ASSERT_EQ(shop_.check("a", text).exit_status, 1);
  const Outcome ran = accept("a.json", "1,2");
  EXPECT_EQ(ran.exit_status, 0) << ran.err;
  EXPECT_EQ(shop_.json("accepted.json").at("accepted").size(), 2U);
}

TEST_F(Accept, AllGoesWithoutNumbersAndNumbersWithOneResult) {
  accept_deep();
  const Words note = {"--reason", "r", "--by", "b", "-o", "accepted.json"};
  const auto refused = [&](Words words) {
    words.insert(words.end(), note.begin(), note.end());
    const Outcome ran = shop_.run(words);
    EXPECT_EQ(ran.exit_status, 2) << ran.out;
    return ran.err;
  };
  EXPECT_NE(refused({"accept", "a.json", "--all", "--finding", "1"}).find("--all or --finding, and not both"),
            std::string::npos);
  EXPECT_NE(refused({"accept", "a.json", "a.json", "--finding", "1"}).find("--finding for one result"),
            std::string::npos);
}

TEST_F(Accept, AnEntryOfAnotherProgramIsNamed) {
  accept_deep();
  shop_.write("other.apt", path_text(stations(kDeep)));
  const Outcome ran = shop_.run({"check", "other.apt", "--part", "part.stl", "--baseline", "accepted.json"});
  EXPECT_EQ(ran.exit_status, 0) << ran.out << ran.err;
  EXPECT_NE(ran.out.find("accepted by R. Miller on 2026-11-23 through the entry of path.apt, line 13: stock allowance"),
            std::string::npos)
      << ran.out;
  EXPECT_NE(ran.out.find("0 void; 1 finding accepted through the entry of another program"), std::string::npos);
}

TEST_F(Accept, ABatchTakesABaselineAndSaysAccepted) {
  accept_deep();
  const Outcome ran =
      shop_.run({"batch", "path.apt", "--part", "part.stl", "--baseline", "accepted.json", "-o", "night"});
  EXPECT_EQ(ran.exit_status, 0) << ran.out << ran.err;
  EXPECT_NE(ran.out.find("accepted-gouges"), std::string::npos) << ran.out;
  EXPECT_EQ(ran.out.find("1 clean"), std::string::npos) << ran.out;
  EXPECT_EQ(shop_.json("night/findings.sarif").at("runs").at(0).at("results").at(0).at("baselineState"), "unchanged");
  const std::string page = shop_.read("night/index.html");
  EXPECT_NE(page.find("<strong>Accepted gouges</strong>"), std::string::npos);
  EXPECT_LT(page.find("<h2>Accepted findings</h2>"), page.find("; accepted by ")) << page;
  EXPECT_EQ(
      shop_.run({"check", "path.apt", "--part", "part.stl", "--baseline", "accepted.json", "--csv", "accepted.json"})
          .exit_status,
      2);
}

TEST_F(Accept, TheFolderOfABatchStandsForItsResults) {
  shop_.write("part.stl", plate_stl());
  shop_.write("one.apt", path_text(stations(kDeep)));
  shop_.write("two.apt", path_text(stations({{60, -0.3}, {70, -0.3}})));
  ASSERT_EQ(shop_.run({"batch", "one.apt", "two.apt", "--part", "part.stl", "-o", "night", "-q"}).exit_status, 1);
  const Words note = {"--reason", "r", "--by", "b", "-o", "accepted.json"};
  const auto accepted = [&](Words words) {
    words.insert(words.end(), note.begin(), note.end());
    return shop_.run(words);
  };
  const Outcome single = accepted({"accept", "night", "--finding", "1"});
  EXPECT_EQ(single.exit_status, 2);
  EXPECT_NE(single.err.find("--finding for one result"), std::string::npos) << single.err;
  EXPECT_EQ(accepted({"accept", "night", "--all"}).exit_status, 0);
  EXPECT_EQ(shop_.json("accepted.json").at("accepted").size(), 2U);
  const Outcome ran = shop_.run(
      {"batch", "one.apt", "two.apt", "--part", "part.stl", "--baseline", "accepted.json", "-o", "night", "-q"});
  EXPECT_EQ(ran.exit_status, 0) << ran.err;
}

TEST_F(Accept, FindingsOfOneJobOfABatchAreNamedByTheJob) {
  shop_.write("part.stl", plate_stl());
  const std::string deep = path_text(stations({{30, -0.2}, {60, -0.3}, {80, -0.1}}));
  shop_.write("one.apt", deep);
  shop_.write("two-3.apt", path_text(stations(kDeep)));
  ASSERT_EQ(shop_.run({"batch", "one.apt", "two-3.apt", "--part", "part.stl", "-o", "night", "-q"}).exit_status, 1);
  const Outcome listed = shop_.run({"accept", "night"});
  EXPECT_EQ(listed.out.find("one:1  one.apt:"), 0U) << listed.out;
  EXPECT_NE(listed.out.find("\ntwo-3:1  two-3.apt:"), std::string::npos) << listed.out;
  const auto accepted = [&](Words words) {
    const Words note = {"--reason", "r", "--by", "b", "-o", "accepted.json"};
    words.insert(words.begin(), {"accept", "night"});
    words.insert(words.end(), note.begin(), note.end());
    return shop_.run(words);
  };
  ASSERT_EQ(accepted({"--finding", "one:1-2", "--finding", "two-3:1"}).exit_status, 0);
  const auto entries = shop_.json("accepted.json").at("accepted");
  ASSERT_EQ(entries.size(), 3U);
  EXPECT_EQ(entries[0].at("toolpath"), "one.apt");
  EXPECT_EQ(entries[2].at("toolpath"), "two-3.apt");
  for (const auto& [finding, message] :
       {std::pair("three:1", "there is no result of a job 'three'"), {"1", "expected JOB:1 for a job of a batch"}}) {
    const Outcome ran = accepted({"--finding", finding});
    EXPECT_EQ(ran.exit_status, 2) << finding;
    EXPECT_NE(ran.err.find(message), std::string::npos) << ran.err;
  }
  for (const char* wrong : {"one:", ":1", "one:x", "one:3-1", "one:1,x", "one,two:1", "one:1,"})
    EXPECT_EQ(accepted({"--finding", wrong}).exit_status, 2) << wrong;
  EXPECT_EQ(accepted({"--finding", "one:9"}).exit_status, 2);
  const Outcome twice =
      shop_.run({"accept", "night", "night", "--finding", "one:3", "--reason", "r", "--by", "b", "-o", "c.json"});
  EXPECT_EQ(twice.exit_status, 2);
  EXPECT_NE(twice.err.find("there are several results of a job 'one'"), std::string::npos) << twice.err;
  EXPECT_EQ(shop_.json("accepted.json").at("accepted").size(), 3U);
}

TEST_F(Accept, TextThatIsNotUtf8IsRefused) {
  ASSERT_EQ(shop_.check("a", path_text(stations(kDeep))).exit_status, 1);
  const Outcome ran =
      shop_.run({"accept", "a.json", "--all", "--reason", "r", "--by", "M\xfcller", "-o", "accepted.json"});
  EXPECT_EQ(ran.exit_status, 2);
  EXPECT_NE(ran.err.find("--reviewer 'M\\xfcller': expected one line of text in UTF-8"), std::string::npos) << ran.err;
}

TEST_F(Accept, StandardOutputIsNoFileToAddTo) {
  ASSERT_EQ(shop_.check("a", path_text(stations(kDeep))).exit_status, 1);
  const Outcome ran = shop_.run({"accept", "a.json", "--all", "--reason", "r", "--by", "b", "-o", "-"});
  EXPECT_EQ(ran.exit_status, 2);
  EXPECT_NE(ran.err.find("-o - is not possible with accept, because it adds to a file"), std::string::npos) << ran.err;
}

TEST_F(Accept, EntriesOfOtherProgramsAreNoneThatAreVoid) {
  accept_deep();
  shop_.write("other.stl", plate_stl(2));
  shop_.write("other.apt", path_text(stations({{20, -0.1}, {30, -0.1}})));
  const Outcome ran = shop_.run({"check", "other.apt", "--part", "other.stl", "--baseline", "accepted.json"});
  EXPECT_NE(ran.out.find(
                "acceptances of accepted.json: 0 applied, 0 with nothing left to accept, 0 void, 1 of other programs"),
            std::string::npos)
      << ran.out << ran.err;
  EXPECT_EQ(ran.out.find("void: "), std::string::npos) << ran.out;
}

TEST_F(Accept, ANumberGivenTwiceIsRefused) {
  ASSERT_EQ(shop_.check("a", path_text(stations(kDeep))).exit_status, 1);
  const Outcome ran = accept("a.json", "1,1");
  EXPECT_EQ(ran.exit_status, 2);
  EXPECT_NE(ran.err.find("--finding names finding 1 twice"), std::string::npos) << ran.err;
}

TEST_F(Accept, WritesThroughALinkToANewFileAndIntoAnEmptyOne) {
  ASSERT_EQ(shop_.check("a", path_text(stations(kDeep))).exit_status, 1);
  ASSERT_EQ(shop_.run_script("mkdir kept; ln -s kept/new.json accepted.json").exit_status, 0);
  EXPECT_EQ(accept("a.json", "1").exit_status, 0);
  EXPECT_EQ(shop_.json("kept/new.json").at("accepted").size(), 1U);
  ASSERT_EQ(shop_.run_script("rm accepted.json; touch accepted.json").exit_status, 0);
  EXPECT_EQ(accept("a.json", "1").exit_status, 0);
  EXPECT_EQ(shop_.json("accepted.json").at("accepted").size(), 1U);
}

TEST_F(Accept, ARangeNamesEachOfItsFindings) {
  ASSERT_EQ(shop_.check("a", path_text(stations({{20, -0.1}, {50, -0.1}, {80, -0.1}}))).exit_status, 1);
  ASSERT_EQ(accept("a.json", "3,1-2").exit_status, 0);
  EXPECT_EQ(shop_.check("b", path_text(stations({{20, -0.1}, {50, -0.1}, {80, -0.1}})), {"--baseline", "accepted.json"})
                .exit_status,
            0);
  EXPECT_NE(accept("a.json", "2-3").err.find("accepted"), std::string::npos) << "the second has an entry";
}

}  // namespace
}  // namespace gouge::testing_samples::accept_test
