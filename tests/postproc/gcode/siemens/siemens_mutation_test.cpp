#include <string>
#include <vector>

#include "tests/postproc/gcode/siemens/siemens_program.h"
#include "tests/support/scatter.h"

// A removed, doubled or damaged word never makes a program clean that was not; and no bytes end the reader.

namespace gouge::siemens_mutation_test {
namespace {

using test::can_be_clean;
using test::kHead;
using test::Scatter;

/// Programs that are not clean. Where one word is the reason, only damage to it may make them clean; so each has two.
std::vector<std::string> open_programs() {
  return {kHead + "G41 G1 X5 F100\nX6\nG42 X7\nX8 Y9\nM30\n",
          kHead + "G64\nG1 X5 F100\nCOMPCAD\nG64\nCOMPCAD\nX7\nM30\n",
          kHead + "TRANS X=R1\nATRANS Y=R2\nAROT Z=R3\nG1 X5 F100\nTRANS X=R4\nX6\nM30\n",
          kHead + "XYZ=5\nG58 X1\nG1 X5 F100\nM66\nX6\nM30\n",
          kHead + "CYCLE86(10,0,3,-6,,1,3,1,1,1,0)\nCYCLE800(1,\"A\",1,192)\nCYCLE86(10,0,3,-6,,1,3,1,1,1,0)\nM30\n",
          kHead + "IF R9==1 GOTOF A\nG1 X5 F100\nA: G1 X=R8\nX=R7\nM30\n",
          kHead + "G74 X1=0\nG75 X1=0\nG1 X5 F100\nG74 X1=0\nM30\n"};
}

/// Words of a program with their places.
std::vector<std::pair<std::size_t, std::size_t>> words_of(const std::string& text) {
  std::vector<std::pair<std::size_t, std::size_t>> words;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t begin = text.find_first_not_of(" \n", at);
    if (begin == std::string::npos) break;
    const std::size_t end = std::min(text.find_first_of(" \n", begin), text.size());
    words.emplace_back(begin, end - begin);
    at = end;
  }
  return words;
}

std::string damaged(std::string word, Scatter& scatter) {
  constexpr std::string_view kBytes = "0123456789XYZGMDTR.-=();,\"'_ $";
  const auto at = static_cast<std::size_t>(scatter.in(0, static_cast<double>(word.size()) - 1e-9));
  word[at] = kBytes[static_cast<std::size_t>(scatter.in(0, static_cast<double>(kBytes.size()) - 1e-9))];
  return word;
}

TEST(SiemensMutations, NoDamagedWordMakesAProgramClean) {
  Scatter scatter(45);
  for (const std::string& program : open_programs()) {
    ASSERT_FALSE(can_be_clean(test::read_siemens(program))) << program;
    for (const auto& [begin, size] : words_of(program)) {
      const std::string word = program.substr(begin, size), before = program.substr(0, begin),
                        after = program.substr(begin + size);
      std::vector<std::string> others = {before + after, before + word + " " + word + after,
                                         before + word + word + after};
      for (int i = 0; i < 12; ++i) others.push_back(before + damaged(word, scatter) + after);
      for (const std::string& other : others) {
        EXPECT_FALSE(can_be_clean(test::read_siemens(other))) << "damaged at '" << word << "':\n" << other;
      }
    }
  }
}

TEST(SiemensMutations, DamageOfACleanProgramMovesNothingUnseen) {
  // A word that is removed from these blocks changes the place, or makes the program open: never the same clean path.
  const std::string program =
      kHead + "RTLION\nTRANS X10\nAROT Z90\nG1 X1 Y2 Z3 F100\nG2 X3 Y4 I1 J1\nTRANS\nG0 X1 Z90\nM30\n";
  const ReadOutcome whole = test::read_siemens(program);
  ASSERT_TRUE(can_be_clean(whole)) << test::reasons_of(whole);
  const std::string blocks = program.substr(kHead.size());
  for (const auto& [begin, size] : words_of(blocks)) {
    const std::string word = blocks.substr(begin, size);
    if (word[0] == 'F') continue;
    const ReadOutcome other = test::read_siemens(kHead + blocks.substr(0, begin) + blocks.substr(begin + size));
    if (!can_be_clean(other)) continue;
    const Moves &a = whole.toolpath->moves, &b = other.toolpath->moves;
    bool is_same = a.size() == b.size();
    for (std::size_t i = 0; is_same && i < a.size(); ++i)
      is_same = (a[i].end.tip - b[i].end.tip).norm() < 1e-9 && a[i].kind == b[i].kind;
    EXPECT_FALSE(is_same) << "without '" << word << "'";
  }
}

TEST(SiemensMutations, DeepExpressionsDoNotEndTheReader) {
  for (const char* piece : {"NOT ", "(", "-(", "SIN(", "R[", "1+("}) {
    std::string value;
    for (int i = 0; i < 200'000; ++i) value += piece;
    EXPECT_FALSE(can_be_clean(test::read_siemens(kHead + "R1=" + value + "\nG1 X=R1 F100\nM30\n"))) << piece;
  }
}

TEST(SiemensMutations, RandomBytesDoNotEndTheReader) {
  Scatter scatter(840);
  constexpr std::string_view kPieces[] = {
      "G1 ",    "X",      "=",         "(",  ")",      "\"",       "R1",      "[",     "]",   "IF ",   "REPEAT ", "A",
      ":",      "GOTOB ", "\n",        "\n", "TRANS ", "CYCLE800", "CYCLE81", ",",     "-",   "1",     "9.5",     "EX",
      "TRAORI", "MCALL ", "DEF REAL ", "_V", "FOR ",   "TO ",      "ENDFOR",  "UNTIL", "P=2", "SUPA ", "AC(",     "*",
      "<",      "==",     "/",         "%",  ";",      "$P_X",     "B",       "A3=",   "\x80"};
  for (int i = 0; i < 4000; ++i) {
    std::string text = i % 2 == 0 ? kHead : std::string();
    const int pieces = static_cast<int>(scatter.in(1, 60));
    for (int k = 0; k < pieces; ++k)
      text += kPieces[static_cast<std::size_t>(scatter.in(0, static_cast<double>(std::size(kPieces)) - 1e-9))];
    const ReadOutcome outcome = test::read_siemens(text, i % 3 == 0 ? test::full_setup() : ProgramSetup{});
    EXPECT_EQ(outcome.toolpath.has_value(), outcome.errors.empty());
    if (!outcome.toolpath) continue;
    for (const Move& move : outcome.toolpath->moves)
      EXPECT_TRUE(move.end.tip.allFinite() && move.end.axis.allFinite()) << text;
  }
}

}  // namespace
}  // namespace gouge::siemens_mutation_test
