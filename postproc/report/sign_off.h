#pragma once

#include <string>

namespace gouge {

struct ReportModel;

/// Fields of the head of a report.
struct SignOff {
  std::string date;               ///< "2026-11-23 14:05 UTC", the one line that differs between runs; may be empty
  std::string command;            ///< the command line that repeats it; may be empty
  std::string project, reviewer;  ///< as given; may be empty
};

/// Returns project, reviewer, date, program and command line, as HTML.
[[nodiscard]] std::string sign_off_facts(const ReportModel& model);

/// Returns lines to sign, as HTML.
[[nodiscard]] std::string sign_off_lines(const ReportModel& model);

}  // namespace gouge
