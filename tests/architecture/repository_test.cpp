#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "tests/architecture/source_rules.h"
#include "tests/architecture/wording_rules.h"
#include "tests/support/source_folder.h"

// The rules of the house on the house itself.

namespace gouge::architecture::repository_test {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

const std::vector<SourceFile>& repository() {
  static const std::vector<SourceFile> kFiles = [] {
    const fs::path root = source_folder();
    std::vector<SourceFile> files;
    const auto add = [&](const fs::path& path) {
      files.push_back({path.lexically_relative(root).generic_string(), text_of(path)});
    };
    for (const char* folder : {"cli", "lib", "toolmodels", "postproc", "tests", "samples", "docs", ".ci"}) {
      for (auto it = fs::recursive_directory_iterator(root / folder); it != fs::end(it); ++it) {
        const std::string path = it->path().lexically_relative(root).generic_string();
        if (path == "samples/out" || path == "tests/corpus") it.disable_recursion_pending();
        const std::string extension = it->path().extension().string();
        const bool is_text = extension == ".h" || extension == ".cpp" || extension == ".txt" || extension == ".md" ||
                             extension == ".sh" || extension == ".cmake" || extension == ".json" || extension.empty();
        if (it->is_regular_file() && is_text) add(it->path());
      }
    }
    for (const char* file :
         {"README.md", "SECURITY.md", "CMakeLists.txt", "CMakePresets.json", ".clang-format", ".clang-tidy"}) {
      if (fs::exists(root / file)) add(root / file);
    }
    std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) { return a.path < b.path; });
    return files;
  }();
  return kFiles;
}

std::vector<Module> modules() {
  std::vector<Module> all;
  for (const SourceFile& file : repository()) {
    if (file.path.rfind("tests/", 0) == 0 || file.path == "CMakeLists.txt") continue;
    if (fs::path(file.path).filename() != "CMakeLists.txt") continue;
    for (Module& room : modules_of(file.text)) all.push_back(std::move(room));
  }
  return all;
}

std::string listed(const Complaints& complaints) {
  std::string out;
  for (const std::string& complaint : complaints) out += complaint + "\n";
  return out;
}

TEST(Repository, HasSourcesAndModules) {
  EXPECT_GT(repository().size(), 100U);
  EXPECT_GT(modules().size(), 10U);
}

TEST(Repository, EverySourceBelowCliLiesInAModule) {
  const std::vector<Module> all = modules();
  for (const SourceFile& file : repository()) {
    const std::string folder = fs::path(file.path).parent_path().generic_string();
    const std::string top = file.path.substr(0, file.path.find('/'));
    const std::string extension = fs::path(file.path).extension().string();
    if ((top != "lib" && top != "toolmodels" && top != "postproc") || (extension != ".h" && extension != ".cpp"))
      continue;
    EXPECT_TRUE(std::any_of(all.begin(), all.end(), [&](const Module& room) { return room.path == folder; }))
        << file.path;
  }
}

TEST(Repository, HasOneVersion) {
  const fs::path root = source_folder();
  std::smatch found;
  const std::string build = text_of(root / "CMakeLists.txt");
  ASSERT_TRUE(std::regex_search(build, found, std::regex(R"(project\(gougecheck VERSION (\d+\.\d+)\.(\d+))")));
  const std::string minor = found[1], version = minor + "." + std::string(found[2]);
  const std::map<std::string, std::string> stated = {
      {"cli/library/gougecheck/version.h", "GOUGECHECK_VERSION_STRING \"" + version + "\""},
      {"cli/library/exports.map", "GOUGECHECK_" + minor + " {"},
      {"cli/python/pyproject.toml", "version = \"" + version + "\""},
      {"postproc/report/report_model.h", "kProgramVersion = \"" + version + "\""},
      {"docs/CHANGELOG.md", "\n## " + version},
      {"docs/guide/install.md", "libgougecheck" + minor},
      {"docs/guide/library.md", "libgougecheck.so." + minor}};
  for (const auto& [file, words] : stated)
    EXPECT_NE(text_of(root / file).find(words), std::string::npos) << file << ": expected " << words;
}

