#pragma once

#include <string>

namespace gouge {

struct ReportModel;

/// Data for the head of a report.
struct SignOff {
  std::string date;               ///< "2026-11-23 14:05 UTC", the only line that differs between runs; may be empty
  std::string command;            ///< the command line that repeats the run; may be empty
  std::string project, reviewer;  ///< as given; may be empty
};

/// Returns project, reviewer, date, program and command line, as HTML.
[[nodiscard]] std::string sign_off_facts(const ReportModel& model);

/// Returns lines for signatures, as HTML.
[[nodiscard]] std::string sign_off_lines(const ReportModel& model);

}  // namespace gouge
