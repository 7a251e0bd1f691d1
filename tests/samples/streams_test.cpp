#include <gtest/gtest.h>

#include <filesystem>

#include "tests/samples/program.h"
#include "tests/samples/sample_folder.h"

// Standard output that ends early, is full or closed, and limits of the shell: docs/exit_codes.md.

namespace gouge::testing_samples::streams_test {
namespace {

namespace fs = std::filesystem;

const std::string kPocket = " pocket.apt --tools tools.json --part part.stl --fixture clamp.stl ";

/// A pipe whose reader is gone before the program begins to write: `true` ends at once, and what is before it
/// in the pipe waits for that.
std::string into_a_closed_pipe(const std::string& command) {
  return "{ { sleep 0.3; " + command + "; echo $? >status; } | true; } 2>err; wait; cat status err";
}

std::size_t files_in(const std::string& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(Streams, AClosedPipeEndsThePrintingNotTheWork) {
  const SampleFolder sample = open_sample("pocket");
  const Outcome ran =
      run_script(sample.path, into_a_closed_pipe("$GOUGECHECK check" + kPocket + "--report r --csv c.csv --json j"));
  EXPECT_EQ(ran.out, "1\n") << "the verdict's status, and no message";
  for (const char* file : {"r/report.html", "r/manifest.json", "c.csv", "j"})
    EXPECT_TRUE(fs::exists(sample.path + "/" + file)) << file;
  for (const char* command :
       {"--help", "--version", "check --help", "path info pocket.apt", "tool list --tools tools.json", "mesh part.stl"})
    EXPECT_EQ(run_script(sample.path, into_a_closed_pipe(std::string("$GOUGECHECK ") + command)).out, "0\n") << command;
  const Outcome corrected = run_script(sample.path, into_a_closed_pipe("$GOUGECHECK correct" + kPocket + "-o out.apt"));
  EXPECT_EQ(corrected.out.substr(0, corrected.out.find("pocket.apt:136: warning: ")), "0\n") << corrected.out;
  EXPECT_TRUE(fs::exists(sample.path + "/out.apt"));
}

TEST(Streams, DataThatAPipeDoesNotTakeAreStatus5) {
  const SampleFolder sample = open_sample("pocket");
  for (const std::string& command :
       {"check" + kPocket + "--json -", "check" + kPocket + "--csv -", "correct" + kPocket + "-o -",
        std::string("path info pocket.apt --json -"), std::string("path convert pocket.apt -o -"),
        std::string("mesh part.stl --json -")}) {
    const std::string out = run_script(sample.path, into_a_closed_pipe("$GOUGECHECK " + command)).out;
    EXPECT_EQ(out.substr(0, 2), "5\n") << command;
    EXPECT_TRUE(
        out.ends_with("gougecheck: error: standard output is a pipe whose reader ended before all was written "
                      "[output-unwritable]\n"))
        << command << ": " << out;
  }
}

TEST(Streams, AStandardOutputThatIsFullOrClosedIsStatus5) {
  const SampleFolder sample = open_sample("pocket");
  const std::string message =
      "gougecheck: error: standard output could not be written (closed, full, or a limit of the shell) "
      "[output-unwritable]\n";
  for (const std::string& command :
       {std::string("--help"), std::string("--version"), std::string("correct --help"), "check" + kPocket,
        "check" + kPocket + "--csv -", std::string("tool list --tools tools.json"), std::string("mesh part.stl"),
        std::string("path info pocket.apt")}) {
    for (const char* target : {" >/dev/full", " >&-"}) {
      const Outcome ran = run_script(sample.path, "$GOUGECHECK " + command + target);
      EXPECT_EQ(ran.exit_status, 5) << command << target;
      EXPECT_EQ(ran.err, message) << command << target;
    }
  }
  EXPECT_EQ(run_script(sample.path, "$GOUGECHECK check -q" + kPocket + " >&-").exit_status, 1) << "nothing to print";
}

TEST(Streams, AClosedStandardOutputIsNeverAFile) {
  const SampleFolder sample = open_sample("pocket");
  const std::string command = "$GOUGECHECK check" + kPocket;
  ASSERT_EQ(run_script(sample.path, command + "--csv good.csv").exit_status, 1);
  EXPECT_EQ(run_script(sample.path, command + "--csv c.csv >&- 2>&- <&-").exit_status, 5);
  EXPECT_EQ(text_of(sample.path + "/c.csv"), text_of(sample.path + "/good.csv"));
}

TEST(Streams, ALimitOfTheShellIsStatus5AndLeavesNothing) {
  const SampleFolder sample = open_sample("pocket");
  write_text(sample.path + "/old.csv", "old");
  const Outcome warm = run_script(sample.path, "true");
  ASSERT_EQ(warm.exit_status, 0);
  const std::size_t before = files_in(sample.path);
  for (const char* outputs : {"--csv old.csv", "--csv new.csv", "--json u.json --report r", "--report r"}) {
    const Outcome ran = run_script(sample.path, "ulimit -f 1\nexec $GOUGECHECK check -q" + kPocket + outputs);
    EXPECT_EQ(ran.exit_status, 5) << outputs;
    EXPECT_NE(ran.err.find("File too large (a limit of the shell, ulimit -f); nothing was written [file-unwritable]"),
              std::string::npos)
        << ran.err;
    EXPECT_EQ(files_in(sample.path), before) << outputs;
  }
  EXPECT_EQ(text_of(sample.path + "/old.csv"), "old");
}

}  // namespace
}  // namespace gouge::testing_samples::streams_test
