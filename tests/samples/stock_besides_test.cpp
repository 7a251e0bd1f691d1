#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/samples/box_stl.h"
#include "tests/samples/small_shop.h"

// Moves that gouge the part and meet remaining stock besides.

namespace gouge::testing_samples::stock_besides_test {
namespace {

using Words = std::vector<std::string>;

/// A rapid 0.1 mm deep in the plate, and in material that is 5 mm higher.
const std::string kPath =
    std::string(kHead) + "RAPID\nGOTO/-20,50,20\nRAPID\nGOTO/-20,50,-0.1\nRAPID\nGOTO/50,50,-0.1\nFINI\n";
const Words kStock = {"--stock", "box=5"};
constexpr const char* kRemark = "the cutter is in remaining stock too: ";

Words with_stock(Words words) {
  words.insert(words.end(), kStock.begin(), kStock.end());
  return words;
}

class StockBesides : public testing::Test {
 protected:
  Outcome accept(const std::string& result) const {
    return shop_.run({"accept", result, "--all", "--reason", "r", "--reviewer", "A", "-o", "accepted.json"});
  }

  SmallShop shop_;
};

TEST_F(StockBesides, IsStatedWithTheGouge) {
  const Outcome ran = shop_.check("a", kPath, kStock);
  EXPECT_EQ(ran.exit_status, 1);
  EXPECT_NE(ran.out.find(kRemark), std::string::npos) << ran.out;
  EXPECT_NE(shop_.json("a.json").at("moves").at(0).at("reason").get<std::string>().find(kRemark), std::string::npos);
  EXPECT_EQ(shop_.check("b", kPath).out.find(kRemark), std::string::npos) << "without a stock there is no remark";
}

TEST_F(StockBesides, IsNotHiddenByAnAcceptanceOfTheGouge) {
  shop_.check("a", kPath);
  ASSERT_EQ(accept("a.json").exit_status, 0);
  EXPECT_EQ(shop_.check("b", kPath, {"--baseline", "accepted.json"}).exit_status, 0);
  const Outcome ran = shop_.check("c", kPath, with_stock({"--baseline", "accepted.json"}));
  EXPECT_EQ(ran.exit_status, 1);
  EXPECT_NE(ran.out.find("not accepted: line 10 has more than this gouge: the cutter is in remaining stock too"),
            std::string::npos)
      << ran.out;
  EXPECT_EQ(shop_.json("c.json").at("verdict"), "gouges");
}

TEST_F(StockBesides, CannotBeAcceptedWithTheGouge) {
  shop_.check("a", kPath, kStock);
  const Outcome ran = accept("a.json");
  EXPECT_EQ(ran.exit_status, 3);
  EXPECT_NE(ran.err.find("has more than this gouge: the cutter is in remaining stock too"), std::string::npos)
      << ran.err;
}

TEST_F(StockBesides, IsWorseThanTheGougeAloneInACompare) {
  shop_.check("a", kPath);
  shop_.check("b", kPath, kStock);
  const Outcome ran = shop_.run({"compare", "a.json", "b.json"});
  EXPECT_EQ(ran.exit_status, 1);
  EXPECT_NE(ran.out.find("1 motion is in remaining stock too, or may be, which was not so before"), std::string::npos)
      << ran.out;
  EXPECT_EQ(shop_.run({"compare", "b.json", "b.json"}).exit_status, 0);
}

TEST_F(StockBesides, IsNoneOfTheLimitsOfSingleFiles) {
  shop_.write("clamp.stl", box_stl({30, 40, -1}, {70, 60, 3}));
  const std::string above =
      std::string(kHead) + "RAPID\nGOTO/-20,50,20\nRAPID\nGOTO/-20,50,3.5\nRAPID\nGOTO/90,50,3.5\nFINI\n";
  const Words clamp = {"--fixture", "clamp.stl,clearance=1"};
  const Outcome alone = shop_.check("a", above, clamp);
  ASSERT_EQ(alone.exit_status, 1) << alone.out << alone.err;
  const Outcome both = shop_.check("b", above, with_stock(clamp));
  ASSERT_NE(both.out.find(kRemark), std::string::npos) << both.out;
  EXPECT_EQ(accept("b.json").exit_status, 3);
  EXPECT_EQ(shop_.run({"compare", "a.json", "b.json"}).exit_status, 1);
  EXPECT_EQ(accept("a.json").exit_status, 0) << "a limit alone can be accepted";
}

TEST_F(StockBesides, IsKnownToVerify) {
  shop_.check("a", kPath, kStock);
  const Outcome ran = shop_.run({"verify", "a.json"});
  EXPECT_EQ(ran.exit_status, 0) << ran.out << ran.err;
}

}  // namespace
}  // namespace gouge::testing_samples::stock_besides_test
