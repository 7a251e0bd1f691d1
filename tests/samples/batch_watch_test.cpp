#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/samples/batch_folder.h"
#include "tests/samples/program.h"

// gougecheck batch --watch, as its users run it.

namespace gouge::testing_samples::batch_watch_test {
namespace {

using Json = nlohmann::json;

// A CAM system writes a file in pieces, and a program beside it has one with another ending for a while. When a file
// counts is what settled_files_test holds: here the machine may be too busy for any second to be the same everywhere.
TEST(Batch, WatchesAFolderAndChecksWhatIsWrittenThere) {
  const std::string folder = samples_with_list({"needles", "thin_post"});
  const Outcome ran = run_script(
      folder,
      "mkdir hot; cp needles/needles.apt hot/first.apt; echo no toolpath > hot/readme.txt\n"
      "$GOUGECHECK batch --watch hot --part needles/part.stl --tools needles/tools.json -o out > log & watch=$!\n"
      "wait_for() { for i in $(seq 600); do [ \"$(grep -c \"$1\" $2 2>/dev/null)\" = $3 ] && return; sleep 0.1; done; "
      "echo no $1; }\n"
      "wait_for '^report: ' log 1\n"
      "head -c 2000 needles/needles.apt > hot/second.apt; cp needles/needles.apt hot/third.apt.tmp; sleep 0.5\n"
      "tail -c +2001 needles/needles.apt >> hot/second.apt\n"
      "wait_for ',274,274,' out/summary.csv 2; wait_for '1 job taken from the store, 1 run' log 1\n"
      "kill -TERM $watch; wait $watch; echo ended $?; cat log");
  EXPECT_NE(ran.out.find("ended 143\n"), std::string::npos) << ran.out << ran.err;
  EXPECT_EQ(ran.out.find("no "), std::string::npos) << ran.out;
  const Json jobs = summary_of(folder + "/out").at("jobs");
  ASSERT_EQ(jobs.size(), 2U);
  EXPECT_EQ(jobs.at(1).at("job"), "second");
}

TEST(Batch, TellsHowToGoOnWhenAWatchEndsWithinAJob) {
  const std::string folder = samples_with_list({"freeform"});
  const Outcome ran = run_script(
      folder,
      "mkdir hot; for i in $(seq 30); do cp freeform/freeform.apt hot/$i.apt; done\n"
      "$GOUGECHECK batch --watch hot --part freeform/part.stl --tools freeform/tools.json --jobs 1 -o out > log 2>&1 & "
      "watch=$!\n"
      "for i in $(seq 600); do [ -e out/results.sqlite ] && break; sleep 0.1; done; sleep 0.5\n"
      "kill -INT $watch; kill -TERM $watch; wait $watch; cat log");
  EXPECT_NE(ran.out.find("note: the batch was interrupted; what is done is kept: the same command goes on from there "
                         "[batch-interrupted]"),
            std::string::npos)
      << ran.out << ran.err;
}

TEST(Batch, WatchesNoFolderThatDoesNotExist) {
  const std::string folder = samples_with_list({"needles"});
  for (const char* place : {"nowhere", "nowhere/*.apt", "needles/nowhere", "nowhere/"}) {
    const Outcome ran = run_gougecheck(folder, {"batch", "--watch", place, "--part", "needles/part.stl", "-o", "out"});
    EXPECT_EQ(ran.exit_status, 2) << place;
    EXPECT_NE(ran.err.find("--watch '" + std::string(place) +
                           "': there is no such folder; expected one, or a pattern in one"),
              std::string::npos)
        << ran.err;
  }
}

// Somebody who looks into the store for longer than we wait for must not end a night's watch.
TEST(Batch, WatchesOnWhileAQueryHoldsTheStore) {
  const std::string folder = samples_with_list({"needles"});
  const std::string watch = "$GOUGECHECK batch --watch hot --part needles/part.stl --tools needles/tools.json -o out";
  const Outcome ran = run_script(
      folder,
      "mkdir hot; mkfifo lock; cp needles/needles.apt hot/first.apt\n"
      "$GOUGECHECK batch hot/first.apt --part needles/part.stl --tools needles/tools.json -o out -q || exit 1\n"
      "python3 -c 'import sqlite3, sys; s = sqlite3.connect(\"out/results.sqlite\", isolation_level=None)\n"
      "s.execute(\"BEGIN\"); s.execute(\"SELECT count(*) FROM jobs\").fetchone(); print(\"held\", flush=True)\n"
      "sys.stdin.read()' < lock > held & query=$!\n" +
          std::string("exec 9> lock; while ! [ -s held ]; do sleep 0.01; done\n") +
          "$GOUGECHECK batch hot/first.apt --part needles/part.stl --tools needles/tools.json -o out -q 9>&-; echo batch $?\n" +
          watch + " > log 2> errors 9>&- & watch=$!\n" +
          "while ! [ -s errors ]; do sleep 0.01; done; exec 9>&-; wait $query\n"
          "for i in $(seq 600); do grep -q '^report: ' log && break; sleep 0.1; done\n"
          "kill -TERM $watch; wait $watch; echo ended $?; cat errors log");
  EXPECT_NE(ran.out.find("batch 5\n"), std::string::npos) << ran.out << ran.err;
  EXPECT_NE(ran.err.find("[store-busy]"), std::string::npos) << ran.err;
  EXPECT_NE(ran.out.find("[store-busy]"), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("report: out/index.html\n"), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("ended 143\n"), std::string::npos) << ran.out << ran.err;
}

const char* const kWaitFor =
    "wait_for() { for i in $(seq 600); do grep -q \"$1\" $2 2>/dev/null && return; sleep 0.1; done; echo no $1; }\n";
const char* const kOfNeedles = " --part needles/part.stl --tools needles/tools.json --no-reports ";

// One file with an odd name must end neither the watch nor its next start.
TEST(Batch, WatchesOnAfterAFileWithANameThatNoJobCanHave) {
  const std::string folder = samples_with_list({"needles"});
  const Outcome ran = run_script(
      folder, std::string("mkdir hot; cp needles/needles.apt hot/first.apt\n") + kWaitFor +
                  "$GOUGECHECK batch --watch hot -o out" + kOfNeedles + "> log & watch=$!\n" +
                  "wait_for '^report: ' log\n"
                  "for name in 'bad .apt' -dash.apt $(printf 'x%.0s' $(seq 120)).apt 'a\nb.apt'; do "
                  "cp needles/needles.apt \"hot/$name\"; done\n"
                  "wait_for '4 failed' log; mkdir -p hot/op10/below; cp needles/needles.apt hot/op10/below/last.apt\n"
                  "wait_for '^last ' log; kill -TERM $watch; wait $watch; echo ended $?\n"
                  "$GOUGECHECK batch hot -o out" +
                  kOfNeedles + "; echo batch $?");
  EXPECT_EQ(ran.out.find("no "), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("ended 143\n"), std::string::npos) << ran.out << ran.err;
  EXPECT_NE(ran.out.find("the name of a job, 'bad ', begins or ends with a blank"), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("[job-name]"), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("6 jobs taken from the store, 0 run"), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("batch 3\n"), std::string::npos) << ran.out;
  EXPECT_NE(ran.err.find("the watch ended with 6 jobs: "), std::string::npos) << ran.err;
}

TEST(Batch, RefusesASecondBatchInTheFolderOfAWatch) {
  const std::string folder = samples_with_list({"needles"});
  const Outcome ran = run_script(
      folder, std::string("mkdir hot other; cp needles/needles.apt other\n") + kWaitFor +
                  "$GOUGECHECK batch other -o out -q" + kOfNeedles + "; cp needles/needles.apt hot/first.apt\n" +
                  "$GOUGECHECK batch --watch hot -o out" + kOfNeedles + "> log 2> errors & watch=$!\n" +
                  "wait_for '^report: ' log; sleep 1\n"
                  "$GOUGECHECK batch --watch other -o out" +
                  kOfNeedles + "; echo second $?\n" + "$GOUGECHECK batch other -o out" + kOfNeedles +
                  "; echo third $?\n" + "kill -TERM $watch; wait $watch; cat errors");
  EXPECT_NE(ran.out.find("second 5\nthird 5\n"), std::string::npos) << ran.out << ran.err;
  EXPECT_NE(ran.err.find("[store-busy]"), std::string::npos) << ran.err;
  EXPECT_NE(ran.out.find("[batch-replaced]"), std::string::npos) << ran.out;
}

TEST(Batch, RunsFailedJobsOfAWatchAgainWhenTheirPartIsThere) {
  const std::string folder = samples_with_list({"needles"});
  const Outcome ran = run_script(
      folder,
      std::string("mkdir hot; cp needles/needles.apt hot/first.apt\n") + kWaitFor +
          "$GOUGECHECK batch --watch hot -o out --part later.stl --tools needles/tools.json --no-reports > log & "
          "watch=$!\n"
          "wait_for '1 failed' log; cp needles/part.stl later.stl; wait_for '274 ' log\n"
          "kill -TERM $watch; wait $watch");
  EXPECT_EQ(ran.out.find("no "), std::string::npos) << ran.out << ran.err;
}

TEST(Batch, RefusesOptionsThatAWatchCannotFollow) {
  const std::string folder = samples_with_list({"needles"});
  for (const std::vector<std::string>& option : {std::vector<std::string>{"--stop-on", "gouge"}, {"--fresh"}}) {
    std::vector<std::string> words = {"batch", "--watch", "needles", "--part", "needles/part.stl", "-o", "out"};
    words.insert(words.end(), option.begin(), option.end());
    const Outcome ran = run_gougecheck(folder, words);
    EXPECT_EQ(ran.exit_status, 2);
    EXPECT_NE(ran.err.find("error: " + option.front() + " "), std::string::npos) << ran.err;
    EXPECT_NE(ran.err.find("--watch"), std::string::npos) << ran.err;
    EXPECT_EQ(ran.err.find("--resume"), std::string::npos) << ran.err;
    EXPECT_FALSE(std::filesystem::exists(folder + "/out"));
  }
}

}  // namespace
}  // namespace gouge::testing_samples::batch_watch_test
