#include "tests/samples/batch_folder.h"

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "tests/samples/program.h"
#include "tests/samples/sample_folder.h"

namespace gouge::testing_samples {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr const char* kMayDiffer[] = {"seconds", "memory_mb", "host", "rank"};

// The last four columns; a host has no comma.
std::string without_columns(const std::string& csv) {
  std::istringstream lines(csv);
  std::string out;
  for (std::string line; std::getline(lines, line);) {
    for (std::size_t k = 0; k < std::size(kMayDiffer); ++k) line.erase(line.rfind(','));
    out += line + "\n";
  }
  return out;
}

std::string without_keys(const std::string& text) {
  Json summary = Json::parse(text);
  for (Json& job : summary.at("jobs")) {
    for (const char* key : kMayDiffer) job.erase(key);
  }
  return summary.dump(1);
}

int take_row(void* rows, int columns, char** values, char** names) {
  std::string row;
  for (int k = 0; k < columns; ++k) {
    const std::string name = names[k];
    if (std::find(std::begin(kMayDiffer), std::end(kMayDiffer), name) != std::end(kMayDiffer)) continue;
    row += name + "=" + (values[k] == nullptr ? "NULL" : values[k]) + "|";
  }
  static_cast<std::vector<std::string>*>(rows)->push_back(row);
  return 0;
}

std::string rows_of(const std::string& file) {
  sqlite3* store = nullptr;
  std::string all;
  if (sqlite3_open_v2(file.c_str(), &store, SQLITE_OPEN_READONLY, nullptr) == SQLITE_OK) {
    for (const char* table : {"runs", "names", "jobs", "counts", "findings", "cases", "warnings", "inputs", "searches",
                              "found", "outputs"}) {
      std::vector<std::string> rows;
      char* error = nullptr;
      if (sqlite3_exec(store, (std::string("SELECT * FROM ") + table).c_str(), take_row, &rows, &error) != SQLITE_OK)
        all += std::string("error: ") + (error == nullptr ? "" : error);
      sqlite3_free(error);
      std::sort(rows.begin(), rows.end());
      for (const std::string& row : rows) all += std::string(table) + ": " + row + "\n";
    }
  } else {
    all = "cannot be opened";
  }
  sqlite3_close(store);
  return all;
}

}  // namespace

void write_job_list(const std::string& folder, const std::vector<std::string>& samples) {
  Json list = {{"jobs", Json::array()}};
  for (const std::string& sample : samples) {
    const Json known = Json::parse(text_of(folder + "/" + sample + "/expected.json"));
    const auto below = [&](const std::string& file) { return sample + "/" + file; };
    Json job = {{"name", sample}, {"path", below(known.at("toolpath"))}, {"tools", below(known.at("tools"))}};
    for (const auto& [key, files] : {std::pair("part", "parts"), {"fixture", "fixtures"}, {"head", "heads"}}) {
      for (const Json& file : known.at(files)) job[key].push_back(below(file));
    }
    job["report"] = list["jobs"].size() % 4 == 0;
    list["jobs"].push_back(job);
    job["name"] = sample + " corrected";
    job["command"] = "correct";
    list["jobs"].push_back(job);
  }
  write_text(folder + "/jobs.json", list.dump(1));
}

std::string samples_with_list(const std::vector<std::string>& samples) {
  const std::string folder = fresh_folder();
  EXPECT_EQ(run_make_samples(folder).exit_status, 0);
  write_job_list(folder, samples);
  return folder;
}

Outcome run_batch(const std::string& folder, std::vector<std::string> words) {
  words.insert(words.begin(), "batch");
  return run_gougecheck(folder, words);
}

Json summary_of(const std::string& folder) { return Json::parse(text_of(folder + "/summary.json")); }

std::map<std::string, std::string> batch_files(const std::string& folder) {
  static const std::regex kTime("time=\"[0-9.]+\"");
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    const std::string name = fs::relative(entry.path(), folder).string();
    std::string bytes = text_of(entry.path().string());
    if (name == "manifest.json") continue;
    if (name == "summary.csv") bytes = without_columns(bytes);
    if (name == "summary.json") bytes = without_keys(bytes);
    if (name == "junit.xml") bytes = std::regex_replace(bytes, kTime, "time=\"\"");
    if (name == "results.sqlite") bytes = rows_of(entry.path().string());
    files[name] = std::move(bytes);
  }
  return files;
}

void change_store(const std::string& file, const std::string& sql) {
  sqlite3* store = nullptr;
  EXPECT_EQ(sqlite3_open_v2(file.c_str(), &store, SQLITE_OPEN_READWRITE, nullptr), SQLITE_OK);
  EXPECT_EQ(sqlite3_exec(store, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK);
  sqlite3_close(store);
}

long number_in_store(const std::string& file, const std::string& sql) {
  sqlite3* store = nullptr;
  long number = -1;
  EXPECT_EQ(sqlite3_open_v2(file.c_str(), &store, SQLITE_OPEN_READWRITE, nullptr), SQLITE_OK);
  const auto take = [](void* to, int, char** values, char**) {
    *static_cast<long*>(to) = values[0] == nullptr ? -1 : std::stol(values[0]);
    return 0;
  };
  EXPECT_EQ(sqlite3_exec(store, sql.c_str(), take, &number, nullptr), SQLITE_OK);
  sqlite3_close(store);
  return number;
}

std::string difference(const std::map<std::string, std::string>& a, const std::map<std::string, std::string>& b) {
  std::string names;
  for (const auto& [name, bytes] : a) {
    const auto other = b.find(name);
    if (other == b.end()) names += " -" + name;
    if (other != b.end() && other->second != bytes) names += " !" + name;
  }
  for (const auto& [name, bytes] : b) {
    if (!a.contains(name)) names += " +" + name;
  }
  return names;
}

}  // namespace gouge::testing_samples