TEST(Repository, ModulesImportOneWay) { EXPECT_EQ(listed(check_modules(modules())), ""); }
TEST(Repository, IncludesKeepToTheImports) { EXPECT_EQ(listed(check_includes(repository(), modules())), ""); }
TEST(Repository, PartsOfAVerdictAreClosedToAllWhoCouldForgetTheOthers) {
  std::size_t closed = 0;
  for (const Module& room : modules()) closed += room.closed.size();
  EXPECT_GE(closed, 5U);
  EXPECT_EQ(listed(check_closed_headers(repository(), modules())), "");
}
TEST(Repository, CgalAndOpenCvStayInTheirSources) { EXPECT_EQ(listed(check_heavy_libraries(repository())), ""); }
TEST(Repository, TheVerifierSharesNothingWithTheCheckButReadersAndVectors) {
  const std::set<std::string> shared_rooms{"lib/base", "lib/geom", "lib/mesh", "lib/path", "lib/tool", "lib/verify"};
  const std::set<std::string> plain_data{"lib/tool/compiled_tool.h", "lib/tool/tool_variants.h"};
  std::size_t sources = 0;
  for (const SourceFile& file : repository()) {
    if (file.path.rfind("lib/verify/", 0) != 0) continue;
    ++sources;
    for (const Include& include : includes_of(file.text)) {
      if (!include.is_quoted) continue;
      const std::string room = include.target.substr(0, include.target.rfind('/'));
      EXPECT_EQ(shared_rooms.count(room), 1U) << file.path << " includes " << include.target;
      EXPECT_TRUE(room != "lib/tool" || plain_data.count(include.target) == 1)
          << file.path << " includes " << include.target;
    }
  }
  EXPECT_GT(sources, 10U);
}
TEST(Repository, NothingBelowCliPrintsEndsOrThrows) { EXPECT_EQ(listed(check_banned_words(repository())), ""); }
TEST(Repository, MotionsAndObstaclesHaveOnePlace) { EXPECT_EQ(listed(check_seams(repository())), ""); }
TEST(Repository, FormatsAreNamedInTheirTableAlone) { EXPECT_EQ(listed(check_formats(repository())), ""); }
TEST(Repository, TolerancesHaveNames) { EXPECT_EQ(listed(check_tolerances(repository())), ""); }
TEST(Repository, RandomNumbersAreTheSameEverywhere) { EXPECT_EQ(listed(check_random_numbers(repository())), ""); }
TEST(Repository, TestsShareNoTemporaryFolders) { EXPECT_EQ(listed(check_temporary_folders(repository())), ""); }
TEST(Repository, ReadersNoteTheirSearchesForFiles) { EXPECT_EQ(listed(check_file_searches(repository())), ""); }
TEST(Repository, FilesAreShortAndHeadersGuarded) { EXPECT_EQ(listed(check_shape(repository())), ""); }
TEST(Repository, HasNoNotesToSelfAndNoMachinePaths) { EXPECT_EQ(listed(check_stray_text(repository())), ""); }

TEST(Repository, IsWrittenInPlainWords) { EXPECT_EQ(listed(check_wording(repository())), ""); }

TEST(Repository, NoTwoTypesHaveOneName) { EXPECT_EQ(listed(check_type_names(repository())), ""); }

TEST(Repository, EveryMessageCodeIsDocumentedAndNoOther) {
  std::set<std::string> used, documented;
  for (const SourceFile& file : repository()) {
    const bool is_source = fs::path(file.path).extension() == ".cpp" && file.path.rfind("tests/", 0) != 0;
    if (is_source) used.merge(message_codes_of(file.text));
    if (file.path == "docs/errors.md") documented = documented_codes_of(file.text);
  }
  EXPECT_GT(used.size(), 30U);
  for (const std::string& code : used) EXPECT_EQ(documented.count(code), 1U) << code << " is not in docs/errors.md";
  for (const std::string& code : documented) EXPECT_EQ(used.count(code), 1U) << code << " is in no source";
}

