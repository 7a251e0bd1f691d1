#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "tests/samples/csv.h"
#include "tests/samples/program.h"
#include "tests/samples/sample_folder.h"

// check --find-cures as users run it: the lift proved on files lifted by hand, the tilt by what correct writes.

namespace gouge::testing_samples::cures_test {
namespace {

using Json = nlohmann::json;

struct Checked {
  Outcome ran;
  Json report;

  /// The finding of a body.
  [[nodiscard]] Json event_of(const std::string& body) const {
    for (const Json& event : report.at("events")) {
      if (event.at("body") == body) return event;
    }
    return nullptr;
  }
};

Checked check(const SampleFolder& sample, const std::string& toolpath, std::vector<std::string> more) {
  more.insert(more.end(), {"--json", "cures.json"});
  Outcome ran = run_gougecheck(sample.path, sample.arguments("check", toolpath, more));
  return {std::move(ran), Json::parse(text_of(sample.path + "/cures.json"))};
}

/// The toolpath with the positions of these lines lifted along their axes.
std::string lifted(const std::string& text, const std::set<std::size_t>& lines, double lift) {
  std::istringstream in(text);
  std::string out;
  std::size_t number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    std::array<double, 6> v{};
    const bool is_goto =
        std::sscanf(line.c_str(), "GOTO/%lf,%lf,%lf,%lf,%lf,%lf", &v[0], &v[1], &v[2], &v[3], &v[4], &v[5]) == 6;
    if (is_goto && lines.contains(number)) {
      std::array<char, 200> moved{};
      std::snprintf(moved.data(), moved.size(), "GOTO/%.7f,%.7f,%.7f,%.9f,%.9f,%.9f", v[0] + lift * v[3],
                    v[1] + lift * v[4], v[2] + lift * v[5], v[3], v[4], v[5]);
      line = moved.data();
    }
    out += line + "\n";
  }
  return out;
}

TEST(Cures, OfTheFreeformsHolderAreWhatACheckAndACorrectionSay) {
  const SampleFolder sample = open_sample("freeform");
  const Checked found = check(sample, sample.toolpath(), {"--find-cures", "--csv", "moves.csv"});
  EXPECT_EQ(found.ran.exit_status, 1);
  const Json event = found.event_of("holder");
  const Json& cures = event.at("cures");
  const double lift = cures.at("lift").at("length");
  const std::size_t first = event.at("first_move"), last = event.at("last_move");
  std::set<std::size_t> lines;
  for (const MoveRow& row : parse_moves(text_of(sample.path + "/moves.csv"))) {
    if (row.move + 1 >= first && row.move <= last) lines.insert(row.line);
  }
  const auto gouges_at = [&](double by) {
    write_text(sample.path + "/lifted.apt", lifted(text_of(sample.path + "/" + sample.toolpath()), lines, by));
    check(sample, "lifted.apt", {"--csv", "lifted.csv"});
    std::size_t count = 0;
    for (const MoveRow& row : parse_moves(text_of(sample.path + "/lifted.csv")))
      count += row.move >= first && row.move <= last && row.state != "clean" ? 1U : 0U;
    return count;
  };
  EXPECT_EQ(gouges_at(lift), 0U);
  EXPECT_GT(gouges_at(lift - 0.012), 0U);
  std::vector<std::string> more{"--strategy", "holder=tilt", "-o", "tilted.apt", "--json", "tilted.json"};
  const Outcome corrected = run_gougecheck(sample.path, sample.arguments("correct", sample.toolpath(), more));
  EXPECT_EQ(corrected.exit_status, 0) << corrected.err;
  const Json written = Json::parse(text_of(sample.path + "/tilted.json")).at("correction");
  EXPECT_NEAR(cures.at("tilt").at("rad").get<double>(),
              written.at("quality").at("largest_tilt").at("rad").get<double>(), 1e-4);
}

// The post is 1.005 mm deep in the head as its formula states, and the tool leans while it follows.
TEST(Cures, OfTheHeadAreFound) {
  const SampleFolder sample = open_sample("between_head");
  const Checked found = check(sample, sample.toolpath(), {"--find-cures"});
  const Json cures = found.event_of("head").at("cures");
  const double depth = sample.expected.at("findings").at(0).at("depth_max");
  EXPECT_GE(cures.at("lift").at("length").get<double>(), depth - 0.011);
  EXPECT_LE(cures.at("lift").at("length").get<double>(), 1.3 * depth);
  EXPECT_EQ(cures.at("lift").at("body"), "head");
  EXPECT_FALSE(cures.at("tilt").at("rad").is_null());
}

TEST(Cures, AreThoseOfCollisionsAloneAndOnlyWhereAsked) {
  const SampleFolder sample = open_sample("freeform");
  const Checked plain = check(sample, sample.toolpath(), {});
  EXPECT_TRUE(plain.report.at("cures").is_null());
  for (const Json& event : plain.report.at("events")) EXPECT_TRUE(event.at("cures").is_null());
  EXPECT_EQ(plain.ran.out.find("cured by"), std::string::npos);
  const Checked asked = check(sample, sample.toolpath(), {"--find-cures"});
  EXPECT_FALSE(asked.report.at("cures").is_null());
  for (const Json& event : asked.report.at("events"))
    EXPECT_EQ(event.at("cures").is_null(), event.at("body") == "cutter");
}

TEST(Cures, AreTheSameAtAnyNumberOfThreadsAndShownToPeople) {
  const SampleFolder sample = open_sample("freeform");
  Json first;
  for (const std::string threads : {"1", "3"}) {
    const Checked found =
        check(sample, sample.toolpath(), {"--find-cures", "--threads", threads, "--report", "r" + threads});
    if (first.is_null()) first = found.report;
    EXPECT_EQ(found.report, first);
    EXPECT_NE(found.ran.out.find("\n  cured by a tilt of up to "), std::string::npos) << found.ran.out;
    EXPECT_NE(found.ran.out.find(" mm along the tool axis\n"), std::string::npos) << found.ran.out;
    const std::string html = text_of(sample.path + "/r" + threads + "/report.html");
    EXPECT_NE(html.find("Cured by"), std::string::npos);
    EXPECT_NE(html.find("a tilt of up to "), std::string::npos);
  }
}

}  // namespace
}  // namespace gouge::testing_samples::cures_test
