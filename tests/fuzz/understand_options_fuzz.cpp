#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

#include "cli/options/job_options.h"
#include "tests/fuzz/require.h"

// The values of the options of a job, one a line: refused with a message that names the option, or understood as
// lengths that are finite and not negative and a placement that is a rotation and a shift.

namespace gouge {
namespace {

using fuzz::require;

JobArguments arguments_of(const std::string& text) {
  JobArguments a;
  std::istringstream lines(text);
  const std::array<std::string*, 12> fields = {
      &a.tolerance,       &a.stock_to_leave, &a.clearance,      &a.near_miss, &a.resolution, &a.place,
      &a.reading.dialect, &a.reading.units,  &a.reading.cutcom, &a.rapid,     &a.progress,   &a.report_folder};
  std::string line;
  for (std::string* field : fields)
    if (std::getline(lines, line) && !line.empty()) *field = line;
  while (std::getline(lines, line)) a.tool_names.push_back(line);
  a.is_quiet = text.size() % 3 == 0;
  a.is_verbose = text.size() % 5 == 0;
  return a;
}

void understand_text(const std::string& text) {
  const Result<JobOptions> options = understand(arguments_of(text));
  require(options.has_value() || (options.error().code == "usage" && !options.error().message.empty()));
  if (!options) return;
  const CheckOptions& check = options->check;
  for (const double length : {check.tolerance_mm, check.stock_to_leave_mm, check.near_miss_mm, check.resolution_mm,
                              check.shank_clearance_mm, check.holder_clearance_mm})
    require(std::isfinite(length) && length >= 0);
  require(check.resolution_mm > 0);
  const Eigen::Matrix3d& rotation = options->place.rotation;
  require(options->place.shift.allFinite() && rotation.allFinite());
  require((rotation * rotation.transpose()).isIdentity(1e-9) && rotation.determinant() > 0);
}

}  // namespace
}  // namespace gouge

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  gouge::understand_text(std::string(reinterpret_cast<const char*>(data), size));
  return 0;
}
