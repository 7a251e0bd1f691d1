#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/samples/box_stl.h"
#include "tests/samples/small_shop.h"

// Moves in which more than one body gouges, or one body gouges the part and a fixture.

namespace gouge::testing_samples::further_contacts_test {
namespace {

using Words = std::vector<std::string>;

constexpr const char* kTools = R"({"units": "mm", "tools": [{"number": 1, "name": "flat",
  "cutter": {"shape": "flat", "diameter": 10, "length": 25},
  "shank": [{"lower_diameter": 10, "upper_diameter": 10, "length": 10}],
  "holder": [{"lower_diameter": 40, "upper_diameter": 40, "length": 40}]}]})";

/// The cutter runs over the plate at this height. The holder begins 35 mm above the tip, and passes a clamp.
std::string path_at(const std::string& z) {
  return "PARTNO/SHOP\nUNITS/MM\nLOADTL/1\nGOTO/-20,50,20\nGOTO/-20,50," + z + "\nGOTO/110,50," + z + "\nFINI\n";
}

class FurtherContacts : public testing::Test {
 protected:
  FurtherContacts() { shop_.write("tools.json", kTools); }

  /// Checks the path at z beside a clamp of this height.
  Outcome check(const std::string& name, const std::string& z, double clamp_mm, Words more = {}) const {
    shop_.write("clamp.stl", box_stl({40, 65, 1}, {60, 95, clamp_mm}));
    for (const char* word : {"--tools", "tools.json", "--fixture", "clamp.stl"}) more.emplace_back(word);
    return shop_.check(name, path_at(z), more);
  }
  [[nodiscard]] nlohmann::json further(const std::string& file) const {
    return shop_.json(file).at("moves").back().value("further", nlohmann::json::array());
  }
  [[nodiscard]] nlohmann::json compare(const std::string& before, const std::string& after) const {
    static_cast<void>(shop_.run({"compare", before, after, "--json", "compared.json"}));
    return shop_.json("compared.json");
  }

  SmallShop shop_;
};

TEST_F(FurtherContacts, AreStatedInEveryOutput) {
  const Outcome ran = check("a", "-0.2", 38, {"--sarif", "a.sarif", "--junit", "a.xml", "--report", "page"});
  EXPECT_EQ(ran.exit_status, 1);
  const std::string words = "; cutter too: 0.200 mm at (0, 50, 0) t=0.";
  EXPECT_NE(ran.out.find("gouge: 3.200 mm holder T1 against fixture clamp.stl"), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find(words), std::string::npos) << ran.out;
  for (const char* file : {"a.sarif", "a.xml", "page/report.html"})
    EXPECT_NE(shop_.read(file).find("cutter too: 0.200 mm"), std::string::npos) << file;
  EXPECT_NE(shop_.read("page/report.html").find("<td>holder T1 (and cutter)</td><td>fixture clamp.stl (and part)</td>"),
            std::string::npos);
  const nlohmann::json all = further("a.json");
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].at("body"), "cutter");
  EXPECT_EQ(all[0].at("against"), "part");
  EXPECT_NEAR(all[0].at("depth").get<double>(), 0.2, 1e-9);
  EXPECT_LE(all[0].at("depth_upper").get<double>(), 0.201);
  EXPECT_EQ(all[0].at("witness").at("mesh"), "part.stl");
}

TEST_F(FurtherContacts, AreAbsentWhereOneBodyGouges) {
  EXPECT_EQ(check("a", "-0.2", 30).out.find(" too: "), std::string::npos);
  EXPECT_TRUE(further("a.json").empty());
  EXPECT_EQ(check("b", "0", 38).out.find(" too: "), std::string::npos);
  EXPECT_TRUE(further("b.json").empty());
}

TEST_F(FurtherContacts, AreFoundForOneBodyInPartAndFixture) {
  shop_.write("clamp.stl", box_stl({40, 40, 1}, {60, 60, 4}));
  const Outcome ran = shop_.check("a", path_at("-0.2"), {"--tools", "tools.json", "--fixture", "clamp.stl"});
  EXPECT_NE(ran.out.find("cutter T1 against fixture clamp.stl"), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("cutter too: 0.200 mm at"), std::string::npos) << ran.out;
}

