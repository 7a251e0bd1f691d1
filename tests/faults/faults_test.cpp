#include <gtest/gtest.h>

#include "tests/faults/campaign.h"

// check, correct and report while the n-th call of a kind fails, for some n; for GOUGE_FAULTS of them, evenly spread,
// or all. Whatever fails: no crash, no half file, nothing left behind, and the undisturbed result or status 5 with a
// message.

namespace gouge::testing_faults::faults_test {
namespace {

struct Fault {
  const char* kind;
  const char* what;
  bool is_lasting = false;
  bool is_harmless = false;  ///< the result must be the undisturbed one
  bool may_refuse_input = false;
  bool may_leave_hidden = false;
};

class Faults : public testing::TestWithParam<const char*> {
 protected:
  void try_fault(const FaultJob& job, const Fault& fault) {
    const std::string what =
        job.name + " " + fault.kind + " " + fault.what + (fault.is_lasting ? " and all after" : "");
    const auto calls = job.calls.find(fault.kind);
    ASSERT_NE(calls, job.calls.end()) << what;
    Tally tally(what);
    const long few = job.name == "report" ? 1 : 3;  // drawing takes a second
    long trial = 0;
    for (const long n : spread(calls->second, number_asked("GOUGE_FAULTS", few))) {
      const bool has_older = ++trial % 2 == 0;
      job.prepare(has_older);
      const std::string kind(fault.kind);
      const bool is_early = kind.starts_with("early ");
      const std::string text = (is_early ? kind.substr(6) : kind) + ":" + std::to_string(n) +
                               (fault.is_lasting ? "+" : "") + ":" + fault.what;
      Misfortune misfortune;
      misfortune.fault = text;
      misfortune.is_early = is_early;
      const Ending ending = run_program(job.folder, job.arguments, misfortune);
      std::vector<std::string> wrong = wrong_ending(job, ending, fault.may_refuse_input);
      if (fault.is_harmless && ending.exit_status != job.ending.exit_status)
        wrong.push_back("a harmless fault, but exit status " + std::to_string(ending.exit_status) + ": " + ending.err);
      for (std::string& line : wrong_files(job, has_older, fault.may_leave_hidden)) wrong.push_back(std::move(line));
      tally.add(job, ending, text + (has_older ? " over older outputs" : ""), wrong);
    }
  }
};

TEST_P(Faults, NoFailingCallMakesAHalfFileOrAWrongVerdict) {
  const FaultJob job = make_job(GetParam());
  constexpr bool kInput = true;
  for (const Fault& fault : {Fault{"memory", "ENOMEM"},
                             {"memory", "ENOMEM", true},
                             {"early memory", "ENOMEM", true},
                             {"map", "ENOMEM"},
                             {"thread", "EAGAIN", true},
                             {"open", "EMFILE", false, false, kInput},
                             {"open", "EACCES", true, false, kInput},
                             {"read", "EIO", false, false, kInput},
                             {"read", "EINTR", false, true},
                             {"read", "short", true, true},
                             {"write", "ENOSPC"},
                             {"write", "EIO", true},
                             {"write", "EINTR", false, true},
                             {"write", "short", false, true},
                             {"sync", "EIO"},
                             {"place", "EIO"},
                             {"place", "ENOSPC", true},
                             {"remove", "EIO", true, false, false, true},
                             {"close", "EIO"}})
    try_fault(job, fault);
}

INSTANTIATE_TEST_SUITE_P(Commands, Faults, testing::Values("check", "correct", "report"),
                         [](const auto& command) { return std::string(command.param); });

}  // namespace
}  // namespace gouge::testing_faults::faults_test
