#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "lib/base/files.h"
#include "postproc/record/read_record.h"
#include "postproc/record/record_schema.h"
#include "postproc/record/result_digest.h"
#include "postproc/record/write_record.h"
#include "postproc/report/record_of.h"
#include "tests/postproc/report/small_report.h"
#include "tests/postproc/report/tilted_report.h"
#include "tests/support/source_folder.h"

namespace gouge::result_record_test {
namespace {

using nlohmann::json;

/// Fills every optional section of a report.
void fill(ReportModel& model, const CheckResult& result) {
  model.more_options = {{"place", "1,2,3"}, {"tool", "1=ball"}, {"tool", "2=flat"}};
  model.stickout_options = StickoutOptions{0.5, 100};
  StickoutFacts tool;
  tool.found.now_mm = 40;
  tool.found.all = {52.5, 2, Body::holder};
  tool.found.operations = {{0, {52.5, 2, Body::holder}}};
  model.stickouts = {tool};
  model.cure_options = CureOptions();
  model.cures = {{0, {0.1, ""}, {2.5, 1, Body::holder, MoveState::gouge, 2.25}}};
  model.baseline.file = "accepted.json";
  model.baseline.entries = {
      {.by = "me", .date = "2026-11-23", .reason = "stock", .finding = "0.25 mm", .use = BaselineEntry::Use::applied}};
  model.baseline.events.resize(result.events.size());
  model.baseline.events[0] = {{0}, true, ""};
}

struct FullReport : SmallReport {
  FullReport() {
    add_correction();
    fill(model, result);
    result.closest_approach = ClosestApproach{2, 2, 0.5, 1.5};
    Assumption fact;
    fact.subject = Subject::tool;
    fact.object = "T1";
    fact.value = "ball D10";
    result.assumptions = {fact};
    CorrectionFacts& c = model.correction;
    c.changes[0].cause = CauseRecord{1, 11, MoveState::gouge, 0.25, Body::cutter, Against::part, "part.stl"};
    c.changes[0].old_record = "GOTO/1,2,3\n";
    c.uncut = {{3, 5, 13, 15, 2, 12.5}};
    c.stock = {{3, 5, 13, 15, {0.5, false, true, {1, 2, 3}, 3}}};
    c.low_rapids = {{2, 12, -0.25}};
    c.written = {{WrittenKind::changed, 12}};
  }
};

std::string error_of(const json& value) {
  const Result<ReadRecord> read = read_record("r.json", value.dump());
  return read ? std::string() : read.error().code;
}

TEST(ResultRecord, ReadsBackAsItWasWritten) {
  const FullReport report;
  const std::string text = write_record(record_of(report.model));
  const Result<ReadRecord> read = read_record("r.json", text);
  ASSERT_TRUE(read.has_value()) << to_text(read.error());
  EXPECT_EQ(write_record(read->record), text);
  EXPECT_EQ(check_digest(text), DigestState::right);
}

TEST(ResultRecord, TheAxisQualityReadsBackToo) {
  const TiltedReport report;
  const std::string text = write_record(record_of(report.model));
  const Result<ReadRecord> read = read_record("r.json", text);
  ASSERT_TRUE(read.has_value()) << to_text(read.error());
  EXPECT_EQ(write_record(read->record), text);
}

TEST(ResultRecord, LengthsAreInTheUnitOfTheFile) {
  FullReport report;
  report.path.unit = LengthUnit::inch;
  const std::string text = write_record(record_of(report.model));
  EXPECT_DOUBLE_EQ(json::parse(text)["events"][0]["cures"]["lift"]["length"].get<double>(), 2.5 / 25.4);
  const Result<ReadRecord> read = read_record("r.json", text);
  ASSERT_TRUE(read.has_value());
  EXPECT_NEAR(*read->record.events[0].cures->lift.lift_mm, 2.5, 1e-15);
  EXPECT_NEAR(read->record.correction->low_rapids[0].keeps_mm, -0.25, 1e-15);
}

// Keys of objects whose keys are data.
bool is_data(const std::string& pointer) {
  return pointer.starts_with("/options/more/") || pointer.starts_with("/toolpath/words_not_understood/") ||
         pointer == "/digest";
}

/// Visits every key of every object in `value`.
void for_each_key(const json& value, const std::string& pointer, const std::function<void(const std::string&)>& visit) {
  if (value.is_object()) {
    for (const auto& [key, inner] : value.items()) {
      visit(pointer + "/" + key);
      for_each_key(inner, pointer + "/" + key, visit);
    }
  }
  for (std::size_t k = 0; value.is_array() && k < value.size(); ++k)
    for_each_key(value[k], pointer + "/" + std::to_string(k), visit);
}

TEST(ResultRecord, EveryFieldMustBeThereAndOfItsKind) {
  const FullReport report;
  const json whole = json::parse(write_record(record_of(report.model)));
  std::size_t fields = 0;
  for_each_key(whole, "", [&](const std::string& pointer) {
    if (is_data(pointer)) return;
    ++fields;
    json wrong = whole;
    const std::size_t slash = pointer.rfind('/');
    const json::json_pointer at(pointer), parent(pointer.substr(0, slash));
    wrong[parent].erase(pointer.substr(slash + 1));
    EXPECT_NE(error_of(wrong), "") << pointer << " is missing";
    wrong[at] = json::array({json::object()});
    EXPECT_NE(error_of(wrong), "") << pointer << " is of another kind";
  });
  EXPECT_GT(fields, 350U);
}

TEST(ResultRecord, RefusesValuesBeyondTheirLimits) {
  const FullReport report;
  const json whole = json::parse(write_record(record_of(report.model)));
  const auto error_with = [&](const char* pointer, const json& value) {
    json wrong = whole;
    wrong[json::json_pointer(pointer)] = value;
    return error_of(wrong);
  };
  EXPECT_EQ(error_with("/moves/1/depth", -1), "result-field");
  EXPECT_EQ(error_with("/moves/1/state", "goudge"), "result-field");
  EXPECT_EQ(error_with("/events/0/moves", 0), "result-field");
  EXPECT_EQ(error_with("/exit_status", 5'000'000'000), "result-field");
  EXPECT_EQ(error_with("/inputs/0/role", "friend"), "result-field");
  EXPECT_EQ(error_with("/format_version", 2), "result-format");
  EXPECT_EQ(error_with("/moves/1/witness/point", json::array({1, 2})), "result-field");
  EXPECT_EQ(error_with("/moves/1/depth", 0.25), "");
}

TEST(ResultRecord, TheSchemaOfTheDocsIsTheGeneratedOne) {
  const Result<std::string> page = read_file(source_folder() + "/docs/formats/report.schema.json");
  ASSERT_TRUE(page.has_value());
  EXPECT_EQ(*page, result_schema()) << "write it anew: gougecheck schema result > docs/formats/report.schema.json";
}

}  // namespace
}  // namespace gouge::result_record_test
