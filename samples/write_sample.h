#pragma once

#include <string>
#include <vector>

#include "lib/base/result.h"
#include "samples/sample.h"

namespace gouge::samples {

/// Returns the expected verdict as JSON text; the format is described in docs/develop/testing.md.
[[nodiscard]] std::string expected_json(const Sample& sample);

/// Writes the sample's files into `folder`/`sample.name`. Errors: those of write_file and make_folder.
[[nodiscard]] Outcome write_sample(const Sample& sample, const std::string& folder);

/// Returns one line for each sample for shell scripts: name, exit status of check, exit status of correct, toolpath,
/// options.
[[nodiscard]] std::string index_text(const std::vector<Sample>& samples);

}  // namespace gouge::samples