TEST(Repository, EveryLinkOfTheDocumentsLeadsToAFile) {
  const fs::path root = source_folder();
  std::size_t links = 0;
  for (const SourceFile& file : repository()) {
    if (fs::path(file.path).extension() != ".md") continue;
    for (const std::string& link : file_links_of(file.text)) {
      ++links;
      EXPECT_TRUE(fs::exists((root / file.path).parent_path() / link)) << file.path << " links to " << link;
    }
  }
  EXPECT_GT(links, 30U);
}

/// Rows of a table whose first column names sections: the last column may be empty, the others may not.
std::map<std::string, std::vector<std::string>> rows_by_section(const std::string& text) {
  std::map<std::string, std::vector<std::string>> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line[0] != '|') continue;
    std::vector<std::string> cells;
    std::istringstream row(line.substr(1));
    for (std::string cell; std::getline(row, cell, '|');) cells.push_back(cell);
    std::istringstream sections(cells.empty() ? "" : cells[0]);
    for (std::string section; std::getline(sections, section, ',');) {
      const std::size_t first = section.find_first_not_of(' '), last = section.find_last_not_of(' ');
      if (first != std::string::npos) rows[section.substr(first, last - first + 1)] = cells;
    }
  }
  return rows;
}

TEST(Repository, TheThesisMapNamesFilesAndTestsForEverySectionOfTheCoresChapters) {
  const auto rows = rows_by_section(text_of(fs::path(source_folder()) / "docs" / "thesis_map.md"));
  for (const char* section :
       {"2.4.18",  "2.4.18.1", "2.4.18.2", "2.4.18.3", "2.4.18.4", "2.4.18.5", "4.1",        "4.1.1",     "4.1.2",
        "4.2",     "4.3",      "4.4",      "4.4.1",    "4.4.2",    "4.5",      "4.5.1",      "4.5.2",     "4.5.2.1",
        "4.5.2.2", "4.5.2.3",  "4.6",      "4.6.1",    "4.6.2",    "4.7",      "4.8",        "5.1",       "5.2",
        "5.2.1",   "5.2.2",    "5.2.3",    "5.3",      "5.4",      "6.1",      "6.1.1",      "6.1.2",     "6.1.3",
        "6.1.4",   "6.1.4.1",  "6.1.4.2",  "6.1.4.3",  "6.2",      "6.3",      "appendix B", "appendix C"}) {
    const auto row = rows.find(section);
    ASSERT_NE(row, rows.end()) << section << " has no row";
    ASSERT_GE(row->second.size(), 5U) << section;
    for (std::size_t k = 1; k < 4; ++k) {
      EXPECT_NE(row->second[k].find_first_not_of(' '), std::string::npos) << section << ", column " << k + 1;
    }
  }
}

TEST(Repository, EveryPathTheDocumentsNameIsThere) {
  const fs::path root = source_folder();
  std::size_t named = 0;
  for (const SourceFile& file : repository()) {
    if (fs::path(file.path).extension() != ".md") continue;
    for (const std::string& path : quoted_paths_of(file.text)) {
      ++named;
      const bool is_there = fs::exists(root / path) || fs::exists(root / (path + ".h")) ||
                            fs::exists(root / (path + ".cpp")) || path == "tests/corpus";
      EXPECT_TRUE(is_there) << file.path << " names " << path;
    }
  }
  EXPECT_GT(named, 30U);
}

TEST(Repository, EveryPageThatAFileNamesIsThere) {
  static const std::regex page(R"(\bdocs/[a-z_/0-9]+\.md\b)");
  const fs::path root = source_folder();
  std::size_t named = 0;
  for (const SourceFile& file : repository()) {
    if (file.path == "tests/architecture/rules_test.cpp") continue;  // names pages of made-up repositories
    for (std::sregex_iterator at(file.text.begin(), file.text.end(), page), end; at != end; ++at) {
      ++named;
      EXPECT_TRUE(fs::exists(root / at->str())) << file.path << " names " << at->str();
    }
  }
  EXPECT_GT(named, 100U);
}

}  // namespace
}  // namespace gouge::architecture::repository_test
