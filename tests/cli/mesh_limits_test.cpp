#include "cli/options/mesh_limits.h"

#include <gtest/gtest.h>

namespace gouge::mesh_limits_test {
namespace {

Result<std::vector<MeshLimit>> limits_of(const std::string& typed, Against against = Against::fixture) {
  std::vector<std::string> files;
  LimitTexts texts;
  split_limits({"plain.stl", typed}, files, texts);
  return understand_limits("--fixture", against, files, texts, 0.01);
}

TEST(MeshLimits, StandBehindTheNameOfTheFile) {
  std::vector<std::string> files;
  LimitTexts texts;
  split_limits({"a,b.stl", "vise.stl,clearance=1,tolerance=0.5mm"}, files, texts);
  EXPECT_EQ(files, (std::vector<std::string>{"a,b.stl", "vise.stl"}));
  EXPECT_EQ(texts, (LimitTexts{{"vise.stl", "clearance=1,tolerance=0.5mm"}}));
}

TEST(MeshLimits, MayHaveAUnit) {
  const auto limits = limits_of("vise.stl,tolerance=0.005,clearance=0.1in");
  ASSERT_TRUE(limits);
  ASSERT_EQ(limits->size(), 1U);
  EXPECT_EQ(limits->front().mesh, 1U);
  EXPECT_DOUBLE_EQ(limits->front().clearance_mm, 2.54);
  EXPECT_DOUBLE_EQ(limits->front().tolerance_mm, 0.005);
}

TEST(MeshLimits, WithoutAToleranceAllowNoDepth) {
  const auto limits = limits_of("vise.stl,clearance=1");
  ASSERT_TRUE(limits);
  EXPECT_DOUBLE_EQ(limits->front().tolerance_mm, 0);
}

class WrongLimits : public testing::TestWithParam<const char*> {};

TEST_P(WrongLimits, AreRefusedWithWhatWasTyped) {
  const auto limits = limits_of(GetParam());
  ASSERT_FALSE(limits);
  EXPECT_NE(limits.error().message.find(GetParam()), std::string::npos) << limits.error().message;
}

INSTANTIATE_TEST_SUITE_P(Typed, WrongLimits,
                         testing::Values("v.stl,clearance=", "v.stl,clearance=-1", "v.stl,clearance=1,clearance=1",
                                         "v.stl,clearance=1,colour=red", "v.stl,clearance=1e9", "v.stl,tolerance=0.02",
                                         "v.stl,clearence=1"));

TEST(MeshLimits, OfAFileThatIsGivenTwiceAreRefused) {
  std::vector<std::string> files;
  LimitTexts texts;
  split_limits({"v.stl,clearance=1", "v.stl,clearance=2"}, files, texts);
  EXPECT_FALSE(understand_limits("--fixture", Against::fixture, files, texts, 0.01));
}

TEST(MeshLimits, GiveAPartNoClearance) {
  EXPECT_FALSE(limits_of("part.stl,clearance=1", Against::part));
  EXPECT_TRUE(limits_of("part.stl,tolerance=0.001", Against::part));
}

}  // namespace
}  // namespace gouge::mesh_limits_test
