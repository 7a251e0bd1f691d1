#pragma once

#include <iosfwd>

#include "cli/job.h"

namespace gouge {

/// Prints the findings and writes every file asked for. A file that cannot be written is told on `err`.
/// Returns whether all were written.
[[nodiscard]] bool write_outputs(const JobArguments& arguments, const Job& job, const ReportModel& model,
                                 Progress& progress, std::ostream& out, std::ostream& err);

/// Prints diagnostics, one a line, as compilers do.
void print(std::ostream& err, const Diagnostics& diagnostics);

/// Warnings of the inputs; with -v notes as well, with -q nothing. More than a handful are counted.
void print_notes(std::ostream& err, const Diagnostics& notes, const JobArguments& arguments);

/// Whether "-" was given for one of the outputs, so that standard output belongs to it alone; more than one
/// is an error, returned as its message. `corrected` is where the corrected toolpath goes, or empty.
[[nodiscard]] Result<bool> is_stdout_taken(const JobArguments& arguments, const std::string& corrected);

}  // namespace gouge
