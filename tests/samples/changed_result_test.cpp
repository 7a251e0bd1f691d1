#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "tests/samples/box_stl.h"
#include "tests/samples/sealed_result.h"
#include "tests/samples/small_shop.h"

// Every value of a sound result is changed by itself and the result is sealed anew: `verify` must notice it.

namespace gouge::testing_samples::changed_result_test {
namespace {

using nlohmann::json;
using Pointer = json::json_pointer;

constexpr const char* kTools = R"({"units": "mm", "tools": [{"number": 1, "name": "mill",
  "cutter": {"shape": "flat", "diameter": 10, "length": 20},
  "shank": [{"lower_diameter": 10, "upper_diameter": 10, "length": 20}],
  "holder": [{"lower_diameter": 30, "upper_diameter": 40, "length": 30}]}]})";

/// Values that stand for each other where only words of a list are allowed.
const std::map<std::string, std::set<std::string>> kWordsOf = {
    {"state", {"near", "gouge", "buried", "not-certified"}},
    {"body", {"cutter", "shank", "holder"}},
    {"bodies", {"cutter", "shank", "holder"}},
    {"against", {"part", "fixture", "stock"}},
    {"kind", {"feed", "rapid"}},
    {"words_not_understood", {}},
};

class ChangedResult : public ::testing::Test {
 protected:
  /// Checks a path with gouges of the part and of a fixture, a near miss, a rapid and two operations.
  void check(const std::string& head, const std::vector<std::string>& more = {}) {
    shop_.write("tools.json", kTools);
    shop_.write("vise.stl", box_stl({20, 55.3, 0}, {31, 90, 8}));
    shop_.write("stop.stl", box_stl({62, 30, -0.5}, {66, 60, 0.4}));
    std::vector<std::string> arguments = {"--tools",  "tools.json",  "--fixture", "vise.stl", "--fixture",
                                          "stop.stl", "--near-miss", "0.5",       "-q"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome ran =
        shop_.check("result", path_text(stations({{40, -0.5}, {50, -0.5}, {90, -0.2}}), head), arguments);
    ASSERT_EQ(ran.exit_status, 1) << ran.err;
    whole_ = shop_.json("result.json");
    ASSERT_EQ(status_of(whole_), 0) << shop_.run({"verify", "changed.json"}).out;
  }

  [[nodiscard]] int status_of(const json& result) const {
    shop_.write("changed.json", sealed(result));
    return shop_.run({"verify", "changed.json", "-q"}).exit_status;
  }

  void expect_noticed(const json& changed, const std::string& what) const {
    const int status = status_of(changed);
    EXPECT_TRUE(status == 1 || status == 3) << what << " has status " << status;
  }

  SmallShop shop_;
  json whole_;
};

/// Returns other values for a leaf; `key` is the last key of its place that is not a number.
std::vector<json> others(const std::string& key, const json& value) {
  if (const auto words = kWordsOf.find(key); words != kWordsOf.end() && value.is_string()) {
    std::vector<json> all;
    for (const std::string& word : words->second)
      if (word != value) all.emplace_back(word);
    return all;
  }
  if (value.is_boolean()) return {!value.get<bool>()};
  if (value.is_number_integer()) return {value.get<long>() + 1};
  if (value.is_number()) return {value.get<double>() * 1.001 + 1e-4};
  if (value.is_string()) return {"other"};
  if (value.is_null()) return {1, "other"};
  return {json::object({{"OTHER", 1}}), json::array({1})};  // an empty list or object
}

std::string last_key(const std::string& place) {
  std::string rest = place;
  while (!rest.empty()) {
    const std::size_t slash = rest.rfind('/');
    const std::string key = rest.substr(slash + 1);
    if (key.find_first_not_of("0123456789") != std::string::npos) return key;
    rest.resize(slash);
  }
  return {};
}

/// Returns the places of all leaves below a place.
std::vector<std::string> leaves(const json& result, const std::string& section) {
  std::vector<std::string> places;
  const json flat = result.at(section).flatten();
  for (const auto& [place, value] : flat.items()) places.push_back("/" + section + place);
  return places;
}

TEST_F(ChangedResult, EveryLeafOfWhatItStatesOfItsInputsAndFindingsIsVerified) {
  check(kHead);
  const json& totals = whole_.at("totals");
  ASSERT_GE(totals.at("gouge"), 4);
  ASSERT_GE(totals.at("near"), 1);
  ASSERT_GE(whole_.at("events").size(), 4U);
  for (const char* section : {"events", "toolpath", "tools", "totals", "parts", "fixtures", "runs", "motions"}) {
    for (const std::string& place : leaves(whole_, section)) {
      for (const json& other : others(last_key(place), whole_.at(Pointer(place)))) {
        if (other == whole_.at(Pointer(place))) continue;
        json changed = whole_;
        changed.at(Pointer(place)) = other;
        expect_noticed(changed, place + " = " + other.dump());
      }
    }
  }
}

TEST_F(ChangedResult, InInchesToo) {
  check("PARTNO/SHOP\nUNITS/INCHES\nLOADTL/1\nMULTAX/ON\n", {"--stl-units", "inch"});
  for (const std::string& place : leaves(whole_, "events")) {
    const json other = others(last_key(place), whole_.at(Pointer(place))).front();
    json changed = whole_;
    changed.at(Pointer(place)) = other;
    expect_noticed(changed, place + " = " + other.dump());
  }
}

TEST_F(ChangedResult, EntriesThatAreMissingTwiceThereOrInAnotherOrderAreNoticed) {
  check(kHead);
  for (const char* section : {"events", "tools", "parts", "fixtures", "runs", "moves", "assumptions", "motions"}) {
    const json& list = whole_.at(section);
    for (std::size_t k = 0; k < list.size(); ++k) {
      json without = whole_, twice = whole_;
      without.at(section).erase(k);
      twice.at(section).push_back(list.at(k));
      expect_noticed(without, std::string(section) + " without " + std::to_string(k));
      expect_noticed(twice, std::string(section) + " with " + std::to_string(k) + " twice");
    }
  }
  json swapped = whole_;
  std::swap(swapped.at("events").at(0), swapped.at("events").at(1));
  expect_noticed(swapped, "events in another order");
}

// The numbers of a witness are verified as such: another point that is as deep is a witness too.
TEST_F(ChangedResult, WhatAMoveStatesOfItsStatementMotionAndBodyIsVerified) {
  check(kHead);
  const std::set<std::string> verified = {"move",  "line",      "kind", "tool",    "operation", "statement", "motion",
                                          "state", "clearance", "body", "against", "mesh",      "depth"};
  for (const std::string& place : leaves(whole_, "moves")) {
    const json& value = whole_.at(Pointer(place));
    if (!verified.contains(last_key(place))) continue;
    for (const json& other : others(last_key(place), value)) {
      json changed = whole_;
      changed.at(Pointer(place)) = other;
      if (other != value) expect_noticed(changed, place + " = " + other.dump());
    }
  }
}

TEST_F(ChangedResult, FactsThatAreHiddenRelabelledOrAddedAreNoticed) {
  std::string head = kHead;
  check(head);
  for (std::size_t k = 0; k < whole_.at("assumptions").size(); ++k) {
    const std::string place = "/assumptions/" + std::to_string(k);
    for (const char* key : {"fact", "object", "value", "evidence", "remedy", "file"}) {
      json changed = whole_;
      changed.at(Pointer(place + "/" + key)) = std::string(key) == "fact" ? "stock" : "other";
      expect_noticed(changed, place + "/" + key);
    }
    for (const char* state : {"stated", "derived", "default", "contradicted", "unknown"}) {
      json changed = whole_;
      json& fact = changed.at(Pointer(place));
      if (fact.at("state") == state) continue;
      fact["state"] = state;
      expect_noticed(changed, place + " as " + state);
    }
    json open = whole_;
    open.at(Pointer(place)).at("is_open") = true;
    expect_noticed(open, place + " as open");
  }
}

/// A path over the plate without its end.
std::string without_end() {
  std::string text = path_text(stations());
  text.resize(text.rfind("FINI"));
  return text;
}

TEST_F(ChangedResult, AnUnknownFactCannotBeHidden) {
  ASSERT_EQ(shop_.check("result", without_end(), {"-q"}).exit_status, 4);
  const json result = shop_.json("result.json");
  ASSERT_EQ(status_of(result), 0) << shop_.run({"verify", "changed.json"}).out;
  json without = result, relabelled = result;
  without["verdict"] = relabelled["verdict"] = "clean";
  without["exit_status"] = relabelled["exit_status"] = 0;
  json& facts = without.at("assumptions");
  facts.erase(std::ranges::find_if(facts, [](const json& fact) { return fact.at("fact") == "complete"; }));
  for (json& fact : relabelled.at("assumptions")) {
    if (fact.at("fact") == "complete") fact["state"] = "derived", fact["is_open"] = false;
  }
  shop_.write("changed.json", sealed(without));
  Outcome ran = shop_.run({"verify", "changed.json"});
  EXPECT_EQ(ran.exit_status, 1);
  EXPECT_NE(ran.out.find("refuted: it leaves out the fact complete (unknown)"), std::string::npos) << ran.out;
  shop_.write("changed.json", sealed(relabelled));
  ran = shop_.run({"verify", "changed.json"});
  EXPECT_EQ(ran.exit_status, 1);
  EXPECT_NE(ran.out.find("it states the fact complete as derived, and its moves and inputs show it as unknown"),
            std::string::npos)
      << ran.out;
}

TEST_F(ChangedResult, AWarningThatCountsAsAnErrorCannotBeHidden) {
  std::string plate = plate_stl();
  plate.resize(plate.rfind("endsolid"));
  shop_.write("part.stl", plate);
  ASSERT_EQ(shop_.check("result", path_text(stations()), {"--warnings-as-errors", "-q"}).exit_status, 4);
  json result = shop_.json("result.json");
  ASSERT_EQ(status_of(result), 0) << shop_.run({"verify", "changed.json"}).out;
  result["notes"] = json::array();
  result["verdict"] = "clean";
  result["exit_status"] = 0;
  shop_.write("changed.json", sealed(result));
  const Outcome ran = shop_.run({"verify", "changed.json"});
  EXPECT_EQ(ran.exit_status, 1) << ran.out;
  EXPECT_NE(ran.out.find("it leaves out the warning stl-no-endsolid"), std::string::npos) << ran.out;
}

// The options of the check state facts too. Each of these results is sound, whichever way its files are named.
TEST_F(ChangedResult, FactsOfTheOptionsAreThoseOfTheResult) {
  std::string open = plate_stl();
  open.erase(open.find("facet"), open.find("endfacet") + 9 - open.find("facet"));
  shop_.write("open.stl", open);
  const std::vector<std::vector<std::string>> options = {
      {"--assume", "complete"},
      {"--assume", "complete", "--strict"},
      {"--assume", "complete", "--assume", "solid=open.stl", "--part", "open.stl"},
      {"--place", "0,0,-1", "--stl-units", "mm"},
      {"--place", "0,0,-0.1mm", "--assume", "placement"},
      {"--tolerance", "0.6", "--stock-to-leave", "-0.5"}};
  for (const std::vector<std::string>& more : options) {
    (void)shop_.check("result", without_end(), more);
    const std::string what = json(more).dump();
    Outcome ran = shop_.run({"verify", "result.json"});
    EXPECT_EQ(ran.out.find("refuted: "), std::string::npos) << what << ran.out << ran.err;
    ran = shop_.run_script("here=$(pwd); cd / && \"$GOUGECHECK\" verify \"$here/result.json\"");
    EXPECT_EQ(ran.out.find("refuted: "), std::string::npos) << what << ran.out << ran.err;
  }
}

// The result lists the touched point without its depth, and any of these moves may be the worst.
TEST_F(ChangedResult, ABuriedToolThatTouchesASurfaceIsNotRefuted) {
  shop_.write("tools.json", R"({"units": "mm", "tools": [{"number": 1, "name": "mill",
    "cutter": {"shape": "flat", "diameter": 10, "length": 10}}]})");
  std::string text = "PARTNO/SHOP\nUNITS/MM\nLOADTL/1\nRAPID\nGOTO/-20,50,30\n";
  for (const char* at : {"30,50,-20.004", "40,50,-20.006", "50,50,-20.006", "60,50,-20.005", "120,50,30"})
    text += std::string("RAPID\nGOTO/") + at + "\n";
  (void)shop_.check("result", text + "FINI\n", {"--tools", "tools.json", "--near-miss", "0.5", "-q"});
  const json moves = shop_.json("result.json").at("moves");
  EXPECT_TRUE(std::ranges::any_of(moves, [](const json& move) {
    return move.at("state") == "buried" && !move.at("witness").is_null();
  })) << moves.dump();
  const Outcome ran = shop_.run({"verify", "result.json"});
  EXPECT_EQ(ran.exit_status, 4) << ran.err;
  EXPECT_EQ(ran.out.find("refuted: "), std::string::npos) << ran.out;
}

TEST_F(ChangedResult, IsRefutedWhereOtherCommandsRefuseIt) {
  check(kHead);
  json changed = whole_;
  changed["toolpath"]["moves"] = whole_.at("toolpath").at("moves").get<int>() + 1;
  shop_.write("changed.json", sealed(changed));
  EXPECT_EQ(shop_.run({"accept", "changed.json", "--all", "--by", "A", "--reason", "r", "-o", "a.json"}).exit_status,
            3);
  const Outcome ran = shop_.run({"verify", "changed.json"});
  EXPECT_EQ(ran.exit_status, 1) << ran.out;
  EXPECT_NE(ran.out.find(" contradicts another: "), std::string::npos) << ran.out;
}

}  // namespace
}  // namespace gouge::testing_samples::changed_result_test
