#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/samples/csv.h"
#include "tests/samples/program.h"
#include "tests/samples/sample_folder.h"

// check --find-stickout on the samples whose holder or head is in the way, proved by checks just below the result and at
// it with the tool made longer by hand.

namespace gouge::testing_samples::stickout_test {
namespace {

using Json = nlohmann::json;

Json stickout_of(const SampleFolder& sample, std::vector<std::string> more) {
  more.insert(more.end(), {"--find-stickout", "--json", "stickout.json"});
  const Outcome ran = run_gougecheck(sample.path, sample.arguments("check", sample.toolpath(), more));
  EXPECT_EQ(ran.exit_status, 1) << ran.err;
  return Json::parse(text_of(sample.path + "/stickout.json")).at("stickout");
}

/// Moves that shank or holder gouges in, the first tool's shank lengthened.
std::size_t holder_gouges(const SampleFolder& sample, double longer_mm) {
  Json library = Json::parse(text_of(sample.path + "/tools.json"));
  Json& shank = library.at("tools").at(0).at("shank").back();
  shank.at("length") = shank.at("length").get<double>() + longer_mm;
  write_text(sample.path + "/longer.json", library.dump());
  std::vector<std::string> arguments = sample.arguments("check", sample.toolpath(), {"--csv", "longer.csv"});
  std::replace(arguments.begin(), arguments.end(), std::string("tools.json"), std::string("longer.json"));
  EXPECT_NE(run_gougecheck(sample.path, arguments).exit_status, 3);
  const std::vector<MoveRow> rows = parse_moves(text_of(sample.path + "/longer.csv"));
  return static_cast<std::size_t>(std::count_if(rows.begin(), rows.end(), [](const MoveRow& row) {
    return row.state == "gouge" && (row.body == "holder" || row.body == "shank");
  }));
}

TEST(Stickout, FreesTheHolderAndOneStepLessDoesNot) {
  const SampleFolder sample = open_sample("freeform");
  for (const std::string step : {"1", "0.25"}) {
    const Json found = stickout_of(sample, {"--stickout-step", step});
    ASSERT_EQ(found.at("tools").size(), 1U);
    const Json& tool = found.at("tools").at(0);
    const double now = tool.at("now"), needed = tool.at("needed"), by = found.at("step");
    EXPECT_GT(needed, now);
    EXPECT_EQ(tool.at("body"), "holder");
    EXPECT_EQ(holder_gouges(sample, needed - now), 0U);
    EXPECT_GT(holder_gouges(sample, needed - now - by), 0U);
    const auto needing = std::count_if(tool.at("operations").begin(), tool.at("operations").end(),
                                       [](const Json& of) { return !of.at("move").is_null(); });
    EXPECT_EQ(needing, 1) << "the last pass alone";
  }
}

// The post is 1.005 mm deep in the head as its formula states, and the head goes up along the tilted axis.
TEST(Stickout, FreesTheHead) {
  const SampleFolder sample = open_sample("between_head");
  const Json tool = stickout_of(sample, {"--stickout-step", "0.1"}).at("tools").at(0);
  const double longer = tool.at("needed").get<double>() - tool.at("now").get<double>();
  const double depth = sample.expected.at("findings").at(0).at("depth_max");
  EXPECT_EQ(tool.at("body"), "head");
  EXPECT_GE(longer, depth - 0.011);
  EXPECT_LE(longer, depth + 0.1);
}

TEST(Stickout, IsTheSameAtAnyNumberOfThreadsAndShownToPeople) {
  const SampleFolder sample = open_sample("freeform");
  std::string first;
  for (const std::string threads : {"1", "2", "5"}) {
    stickout_of(sample, {"--threads", threads, "--report", "r" + threads});
    const std::string text = text_of(sample.path + "/stickout.json");
    if (first.empty()) first = text;
    EXPECT_EQ(text, first);
    EXPECT_NE(text_of(sample.path + "/r" + threads + "/report.html").find("<h2>Stick-out</h2>"), std::string::npos);
  }
  const Outcome ran = run_gougecheck(sample.path, sample.arguments("check", sample.toolpath(), {"--find-stickout"}));
  EXPECT_NE(ran.out.find("\nstick-out T1: 50 mm; "), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find(" longer; at "), std::string::npos) << ran.out;
}

TEST(Stickout, OfAnInchPathIsInInches) {
  const SampleFolder sample = open_sample("inch");
  const Outcome ran = run_gougecheck(
      sample.path, sample.arguments("check", sample.toolpath(), {"--find-stickout", "--stickout-step", "0.125in"}));
  EXPECT_NE(ran.out.find("\nstick-out T2: 2.25 in; long enough\n"), std::string::npos) << ran.out << ran.err;
}

TEST(Stickout, WrongOptionsAreStatus2AndNamed) {
  const SampleFolder sample = open_sample("needles");
  for (const std::vector<std::string>& wrong : {std::vector<std::string>{"--stickout-step", "1"},
                                                {"--find-stickout", "--stickout-step", "0"},
                                                {"--find-stickout", "--stickout-step", "-1"},
                                                {"--find-stickout", "--stickout-step", "300"},
                                                {"--find-stickout", "--stickout-step", "1e-9"},
                                                {"--find-stickout", "--stickout-step", ""},
                                                {"--find-stickout", "--stickout-limit", "nan"},
                                                {"--find-stickout", "--stickout-limit", "0"}}) {
    const Outcome ran = run_gougecheck(sample.path, sample.arguments("check", sample.toolpath(), wrong));
    EXPECT_EQ(ran.exit_status, 2) << wrong.back();
    EXPECT_NE(ran.err.find("--stickout-"), std::string::npos) << ran.err;
  }
}

}  // namespace
}  // namespace gouge::testing_samples::stickout_test
