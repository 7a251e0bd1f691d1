#include "tests/faults/campaign.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace gouge::testing_faults {

std::vector<long> spread(long count, long most) {
  std::vector<long> numbers;
  const long trials = std::min(count, most);
  for (long i = 0; i < trials; ++i) numbers.push_back(1 + (2 * i + 1) * count / (2 * trials));
  return numbers;
}

long number_asked(const char* name, long usual) {
  const char* text = std::getenv(name);
  return text == nullptr ? usual : std::atol(text);
}

Tally::~Tally() {
  std::printf("%-34s %6ld trials: %6ld undisturbed results, %6ld refused, %6ld killed, %ld wrong\n", what_.c_str(),
              trials_, right_, refused_, killed_, wrong_);
  std::fflush(stdout);
}

void Tally::add(const FaultJob& job, const Ending& ending, const std::string& trial,
                const std::vector<std::string>& wrong) {
  constexpr long kMaxReported = 5;
  ++trials_;
  if (ending.signal != 0)
    ++killed_;
  else
    ++(ending.exit_status == job.ending.exit_status ? right_ : refused_);
  if (wrong.empty()) return;
  if (++wrong_ > kMaxReported) return;
  std::string text;
  for (const std::string& line : wrong) text += "\n  " + line;
  ADD_FAILURE() << what_ << ", " << trial << ":" << text;
}

}  // namespace gouge::testing_faults
