#pragma once

#include <iosfwd>

#include "cli/job_options.h"

namespace gouge {

struct CorrectArguments {
  JobArguments job;
  std::string output;
  std::string strategy = "weighted";
  std::string max_shift = "20";
  std::string max_side_shift;  ///< empty: by the depth
  std::string rapid_clearance = "1";
  std::string max_rotary_speed;  ///< empty: no limit
};

void add_correct_options(CLI::App& command, CorrectArguments& arguments);

/// `gougecheck correct`. Returns the exit status.
[[nodiscard]] int run_correct(const CorrectArguments& arguments, std::ostream& out, std::ostream& err);

}  // namespace gouge
