#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>

#include "tests/faults/campaign.h"
#include "tests/faults/trial.h"
#include "tests/samples/batch_folder.h"
#include "tests/samples/program.h"
#include "tests/samples/sample_folder.h"
#include "tests/support/scatter.h"

// A batch that is ended by signals at random instants, or by a disk that is full, again and again, and resumed until it
// is whole, leaves what an undisturbed one leaves: no job lost, none twice, the same bytes. GOUGE_KILLS states how many
// signals, GOUGE_RANK_KILLS how many ranks, GOUGE_FULL_DISKS how many disks, GOUGE_SEED which.

namespace gouge::testing_faults::batch_kills_test {
namespace {

namespace fs = std::filesystem;

// The first has ten chunks of moves.
const std::vector<std::string> kSamples = {"freeform",  "needles",  "between_rib",
                                           "thin_post", "sunk_jaw", "between_swing"};
constexpr int kSignals[] = {SIGKILL, SIGTERM, SIGKILL, SIGINT};

std::size_t hidden_files(const std::string& folder) {
  std::size_t count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    count += entry.path().filename().string().starts_with(".gougecheck") ? 1U : 0U;
  return count;
}

TEST(BatchKills, AreResumedToWhatAnUndisturbedBatchLeaves) {
  const std::string folder = testing_samples::fresh_folder();
  ASSERT_EQ(testing_samples::run_make_samples(folder).exit_status, 0);
  testing_samples::write_job_list(folder, kSamples);
  const std::vector<std::string> undisturbed = {"batch", "jobs.json", "-o", "whole", "-q"};
  const Ending whole = run_program(folder, undisturbed, {});
  ASSERT_EQ(whole.exit_status, 1) << whole.err;
  const auto expected = testing_samples::batch_files(folder + "/whole");

  test::Scatter random(static_cast<std::uint64_t>(number_asked("GOUGE_SEED", 17)));
  const long kills = number_asked("GOUGE_KILLS", 6);
  long killed = 0, batches = 0;
  for (long i = 0; i < kills; ++i) {
    Misfortune misfortune;
    misfortune.signal = kSignals[i % 4];
    misfortune.after_s = whole.seconds * random.in(0, 0.7);
    const std::vector<std::string> jobs = {"batch",   "jobs.json",
                                           "-o",      "killed",
                                           "-q",      "--resume",
                                           "--jobs",  std::to_string(1 + i % 3),
                                           "--chunk", i % 2 == 0 ? "65536" : "1"};
    const Ending ending = run_program(folder, jobs, misfortune);
    const bool is_killed = ending.signal == misfortune.signal;
    ASSERT_TRUE(is_killed || ending.exit_status == 1) << ending.exit_status << " " << ending.err;
    killed += is_killed ? 1 : 0;
    // Some go on being killed where they were resumed.
    if (is_killed && random.in(0, 1) < 0.5) continue;
    const Ending resumed = run_program(folder, jobs, {});
    ASSERT_EQ(resumed.exit_status, 1) << "signal " << resumed.signal << " after " << resumed.seconds
                                      << " s: " << resumed.err;
    ASSERT_EQ(testing_samples::difference(expected, testing_samples::batch_files(folder + "/killed")), "")
        << "kill " << i << ", signal " << misfortune.signal << " after " << misfortune.after_s << " s";
    EXPECT_EQ(hidden_files(folder + "/killed"), 0U);
    ++batches;
    fs::remove_all(folder + "/killed");
  }
  std::printf("batch: %ld of %ld ended by a signal, %ld batches resumed to their end\n", killed, kills, batches);
  EXPECT_TRUE(kills < 3 || killed > 0);
}

TEST(BatchKills, SayHowToGoOnUnlessTheyAreQuiet) {
  const std::string folder = testing_samples::fresh_folder();
  ASSERT_EQ(testing_samples::run_make_samples(folder).exit_status, 0);
  testing_samples::write_job_list(folder, kSamples);
  const double seconds = run_program(folder, {"batch", "jobs.json", "-o", "whole", "-q"}, {}).seconds;
  const std::string said = "--resume goes on from there [batch-interrupted]\n";
  long killed = 0, advised = 0;
  for (const double share : {0.2, 0.35, 0.5, 0.65}) {
    for (const char* const output : {"-q", "-v"}) {
      Misfortune misfortune;
      misfortune.signal = SIGINT;
      misfortune.after_s = seconds * share;
      const Ending ending = run_program(folder, {"batch", "jobs.json", "-o", "killed", "--fresh", output}, misfortune);
      const bool is_advised = ending.err.ends_with(said);
      if (ending.signal == SIGINT) ++killed;
      if (is_advised) ++advised;
      EXPECT_TRUE(!is_advised || (ending.signal == SIGINT && output[1] == 'v')) << ending.err;
      fs::remove_all(folder + "/killed");
    }
  }
  EXPECT_GT(killed, 0);
  EXPECT_GT(advised, 0);
}

#ifdef GOUGE_MPI
constexpr bool kHasMpi = true;
#else
constexpr bool kHasMpi = false;
#endif

const std::string kMpirun = "OMPI_MCA_plm_rsh_agent= mpirun --oversubscribe --allow-run-as-root -n ";

// One of two to four ranks is killed, any of them, the first too; Open MPI then ends the others.
TEST(BatchKills, OfARankAreResumedWithAnyNumberOfRanks) {
  if (!kHasMpi) GTEST_SKIP() << "built without MPI (Debian: libopenmpi-dev, openmpi-bin)";
  const std::string folder = testing_samples::fresh_folder();
  ASSERT_EQ(testing_samples::run_make_samples(folder).exit_status, 0);
  testing_samples::write_job_list(folder, kSamples);
  ASSERT_EQ(run_program(folder, {"batch", "jobs.json", "-o", "whole", "-q"}, {}).exit_status, 1);
  const auto expected = testing_samples::batch_files(folder + "/whole");
  const std::string batch = " $GOUGECHECK batch jobs.json -o killed -q --resume --threads 1 --chunk 1";
  const Ending usual = [&] {
    Ending ending;
    const auto begin = std::chrono::steady_clock::now();
    ending.exit_status = testing_samples::run_script(folder, kMpirun + "2" + batch).exit_status;
    ending.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    fs::remove_all(folder + "/killed");
    return ending;
  }();
  ASSERT_EQ(usual.exit_status, 1);

  test::Scatter random(static_cast<std::uint64_t>(number_asked("GOUGE_SEED", 17)));
  const long kills = number_asked("GOUGE_RANK_KILLS", 2);
  long killed = 0, batches = 0;
  for (long i = 0; i < kills; ++i) {
    const std::string ranks = std::to_string(2 + i % 3), rank = std::to_string(1 + i % (2 + i % 3));
    const std::string wait = std::to_string(usual.seconds * random.in(0.1, 0.9));
    const testing_samples::Outcome ran =
        testing_samples::run_script(folder, kMpirun + ranks + batch + " & all=$!\nsleep " + wait +
                                                "\nkill -9 $(pgrep -P $all -f 'batch jobs.json' | sed -n " + rank +
                                                "p) && echo killed\nwait $all; echo $?");
    killed += ran.out.find("killed") != std::string::npos ? 1 : 0;
    if (random.in(0, 1) < 0.3) continue;
    const testing_samples::Outcome resumed =
        testing_samples::run_script(folder, kMpirun + std::to_string(1 + i % 4) + batch);
    ASSERT_EQ(resumed.exit_status, 1) << resumed.out << resumed.err;
    ASSERT_EQ(testing_samples::difference(expected, testing_samples::batch_files(folder + "/killed")), "")
        << "kill " << i << " of " << ranks << " after " << wait << " s";
    EXPECT_EQ(hidden_files(folder + "/killed"), 0U);
    ++batches;
    fs::remove_all(folder + "/killed");
  }
  std::printf("ranks: %ld of %ld killed, %ld batches resumed to their end\n", killed, kills, batches);
}

// A small disk of its own, which is full at some instant: in a result, a report, a chunk of moves, the summary. Then
// there is room again.
TEST(BatchKills, ByAFullDiskAreResumedOnceThereIsRoom) {
  const std::string folder = testing_samples::fresh_folder();
  const std::string apart = ::geteuid() == 0 ? "unshare -m" : "unshare -rm";
  if (testing_samples::run_script(folder, apart + " mount -t tmpfs tmpfs /mnt").exit_status != 0)
    GTEST_SKIP() << "no file system may be mounted here";
  ASSERT_EQ(testing_samples::run_make_samples(folder).exit_status, 0);
  testing_samples::write_job_list(folder, kSamples);
  ASSERT_EQ(run_program(folder, {"batch", "jobs.json", "-o", "whole", "-q"}, {}).exit_status, 1);
  const auto expected = testing_samples::batch_files(folder + "/whole");
  std::uintmax_t bytes = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder + "/whole"))
    bytes += entry.is_regular_file() ? entry.file_size() : 0;

