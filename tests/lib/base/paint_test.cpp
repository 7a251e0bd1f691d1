#include "lib/base/paint.h"

#include <gtest/gtest.h>

#include "tests/support/plain_text.h"

namespace gouge::paint_test {
namespace {

TEST(Paint, IsAroundTheTextOrNotThere) {
  EXPECT_EQ(painted("gouge:", Paint::error, true), "\x1b[1;31mgouge:\x1b[0m");
  EXPECT_EQ(painted("gouge:", Paint::error, false), "gouge:");
  EXPECT_EQ(painted("", Paint::error, true), "") << "nothing to colour";
}

TEST(Paint, OfADiagnosticChangesNothingElse) {
  for (const Diagnostic& d :
       {make_error("usage", "--x 'y': error: expected z"), make_warning("a-b", "m: n", "dir: name/p.apt", 12),
        make_note("", "no code", "f"), make_error("c", "", "f"), make_error("c", "bad \x1b[31m text", "\x1b.apt", 3),
        make_error("c", std::string(100'000, 'x') + "; expected z", "f", 1)}) {
    const std::string coloured = painted_text(d);
    EXPECT_EQ(without_colours(coloured), to_text(d));
    const std::string word = d.severity == Severity::error     ? "\x1b[1;31merror:\x1b[0m"
                             : d.severity == Severity::warning ? "\x1b[1;35mwarning:\x1b[0m"
                                                               : "\x1b[1;36mnote:\x1b[0m";
    EXPECT_NE(coloured.find(word), std::string::npos) << coloured;
  }
}

TEST(DiagnosticText, ALongMessageKeepsItsBeginningAndWhatIsExpected) {
  std::string letters;
  for (int i = 0; i < 100'000; ++i) letters += "\u00e4";
  for (const char* before : {"", "x"}) {
    const std::string text = to_text(make_error("c", before + letters + "; expected z", "f", 1));
    EXPECT_LT(text.size(), 3000U);
    EXPECT_TRUE(text.starts_with(std::string("f:1: error: ") + before + "\u00e4")) << text;
    EXPECT_TRUE(text.ends_with("\u00e4; expected z [c]")) << text;
    EXPECT_NE(text.find("\u00e4 ... \u00e4"), std::string::npos) << "no letter is cut in half";
  }
}

}  // namespace
}  // namespace gouge::paint_test
