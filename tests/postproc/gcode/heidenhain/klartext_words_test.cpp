#include <gtest/gtest.h>

#include <cmath>

#include "postproc/gcode/heidenhain/klartext_block.h"
#include "postproc/gcode/heidenhain/klartext_table.h"
#include "postproc/gcode/heidenhain/klartext_words.h"

namespace gouge::klartext_words_test {
namespace {

std::string words_of(const std::string& text, const QParameters& parameters = {}) {
  std::vector<KlartextWord> words;
  const std::string wrong = read_klartext_words(text, parameters, words);
  if (!wrong.empty()) return "wrong: " + wrong;
  std::string all;
  for (const KlartextWord& word : words) all += (all.empty() ? "" : "|") + word_text(word);
  return all;
}

double formula(const std::string& text) {
  QParameters parameters;
  parameters.set("Q2", 10);
  parameters.set("QL3", -4);
  const FormulaValue value = read_formula(text, parameters);
  EXPECT_EQ(value.error, "") << text;
  return value.value;
}

TEST(KlartextWords, HaveNamesSignsNumbersAndTexts) {
  EXPECT_EQ(words_of("X+12.5 IY-3 FMAX DR- R0 M09"), "X12.5|IY-3|FMAX|DR-|R0|M9");
  EXPECT_EQ(words_of("Z 25.000 F 240 F MAX"), "Z25|F240|F|MAX");
  EXPECT_EQ(words_of("T \"MILL D10\" Z S3000"), "T \"MILL D10\"|Z|S3000");
  EXPECT_EQ(words_of("REFPNT TIP-TIP"), "REFPNT|TIP-|TIP");
}

TEST(KlartextWords, TakeValuesFromParameters) {
  QParameters parameters;
  parameters.set("Q5", 7.5);
  EXPECT_EQ(words_of("X+Q5 Y-Q5 IZQ5 FQ5", parameters), "X7.5|Y-7.5|IZ7.5|F7.5");
  EXPECT_EQ(words_of("X+Q6", parameters), "XQ6");  // not known
}

TEST(KlartextWords, RefuseWhatIsNoWord) {
  for (const char* const text : {"X+12,5", "X+1.2.3", "# X1", "5", "\"A\"", "X+.", "T \"A", "X12\xc3\xa4"})
    EXPECT_EQ(words_of(text).substr(0, 6), "wrong:") << text;
}

TEST(KlartextWords, NameADecimalComma) {
  EXPECT_EQ(words_of("X+12,5 FMAX"), "wrong: ',5 FMAX' is not understood (a decimal comma: write a point)");
  EXPECT_EQ(words_of("FMAX ,5"), "wrong: ',5' is not understood");
  EXPECT_EQ(words_of("X+12 , Y5"), "wrong: ', Y5' is not understood");
}

TEST(KlartextWords, RefuseParametersOfTheControl) {
  QParameters parameters;
  parameters.set("Q120", 5);
  EXPECT_TRUE(std::isnan(parameters.value("Q120")));
  EXPECT_TRUE(std::isnan(parameters.value("Q1")));
}

TEST(KlartextFormula, FollowsTheOrderOfOperations) {
  EXPECT_DOUBLE_EQ(formula("5 * 3 + 2 * 10"), 35);  // the manual's example
  EXPECT_DOUBLE_EQ(formula("SQ 10 - 3^3"), 73);     // the manual's example
  EXPECT_DOUBLE_EQ(formula("(Q2 + 2) / -QL3"), 3);
  EXPECT_DOUBLE_EQ(formula("SIN 30 + COS(60)"), 1);
  EXPECT_DOUBLE_EQ(formula("INT -3.7"), -3);
  EXPECT_DOUBLE_EQ(formula("SQRT 16 * PI"), 4 * std::acos(-1.0));
}

TEST(KlartextFormula, IsNotKnownWhereNoManualStatesIt) {
  for (const char* const text : {"-3^2", "SQ 2^3", "2^3^2", "1 / 0", "Q9 + 1", "SQRT -1", "LN 0"})
    EXPECT_TRUE(std::isnan(formula(text))) << text;
}

TEST(KlartextFormula, RefusesOtherText) {
  for (const char* const text : {"", "3 +", "(3", "SINH 3", "3 4", "Q", "5 % 2"})
    EXPECT_NE(read_formula(text, {}).error, "") << text;
  EXPECT_NE(read_formula(std::string(200, '(') + "1", {}).error, "");
}

TEST(KlartextBlock, HasNeitherNumberNorComment) {
  EXPECT_EQ(read_klartext_line("12 l x+1 ; to the corner").text, "L X+1");
  EXPECT_EQ(read_klartext_line("7 * - ROUGHING").comment, "ROUGHING");
  EXPECT_EQ(read_klartext_line("TOOL CALL \"Mill;1\" Z").text, "TOOL CALL \"Mill;1\" Z");
  EXPECT_EQ(read_klartext_line("\xef\xbb\xbf"
                               "0 BEGIN PGM A MM")
                .text,
            "BEGIN PGM A MM");
  EXPECT_TRUE(read_klartext_line("/12 L X+1").is_skippable);
  EXPECT_TRUE(read_klartext_line("12 /L X+1").is_skippable);
}

TEST(KlartextBlock, IsLostByAReturnInACommentBeforeABlock) {
  EXPECT_EQ(read_klartext_line("5 ; mill\r quick, of steel 60.0 MM").error, "");
  for (const char* const text : {"5 ; tool\r6 L Z-5", "; hi\rX+50 R0", "; hi\rIX+50", "; hi\r12 IX+50",
                                 "; hi\rPR+50 PA+0", "; hi\r x Q5", "; hi\rIPA+5 DR+", "L X+1 ; hi\rCYCLE DEF 7.1 X+5",
                                 "; a\rmm, of steel", "L X+1 ; a\r l Z-5", ";a\rQ1 = 5", ";a\r b\r M3"})
    EXPECT_NE(read_klartext_line(text).error, "") << text;
}

TEST(KlartextTable, HasEachNumberOnce) {
  int before = -1;
  for (const KlartextFunction& row : klartext_functions()) {
    EXPECT_GT(row.number, before);
    before = row.number;
  }
  before = -1;
  for (const KlartextCycle& row : klartext_cycles()) {
    EXPECT_GT(row.number, before);
    before = row.number;
  }
}

}  // namespace
}  // namespace gouge::klartext_words_test
