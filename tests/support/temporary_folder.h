#pragma once

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace gouge::testing_support {

/// A new folder that belongs to one test and goes with it. Tests run beside each other, so no two may share a name.
class TemporaryFolder {
 public:
  TemporaryFolder() : path_(::testing::TempDir() + "gouge_test_XXXXXX") {
    if (::mkdtemp(path_.data()) == nullptr) std::abort();
    ::chmod(path_.c_str(), 0755);  // as folders usually are: other users may read it
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  /// The full path, without a slash at its end.
  [[nodiscard]] const std::string& path() const { return path_; }
  /// The full path of a file in it.
  [[nodiscard]] std::string at(const std::string& name) const { return path_ + "/" + name; }

 private:
  std::string path_;
};

}  // namespace gouge::testing_support
