#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "lib/base/sha256.h"
#include "postproc/store/result_store.h"
#include "tests/samples/batch_folder.h"
#include "tests/samples/program.h"

// Foreign, blocking or changed files that a batch finds in its folder or in a share.

namespace gouge::testing_samples::batch_surroundings_test {
namespace {

namespace fs = std::filesystem;

TEST(Batch, LeavesWhatIsNotItsOwnAlone) {
  const std::string folder = samples_with_list({"needles"});
  fs::create_directories(folder + "/out");
  write_text(folder + "/out/summary.csv", "mine\n");
  const Outcome ran = run_batch(folder, {"jobs.json", "-o", "out"});
  EXPECT_EQ(ran.exit_status, 2);
  EXPECT_NE(ran.err.find("summary.csv"), std::string::npos) << ran.err;
  EXPECT_EQ(text_of(folder + "/out/summary.csv"), "mine\n");
  EXPECT_FALSE(fs::exists(folder + "/out/results.sqlite"));
  fs::remove(folder + "/out/summary.csv");
  write_text(folder + "/out/results.sqlite", "mine too, and long enough to be taken for a file of somebody else's\n");
  const Outcome foreign = run_batch(folder, {"jobs.json", "-o", "out"});
  EXPECT_EQ(foreign.exit_status, 5);
  EXPECT_NE(foreign.err.find("is no store of a batch"), std::string::npos) << foreign.err;
  EXPECT_EQ(text_of(folder + "/out/results.sqlite").substr(0, 8), "mine too");
}

TEST(Batch, LeavesCorrectedPathsThatAreNotItsOwnAlone) {
  const std::string folder = samples_with_list({"pocket"});
  const std::string corrected = folder + "/out/corrected/pocket corrected.apt";
  fs::create_directories(folder + "/out/corrected");
  write_text(corrected, "mine\n");
  EXPECT_EQ(run_batch(folder, {"jobs.json", "-o", "out"}).exit_status, 2);
  EXPECT_EQ(text_of(corrected), "mine\n");
  fs::remove(corrected);
  ASSERT_EQ(run_batch(folder, {"jobs.json", "-o", "out"}).exit_status, 1);
  std::ofstream(corrected, std::ios::app) << "$$ mine\n";
  const std::string edited = text_of(corrected);
  const Outcome again = run_batch(folder, {"jobs.json", "-o", "out"});
  EXPECT_EQ(again.exit_status, 2);
  EXPECT_NE(again.err.find("pocket corrected.apt"), std::string::npos) << again.err;
  EXPECT_EQ(text_of(corrected), edited);
  EXPECT_EQ(run_batch(folder, {"jobs.json", "-o", "out", "--force"}).exit_status, 1);
  EXPECT_NE(text_of(corrected), edited);
}

// A job that can no longer be corrected has no corrected path left over from when it could.
TEST(Batch, LeavesNoCorrectedPathOfAJobThatFailsNow) {
  const std::string folder = samples_with_list({"pocket"});
  ASSERT_EQ(run_batch(folder, {"jobs.json", "-o", "out"}).exit_status, 1);
  write_text(folder + "/pocket/part.stl", "solid broken\n");
  EXPECT_EQ(run_batch(folder, {"jobs.json", "-o", "out"}).exit_status, 3);
  EXPECT_FALSE(fs::exists(folder + "/out/corrected/pocket corrected.apt"));
}

TEST(Batch, JoinsNoSharesThatReadDifferentContentsOfOneFile) {
  const std::string folder = samples_with_list({"needles"});
  EXPECT_EQ(run_batch(folder, {"jobs.json", "-o", "s1", "--shard", "1/2"}).exit_status, 0);
  ASSERT_EQ(
      run_script(folder, "$GOUGECHECK mesh thin_post/part.stl -q; cp thin_post/part.stl needles/part.stl").exit_status,
      0);
  const int second = run_batch(folder, {"jobs.json", "-o", "s2", "--shard", "2/2"}).exit_status;
  EXPECT_NE(second, 2);
  const Outcome merged = run_gougecheck(folder, {"merge", "s1", "s2", "-o", "m"});
  EXPECT_EQ(merged.exit_status, 3);
  EXPECT_NE(merged.err.find("needles/part.stl had another content"), std::string::npos) << merged.err;
  EXPECT_FALSE(fs::exists(folder + "/m"));
  const Outcome other = run_batch(folder, {"jobs.json", "-o", "s1", "--shard", "2/2"});
  EXPECT_EQ(other.exit_status, 2);
  EXPECT_NE(other.err.find("another share"), std::string::npos) << other.err;
}

// A store may come from somebody else, and name files that are none of the batch.
TEST(Batch, JoinsNoFilesFromOutsideOfAShare) {
  const std::string folder = samples_with_list({"needles"});
  ASSERT_EQ(run_batch(folder, {"jobs.json", "-o", "s"}).exit_status, 0);
  write_text(folder + "/secret", "x");
  {
    Result<ResultStore> store = ResultStore::open(folder + "/s/results.sqlite");
    ASSERT_TRUE(store.has_value());
    Result<std::vector<JobResult>> results = store->all();
    ASSERT_TRUE(results.has_value());
    results->front().outputs.push_back({"../secret", 1, sha256_of("x")});
    ASSERT_TRUE(store->put({{0, results->front()}}).has_value());
  }
  const Outcome merged = run_gougecheck(folder, {"merge", "s", "-o", "m/m"});
  EXPECT_EQ(merged.exit_status, 3) << merged.out << merged.err;
  EXPECT_NE(merged.err.find("../secret"), std::string::npos) << merged.err;
  EXPECT_FALSE(fs::exists(folder + "/m"));
}

// A store is not believed what was not put into it: a gouge that became clean, or bits that a disk has lost.
TEST(Batch, BelievesNoStoreThatWasChanged) {
  const std::string folder = samples_with_list({"pocket", "needles"});
  ASSERT_EQ(run_batch(folder, {"jobs.json", "-o", "one"}).exit_status, 1);
  const auto expected = batch_files(folder + "/one");
  for (const char* sql :
       {"UPDATE counts SET moves = 0 WHERE job = 0 AND state = 'gouge'", "UPDATE jobs SET status = 0 WHERE job = 0",
        "DELETE FROM findings WHERE job = 0 AND finding = 0", "UPDATE findings SET depth = depth / 2 WHERE job = 0",
        "UPDATE jobs SET verdict = 'clean' WHERE job = 0", "UPDATE jobs SET findings = 0, moves = 1 WHERE job = 0",
        "UPDATE inputs SET checksum = replace(checksum, 'a', 'b') WHERE job = 0"}) {
    fs::remove_all(folder + "/s");
    fs::copy(folder + "/one", folder + "/s", fs::copy_options::recursive);
    change_store(folder + "/s/results.sqlite", sql);
    const Outcome merged = run_gougecheck(folder, {"merge", "s", "-o", "m"});
    EXPECT_EQ(merged.exit_status, 3) << sql;
    EXPECT_NE(merged.err.find("its result of job pocket is not what was stored"), std::string::npos) << merged.err;
    EXPECT_FALSE(fs::exists(folder + "/m"));
    const Outcome again = run_batch(folder, {"jobs.json", "-o", "s"});
    EXPECT_EQ(again.exit_status, 1) << sql;
    EXPECT_NE(again.out.find("3 jobs taken from the store, 1 run\n"), std::string::npos) << sql << again.out;
    EXPECT_EQ(difference(expected, batch_files(folder + "/s")), "") << sql;
  }
}

TEST(Batch, RefusesOutputsThatLieInTheWay) {
  const std::string folder = samples_with_list({"needles"});
  const std::string begin =
      "{\"defaults\": {\"part\": \"needles/part.stl\", \"tools\": \"needles/tools.json\"}, \"jobs\": "
      "[{\"path\": \"needles/needles.apt\", \"json\": \"";
  for (const std::string output : {"out/results.sqlite", "out/results.sqlite-wal", "out/summary.json",
                                   "out/reports/needles/result.json", "out/corrected", "./out/x.json", "wrong.json"}) {
    write_text(folder + "/wrong.json", begin + output + "\"}]}");
    const std::string before = text_of(folder + "/wrong.json");
    const Outcome ran = run_batch(folder, {"wrong.json", "-o", "out"});
    EXPECT_EQ(ran.exit_status, 2) << output;
    EXPECT_NE(ran.err.find("--json"), std::string::npos) << ran.err;
    EXPECT_EQ(text_of(folder + "/wrong.json"), before);
    EXPECT_FALSE(fs::exists(folder + "/out"));
  }
  const Outcome piped =
      run_script(folder,
                 "mkfifo pipe; printf '{\"jobs\": [{\"name\": \"a\", \"path\": \"pipe\", \"part\": \"p\"}, "
                 "{\"name\": \"b\", \"path\": \"pipe\", \"part\": \"p\"}]}' > p.json; $GOUGECHECK batch p.json -o out");
  EXPECT_EQ(piped.exit_status, 2) << piped.err;
  EXPECT_NE(piped.err.find("read but once"), std::string::npos) << piped.err;
}

// Root may write everywhere, so it runs the program as somebody else.
TEST(Batch, SaysThatItsFolderCannotBeWrittenAndLeavesItAlone) {
  const std::string folder = samples_with_list({"needles"});
  const std::string somebody = ::geteuid() == 0 ? "setpriv --reuid=65534 --regid=65534 --clear-groups " : "";
  if (run_script(folder, somebody + "$GOUGECHECK --version && ! " + somebody + "touch /bin").exit_status != 0)
    GTEST_SKIP() << "nobody else may run the program here";
  fs::create_directories(folder + "/out");
  ASSERT_EQ(run_batch(folder, {"jobs.json", "-o", "done"}).exit_status, 0);
  const auto before = batch_files(folder + "/done");
  ASSERT_EQ(run_script(folder, "chmod -R a-w out done").exit_status, 0);
  for (const char* out : {"out", "done", "done --fresh", "none/out"}) {
    const Outcome ran =
        run_script(folder, "chmod a-w .; " + somebody + "$GOUGECHECK batch jobs.json -o " + out +
                               " > /dev/null 2> /dev/shm/gouge_batch_test; status=$?; chmod u+w .\n"
                               "cat /dev/shm/gouge_batch_test; rm /dev/shm/gouge_batch_test; exit $status");
    EXPECT_EQ(ran.exit_status, 5) << out << ran.out;
    EXPECT_EQ(std::count(ran.out.begin(), ran.out.end(), '\n'), 1) << ran.out;
    EXPECT_NE(ran.out.find(": error: "), std::string::npos) << ran.out;
  }
  EXPECT_TRUE(fs::is_empty(folder + "/out"));
  EXPECT_EQ(difference(before, batch_files(folder + "/done")), "");
  ASSERT_EQ(run_script(folder, "chmod -R u+w out done").exit_status, 0);
}

TEST(Batch, OfALaterVersionIsLeftAsItIs) {
  const std::string folder = samples_with_list({"needles"});
  ASSERT_EQ(run_batch(folder, {"jobs.json", "-o", "out", "--no-reports"}).exit_status, 0);
  ASSERT_EQ(
      run_script(folder, "printf '\\0\\0\\0\\143' | dd of=out/results.sqlite bs=1 seek=60 conv=notrunc 2>/dev/null")
          .exit_status,
      0);
  const std::string before = text_of(folder + "/out/results.sqlite");
  const Outcome ran = run_batch(folder, {"jobs.json", "-o", "out"});
  EXPECT_EQ(ran.exit_status, 5);
  EXPECT_NE(ran.err.find("another version"), std::string::npos) << ran.err;
  EXPECT_TRUE(text_of(folder + "/out/results.sqlite") == before);
}

TEST(Batch, KeepsItsFilesFromOutputsOfCommandsThatReadIt) {
  const std::string folder = samples_with_list({"needles"});
  ASSERT_EQ(run_batch(folder, {"jobs.json", "-o", "out"}).exit_status, 0);
  const std::string summary = text_of(folder + "/out/summary.json"), report = folder + "/out/reports/needles";
  const std::string result = text_of(report + "/result.json");
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"compare", "out", "out", "--json", "out/summary.json"},
        {"compare", "out", "out", "--json", "out/results.sqlite"},
        {"accept", "out", "--all", "--reason", "x", "--by", "y", "-o", "out/summary.json"},
        {"check", "path.apt", "--part", "part.stl", "--report", "out/reports/needles"},
        {"check", "path.apt", "--part", "part.stl", "--report", "out/reports/new/of"},
        {"check", "path.apt", "--part", "part.stl", "--csv", "out/summary.csv"},
        {"correct", "path.apt", "--part", "part.stl", "-o", "out/corrected/needles.apt"},
        {"check", "path.apt", "--part", "part.stl", "--json", "out/reports/needles/manifest.json"},
        {"check", "path.apt", "--part", "part.stl", "--csv", "out/reports/needles/moves.csv"}}) {
    write_text(folder + "/path.apt", "UNITS/MM\nCUTTER/10\nLOADTL/1\nGOTO/0,0,50\nFINI\n");
    fs::copy_file(folder + "/needles/part.stl", folder + "/part.stl", fs::copy_options::overwrite_existing);
    EXPECT_EQ(run_gougecheck(folder, words).exit_status, 2) << words[0] << " " << words.back();
  }
  EXPECT_EQ(text_of(folder + "/out/summary.json"), summary);
  EXPECT_EQ(text_of(report + "/result.json"), result);
  EXPECT_FALSE(fs::exists(folder + "/out/reports/new"));
  EXPECT_EQ(run_batch(folder, {"jobs.json", "-o", "out"}).exit_status, 0) << "the folder is as it was";
}

