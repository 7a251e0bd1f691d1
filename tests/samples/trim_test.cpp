#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/samples/program.h"
#include "tests/samples/sample_folder.h"

// correct --strategy trim, as users run it.

namespace gouge::testing_samples::trim_test {
namespace {

using Json = nlohmann::json;

struct Corrected {
  Outcome ran;
  Json report;

  [[nodiscard]] const Json& correction() const { return report.at("correction"); }
};

Corrected correct(const SampleFolder& sample, std::vector<std::string> more) {
  more.insert(more.end(), {"-o", "corrected.apt", "--json", "result.json"});
  Outcome ran = run_gougecheck(sample.path, sample.arguments("correct", sample.toolpath(), more));
  return {std::move(ran), Json::parse(text_of(sample.path + "/result.json"))};
}

std::size_t count_of(const std::string& text, const std::string& wanted) {
  std::size_t count = 0;
  for (std::size_t at = text.find(wanted); at != std::string::npos; at = text.find(wanted, at + 1)) ++count;
  return count;
}

// The holder meets the wall along its last pass.
TEST(Trim, LeavesTheStretchOutInWhichTheFreeformsHolderMeetsTheWall) {
  const SampleFolder sample = open_sample("freeform");
  const Corrected trimmed = correct(sample, {"--strategy", "holder=trim"});
  EXPECT_EQ(trimmed.ran.exit_status, 0) << trimmed.ran.err;
  const Json& uncut = trimmed.correction().at("uncut");
  ASSERT_EQ(uncut.at("stretches").size(), 1U);
  const std::size_t positions = uncut.at("positions");
  EXPECT_GT(positions, 80U);
  EXPECT_GT(uncut.at("length").get<double>(), 80);
  std::size_t trims = 0;
  for (const Json& change : trimmed.correction().at("changes")) {
    if (change.at("strategy") != "trim") continue;
    ++trims;
    EXPECT_GE(change.at("move"), uncut.at("stretches").at(0).at("first_move"));
    EXPECT_LE(change.at("move"), uncut.at("stretches").at(0).at("last_move"));
  }
  EXPECT_GE(trims, positions + 2);
  // The crossing runs lower than the rapids before it, so it is a feed; a rapid that is lifted may add its own.
  const std::size_t rapids = count_of(text_of(sample.path + "/" + sample.toolpath()), "RAPID");
  EXPECT_LT(count_of(text_of(sample.path + "/corrected.apt"), "RAPID"), rapids + 10);
  EXPECT_NE(trimmed.ran.out.find(std::to_string(positions) + " positions and "), std::string::npos) << trimmed.ran.out;
  EXPECT_NE(trimmed.ran.out.find(" left uncut in 1 stretch"), std::string::npos) << trimmed.ran.out;
  const Outcome again = run_gougecheck(sample.path, sample.arguments("check", "corrected.apt"));
  EXPECT_EQ(again.exit_status, 0) << again.out << again.err;
}

// Old records in the file as it was, new ones in the corrected one, each once and in order; and why.
TEST(Trim, EveryChangeCarriesItsRecordsAndItsCause) {
  const SampleFolder sample = open_sample("freeform");
  for (const std::string strategy : {"holder=trim", "auto", "axis"}) {
    const Corrected corrected = correct(sample, {"--strategy", strategy});
    const std::string before = text_of(sample.path + "/" + sample.toolpath());
    const std::string after = text_of(sample.path + "/corrected.apt");
    std::size_t at_before = 0, at_after = 0, holders = 0;
    ASSERT_GT(corrected.correction().at("changes").size(), 100U);
    for (const Json& change : corrected.correction().at("changes")) {
      const Json& cause = change.at("cause");
      ASSERT_FALSE(cause.is_null());
      EXPECT_EQ(cause.at("mesh"), "part.stl");
      holders += cause.at("body") == "holder" ? 1U : 0U;
      EXPECT_EQ(change.at("old_record").is_null(), change.at("is_inserted").get<bool>());
      if (!change.at("old_record").is_null()) {
        at_before = before.find(change.at("old_record").get<std::string>(), at_before);
        ASSERT_NE(at_before, std::string::npos) << change;
      }
      const std::string written = change.at("new_record");
      at_after = after.find(written, at_after);
      ASSERT_NE(at_after, std::string::npos) << change;
      EXPECT_NE(written.find("GOTO/"), std::string::npos);
      at_after += written.size();
    }
    EXPECT_GT(holders, 90U);
  }
}

TEST(Trim, OfTheHeadLeavesOutWhereItMeetsThePost) {
  const SampleFolder sample = open_sample("between_head");
  const Corrected trimmed = correct(sample, {"--strategy", "head=trim"});
  EXPECT_EQ(trimmed.ran.exit_status, 0) << trimmed.ran.err;
  EXPECT_EQ(trimmed.correction().at("uncut").at("stretches").size(), 1U);
}

// Binary records cannot state rapid of one motion: the crossing is a feed, and certified as one.
TEST(Trim, OfBinaryRecordsCrossesAsFeed) {
  const SampleFolder sample = open_sample("freeform");
  const Outcome converted =
      run_gougecheck(sample.path, {"path", "convert", sample.toolpath(), "--to", "nccs-binary", "-o", "pass.cl"});
  ASSERT_EQ(converted.exit_status, 0) << converted.err;
  std::vector<std::string> arguments = sample.arguments(
      "correct", "pass.cl", {"--path-units", "mm", "--strategy", "trim", "-o", "trimmed.cl", "--json", "result.json"});
  const Outcome ran = run_gougecheck(sample.path, arguments);
  EXPECT_EQ(ran.exit_status, 0) << ran.err;
  const Json report = Json::parse(text_of(sample.path + "/result.json"));
  EXPECT_GT(report.at("correction").at("uncut").at("positions"), 100);
  for (const Json& change : report.at("correction").at("changes")) {
    EXPECT_TRUE(change.at("old_record").is_null());
    EXPECT_TRUE(change.at("new_record").is_null());
  }
  const Outcome checked = run_gougecheck(
      sample.path, sample.arguments("check", "pass.cl", {"--path-units", "mm", "--json", "before.json"}));
  EXPECT_EQ(checked.exit_status, 1) << checked.err;
  const Json before = Json::parse(text_of(sample.path + "/before.json"));
  const auto rapids = [](const Json& of) { return of.at("toolpath").at("moves_by_kind").at("rapid").get<int>(); };
  // A rapid of the file that is joined in the air gets positions of its own.
  EXPECT_LT(rapids(report), rapids(before) + 10);
}

// Only what leaving out frees may be left out, and the tolerance of all others holds: nothing is worse anywhere.
TEST(Trim, OfEverySampleIsCleanOrListsWhatItIsNot) {
  for (const std::string& name : sample_names()) {
    const SampleFolder sample = open_sample(name);
    const Corrected trimmed = correct(sample, {"--strategy", "trim", "--force"});
    const int status = trimmed.ran.exit_status;
    EXPECT_TRUE(status == 0 || status == 1 || status == 4) << name << "\n" << trimmed.ran.err;
    const Json& totals = trimmed.report.at("totals");
    const bool has_bad = totals.at("gouge") > 0 || totals.at("buried") > 0;
    EXPECT_EQ(has_bad, !trimmed.correction().at("uncorrected").empty()) << name;
    for (const Json& left : trimmed.correction().at("uncorrected"))
      EXPECT_FALSE(left.at("reason").get<std::string>().empty()) << name;
  }
}

TEST(Trim, IsTheSameAtAnyNumberOfThreadsAndShownToPeople) {
  const SampleFolder sample = open_sample("freeform");
  std::string first;
  for (const std::string threads : {"1", "3"}) {
    const Corrected trimmed = correct(sample, {"--strategy", "trim", "--threads", threads, "--report", "r" + threads});
    EXPECT_EQ(trimmed.ran.exit_status, 0);
    const std::string text = text_of(sample.path + "/corrected.apt");
    if (first.empty()) first = text;
    EXPECT_EQ(text, first);
    EXPECT_NE(text_of(sample.path + "/r" + threads + "/report.html").find("left uncut in"), std::string::npos);
  }
}

}  // namespace
}  // namespace gouge::testing_samples::trim_test
