#include "postproc/cldata/lexing/lexer.h"

#include <gtest/gtest.h>

#include <string>

#include "postproc/cldata/language/arguments.h"

namespace gouge::lexer_test {
namespace {

std::vector<Statement> statements_of(std::string_view text) {
  Lexer lexer(text);
  std::vector<Statement> result;
  Statement statement;
  while (lexer.next(statement)) result.push_back(statement);
  return result;
}

std::vector<std::string> arguments_of(std::string_view text) {
  std::vector<Argument> arguments;
  split_arguments(statements_of(text).at(0), arguments);
  std::vector<std::string> result;
  for (const Argument& argument : arguments) result.emplace_back(argument.text);
  return result;
}

using Words = std::vector<std::string>;

TEST(Lexer, ADollarAtTheEndJoinsTheNextLine) {
  const std::string text = "CUTTER/ 10.0,  0.0,$\r\n   5.0,  $\n 6\nRAPID\n";
  const auto all = statements_of(text);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].line, 1u);
  EXPECT_EQ(all[1].line, 4u);
  EXPECT_EQ(all[0].first_byte, 0u);
  EXPECT_EQ(all[0].last_byte, text.find("RAPID"));
  EXPECT_EQ(arguments_of(text), (Words{"10.0", "0.0", "5.0", "6"}));
}

TEST(Lexer, ACommentAmidAStatementDoesNotEndIt) {
  EXPECT_EQ(arguments_of("GOTO/1,2,$\n$$ a comment\n\n3\n"), (Words{"1", "2", "3"}));
}

TEST(Lexer, ACommentEndsTheLineButNotTextOfPprint) {
  EXPECT_EQ(arguments_of("GOTO/1,2,3 $$ GOTO/4,5,6"), (Words{"1", "2", "3"}));
  const auto all = statements_of("PPRINT/costs 5 $$, CUTTER/8 $\nRAPID");
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].word, Word::pprint);
  EXPECT_EQ(all[0].pieces.front(), "costs 5 $$, CUTTER/8 $");
  EXPECT_EQ(all[1].word, Word::rapid);
}

TEST(Lexer, FreeTextNeedsNoDelimiter) {
  EXPECT_EQ(statements_of("pprint*****pocket***").at(0).word, Word::pprint);
  EXPECT_EQ(statements_of("PARTNO PART TO BE = MACHINED").at(0).word, Word::free_text);
  EXPECT_EQ(statements_of("TOOL PATH/A/B,TOOL,C").at(0).word, Word::tool_path);
}

TEST(Lexer, AFileThatEndsAfterADollarIsReported) {
  EXPECT_TRUE(statements_of("GOTO/1,2,$").at(0).is_unterminated);
  EXPECT_TRUE(statements_of("GOTO/1,2,$\n\n").at(0).is_unterminated);
  EXPECT_FALSE(statements_of("GOTO/1,2,$\n3").at(0).is_unterminated);
}

TEST(Lexer, AByteOrderMarkIsNoWord) { EXPECT_EQ(statements_of("\xef\xbb\xbfRAPID\n").at(0).word, Word::rapid); }

TEST(Lexer, CreosDataCommentsContinueOnPlainLines) {
  const auto all = statements_of("$$-> CSYS / 1, 0,  $\n   0, 1\nRAPID\n");
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].word, Word::comment);
  EXPECT_EQ(all[0].pieces.size(), 2u);
}

TEST(Arguments, BlanksCommasAndBracketsSeparate) {
  EXPECT_EQ(arguments_of("GOTO  /   98.0,-1.0, 3"), (Words{"98.0", "-1.0", "3"}));
  EXPECT_EQ(arguments_of("GOTO/-10.0 5.0 0.0"), (Words{"-10.0", "5.0", "0.0"}));
  EXPECT_EQ(arguments_of("CUTTER/ 6.0,0.0,"), (Words{"6.0", "0.0"}));
  EXPECT_EQ(arguments_of("ROTABL/ 0.0,,TABLE"), (Words{"0.0", "", "TABLE"}));
  EXPECT_EQ(arguments_of("TLON,GOFWD/(CIRCLE/1,2,3,$\n4),ON,(LINE/1,2,3,$\n5,6,7)"),
            (Words{"GOFWD", "CIRCLE", "1", "2", "3", "4", "ON", "LINE", "1", "2", "3", "5", "6", "7"}));
}

TEST(Words, AreFoundInAnyCase) {
  EXPECT_EQ(find_word("goto"), Word::go_to);
  EXPECT_EQ(find_word("END-OF-PATH"), Word::end_of_path);
  EXPECT_EQ(find_word("GOT"), Word::unknown);
  EXPECT_EQ(find_word(""), Word::unknown);
}

}  // namespace
}  // namespace gouge::lexer_test