TEST(Batch, OfTwoInOneFolderTheSecondIsRefused) {
  const std::string folder = samples_with_list({"pocket", "needles", "thin_post"});
  const Outcome ran = run_script(folder,
                                 "$GOUGECHECK batch jobs.json -o out -q & first=$!\n"
                                 "while [ ! -s out/results.sqlite ]; do :; done\n"
                                 "$GOUGECHECK batch jobs.json -o out; echo second $?\n"
                                 "wait $first; echo first $?\n");
  EXPECT_NE(ran.out.find("first 1\n"), std::string::npos) << ran.out;
  if (ran.out.find("second 5\n") != std::string::npos) {
    EXPECT_NE(ran.err.find("[store-busy]"), std::string::npos) << ran.err;
  }
}

// A job that ends the program, for example by using all memory, must not keep the other jobs from running.
TEST(Batch, JobsThatRanWhenAProcessEndedRunLast) {
  const std::string folder = samples_with_list({"needles"});
  const std::string gouge = "PARTNO/T\nUNITS/MM\nCUTTER/10\nLOADTL/1\nGOTO/0,0,40\nGOTO/0,0,-5\n";
  write_text(folder + "/large.apt", gouge + "$$ a long remark makes this file the larger one\nFINI\n");
  write_text(folder + "/small.apt", gouge + "FINI\n");
  const auto run = [&](const char* out) {
    return run_batch(folder, {"large.apt", "small.apt", "--part", "needles/part.stl", "--jobs", "1", "--stop-on",
                              "gouge", "--no-reports", "-o", out});
  };
  const auto verdicts = [&](const char* out) {
    const nlohmann::json summary = summary_of(folder + "/" + out);
    std::vector<std::string> all;
    for (const auto& job : summary.at("jobs")) all.push_back(job.at("verdict"));
    return all;
  };
  EXPECT_EQ(run("usual").exit_status, 1);
  EXPECT_EQ(verdicts("usual"), (std::vector<std::string>{"gouges", "not-run"}));
  EXPECT_FALSE(fs::exists(folder + "/usual/running"));
  fs::create_directories(folder + "/out/running");
  write_text(folder + "/out/running/" + sha256_of("large") + ".job", "large\n");
  const Outcome ran = run("out");
  EXPECT_NE(ran.err.find("out: note: an earlier run ended while it ran large; they run last"), std::string::npos)
      << ran.err;
  EXPECT_EQ(verdicts("out"), (std::vector<std::string>{"not-run", "gouges"}));
}

}  // namespace
}  // namespace gouge::testing_samples::batch_surroundings_test
