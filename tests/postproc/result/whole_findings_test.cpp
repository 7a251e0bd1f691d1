#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "lib/path/motion_key.h"
#include "postproc/record/result_digest.h"
#include "postproc/result/stored_result.h"

namespace gouge {
namespace {

using Json = nlohmann::json;

Json gouging(std::size_t move) {
  return {
      {"move", move},
      {"line", move + 10},
      {"state", "gouge"},
      {"kind", "feed"},
      {"tool", "1"},
      {"operation", ""},
      {"statement", ""},
      {"motion", std::string(kMotionDigits, 'a')},
      {"depth", 0.2},
      {"depth_upper", 0.2},
      {"overcut", nullptr},
      {"overcut_upper", nullptr},
      {"reason", ""},
      {"witness", {{"t", 0.5}, {"body", "cutter"}, {"against", "part"}, {"mesh", "part.stl"}, {"point", {1, 2, 3}}}}};
}

Json event(std::size_t number, std::size_t first, std::size_t last) {
  return {{"number", number},    {"state", "gouge"},          {"first_move", first}, {"last_move", last},
          {"worst_move", first}, {"moves", last - first + 1}, {"line", first + 10},  {"tool", "1"},
          {"tool_index", 0},     {"body", "cutter"},          {"against", "part"}};
}

/// Four moves, of which 0, 1 and 3 gouge.
Json result() {
  const Json options = {{"tolerance", 0.01},    {"resolution", 0.001},   {"stock_to_leave", 0},
                        {"shank_clearance", 0}, {"holder_clearance", 0}, {"rapid", "straight"}};
  return {{"format", "gougecheck-report"},
          {"format_version", 1},
          {"program", Json{{"version", "1"}}},
          {"verdict", "gouges"},
          {"unit", "mm"},
          {"placement", ""},
          {"toolpath", {{"file", "a.apt"}, {"moves", 4}}},
          {"totals", Json{{"left_out_as_asked", 0}}},
          {"options", options},
          {"inputs", Json::array()},
          {"tools", Json::array({Json{{"key", "1"}, {"identity", "x"}, {"bodies", Json::array({"cutter"})}}})},
          {"motions", Json::array({std::string(4 * kListedDigits, 'a')})},
          {"runs", Json::array({Json{{"first_move", 0}, {"operation", ""}, {"tool", "1"}}})},
          {"moves", Json::array({gouging(0), gouging(1), gouging(3)})},
          {"events", Json::array({event(1, 0, 1), event(2, 3, 3)})}};
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
}  // namespace gouge
