#include "cli/options/parse_errors.h"

#include <gtest/gtest.h>

#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "cli/run.h"
#include "lib/base/exit_code.h"

namespace gouge::parse_errors_test {
namespace {

// Message of the program for a wrong command line, without its frame; fails the test where it is not one such line.
std::string said(const std::vector<const char*>& words) {
  std::vector<const char*> argv = {"/usr/bin/gougecheck"};
  argv.insert(argv.end(), words.begin(), words.end());
  std::ostringstream out, err;
  EXPECT_EQ(run(static_cast<int>(argv.size()), argv.data(), out, err), kExitUsage);
  EXPECT_EQ(out.str(), "");
  const std::string start = "gougecheck: error: ", end = " [usage]\n", text = err.str();
  EXPECT_TRUE(text.starts_with(start) && text.ends_with(end)) << text;
  if (text.size() < start.size() + end.size()) return text;
  return text.substr(start.size(), text.size() - start.size() - end.size());
}

TEST(ParseErrors, AnUnknownOptionIsNamedWithTheOneThatWasMeant) {
  EXPECT_EQ(said({"check", "a.apt", "--part", "p.stl", "--tolerence", "0.02"}),
            "gougecheck check has no option '--tolerence'; did you mean --tolerance?");
  EXPECT_EQ(
      said({"check", "--", "-dash.apt", "--part", "p.stl"}),
      "gougecheck check: only files may stand behind '--'; expected the options before it: gougecheck check OPTIONS "
      "-- FILE");
  EXPECT_EQ(said({"check", "a.apt", "--prat=p.stl"}), "gougecheck check has no option '--prat'; did you mean --part?");
  EXPECT_EQ(said({"check", "a.apt", "--part", "p.stl", "--toler", "1"}),
            "gougecheck check has no option '--toler'; did you mean --tolerance?");
  EXPECT_EQ(said({"check", "a.apt", "--part", "p.stl", "--colour"}),
            "gougecheck check has no option '--colour'; did you mean --color?");
  EXPECT_EQ(said({"tool", "list", "--tolls", "x"}),
            "gougecheck tool list has no option '--tolls'; did you mean --tools?");
}

TEST(ParseErrors, AnUnknownCommandIsNamedWithTheCommandsThereAre) {
  const std::string expected =
      "; expected check, correct, batch, clash, compare, accept, merge, machine, mesh, path, tool, verify, config, init, help, man, completion or schema";
  EXPECT_EQ(said({"chekc", "x"}), "'chekc' is no command of gougecheck" + expected + "; did you mean check?");
  EXPECT_EQ(said({"simulate"}), "'simulate' is no command of gougecheck" + expected);
  EXPECT_EQ(said({}), "no command after gougecheck" + expected);
  EXPECT_EQ(said({"tool"}), "no command after gougecheck tool; expected list, show, draw or import");
  EXPECT_EQ(
      said({"path", "inof", "a.apt"}),
      "'inof' is no command of gougecheck path; expected info, convert, plot, laws or joints; did you mean info?");
}

TEST(ParseErrors, WhatStandsBeforeTheCommandIsNamedWithItsPlace) {
  EXPECT_EQ(said({"--part", "p.stl", "check", "a.apt"}),
            "'--part' stands before the command; expected the command first: gougecheck check --part ...");
  EXPECT_EQ(said({"--tolerance=0.02", "correct", "a.apt"}),
            "'--tolerance' stands before the command; expected the command first: gougecheck correct --tolerance ...");
  EXPECT_TRUE(said({"--part", "p.stl", "a.apt"})
                  .starts_with("'--part' stands before the command; expected the command first: gougecheck COMMAND "
                               "--part ..., with check, correct, "));
}

TEST(ParseErrors, AWrongCommandIsNamedBeforeItsOptions) {
  const std::string text = said({"CHECK", "a.apt", "--part", "p.stl"});
  EXPECT_TRUE(text.starts_with("'CHECK' is no command of gougecheck; expected check, correct, ")) << text;
  EXPECT_TRUE(text.ends_with("; did you mean check?")) << text;
  EXPECT_EQ(said({"tool", "lst", "--tools", "t.json"}),
            "'lst' is no command of gougecheck tool; expected list, show, draw or import; did you mean list?");
}

TEST(ParseErrors, AFileThatBeginsWithADashIsNamedAsTyped) {
  EXPECT_EQ(said({"check", "-vorne.cls", "--part", "p.stl"}),
            "gougecheck check has no option '-vorne.cls'; a file of this name is written ./-vorne.cls");
  EXPECT_EQ(said({"check", "-q1.apt", "--part", "p.stl"}),
            "gougecheck check has no option '-q1.apt'; a file of this name is written ./-q1.apt");
}

TEST(ParseErrors, AnOptionThatSwallowedNothingHasNoValue) {
  EXPECT_EQ(said({"check", "a.apt", "--part", "--tools", "t.json"}),
            "--part has no value: '--tools' behind it is an option; expected a file; see gougecheck check --help");
  EXPECT_EQ(said({"check", "a.apt", "--part", "p.stl", "--tolerance", "--near-miss=1"}),
            "--tolerance has no value: '--near-miss' behind it is an option; expected a length; see gougecheck check "
            "--help");
  EXPECT_TRUE(said({"check", "a.apt", "--part", "p.stl", "--tools"}).starts_with("--tools has no value; expected: "));
}

TEST(ParseErrors, AValueThatCannotBeIsReportedWithWhatCan) {
  EXPECT_EQ(said({"check", "a.apt", "--part", "p.stl", "--rapid", "slow"}),
            "--rapid 'slow': expected straight, dogleg or skip");
  EXPECT_EQ(said({"check", "a.apt", "--part", "p.stl", "--threads", "-1"}),
            "--threads '-1': expected a whole number of 0 or more; see gougecheck check --help");
  EXPECT_EQ(said({"check", "a.apt", "--part", "p.stl", "--cutcom", "left"}), "--cutcom 'left': expected centre");
  for (const char* word : {"GOTO", "goto", "UNITS", "INSERT", "OFF"})
    EXPECT_EQ(said({"path", "info", "a.apt", "--harmless-word", word}),
              "--harmless-word '" + std::string(word) +
                  "': expected a word of your own: this one is read, and what it says holds");
  EXPECT_EQ(said({"path", "info", "a.apt", "--harmless-word", "WHEEL/5"}),
            "--harmless-word 'WHEEL/5': expected the word that a statement begins with, such as MYWORD of MYWORD/5");
  EXPECT_EQ(said({"tool", "import", "a.json", "-o", "b.json", "--stickout", "-3"}),
            "--stickout '-3': expected a length above 0 in mm, or with a unit (0.0005in), and at most 100 m");
  for (const char* speed : {"0", "-5", "fast", "1e999", "600deg"}) {
    EXPECT_EQ(said({"correct", "a.apt", "--part", "p.stl", "-o", "b.apt", "--max-rotary-speed", speed}),
              "--max-rotary-speed '" + std::string(speed) + "': expected degrees a minute, at least 0.001");
  }
  const auto corrects = [](const char* option, const char* value) {
    return said({"correct", "a.apt", "--part", "p.stl", "-o", "b.apt", option, value});
  };
  for (const char* strategy :
       {"lift", "holder=lift", "arm=tilt", "=tilt", "cutter=tilt", "direction=1,2", "direction=0,0,0"})
    EXPECT_TRUE(corrects("--strategy", strategy).starts_with("--strategy '" + std::string(strategy) + "': expected "));
  for (const char* cone : {"0,0,1", "0,0,0,10", "0,0,1,0", "0,0,1,181", "a,0,1,10", "0,0,1,10,2"})
    EXPECT_TRUE(corrects("--axis-cone", cone).starts_with("--axis-cone '" + std::string(cone) + "': expected I,J,K,"));
  for (const char* option : {"--max-tilt", "--max-turn", "--max-turn-step"}) {
    for (const char* value : {"0", "-1", "nan", "1e9", "5deg"})
      EXPECT_TRUE(
          corrects(option, value).starts_with(std::string(option) + " '" + value + "': expected degrees above 0"));
  }
  EXPECT_TRUE(corrects("--blend", "0").starts_with("--blend '0': expected "));
  EXPECT_TRUE(said({"path", "convert", "a.apt", "-o", "b", "--to", "fanuc"})
                  .starts_with("--to 'fanuc': expected one of nx-clsf, "));
  for (const char* name : {"mastercam-nci", "MASTERCAM-NCI"}) {
    EXPECT_EQ(said({"path", "convert", "a.apt", "-o", "b", "--to", name}),
              "--to '" + std::string(name) +
                  "': expected one of nx-clsf, apt-catia, apt-creo, apt-solidworks-cam, camworks-clt, apt-autodesk, "
                  "apt-camplete, apt-mori, apt-nccs, nccs-binary, goto-list, apt; mastercam-nci can be read but not "
                  "written");
  }
  EXPECT_TRUE(corrects("--strategy", "tlit").ends_with("; did you mean tilt?")) << corrects("--strategy", "tlit");
  EXPECT_TRUE(corrects("--strategy", "holdr=axis").ends_with("; did you mean holder=axis?"));
  EXPECT_EQ(corrects("--strategy", "something").find("did you mean"), std::string::npos);
}

TEST(ParseErrors, WhatIsMissingTwiceOrTooMuchIsReported) {
  EXPECT_EQ(said({"check"}), "gougecheck check needs PATH and --part; see gougecheck check --help");
  EXPECT_EQ(said({"check", "a.apt"}), "gougecheck check needs --part; see gougecheck check --help");
  EXPECT_EQ(said({"check", "a.apt", "--part", "p.stl", "--tolerance"}),
            "--tolerance has no value; expected: Maximum depth that a move may have in parts and fixtures; see "
            "gougecheck check --help");
  EXPECT_EQ(said({"check", "a.apt", "--part", "p.stl", "--tolerance", "1", "--tolerance", "2"}),
            "--tolerance is given 2 times; expected once; see gougecheck check --help");
  EXPECT_EQ(
      said({"check", "a.apt", "b.apt", "--part", "p.stl"}),
      "'b.apt' is one argument too many; gougecheck check takes one PATH beside its options, and gougecheck batch "
      "takes several; see gougecheck check --help");
  EXPECT_EQ(said({"mesh", "p.stl", "--fill-holes"}), "--fill-holes requires --repair; see gougecheck mesh --help");
}

// The options with a value and the positionals of a command, as its help names them.
std::vector<std::string> taking_values(std::vector<const char*> command) {
  command.insert(command.begin(), "/usr/bin/gougecheck");
  if (std::string_view(command[1]) != "help") command.push_back("--help");
  std::ostringstream out, err;
  EXPECT_EQ(run(static_cast<int>(command.size()), command.data(), out, err), kExitClean);
  const std::regex row("^  (?:-[a-z],)?(--[a-z-]+|[A-Za-z]+) (?!Needs)[A-Z].*");
  std::vector<std::string> names;
  std::istringstream lines(out.str());
  std::smatch found;
  for (std::string line; std::getline(lines, line);) {
    if (line == "Example:" || line == "Examples:") break;
    if (std::regex_match(line, found, row)) names.push_back(found[1]);
  }
  return names;
}

TEST(ParseErrors, AnEmptyValueIsRefusedWhereverAValueIsTaken) {
  const std::vector<std::vector<const char*>> commands = {
      {"check"},        {"correct"},        {"mesh"},         {"tool", "list"},    {"tool", "show"},
      {"tool", "draw"}, {"tool", "import"}, {"path", "info"}, {"path", "convert"}, {"path", "plot"}};
  const std::string end = "; is a variable of your script unset?";
  std::size_t count = 0;
  for (const std::vector<const char*>& command : commands) {
    for (const std::string& name : taking_values(command)) {
      const bool is_option = name.front() == '-';
      const std::string with_equals = name + "=";
      std::vector<std::vector<const char*>> lines(is_option ? 3 : 1, command);
      if (is_option) lines[0].push_back(name.c_str());
      lines[0].push_back("");
      for (std::size_t i = 1; i < lines.size(); ++i) lines[i].push_back(with_equals.c_str());
      if (is_option) lines[2].push_back("-q");
      for (const std::vector<const char*>& line : lines) {
        const std::string text = said(line);
        EXPECT_TRUE(text.starts_with(name + " '': expected ") && text.ends_with(end)) << name << ": " << text;
        ++count;
      }
    }
  }
  EXPECT_GT(count, 150U);
}

// The parser knows the kind of a value by words of programs: UINT, MOVES:POSITIVE.
TEST(ParseErrors, NoValueIsAnsweredWithAWordOfTheProgramAlone) {
  const std::regex of_programs("UINT|FLOAT|POSITIVE|expected [A-Z]+(;|$)");
  std::size_t count = 0;
  for (const char* command :
       {"check",        "correct",   "batch",       "compare",      "clash",         "accept",      "merge",
        "verify",       "mesh",      "tool list",   "tool show",    "tool draw",     "tool import", "path info",
        "path convert", "path plot", "path joints", "machine show", "machine check", "machine draw"}) {
    const std::string name = command;
    const std::size_t blank = name.find(' ');
    const std::string first = name.substr(0, blank), second = blank == std::string::npos ? "" : name.substr(blank + 1);
    std::vector<const char*> words = {first.c_str()};
    if (!second.empty()) words.push_back(second.c_str());
    std::vector<const char*> help = {"help"};
    help.insert(help.end(), words.begin(), words.end());
    help.push_back("--all");
    for (const std::string& option : taking_values(help)) {
      for (const char* value : {"1e9", "1.5", "-3", "0x", "1e30", "", "nan"}) {
        std::vector<const char*> argv = {"/usr/bin/gougecheck"};
        argv.insert(argv.end(), words.begin(), words.end());
        argv.insert(argv.end(), {option.c_str(), value});
        std::ostringstream out, err;
        EXPECT_NE(run(static_cast<int>(argv.size()), argv.data(), out, err), kExitClean) << name << option << value;
        EXPECT_FALSE(std::regex_search(err.str(), of_programs)) << name << " " << option << " " << err.str();
        ++count;
      }
    }
  }
  EXPECT_GT(count, 1000U);
  for (const char* value : {"1e9", "0", "-3", "1.5"})
    EXPECT_TRUE(said({"batch", "a.apt", "--chunk", value})
                    .starts_with("--chunk '" + std::string(value) + "': expected a whole number above 0"));
}

TEST(ParseErrors, AnEmptyValueIsReportedWithWhatIsExpected) {
  const std::string end = "; is a variable of your script unset?";
  EXPECT_EQ(said({"check", "a.apt", "--part", "p.stl", "--csv", ""}), "--csv '': expected a file" + end);
  EXPECT_EQ(said({"check", "a.apt", "--part", "p.stl", "--part", ""}), "--part '': expected a file" + end);
  EXPECT_EQ(said({"check", "", "--part", "p.stl"}), "PATH '': expected a file" + end);
  EXPECT_EQ(said({"check", "a.apt", "--part", "p.stl", "--threads", ""}),
            "--threads '': expected a whole number of 0 or more" + end);
  EXPECT_EQ(said({"check", "a.apt", "--part", "p.stl", "--rapid="}),
            "--rapid '': expected straight, dogleg or skip" + end);
  EXPECT_EQ(said({"check", "a.apt", "--part", "p.stl", "--clearance", ""}),
            "--clearance '': expected BODY=LENGTH" + end);
}

TEST(ParseErrors, TheNearestNameIsNearAndTheOnlyOneBegun) {
  const std::vector<std::string> names = {"--part", "--place", "--progress", "--tool", "--tools"};
  EXPECT_EQ(nearest_name("--pat", names), "--part");
  EXPECT_EQ(nearest_name("--pro", names), "--progress");
  EXPECT_EQ(nearest_name("--toll", names), "--tool");
  EXPECT_EQ(nearest_name("--xyz", {"--xya", "--xyb"}), "--xya") << "the first of equals";
  EXPECT_EQ(nearest_name("--quite-another", names), "");
  EXPECT_EQ(nearest_name("--units", {"--junit", "--path-units"}), "--path-units") << "the end of a name";
  EXPECT_EQ(nearest_name("solidworks", {"apt", "apt-solidworks-cam"}), "apt-solidworks-cam") << "a part of a name";
  EXPECT_EQ(nearest_name("inches", {"mm", "inch", "m"}), "inch");
  EXPECT_EQ(nearest_name("-x", names), "");
  EXPECT_EQ(nearest_name("nx", {"nx-clsf", "apt"}), "nx-clsf") << "two letters that only one begins with";
}

}  // namespace
}  // namespace gouge::parse_errors_test
