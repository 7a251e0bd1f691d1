#include <gtest/gtest.h>

#include <map>
#include <sstream>

#include "tests/samples/csv.h"
#include "tests/samples/program.h"
#include "tests/samples/sample_folder.h"

// Every sample gets the verdict its formulas give, move by move.

namespace gouge::testing_samples::verdicts_test {
namespace {

class Verdicts : public ::testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(Samples, Verdicts, ::testing::ValuesIn(sample_names()),
                         [](const auto& test) { return test.param; });

TEST(SampleList, IsWhatTheGeneratorWrites) {
  const std::string folder = fresh_folder();
  ASSERT_EQ(run_make_samples(folder).exit_status, 0);
  std::vector<std::string> names;
  std::istringstream index(text_of(folder + "/index.txt"));
  for (std::string line; std::getline(index, line);) names.push_back(line.substr(0, line.find(' ')));
  EXPECT_EQ(names, sample_names());
}

TEST_P(Verdicts, ExitStatusStatesBodiesAndDepthsAreThoseExpected) {
  const SampleFolder sample = open_sample(GetParam());
  const Outcome ran = run_gougecheck(sample.path, sample.arguments("check", sample.toolpath(), {"--csv", "all.csv"}));
  EXPECT_EQ(ran.exit_status, sample.expected.at("check_exit").get<int>()) << ran.out << ran.err;
  const std::vector<MoveRow> rows = parse_moves(text_of(sample.path + "/all.csv"));
  ASSERT_EQ(rows.size(), sample.expected.at("moves").get<std::size_t>());

  std::map<std::size_t, nlohmann::json> findings;
  for (const auto& finding : sample.expected.at("findings")) findings[finding.at("line")] = finding;
  std::size_t found = 0;
  for (const MoveRow& row : rows) {
    const auto it = findings.find(row.line);
    if (it == findings.end()) {
      EXPECT_EQ(row.state, "clean") << "line " << row.line << ", depth " << row.depth;
      EXPECT_LE(row.depth_upper_value(), 0.011) << "line " << row.line;
      continue;
    }
    ++found;
    const nlohmann::json& expected = it->second;
    EXPECT_EQ(row.state, expected.at("state")) << "line " << row.line;
    if (row.state != "gouge") continue;
    EXPECT_EQ(row.body, expected.at("body")) << "line " << row.line;
    EXPECT_EQ(row.against, expected.at("against")) << "line " << row.line;
    EXPECT_LE(row.depth_value(), expected.at("depth_max").get<double>()) << "line " << row.line;
    EXPECT_GE(row.depth_upper_value(), expected.at("depth_min").get<double>()) << "line " << row.line;
    const double unit = sample.expected.at("unit") == "inch" ? 25.4 : 1;
    EXPECT_LE((row.depth_upper_value() - row.depth_value()) * unit, 0.001 + 1e-9) << "line " << row.line;
  }
  EXPECT_EQ(found, findings.size());
}

TEST_P(Verdicts, OneFindingOnStandardOutputNamesEachGougingStretch) {
  const SampleFolder sample = open_sample(GetParam());
  const Outcome ran = run_gougecheck(sample.path, sample.arguments("check", sample.toolpath()));
  const std::string start = sample.toolpath() + ":";
  std::istringstream lines(ran.out);
  std::size_t reported = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind(start, 0) != 0) continue;
    ++reported;
    EXPECT_TRUE(line.find(": gouge: ") != std::string::npos || line.find(": buried") != std::string::npos) << line;
  }
  const std::size_t findings = sample.expected.at("findings").size();
  EXPECT_LE(reported, findings);
  EXPECT_EQ(reported == 0, findings == 0);
}

TEST_P(Verdicts, AreTheSameBytesAtOneAndTwoThreads) {
  const SampleFolder sample = open_sample(GetParam());
  for (const std::string threads : {"1", "2"}) {
    const Outcome ran = run_gougecheck(
        sample.path, sample.arguments("check", sample.toolpath(),
                                      {"--csv", threads + ".csv", "--json", threads + ".json", "--threads", threads}));
    EXPECT_EQ(ran.exit_status, sample.expected.at("check_exit").get<int>()) << ran.err;
  }
  const std::string csv = text_of(sample.path + "/1.csv"), json = text_of(sample.path + "/1.json");
  EXPECT_FALSE(csv.empty());
  EXPECT_TRUE(nlohmann::json::accept(json));
  EXPECT_EQ(csv, text_of(sample.path + "/2.csv"));
  EXPECT_EQ(json, text_of(sample.path + "/2.json"));
}

}  // namespace
}  // namespace gouge::testing_samples::verdicts_test
