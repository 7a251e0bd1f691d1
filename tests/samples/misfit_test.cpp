#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>
#include <vector>

#include "tests/samples/program.h"
#include "tests/samples/sample_folder.h"
#include "tests/support/shapes.h"
#include "tests/support/source_folder.h"
#include "tests/support/stl_text.h"

// A path that plainly does not fit its part: refused by `correct`, reported by `check`, explained where it can
// be.

namespace gouge::testing_samples::misfit_test {
namespace {

/// Every GOTO of a file of commas, with one of its numbers negated where it has an axis.
std::string with_negated(const std::string& text, std::size_t number) {
  std::istringstream lines(text);
  std::string result;
  for (std::string line; std::getline(lines, line); result += line + "\n") {
    if (line.compare(0, 5, "GOTO/") != 0) continue;
    std::vector<std::string> numbers;
    std::istringstream list(line.substr(5));
    for (std::string one; std::getline(list, one, ',');) numbers.push_back(one);
    if (numbers.size() != 6) continue;
    std::string& negated = numbers[number];
    const std::size_t at = negated.find_first_not_of(' ');
    negated = negated[at] == '-' ? negated.substr(at + 1) : "-" + negated.substr(at);
    line = "GOTO/";
    for (std::size_t i = 0; i < 6; ++i) line += (i == 0 ? "" : ", ") + numbers[i];
  }
  return result;
}

bool says(const std::string& text, const std::string& what) { return text.find(what) != std::string::npos; }

TEST(Misfit, AWrongSignOfTheAxisIsRefusedExplainedAndForced) {
  const SampleFolder sample = open_sample("freeform");
  write_text(sample.path + "/wrong.apt", with_negated(text_of(sample.path + "/" + sample.toolpath()), 5));
  const Outcome checked = run_gougecheck(sample.path, sample.arguments("check", "wrong.apt"));
  EXPECT_EQ(checked.exit_status, 1) << "the verdict stands by itself";
  EXPECT_TRUE(says(checked.err, "warning: the path does not fit the part")) << checked.err;
  EXPECT_TRUE(says(checked.err, "with K negated 100 % of the positions touch the part")) << checked.err;

  const Outcome refused = run_gougecheck(
      sample.path,
      sample.arguments("correct", "wrong.apt", {"-o", "out.apt", "--report", "rep", "--json", "out.json"}));
  EXPECT_EQ(refused.exit_status, 1);
  EXPECT_TRUE(says(refused.err, "error: the path does not fit the part")) << refused.err;
  EXPECT_TRUE(says(refused.err, "check units, placement, axis sign: with K")) << refused.err;
  EXPECT_TRUE(says(refused.err, "--force")) << refused.err;
  for (const char* file : {"out.apt", "rep", "out.json"})
    EXPECT_FALSE(std::filesystem::exists(sample.path + "/" + file)) << file;
}

TEST(Misfit, WhatGougesHereAndThereIsCorrectedWithoutAWord) {
  const SampleFolder sample = open_sample("freeform");
  const Outcome ran = run_gougecheck(sample.path, sample.arguments("correct", sample.toolpath(), {"-o", "out.apt"}));
  EXPECT_FALSE(says(ran.err, "path-misfit")) << ran.err;
  EXPECT_TRUE(std::filesystem::exists(sample.path + "/out.apt"));
}

TEST(Misfit, APartInAnotherUnitIsRefusedAndForced) {
  const std::string folder = fresh_folder();
  write_text(folder + "/part.stl", shapes::ascii_stl(shapes::cube(0.8)));
  write_text(folder + "/op.apt",
             "PARTNO/A\nUNITS/MM\nCUTTER/1,0,0.5,0,0,0,20\nGOTO/-10,0.4,5\nGOTO/-10,0.4,0.5\nGOTO/10,0.4,0.5\n"
             "GOTO/10,0.4,5\nFINI\n");
  const std::vector<std::string> correct = {"correct", "op.apt", "--part", "part.stl", "-o", "out.apt"};
  const Outcome refused = run_gougecheck(folder, correct);
  EXPECT_EQ(refused.exit_status, 1) << refused.err;
  EXPECT_TRUE(says(refused.err, "smaller than the path")) << refused.err;
  EXPECT_TRUE(says(refused.err, "--force corrects all the same [path-misfit]")) << refused.err;
  EXPECT_FALSE(std::filesystem::exists(folder + "/out.apt"));
  std::vector<std::string> forced = correct;
  forced.emplace_back("--force");
  EXPECT_FALSE(says(run_gougecheck(folder, forced).err, "path-misfit"));
  EXPECT_TRUE(std::filesystem::exists(folder + "/out.apt"));
}

TEST(Misfit, APartAwayFromThePathIsRefusedAlsoWithoutAGouge) {
  const SampleFolder sample = open_sample("freeform");
  const std::vector<std::string> correct =
      sample.arguments("correct", sample.toolpath(), {"-o", "out.apt", "--place", "0,0,-30"});
  const Outcome refused = run_gougecheck(sample.path, correct);
  EXPECT_EQ(refused.exit_status, 1) << refused.out;
  EXPECT_TRUE(says(refused.err, "[path-misfit]")) << refused.err;
  EXPECT_FALSE(std::filesystem::exists(sample.path + "/out.apt"));
  std::vector<std::string> assumed = correct;
  assumed.insert(assumed.end(), {"--assume", "placement"});
  EXPECT_EQ(run_gougecheck(sample.path, assumed).exit_status, 0);
}

TEST(Misfit, ARealFiveAxisPathWithOneSignWrong) {
  const std::string data = source_folder() + "/../shared/data/";
  if (!std::filesystem::exists(data)) GTEST_SKIP() << "no real toolpaths beside the checkout (" << data << ")";
  const std::string folder = fresh_folder();
  const std::string path = text_of(data + "toolpaths/five_axis_part/subset_camplete.apt");
  const std::string part = data + "parts/matched/five_axis_part_inch.stl";
  const std::vector<std::string> expected = {"with I negated", "with J negated", "with K of the tilted axes negated"};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    write_text(folder + "/wrong.apt", with_negated(path, 3 + i));
    const Outcome refused = run_gougecheck(folder, {"correct", "wrong.apt", "--part", part, "-o", "out.apt"});
    EXPECT_EQ(refused.exit_status, 1) << expected[i];
    EXPECT_TRUE(says(refused.err, expected[i] + " 9")) << refused.err;
    EXPECT_FALSE(std::filesystem::exists(folder + "/out.apt"));
  }
  write_text(folder + "/right.apt", path);
  const Outcome right = run_gougecheck(folder, {"check", "right.apt", "--part", part});
  EXPECT_FALSE(says(right.err, "path-misfit")) << right.err;
  const Outcome forced = run_gougecheck(folder, {"correct", "wrong.apt", "--part", part, "-o", "out.apt", "--force"});
  EXPECT_TRUE(says(forced.err, "warning: the path does not fit the part")) << forced.err;
  EXPECT_TRUE(std::filesystem::exists(folder + "/out.apt"));
}

TEST(Misfit, NoRealPairIsReportedNotToFit) {
  const std::string data = source_folder() + "/../shared/data/";
  if (!std::filesystem::exists(data)) GTEST_SKIP() << "no real toolpaths beside the checkout (" << data << ")";
  for (const char* name : {"basemach", "Sacrifice-Board", "SupPetriLED", "Teste-Metrologia", "Paralelipipedo2"}) {
    const Outcome ran = run_gougecheck(fresh_folder(), {"check", data + "toolpaths/solidworks_cam/" + name + ".apt",
                                                        "--part", data + "parts/matched/" + name + ".STL"});
    EXPECT_FALSE(says(ran.err, "path-misfit")) << name << ": " << ran.err;
  }
}

}  // namespace
}  // namespace gouge::testing_samples::misfit_test
