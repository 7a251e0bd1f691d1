#include "cli/terminal/progress.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <sstream>
#include <thread>

namespace gouge::progress_test {
namespace {

void wait_ms(int duration) { std::this_thread::sleep_for(std::chrono::milliseconds(duration)); }

TEST(Progress, ShowsThatWorkGoesOnThatCountsNothing) {
  std::ostringstream err;
  Progress progress(err, ProgressMode::always);
  for (int tries = 0; tries < 60 && err.str().empty(); ++tries) {
    progress.begin("reading part.stl");
    wait_ms(600 + 100 * tries);
    progress.end();
  }
  EXPECT_EQ(err.str().substr(0, 20), "\rreading part.stl: 1") << err.str();
  EXPECT_EQ(err.str().substr(err.str().size() - 4), "\r\x1b[K") << "the line is wiped";
}

TEST(Progress, SaysHowMuchIsDoneAndAboutHowLongTheRestTakes) {
  std::ostringstream err;
  Progress progress(err, ProgressMode::always);
  const ProgressCall call = progress.call();
  call("checking moves", 0, 1000);
  wait_ms(1300);
  call("checking moves", 500, 1000);
  wait_ms(300);
  progress.end();
  EXPECT_NE(err.str().find("\rchecking moves: 0 of 1000 (0 %)\x1b[K"), std::string::npos) << err.str();
  EXPECT_NE(err.str().find("\rchecking moves: 500 of 1000 (50 %), about "), std::string::npos) << err.str();
}

TEST(Progress, WhatWentBeforeTheCountingIsNotCountedIn) {
  std::ostringstream err;
  Progress progress(err, ProgressMode::always);
  progress.begin("reading part.stl");
  wait_ms(3000);
  const auto counting = std::chrono::steady_clock::now();
  progress.show("reading part.stl", 0, 1000);
  wait_ms(1300);
  progress.show("reading part.stl", 500, 1000);
  wait_ms(300);
  progress.show("reading part.stl", 500, 1000);  // drawn now, if the first was not
  const double counted_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - counting).count();
  progress.end();
  const std::size_t at = err.str().find("500 of 1000 (50 %), about ");
  ASSERT_NE(at, std::string::npos) << err.str();
  // Half is done: the rest takes no longer than the counting did, however busy the machine is.
  const double left_s = std::stod(err.str().substr(at + 26));
  EXPECT_GE(left_s, 1);
  EXPECT_LE(left_s, std::ceil(counted_s)) << err.str();
}

TEST(Progress, EachStageCountsItsOwnTime) {
  std::ostringstream err;
  Progress progress(err, ProgressMode::always);
  const ProgressCall call = progress.call();
  call("checking moves", 1, 2);
  wait_ms(1300);
  call("measuring overcuts", 1, 2);
  progress.end();
  EXPECT_EQ(err.str().find("measuring"), std::string::npos) << "it has only begun: " << err.str();
}

TEST(Progress, IsSilentWhereItIsOff) {
  std::ostringstream err;
  Progress progress(err, ProgressMode::never);
  EXPECT_FALSE(progress.call());
  progress.begin("reading part.stl");
  progress.show("checking moves", 1, 2);
  progress.end();
  EXPECT_EQ(err.str(), "");
}

TEST(Progress, FileNamesCannotForgeALine) {
  std::ostringstream err;
  Progress progress(err, ProgressMode::always);
  progress.begin("reading \x1b[2Jpart\n.stl");
  wait_ms(900);
  progress.end();
  EXPECT_EQ(err.str().find("\x1b[2J"), std::string::npos);
  EXPECT_EQ(err.str().find('\n'), std::string::npos);
}

TEST(DurationText, IsShort) {
  EXPECT_EQ(duration_text(0.2), "1 s");
  EXPECT_EQ(duration_text(89.5), "90 s");
  EXPECT_EQ(duration_text(150), "3 min");
  EXPECT_EQ(duration_text(9000), "2.5 h");
}

}  // namespace
}  // namespace gouge::progress_test
