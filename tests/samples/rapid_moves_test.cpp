#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/samples/box_stl.h"
#include "tests/samples/small_shop.h"

// Moves in rapid that are no rapids of their own: arcs, steps of cycles, lists of positions.

namespace gouge::testing_samples::rapid_moves_test {
namespace {

using Words = std::vector<std::string>;

const std::string kBegin = std::string(kHead) + "FEDRAT/100,MMPM\n";
const Words kStock = {"--stock", "box=5", "--assume", "placement"};
constexpr const char* kFound = "rapid into stock: ";

class RapidMoves : public testing::Test {
 protected:
  Outcome check(const std::string& text, const Words& more) const { return shop_.check("a", kBegin + text, more); }

  SmallShop shop_;
};

std::string holes(const std::string& heights) {
  return "RAPID\nGOTO/20,50,60\nCYCLE/DRILL,DEPTH,0.5,MMPM,100," + heights +
         "\nGOTO/20,50,1\nGOTO/60,50,1\nCYCLE/OFF\nRAPID\nGOTO/60,50,60\nFINI\n";
}

TEST_F(RapidMoves, OfCyclesMustBeClearOfStock) {
  EXPECT_EQ(check(holes("CLEAR,9,RETURN,9"), kStock).exit_status, 0);
  for (const char* low : {"CLEAR,3,RETURN,3", "CLEAR,3,RETURN,9"}) {
    const Outcome ran = check(holes(low), kStock);
    EXPECT_EQ(ran.exit_status, 1) << ran.out << ran.err;
    EXPECT_NE(ran.out.find(kFound), std::string::npos) << ran.out;
    EXPECT_EQ(shop_.run({"verify", "a.json"}).exit_status, 0);
  }
}

TEST_F(RapidMoves, OfCyclesRemoveNoStock) {
  const std::string after = "GOTO/20,50,3\nRAPID\nGOTO/60,50,3\nRAPID\nGOTO/60,50,60\nFINI\n";
  const std::string begin = holes("CLEAR,3,RETURN,3");
  const Outcome ran = check(begin.substr(0, begin.size() - 5) + after, kStock);
  EXPECT_EQ(ran.exit_status, 1);
  EXPECT_EQ(shop_.json("a.json").at("stock").at("contacts").size(), 2U) << "down to the first hole, and across";
  // A feed would have cleared the way of the last rapid.
  EXPECT_NE(ran.out.find("not certified: whether stock is still there"), std::string::npos) << ran.out;
}

TEST_F(RapidMoves, OnArcsMustBeClearOfStock) {
  const auto arc = [](const std::string& z, const std::string& word) {
    return "TRNTYP/WORLD,0,0,0\nGOTO/20,50,60\nGOTO/20,50," + z + "\n" + word + "CIRCLE/30,50," + z +
           ",0,0,1,10\nGOTO/40,50," + z + "\nGOTO/40,50,60\nFINI\n";
  };
  EXPECT_EQ(check(arc("1", ""), kStock).exit_status, 0);
  EXPECT_EQ(check(arc("6", "RAPID\n"), kStock).exit_status, 0);
  const Outcome ran = check(arc("1", "RAPID\n"), kStock);
  EXPECT_EQ(ran.exit_status, 1) << ran.out << ran.err;
  EXPECT_NE(ran.out.find(kFound), std::string::npos) << ran.out;
  EXPECT_EQ(shop_.run({"verify", "a.json"}).exit_status, 0);
  // The cutter comes near the part, which only rapids report.
  EXPECT_EQ(check(arc("1", "RAPID\n"), {"--near-miss", "2"}).out.find(" left cutter") != std::string::npos, true);
  EXPECT_EQ(check(arc("1", ""), {"--near-miss", "2"}).out.find(" left cutter"), std::string::npos);
}

TEST_F(RapidMoves, OfCyclesAreDoglegsAndNearMisses) {
  // Straight, the way across passes beside the post; with equal speeds of both axes it runs into it.
  shop_.write("post.stl", box_stl({47, 47, -1}, {53, 53, 20}));
  const std::string across =
      "RAPID\nGOTO/10,10,60\nCYCLE/DRILL,DEPTH,0.5,MMPM,100,CLEAR,3\nGOTO/10,10,1\nGOTO/90,50,1\n"
      "CYCLE/OFF\nRAPID\nGOTO/90,50,60\nFINI\n";
  const Words post = {"--fixture", "post.stl", "--assume", "placement"};
  const auto with = [&](const Words& more) {
    Words words = post;
    words.insert(words.end(), more.begin(), more.end());
    return check(across, words);
  };
  EXPECT_EQ(with({}).exit_status, 0);
  EXPECT_EQ(with({"--rapid", "dogleg"}).exit_status, 1);
  EXPECT_EQ(shop_.run({"verify", "a.json"}).exit_status, 0);
  EXPECT_NE(with({"--near-miss", "5"}).out.find(" left cutter"), std::string::npos);
}

TEST_F(RapidMoves, OfListsMustBeClearOfStock) {
  const auto list = [](const std::string& word) {
    return "MULTAX/OFF\nGOTO/20,50,60\n" + word + "GOTO/20,50,11,30,50,1,40,50,1\nGOTO/40,50,60\nFINI\n";
  };
  EXPECT_EQ(check(list("RAPID\n"), {}).exit_status, 0);
  EXPECT_EQ(check(list(""), kStock).exit_status, 0);
  const std::string from = "GOTO/20,50,60\nRAPID\nFROM/20,50,20\nGOTO/20,50,1\nGOTO/20,50,60\nFINI\n";
  EXPECT_EQ(check(from, {}).exit_status, 0);
  for (const std::string& text : {list("RAPID\n"), from}) {
    const Outcome ran = check(text, kStock);
    EXPECT_EQ(ran.exit_status, 1) << ran.out;
    EXPECT_NE(ran.out.find(kFound), std::string::npos) << ran.out;
    EXPECT_EQ(shop_.run({"verify", "a.json"}).exit_status, 0);
  }
}

}  // namespace
}  // namespace gouge::testing_samples::rapid_moves_test
