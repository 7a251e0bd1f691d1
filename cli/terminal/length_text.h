#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/values/parse_lengths.h"
#include "lib/base/result.h"
#include "lib/check/check_options.h"
#include "lib/geom/pose.h"

// Values of command-line options. Lengths are millimetres unless they have a unit: 0.5, 0.5mm, 0.02in, 0.02inch.

namespace gouge {

/// Returns the words of --stl-units: the units that an STL file may have.
[[nodiscard]] std::vector<std::string> unit_words();

/// The minimum of a length. Above the finest resolution, double precision can certify it.
enum class Minimum { zero, above_zero, finest_resolution };

/// Returns the length typed for `option`. An error (code usage) names the option, the typed text and the expected one.
[[nodiscard]] Result<double> understand_length(const std::string& option, const std::string& typed, Minimum least);

/// Parses the text typed for `option` with parse_length_range; no end of the interval may be below 0. An error (code
/// usage) names the option, the typed text and the expected one.
[[nodiscard]] Result<LengthRange> understand_length_range(const std::string& option, const std::string& typed);

/// Parses the text typed for `option` with parse_place. An error (code usage) names the option, the typed text and the
/// expected one.
[[nodiscard]] Result<RigidTransform> understand_place(const std::string& option, const std::string& typed);

/// Returns the error "OPTION 'TYPED': expected EXPECTED", code usage.
[[nodiscard]] Diagnostic usage_error(const std::string& option, const std::string& typed, const std::string& expected);

/// Reads "shank=0.5,holder=1" into the options. Returns the error, or nothing.
[[nodiscard]] std::optional<std::string> parse_clearance(const std::string& text, CheckOptions& options);

}  // namespace gouge
