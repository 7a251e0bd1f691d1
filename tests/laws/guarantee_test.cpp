// The guarantee on every generated sample.
#include <gtest/gtest.h>

#include <filesystem>

#include "samples/cases.h"
#include "samples/write_sample.h"
#include "tests/laws/guarantee.h"
#include "tests/support/temporary_folder.h"

namespace gouge::guarantee_test {
namespace {

struct SampleCase {
  const char* name;
  samples::Sample (*make)();
};

void PrintTo(const SampleCase& c, std::ostream* out) { *out << c.name; }

const SampleCase kSamples[] = {{"freeform", samples::make_freeform},
                               {"pocket", samples::make_pocket},
                               {"blade", samples::make_blade},
                               {"between_rib", samples::make_between_rib},
                               {"between_swing", samples::make_between_swing},
                               {"pole_crossing", samples::make_pole_crossing},
                               {"rapid_joints", samples::make_rapid_joints},
                               {"rapid_independent", samples::make_rapid_independent},
                               {"axis_limit", samples::make_axis_limit},
                               {"axis_flip", samples::make_axis_flip},
                               {"smoothing_tube", samples::make_smoothing_tube},
                               {"thin_post", samples::make_thin_post},
                               {"buried", samples::make_buried},
                               {"inch", samples::make_inch},
                               {"needles", samples::make_needles},
                               {"big_triangles", samples::make_big_triangles},
                               {"arcs_nx", samples::make_arcs_nx},
                               {"arcs_creo", samples::make_arcs_creo},
                               {"arcs_catia", samples::make_arcs_catia},
                               {"sunk_jaw", samples::make_sunk_jaw},
                               {"rapid_stock", samples::make_rapid_stock},
                               {"holder_stock", samples::make_holder_stock},
                               {"excess_corner", samples::make_excess_corner}};

class GuaranteeOnSamples : public ::testing::TestWithParam<SampleCase> {
 protected:
  void SetUp() override {
    const samples::Sample sample = GetParam().make();
    ASSERT_TRUE(samples::write_sample(sample, folder_.path()).has_value());
    const std::string own = folder_.at(sample.name) + "/";
    JobArguments arguments;
    arguments.path = own + sample.toolpath_file;
    arguments.tools_file = own + "tools.json";
    for (const auto& part : sample.parts) arguments.parts.push_back(own + part.file);
    for (const auto& fixture : sample.fixtures) arguments.fixtures.push_back(own + fixture.file);
    job_ = guarantee::load(arguments);
    ASSERT_EQ(job_.toolpath.moves.size(), sample.moves);
    result_ = guarantee::check_job(job_);
  }

  testing_support::TemporaryFolder folder_;
  Job job_;
  CheckResult result_;
};

INSTANTIATE_TEST_SUITE_P(All, GuaranteeOnSamples, ::testing::ValuesIn(kSamples),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(GuaranteeOnSamplesList, NoSampleIsForgotten) {
  std::vector<std::string> made, tested;
  // The guarantee of heads is held in tests/lib/head.
  for (const samples::Sample& sample : samples::make_all()) {
    if (sample.heads.empty()) made.push_back(sample.name);
  }
  for (const SampleCase& c : kSamples) tested.emplace_back(c.name);
  EXPECT_EQ(made, tested);
}

TEST_P(GuaranteeOnSamples, EveryWitnessRealisesItsDepthAndNothingIsDeeperThanReported) {
  guarantee::expect_witnesses(job_, result_);
  guarantee::expect_nothing_deeper(job_, result_);
}

}  // namespace
}  // namespace gouge::guarantee_test
