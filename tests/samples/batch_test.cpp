#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/samples/batch_folder.h"
#include "tests/samples/program.h"
#include "tests/samples/sample_folder.h"
#include "tests/samples/small_shop.h"

// gougecheck batch and merge as their users run them.

namespace gouge::testing_samples::batch_test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

const std::vector<std::string> kSamples = {"pocket", "between_rib", "thin_post", "needles", "sunk_jaw", "between_head"};

TEST(Batch, SaysOfEveryJobWhatItsOwnCommandSays) {
  const std::string folder = samples_with_list(kSamples);
  const Outcome ran = run_batch(folder, {"jobs.json", "-o", "out"});
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

// The page of a report without the links to other reports of its batch, which stand in one line.
std::string without_links(std::string page) {
  const std::size_t begin = page.find("<nav ");
  if (begin != std::string::npos) page.erase(begin, page.find('\n', begin) + 1 - begin);
  return page;
}

// The outputs of a job equal those of its command alone, byte for byte, except for the links between reports. The
// manifest has the hash of the page.
TEST(Batch, LeavesTheReportsAndPathsThatTheCommandsLeave) {
  const std::string folder = samples_with_list({"pocket"});
  ASSERT_EQ(run_batch(folder, {"jobs.json", "-o", "out"}).exit_status, 1);
  ASSERT_EQ(run_gougecheck(folder, {"check", "pocket/pocket.apt", "--part", "pocket/part.stl", "--fixture",
                                    "pocket/clamp.stl", "--tools", "pocket/tools.json", "--report", "alone"})
                .exit_status,
            1);
  const std::string reports = folder + "/out/reports/pocket";
  for (const auto& entry : fs::directory_iterator(folder + "/alone")) {
    const std::string name = entry.path().filename().string();
    if (name == "manifest.json") continue;
    EXPECT_TRUE(without_links(text_of(reports + "/" + name)) == text_of(entry.path().string())) << name;
  }
  EXPECT_NE(text_of(reports + "/report.html").find("index.html#after=pocket\">Next report"), std::string::npos);
  ASSERT_EQ(run_gougecheck(folder, {"correct", "pocket/pocket.apt", "--part", "pocket/part.stl", "--fixture",
                                    "pocket/clamp.stl", "--tools", "pocket/tools.json", "-o", "alone.apt"})
                .exit_status,
            0);
  EXPECT_EQ(text_of(folder + "/out/corrected/pocket corrected.apt"), text_of(folder + "/alone.apt"));
}

TEST(Batch, IsTheSameAtAnyNumberOfJobsAndThreadsAndInShards) {
  const std::string folder = samples_with_list(kSamples);
  ASSERT_EQ(run_batch(folder, {"jobs.json", "-o", "one", "--jobs", "1", "--threads", "1"}).exit_status, 1);
  const auto expected = batch_files(folder + "/one");
  ASSERT_TRUE(expected.contains("index.html") && expected.contains("findings.sarif") &&
              expected.contains("reports/pocket/report.html"));
  for (const std::vector<std::string>& how :
       {std::vector<std::string>{"--jobs", "5"}, {"--jobs", "1", "--threads", "3"}, {"--memory", "0.05"}}) {
    std::vector<std::string> more = {"jobs.json", "-o", "other", "--fresh"};
    more.insert(more.end(), how.begin(), how.end());
    ASSERT_EQ(run_batch(folder, more).exit_status, 1);
    EXPECT_EQ(difference(expected, batch_files(folder + "/other")), "") << how.front();
  }
  for (const std::string shard : {"1", "2", "3"}) {
    const int status = run_batch(folder, {"jobs.json", "-o", "shard" + shard, "--shard", shard + "/3"}).exit_status;
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
  ASSERT_EQ(run_batch(folder, {"jobs.json", "-o", "out"}).exit_status, 1);
  const auto first = batch_files(folder + "/out");
  const auto again = [&](const std::string& expected) {
    const Outcome ran = run_batch(folder, {"jobs.json", "-o", "out"});
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
  const Outcome ran = run_batch(folder, {"jobs.json", "-o", "out", "--jobs", "1"});
  EXPECT_EQ(ran.exit_status, 3);
  EXPECT_NE(ran.out.find("4 jobs: 1 failed, 1 gouges, 2 clean\n"), std::string::npos) << ran.out;
  const Json failed = summary_of(folder + "/out").at("jobs").at(0);
  EXPECT_EQ(failed.at("verdict"), "failed");
  EXPECT_NE(failed.at("messages").dump().find("gone.stl"), std::string::npos) << failed;
  EXPECT_NE(text_of(folder + "/out/junit.xml").find("<error message="), std::string::npos);
  EXPECT_NE(text_of(folder + "/out/index.html").find("gone.stl"), std::string::npos);
  const Outcome stopped = run_batch(folder, {"jobs.json", "-o", "stopped", "--jobs", "1", "--stop-on", "gouge"});
  EXPECT_NE(
      stopped.out.find("stopped by --stop-on gouge; the same command without it, and with --resume, runs the rest"),
      std::string::npos)
      << stopped.out;
  EXPECT_NE(stopped.out.find("not-run"), std::string::npos) << stopped.out;
  const Outcome resumed = run_batch(folder, {"jobs.json", "-o", "stopped", "--resume"});
  EXPECT_EQ(resumed.out.find("not-run"), std::string::npos) << resumed.out;
  EXPECT_EQ(difference(batch_files(folder + "/out"), batch_files(folder + "/stopped")), "");
}

TEST(Batch, PrintsTheErrorsOfFailedJobsAlsoWhereItIsQuiet) {
  const std::string folder = samples_with_list({"needles"});
  const Outcome ran = run_script(
      folder,
      "$GOUGECHECK batch gone.apt needles/needles.apt --part needles/part.stl --tools needles/tools.json -o out -q");
  EXPECT_EQ(ran.exit_status, 3);
  EXPECT_EQ(ran.out, "");
  EXPECT_EQ(ran.err, "job gone: gone.apt: error: no such file [file-not-found]\n");
}

TEST(Batch, ChecksToolpathsNamedOnTheCommandLine) {
  const std::string folder = samples_with_list({"needles"});
  fs::copy_file(folder + "/needles/needles.apt", folder + "/needles/second.apt");
  const Outcome ran =
      run_script(folder, "$GOUGECHECK batch needles/*.apt --part needles/part.stl --tools needles/tools.json -o out");
  EXPECT_EQ(ran.exit_status, 0) << ran.err;
  EXPECT_EQ(summary_of(folder + "/out").at("jobs").size(), 2U);
  const Outcome listed =
      run_batch(folder, {"needles/needles.apt", "--part", "needles/part.stl", "-o", "none", "--dry-run"});
  EXPECT_EQ(listed.out, "needles: check --part=needles/part.stl needles/needles.apt\n");
  EXPECT_EQ(listed.exit_status, 0) << listed.err;
  const Outcome missing = run_batch(folder, {"needles/needles.apt", "gone.apt", "--part", "needles/part.stl", "--tools",
                                             "no.json", "-o", "none", "--dry-run"});
  EXPECT_EQ(missing.exit_status, 3);
  EXPECT_NE(missing.out.find("needles: check"), std::string::npos) << missing.out;
  EXPECT_EQ(missing.err,
            "job needles: no.json: error: no such file [file-not-found]\n"
            "job gone: gone.apt: error: no such file [file-not-found]\n"
            "job gone: no.json: error: no such file [file-not-found]\n");
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

TEST(Batch, ChecksRemainingStockAndSearchesForCuresOfPathsOnTheCommandLine) {
  const SampleFolder sample = open_sample("holder_stock");
  const std::vector<std::string> words = sample.arguments(
      "check", "holder_stock.apt", {"--stock", "box", "--excess", "5", "--find-cures", "--find-stickout"});
  const Outcome checked = run_gougecheck(sample.path, [&] {
    std::vector<std::string> all = words;
    all.insert(all.end(), {"--json", "alone.json"});
    return all;
  }());
  std::vector<std::string> of_batch = words;
  of_batch.front() = "batch";
  of_batch.insert(of_batch.end(), {"-o", "out"});
  const Outcome ran = run_gougecheck(sample.path, of_batch);
  EXPECT_EQ(ran.exit_status, checked.exit_status) << ran.err;
  EXPECT_EQ(Json::parse(text_of(sample.path + "/out/reports/holder_stock/result.json")),
            Json::parse(text_of(sample.path + "/alone.json")));
}

TEST(Batch, IsTheSameUnderMpirunAndAfterARankIsKilled) {
  if (!kHasMpi) GTEST_SKIP() << "built without MPI (Debian: libopenmpi-dev, openmpi-bin)";
  const std::string folder = samples_with_list(kSamples);
  ASSERT_EQ(run_batch(folder, {"jobs.json", "-o", "one"}).exit_status, 1);
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

// The numbers of meshes that processes state they copied, together.
int meshes_copied(const std::string& err) {
  const std::string before = "holds ";
  int meshes = 0;
  for (std::size_t at = err.find(before); at != std::string::npos; at = err.find(before, at + 1))
    meshes += std::stoi(err.substr(at + before.size()));
  return meshes;
}

TEST(Batch, ReadsEachMeshOnceForAllProcessesOfAMachine) {
  const std::string folder = samples_with_list(kSamples);
  fs::create_directories(folder + "/disk");
  ASSERT_EQ(run_batch(folder, {"jobs.json", "-o", "one"}).exit_status, 1);
  const auto expected = batch_files(folder + "/one");
  std::set<std::string> meshes;
  const Json list = Json::parse(text_of(folder + "/jobs.json"));
  for (const Json& job : list.at("jobs")) {
    for (const char* key : {"part", "fixture", "head"}) {
      for (const auto& file : job.value(key, Json::array())) meshes.insert(file.get<std::string>());
    }
  }
  const std::string batch = "$GOUGECHECK batch jobs.json -v --scratch disk -o ";
  const auto run = [&](const std::string& how, const std::string& out) {
    const Outcome ran = run_script(folder, kMpirun + how + batch + out);
    EXPECT_EQ(ran.exit_status, 1) << ran.err;
    EXPECT_EQ(meshes_copied(ran.err), static_cast<int>(meshes.size())) << ran.err;
    EXPECT_EQ(difference(expected, batch_files(folder + "/" + out)), "") << out;
    EXPECT_TRUE(fs::is_empty(folder + "/disk"));
  };
  run("", "alone");
  if (!kHasMpi) return;
  run("mpirun -n 3 ", "ranks");
  const Outcome killed = run_script(folder, kMpirun + "mpirun -n 3 " + batch +
                                                "killed & all=$!\n"
                                                "while [ -z \"$(ls disk)\" ]; do sleep 0.01; done; sleep 0.1\n"
                                                "kill -9 $(pgrep -f 'batch jobs.json' -P $all | tail -n 1)\n"
                                                "wait $all; mpirun -n 2 " +
                                                batch + "killed --resume; echo resumed $?");
  EXPECT_NE(killed.out.find("resumed 1\n"), std::string::npos) << killed.out << killed.err;
  EXPECT_EQ(difference(expected, batch_files(folder + "/killed")), "");
  EXPECT_TRUE(fs::is_empty(folder + "/disk"));
}

TEST(Batch, GoesOnWithoutADiskOfItsOwn) {
  const std::string folder = samples_with_list({"needles"});
  const Outcome ran = run_batch(folder, {"jobs.json", "-o", "out", "--scratch", "gone"});
  EXPECT_EQ(ran.exit_status, 0) << ran.err;
  EXPECT_NE(ran.err.find("meshes are read where they are; the results are the same [scratch-unusable]\n"),
            std::string::npos)
      << ran.err;
}

TEST(Batch, SaysThatMpirunIsOfNoUseWithoutMpi) {
  if (kHasMpi) GTEST_SKIP() << "built with MPI";
  const std::string folder = samples_with_list({"needles"});
  const Outcome ran = run_script(folder, "OMPI_COMM_WORLD_SIZE=2 $GOUGECHECK batch jobs.json -o out");
  EXPECT_EQ(ran.exit_status, 2);
  EXPECT_NE(ran.err.find("built without MPI"), std::string::npos) << ran.err;
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
       "wrong.json:3: error: job a: --tolerance 'wide'"},
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
      {"{\"jobs\": [{\"path\": \"a.apt\", \"part\": \"p.stl\", \"csv\": \"b\\u0000.csv\"}]}",
       "\"csv\" holds the character U+0000"},
      {"{\"jobs\": [{\"path\": \"a.apt\\u0000b\", \"part\": \"p.stl\"}]}", "one with the character U+0000"},
      {"{\"jobs\": [{\"name\": \"\\u0000\", \"path\": \"a.apt\", \"part\": \"p.stl\"}]}",
       "\"name\" is no text, empty, or holds the character U+0000"},
      {"{\"jobs\": []}", "at least one job"},
      {"{\"job\": []}", "has no \"job\""},
      {"[1]", "expected a job list"},
      {"{\"jobs\": [", "this is not JSON"}};
  for (const WrongList& wrong : wrong_lists) {
    write_text(folder + "/wrong.json", wrong.text);
    const Outcome ran = run_batch(folder, {"wrong.json", "-o", "out"});
    EXPECT_TRUE(ran.exit_status == 2 || ran.exit_status == 3) << wrong.text;
    const std::string said = std::string(wrong.said) == "cannot be" ? "begins with ." : wrong.said;
    EXPECT_NE(ran.err.find(said), std::string::npos) << wrong.text << "\n" << ran.err;
    EXPECT_FALSE(fs::exists(folder + "/out")) << wrong.text;
  }
}

TEST(Batch, TakesABaselineInAJobAndRunsItAgainWhenThatChanges) {
  const std::string folder = samples_with_list({"pocket"});
  Json list = Json::parse(text_of(folder + "/jobs.json"));
  list["jobs"][0]["baseline"] = "accepted.json";
  list["jobs"].erase(1);
  write_text(folder + "/jobs.json", list.dump());
  const Outcome accepted = run_script(
      folder,
      "$GOUGECHECK check pocket/pocket.apt --part pocket/part.stl --fixture pocket/clamp.stl --tools "
      "pocket/tools.json --json result.json -q\n"
      "$GOUGECHECK accept result.json -o accepted.json --finding 1 --finding 2 --finding 3 --reason 'as agreed' --by test");
  ASSERT_EQ(accepted.exit_status, 0) << accepted.err;
  const Outcome ran = run_batch(folder, {"jobs.json", "-o", "out"});
  EXPECT_EQ(ran.exit_status, 0) << ran.out << ran.err;
  EXPECT_EQ(summary_of(folder + "/out").at("jobs").at(0).at("verdict"), "accepted-gouges");
  EXPECT_NE(run_batch(folder, {"jobs.json", "-o", "out"}).out.find("1 job taken from the store, 0 run\n"),
            std::string::npos);
  write_text(folder + "/accepted.json", text_of(folder + "/accepted.json") + "\n");
  EXPECT_EQ(run_batch(folder, {"jobs.json", "-o", "out"}).out.find("1 job taken"), std::string::npos);
  fs::remove(folder + "/accepted.json");
  EXPECT_EQ(run_batch(folder, {"jobs.json", "-o", "out"}).exit_status, 3);
}

TEST(Batch, TheBaselineOfTheDefaultsHoldsForChecksAlone) {
  const std::string folder = samples_with_list({"pocket"});
  Json list = Json::parse(text_of(folder + "/jobs.json"));
  list["defaults"]["baseline"] = "accepted.json";
  write_text(folder + "/jobs.json", list.dump());
  ASSERT_EQ(list["jobs"][1]["command"], "correct");
  const Outcome accepted =
      run_script(folder,
                 "$GOUGECHECK check pocket/pocket.apt --part pocket/part.stl --fixture pocket/clamp.stl --tools "
                 "pocket/tools.json --json result.json -q\n"
                 "$GOUGECHECK accept result.json -o accepted.json --all --reason 'as agreed' --by test");
  ASSERT_EQ(accepted.exit_status, 0) << accepted.err;
  const Outcome ran = run_batch(folder, {"jobs.json", "-o", "out"});
  EXPECT_EQ(summary_of(folder + "/out").at("jobs").at(0).at("verdict"), "accepted-gouges") << ran.err;
  EXPECT_NE(summary_of(folder + "/out").at("jobs").at(1).at("verdict"), "failed") << ran.err;
  EXPECT_NE(
      ran.err.find("jobs.json: note: \"baseline\" of the defaults does not hold for 1 job with the command correct "
                   "[jobs-baseline]\n"),
      std::string::npos)
      << ran.err;
  list["jobs"][1]["baseline"] = "accepted.json";
  write_text(folder + "/jobs.json", list.dump());
  const Outcome refused = run_batch(folder, {"jobs.json", "-o", "out"});
  EXPECT_EQ(refused.exit_status, 3);
  EXPECT_NE(refused.err.find("\"baseline\" is no option of correct"), std::string::npos) << refused.err;
}

TEST(Batch, ListsNotesToTheAskingAndNamesOpenFactsFirst) {
  const SmallShop shop;
  shop.write("part.stl", plate_stl());
  shop.write("op.apt", path_text(stations({{40, -0.2}})));
  const std::vector<std::string> words = {"batch",       "op.apt", "--part",      "part.stl",    "--place",
                                          "0,0,-300",    "-o",     "out",         "--tolerance", "6",
                                          "--tip-frame", "table",  "--no-reports"};
  const Outcome plain = shop.run(words);
  EXPECT_EQ(plain.exit_status, 4) << plain.err;
  EXPECT_EQ(plain.err.find("[option-unused]"), std::string::npos) << plain.err;
  EXPECT_NE(plain.out.find("2 warnings; -v lists them\n"), std::string::npos) << plain.out;
  EXPECT_NE(plain.out.find("op: op.apt: warning: no move reaches the part"), std::string::npos) << plain.out;
  const std::string page = shop.read("out/index.html");
  EXPECT_NE(page.find("<td>op.apt: warning: no move reaches the part"), std::string::npos);
  std::vector<std::string> verbose = words;
  verbose.emplace_back("-v");
  const Outcome listed = shop.run(verbose);
  for (const char* code : {"[option-unused]", "[tolerance-large]"}) {
    const std::size_t at = listed.err.find(code);
    EXPECT_NE(at, std::string::npos) << code << listed.err;
    EXPECT_EQ(at, listed.err.rfind(code)) << "once: " << listed.err;
  }
  EXPECT_EQ(shop.json("out/findings.sarif").dump().find("option-unused"), std::string::npos) << "warnings alone";
}

TEST(Batch, TakesAFileForItselfBeforeItTakesItForAPattern) {
  const std::string folder = samples_with_list({"needles", "thin_post"});
  fs::copy_file(folder + "/needles/needles.apt", folder + "/x1.apt");
  fs::copy_file(folder + "/thin_post/thin_post.apt", folder + "/x[1].apt");
  write_text(folder + "/one.json",
             "{\"jobs\": [{\"path\": \"x[1].apt\", \"part\": \"thin_post/part.stl\", \"tools\": "
             "\"thin_post/tools.json\", \"report\": false}]}");
  EXPECT_EQ(run_batch(folder, {"one.json", "-o", "out"}).exit_status, 1);
}

TEST(Batch, AWrongValueIsReportedInItsLineAlsoInTheDefaults) {
  const std::string folder = samples_with_list({"needles"});
  const auto error_of = [&](const std::string& defaults, const std::string& own) {
    write_text(folder + "/list.json", "{\"defaults\": {\n \"part\": \"needles/part.stl\"" + defaults +
                                          "},\n\"jobs\": [\n{\"path\": \"needles/needles.apt\"" + own + "}]}\n");
    return run_gougecheck(folder, {"batch", "list.json", "-o", "out"}).err;
  };
  EXPECT_EQ(error_of(",\n \"tolerance\": -1", "").find("list.json:3: error: job needles: --tolerance"), 0U)
      << error_of(",\n \"tolerance\": -1", "");
  EXPECT_EQ(error_of("", ",\n \"tolerance\": -1").find("list.json:5: error: job needles: --tolerance"), 0U);
}

TEST(Batch, CountsTheRapidsThatAreLeftOutAsAsked) {
  const std::string folder = samples_with_list({"needles"});
  write_text(folder + "/rapids.apt",
             "UNITS/MM\nCUTTER/10\nLOADTL/1\nGOTO/0,0,900\nRAPID\nGOTO/10,0,900\nGOTO/20,0,900\nFINI\n");
  const Outcome ran = run_batch(
      folder, {"rapids.apt", "--part", "needles/part.stl", "--rapid", "skip", "--assume", "placement", "-o", "out"});
  EXPECT_EQ(ran.exit_status, 0) << ran.out << ran.err;
  EXPECT_NE(ran.out.find("\nrapids: 1 rapid left out as asked\n"), std::string::npos) << ran.out;
  const std::string page = text_of(folder + "/out/index.html");
  EXPECT_NE(page.find("<div class=\"soft\">1 rapid left out</div>"), std::string::npos);
  EXPECT_EQ(text_of(folder + "/out/junit.xml").find("<error"), std::string::npos);
}

TEST(Batch, LooksIntoLinkedFoldersAndOverlooksNoDeadLink) {
  const std::string folder = samples_with_list({"needles"});
  const Outcome ran = run_script(
      folder,
      "mkdir ops far; cp needles/needles.apt ops/a.apt; cp needles/needles.apt far/b.apt\n"
      "ln -s ../far ops/far; ln -s . ops/back; ln -s gone.apt ops/c.apt\n"
      "$GOUGECHECK batch ops --part needles/part.stl --tools needles/tools.json -o out --no-reports -q; echo status $?");
  EXPECT_NE(ran.out.find("status 3\n"), std::string::npos) << ran.out << ran.err;
  std::set<std::string> names;
  const Json summary = summary_of(folder + "/out");
  for (const Json& job : summary.at("jobs")) names.insert(job.at("job").get<std::string>());
  EXPECT_EQ(names, (std::set<std::string>{"a", "b", "c"})) << "the file of c is missing, and that is said\n"
                                                           << ran.out << ran.err;
}

TEST(Batch, NamesBesideAJobWithGougesThatItsStockIsMisplaced) {
  const std::string folder = samples_with_list({"pocket"});
  write_text(folder + "/stock.json",
             R"({"jobs": [{"path": "pocket/pocket.apt", "part": "pocket/part.stl", "tools": "pocket/tools.json",
                           "stock": "pocket/clamp.stl"}]})");
  const Outcome ran = run_batch(folder, {"stock.json", "-o", "out"});
  EXPECT_NE(ran.out.find("1 job: 1 gouges"), std::string::npos) << ran.out << ran.err;
  EXPECT_NE(ran.out.find("\npocket: "), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("[stock-misplaced]"), std::string::npos) << ran.out;
}

}  // namespace
}  // namespace gouge::testing_samples::batch_test
