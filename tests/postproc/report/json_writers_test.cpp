#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "lib/base/files.h"
#include "postproc/report/write_report.h"
#include "tests/postproc/report/small_report.h"
#include "tests/postproc/report/tilted_report.h"
#include "tests/support/source_folder.h"

namespace gouge::json_writers_test {
namespace {

using nlohmann::json;

bool has_type(const json& value, const std::string& type) {
  if (type == "object") return value.is_object();
  if (type == "array") return value.is_array();
  if (type == "string") return value.is_string();
  if (type == "integer") return value.is_number_integer();
  if (type == "number") return value.is_number();
  if (type == "boolean") return value.is_boolean();
  return type == "null" && value.is_null();
}

// The part of JSON Schema that report.schema.json uses. Unknown keywords count as errors, so that the schema
// cannot have a field that this does not examine.
void check_schema(const json& root, const json& schema, const json& value, const std::string& where,
                  std::vector<std::string>& errors) {
  for (const auto& [keyword, rule] : schema.items()) {
    if (keyword == "$ref") {
      check_schema(root, root.at(json::json_pointer(rule.get<std::string>().substr(1))), value, where, errors);
    } else if (keyword == "type") {
      const json types = rule.is_array() ? rule : json::array({rule});
      bool fits = false;
      for (const json& type : types) fits = fits || has_type(value, type.get<std::string>());
      if (!fits) errors.push_back(where + ": not " + rule.dump() + " but " + value.dump());
    } else if (keyword == "enum") {
      if (std::find(rule.begin(), rule.end(), value) == rule.end()) errors.push_back(where + ": not in enum");
    } else if (keyword == "const") {
      if (value != rule) errors.push_back(where + ": not " + rule.dump());
    } else if (keyword == "required") {
      for (const json& key : rule) {
        if (value.is_object() && !value.contains(key.get<std::string>()))
          errors.push_back(where + ": no " + key.dump());
      }
    } else if (keyword == "properties") {
      for (const auto& [key, rest] : rule.items()) {
        if (value.is_object() && value.contains(key)) check_schema(root, rest, value[key], where + "/" + key, errors);
      }
    } else if (keyword == "additionalProperties") {
      const json object = value.is_object() ? value : json::object();
      for (const auto& [key, rest] : object.items()) {
        const bool is_known = schema.contains("properties") && schema["properties"].contains(key);
        if (is_known) continue;
        if (rule.is_boolean())
          errors.push_back(where + ": unknown key " + key);
        else
          check_schema(root, rule, rest, where + "/" + key, errors);
      }
    } else if (keyword == "items") {
      for (std::size_t i = 0; value.is_array() && i < value.size(); ++i) {
        check_schema(root, rule, value[i], where + "/" + std::to_string(i), errors);
      }
    } else if (keyword == "minItems") {
      if (value.is_array() && value.size() < rule.get<std::size_t>()) errors.push_back(where + ": too short");
    } else if (keyword == "maxItems") {
      if (value.is_array() && value.size() > rule.get<std::size_t>()) errors.push_back(where + ": too long");
    } else if (keyword == "minimum") {
      if (value.is_number() && value < rule) errors.push_back(where + ": below minimum");
    } else if (!std::set<std::string>{"$schema", "$id", "title", "description", "$defs"}.contains(keyword)) {
      errors.push_back(where + ": the schema uses " + keyword);
    }
  }
}

std::vector<std::string> schema_errors(const json& value) {
  const Result<std::string> text = read_file(source_folder() + "/docs/formats/report.schema.json");
  if (!text) return {text.error().message};
  std::vector<std::string> errors;
  const json schema = json::parse(*text);
  check_schema(schema, schema, value, "", errors);
  return errors;
}

TEST(WriteJson, ObeysItsSchema) {
  SmallReport report;
  EXPECT_EQ(schema_errors(json::parse(write_json(report.model))), std::vector<std::string>{});
  report.add_correction();
  report.path.unit = LengthUnit::inch;
  report.result.verdicts[5].depth_upper_mm = std::numeric_limits<double>::infinity();
  EXPECT_EQ(schema_errors(json::parse(write_json(report.model))), std::vector<std::string>{});
}

TEST(WriteJson, ChangesCarryTheirCauseAndTheirRecordsAndSaysWhatIsUncut) {
  SmallReport report;
  report.add_correction();
  std::vector<CorrectedRecord>& changes = report.model.correction.changes;
  changes[0].cause = CauseRecord{1, 11, MoveState::gouge, 0.25, Body::cutter, Against::part, "part.stl"};
  changes[0].old_record = "GOTO/1,2,3\n";
  changes[0].new_record = "GOTO/1,2,3.25\n";
  report.set_gouge(1, 0.25);
  report.model.correction.uncut = {
      {3, 5, 13, 15, 2, 12.5}, {7, 7, 17, 17, 0, 4}, {9, 9, 19, 19, 0, 1.5, Uncut::Kind::hole}};
  report.model.correction.low_rapids = {{2, 12, -0.25}};
  const json value = json::parse(write_json(report.model));
  EXPECT_EQ(schema_errors(value), std::vector<std::string>{});
  const json& first = value["correction"]["changes"][0];
  EXPECT_EQ(first["old_record"], "GOTO/1,2,3\n");
  EXPECT_EQ(first["new_record"], "GOTO/1,2,3.25\n");
  EXPECT_EQ(first["cause"]["line"], 11);
  EXPECT_EQ(first["cause"]["body"], "cutter");
  EXPECT_EQ(first["cause"]["against"], "part");
  EXPECT_EQ(first["cause"]["mesh"], "part.stl");
  EXPECT_TRUE(value["correction"]["changes"][1]["cause"].is_null());
  EXPECT_TRUE(value["correction"]["changes"][1]["old_record"].is_null());
  EXPECT_EQ(value["correction"]["uncut"]["positions"], 2);
  EXPECT_EQ(value["correction"]["uncut"]["length"], 16.5);
  EXPECT_EQ(value["correction"]["uncut"]["stretches"][0]["last_line"], 15);
  EXPECT_EQ(value["correction"]["uncut"]["holes"], 1);
  EXPECT_EQ(value["correction"]["uncut"]["stretches"][2]["kind"], "hole");
  EXPECT_EQ(value["correction"]["low_rapids"][0]["keeps"], -0.25);
}

TEST(WriteJson, LeavesOutStatementsThatAreNoText) {
  SmallReport report;
  report.set_gouge(1, 0.25);
  report.path.source = "GOTO/1,2,3\n";
  report.path.statements = {SourceStatement{1, 0, report.path.source.size()}};
  report.path.moves[1].statement = 0;
  EXPECT_EQ(json::parse(write_json(report.model))["moves"][0]["statement"], "GOTO/1,2,3");
  report.path.source = "\x01OTO/1,2,3\n";
  EXPECT_EQ(json::parse(write_json(report.model))["moves"][0]["statement"], "");
}

TEST(WriteJson, HasTheCuresOfFindings) {
  SmallReport report;
  ASSERT_GE(report.result.events.size(), 2U);
  EXPECT_TRUE(json::parse(write_json(report.model))["cures"].is_null()) << "not asked";
  report.model.cure_options = CureOptions();
  report.model.cures = {{0, {0.1, ""}, {2.5, 1, Body::holder, MoveState::gouge, 2.25}},
                        {1, {std::nullopt, "none there"}, {std::nullopt, 2, Body::head, MoveState::buried}}};
  const json value = json::parse(write_json(report.model));
  EXPECT_EQ(schema_errors(value), std::vector<std::string>{});
  const json& first = value["events"][0]["cures"];
  EXPECT_EQ(first["tilt"]["rad"], 0.1);
  EXPECT_TRUE(first["tilt"]["reason"].is_null());
  EXPECT_EQ(first["lift"]["length"], 2.5);
  EXPECT_EQ(first["lift"]["is_least"], false);
  EXPECT_EQ(first["lift"]["not_free_below"], 2.25);
  EXPECT_EQ(first["lift"]["body"], "holder");
  const json& second = value["events"][1]["cures"];
  EXPECT_TRUE(second["tilt"]["rad"].is_null());
  EXPECT_EQ(second["tilt"]["reason"], "none there");
  EXPECT_TRUE(second["lift"]["length"].is_null());
  EXPECT_EQ(second["lift"]["state"], "buried");
}

TEST(WriteJson, ReportsTheFilesOfHeads) {
  SmallReport report;
  EXPECT_EQ(json::parse(write_json(report.model))["heads"], json::array());
  report.model.inputs.push_back(describe_input("head", "head.stl", "solid"));
  report.model.heads = {MeshFacts{"head.stl", 12, 8, 0, true, ""}};
  const json value = json::parse(write_json(report.model));
  EXPECT_EQ(schema_errors(value), std::vector<std::string>{});
  EXPECT_EQ(value["heads"][0]["name"], "head.stl");
  EXPECT_EQ(value["heads"][0]["triangles"], 12);
}

TEST(WriteJson, ReportsStickOuts) {
  SmallReport report;
  EXPECT_TRUE(json::parse(write_json(report.model))["stickout"].is_null()) << "not asked";
  report.model.stickout_options = StickoutOptions{0.5, 100};
  StickoutFacts tool;
  tool.found.tool = 0;
  tool.found.now_mm = 40;
  tool.found.all = {52.5, 2, Body::holder};
  tool.found.operations = {{0, {52.5, 2, Body::holder}}, {1, {40, kNone, Body::holder}}};
  report.model.stickouts = {tool, tool};
  report.model.stickouts[1].found.all = {std::nullopt, 3, Body::head};
  const json value = json::parse(write_json(report.model));
  EXPECT_EQ(schema_errors(value), std::vector<std::string>{});
  const json& first = value["stickout"]["tools"][0];
  EXPECT_EQ(first["tool"], "1");
  EXPECT_EQ(first["needed"], 52.5);
  EXPECT_EQ(first["line"], 12);
  EXPECT_TRUE(first["operations"][1]["line"].is_null());
  EXPECT_TRUE(value["stickout"]["tools"][1]["needed"].is_null());
}

TEST(WriteJson, ReportsHowTheAxisTurns) {
  TiltedReport report;
  json value = json::parse(write_json(report.model));
  EXPECT_EQ(schema_errors(value), std::vector<std::string>{});
  const json& quality = value["correction"]["quality"];
  const AxisFacts& axes = *report.model.correction.axes;
  EXPECT_EQ(quality["after"]["bending"].get<double>(), axes.after.bending);
  EXPECT_EQ(quality["after"]["largest_turn_per_length"]["rad"].get<double>(), axes.after.turn_rad_per_mm.value);
  EXPECT_EQ(quality["after"]["largest_turn_per_length"]["line"], 90);
  EXPECT_EQ(quality["before"]["largest_turn_per_length"]["move"], 80);
  EXPECT_EQ(quality["before"]["largest_turn_on_the_spot"]["line"], nullptr);
  EXPECT_EQ(quality["before"]["feed_seconds"].get<double>(), axes.before.feed_seconds);
  EXPECT_EQ(quality["after"]["feed_seconds_with_max_rotary_speed"].get<double>(), axes.after.limited_feed_seconds);
  EXPECT_EQ(quality["max_rotary_speed_deg_per_min"], 600);
  EXPECT_EQ(quality["largest_tilt"]["move"], 60);
  EXPECT_EQ(quality["positions"], (json{{"moved", 1}, {"inserted", 1}, {"tilted", 39}}));
  EXPECT_EQ(quality["tilted_runs"], 1);
  report.path.unit = LengthUnit::inch;
  report.model.correction.axes->max_rotary_deg_per_min.reset();
  report.model.correction.axes->after.limited_feed_seconds.reset();
  report.model.correction.axes->before.feed_seconds = std::numeric_limits<double>::infinity();
  value = json::parse(write_json(report.model));
  EXPECT_EQ(schema_errors(value), std::vector<std::string>{});
  EXPECT_DOUBLE_EQ(value["correction"]["quality"]["after"]["bending"].get<double>(), axes.after.bending * 16387.064);
  report.model.correction.axes.reset();
  value = json::parse(write_json(report.model));
  EXPECT_EQ(schema_errors(value), std::vector<std::string>{});
  EXPECT_TRUE(value["correction"]["quality"].is_null()) << "not measured";
}

TEST(WriteJson, SchemaCheckCanFail) {
  const SmallReport report;
  json value = json::parse(write_json(report.model));
  value["verdict"] = "fine";
  EXPECT_EQ(schema_errors(value).size(), 1U);
  value.erase("verdict");
  EXPECT_EQ(schema_errors(value), std::vector<std::string>{": no \"verdict\""});
  value["surprise"] = 1;
  EXPECT_EQ(schema_errors(value).size(), 2U);
}

TEST(WriteJson, KeepsItsKeyOrderAndItsNumbers) {
  const SmallReport report;
  const std::string text = write_json(report.model);
  EXPECT_EQ(text.substr(0, 33), "{\n \"format\": \"gougecheck-report\",");
  const json value = json::parse(text);
  EXPECT_EQ(value["moves"].size(), 7U);
  EXPECT_EQ(value["moves"][1]["depth"].get<double>(), 0.3333);
  EXPECT_EQ(value["moves"][1]["witness"]["mesh"], "part.stl");
  EXPECT_TRUE(value["moves"][3]["depth"].is_null());
  EXPECT_EQ(value["totals"]["gouge"], 2);
  EXPECT_EQ(value["exit_status"], 1);
  EXPECT_EQ(text, write_json(report.model));
}

TEST(WriteJson, SurvivesNamesThatAreNotUtf8) {
  SmallReport report;
  report.path.file = "p\xFFth.apt";
  report.path.words_not_understood["\xC0"] = 1;
  EXPECT_EQ(json::parse(write_json(report.model))["toolpath"]["file"], "p\xEF\xBF\xBDth.apt");
  EXPECT_TRUE(json::accept(write_sarif(report.model)));
}

TEST(WriteSarif, HasAResultForEveryFindingAndReason) {
  SmallReport report;
  report.path.file = "my paths/path 1.apt";
  const json log = json::parse(write_sarif(report.model));
  EXPECT_EQ(log["version"], "2.1.0");
  const json& run = log["runs"][0];
  std::vector<std::string> ids;
  for (const json& result : run["results"]) {
    ids.push_back(result["ruleId"]);
    EXPECT_EQ(run["tool"]["driver"]["rules"][result["ruleIndex"].get<std::size_t>()]["id"], result["ruleId"]);
    EXPECT_EQ(result["locations"][0]["physicalLocation"]["artifactLocation"]["uri"], "my%20paths/path%201.apt");
  }
  EXPECT_EQ(ids, (std::vector<std::string>{"gouge", "near", "buried", "not-certified", "not-checked"}));
  EXPECT_EQ(run["results"][0]["level"], "error");
  EXPECT_EQ(run["results"][0]["locations"][0]["physicalLocation"]["region"]["startLine"], 12);
  EXPECT_EQ(run["results"][0]["message"]["text"],
            "gouge: 0.333 mm cutter T1 at (12.3, 4.5, 6.7), move 2 t=0.42 (2 moves, 1-2)");
}

TEST(WriteSarif, ReportsWarningsOfTheInput) {
  SmallReport report;
  report.model.notes.push_back(make_note("tool-no-holder", "T1 has no holder", "path.apt", 3));
  const json invocation = json::parse(write_sarif(report.model))["runs"][0]["invocations"][0];
  const json& reported = invocation["toolExecutionNotifications"];
  ASSERT_EQ(reported.size(), 1U) << "notes are no warnings";
  EXPECT_EQ(reported[0]["level"], "warning");
  EXPECT_EQ(reported[0]["descriptor"]["id"], "apt-word");
  EXPECT_EQ(reported[0]["message"]["text"], "path.apt:4: warning: word not understood [apt-word]");
}

TEST(WriteSarif, FingerprintsHoldWhenLinesMoveAndDifferBetweenFindings) {
  SmallReport report;
  const auto prints = [&] {
    std::vector<std::string> all;
    const json log = json::parse(write_sarif(report.model));
    for (const json& result : log["runs"][0]["results"]) {
      all.push_back(result["partialFingerprints"]["gougecheckFinding/v2"]);
    }
    return all;
  };
  const std::vector<std::string> before = prints();
  EXPECT_EQ(std::set<std::string>(before.begin(), before.end()).size(), before.size());
  for (Move& move : report.path.moves) move.line = move.line + 100;
  EXPECT_EQ(prints(), before);
}

}  // namespace
}  // namespace gouge::json_writers_test
