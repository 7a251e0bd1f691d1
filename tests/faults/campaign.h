#pragma once

#include <string>
#include <vector>

#include "tests/faults/job.h"

namespace gouge::testing_faults {

/// `most` of the numbers 1 to `count`, evenly spread, or all of them.
[[nodiscard]] std::vector<long> spread(long count, long most);

/// The number in the environment variable `name`, or `usual`.
[[nodiscard]] long number_asked(const char* name, long usual);

/// Counts trials of one kind and prints a line about them; the first few that went wrong fail the test.
class Tally {
 public:
  explicit Tally(std::string what) : what_(std::move(what)) {}
  ~Tally();
  Tally(const Tally&) = delete;
  Tally& operator=(const Tally&) = delete;

  void add(const FaultJob& job, const Ending& ending, const std::string& trial, const std::vector<std::string>& wrong);

 private:
  std::string what_;
  long trials_ = 0, right_ = 0, refused_ = 0, killed_ = 0, wrong_ = 0;
};

}  // namespace gouge::testing_faults
