#include "postproc/cldata/language/arguments.h"

#include <gtest/gtest.h>

#include <string>

namespace gouge::arguments_test {
namespace {

bool has_blank(const std::string& text) {
  Statement statement;
  statement.word = Word::go_to;
  statement.pieces = {text};
  return has_blank_in_number(statement);
}

TEST(BlankInNumber, IsFoundWhateverTheBlankIs) {
  for (const char blank : {' ', '\t', '\r', '\f', '\v', '\x1a'}) {
    const std::string b(1, blank);
    EXPECT_TRUE(has_blank("/ 1" + b + "2, 3, 4")) << static_cast<int>(blank);
    EXPECT_FALSE(has_blank("/" + b + "1," + b + "2" + b + "," + b + "3" + b)) << static_cast<int>(blank);
    EXPECT_FALSE(has_blank("/1,2,3" + b + b)) << static_cast<int>(blank);
  }
  EXPECT_TRUE(has_blank("/ 1.0, 3, 4 5"));
  EXPECT_TRUE(has_blank("/\t1.5, 2 .5, 3")) << "a blank beside a tab elsewhere";
  EXPECT_FALSE(has_blank("/ 1.5 , 2.5 , 3 "));
  EXPECT_FALSE(has_blank(""));
  EXPECT_FALSE(
      has_blank("/1,\x01"
                "2,3"))
      << "a control character that is no blank";
  for (std::size_t before = 0; before < 70; ++before) {
    const std::string text = "/" + std::string(before, '7');
    EXPECT_TRUE(has_blank(text + "1 2, 3, 4")) << before;
    EXPECT_FALSE(has_blank(text + "1, 2, 3, 4")) << before;
  }
}

}  // namespace
}  // namespace gouge::arguments_test
