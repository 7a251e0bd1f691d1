#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

// One run of the real program under misfortune, and what it left.

namespace gouge::testing_faults {

/// Bytes by name, below some folder. A folder's name ends with a slash, and it has no bytes.
using Files = std::map<std::string, std::string>;

/// How a run ended and what it printed.
struct Ending {
  int exit_status = -1;  ///< -1: a signal ended it
  int signal = 0;        ///< 0: it ended by itself; SIGALRM: it did not end within ten minutes
  std::string out, err;
  double seconds = 0;
};

/// Fault injected into a run.
struct Misfortune {
  std::string fault;        ///< GOUGE_FAULT for the fault library; empty: none
  bool is_early = false;    ///< count from the loader on, not from main
  std::string counts_file;  ///< where the calls are counted; empty: they are not
  int signal = 0;           ///< sent `after_s` after the start; 0: none
  double after_s = 0;
};

/// Runs gougecheck with `arguments` in `folder`. Standard output and error go to files above it.
[[nodiscard]] Ending run_program(const std::string& folder, const std::vector<std::string>& arguments,
                                 const Misfortune& misfortune);

/// Every file below `folder`, without what may differ between two equal runs (the seconds of JUnit).
[[nodiscard]] Files files_of(const std::string& folder);

/// Removes `folder` and writes it anew.
void put_files(const std::string& folder, const Files& files);

}  // namespace gouge::testing_faults