  test::Scatter random(static_cast<std::uint64_t>(number_asked("GOUGE_SEED", 17)));
  const long disks = number_asked("GOUGE_FULL_DISKS", 3);
  long full = 0;
  for (long i = 0; i < disks; ++i) {
    const double part = random.in(0, 1.1);
    const std::string size = std::to_string(4096 + static_cast<std::uintmax_t>(part * static_cast<double>(bytes)));
    const std::string ranks = kHasMpi && i % 3 == 2 ? kMpirun + "2" : "";
    const std::string batch =
        ranks + " $GOUGECHECK batch jobs.json -o disk/out -q --resume --chunk 1 --jobs " + std::to_string(1 + i % 2);
    testing_samples::write_text(folder + "/script", "mount -t tmpfs -o size=" + size + " tmpfs disk\n" + batch +
                                                        "; echo full $?\nmount -o remount,size=1g disk\n" + batch +
                                                        "; echo resumed $?\ncp -r disk/out refilled\n");
    const testing_samples::Outcome ran =
        testing_samples::run_script(folder, "mkdir -p disk; export GOUGECHECK; " + apart + " sh ./script");
    full += ran.out.find("full 5\n") != std::string::npos ? 1 : 0;
    EXPECT_TRUE(ran.out.find("full 5\n") != std::string::npos || ran.out.find("full 1\n") != std::string::npos)
        << ran.out << ran.err;
    EXPECT_NE(ran.out.find("resumed 1\n"), std::string::npos) << size << " bytes: " << ran.out << ran.err;
    ASSERT_EQ(testing_samples::difference(expected, testing_samples::batch_files(folder + "/refilled")), "")
        << "disk " << i << " of " << size << " bytes: " << ran.out << ran.err;
    EXPECT_EQ(hidden_files(folder + "/refilled"), 0U);
    fs::remove_all(folder + "/refilled");
  }
  std::printf("disks: %ld of %ld were full, all batches resumed to their end\n", full, disks);
}

}  // namespace
}  // namespace gouge::testing_faults::batch_kills_test
