#pragma once

#include <string>
#include <vector>

// Runs the real program and reports what a user sees.

namespace gouge::testing_samples {

struct Outcome {
  int exit_status = -1;  ///< -1: it did not end by itself
  std::string out, err;
};

/// Runs gougecheck with these arguments in `folder`, with nothing on standard input.
[[nodiscard]] Outcome run_gougecheck(const std::string& folder, const std::vector<std::string>& arguments);

/// Runs `script` with /bin/sh in `folder`; $GOUGECHECK is the program.
[[nodiscard]] Outcome run_script(const std::string& folder, const std::string& script);

/// Runs make_samples into `folder`.
[[nodiscard]] Outcome run_make_samples(const std::string& folder);

[[nodiscard]] std::string text_of(const std::string& path);
void write_text(const std::string& path, const std::string& text);

}  // namespace gouge::testing_samples
