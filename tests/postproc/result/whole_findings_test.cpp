#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "lib/path/motion_key.h"
#include "postproc/record/result_digest.h"
#include "postproc/record/write_record.h"
#include "postproc/result/stored_result.h"

namespace gouge::whole_findings_test {
namespace {

using Json = nlohmann::json;

MoveRecord gouging(std::size_t move) {
  MoveRecord record;
  record.move = move;
  record.line = move + 10;
  record.tool = "1";
  record.motion = std::string(kMotionDigits, 'a');
  record.depth_mm = record.depth_upper_mm = 0.2;
  record.witness = WitnessRecord{0.5, {1, 2, 3}, {0, 0, 1}, Body::cutter, Against::part, "part.stl", 0};
  return record;
}

EventRecord event_of(std::size_t number, std::size_t first, std::size_t last) {
  EventRecord record;
  record.number = number;
  record.first_move = record.worst_move = first;
  record.last_move = last;
  record.moves = last - first + 1;
  record.line = first + 10;
  record.tool = "1";
  record.tool_index = 0;
  return record;
}

Json parsed(const ResultRecord& record) {
  Json json = Json::parse(write_record(record));
  json.erase("digest");
  return json;
}

Json event(std::size_t number, std::size_t first, std::size_t last) {
  ResultRecord record;
  record.events = {event_of(number, first, last)};
  return parsed(record)["events"][0];
}

/// Returns a result of so many moves. Those listed gouge.
ResultRecord record_of_moves(std::size_t count, const std::vector<std::size_t>& gouges) {
  ResultRecord record;
  record.verdict = "gouges";
  record.options.rapid = "straight";
  record.toolpath.moves = count;
  ToolRecord tool;
  tool.key = "1";
  tool.identity = "x";
  tool.bodies = {Body::cutter};
  record.tools = {tool};
  for (std::size_t first = 0; first < count; first += kMotionsOfText)
    record.motions.emplace_back(std::min(kMotionsOfText, count - first) * kListedDigits, 'a');
  record.runs = {{0, "", "1"}};
  for (const std::size_t move : gouges) record.moves.push_back(gouging(move));
  return record;
}

/// Four moves, of which 0, 1 and 3 gouge.
Json result() {
  ResultRecord record = record_of_moves(4, {0, 1, 3});
  record.events = {event_of(1, 0, 1), event_of(2, 3, 3)};
  return parsed(record);
}

std::string error_of(const Json& json) {
  const Result<StoredResult> read = read_result("a.json", with_digest(json.dump(1) + "\n"));
  return read ? "" : to_text(read.error());
}

TEST(WholeFindings, EveryGougeIsOfOneFinding) {
  EXPECT_EQ(error_of(result()), "");
  Json twice = result();
  twice["events"] = Json::array({event(1, 0, 1), event(2, 1, 1), event(3, 3, 3)});
  EXPECT_NE(error_of(twice).find("'/events/1/first_move' is 1; expected findings of the path, one behind the other"),
            std::string::npos)
      << error_of(twice);
  Json hidden = result();
  hidden["events"] = Json::array({event(1, 0, 1)});
  EXPECT_NE(error_of(hidden).find("expected every move that gouges or is buried in one of them"), std::string::npos)
      << error_of(hidden);
  Json beyond = result();
  beyond["events"][1]["last_move"] = 4;
  EXPECT_NE(error_of(beyond).find("expected findings of the path, one behind the other"), std::string::npos);
}

// With overlapping findings every one of them would go through all moves.
TEST(WholeFindings, ManyFindingsOverAllMovesAreRefused) {
  Json json = result();
  json["events"] = Json::array();
  for (std::size_t k = 0; k < 10'000; ++k) json["events"].push_back(event(k + 1, 0, 1));
  EXPECT_NE(error_of(json).find("'/events/1/first_move' is 0"), std::string::npos) << error_of(json);
}

}  // namespace
}  // namespace gouge::whole_findings_test
