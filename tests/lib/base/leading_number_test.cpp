#include "lib/base/leading_number.h"

#include <gtest/gtest.h>

#include <charconv>
#include <string>

#include "tests/support/scatter.h"

namespace gouge::leading_number_test {
namespace {

TEST(LeadingNumber, EndsAtTheFirstOtherCharacter) {
  EXPECT_EQ(leading_number("12.5,3").length, 4U);
  EXPECT_DOUBLE_EQ(leading_number("12.5,3").value, 12.5);
  EXPECT_EQ(leading_number("-.5 ").length, 3U);
  EXPECT_EQ(leading_number("7.").length, 2U);
  EXPECT_EQ(leading_number("1.2.3").length, 3U);
  EXPECT_EQ(leading_number("1E5").length, 1U);
}

TEST(LeadingNumber, NeedsADigit) {
  for (const char* const text : {"", "-", ".", "-.", "+1", "x", "--1", ",1"})
    EXPECT_EQ(leading_number(text).length, 0U);
}

TEST(LeadingNumber, LeavesNumbersOfTooManyDigits) {
  EXPECT_EQ(leading_number("9007199254740993").length, 0U);        // 2^53 + 1
  EXPECT_EQ(leading_number("0.00000000000000000001").length, 0U);  // the power of ten would have to be exact
  EXPECT_EQ(leading_number("18446744073709551617").length, 0U);    // 2^64 + 1 overflows to 1
}

TEST(LeadingNumber, HasTheNearestValue) {
  test::Scatter random(1);
  std::size_t read = 0;
  for (int i = 0; i < 200000; ++i) {
    std::string text = (random.is(0.5) ? "-" : "") + std::to_string(random.next() >> random.below(64));
    const std::size_t digits = text.size() - (text.front() == '-' ? 1 : 0);
    if (random.is(0.9)) text.insert(text.size() - random.below(digits + 1), ".");
    const LeadingNumber number = leading_number(text);
    if (number.length == 0) continue;
    ++read;
    double expected = 0;
    std::from_chars(text.data(), text.data() + text.size(), expected);
    ASSERT_EQ(number.length, text.size()) << text;
    ASSERT_EQ(number.value, expected) << text;
  }
  EXPECT_GT(read, 100000U);
}

}  // namespace
}  // namespace gouge::leading_number_test
