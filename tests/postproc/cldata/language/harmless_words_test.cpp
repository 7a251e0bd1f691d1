#include "postproc/cldata/language/harmless_words.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "postproc/cldata/language/words.h"
#include "tests/support/source_folder.h"

namespace gouge::harmless_words_test {
namespace {

bool is_harmless_statement(std::string_view word, std::string_view text) {
  Statement statement;
  statement.pieces.push_back(text);
  std::vector<Argument> arguments;
  split_arguments(statement, arguments);
  return is_harmless(word, arguments);
}

TEST(HarmlessWords, HaveTheArgumentsOfTheirRows) {
  EXPECT_TRUE(is_harmless_statement("COOLNT", "FLOOD"));
  EXPECT_TRUE(is_harmless_statement("coolnt", "flood"));
  EXPECT_TRUE(is_harmless_statement("COOLNT", ""));
  EXPECT_FALSE(is_harmless_statement("COOLNT", "BLURB"));
  EXPECT_FALSE(is_harmless_statement("COOLNT", "ON,0,0,5")) << "a position whose line end was lost";
  EXPECT_FALSE(is_harmless_statement("COOLNT", "ON,,"));
  EXPECT_FALSE(is_harmless_statement("BLURB", ""));
}

TEST(HarmlessWords, HaveAsManyNegativeNumbersAsTheirRowsSay) {
  EXPECT_TRUE(is_harmless_statement("SPINDL", "RPM,-500,CLW"));
  EXPECT_FALSE(is_harmless_statement("SPINDL", "-500,2"));
  EXPECT_FALSE(is_harmless_statement("SPINDL", "CLW,0,0,5"));
  EXPECT_TRUE(is_harmless_statement("SPINDL", "70,SFM,CLW,MAXRPM,3000,RANGE,2"));
  EXPECT_FALSE(is_harmless_statement("DELAY", "-2"));
  EXPECT_TRUE(is_harmless_statement("BOX", "-1,-2,-3,4,5,6"));
}

TEST(HarmlessWords, HaveNamesThatAreNoWordsOfAnyDialect) {
  EXPECT_TRUE(is_harmless_statement("MACHIN", "UNCX01, 1"));
  EXPECT_TRUE(is_harmless_statement("MACHIN", "Haas_UMC-750,1"));
  EXPECT_FALSE(is_harmless_statement("MACHIN", "POST,1,OFF"));
  EXPECT_FALSE(is_harmless_statement("MACHIN", "POST GOTO"));
  EXPECT_FALSE(is_harmless_statement("MACHIN", "POST INSERT G68"));
  EXPECT_FALSE(is_harmless_statement("MACHIN", "#1=5"));
  EXPECT_FALSE(is_harmless_statement("MACHIN", "A B C D E F G"));
}

TEST(HarmlessWords, MayNeedAWord) {
  EXPECT_TRUE(is_harmless_statement("TCP", "ON"));
  EXPECT_FALSE(is_harmless_statement("TCP", "OFF"));
  EXPECT_FALSE(is_harmless_statement("TCP", ""));
  EXPECT_FALSE(is_harmless_statement("PPFUN", "43,2"));
}

// ARCSLP of Mori and CLEARP are read for what they state of motion, and harmless in their other forms.
TEST(HarmlessWords, AreNoWordsThatAreRead) {
  for (const HarmlessWord& row : harmless_words()) {
    const bool is_read_too = row.word == "ARCSLP" || row.word == "CLEARP";
    EXPECT_EQ(find_word(row.word) == Word::harmless, !is_read_too) << row.word;
    EXPECT_FALSE(row.source.empty()) << row.word;
  }
}

TEST(HarmlessWords, StandInTheirDocument) {
  std::ifstream stream(std::string(source_folder()) + "/docs/formats/harmless_words.md");
  const std::string page{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  for (const HarmlessWord& row : harmless_words()) {
    const std::size_t at = page.find("\n| `" + std::string(row.word) + "` |");
    ASSERT_NE(at, std::string::npos) << row.word;
    const std::string line = page.substr(at + 1, page.find('\n', at + 1) - at - 1);
    EXPECT_TRUE(line.ends_with("| " + std::string(row.source) + " |")) << line;
    for (std::string_view minors = row.minors; !minors.empty();) {
      const std::size_t end = std::min(minors.find(' '), minors.size());
      EXPECT_NE(line.find("`" + std::string(minors.substr(0, end)) + "`"), std::string::npos) << line;
      minors.remove_prefix(std::min(end + 1, minors.size()));
    }
  }
}

}  // namespace
}  // namespace gouge::harmless_words_test
