#pragma once

#include <string>
#include <vector>

#include "cli/options/job_options.h"
#include "lib/correct/correct_path.h"
#include "postproc/report/report_model.h"

namespace gouge {

/// The options of `correct`, as typed.
struct CorrectArguments {
  JobArguments job;
  std::string output;
  std::string output_name;              ///< as reports call it; empty: as it was typed
  std::vector<std::string> strategies;  ///< "tilt", or "holder=tilt" for one body
  std::string max_shift = "20";
  std::string max_side_shift;  ///< empty: by the depth
  std::string rapid_clearance = "1";
  std::string max_tilt = "30", tilt = "both", axis_cone, max_turn, max_turn_step, blend = "10";
  std::string max_stock = "0.01";  ///< above the tolerance
  bool may_add_axes = false;
  std::string max_rotary_speed;  ///< empty: no limit

  [[nodiscard]] const std::string& reported_output() const { return output_name.empty() ? output : output_name; }
};

/// Returns the rows that `correct` has beside job_options().
[[nodiscard]] const OptionRows<CorrectArguments>& correct_options();

void add_correct_options(CLI::App& command, CorrectArguments& arguments);

/// Errors (code usage): names the option, the typed text and the expected one.
[[nodiscard]] Result<CorrectOptions> understand_correction(const CorrectArguments& arguments);

/// Returns the strategies as a report names them: "auto", "axis", "cutter=axis, holder=tilt".
[[nodiscard]] std::string strategies_text(const CorrectArguments& arguments);

}  // namespace gouge
