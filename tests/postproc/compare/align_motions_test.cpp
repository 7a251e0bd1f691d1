#include "postproc/compare/match_findings.h"

#include <gtest/gtest.h>

#include "lib/path/toolpath.h"

namespace gouge::align_motions_test {
namespace {

/// Views of the letters, which must outlive them.
std::vector<std::string_view> motions(const std::string& letters) {
  std::vector<std::string_view> all;
  for (std::size_t k = 0; k < letters.size(); ++k) all.push_back(std::string_view(letters).substr(k, 1));
  return all;
}

/// For each letter of `before` its place in `after`, '-' where it has none.
std::string aligned(const std::string& before, const std::string& after) {
  const MotionAlignment made = align_motions(motions(before), motions(after));
  std::string text;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const std::size_t j = made.before_to_after[i];
    text += j == kNone ? '-' : static_cast<char>('0' + j);
    EXPECT_TRUE(j == kNone || made.after_to_before[j] == i);
  }
  return text;
}

TEST(AlignMotions, WhatIsEqualIsItself) {
  EXPECT_EQ(aligned("abcd", "abcd"), "0123");
  EXPECT_EQ(aligned("", "abc"), "");
  EXPECT_EQ(aligned("abc", ""), "---");
}

TEST(AlignMotions, InsertedAndMissingMotionsShiftTheOthers) {
  EXPECT_EQ(aligned("abcd", "xyabcd"), "2345");
  EXPECT_EQ(aligned("abcd", "ad"), "0--1");
  EXPECT_EQ(aligned("abcd", "abxd"), "01-3");
}

TEST(AlignMotions, OrderIsKeptWhereMotionsAreSwapped) {
  const std::string swapped = aligned("abcde", "deabc");
  EXPECT_TRUE(swapped == "234--" || swapped == "---01") << swapped;
}

TEST(AlignMotions, RepeatedMotionsAreTakenBesideThoseThatAreThereOnce) {
  EXPECT_EQ(aligned("rrarrb", "rrarrb"), "012345");
  EXPECT_EQ(aligned("rarb", "rxrarb"), "0345");
  EXPECT_EQ(aligned("xrray", "urrav"), "-123-");
  EXPECT_EQ(aligned("rr", "rr"), "01");
  EXPECT_EQ(aligned("xrry", "urrv"), "----") << "no motion is there once: nothing says which is which";
}

}  // namespace
}  // namespace gouge::align_motions_test
