#include "lib/base/paint.h"

#include <gtest/gtest.h>

namespace gouge {
namespace {

TEST(Paint, IsAroundTheTextOrNotThere) {
  EXPECT_EQ(painted("gouge:", Paint::error, true), "\x1b[1;31mgouge:\x1b[0m");
  EXPECT_EQ(painted("gouge:", Paint::error, false), "gouge:");
  EXPECT_EQ(painted("", Paint::error, true), "") << "nothing to colour";
}

TEST(Paint, OfADiagnosticChangesNothingElse) {
  for (const Diagnostic& d :
       {make_error("usage", "--x 'y': error: expected z"), make_warning("a-b", "m: n", "dir: name/p.apt", 12),
        make_note("", "no code", "f"), make_error("c", "", "f"), make_error("c", "bad \x1b[31m text", "\x1b.apt", 3)}) {
    const std::string coloured = painted_text(d);
    std::string plain;
    for (std::size_t at = 0; at < coloured.size(); ++at) {
      if (coloured[at] == '\x1b') {
        at = coloured.find('m', at);
      } else {
        plain += coloured[at];
      }
    }
    EXPECT_EQ(plain, to_text(d));
    const std::string word = d.severity == Severity::error     ? "\x1b[1;31merror:\x1b[0m"
                             : d.severity == Severity::warning ? "\x1b[1;35mwarning:\x1b[0m"
                                                               : "\x1b[1;36mnote:\x1b[0m";
    EXPECT_NE(coloured.find(word), std::string::npos) << coloured;
  }
}

}  // namespace
}  // namespace gouge
