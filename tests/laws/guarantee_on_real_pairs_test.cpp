// The guarantee on real toolpaths and the parts they were made for, where these are at hand.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/laws/guarantee.h"
#include "tests/support/source_folder.h"

namespace gouge::guarantee_on_real_pairs_test {
namespace {

struct Pair {
  const char* name;
  const char* toolpath;
  const char* part;
};

void PrintTo(const Pair& p, std::ostream* out) { *out << p.name; }

const Pair kPairs[] = {{"five_axis_part", "five_axis_part/subset_autodesk_iso4343.apt", "five_axis_part_inch.stl"},
                       {"Teste_Metrologia", "solidworks_cam/Teste-Metrologia.apt", "Teste-Metrologia.STL"},
                       {"Sacrifice_Board", "solidworks_cam/Sacrifice-Board.apt", "Sacrifice-Board.STL"},
                       {"SupPetriLED", "solidworks_cam/SupPetriLED.apt", "SupPetriLED.STL"},
                       {"basemach", "solidworks_cam/basemach.apt", "basemach.STL"},
                       {"Paralelipipedo2", "solidworks_cam/Paralelipipedo2.apt", "Paralelipipedo2.STL"}};

class GuaranteeOnRealPairs : public ::testing::TestWithParam<Pair> {};

INSTANTIATE_TEST_SUITE_P(All, GuaranteeOnRealPairs, ::testing::ValuesIn(kPairs),
                         [](const auto& test) { return std::string(test.param.name); });

TEST_P(GuaranteeOnRealPairs, EveryWitnessRealisesItsDepthAndNothingIsDeeperThanReported) {
  const std::filesystem::path data = std::filesystem::path(source_folder()) / "../shared/data";
  JobArguments arguments;
  arguments.path = (data / "toolpaths" / GetParam().toolpath).string();
  arguments.parts = {(data / "parts/matched" / GetParam().part).string()};
  if (!std::filesystem::exists(arguments.path) || !std::filesystem::exists(arguments.parts[0])) {
    GTEST_SKIP() << "the shared data is not here";
  }
  const Job job = guarantee::load(arguments);
  ASSERT_GT(job.toolpath.moves.size(), 10U);
  const CheckResult result = guarantee::check_job(job);
  EXPECT_GT(result.counts.clean + result.counts.gouge, 10U);
  EXPECT_EQ(result.counts.not_certified, 0U);
  guarantee::expect_witnesses(job, result);
  guarantee::expect_nothing_deeper(job, result);
}

}  // namespace
}  // namespace gouge::guarantee_on_real_pairs_test
