#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/samples/batch_folder.h"
#include "tests/samples/program.h"
#include "tests/samples/sample_folder.h"

// gougecheck batch and merge as their users run them.

namespace gouge::testing_samples {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

const std::vector<std::string> kSamples = {"pocket", "between_rib", "thin_post", "needles", "sunk_jaw", "between_head"};

std::string samples_with_list(const std::vector<std::string>& samples = kSamples) {
  const std::string folder = fresh_folder();
  EXPECT_EQ(run_make_samples(folder).exit_status, 0);
  write_job_list(folder, samples);
  return folder;
}

Outcome batch(const std::string& folder, std::vector<std::string> more) {
  more.insert(more.begin(), "batch");
  return run_gougecheck(folder, more);
}

Json summary_of(const std::string& folder) { return Json::parse(text_of(folder + "/summary.json")); }

TEST(Batch, SaysOfEveryJobWhatItsOwnCommandSays) {
  const std::string folder = samples_with_list();
  const Outcome ran = batch(folder, {"jobs.json", "-o", "out"});
  EXPECT_EQ(ran.exit_status, 1) << ran.out << ran.err;
  EXPECT_EQ(ran.err, "");
  const Json summary = summary_of(folder + "/out");
  EXPECT_EQ(summary.at("exit_status"), 1);
  ASSERT_EQ(summary.at("jobs").size(), 2 * kSamples.size());
  for (std::size_t k = 0; k < kSamples.size(); ++k) {
    const Json known = Json::parse(text_of(folder + "/" + kSamples[k] + "/expected.json"));
    const Json &checked = summary.at("jobs").at(2 * k), &corrected = summary.at("jobs").at(2 * k + 1);
    EXPECT_EQ(checked.at("job"), kSamples[k]);
    EXPECT_EQ(checked.at("status"), known.at("check_exit")) << kSamples[k];
    EXPECT_EQ(corrected.at("status"), known.at("correct_exit")) << kSamples[k];
    EXPECT_EQ(checked.at("moves"), known.at("moves")) << kSamples[k];
    EXPECT_NE(ran.out.find("\n" + kSamples[k]), std::string::npos) << ran.out;
  }
}

// What a job leaves is to the byte what its command alone leaves.
TEST(Batch, LeavesTheReportsAndPathsThatTheCommandsLeave) {
  const std::string folder = samples_with_list({"pocket"});
  ASSERT_EQ(batch(folder, {"jobs.json", "-o", "out"}).exit_status, 1);
  ASSERT_EQ(run_gougecheck(folder, {"check", "pocket/pocket.apt", "--part", "pocket/part.stl", "--fixture",
                                    "pocket/clamp.stl", "--tools", "pocket/tools.json", "--report", "alone"})
                .exit_status,
            1);
  const std::string reports = folder + "/out/reports/pocket";
  for (const auto& entry : fs::directory_iterator(folder + "/alone")) {
    const std::string name = entry.path().filename().string();
    EXPECT_TRUE(text_of(reports + "/" + name) == text_of(entry.path().string())) << name;
  }
  ASSERT_EQ(run_gougecheck(folder, {"correct", "pocket/pocket.apt", "--part", "pocket/part.stl", "--fixture",
                                    "pocket/clamp.stl", "--tools", "pocket/tools.json", "-o", "alone.apt"})
                .exit_status,
            0);
  EXPECT_EQ(text_of(folder + "/out/corrected/pocket corrected.apt"), text_of(folder + "/alone.apt"));
}

TEST(Batch, IsTheSameAtAnyNumberOfJobsAndThreadsAndInShards) {
  const std::string folder = samples_with_list();
  ASSERT_EQ(batch(folder, {"jobs.json", "-o", "one", "--jobs", "1", "--threads", "1"}).exit_status, 1);
  const auto expected = batch_files(folder + "/one");
  ASSERT_TRUE(expected.contains("index.html") && expected.contains("findings.sarif") &&
              expected.contains("reports/pocket/report.html"));
  for (const std::vector<std::string>& how :
       {std::vector<std::string>{"--jobs", "5"}, {"--jobs", "1", "--threads", "3"}, {"--memory", "0.05"}}) {
    std::vector<std::string> more = {"jobs.json", "-o", "other", "--fresh"};
    more.insert(more.end(), how.begin(), how.end());
    ASSERT_EQ(batch(folder, more).exit_status, 1);
    EXPECT_EQ(difference(expected, batch_files(folder + "/other")), "") << how.front();
  }
  for (const std::string shard : {"1", "2", "3"}) {
    const int status = batch(folder, {"jobs.json", "-o", "shard" + shard, "--shard", shard + "/3"}).exit_status;
    EXPECT_TRUE(status == 0 || status == 1);
  }
  const Outcome merged = run_gougecheck(folder, {"merge", "shard3", "shard1", "shard2", "-o", "merged"});
  EXPECT_EQ(merged.exit_status, 1) << merged.err;
  EXPECT_EQ(difference(expected, batch_files(folder + "/merged")), "");
  const Outcome incomplete = run_gougecheck(folder, {"merge", "shard3", "shard1", "-o", "half"});
  EXPECT_EQ(incomplete.exit_status, 3);
  EXPECT_NE(incomplete.err.find("4 of 12 jobs"), std::string::npos) << incomplete.err;
  EXPECT_FALSE(fs::exists(folder + "/half"));
}

TEST(Batch, RunsAgainWhatHasChangedAndNothingElse) {
  const std::string folder = samples_with_list({"pocket", "needles"});
  ASSERT_EQ(batch(folder, {"jobs.json", "-o", "out"}).exit_status, 1);
  const auto first = batch_files(folder + "/out");
  const auto again = [&](const std::string& expected) {
    const Outcome ran = batch(folder, {"jobs.json", "-o", "out"});
    EXPECT_NE(ran.out.find("\n" + expected), std::string::npos) << ran.out << ran.err;
  };
  again("4 jobs taken from the store, 0 run\n");
  EXPECT_EQ(difference(first, batch_files(folder + "/out")), "");
  std::ofstream(folder + "/pocket/pocket.apt", std::ios::app) << "$$ later\n";
  again("2 jobs taken from the store, 2 run\n");
  fs::remove(folder + "/out/corrected/needles corrected.apt");
  again("3 jobs taken from the store, 1 run\n");
  EXPECT_TRUE(fs::exists(folder + "/out/corrected/needles corrected.apt"));
  Json list = Json::parse(text_of(folder + "/jobs.json"));
  list["jobs"][2]["tolerance"] = 0.02;
  std::swap(list["jobs"][0], list["jobs"][3]);
  write_text(folder + "/jobs.json", list.dump());
  again("3 jobs taken from the store, 1 run\n");
  EXPECT_EQ(summary_of(folder + "/out").at("jobs").at(0).at("job"), "needles corrected");
  list["jobs"].erase(1);
  write_text(folder + "/jobs.json", list.dump());
  again("3 jobs taken from the store, 0 run\n");
  EXPECT_EQ(summary_of(folder + "/out").at("jobs").size(), 3U);
}

TEST(Batch, GoesOnWhenAJobFailsUnlessAskedNotTo) {
  const std::string folder = samples_with_list({"needles", "thin_post"});
  Json list = Json::parse(text_of(folder + "/jobs.json"));
  list["jobs"][0]["part"] = {"gone.stl"};
  write_text(folder + "/jobs.json", list.dump());
  const Outcome ran = batch(folder, {"jobs.json", "-o", "out", "--jobs", "1"});
  EXPECT_EQ(ran.exit_status, 3);
  EXPECT_NE(ran.out.find("4 jobs: 1 failed, 1 gouges, 2 clean\n"), std::string::npos) << ran.out;
  const Json failed = summary_of(folder + "/out").at("jobs").at(0);
  EXPECT_EQ(failed.at("verdict"), "failed");
  EXPECT_NE(failed.at("messages").dump().find("gone.stl"), std::string::npos) << failed;
  EXPECT_NE(text_of(folder + "/out/junit.xml").find("<error message="), std::string::npos);
  EXPECT_NE(text_of(folder + "/out/index.html").find("gone.stl"), std::string::npos);
  const Outcome stopped = batch(folder, {"jobs.json", "-o", "stopped", "--jobs", "1", "--stop-on", "gouge"});
  EXPECT_NE(stopped.out.find("stopped as asked"), std::string::npos) << stopped.out;
  EXPECT_NE(stopped.out.find("not-run"), std::string::npos) << stopped.out;
  const Outcome resumed = batch(folder, {"jobs.json", "-o", "stopped", "--resume"});
  EXPECT_EQ(resumed.out.find("not-run"), std::string::npos) << resumed.out;
  EXPECT_EQ(difference(batch_files(folder + "/out"), batch_files(folder + "/stopped")), "");
}

TEST(Batch, ChecksToolpathsNamedOnTheCommandLine) {
  const std::string folder = samples_with_list({"needles"});
  fs::copy_file(folder + "/needles/needles.apt", folder + "/needles/second.apt");
  const Outcome ran =
      run_script(folder, "$GOUGECHECK batch needles/*.apt --part needles/part.stl --tools needles/tools.json -o out");
  EXPECT_EQ(ran.exit_status, 0) << ran.err;
  EXPECT_EQ(summary_of(folder + "/out").at("jobs").size(), 2U);
  const Outcome listed =
      batch(folder, {"needles/needles.apt", "--part", "needles/part.stl", "-o", "none", "--dry-run"});
  EXPECT_EQ(listed.out, "needles: check --part=needles/part.stl needles/needles.apt\n");
  EXPECT_FALSE(fs::exists(folder + "/none"));
}

#ifdef GOUGE_MPI
constexpr bool kHasMpi = true;
#else
constexpr bool kHasMpi = false;
#endif

// As root too, on fewer cores than ranks, and on machines without a network.
const std::string kMpirun =
    "export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 "
    "OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_MCA_plm_rsh_agent=\n";

TEST(Batch, IsTheSameUnderMpirunAndAfterARankIsKilled) {
  if (!kHasMpi) GTEST_SKIP() << "built without MPI (Debian: libopenmpi-dev, openmpi-bin)";
  const std::string folder = samples_with_list();
  ASSERT_EQ(batch(folder, {"jobs.json", "-o", "one"}).exit_status, 1);
  const auto expected = batch_files(folder + "/one");
  for (const std::string ranks : {"1", "3"}) {
    const Outcome ran =
        run_script(folder, kMpirun + "mpirun -n " + ranks + " $GOUGECHECK batch jobs.json -o ranks" + ranks);
    EXPECT_EQ(ran.exit_status, 1) << ran.err;
    EXPECT_EQ(difference(expected, batch_files(folder + "/ranks" + ranks)), "");
    EXPECT_NE(ran.out.find("12 jobs: "), std::string::npos) << ran.out;
    EXPECT_EQ(ran.out.find("12 jobs: "), ran.out.rfind("12 jobs: ")) << "said once";
  }
  const Outcome killed =
      run_script(folder, kMpirun +
                             "mpirun -n 3 $GOUGECHECK batch jobs.json -o killed -q & all=$!\n"
                             "while [ ! -e killed/results-rank-2.sqlite ]; do sleep 0.01; done; sleep 0.3\n"
                             "kill -9 $(pgrep -f 'batch jobs.json -o killed -q' -P $all | tail -n 1)\n"
                             "wait $all; echo killed $?\n"
                             "mpirun -n 2 $GOUGECHECK batch jobs.json -o killed -q --resume; echo resumed $?");
  EXPECT_NE(killed.out.find("resumed 1\n"), std::string::npos) << killed.out << killed.err;
  EXPECT_EQ(difference(expected, batch_files(folder + "/killed")), "");
}

TEST(Batch, SaysThatMpirunIsOfNoUseWithoutMpi) {
  if (kHasMpi) GTEST_SKIP() << "built with MPI";
  const std::string folder = samples_with_list({"needles"});
  const Outcome ran = run_script(folder, "OMPI_COMM_WORLD_SIZE=2 $GOUGECHECK batch jobs.json -o out");
  EXPECT_EQ(ran.exit_status, 2);
  EXPECT_NE(ran.err.find("built without MPI"), std::string::npos) << ran.err;
}

// A CAM system writes a file in pieces, and a program beside it has one with another ending for a while.
TEST(Batch, WatchesAFolderAndChecksWhatIsWrittenThere) {
  const std::string folder = samples_with_list({"needles", "thin_post"});
  const Outcome ran = run_script(
      folder,
      "mkdir hot; cp needles/needles.apt hot/first.apt\n"
      "$GOUGECHECK batch --watch hot --part needles/part.stl --tools needles/tools.json -o out > log & watch=$!\n"
      "wait_for() { for i in $(seq 300); do grep -q \"$1\" out/summary.csv 2>/dev/null && return; sleep 0.1; done; echo no $1; }\n"
      "wait_for '^first,'\n"
      "head -c 2000 needles/needles.apt > hot/second.apt; cp needles/needles.apt hot/third.apt.tmp; sleep 0.5\n"
      "tail -c +2001 needles/needles.apt >> hot/second.apt\n"
      "wait_for '^second,'; kill -TERM $watch; wait $watch; echo ended $?; cat log");
  EXPECT_NE(ran.out.find("ended 143\n"), std::string::npos) << ran.out << ran.err;
  EXPECT_EQ(ran.out.find("no ^"), std::string::npos) << ran.out;
  const Json jobs = summary_of(folder + "/out").at("jobs");
  ASSERT_EQ(jobs.size(), 2U);
  EXPECT_EQ(jobs.at(1).at("moves"), jobs.at(0).at("moves")) << "the whole file";
  EXPECT_NE(ran.out.find("1 job taken from the store, 1 run\n"), std::string::npos) << ran.out;
}

struct WrongList {
  const char* text;
  const char* said;
};

TEST(Batch, WrongListsAreRefusedWithTheirLineBeforeAnythingBegins) {
  const std::string folder = samples_with_list({"needles"});
  const WrongList wrong_lists[] = {
      {"{\"jobs\": [\n{\"path\": \"a.apt\", \"part\": \"p.stl\",\n \"tolerence\": 1}]}",
       "wrong.json:3: error: job a.apt: \"tolerence\" is no option of check"},
      {"{\"jobs\": [\n{\"path\": \"a.apt\", \"part\": \"p.stl\",\n \"tolerance\": \"wide\"}]}",
       "wrong.json:2: error: job a: --tolerance 'wide'"},
      {"{\"jobs\": [\n{\"path\": \"a.apt\"}]}", "wrong.json:2: error: job a: gougecheck check needs --part"},
      {"{\"jobs\": [\n{\"part\": \"p.stl\"}]}", "wrong.json:2: error: a job has no \"path\""},
      {"{\"jobs\": [\n{\"path\": \"x*.apt\", \"part\": \"p.stl\"}]}", "wrong.json:2: error: no file is like"},
      {"{\"jobs\": [{\"path\": \"a.apt\", \"part\": \"p.stl\"},\n{\"path\": \"b/a.apt\", \"part\": \"p.stl\"}]}",
       "wrong.json:2: error: a second job is called a, as that of line 1"},
      {"{\"jobs\": [{\"name\": \"../x\", \"path\": \"a.apt\", \"part\": \"p.stl\"}]}", "cannot be"},
      {"{\"jobs\": [{\"path\": \"a.apt\", \"part\": \"p.stl\", \"threads\": 2}]}", "is an option of the batch"},
      {"{\"jobs\": [{\"path\": \"a.apt\", \"part\": \"p.stl\", \"json\": \"a.apt\"}]}",
       "--json 'a.apt' is the toolpath of job a"},
      {"{\"jobs\": [{\"path\": \"a.apt\", \"part\": \"p.stl\", \"csv\": \"-\"}]}", "standard output is the batch's"},
      {"{\"jobs\": [{\"path\": \"a.apt\", \"part\": \"p.stl\", \"command\": \"mesh\"}]}", "expected check or correct"},
      {"{\"jobs\": []}", "at least one job"},
      {"{\"job\": []}", "has no \"job\""},
      {"[1]", "expected a job list"},
      {"{\"jobs\": [", "this is not JSON"}};
  for (const WrongList& wrong : wrong_lists) {
    write_text(folder + "/wrong.json", wrong.text);
    const Outcome ran = batch(folder, {"wrong.json", "-o", "out"});
    EXPECT_TRUE(ran.exit_status == 2 || ran.exit_status == 3) << wrong.text;
    const std::string said = std::string(wrong.said) == "cannot be" ? "begins with ." : wrong.said;
    EXPECT_NE(ran.err.find(said), std::string::npos) << wrong.text << "\n" << ran.err;
    EXPECT_FALSE(fs::exists(folder + "/out")) << wrong.text;
  }
}

TEST(Batch, LeavesWhatIsNotItsOwnAlone) {
  const std::string folder = samples_with_list({"needles"});
  fs::create_directories(folder + "/out");
  write_text(folder + "/out/summary.csv", "mine\n");
  const Outcome ran = batch(folder, {"jobs.json", "-o", "out"});
  EXPECT_EQ(ran.exit_status, 2);
  EXPECT_NE(ran.err.find("summary.csv"), std::string::npos) << ran.err;
  EXPECT_EQ(text_of(folder + "/out/summary.csv"), "mine\n");
  EXPECT_FALSE(fs::exists(folder + "/out/results.sqlite"));
  fs::remove(folder + "/out/summary.csv");
  write_text(folder + "/out/results.sqlite", "mine too, and long enough to be taken for a file of somebody else's\n");
  const Outcome foreign = batch(folder, {"jobs.json", "-o", "out"});
  EXPECT_EQ(foreign.exit_status, 5);
  EXPECT_NE(foreign.err.find("is no store of a batch"), std::string::npos) << foreign.err;
  EXPECT_EQ(text_of(folder + "/out/results.sqlite").substr(0, 8), "mine too");
}

TEST(Batch, LeavesCorrectedPathsThatAreNotItsOwnAlone) {
  const std::string folder = samples_with_list({"pocket"});
  const std::string corrected = folder + "/out/corrected/pocket corrected.apt";
  fs::create_directories(folder + "/out/corrected");
  write_text(corrected, "mine\n");
  EXPECT_EQ(batch(folder, {"jobs.json", "-o", "out"}).exit_status, 2);
  EXPECT_EQ(text_of(corrected), "mine\n");
  fs::remove(corrected);
  ASSERT_EQ(batch(folder, {"jobs.json", "-o", "out"}).exit_status, 1);
  std::ofstream(corrected, std::ios::app) << "$$ mine\n";
  const std::string edited = text_of(corrected);
  const Outcome again = batch(folder, {"jobs.json", "-o", "out"});
  EXPECT_EQ(again.exit_status, 2);
  EXPECT_NE(again.err.find("pocket corrected.apt"), std::string::npos) << again.err;
  EXPECT_EQ(text_of(corrected), edited);
  EXPECT_EQ(batch(folder, {"jobs.json", "-o", "out", "--force"}).exit_status, 1);
  EXPECT_NE(text_of(corrected), edited);
}

// A job that can no longer be corrected has no corrected path left over from when it could.
TEST(Batch, LeavesNoCorrectedPathOfAJobThatFailsNow) {
  const std::string folder = samples_with_list({"pocket"});
  ASSERT_EQ(batch(folder, {"jobs.json", "-o", "out"}).exit_status, 1);
  write_text(folder + "/pocket/part.stl", "solid broken\n");
  EXPECT_EQ(batch(folder, {"jobs.json", "-o", "out"}).exit_status, 3);
  EXPECT_FALSE(fs::exists(folder + "/out/corrected/pocket corrected.apt"));
}

TEST(Batch, JoinsNoSharesThatReadDifferentContentsOfOneFile) {
  const std::string folder = samples_with_list({"needles"});
  EXPECT_EQ(batch(folder, {"jobs.json", "-o", "s1", "--shard", "1/2"}).exit_status, 0);
  ASSERT_EQ(
      run_script(folder, "$GOUGECHECK mesh thin_post/part.stl -q; cp thin_post/part.stl needles/part.stl").exit_status,
      0);
  const int second = batch(folder, {"jobs.json", "-o", "s2", "--shard", "2/2"}).exit_status;
  EXPECT_NE(second, 2);
  const Outcome merged = run_gougecheck(folder, {"merge", "s1", "s2", "-o", "m"});
  EXPECT_EQ(merged.exit_status, 3);
  EXPECT_NE(merged.err.find("needles/part.stl had another content"), std::string::npos) << merged.err;
  EXPECT_FALSE(fs::exists(folder + "/m"));
  const Outcome other = batch(folder, {"jobs.json", "-o", "s1", "--shard", "2/2"});
  EXPECT_EQ(other.exit_status, 2);
  EXPECT_NE(other.err.find("another share"), std::string::npos) << other.err;
}

// A store may come from somebody else, and name files that are none of the batch.
TEST(Batch, JoinsNoFilesFromOutsideOfAShare) {
  const std::string folder = samples_with_list({"needles"});
  ASSERT_EQ(batch(folder, {"jobs.json", "-o", "s"}).exit_status, 0);
  write_text(folder + "/secret", "x");
  const std::string hash = "2d711642b726b04401627ca9fbac32f5c8530fb1903cc4db02258717921a4881";
  change_store(folder + "/s/results.sqlite", "INSERT INTO outputs VALUES(0, 99, '../secret', 1, '" + hash + "')");
  const Outcome merged = run_gougecheck(folder, {"merge", "s", "-o", "m/m"});
  EXPECT_EQ(merged.exit_status, 3) << merged.out << merged.err;
  EXPECT_NE(merged.err.find("../secret"), std::string::npos) << merged.err;
  EXPECT_FALSE(fs::exists(folder + "/m"));
}

TEST(Batch, TakesAFileForItselfBeforeItTakesItForAPattern) {
  const std::string folder = samples_with_list({"needles", "thin_post"});
  fs::copy_file(folder + "/needles/needles.apt", folder + "/x1.apt");
  fs::copy_file(folder + "/thin_post/thin_post.apt", folder + "/x[1].apt");
  write_text(folder + "/one.json",
             "{\"jobs\": [{\"path\": \"x[1].apt\", \"part\": \"thin_post/part.stl\", \"tools\": "
             "\"thin_post/tools.json\", \"report\": false}]}");
  EXPECT_EQ(batch(folder, {"one.json", "-o", "out"}).exit_status, 1);
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
    const Outcome ran = batch(folder, {"wrong.json", "-o", "out"});
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

TEST(Batch, SaysThatItsFolderCannotBeWritten) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  const std::string folder = samples_with_list({"needles"});
  fs::create_directories(folder + "/out");
  ::chmod((folder + "/out").c_str(), 0555);
  const Outcome ran = batch(folder, {"jobs.json", "-o", "out"});
  EXPECT_EQ(ran.exit_status, 5) << ran.err;
  ::chmod((folder + "/out").c_str(), 0755);
}

TEST(Batch, OfALaterVersionIsLeftAsItIs) {
  const std::string folder = samples_with_list({"needles"});
  ASSERT_EQ(batch(folder, {"jobs.json", "-o", "out", "--no-reports"}).exit_status, 0);
  ASSERT_EQ(
      run_script(folder, "printf '\\0\\0\\0\\143' | dd of=out/results.sqlite bs=1 seek=60 conv=notrunc 2>/dev/null")
          .exit_status,
      0);
  const std::string before = text_of(folder + "/out/results.sqlite");
  const Outcome ran = batch(folder, {"jobs.json", "-o", "out"});
  EXPECT_EQ(ran.exit_status, 5);
  EXPECT_NE(ran.err.find("another version"), std::string::npos) << ran.err;
  EXPECT_TRUE(text_of(folder + "/out/results.sqlite") == before);
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
    EXPECT_NE(ran.err.find("-busy"), std::string::npos) << ran.err;
  }
}

}  // namespace
}  // namespace gouge::testing_samples
