#include "cli/project_file.h"
#include "cli/file_schemas.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "tests/support/source_folder.h"

namespace gouge::project_file_test {
namespace {

std::string document(const std::string& name) {
  std::ifstream stream(source_folder() + "/docs/formats/" + name);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

TEST(ProjectFile, TheSchemaHasEveryKeyAndNoOther) {
  const nlohmann::json schema = nlohmann::json::parse(document("project.schema.json"));
  std::set<std::string> listed;
  for (const auto& [key, value] : schema["properties"].items()) listed.insert(key);
  const std::vector<std::string> keys = project_keys();
  EXPECT_EQ(listed, std::set<std::string>(keys.begin(), keys.end()));
  EXPECT_EQ(schema["additionalProperties"], false);
}

TEST(FileSchemas, ThoseOfTheDocsAreTheGeneratedOnes) {
  EXPECT_EQ(document("project.schema.json"), project_schema())
      << "write it anew: gougecheck schema project > docs/formats/project.schema.json";
  EXPECT_EQ(document("jobs.schema.json"), jobs_schema())
      << "write it anew: gougecheck schema jobs > docs/formats/jobs.schema.json";
}

TEST(FileSchemas, JobListsHaveTheOptionsOfTheirCommandsAndNoOther) {
  const nlohmann::json options = nlohmann::json::parse(jobs_schema()).at("$defs").at("options").at("properties");
  for (const char* key : {"path", "report", "part", "certificate", "json", "baseline", "output", "allow-stock"})
    EXPECT_TRUE(options.contains(key)) << key;
  for (const char* key : {"help", "threads", "quiet", "progress", "name", "tolerence"})
    EXPECT_FALSE(options.contains(key)) << key;
}

TEST(ProjectFile, ThePageNamesEveryKey) {
  const std::string page = document("project_file.md");
  for (const std::string& key : project_keys()) EXPECT_NE(page.find("`" + key + "`"), std::string::npos) << key;
}

TEST(ProjectFile, TheExampleOfThePageIsRead) {
  const std::string page = document("project_file.md");
  const std::size_t begin = page.find("```json\n") + 8;
  const Result<ProjectFile> project =
      read_project_file("gougecheck.json", "../", page.substr(begin, page.find("```", begin) - begin));
  ASSERT_TRUE(project.has_value()) << to_text(project.error());
  ASSERT_NE(project->option("part"), nullptr);
  EXPECT_EQ(project->option("part")->words, std::vector<std::string>{"--part=../part.stl"}) << "beside the file";
  EXPECT_EQ(project->option("clearance")->value(), "holder=1,shank=0.5");
  EXPECT_EQ(project->option("part")->line, 2U);
}

TEST(ProjectFile, NoKeyNamesAnOutputOrOverwrites) {
  const std::vector<std::string> keys = project_keys();
  for (const char* key : {"report", "json", "csv", "sarif", "junit", "output", "force", "baseline", "export", "threads",
                          "quiet", "verbose", "progress", "color", "sort", "no-config", "help"})
    EXPECT_EQ(std::ranges::count(keys, key), 0) << key;
  EXPECT_GE(keys.size(), 30U);
}

TEST(ProjectFile, NamesNoStandardInput) {
  const Result<ProjectFile> project = read_project_file("g.json", "", R"({"part": "-"})");
  ASSERT_FALSE(project.has_value());
  EXPECT_EQ(project.error().message, "\"part\" is -; expected a file: a project file cannot name standard input");
}

TEST(ProjectFile, ListsTheHarmlessWords) {
  const Result<ProjectFile> project = read_project_file("g.json", "", R"({"harmless_words": ["WHEEL", "切削"]})");
  ASSERT_TRUE(project.has_value());
  EXPECT_EQ(project->options[0].words, (std::vector<std::string>{"--harmless-word=WHEEL", "--harmless-word=切削"}));
}

TEST(ProjectFile, AbsolutePathsStay) {
  const Result<ProjectFile> project = read_project_file("g.json", "../", R"({"fixture": ["/a.stl", "b.stl"]})");
  ASSERT_TRUE(project.has_value());
  EXPECT_EQ(project->options[0].words, (std::vector<std::string>{"--fixture=/a.stl", "--fixture=../b.stl"}));
}

}  // namespace
}  // namespace gouge::project_file_test
