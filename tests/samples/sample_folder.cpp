#include "tests/samples/sample_folder.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/samples/program.h"

namespace gouge::testing_samples {

const std::vector<std::string>& sample_names() {
  static const std::vector<std::string> kNames = {
      "freeform",      "pocket",        "blade",          "between_rib",
      "between_swing", "pole_crossing", "rapid_joints",   "rapid_independent",
      "axis_limit",    "axis_flip",     "smoothing_tube", "between_head",
      "thin_post",     "buried",        "inch",           "needles",
      "big_triangles", "arcs_nx",       "arcs_creo",      "arcs_catia",
      "sunk_jaw",      "rapid_stock",   "holder_stock",   "excess_corner"};
  return kNames;
}

std::string fresh_folder() {
  const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
  std::string name = std::string(info->test_suite_name()) + "." + info->name();
  for (char& c : name) {
    if (c == '/') c = '.';
  }
  const std::filesystem::path folder = std::filesystem::path(GOUGE_TEST_FOLDER) / name;
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder.string();
}

std::vector<std::string> SampleFolder::arguments(const std::string& command, const std::string& toolpath,
                                                 const std::vector<std::string>& more) const {
  std::vector<std::string> all = {command, toolpath, "--tools", expected.at("tools").get<std::string>()};
  for (const auto& part : expected.at("parts")) all.insert(all.end(), {"--part", part.get<std::string>()});
  for (const auto& fixture : expected.at("fixtures")) all.insert(all.end(), {"--fixture", fixture.get<std::string>()});
  for (const auto& head : expected.at("heads")) all.insert(all.end(), {"--head", head.get<std::string>()});
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

SampleFolder open_sample(const std::string& name) {
  const std::string folder = fresh_folder();
  EXPECT_EQ(run_make_samples(folder).exit_status, 0);
  SampleFolder sample;
  sample.path = folder + "/" + name;
  sample.expected = nlohmann::json::parse(text_of(sample.path + "/expected.json"), nullptr, false);
  EXPECT_FALSE(sample.expected.is_discarded()) << sample.path;
  return sample;
}

}  // namespace gouge::testing_samples
