#pragma once

#include <deque>
#include <optional>

#include "cli/job/job.h"
#include "lib/certify/settle_stock.h"

namespace gouge {

/// The programs of --before with the tools to which they refer.
struct EarlierPrograms {
  std::deque<ToolVariants> tools;
  std::deque<EarlierProgram> programs;  ///< in the order of time
};

/// Reads the programs of --before and moves them into the coordinates of the job's path. They follow its law of motion.
/// Adds their files, notes and assumptions to the job. Requires: find_wrong_stock finds nothing.
/// Nothing: `errors` has those of the files; no-tool, no tool of a program is defined; before-place, the law of the motion
/// depends on the machine, so that the program cannot be moved.
[[nodiscard]] std::optional<EarlierPrograms> read_earlier_programs(const JobArguments& arguments, Job& job,
                                                                   Progress& progress, Diagnostics& errors);

}  // namespace gouge
