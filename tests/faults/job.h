#pragma once

#include <string>
#include <vector>

#include "tests/faults/trial.h"

namespace gouge::testing_faults {

/// A command over a small sample, and what it does undisturbed.
struct FaultJob {
  std::string name;
  std::string folder;
  std::vector<std::string> arguments;
  Files inputs;
  Files older;                        ///< what stands under the names of the outputs before some of the trials
  Files outputs;                      ///< what it writes
  Ending ending;                      ///< undisturbed
  std::map<std::string, long> calls;  ///< by kind of the fault library; "early" kinds begin with "early "
  std::map<std::string, long> calls_over_older;

  /// Inputs alone, or inputs and older outputs, into the folder.
  void prepare(bool has_older) const;
};

/// "check", "correct" or "report" in a fresh folder below the build folder. Fails the test when it cannot be made.
[[nodiscard]] FaultJob make_job(const std::string& name);

/// Errors in the remains of a trial, one line each; empty when there are none. Every output is absent, as it was
/// before or as undisturbed; nothing else is there but the inputs, unchanged. `may_leave_hidden`: files whose names
/// begin with .gougecheck may be there, as after SIGKILL.
[[nodiscard]] std::vector<std::string> wrong_files(const FaultJob& job, bool has_older, bool may_leave_hidden);

/// The same of how a trial ended that was not killed: by itself, with the status, the text and all files of an
/// undisturbed run, or with status 5 (3 where `may_refuse_input`) and a message.
[[nodiscard]] std::vector<std::string> wrong_ending(const FaultJob& job, const Ending& ending, bool may_refuse_input);

}  // namespace gouge::testing_faults
