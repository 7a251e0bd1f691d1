#include <gtest/gtest.h>

#include <algorithm>

#include "tests/samples/csv.h"
#include "tests/samples/program.h"
#include "tests/samples/sample_folder.h"
#include "tests/support/shapes.h"
#include "tests/support/stl_text.h"

// A verdict is that of the tool, of the heads, against parts and fixtures, from outside and from inside, with its
// overcut. Whoever gives one and leaves any of these out fails here: each move below is found by one of them alone.

namespace gouge::testing_samples::whole_verdict_test {
namespace {

constexpr const char* kPath =
    "UNITS/MM\n"
    "LOADTL/1\n"
    "GOTO/250,0,-100\n"  // inside the second part, no surface in the tool
    "GOTO/251,0,-100\n"  // still
    "RAPID\n"
    "GOTO/251,0,200\n"  // out of it
    "RAPID\n"
    "GOTO/0,0,200\n"
    "GOTO/0,0,-0.5\n"  // into the first part
    "GOTO/0,0,60\n"
    "GOTO/-30,0,60\n"
    "GOTO/-30,0,5\n"  // into the fixture
    "GOTO/-30,0,60\n"
    "GOTO/0,60,60\n"
    "GOTO/0,60,10\n"  // the head comes down on the post, far from the tool
    "GOTO/0,60,60\n"
    "FINI\n";
/// Beside the second part, the head alone in it.
constexpr const char* kHeadPath = "UNITS/MM\nLOADTL/1\nGOTO/139,0,-100\nGOTO/138,0,-100\nFINI\n";
constexpr std::size_t kBuried = 1, kPart = 4, kFixture = 7, kHead = 10;

std::string set_up() {
  const std::string folder = fresh_folder() + "/";
  const auto write = [&](const char* file, const IndexedMesh& mesh) {
    write_text(folder + file, shapes::ascii_stl(mesh));
  };
  write("part.stl", shapes::box(Vec3(-50, -50, -20), Vec3(50, 50, 0)));
  write("block.stl", shapes::box(Vec3(150, -100, -200), Vec3(400, 100, 100)));
  write("post.stl", shapes::box(Vec3(38, 58, -20), Vec3(42, 62, 55)));
  write("fixture.stl", shapes::box(Vec3(-40, -5, 1), Vec3(-20, 5, 20)));
  write("head.stl", shapes::box(Vec3(20, -20, 40), Vec3(60, 20, 90)));
  write_text(folder + "tools.json",
             R"({"units":"mm","tools":[{"number":1,"cutter":{"shape":"flat","diameter":10,"length":30}}]})");
  write_text(folder + "path.apt", kPath);
  write_text(folder + "head.apt", kHeadPath);
  return folder;
}

std::vector<std::string> words(const std::string& command, const std::string& path,
                               const std::vector<std::string>& more) {
  std::vector<std::string> all = {command,  path,        "--tools",     "tools.json", "--part",    "part.stl",
                                  "--part", "block.stl", "--part",      "post.stl",   "--fixture", "fixture.stl",
                                  "--head", "head.stl",  "--stl-units", "mm"};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

/// A field of all.csv.
std::string field(const std::string& folder, std::size_t move, const std::string& column) {
  const auto rows = parse_csv(text_of(folder + "all.csv"));
  const auto at = std::find(rows[0].begin(), rows[0].end(), column) - rows[0].begin();
  return rows[1 + move][static_cast<std::size_t>(at)];
}

/// The row of every move, except its place in the file.
std::vector<std::string> verdicts_of(const std::string& csv) {
  std::vector<std::string> all;
  for (const std::vector<std::string>& row : parse_csv(csv)) {
    std::string text;
    for (std::size_t k = 0; k < row.size(); ++k) text += k == 1 ? "" : row[k] + ",";
    all.push_back(text);
  }
  return all;
}

TEST(WholeVerdict, OfCheckLeavesNothingOut) {
  const std::string folder = set_up();
  const Outcome ran = run_gougecheck(folder, words("check", "path.apt", {"--csv", "all.csv"}));
  EXPECT_EQ(ran.exit_status, 1) << ran.err;
  const std::vector<MoveRow> moves = parse_moves(text_of(folder + "all.csv"));
  ASSERT_EQ(moves.size(), 12U) << ran.out << ran.err;
  EXPECT_EQ(moves[kBuried].state, "buried");
  EXPECT_EQ(moves[kPart].state + moves[kPart].against + moves[kPart].body, "gougepartcutter");
  EXPECT_EQ(moves[kFixture].state + moves[kFixture].against + moves[kFixture].body, "gougefixturecutter");
  EXPECT_EQ(moves[kHead].state + moves[kHead].against + moves[kHead].body, "gougeparthead");
  for (const std::size_t clean : {kPart - 1, kFixture - 1, kHead - 1}) EXPECT_EQ(moves[clean].state, "clean") << clean;
  EXPECT_EQ(field(folder, kBuried, "reason"), "the tool is inside the solid; no surface is inside the tool");
  for (const std::size_t gouge : {kPart, kFixture, kHead}) {
    const std::string overcut = field(folder, gouge, "overcut");
    ASSERT_FALSE(overcut.empty()) << gouge;
    EXPECT_GT(std::stod(overcut), 0) << gouge;
  }
}

TEST(WholeVerdict, OfCheckKnowsABuriedHead) {
  const std::string folder = set_up();
  EXPECT_EQ(run_gougecheck(folder, words("check", "head.apt", {"--csv", "all.csv"})).exit_status, 1);
  EXPECT_EQ(field(folder, 1, "reason"), "the head is inside the solid; no surface is inside the head");
}

// Where nothing may move, both checks of a correction are those of the same path.
TEST(WholeVerdict, OfCorrectWithoutAChangeIsThatOfCheck) {
  const std::string folder = set_up();
  for (const std::string path : {"path.apt", "head.apt"}) {
    const Outcome checked = run_gougecheck(folder, words("check", path, {"--csv", "check.csv"}));
    const Outcome corrected = run_gougecheck(
        folder, words("correct", path, {"-o", "same.apt", "--csv", "correct.csv", "--max-shift", "0.001", "--force"}));
    EXPECT_EQ(corrected.exit_status, checked.exit_status) << corrected.err;
    EXPECT_EQ(text_of(folder + "same.apt"), text_of(folder + path));
    EXPECT_EQ(verdicts_of(text_of(folder + "correct.csv")), verdicts_of(text_of(folder + "check.csv")));
  }
}

TEST(WholeVerdict, OfCorrectIsThatOfCheckOnTheFileItWrote) {
  const std::string folder = set_up();
  const Outcome corrected =
      run_gougecheck(folder, words("correct", "path.apt", {"-o", "new.apt", "--csv", "correct.csv", "--force"}));
  EXPECT_NE(text_of(folder + "new.apt"), kPath) << corrected.out << corrected.err;
  const Outcome checked = run_gougecheck(folder, words("check", "new.apt", {"--csv", "check.csv"}));
  EXPECT_EQ(corrected.exit_status, checked.exit_status) << corrected.err;
  EXPECT_EQ(text_of(folder + "correct.csv"), text_of(folder + "check.csv"));
  // The pose inside the block stays, as there is no way out to follow; nothing else may remain.
  for (const MoveRow& move : parse_moves(text_of(folder + "check.csv"))) {
    if (move.move <= 2) continue;
    EXPECT_EQ(move.state, "clean") << move.move;
  }
}

}  // namespace
}  // namespace gouge::testing_samples::whole_verdict_test
