#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "tests/support/source_folder.h"

namespace gouge {

inline std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// The files below `folder`, sorted; empty where there is none.
inline std::vector<std::filesystem::path> files_below(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  if (!std::filesystem::exists(folder)) return files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

inline std::filesystem::path corpus() { return std::filesystem::path(source_folder()) / "tests/corpus/cl"; }

inline std::filesystem::path real_toolpaths() {
  return std::filesystem::path(source_folder()) / "../shared/data/toolpaths";
}

/// Our own sample of every dialect, and the real files where they are.
inline std::vector<std::filesystem::path> all_cl_files() {
  std::vector<std::filesystem::path> files = files_below(corpus());
  for (const auto& file : files_below(real_toolpaths())) files.push_back(file);
  return files;
}

}  // namespace gouge
