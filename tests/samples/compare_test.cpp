#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/samples/small_shop.h"

// `gougecheck compare` as a person would judge it. Each expectation was written down before the program was run.

namespace gouge::testing_samples::compare_test {
namespace {

const std::vector<Station> kTwoDeep = {{40, -0.2}, {50, -0.2}};

class Compare : public testing::Test {
 protected:
  Outcome compare(const std::string& before, const std::string& after, const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments = {"compare", before + ".json", after + ".json", "--json", "changes.json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    Outcome ran = shop_.run(arguments);
    if (ran.exit_status == 0 || ran.exit_status == 1 || ran.exit_status == 4)
      counts_ = shop_.json("changes.json").at("counts");
    return ran;
  }
  /// "new 1, same 2", in the order of the counts; what is 0 is left out.
  [[nodiscard]] std::string counts() const {
    std::string text;
    for (const char* name : {"new", "deeper", "not-checked-any-more", "gone", "shallower", "same"}) {
      const int count = counts_.at(name);
      if (count > 0) text += (text.empty() ? "" : ", ") + std::string(name) + " " + std::to_string(count);
    }
    return text;
  }

  /// Reason of the first finding.
  [[nodiscard]] std::string why() const { return shop_.json("changes.json").at("findings").at(0).at("why"); }

  SmallShop shop_;
  nlohmann::json counts_;
};

TEST_F(Compare, TheSameRunTwiceIsTheSame) {
  ASSERT_EQ(shop_.check("a", path_text(stations(kTwoDeep))).exit_status, 1);
  shop_.check("b", path_text(stations(kTwoDeep)), {"--threads", "3"});
  const Outcome ran = compare("a", "b", {"-v"});
  EXPECT_EQ(ran.exit_status, 0) << ran.err;
  EXPECT_EQ(counts(), "same 1");
  EXPECT_EQ(ran.out.find("note:"), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("path.apt:13: same: 0.200 mm cutter T1 at ("), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find(
                "\na.json -> b.json\nno worse: 0 new, 0 deeper, 0 not checked any more, 0 gone, 0 shallower, 1 same\n"),
            std::string::npos)
      << ran.out;
}

TEST_F(Compare, NotesThatFindingsAreNotAcceptedAnyMore) {
  const std::string path = path_text(stations(kTwoDeep));
  shop_.check("a", path);
  ASSERT_EQ(shop_.run({"accept", "a.json", "--all", "--reason", "r", "--by", "b", "-o", "accepted.json"}).exit_status,
            0);
  ASSERT_EQ(shop_.check("b", path, {"--baseline", "accepted.json"}).exit_status, 0);
  const Outcome ran = compare("b", "a");
  EXPECT_EQ(ran.exit_status, 0) << "the gouges are the same";
  EXPECT_NE(ran.out.find("note: 0 of the findings accepted, 1 before"), std::string::npos) << ran.out;
}

TEST_F(Compare, WhatCorrectFreedIsGone) {
  shop_.check("a", path_text(stations(kTwoDeep)));
  const Outcome corrected =
      shop_.run({"correct", "path.apt", "--part", "part.stl", "-o", "fixed.apt", "--json", "b.json"});
  ASSERT_EQ(corrected.exit_status, 0) << corrected.out << corrected.err;
  EXPECT_EQ(compare("a", "b").exit_status, 0);
  EXPECT_EQ(counts(), "gone 1");
  EXPECT_EQ(compare("b", "a").exit_status, 1);
  EXPECT_EQ(counts(), "new 1");
}

TEST_F(Compare, LinesInsertedBeforeChangeNothing) {
  shop_.check("a", path_text(stations(kTwoDeep)));
  const std::string head = std::string(kHead) + "PPRINT/MORE\nRAPID\nGOTO/0,0,50\nGOTO/10,0,50\nGOTO/0,0,50\n";
  shop_.check("b", path_text(stations(kTwoDeep), head));
  EXPECT_EQ(compare("a", "b").exit_status, 0);
  EXPECT_EQ(counts(), "same 1");
}

TEST_F(Compare, AnotherTessellationIsTheSamePartToItsChordError) {
  shop_.write("fine.stl", plate_stl(7));
  shop_.write("above.stl", plate_stl(5, 0.004));
  shop_.check("a", path_text(stations(kTwoDeep)));
  shop_.check("b", path_text(stations(kTwoDeep)), {"--part", "fine.stl"});
  const Outcome fine = compare("a", "b");
  EXPECT_EQ(fine.exit_status, 0);
  EXPECT_EQ(counts(), "same 1");
  EXPECT_NE(fine.out.find("note: the parts are other files\n"), std::string::npos) << fine.out;
  shop_.check("c", path_text(stations(kTwoDeep)), {"--part", "above.stl"});
  EXPECT_EQ(compare("a", "c").exit_status, 1);
  EXPECT_EQ(counts(), "deeper 1");
  EXPECT_EQ(compare("a", "c", {"--same-within", "0.005"}).exit_status, 0);
  EXPECT_EQ(counts(), "same 1");
}

TEST_F(Compare, DeeperAndShallowerAreOfTheirDepth) {
  shop_.check("a", path_text(stations({{40, -0.2}})));
  shop_.check("b", path_text(stations({{40, -0.3}})));
  const Outcome deeper = compare("a", "b");
  EXPECT_EQ(deeper.exit_status, 1);
  EXPECT_EQ(counts(), "deeper 1");
  EXPECT_NE(deeper.out.find("deeper: 0.300 mm cutter T1"), std::string::npos) << deeper.out;
  EXPECT_NE(deeper.out.find("; 0.200 mm before"), std::string::npos) << deeper.out;
  EXPECT_EQ(why(), "line 13 is 0.300 mm deep, 0.200 mm before");
  EXPECT_EQ(compare("b", "a").exit_status, 0);
  EXPECT_EQ(counts(), "shallower 1");
  EXPECT_EQ(why(), "the depth is 0.200 mm, 0.300 mm before");
}

// The depth is at most the radius of the cutter, and the overcut grows with the plunge.
TEST_F(Compare, DeeperAndShallowerMayBeOfTheOvercutAlone) {
  shop_.check("a", path_text(stations({{40, -6}})));
  shop_.check("b", path_text(stations({{40, -7}})));
  const Outcome deeper = compare("a", "b", {"--html", "changes.html"});
  EXPECT_EQ(deeper.exit_status, 1);
  EXPECT_EQ(counts(), "deeper 1");
  EXPECT_EQ(why(), "in line 13 the overcut is 7.000 mm, 6.000 mm before");
  EXPECT_NE(deeper.out.find(why()), std::string::npos) << deeper.out;
  EXPECT_NE(shop_.read("changes.html").find(why()), std::string::npos);
  EXPECT_EQ(compare("b", "a").exit_status, 0);
  EXPECT_EQ(counts(), "shallower 1");
  EXPECT_EQ(why(), "the overcut is 6.000 mm, 7.000 mm before");
  EXPECT_EQ(compare("b", "a", {"--same-within", "2"}).exit_status, 0);
  EXPECT_EQ(counts(), "same 1");
}

// The middle is lifted out of the part, then it is back in it: one finding, two, one.
TEST_F(Compare, FindingsThatSplitAreNoWorseAndThoseThatMergeAre) {
  const std::vector<Station> deep = {{30, -0.2}, {40, -0.2}, {50, -0.2}, {60, -0.2}, {70, -0.2}, {80, -0.2}};
  std::vector<Station> lifted = deep;
  lifted[2].z = lifted[3].z = 1;
  shop_.check("one", path_text(stations(deep)));
  shop_.check("two", path_text(stations(lifted)));
  EXPECT_EQ(compare("one", "two").exit_status, 0);
  EXPECT_EQ(counts(), "same 2");
  const Outcome merged = compare("two", "one");
  EXPECT_EQ(merged.exit_status, 1);
  EXPECT_EQ(counts(), "deeper 1");
  EXPECT_NE(merged.out.find("more motions gouge than before; "), std::string::npos) << merged.out;
  EXPECT_EQ(merged.out.find("nothing gouged before"), std::string::npos) << merged.out;
}

// A point within a gouging straight move makes two motions of one. The old motion did gouge there.
TEST_F(Compare, AWiderFindingOfOtherMotionsIsNotSaidToBeWhereNothingGouged) {
  std::vector<Station> one = stations({{30, -0.1}, {70, -0.3}});
  one.erase(one.begin() + 3, one.begin() + 6);  // from x = 30 straight to x = 70
  std::vector<Station> denser = one;
  denser.insert(denser.begin() + 3, {50, -0.2});
  shop_.check("a", path_text(one));
  shop_.check("b", path_text(denser));
  EXPECT_EQ(compare("a", "b").exit_status, 1);
  EXPECT_EQ(counts(), "deeper 1");
  EXPECT_EQ(shop_.json("changes.json").at("findings").at(0).at("why"),
            "more motions gouge than before; 1 of them has its deepest point more than 1 mm from those before");
}

TEST_F(Compare, AMotionThatGougesAnewIsNamed) {
  shop_.check("a", path_text(stations(kTwoDeep)), {"--stock-to-leave", "0"});
  shop_.check("b", path_text(stations(kTwoDeep)), {"--stock-to-leave", "0.1"});
  EXPECT_EQ(compare("a", "b").exit_status, 1);
  const std::string changes = shop_.read("changes.json");
  EXPECT_NE(changes.find("motions gouge where nothing gouged before"), std::string::npos) << changes;
}

TEST_F(Compare, AnotherMotionAtTheSamePlaceIsNew) {
  shop_.check("a", path_text(stations(kTwoDeep)));
  std::vector<Station> twice = stations(kTwoDeep);
  twice.push_back({60, 0});
  twice.push_back({45, -0.1});
  shop_.check("b", path_text(twice));
  EXPECT_EQ(compare("a", "b").exit_status, 1);
  EXPECT_EQ(counts(), "new 1, same 1");
}

TEST_F(Compare, AnotherToolIsSaidAndAnotherNumberIsAnotherFinding) {
  shop_.check("a", path_text(stations(kTwoDeep)));
  shop_.check("b", path_text(stations(kTwoDeep), "PARTNO/SHOP\nUNITS/MM\nCUTTER/12\nLOADTL/1\n"));
  const Outcome wider = compare("a", "b");
  EXPECT_NE(wider.out.find("note: T1 has other dimensions\n"), std::string::npos) << wider.out;
  EXPECT_EQ(counts(), "same 1") << "the cutter is flat: as deep as before";
  EXPECT_EQ(wider.exit_status, 0);
  // Two tools without a number are no difference of a result from itself.
  shop_.check("two", "PARTNO/SHOP\nUNITS/MM\nCUTTER/10\nGOTO/0,0,50\nGOTO/20,0,50\nCUTTER/6\nGOTO/40,0,50\nFINI\n");
  EXPECT_EQ(compare("two", "two").out.find("other dimensions"), std::string::npos);
  shop_.check("c", path_text(stations(kTwoDeep), "PARTNO/SHOP\nUNITS/MM\nCUTTER/10\nLOADTL/2\n"));
  EXPECT_EQ(compare("a", "c").exit_status, 1);
  EXPECT_EQ(counts(), "new 1, gone 1");
}

TEST_F(Compare, WhatTheNewRunDidNotCheckIsNotGone) {
  const std::string path = path_text(stations(kTwoDeep));
  shop_.check("a", path);
  const auto is_open = [&](const std::string& why) {
    const Outcome ran = compare("a", "b");
    EXPECT_EQ(ran.exit_status, 4) << ran.out << ran.err;
    EXPECT_EQ(counts(), "not-checked-any-more 1");
    EXPECT_NE(ran.out.find(why), std::string::npos) << ran.out;
  };
  shop_.check("b", path, {"--tolerance", "0.25"});
  is_open("the tolerance is 0.25 mm, 0.01 mm before");
  std::vector<Station> first_three = stations();
  first_three.resize(3);
  shop_.check("b", path_text(first_three));
  is_open("its motion is not in the new path");
  shop_.check("b", "PARTNO/SHOP\nUNITS/MM\nCUTTER/10\nLOADTL/1\nGOTO/0,0,80\nGOTO/100,0,80\nFINI\n");
  is_open("no motion of the old one");
  const std::size_t at = path.find("GOTO/30.000000");
  shop_.check("b", path.substr(0, at) + "FROBNI/1\n" + path.substr(at));
  is_open("not checked: ");
}

TEST_F(Compare, OpenMovesOfTheNewRunAreSaidAndNeverClean) {
  const std::string path = path_text(stations());
  ASSERT_EQ(shop_.check("a", path).exit_status, 0);
  const std::size_t at = path.find("GOTO/80.000000");
  ASSERT_EQ(shop_.check("b", path.substr(0, at) + "FROBNI/1\n" + path.substr(at)).exit_status, 4);
  const Outcome ran = compare("a", "b");
  EXPECT_EQ(ran.exit_status, 4);
  EXPECT_NE(ran.out.find("no worse as far as it was checked: "), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("nothing is said of what may be new there"), std::string::npos) << ran.out;
}

TEST_F(Compare, ThePageAndItsOutputsAreThoseOfTheTable) {
  shop_.check("a", path_text(stations(kTwoDeep)));
  shop_.check("b", path_text(stations({{40, -0.3}})));
  EXPECT_EQ(compare("a", "b", {"--html", "changes.html", "-q"}).out, "");
  const std::string page = shop_.read("changes.html");
  EXPECT_NE(page.find("<h2>Deeper</h2>"), std::string::npos);
  EXPECT_NE(page.find("GOTO/40.000000,50,-0.300000"), std::string::npos) << "the statement is quoted";
  EXPECT_EQ(shop_.run({"compare", "a.json", "b.json", "--html", "a.json"}).exit_status, 2);
  const Outcome piped = shop_.run({"compare", "a.json", "b.json", "--json", "-"});
  EXPECT_EQ(nlohmann::json::parse(piped.out).at("exit_status"), 1);
}

TEST_F(Compare, TheFolderOfAReportIsItsResultAndStaysAsItIs) {
  shop_.check("a", path_text(stations(kTwoDeep)), {"--report", "rep"});
  shop_.check("b", path_text(stations({{40, -0.3}})));
  const std::string whole = shop_.read("rep/result.json");
  EXPECT_EQ(shop_.run({"compare", "rep", "b.json", "-q"}).exit_status, 1);
  for (const char* const option : {"--html", "--json"})
    EXPECT_EQ(shop_.run({"compare", "rep", "b.json", option, "rep/result.json"}).exit_status, 2);
  EXPECT_EQ(shop_.read("rep/result.json"), whole);
  const Outcome paths = shop_.run({"compare", "--paths", "path.apt", "path.apt", "--html", "p.html"});
  EXPECT_EQ(paths.exit_status, 2);
  EXPECT_NE(paths.err.find("--paths takes --json"), std::string::npos) << paths.err;
}

TEST_F(Compare, AFactThatIsNotEstablishedAnyMoreIsNeverNoWorse) {
  const std::string text = path_text(stations({{40, -0.2}}));
  ASSERT_EQ(shop_.check("a", text).exit_status, 1);
  ASSERT_EQ(shop_.check("b", text, {"--place", "0,0,-300"}).exit_status, 4);
  const Outcome ran = shop_.run({"compare", "a.json", "b.json", "--json", "c.json"});
  EXPECT_EQ(ran.exit_status, 4) << ran.out;
  EXPECT_NE(ran.out.find("note: not established any more: placement (contradicted): no move reaches the part"),
            std::string::npos)
      << ran.out;
  EXPECT_EQ(shop_.json("c.json").at("open_facts").size(), 1U);
  EXPECT_EQ(shop_.run({"compare", "b.json", "b.json"}).exit_status, 0) << "it was open before";
}

TEST_F(Compare, NamesTheOptionForToolpaths) {
  shop_.write("a.apt", path_text(stations()));
  const Outcome ran = shop_.run({"compare", "a.apt", "a.apt"});
  EXPECT_EQ(ran.exit_status, 3);
  EXPECT_NE(ran.err.find("a.apt: error: is a toolpath, not a result; two toolpaths are compared with --paths"),
            std::string::npos)
      << ran.err;
}

TEST_F(Compare, BatchesAreComparedJobByJob) {
  shop_.write("part.stl", plate_stl());
  const auto batch = [&](const char* folder, const std::vector<std::pair<std::string, std::string>>& paths) {
    std::vector<std::string> words = {"batch", "--part", "part.stl", "-q", "-o", folder};
    for (const auto& [name, text] : paths) {
      shop_.write(name + ".apt", text);
      words.push_back(name + ".apt");
    }
    (void)shop_.run(words);
  };
  const std::string deep = path_text(stations(kTwoDeep)), clean = path_text(stations());
  batch("old", {{"fixed", deep}, {"same", clean}, {"left_out", clean}, {"broken", deep}});
  batch("new", {{"fixed", clean}, {"same", clean}, {"added", deep}, {"broken", "no path"}});
  const Outcome text = shop_.run({"compare", "old", "new"});
  EXPECT_EQ(text.exit_status, 1) << "the added job gouges\n" << text.err;
  for (const char* line :
       {"job fixed: no worse: 0 new, 0 deeper, 0 not checked any more, 1 gone, 0 shallower, 0 same\n",
        "job same: no worse: 0 new", "job added: the old batch has no such job: gouges\n",
        "job broken: the new batch has no report of it: gouges, then failed\n",
        "job left_out: the new batch has no such job: clean\n",
        "old -> new\n5 jobs: 1 worse, 1 not compared, 1 only in the old batch, 1 better, 1 same\n"})
    EXPECT_NE(text.out.find(line), std::string::npos) << line << text.out;
  EXPECT_EQ(shop_.run({"compare", "old", "new", "--json", "c.json"}).exit_status, 1);
  const auto json = shop_.json("c.json");
  EXPECT_EQ(json["format"], "gougecheck-batch-comparison");
  EXPECT_EQ(json["jobs"][0]["comparison"]["counts"]["gone"], 1);
  EXPECT_EQ(json["jobs"][4]["exit_status"], 4);
  EXPECT_EQ(json["jobs"][4]["change"], "only-before");
  EXPECT_EQ(shop_.run({"compare", "old", "missing"}).exit_status, 3);
  EXPECT_EQ(shop_.run({"compare", "missing", "old"}).err,
            "missing: error: no such folder; expected that of another batch [file-not-found]\n");
  EXPECT_EQ(shop_.run({"compare", "new", "new"}).exit_status, 4) << "the broken job has no result";
  const std::string kept = shop_.read("old/reports/fixed/result.json");
  for (const std::vector<std::string>& wrong : {std::vector<std::string>{"compare", "old", "new/reports/fixed"},
                                                {"compare", "old", "new", "--html", "new/reports/fixed/report.html"},
                                                {"compare", "old", "new", "--json", "old/reports/fixed/result.json"}})
    EXPECT_EQ(shop_.run(wrong).exit_status, 2) << wrong.back();
  EXPECT_EQ(shop_.read("old/reports/fixed/result.json"), kept);
  EXPECT_NE(shop_.run({"compare", "old", "new/reports/fixed"})
                .err.find("old is the folder of a batch, but new/reports/fixed is the report of one job"),
            std::string::npos);
  (void)shop_.run_script("rm new/summary.json");
  EXPECT_NE(
      shop_.run({"compare", "old", "new"}).err.find("but new is the folder of a batch that was interrupted; finish"),
      std::string::npos);
}

TEST_F(Compare, ThePageOfTwoBatchesListsTheJobsAndLeadsToTheirReports) {
  shop_.write("part.stl", plate_stl());
  const std::string deep = path_text(stations(kTwoDeep)), clean = path_text(stations());
  const auto batch = [&](const std::string& folder, const std::vector<std::pair<std::string, std::string>>& paths) {
    std::vector<std::string> words = {"batch", "--part", "part.stl", "-q", "-o", folder};
    for (const auto& [name, text] : paths) {
      shop_.write(name + ".apt", text);
      words.push_back(name + ".apt");
    }
    (void)shop_.run(words);
  };
  batch("old", {{"fixed", deep}, {"same", clean}, {"left_out", clean}, {"broken", deep}, {"deeper", deep}});
  batch("new", {{"fixed", clean},
                {"same", clean},
                {"added", clean},
                {"bad", deep},
                {"broken", "no path"},
                {"deeper", path_text(stations({{40, -0.3}, {50, -0.2}}))}});
  (void)shop_.run_script("mkdir pages");
  EXPECT_EQ(shop_.run({"compare", "old", "new", "-q", "--html", "pages/c.html", "--json", "c.json"}).exit_status, 1);
  const std::string page = shop_.read("pages/c.html");
  const auto row_of = [&](const std::string& job) {
    for (std::size_t at = page.find("<tr><td>"); at != std::string::npos; at = page.find("<tr><td>", at + 1)) {
      std::string row = page.substr(at, page.find("</tr>", at) - at);
      if (row.find(">" + job + "<") != std::string::npos) return row;
    }
    return std::string();
  };
  for (const auto& [job, change] :
       {std::pair("bad", "Worse"), std::pair("deeper", "Worse"), std::pair("broken", "Not compared"),
        std::pair("left_out", "Only in the old batch"), std::pair("added", "Only in the new batch"),
        std::pair("fixed", "Better"), std::pair("same", "Same")})
    EXPECT_NE(row_of(job).find(std::string(">") + change + "</span>"), std::string::npos) << job << page;
  EXPECT_NE(row_of("deeper").find("<td class=\"n none\">0</td><td class=\"n bad\">1</td>"), std::string::npos);
  EXPECT_NE(row_of("fixed").find("<a href=\"../old/reports/fixed/report.html\">gouges</a>, then "
                                 "<a href=\"../new/reports/fixed/report.html\">clean</a>"),
            std::string::npos)
      << row_of("fixed");
  EXPECT_NE(page.find("<a href=\"../old/index.html\">old</a>, then"), std::string::npos);
  EXPECT_NE(
      page.find(
          "<strong>Worse</strong><div>7 jobs: 2 worse, 1 not compared, 1 only in the old batch, 1 only in the new batch, 1 better, 1 same<"),
      std::string::npos);
  EXPECT_LT(page.find(">bad<"), page.find(">broken<")) << "the worst first";
  const std::string kept = shop_.read("new/index.html");
  EXPECT_EQ(shop_.run({"compare", "old", "new", "--html", "new/index.html"}).exit_status, 2);
  EXPECT_EQ(shop_.read("new/index.html"), kept);
}

TEST_F(Compare, AResultThatIsNotAsItWasWrittenIsRefused) {
  shop_.check("a", path_text(stations(kTwoDeep)));
  const std::string whole = shop_.read("a.json");
  const auto refused = [&](const std::string& text) {
    shop_.write("b.json", text);
    const Outcome ran = compare("a", "b");
    EXPECT_EQ(ran.exit_status, 3) << ran.out;
    EXPECT_EQ(ran.out, "");
    return ran.err;
  };
  std::string edited = whole;
  edited.replace(edited.find("\"depth\": 0.2"), 12, "\"depth\": 0.1");
  EXPECT_NE(refused(edited).find("[result-edited]"), std::string::npos);
  std::string old = whole.substr(0, whole.rfind(",\n \"digest\"")) + "\n}\n";
  EXPECT_NE(refused(old).find("[result-format]"), std::string::npos);
  EXPECT_NE(refused(whole.substr(0, whole.size() / 2)).find("[result-syntax]"), std::string::npos);
  edited = whole;
  edited.replace(edited.find("\"depth\": 0.2"), 12, "\"depth\": NaN");
  EXPECT_NE(refused(edited).find("[result-syntax]"), std::string::npos);
  EXPECT_NE(refused("{\"format\": \"other\"}").find("[result-format]"), std::string::npos);
  EXPECT_NE(refused("").find("[result-syntax]"), std::string::npos);
}

}  // namespace
}  // namespace gouge::testing_samples::compare_test
