// A report that is killed, or fails, at any call that changes the disk. The calls are this program's own: the
// linker prefers them to those of the C library, and each counts before it does its work.

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <map>

#include "cli/output/output_file.h"
#include "cli/output/report_folder.h"
#include "lib/base/files.h"
#include "tests/support/temporary_folder.h"

namespace {

int calls = 0;    // so far
int chosen = -1;  // the one at which it happens
bool is_kill = true;

bool happens() {
  if (calls++ != chosen) return false;
  if (is_kill) ::raise(SIGKILL);
  errno = EIO;
  return true;
}

}  // namespace

extern "C" {
int rename(const char* from, const char* to) noexcept {
  return happens() ? -1 : static_cast<int>(::syscall(SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, 0));
}
int linkat(int from, const char* old_name, int to, const char* new_name, int flags) noexcept {
  return happens() ? -1 : static_cast<int>(::syscall(SYS_linkat, from, old_name, to, new_name, flags));
}
int unlink(const char* name) noexcept {
  return happens() ? -1 : static_cast<int>(::syscall(SYS_unlinkat, AT_FDCWD, name, 0));
}
int mkdir(const char* name, mode_t mode) noexcept {
  return happens() ? -1 : static_cast<int>(::syscall(SYS_mkdirat, AT_FDCWD, name, mode));
}
ssize_t write(int handle, const void* bytes, size_t count) {
  return happens() ? -1 : static_cast<ssize_t>(::syscall(SYS_write, handle, bytes, count));
}
// The kernel outlives every kill of this test, so nothing needs to reach the disk.
int fsync(int) { return happens() ? -1 : 0; }
int fchmod(int handle, mode_t mode) noexcept {
  return happens() ? -1 : static_cast<int>(::syscall(SYS_fchmod, handle, mode));
}
}

namespace gouge::report_kill_test {
namespace {

namespace fs = std::filesystem;
using Content = std::map<std::string, std::string>;

class ReportKill : public testing::Test {
 protected:
  void SetUp() override { chosen = -1; }

  bool report(const Content& files) const {
    std::vector<NamedFile> named;
    for (const auto& [name, bytes] : files) named.push_back({name, bytes, ""});
    ReportFolder report(folder_, false);
    return report.open() && report.stage(named) && report.commit();
  }

  /// In a process of its own, with call `n` killed or failing: whether it was whole, and whether that call
  /// came.
  struct Run {
    bool is_done = false, is_hit = false;
  };
  [[nodiscard]] Run report_until(const Content& files, int n) const {
    const pid_t child = ::fork();
    if (child == 0) {
      calls = 0;
      chosen = n;
      const bool is_done = report(files);
      ::_exit((is_done ? 1 : 0) + (calls > n ? 2 : 0));
    }
    int status = 0;
    EXPECT_EQ(::waitpid(child, &status, 0), child);
    if (WIFSIGNALED(status)) return {false, true};
    return {(WEXITSTATUS(status) & 1) != 0, (WEXITSTATUS(status) & 2) != 0};
  }

  [[nodiscard]] Content content() const {
    Content files;
    if (!fs::exists(folder_)) return files;
    for (const auto& entry : fs::directory_iterator(folder_)) {
      const std::string name = entry.path().filename().string();
      if (name != kManifestName) files[name] = *read_file(entry.path().string());
    }
    return files;
  }

  /// Every file has the content of one of the two reports, whole.
  static void expect_whole(const Content& found, const Content& before, const Content& after, int n) {
    for (const auto& [name, bytes] : found) {
      if (name.starts_with(".gougecheck-report-")) continue;
      const auto is_of = [&, &file = name, &text = bytes](const Content& report) {
        const auto at = report.find(file);
        return at != report.end() && at->second == text;
      };
      EXPECT_TRUE(is_of(before) || is_of(after)) << name << " at call " << n;
    }
  }

  const Content old_ = {{"report.html", "a"}, {"moves.csv", "b"}, {"event_1.png", "c"}, {"event_5.png", "d"}};
  const Content new_ = {{"report.html", "A"}, {"moves.csv", "b"}, {"event_1.png", "C"}, {"heat_map.png", "E"}};
  testing_support::TemporaryFolder temporary_;
  std::string folder_ = temporary_.at("report");
};

TEST_F(ReportKill, AKillAtAnyCallLeavesAFolderTheNextReportKnows) {
  is_kill = true;
  for (const bool is_first : {true, false}) {
    int n = 0;
    for (bool is_hit = true; is_hit; ++n) {
      fs::remove_all(folder_);
      if (!is_first) {
        ASSERT_TRUE(report(old_));
      }
      const Content before = content();
      const Run run = report_until(new_, n);
      is_hit = run.is_hit;
      EXPECT_EQ(run.is_done, !is_hit) << n;
      expect_whole(content(), before, new_, n);
      EXPECT_TRUE(report(new_)) << "after a kill at call " << n;
      EXPECT_EQ(content(), new_) << "after a kill at call " << n;
    }
    EXPECT_GT(n, 20) << "hardly anything was killed";
  }
}

TEST_F(ReportKill, AFailureAtAnyCallLeavesWholeFilesAndNoOthers) {
  is_kill = false;
  for (const bool is_first : {true, false}) {
    int n = 0;
    for (bool is_hit = true; is_hit; ++n) {
      fs::remove_all(folder_);
      if (!is_first) {
        ASSERT_TRUE(report(old_));
      }
      const Content before = content();
      const Run run = report_until(new_, n);
      is_hit = run.is_hit;
      const Content after = content();
      expect_whole(after, before, new_, n);
      EXPECT_TRUE(!run.is_done || after == new_) << n;
      for (const auto& [name, bytes] : after) EXPECT_FALSE(name.starts_with(".")) << name << " at call " << n;
      EXPECT_TRUE(report(new_)) << "after a failure at call " << n;
      EXPECT_EQ(content(), new_) << "after a failure at call " << n;
    }
    EXPECT_GT(n, 20) << "hardly anything failed";
  }
}

}  // namespace
}  // namespace gouge::report_kill_test
