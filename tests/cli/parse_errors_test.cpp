#include "cli/parse_errors.h"

#include <gtest/gtest.h>

#include <sstream>
#include <vector>

#include "cli/exit_code.h"
#include "cli/run.h"

namespace gouge {
namespace {

// What the program says of a wrong command line, without its frame; fails the test where it is not one such line.
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
  EXPECT_EQ(said({"check", "a.apt", "--prat=p.stl"}),
            "gougecheck check has no option '--prat'; did you mean --part?");
  EXPECT_EQ(said({"check", "a.apt", "--part", "p.stl", "--toler", "1"}),
            "gougecheck check has no option '--toler'; did you mean --tolerance?");
  EXPECT_EQ(said({"check", "a.apt", "--part", "p.stl", "--colour"}),
            "gougecheck check has no option '--colour'; see gougecheck check --help");
  EXPECT_EQ(said({"tool", "list", "--tolls", "x"}), "gougecheck tool list has no option '--tolls'; did you mean --tools?");
}

TEST(ParseErrors, AnUnknownCommandIsNamedWithTheCommandsThereAre) {
  const std::string expected = "; expected check, correct, mesh, path or tool";
  EXPECT_EQ(said({"chekc", "x"}), "'chekc' is no command of gougecheck" + expected + "; did you mean check?");
  EXPECT_EQ(said({"simulate"}), "'simulate' is no command of gougecheck" + expected);
  EXPECT_EQ(said({}), "no command after gougecheck" + expected);
  EXPECT_EQ(said({"tool"}), "no command after gougecheck tool; expected list, show, draw or import");
  EXPECT_EQ(said({"path", "inof", "a.apt"}),
            "'inof' is no command of gougecheck path; expected info, convert or plot; did you mean info?");
}

TEST(ParseErrors, AValueThatCannotBeIsToldWithWhatCan) {
  EXPECT_EQ(said({"check", "a.apt", "--part", "p.stl", "--rapid", "slow"}),
            "--rapid 'slow': expected straight, dogleg or skip");
  EXPECT_EQ(said({"check", "a.apt", "--part", "p.stl", "--threads", "-1"}),
            "--threads '-1': expected a whole number of 0 or more; see gougecheck check --help");
  EXPECT_EQ(said({"check", "a.apt", "--part", "p.stl", "--cutcom", "left"}), "--cutcom 'left': expected centre");
  EXPECT_EQ(said({"tool", "import", "a.json", "-o", "b.json", "--stickout", "-3"}),
            "--stickout '-3': expected a number above 0");
  EXPECT_TRUE(said({"path", "convert", "a.apt", "-o", "b", "--to", "fanuc"})
                  .starts_with("--to 'fanuc': expected one of nx-clsf, "));
}

TEST(ParseErrors, WhatIsMissingTwiceOrTooMuchIsTold) {
  EXPECT_EQ(said({"check"}), "gougecheck check needs PATH and --part; see gougecheck check --help");
  EXPECT_EQ(said({"check", "a.apt"}), "gougecheck check needs --part; see gougecheck check --help");
  EXPECT_EQ(said({"check", "a.apt", "--part", "p.stl", "--tolerance"}),
            "--tolerance has no value; expected: Depth a move may have, against parts and fixtures alike; see gougecheck check --help");
  EXPECT_EQ(said({"check", "a.apt", "--part", "p.stl", "--tolerance", "1", "--tolerance", "2"}),
            "--tolerance is given 2 times; expected once; see gougecheck check --help");
  EXPECT_EQ(said({"check", "a.apt", "b.apt", "--part", "p.stl"}),
            "'b.apt' is one argument too many; gougecheck check takes one PATH beside its options; see gougecheck check "
            "--help");
  EXPECT_EQ(said({"mesh", "p.stl", "--fill-holes"}), "--fill-holes requires --repair; see gougecheck mesh --help");
}

TEST(ParseErrors, TheNearestNameIsNearAndTheOnlyOneBegun) {
  const std::vector<std::string> names = {"--part", "--place", "--progress", "--tool", "--tools"};
  EXPECT_EQ(nearest_name("--pat", names), "--part");
  EXPECT_EQ(nearest_name("--pro", names), "--progress");
  EXPECT_EQ(nearest_name("--toll", names), "--tool");
  EXPECT_EQ(nearest_name("--xyz", {"--xya", "--xyb"}), "--xya") << "the first of equals";
  EXPECT_EQ(nearest_name("--quite-another", names), "");
  EXPECT_EQ(nearest_name("-x", names), "");
}

}  // namespace
}  // namespace gouge
