#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "tests/postproc/gcode/siemens/siemens_program.h"
#include "tests/support/source_folder.h"

// The real programs of the shared data. Their words are read here by another way: a regular expression for each line, and
// the places of X, Y and Z from one to the next.

namespace gouge::siemens_real_test {
namespace {

std::string real_program(const std::string& name) {
  const std::filesystem::path file = std::filesystem::path(source_folder()) / "../shared/data/gcode" / name;
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// Places of all blocks with plain words of X, Y and Z, by line.
std::map<std::size_t, Vec3> plain_places(const std::string& text) {
  std::map<std::size_t, Vec3> places;
  Vec3 at = Vec3::Constant(std::nan(""));
  std::istringstream lines(text);
  std::size_t number = 0;
  const std::regex word("([XYZ])(-?[0-9]*\\.?[0-9]+|-?[0-9]+\\.)");
  for (std::string line; std::getline(lines, line);) {
    ++number;
    line = line.substr(0, line.find(';'));
    if (line.find('(') != std::string::npos || line.find("SUPA") != std::string::npos ||
        line.find('=') != std::string::npos)
      continue;
    bool has_word = false;
    for (std::sregex_iterator one(line.begin(), line.end(), word), end; one != end; ++one) {
      at[(*one)[1].str()[0] - 'X'] = std::stod((*one)[2].str());
      has_word = true;
    }
    if (has_word) places[number] = at;
  }
  return places;
}

ProgramSetup real_setup(const std::string& start) {
  ProgramSetup setup = test::full_setup();
  setup.start = start;
  setup.tip_tolerance_mm = 0.07;
  return setup;
}

/// Expects that each move of a plain block ends at its place, and returns the lines of moves that are not checked.
std::set<std::size_t> compare(const std::string& text, const ReadOutcome& outcome, std::size_t& compared) {
  std::set<std::size_t> open;
  if (!outcome.toolpath) {
    ADD_FAILURE() << test::reasons_of(outcome);
    return open;
  }
  const std::map<std::size_t, Vec3> places = plain_places(text);
  std::set<std::size_t> seen;
  for (const Move& move : outcome.toolpath->moves) {
    if (!move.not_checked_reason.empty()) open.insert(move.line);
    const auto place = places.find(move.line);
    if (place == places.end() || !seen.insert(move.line).second || !move.not_checked_reason.empty()) continue;
    const bool is_known_place = !place->second.hasNaN();
    if (!is_known_place) continue;
    EXPECT_NEAR((move.end.tip - place->second).norm(), 0, 1e-9) << "line " << move.line;
    ++compared;
  }
  return open;
}

TEST(SiemensReal, TheSpinnerProgramIsReadToItsEnd) {
  const std::string text = real_program("s840d_spinner_keychain.mpf");
  if (text.empty()) GTEST_SKIP() << "the shared data is not here";
  const ReadOutcome outcome = test::read_siemens(text, real_setup("G54\n"), {"M27", "M29", "M50", "M51", "M65"});
  std::size_t compared = 0;
  const std::set<std::size_t> open = compare(text, outcome, compared);
  EXPECT_TRUE(open.empty()) << test::reasons_of(outcome);
  EXPECT_GT(compared, 550U);
  EXPECT_TRUE(outcome.toolpath->words_not_understood.empty());
  EXPECT_EQ(outcome.toolpath->tools.size(), 2U);
  // Six holes by CYCLE81: the deepest place, by hand from the words of the cycle.
  EXPECT_NEAR(outcome.toolpath->moves.back().end.tip.z(), 610 - 100, 1e-9);
}

TEST(SiemensReal, TheSpinnerProgramWithoutFactsListsItsBlocks) {
  const std::string text = real_program("s840d_spinner_keychain.mpf");
  if (text.empty()) GTEST_SKIP() << "the shared data is not here";
  ProgramSetup setup;
  setup.machine = test::table_machine();
  const ReadOutcome outcome = test::read_siemens(text, setup);
  EXPECT_FALSE(test::can_be_clean(outcome));
  EXPECT_TRUE(is_gcode(text));
  EXPECT_NE(test::reasons_of(outcome).find("M50"), std::string::npos) << test::reasons_of(outcome);
}

TEST(SiemensReal, TheNxProgramIsReadToItsEnd) {
  const std::string text = real_program("s840d_nx_camtest.mpf");
  if (text.empty()) GTEST_SKIP() << "the shared data is not here";
  ProgramSetup setup = real_setup("G54\nG60\n");
  Result<Machine> machine = read_machine("table", R"({"name": "table", "joints": [
    {"name": "C", "type": "rotary", "side": "table", "direction": [0, 0, 1], "point": [0, 0, 0], "continuous": true},
    {"name": "A", "type": "rotary", "side": "table", "direction": [1, 0, 0], "point": [0, 0, 0], "min": -120, "max": 120},
    {"name": "X", "type": "linear", "side": "head", "direction": [1, 0, 0]},
    {"name": "Y", "type": "linear", "side": "head", "direction": [0, 1, 0]},
    {"name": "Z", "type": "linear", "side": "head", "direction": [0, 0, 1]}]})");
  ASSERT_TRUE(machine.has_value());
  setup.machine = std::make_shared<const Machine>(std::move(*machine));
  setup.offsets["G54"] = {Vec3(-300, -200, -400), Vec3::Zero()};
  const ReadOutcome outcome = test::read_siemens(text, setup);
  std::size_t compared = 0;
  const std::set<std::size_t> open = compare(text, outcome, compared);
  EXPECT_TRUE(open.empty()) << test::reasons_of(outcome);
  EXPECT_GT(compared, 950U);
  EXPECT_GT(outcome.toolpath->arcs.size(), 100U);
  EXPECT_TRUE(outcome.toolpath->words_not_understood.empty());
}

}  // namespace
}  // namespace gouge::siemens_real_test
