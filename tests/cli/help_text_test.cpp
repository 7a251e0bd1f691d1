#include "cli/options/help_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <vector>

#include "cli/options/short_help.h"
#include "cli/program.h"
#include "cli/run.h"
#include "lib/base/printable_text.h"

namespace gouge::help_text_test {
namespace {

TEST(HelpText, LinesBreakAtBlanksAndExamplesStayWhole) {
  EXPECT_EQ(wrapped("one two three", 8, 0), "one two\nthree");
  EXPECT_EQ(wrapped("one two three", 8, 4), "one\n    two\n    three");
  EXPECT_EQ(wrapped("Example:\n  one two three\n\nfour five six", 9, 0), "Example:\n  one two three\n\nfour five\nsix");
  EXPECT_EQ(wrapped("unbreakable a", 4, 0), "unbreakable\na");
  EXPECT_EQ(wrapped("", 4, 0), "");
}

TEST(HelpText, EveryHelpFitsIntoEightyColumns) {
  const std::vector<std::vector<const char*>> commands = {{},
                                                          {"check"},
                                                          {"correct"},
                                                          {"mesh"},
                                                          {"tool"},
                                                          {"tool", "list"},
                                                          {"tool", "show"},
                                                          {"tool", "draw"},
                                                          {"tool", "import"},
                                                          {"path"},
                                                          {"path", "info"},
                                                          {"path", "convert"},
                                                          {"path", "plot"},
                                                          {"path", "laws"},
                                                          {"path", "joints"},
                                                          {"batch"},
                                                          {"merge"},
                                                          {"machine"},
                                                          {"machine", "list"},
                                                          {"machine", "show"},
                                                          {"machine", "check"},
                                                          {"machine", "draw"},
                                                          {"accept"},
                                                          {"clash"},
                                                          {"compare"},
                                                          {"verify"},
                                                          {"config"},
                                                          {"init"},
                                                          {"help"},
                                                          {"man"},
                                                          {"completion"},
                                                          {"schema"}};
  for (const std::vector<const char*>& command : commands) {
    std::vector<const char*> argv = {"/usr/bin/gougecheck"};
    argv.insert(argv.end(), command.begin(), command.end());
    argv.push_back("--help");
    std::ostringstream out, err;
    EXPECT_EQ(run(static_cast<int>(argv.size()), argv.data(), out, err), 0);
    std::istringstream lines(out.str());
    std::size_t count = 0;
    for (std::string line; std::getline(lines, line); ++count) EXPECT_LE(line.size(), 80U) << line;
    EXPECT_GT(count, 5U);
    EXPECT_EQ(out.str().find("/usr/bin"), std::string::npos) << "the program is called by its name";
  }
}

TEST(HelpText, CommandsWithManyOptionsShowTheUsualOnesOnAPage) {
  for (const char* command : {"check", "correct", "batch"}) {
    const char* argv[] = {"gougecheck", command, "--help"};
    std::ostringstream out, err;
    EXPECT_EQ(run(3, argv, out, err), 0);
    const std::string text = out.str();
    EXPECT_LE(std::ranges::count(text, '\n'), 30) << text;
    EXPECT_NE(text.find("--part FILE"), std::string::npos) << text;
    EXPECT_NE(text.find("All options: gougecheck help " + std::string(command) + " --all\n"), std::string::npos)
        << text;
  }
}

TEST(HelpText, NarrowTerminalsGetNarrowPages) {
  for (const std::size_t width : {30U, 48U, 71U, 200U}) {
    const HelpColumns columns(width);
    Program program(columns);
    std::string text = program.app.help() + short_help(*program.app.get_subcommand("check"), columns);
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      const bool is_example =
          line.find("  gougecheck") != std::string::npos || line.find("[OPTIONS") != std::string::npos;
      const bool is_one_word = line.find(' ', line.find_first_not_of(' ')) == std::string::npos;
      EXPECT_TRUE(is_example || is_one_word || line.starts_with("  -") ||
                  line.size() <= std::min(width, std::size_t{80}))
          << width << ": " << line;
    }
  }
}

TEST(HelpText, TypesChoicesDefaultsAndNeedsAreNamed) {
  const char* argv[] = {"gougecheck", "help", "check", "--all"};
  std::ostringstream out, err;
  EXPECT_EQ(run(4, argv, out, err), 0);
  for (const char* text : {"--rapid straight|dogleg|skip", "--tool N=NAME", "--tolerance LENGTH", "[default: 0.01mm]",
                           "--part FILE", "[required]", "\nTerminal:\n", "\nOutput:\n", "--threads N"})
    EXPECT_NE(out.str().find(text), std::string::npos) << text << out.str();
  for (const char* text : {"TEXT", "UINT", "FLOAT", "REQUIRED"})
    EXPECT_EQ(out.str().find(text), std::string::npos) << text;
}

TEST(HelpText, ConvertOffersOnlyDialectsThatCanBeWritten) {
  const char* argv[] = {"gougecheck", "completion", "fish"};
  std::ostringstream out, err;
  EXPECT_EQ(run(3, argv, out, err), 0);
  std::istringstream lines(out.str());
  std::size_t read = 0, written = 0;
  for (std::string line; std::getline(lines, line);) {
    const bool has_nci = line.find("nx-clsf") != std::string::npos && line.find("mastercam-nci") != std::string::npos;
    if (line.find(" -l dialect ") != std::string::npos) {
      EXPECT_TRUE(has_nci) << line;
      ++read;
    } else if (line.find(" -l to ") != std::string::npos) {
      EXPECT_NE(line.find("nx-clsf"), std::string::npos) << line;
      EXPECT_FALSE(has_nci) << line;
      ++written;
    }
  }
  EXPECT_GT(read, 1U);
  EXPECT_EQ(written, 1U);
}

}  // namespace
}  // namespace gouge::help_text_test