TEST_F(FurtherContacts, ObeyClearances) {
  const Outcome near = check("a", "-0.5", 33.8, {"--clearance", "holder=1"});
  EXPECT_NE(near.out.find("cutter T1"), std::string::npos) << near.out;
  ASSERT_EQ(further("a.json").size(), 1U) << near.out;
  EXPECT_EQ(further("a.json")[0].at("body"), "holder");
  EXPECT_NEAR(further("a.json")[0].at("depth").get<double>(), 0.3, 1e-9);
}

TEST_F(FurtherContacts, AreVerified) {
  check("a", "-0.2", 38);
  const Outcome truth = shop_.run({"verify", "a.json"});
  EXPECT_EQ(truth.exit_status, 0) << truth.out << truth.err;
  nlohmann::json forged = shop_.json("a.json");
  nlohmann::json& contact = forged.at("moves").back().at("further").at(0);
  contact["depth"] = 0.1;
  shop_.write("b.json", forged.dump());
  const Outcome deeper = shop_.run({"verify", "b.json"});
  EXPECT_EQ(deeper.exit_status, 1) << deeper.out << deeper.err;
  EXPECT_NE(deeper.out.find("the witness of its cutter: the point is 0.2 mm deep"), std::string::npos) << deeper.out;
  contact["depth"] = 0.2;
  contact["body"] = "shank";
  shop_.write("c.json", forged.dump());
  EXPECT_EQ(shop_.run({"verify", "c.json"}).exit_status, 1);
}

TEST_F(FurtherContacts, AreNoNewFindingsWhenTheDeeperOneIsGone) {
  check("a", "-0.2", 38);
  check("b", "-0.2", 30);
  const nlohmann::json compared = compare("a.json", "b.json");
  EXPECT_EQ(compared.at("exit_status"), 0) << compared.dump(1);
  EXPECT_EQ(compared.at("counts").at("same"), 1);
  EXPECT_EQ(compared.at("counts").at("gone"), 1);
}

TEST_F(FurtherContacts, AreSeenBelowADeeperOne) {
  check("a", "-0.2", 30);
  check("b", "-0.2", 38);
  const nlohmann::json compared = compare("a.json", "b.json");
  EXPECT_EQ(compared.at("exit_status"), 1);
  EXPECT_EQ(compared.at("counts").at("new"), 1);
  EXPECT_EQ(compared.at("counts").at("not-checked-any-more"), 1);
  EXPECT_NE(compared.dump().find("gouges with it too, below a deeper gouge"), std::string::npos) << compared.dump(1);
}

TEST_F(FurtherContacts, ThatAreNewMakeAFindingDeeper) {
  check("a", "-2", 30);
  check("b", "-2", 33.5);
  const nlohmann::json compared = compare("a.json", "b.json");
  EXPECT_EQ(compared.at("counts").at("deeper"), 1) << compared.dump(1);
  EXPECT_NE(compared.dump().find("the holder gouges a fixture too, 0.500 mm deep, which was not so before"),
            std::string::npos)
      << compared.dump(1);
  check("c", "-2", 33.8);
  EXPECT_NE(compare("b.json", "c.json").dump().find("0.800 mm deep, 0.500 mm before"), std::string::npos);
  EXPECT_EQ(compare("c.json", "b.json").at("exit_status"), 0);
}

TEST_F(FurtherContacts, AreAcceptedWithTheGouge) {
  check("a", "-0.2", 38);
  const Outcome accepted =
      shop_.run({"accept", "a.json", "--all", "--reason", "r", "--reviewer", "A", "-o", "accepted.json"});
  ASSERT_EQ(accepted.exit_status, 0) << accepted.err;
  EXPECT_EQ(check("b", "-0.2", 38, {"--baseline", "accepted.json"}).exit_status, 0);
  EXPECT_EQ(check("c", "-0.2", 38.5, {"--baseline", "accepted.json"}).exit_status, 1);
}

}  // namespace
}  // namespace gouge::testing_samples::further_contacts_test
