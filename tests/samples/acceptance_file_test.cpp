#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/samples/small_shop.h"

// `gougecheck accept FILE` for a file of accepted findings: its entries are listed and withdrawn.

namespace gouge::testing_samples::acceptance_file_test {
namespace {

using Words = std::vector<std::string>;

class AcceptanceFile : public testing::Test {
 protected:
  Outcome accept(const std::string& findings) {
    return shop_.run({"accept", "a.json", "--finding", findings, "--reason", "stock allowance", "--by", "R. Miller",
                      "--date", "2026-11-23", "-o", "accepted.json"});
  }

  SmallShop shop_;
};

TEST_F(AcceptanceFile, EntriesAreListedAndWithdrawn) {
  ASSERT_EQ(shop_.check("a", path_text(stations({{30, -0.2}, {70, -0.1}}))).exit_status, 1);
  ASSERT_EQ(accept("1-2").exit_status, 0);
  const nlohmann::json before = shop_.json("accepted.json");
  const Outcome listed = shop_.run({"accept", "accepted.json"});
  EXPECT_EQ(listed.exit_status, 0) << listed.err;
  EXPECT_NE(listed.out.find("1  path.apt:"), std::string::npos) << listed.out;
  EXPECT_NE(listed.out.find("; accepted by R. Miller on 2026-11-23: stock allowance\n2  path.apt:"), std::string::npos)
      << listed.out;
  EXPECT_NE(listed.out.find("\naccepted.json has 2 accepted findings\n"), std::string::npos) << listed.out;
  const Outcome ran = shop_.run({"accept", "accepted.json", "--withdraw", "1"});
  EXPECT_EQ(ran.exit_status, 0) << ran.err;
  EXPECT_TRUE(ran.out.starts_with("withdrawn: path.apt:")) << ran.out;
  EXPECT_TRUE(ran.out.ends_with("\naccepted.json has 1 accepted finding\n")) << ran.out;
  EXPECT_EQ(shop_.json("accepted.json").at("accepted"), nlohmann::json::array({before.at("accepted").at(1)}));
  EXPECT_EQ(
      shop_.check("b", path_text(stations({{30, -0.2}, {70, -0.1}})), {"--baseline", "accepted.json"}).exit_status, 1)
      << "one gouge is not accepted any more";
}

TEST_F(AcceptanceFile, WithdrawsOnlyEntriesThatAreThere) {
  ASSERT_EQ(shop_.check("a", path_text(stations({{40, -0.2}, {50, -0.2}}))).exit_status, 1);
  ASSERT_EQ(accept("1").exit_status, 0);
  const std::string before = shop_.read("accepted.json");
  const auto refused = [&](const Words& words, int status, const std::string& why) {
    const Outcome ran = shop_.run(words);
    EXPECT_EQ(ran.exit_status, status) << ran.err;
    EXPECT_NE(ran.err.find(why), std::string::npos) << ran.err;
    EXPECT_EQ(shop_.read("accepted.json"), before);
  };
  refused({"accept", "accepted.json", "--withdraw", "2"}, 2, "which has 1 accepted finding;");
  refused({"accept", "accepted.json", "--withdraw", "0"}, 2, "--withdraw '0'");
  refused({"accept", "accepted.json", "--withdraw", "1,1"}, 2, "names entry 1 twice");
  refused({"accept", "accepted.json", "--withdraw", "op:1"}, 2, "expected the number of an entry");
  refused({"accept", "accepted.json", "--withdraw", "1", "--all"}, 2, "expected that file and no --finding");
  refused({"accept", "a.json", "--withdraw", "1"}, 3, "[accepted-format]");
  refused({"accept", "none.json", "--withdraw", "1"}, 3, "none.json");
}

TEST_F(AcceptanceFile, ANewerVersionOfTheFormatIsNamed) {
  ASSERT_EQ(shop_.check("a", path_text(stations({{40, -0.2}}))).exit_status, 1);
  ASSERT_EQ(accept("1").exit_status, 0);
  std::string text = shop_.read("accepted.json");
  const std::string version = "\"format_version\": 1";
  ASSERT_NE(text.find(version), std::string::npos);
  shop_.write("accepted.json", text.replace(text.find(version), version.size(), "\"format_version\": 2"));
  const Outcome ran = shop_.check("b", path_text(stations({{40, -0.2}})), {"--baseline", "accepted.json"});
  EXPECT_EQ(ran.exit_status, 3);
  EXPECT_NE(ran.err.find("accepted.json:3: error: this file of accepted findings is of another version of the format; "
                         "expected format_version 1"),
            std::string::npos)
      << ran.err;
}

TEST_F(AcceptanceFile, NumbersOfFindingsMayHaveBlanks) {
  ASSERT_EQ(shop_.check("a", path_text(stations({{30, -0.2}, {70, -0.1}}))).exit_status, 1);
  EXPECT_EQ(accept("1, 2").exit_status, 0);
  EXPECT_EQ(shop_.json("accepted.json").at("accepted").size(), 2U);
}

// The name and the reason of a person stand at the line that the person accepted.
TEST_F(AcceptanceFile, AnAcceptanceCountsInItsLineIfItsMotionIsRepeated) {
  std::vector<Station> twice = stations({{40, -0.2}});
  const std::vector<Station> again = twice;
  twice.insert(twice.end(), again.begin(), again.end());
  const std::string path = path_text(twice);
  ASSERT_EQ(shop_.check("a", path).exit_status, 1);
  for (const char* number : {"1", "2"}) {
    (void)shop_.run_script("rm -f accepted.json");
    ASSERT_EQ(accept(number).exit_status, 0);
    const auto line = shop_.json("accepted.json").at("accepted").at(0).at("line");
    EXPECT_EQ(shop_.check("b", path, {"--baseline", "accepted.json"}).exit_status, 1);
    std::size_t accepted = 0;
    const nlohmann::json checked = shop_.json("b.json");
    for (const auto& event : checked.at("events")) {
      if (!event.at("acceptance").at("is_accepted")) continue;
      ++accepted;
      EXPECT_EQ(event.at("line"), line) << number;
    }
    EXPECT_EQ(accepted, 1U);
  }
  ASSERT_EQ(accept("1").exit_status, 0);
  EXPECT_EQ(shop_.check("b", path, {"--baseline", "accepted.json"}).exit_status, 0);
}

TEST_F(AcceptanceFile, FindingsWithEqualMotionsAreNotCalledAcceptedBefore) {
  shop_.write("part.stl", plate_stl());
  const std::string deep = path_text(stations({{40, -0.2}}));
  for (const char* name : {"one.apt", "two.apt"}) shop_.write(name, deep);
  shop_.write("bad.apt", "no path");
  ASSERT_EQ(
      shop_.run({"batch", "one.apt", "two.apt", "bad.apt", "--part", "part.stl", "-o", "night", "-q"}).exit_status, 3);
  const Words note = {"--reason", "r", "--by", "b", "-o", "accepted.json"};
  for (Words words :
       {Words{"accept", "night", "--finding", "one:1", "--finding", "two:1"}, Words{"accept", "night", "--all"}}) {
    (void)shop_.run_script("rm -f accepted.json");
    words.insert(words.end(), note.begin(), note.end());
    const Outcome ran = shop_.run(words);
    EXPECT_EQ(ran.exit_status, 0) << ran.err;
    EXPECT_NE(ran.out.find("\n1 finding has the motions of these, so the new entries accept it too\n"),
              std::string::npos)
        << ran.out;
    EXPECT_EQ(ran.out.find("before"), std::string::npos) << ran.out;
    EXPECT_EQ(ran.err.find("job bad (failed) has no result") != std::string::npos, words.at(2) == "--all") << ran.err;
  }
  EXPECT_NE(shop_.run({"accept", "night", "--all", "--reason", "r", "--by", "b", "-o", "accepted.json"})
                .out.find("2 findings accepted before\n"),
            std::string::npos);
}

/// Two paths that share the motion down at x = 40. The second one gouges in two further motions of the same finding.
struct SharedMotion {
  std::string one = path_text(stations({{40, -0.2}}));
  std::string two = path_text(stations({{40, -0.2}, {50, -0.35}}));
};

TEST_F(AcceptanceFile, FindingsOfTwoProgramsThatShareAMotionAreBothAccepted) {
  shop_.write("part.stl", plate_stl());
  shop_.write("one.apt", SharedMotion().one);
  shop_.write("two.apt", SharedMotion().two);
  const auto check = [&](const std::string& name, const Words& more) {
    Words words = {"check", name + ".apt", "--part", "part.stl", "--json", name + ".json"};
    words.insert(words.end(), more.begin(), more.end());
    return shop_.run(words);
  };
  const auto accepted = [&](Words words) {
    const Words note = {"--reason", "r", "--by", "b", "-o", "accepted.json"};
    words.insert(words.begin(), "accept");
    words.insert(words.end(), note.begin(), note.end());
    return shop_.run(words);
  };
  ASSERT_EQ(check("one", {}).exit_status, 1);
  ASSERT_EQ(check("two", {}).exit_status, 1);
  for (const Words& second : {Words{"two.json", "--all"}, Words{"two.json", "--finding", "1"}}) {
    (void)shop_.run_script("rm -f accepted.json");
    ASSERT_EQ(accepted({"one.json", "--all"}).exit_status, 0);
    const Outcome part = check("two", {"--baseline", "accepted.json"});
    EXPECT_EQ(part.exit_status, 1);
    EXPECT_NE(part.out.find("0 void, 1 in part\n"), std::string::npos) << part.out;
    EXPECT_NE(part.out.find("\nin part: one.apt:"), std::string::npos) << part.out;
    EXPECT_NE(part.out.find(": it accepts 1 of 3 moves of the gouge in line "), std::string::npos) << part.out;
    EXPECT_EQ(shop_.json("two.json").at("baseline").at("entries").at(0).at("use"), "partly");
    ASSERT_EQ(check("two", {}).exit_status, 1);
    const Outcome ran = accepted(second);
    EXPECT_EQ(ran.exit_status, 0) << ran.err;
    EXPECT_TRUE(ran.out.starts_with("accepted: two.apt:")) << ran.out;
    EXPECT_TRUE(ran.out.ends_with("\naccepted.json has 2 accepted findings\n")) << ran.out;
    EXPECT_EQ(check("one", {"--baseline", "accepted.json"}).exit_status, 0);
    EXPECT_EQ(check("two", {"--baseline", "accepted.json"}).exit_status, 0);
    EXPECT_EQ(accepted({"two.json", "--all"}).out,
              "1 finding accepted before\naccepted.json has 2 accepted findings\n");
    EXPECT_NE(accepted({"two.json", "--finding", "1"}).err.find("[accept-twice]"), std::string::npos);
  }
}

TEST_F(AcceptanceFile, FindingsOfABatchThatShareAMotionAreAllAccepted) {
  shop_.write("part.stl", plate_stl());
  shop_.write("one.apt", SharedMotion().one);
  shop_.write("two.apt", SharedMotion().two);
  const Words batch = {"batch", "one.apt", "two.apt", "--part", "part.stl", "-o", "night", "-q"};
  ASSERT_EQ(shop_.run(batch).exit_status, 1);
  const Outcome ran = shop_.run({"accept", "night", "--all", "--reason", "r", "--by", "b", "-o", "accepted.json"});
  EXPECT_EQ(ran.exit_status, 0) << ran.err;
  EXPECT_EQ(ran.out.find("too"), std::string::npos) << ran.out;
  Words again = batch;
  again.insert(again.end(), {"--baseline", "accepted.json"});
  EXPECT_EQ(shop_.run(again).exit_status, 0);
}

}  // namespace
}  // namespace gouge::testing_samples::acceptance_file_test
