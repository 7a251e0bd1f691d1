#include <gtest/gtest.h>

#include "tests/postproc/gcode/heidenhain/klartext.h"
#include "tests/support/scatter.h"

// A removed, doubled or damaged word never makes a program clean that was not.

namespace gouge::klartext::klartext_mutation_test {
namespace {

/// Programs that are checked to their end.
const std::vector<std::string>& whole_programs() {
  static const std::vector<std::string> programs = {
      "L X+0 Y+0 Z+10 R0 FMAX M3\nL Z-2 F200\nL X+30 Y+1\nCC X+30 Y+11\nC X+40 Y+11 DR+\nCR X+50 Y+21 R+10 DR-\nL Z+50 FMAX\n",
      "CYCL DEF 7.0 DATUM SHIFT\nCYCL DEF 7.1 X+10\nCYCL DEF 7.2 Y+5\nCYCL DEF 10.0 ROTATION\nCYCL DEF 10.1 ROT+30\n"
      "L X+0 Y+0 Z+10 R0 FMAX\nL X+3 Y+4 F100\nCYCL DEF 10.0 ROTATION\nCYCL DEF 10.1 ROT+0\nL X+9 Y+9 FMAX\n",
      "CYCL DEF 200 DRILLING ~\nQ200=+2 ;SET-UP ~\nQ201=-15 ;DEPTH ~\nQ206=+150 ;FEED ~\nQ203=+5 ;SURFACE ~\nQ204=+30 ;2ND\n"
      "L X+10 Y+20 Z+50 R0 FMAX M99\nL X+20 FMAX M99\n",
      "Q1 = 3\nL X+0 Y+0 Z+10 R0 FMAX\nLBL 1\nL IX+Q1 F100\nCALL LBL 1 REP 2\nCALL LBL 2\nL Z+50 FMAX M30\nLBL 2\nL Y+5\nLBL 0\n",
      "PLANE SPATIAL SPA+0 SPB+30 SPC+45 TURN FMAX\nL X+0 Y+0 Z+10 R0 FMAX\nL X+5 F100\nCC X+5 Y+5\nCP IPA+360 IZ-2 DR+\n"};
  return programs;
}

/// Programs with one motion at least that is not checked, for the reason in force in it.
const std::vector<std::string>& open_programs() {
  static const std::vector<std::string> programs = {
      "L X+0 Y+0 Z+10 R0 FMAX\nL X+5 F100 M118 X1\nL X+6\n", "L X+0 Y+0 Z+10 R0 FMAX\nFOO 3\nL X+6\n",
      "L X+0 Y+0 Z+10 R0 FMAX\nL X+Q1 F100\n",
      "CYCL DEF 19.0 WORKING PLANE\nCYCL DEF 19.1 A+30 B+0 C+0\nL X+0 Y+0 Z+10 R0 FMAX\nL X+6 F100\n",
      "L X+0 Y+0 Z+10 R0 FMAX\nTOOL CALL 2 Z S1 DL+0.5\nL X+0 Y+0 Z+3 FMAX\nL X+6 F100\n"};
  return programs;
}

bool is_open(const std::string& blocks) {
  const ReadOutcome outcome = outcome_of(with_ends(blocks));
  return !outcome.toolpath || !outcome.toolpath->words_not_understood.empty() || count_open(*outcome.toolpath) > 0;
}

struct Piece {
  std::size_t begin = 0, end = 0;
};

std::vector<Piece> words_of(const std::string& text) {
  std::vector<Piece> words;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t begin = text.find_first_not_of(" \n", at);
    if (begin == std::string::npos) break;
    at = std::min(text.find_first_of(" \n", begin), text.size());
    words.push_back({begin, at});
  }
  return words;
}

/// Returns whether a word is within a comment, or is the title of a cycle.
bool has_no_meaning(const std::string& text, const Piece& word) {
  const std::size_t line = text.rfind('\n', word.begin) + 1;
  const std::string before = text.substr(line, word.begin - line);
  const std::string own = text.substr(word.begin, word.end - word.begin);
  const bool is_comment = before.find(';') != std::string::npos || own.starts_with(';');
  const bool is_title = before.starts_with("CYCL DEF ") && own.find_first_of("0123456789~") == std::string::npos;
  return is_comment || is_title;
}

TEST(KlartextMutation, ProgramsAreAsTheyAreMeant) {
  for (const std::string& program : whole_programs()) EXPECT_FALSE(is_open(program)) << program;
  for (const std::string& program : open_programs()) EXPECT_TRUE(is_open(program)) << program;
}

TEST(KlartextMutation, ADamagedWordIsNotOverlooked) {
  for (const std::string& program : whole_programs()) {
    for (const Piece& word : words_of(program)) {
      if (has_no_meaning(program, word)) continue;
      for (std::size_t at = word.begin; at <= word.end; ++at) {
        std::string damaged = program;
        damaged.insert(at, "#");
        EXPECT_TRUE(is_open(damaged)) << damaged;
      }
    }
  }
}

// Only words that allow it may stand twice: a tilde, and text that begins the same block again.
TEST(KlartextMutation, ADoubledWordIsNotOverlooked) {
  for (const std::string& program : whole_programs()) {
    for (const Piece& word : words_of(program)) {
      const std::string own = program.substr(word.begin, word.end - word.begin);
      if (has_no_meaning(program, word) || own == "~") continue;
      std::string doubled = program;
      doubled.insert(word.end, " " + own);
      EXPECT_TRUE(is_open(doubled)) << doubled;
    }
  }
}

// A program that is not checked somewhere may become checked by a removed word only where the word was the reason: then it
// is another program. These reasons stay when any other word goes.
TEST(KlartextMutation, ARemovedWordDoesNotMakeAProgramClean) {
  for (const std::string& program : open_programs()) {
    for (const Piece& word : words_of(program)) {
      const std::string own = program.substr(word.begin, word.end - word.begin);
      std::string removed = program;
      removed.erase(word.begin, word.end - word.begin);
      const bool is_reason =
          own == "X+Q1" || own == "M118" || own == "DL+0.5" || own == "A+30" || own == "FOO" || own == "X1";
      EXPECT_TRUE(is_reason || is_open(removed)) << removed;
    }
  }
}

TEST(KlartextMutation, NoBytesEndTheProgramItself) {
  test::Scatter random(45);
  std::vector<std::string> all = whole_programs();
  all.insert(all.end(), open_programs().begin(), open_programs().end());
  for (int round = 0; round < 20'000; ++round) {
    std::string text = with_ends(all[random.below(all.size())] + all[random.below(all.size())]);
    for (std::size_t change = 0; change < 1 + random.below(6); ++change) {
      const std::size_t at = random.below(text.size());
      const std::size_t kind = random.below(4);
      if (kind == 0) text[at] = static_cast<char>(random.below(256));
      if (kind == 1) text.erase(at, random.below(20));
      if (kind == 2) text.insert(at, text.substr(random.below(text.size()), random.below(20)));
      if (kind == 3) text[at] = "0123456789+-.QXYZ\";~/\r\n"[random.below(23)];
    }
    const ReadOutcome outcome = outcome_of(text);
    EXPECT_TRUE(outcome.toolpath || !outcome.errors.empty());
  }
}

}  // namespace
}  // namespace gouge::klartext::klartext_mutation_test
