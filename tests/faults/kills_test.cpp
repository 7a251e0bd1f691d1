#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <string>

#include "tests/faults/campaign.h"
#include "tests/support/scatter.h"

// check, correct and report, ended by a signal: at random instants (GOUGE_KILLS of them, GOUGE_SEED states which) and at
// calls that change the disk (GOUGE_FAULTS of a kind, or all; GOUGE_FAULT_KINDS of these kinds alone). No file is half;
// what SIGTERM and SIGINT end leaves nothing behind, and what SIGKILL ends the next run completes and tidies up.

namespace gouge::testing_faults::kills_test {
namespace {

struct Signal {
  const char* name;
  int number;
};
constexpr Signal kSignals[] = {{"SIGKILL", SIGKILL}, {"SIGTERM", SIGTERM}, {"SIGINT", SIGINT}};

class Kills : public testing::TestWithParam<const char*> {
 protected:
  void judge(const FaultJob& job, const Signal& signal, const Ending& ending, bool has_older, const std::string& trial,
             Tally& tally) {
    std::vector<std::string> wrong;
    if (ending.signal != signal.number) wrong = wrong_ending(job, ending, false);
    for (std::string& line : wrong_files(job, has_older, signal.number == SIGKILL)) wrong.push_back(std::move(line));
    const Ending again = run_program(job.folder, job.arguments, {});
    for (const std::string& line : wrong_ending(job, again, false)) wrong.push_back("afterwards: " + line);
    tally.add(job, ending, trial + (has_older ? " over older outputs" : ""), wrong);
  }
};

TEST_P(Kills, AtAnyInstantLeaveNoHalfFile) {
  const FaultJob job = make_job(GetParam());
  test::Scatter random(static_cast<std::uint64_t>(number_asked("GOUGE_SEED", 13)));
  const long kills = number_asked("GOUGE_KILLS", job.name == "report" ? 3 : 9);
  Tally tally(job.name + " killed at any instant");
  for (long i = 0; i < kills; ++i) {
    const Signal& signal = kSignals[i % 3];
    const bool has_older = i / 3 % 2 == 1;
    job.prepare(has_older);
    const double after_s = job.ending.seconds * random.in(0, 1);
    Misfortune misfortune;
    misfortune.signal = signal.number;
    misfortune.after_s = after_s;
    const Ending ending = run_program(job.folder, job.arguments, misfortune);
    judge(job, signal, ending, has_older, signal.name + (" after " + std::to_string(after_s) + " s"), tally);
  }
}

TEST_P(Kills, AtAnyCallThatChangesTheDiskLeaveNoHalfFile) {
  const FaultJob job = make_job(GetParam());
  // Drawing takes a second: of reports the suite tries the calls alone that put files in their places.
  const auto usual = [&](const std::string& kind) { return job.name != "report" || kind == "place" ? 1 : 0; };
  const char* const asked = std::getenv("GOUGE_FAULT_KINDS");
  for (const char* kind : {"write", "sync", "place", "remove", "close"}) {
    if (asked != nullptr && std::string(asked).find(kind) == std::string::npos) continue;
    for (const Signal& signal : kSignals) {
      Tally tally(job.name + " " + kind + " " + signal.name);
      for (const bool has_older : {true, false}) {
        const long calls = (has_older ? job.calls_over_older : job.calls).at(kind);
        for (const long n : spread(calls, number_asked("GOUGE_FAULTS", usual(kind)))) {
          job.prepare(has_older);
          Misfortune misfortune;
          misfortune.fault = kind + (":" + std::to_string(n) + ":") + signal.name;
          const Ending ending = run_program(job.folder, job.arguments, misfortune);
          judge(job, signal, ending, has_older, misfortune.fault, tally);
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Commands, Kills, testing::Values("check", "correct", "report"),
                         [](const auto& command) { return std::string(command.param); });

}  // namespace
}  // namespace gouge::testing_faults::kills_test
