#include <gtest/gtest.h>

#include <algorithm>

#include "tests/samples/program.h"
#include "tests/samples/sample_folder.h"
#include "tests/support/plain_text.h"

// Output for people: colours, the order and number of findings, quoted statements, versions, help.

namespace gouge::testing_samples::terminal_test {
namespace {

constexpr const char* kRed = "\x1b[1;31m";

std::vector<double> depths_in(const std::string& text) {
  std::vector<double> depths;
  for (const std::string& line : lines_of(text)) {
    const std::size_t at = line.find(": gouge: ");
    if (at != std::string::npos) depths.push_back(std::stod(line.substr(at + 9)));
  }
  return depths;
}

// `options` in a terminal of util-linux's script.
Outcome on_terminal(const SampleFolder& sample, const std::string& options, const std::string& before = "") {
  return run_script(sample.path, before + " script -qec \"$GOUGECHECK check " + sample.toolpath() +
                                     " --part part.stl --tools tools.json " + options + "\" typescript");
}

// False in a container or chroot without /dev/pts.
bool has_terminals(const std::string& folder) {
  return run_script(folder, "script -qec true typescript").exit_status == 0;
}

Outcome check(const SampleFolder& sample, const std::vector<std::string>& options) {
  return run_gougecheck(sample.path, sample.arguments("check", sample.toolpath(), options));
}

TEST(Terminal, ColoursGoToTerminalsAndWhereTheyAreAskedFor) {
  const SampleFolder sample = open_sample("pocket");
  EXPECT_EQ(check(sample, {}).out.find('\x1b'), std::string::npos) << "a file is no terminal";
  const Outcome always = check(sample, {"--color", "always"});
  EXPECT_NE(always.out.find(std::string(kRed) + "gouge:"), std::string::npos) << always.out;
  EXPECT_NE(always.out.find(std::string(kRed) + "gouges:"), std::string::npos) << always.out;
  EXPECT_EQ(without_colours(always.out), check(sample, {"--color", "never"}).out) << "colours change nothing else";
  if (!has_terminals(sample.path)) GTEST_SKIP() << "no pseudo-terminal can be opened here";
  EXPECT_NE(on_terminal(sample, "").out.find(kRed), std::string::npos);
  EXPECT_EQ(on_terminal(sample, "", "NO_COLOR=1").out.find('\x1b'), std::string::npos);
  EXPECT_EQ(on_terminal(sample, "", "TERM=dumb").out.find('\x1b'), std::string::npos);
  EXPECT_NE(on_terminal(sample, "", "NO_COLOR=").out.find(kRed), std::string::npos) << "an empty value is none";
  EXPECT_NE(on_terminal(sample, "--color always", "NO_COLOR=1").out.find(kRed), std::string::npos);
  EXPECT_EQ(on_terminal(sample, "--color never").out.find('\x1b'), std::string::npos);
}

TEST(Terminal, ErrorsAreColouredToo) {
  const std::string folder = fresh_folder();
  const Outcome wrong = run_gougecheck(folder, {"mesh", "none.stl", "--color", "always"});
  EXPECT_NE(wrong.err.find(std::string(kRed) + "error:"), std::string::npos) << wrong.err;
  const Outcome usage = run_gougecheck(folder, {"mesh", "none.stl", "--color=always", "--no-such"});
  EXPECT_EQ(usage.exit_status, 2);
  EXPECT_NE(usage.err.find(std::string(kRed) + "error:"), std::string::npos) << usage.err;
  EXPECT_EQ(run_gougecheck(folder, {"mesh", "none.stl", "--color", "red"}).exit_status, 2);
}

TEST(Terminal, FindingsAreSortedAndLimitedButNeverLost) {
  const SampleFolder sample = open_sample("pocket");
  const Outcome all = check(sample, {});
  const std::vector<double> depths = depths_in(all.out);
  ASSERT_GE(depths.size(), 2U) << all.out;
  std::vector<double> sorted = depths;
  std::sort(sorted.rbegin(), sorted.rend());
  const Outcome deepest = check(sample, {"--sort", "depth"});
  EXPECT_EQ(depths_in(deepest.out), sorted);
  EXPECT_EQ(deepest.exit_status, all.exit_status);
  const Outcome one = check(sample, {"--max-findings", "1"});
  EXPECT_EQ(depths_in(one.out), std::vector<double>{sorted.front()}) << "the deepest stays";
  EXPECT_NE(one.out.find("and " + std::to_string(depths.size() - 1) + " more, the deepest "), std::string::npos)
      << one.out;
  EXPECT_EQ(one.exit_status, 1);
  EXPECT_EQ(check(sample, {"--max-findings", "all"}).out, all.out);
  const Outcome none = check(sample, {"--min-depth", "1000"});
  EXPECT_EQ(depths_in(none.out), std::vector<double>{});
  EXPECT_EQ(none.exit_status, 1) << "what is not listed is a gouge all the same";
  EXPECT_NE(none.out.find("not listed, less deep than --min-depth 1000 mm"), std::string::npos) << none.out;
  EXPECT_NE(none.out.find("\ngouges: "), std::string::npos) << none.out;
  for (const char* wrong : {"-1", "few", "1.5"})
    EXPECT_EQ(check(sample, {"--max-findings", wrong}).exit_status, 2) << wrong;
  EXPECT_EQ(check(sample, {"--min-depth", "-1"}).exit_status, 2);
  EXPECT_EQ(check(sample, {"--sort", "tool"}).exit_status, 2);
}

TEST(Terminal, VerboseQuotesTheStatement) {
  const SampleFolder sample = open_sample("pocket");
  const std::vector<std::string> source = lines_of(text_of(sample.path + "/" + sample.toolpath()));
  const std::vector<std::string> lines = lines_of(check(sample, {"-v"}).out);
  std::size_t quoted = 0;
  for (std::size_t k = 0; k + 1 < lines.size(); ++k) {
    if (lines[k].find(": gouge: ") == std::string::npos) continue;
    const std::size_t bar = lines[k + 1].find(" | ");
    ASSERT_NE(bar, std::string::npos) << lines[k + 1];
    EXPECT_EQ(lines[k + 1].substr(bar + 3), source[std::stoul(lines[k + 1]) - 1]);
    ++quoted;
  }
  EXPECT_GE(quoted, 2U);
}

TEST(Terminal, ACorrectionSaysBeforeAndAfter) {
  const SampleFolder sample = open_sample("between_rib");
  const Outcome ran = run_gougecheck(sample.path, sample.arguments("correct", sample.toolpath(), {"-o", "out.apt"}));
  EXPECT_NE(ran.out.find("\nbefore gouges: "), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("\nafter  clean: no gouge in "), std::string::npos) << ran.out;
}

TEST(Terminal, TheVersionHasTheFactsOfTheBuild) {
  const std::string folder = fresh_folder();
  const Outcome brief = run_gougecheck(folder, {"-V"});
  EXPECT_EQ(brief.exit_status, 0);
  EXPECT_EQ(lines_of(brief.out).size(), 1U) << brief.out;
  EXPECT_TRUE(brief.out.starts_with("gougecheck ")) << brief.out;
  const Outcome all = run_gougecheck(folder, {"--version"});
  EXPECT_TRUE(all.out.starts_with(brief.out)) << all.out;
  for (const char* fact : {"CGAL ", "OpenCV ", "Eigen ", "kernels here: plain", "MPI: "})
    EXPECT_NE(all.out.find(fact), std::string::npos) << fact << all.out;
}

TEST(Terminal, HelpIsACommand) {
  const std::string folder = fresh_folder();
  EXPECT_EQ(run_gougecheck(folder, {"help"}).out, run_gougecheck(folder, {"--help"}).out);
  const Outcome import = run_gougecheck(folder, {"help", "tool", "import"});
  EXPECT_EQ(import.exit_status, 0);
  EXPECT_EQ(import.out, run_gougecheck(folder, {"tool", "import", "--help"}).out);
  const Outcome wrong = run_gougecheck(folder, {"help", "chekc"});
  EXPECT_EQ(wrong.exit_status, 2);
  EXPECT_NE(wrong.err.find("did you mean check?"), std::string::npos) << wrong.err;
}

TEST(Terminal, ManualPagesNameEveryOptionOfTheHelp) {
  const std::string folder = fresh_folder();
  const Outcome page = run_gougecheck(folder, {"man", "correct"});
  EXPECT_EQ(page.exit_status, 0);
  EXPECT_TRUE(page.out.starts_with(".TH GOUGECHECK-CORRECT 1 ")) << page.out.substr(0, 60);
  for (const char* option : {"\\-\\-part", "\\-\\-max\\-shift", "\\-o", "\\-\\-color", "\\-\\-sort"})
    EXPECT_NE(page.out.find(option), std::string::npos) << option;
  EXPECT_EQ(run_gougecheck(folder, {"man", "corect"}).exit_status, 2);
}

// Completions of bash for a line that ends at its last word.
std::string completed(const std::string& folder, const std::string& words) {
  return run_script(folder,
                    "\"$GOUGECHECK\" completion bash > c.bash && bash --norc -c 'compopt() { :; }; . ./c.bash; "
                    "COMP_WORDS=(" +
                        words + "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _gougecheck; echo \"${COMPREPLY[*]}\"'")
      .out;
}

TEST(Terminal, BashCompletesCommandsOptionsAndValues) {
  const std::string folder = fresh_folder();
  write_text(folder + "/part one.stl", "");
  EXPECT_EQ(completed(folder, "gougecheck che"), "check\n");
  EXPECT_EQ(completed(folder, "gougecheck tool im"), "import\n");
  EXPECT_EQ(completed(folder, "gougecheck check --tolera"), "--tolerance\n");
  EXPECT_EQ(completed(folder, "gougecheck check --rapid s"), "straight skip\n");
  EXPECT_EQ(completed(folder, "gougecheck check --rapid = s"), "straight skip\n");
  EXPECT_EQ(completed(folder, "gougecheck check --part par"), "part one.stl\n");
  EXPECT_EQ(completed(folder, "gougecheck check par"), "part one.stl\n");
  EXPECT_EQ(completed(folder, "gougecheck check --tolerance par"), "\n") << "a length is no file";
  EXPECT_EQ(completed(folder, "gougecheck completion f"), "fish\n");
  EXPECT_EQ(completed(folder, "gougecheck help cor"), "correct\n");
  EXPECT_EQ(run_gougecheck(folder, {"completion", "csh"}).exit_status, 2);
}

TEST(Terminal, JobsHaveNoOptionsOfTheTerminal) {
  const std::string folder = fresh_folder();
  for (const std::string key : {"sort", "min-depth", "max-findings"}) {
    write_text(folder + "/jobs.json", R"({"jobs": [{"path": "a.apt", "part": "p.stl", ")" + key + R"(": "1"}]})");
    const Outcome ran = run_gougecheck(folder, {"batch", "jobs.json", "-o", "out"});
    EXPECT_EQ(ran.exit_status, 3) << key;
    EXPECT_NE(ran.err.find("says what is printed on a terminal"), std::string::npos) << ran.err;
  }
}

}  // namespace
}  // namespace gouge::testing_samples::terminal_test
