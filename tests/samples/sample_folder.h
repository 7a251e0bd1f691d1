#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace gouge::testing_samples {

/// The samples as the tests know them; a test compares the list with what make_samples writes.
[[nodiscard]] const std::vector<std::string>& sample_names();

/// An empty folder named after the running test.
[[nodiscard]] std::string fresh_folder();

/// A generated sample in a fresh folder.
struct SampleFolder {
  std::string path;
  nlohmann::json expected;

  [[nodiscard]] std::string toolpath() const { return expected.at("toolpath"); }
  /// `command` PATH --tools ... --part ... --fixture ... --head ..., then `more`.
  [[nodiscard]] std::vector<std::string> arguments(const std::string& command, const std::string& toolpath,
                                                   const std::vector<std::string>& more = {}) const;
};

/// Generates all samples into a fresh folder and opens one of them. Fails the test when it cannot.
[[nodiscard]] SampleFolder open_sample(const std::string& name);

}  // namespace gouge::testing_samples
