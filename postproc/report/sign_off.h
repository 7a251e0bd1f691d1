#pragma once

#include <string>

namespace gouge {

/// Data for the head of a report.
struct SignOff {
  std::string date;               ///< "2026-11-23 14:05 UTC", the only line that differs between runs; may be empty
  std::string command;            ///< the command line that repeats the run; may be empty
  std::string project, reviewer;  ///< as given; may be empty
  std::string batch_job = {};     ///< name of the job whose report this is; empty: it belongs to no batch

  bool operator==(const SignOff&) const = default;
};

/// Returns project, reviewer, date, program and command line, as HTML.
[[nodiscard]] std::string sign_off_facts(const SignOff& s);

/// Returns links to the page of the batch and to the reports before and after this one, as HTML; empty without a batch.
/// The page of the batch knows the order of the reports, and leads on.
[[nodiscard]] std::string batch_links(const SignOff& s);

/// Returns lines for signatures, as HTML.
[[nodiscard]] std::string sign_off_lines(const SignOff& s);

}  // namespace gouge
