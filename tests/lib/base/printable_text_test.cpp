#include "lib/base/printable_text.h"

#include <gtest/gtest.h>

#include "lib/base/diagnostic.h"

namespace gouge::printable_text_test {
namespace {

TEST(Printable, LeavesWhatIsSeenAsItIs) {
  for (const char* text :
       {"", "part.apt", "C:\\parts\\x1b", "Torusfräser Ø12 – Ж", "東京 球頭", "é combined", "😀", "\xEF\xBF\xBD"})
    EXPECT_EQ(printable(text), text);
}

TEST(Printable, EscapesWhatATerminalObeysOrHides) {
  EXPECT_EQ(printable(std::string_view("a\0b", 3)), "a\\x00b");
  EXPECT_EQ(printable("a\r\nb\tc\x7F"), "a\\r\\nb\\tc\\x7f");
  EXPECT_EQ(printable("\x1B[31mred\x1B]0;title\x07"), "\\x1b[31mred\\x1b]0;title\\x07");
  EXPECT_EQ(printable("\xC2\x9B"
                      "31m\xC2\x85"),
            "\\u009b31m\\u0085")
      << "C1 controls";
  EXPECT_EQ(printable("\u202Egpj.exe\u2066\u200E\u061C"), "\\u202egpj.exe\\u2066\\u200e\\u061c") << "directions";
  EXPECT_EQ(printable("a\u200Bb\u200D\uFEFF\u00AD\u2028\u2029\u3164"),
            "a\\u200bb\\u200d\\ufeff\\u00ad\\u2028\\u2029\\u3164");
  EXPECT_EQ(printable("\U000E0041"), "\\U000e0041");
}

TEST(Printable, EscapesWhatIsNotUtf8ByteByByte) {
  EXPECT_EQ(printable("\xFF\x9B"
                      "31m"),
            "\\xff\\x9b31m");
  EXPECT_EQ(printable("Fr\xE4ser"), "Fr\\xe4ser");
  EXPECT_EQ(printable("\xC0\x8A"), "\\xc0\\x8a") << "an overlong line feed";
  EXPECT_EQ(printable("\xE0\x80\x8A"), "\\xe0\\x80\\x8a") << "a longer one";
  EXPECT_EQ(printable("\xED\xA0\x80"), "\\xed\\xa0\\x80") << "a surrogate";
  EXPECT_EQ(printable("cut \xE6\x97"), "cut \\xe6\\x97");
}

TEST(Printable, DoneTwiceIsTheSame) {
  std::string bytes;
  for (int high = 0; high < 256; high += 3)
    for (int low = 0; low < 256; low += 7) bytes += {static_cast<char>(high), static_cast<char>(low)};
  const std::string once = printable(bytes);
  EXPECT_EQ(printable(once), once);
  EXPECT_EQ(once.find_first_of(std::string_view("\0\n\r\x1B\x07\x7F", 6)), std::string::npos);
}

TEST(DisplayWidth, CountsColumnsNotBytes) {
  EXPECT_EQ(display_width("ball D10"), 8U);
  EXPECT_EQ(display_width("Torusfräser"), 11U);
  EXPECT_EQ(display_width("e\u0301"), 1U) << "a combining accent";
  EXPECT_EQ(display_width("東京"), 4U);
  EXPECT_EQ(display_width("\x1b[1;31mgouge:\x1b[0m"), 6U) << "colours";
  EXPECT_EQ(padded("東京", 6), "東京  ");
  EXPECT_EQ(padded("fräsen", 4), "fräsen");
  EXPECT_EQ(padded("a\nb", 6), "a\\nb  ");
}

TEST(Diagnostic, IsOneLineWhateverItsNamesHold) {
  const Diagnostic forged = make_error("stl-empty", "no \x1B[2J\nok.apt:1: clean", "a\nb.stl: clean\r", 3);
  EXPECT_EQ(to_text(forged), "a\\nb.stl: clean\\r:3: error: no \\x1b[2J\\nok.apt:1: clean [stl-empty]");
}

}  // namespace
}  // namespace gouge::printable_text_test
