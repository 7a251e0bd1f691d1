#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <sstream>

#include "tests/samples/csv.h"
#include "tests/samples/program.h"
#include "tests/samples/sample_folder.h"
#include "tests/samples/small_shop.h"

// Corrected samples re-check clean, and what did not gouge stays byte for byte.

namespace gouge::testing_samples::corrections_test {
namespace {

class Corrections : public ::testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(Samples, Corrections, ::testing::ValuesIn(sample_names()),
                         [](const auto& test) { return test.param; });

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

bool begins_with(const std::string& line, const std::string& start) {
  return line.compare(0, start.size(), start) == 0;
}

/// Lines that a correction may change: the positions at both ends of moves with a finding, and what states that
/// such a move is an arc.
std::set<std::size_t> changeable_lines(const SampleFolder& sample, const std::vector<std::string>& lines) {
  std::set<std::size_t> changeable;
  for (const auto& finding : sample.expected.at("findings")) {
    std::size_t line = finding.at("line");
    changeable.insert(line);
    for (std::size_t before = line - 1; before > 0; --before) {
      const std::string& text = lines[before - 1];
      const bool is_position = begins_with(text, "GOTO");
      const bool is_of_arc = begins_with(text, "CIRCLE") || begins_with(text, "INDIRV") ||
                             begins_with(text, "AUTOPS") || (before > 1 && begins_with(lines[before - 2], "CIRCLE"));
      if (is_position || is_of_arc) changeable.insert(before);
      if (is_position) break;
    }
    while (lines[line - 1].back() == '$') changeable.insert(++line);
  }
  return changeable;
}

/// The first of the lines that may not change and is missing from the corrected file, or 0.
std::size_t first_lost_line(const std::vector<std::string>& before, const std::vector<std::string>& after,
                            const std::set<std::size_t>& changeable) {
  std::size_t at = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (changeable.count(i + 1) != 0) continue;
    while (at < after.size() && after[at] != before[i]) ++at;
    if (at == after.size()) return i + 1;
    ++at;
  }
  return 0;
}

TEST_P(Corrections, ReCheckCleanAndLeaveEveryOtherLineByteForByte) {
  const SampleFolder sample = open_sample(GetParam());
  const std::string corrected = "corrected_" + sample.toolpath();
  const Outcome ran = run_gougecheck(sample.path, sample.arguments("correct", sample.toolpath(), {"-o", corrected}));
  const int expected = sample.expected.at("correct_exit");
  ASSERT_EQ(ran.exit_status, expected) << ran.out << ran.err;

  const std::string before = text_of(sample.path + "/" + sample.toolpath());
  const std::string after = text_of(sample.path + "/" + corrected);
  const std::vector<std::string> old_lines = lines_of(before), new_lines = lines_of(after);
  const std::set<std::size_t> changeable = changeable_lines(sample, old_lines);
  const std::size_t lost = first_lost_line(old_lines, new_lines, changeable);
  EXPECT_EQ(lost, 0U) << "this line is gone: " << old_lines[lost == 0 ? 0 : lost - 1];
  EXPECT_EQ(before == after, changeable.empty() || expected != 0);

  if (expected != 0) return;
  const Outcome again = run_gougecheck(sample.path, sample.arguments("check", corrected));
  EXPECT_EQ(again.exit_status, 0) << again.out << again.err;
}

TEST_P(Corrections, AreTheSameBytesAtOneAndTwoThreads) {
  const SampleFolder sample = open_sample(GetParam());
  for (const std::string threads : {"1", "2"}) {
    const std::string folder = sample.path + "/" + threads;
    std::filesystem::create_directory(folder);
    const Outcome ran = run_gougecheck(sample.path, sample.arguments("correct", sample.toolpath(),
                                                                     {"-o", threads + "/corrected", "--csv",
                                                                      threads + "/all.csv", "--threads", threads}));
    EXPECT_EQ(ran.exit_status, sample.expected.at("correct_exit").get<int>()) << ran.err;
  }
  EXPECT_FALSE(text_of(sample.path + "/1/corrected").empty());
  EXPECT_EQ(text_of(sample.path + "/1/corrected"), text_of(sample.path + "/2/corrected"));
  EXPECT_EQ(text_of(sample.path + "/1/all.csv"), text_of(sample.path + "/2/all.csv"));
}

// Tools over a plate whose top is two triangles: the path runs beside their common diagonal and across it.
constexpr const char* kTools[] = {"CUTTER/10,0", "CUTTER/10,5", "CUTTER/10,2"};

std::string of_tool(const std::string& cutter) { return "PARTNO/SHOP\nUNITS/MM\n" + cutter + "\nLOADTL/1\n"; }

TEST(CorrectionsOfAPlate, ShiftsAreExactlyAlongItsNormal) {
  for (const char* const cutter : kTools) {
    const SmallShop shop;
    shop.write("path.apt", path_text(stations({{30, -0.1}, {40, -0.25}, {50, -0.25}, {60, -0.05}}), of_tool(cutter)));
    const Outcome ran = shop.run({"correct", "path.apt", "--part", "part.stl", "-o", "fixed.apt", "--json", "f.json"});
    ASSERT_TRUE(shop.json("f.json").contains("correction")) << ran.err;
    const nlohmann::json changes = shop.json("f.json").at("correction").at("changes");
    EXPECT_GE(changes.size(), 4U) << cutter;
    for (const auto& change : changes) {
      const auto& shift = change.at("shift");
      EXPECT_NEAR(shift.at(0).get<double>(), 0, 1e-6) << cutter;
      EXPECT_NEAR(shift.at(1).get<double>(), 0, 1e-6) << cutter;
    }
    EXPECT_NE(ran.out.find("0 left as they were"), std::string::npos) << ran.out;
  }
}

/// The path of path_text without the feed beyond the plate; the tool leaves the last station upwards.
std::string path_that_ends_on_the_plate(double depth, const std::string& cutter) {
  const std::string text = path_text(stations({{90, depth}}), of_tool(cutter));
  return text.substr(0, text.find("GOTO/120")) + "RAPID\nGOTO/90,50,30\nFINI\n";
}

TEST(CorrectionsOfAPlate, ARampIntoItGetsAnotherEndAndNothingElse) {
  for (const char* const cutter : kTools) {
    for (const double depth : {-0.02, -0.05, -0.25}) {
      const SmallShop shop;
      const std::string path = path_that_ends_on_the_plate(depth, cutter);
      shop.write("path.apt", path);
      const Outcome ran = shop.run({"correct", "path.apt", "--part", "part.stl", "-o", "fixed.apt"});
      const std::vector<std::string> before = lines_of(path), after = lines_of(shop.read("fixed.apt"));
      ASSERT_EQ(before.size(), after.size()) << ran.out << ran.err << shop.read("fixed.apt");
      for (std::size_t i = 0; i < before.size(); ++i) {
        if (begins_with(before[i], "GOTO/90.")) {
          EXPECT_EQ(after[i], "GOTO/90.000000,50,-0.003") << cutter;
        } else {
          EXPECT_EQ(after[i], before[i]) << cutter;
        }
      }
    }
  }
}

}  // namespace
}  // namespace gouge::testing_samples::corrections_test
