// Blocks, numbers and expressions.
#include <gtest/gtest.h>

#include "postproc/gcode/lexing/block_lexer.h"

namespace gouge::lexer_test {
namespace {

constexpr GcodeSyntax kLinuxcnc = {.has_o_words = true, .has_named_variables = true, .has_equal_tolerance = true};
constexpr GcodeSyntax kFanuc = {
    .numbers = NumberRule::by_point, .has_semicolon_comments = false, .has_macros = true, .binds_and_as_times = true};

GcodeBlock block_of(std::string_view line, const GcodeSyntax& syntax = kLinuxcnc) {
  GcodeVariables variables;
  variables.set("1", 2, false);
  variables.set("101", 0.5, false);
  variables.set("<r>", 60, false);
  GcodeBlock block;
  read_gcode_block(line, syntax, variables, block);
  return block;
}

double value_of(const std::string& text, const GcodeSyntax& syntax = kLinuxcnc) {
  const GcodeBlock block = block_of("X" + text, syntax);
  EXPECT_EQ(block.error, "") << text;
  return block.words.empty() ? kUnknownValue : block.words[0].value;
}

TEST(BlockLexer, ReadsWordsNumbersAndComments) {
  const GcodeBlock block = block_of("/N10 g1 X 1.5y-.25 Z+3 (to the wall) F200 ; fast");
  ASSERT_EQ(block.words.size(), 5u);
  EXPECT_EQ(block.error, "");
  EXPECT_TRUE(block.is_skippable);
  EXPECT_EQ(block.number, 10);
  EXPECT_EQ(block.words[0].letter, 'G');
  EXPECT_EQ(block.words[1].value, 1.5);
  EXPECT_EQ(block.words[2].letter, 'Y');
  EXPECT_EQ(block.words[2].value, -0.25);
  EXPECT_EQ(block.words[3].value, 3);
  EXPECT_FALSE(block.words[3].has_point);
  EXPECT_TRUE(block.words[2].has_point);
  EXPECT_EQ(block.comment, "fast");
}

TEST(BlockLexer, NumbersAreThoseOfTheStandardLibrary) {
  for (const char* text : {"0.1", "123.456789", "-76.543210987654", "100000.00001", "3.", ".5", "0.3333333333333333",
                           "123456789012345678", "0.000000000000000001"}) {
    EXPECT_EQ(value_of(text), std::strtod(text, nullptr)) << text;
  }
}

TEST(BlockLexer, EvaluatesExpressions) {
  EXPECT_EQ(value_of("[1+2*3]"), 7);
  EXPECT_EQ(value_of("[[1+2]*3]"), 9);
  EXPECT_EQ(value_of("[2**3-1]"), 7);
  EXPECT_EQ(value_of("-#1"), -2);
  EXPECT_EQ(value_of("[#<r>/#1]"), 30);
  EXPECT_NEAR(value_of("[60*[cos[60]]]"), 30, 1e-12);
  EXPECT_NEAR(value_of("[atan[1]/[1]]"), 45, 1e-12);
  EXPECT_EQ(value_of("[5 mod 3]"), 2);
  EXPECT_EQ(value_of("[#1 gt 1]"), 1);
  EXPECT_EQ(value_of("[1 eq 2]"), 0);
  EXPECT_EQ(value_of("[1+1 EQ 2]", kFanuc), 1);
}

TEST(BlockLexer, DoesNotKnowValuesOfTheControl) {
  for (const char* text : {"#5021", "[#5021+1]", "#<_x>", "[1/0]", "[1 eq 1.00001]", "[-5 mod 3]", "[round[-0.5]]"})
    EXPECT_TRUE(std::isnan(value_of(text))) << text;
}

TEST(BlockLexer, RefusesWhatIsNoBlock) {
  for (const char* line : {"G1 X", "G1 X1 2", "X1..2", "X1 (no end", "G1 X[1+2", "X[foo[1]]", "=5", "#5", "G1 X1,5",
                           "TRAORI", "G1 X--", "N G1"}) {
    EXPECT_NE(block_of(line).error, "") << line;
  }
  EXPECT_NE(block_of("G1 X1; X2", kFanuc).error, "") << "the next block after the end of this one";
}

TEST(BlockLexer, TakesAssignmentsFromTheValuesBeforeTheBlock) {
  const GcodeBlock block = block_of("#1=5 #<a b>=[#1+1]");
  ASSERT_EQ(block.assignments.size(), 2u);
  EXPECT_EQ(block.assignments[0].value, 5);
  EXPECT_EQ(block.assignments[1].variable, "<ab>");
  EXPECT_EQ(block.assignments[1].value, 3);
}

}  // namespace
}  // namespace gouge::lexer_test
