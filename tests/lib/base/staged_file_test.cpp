#include "lib/base/staged_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>

#include "lib/base/files.h"
#include "tests/support/other_user.h"
#include "tests/support/temporary_folder.h"

namespace gouge::staged_file_test {
namespace {

namespace fs = std::filesystem;

class Staged : public testing::Test {
 protected:
  void SetUp() override {
    // Everybody may make files here, so that only the files themselves are closed to another user.
    fs::permissions(folder_, fs::perms::all);
  }

  [[nodiscard]] std::string at(const std::string& name) const { return folder_ + "/" + name; }
  void put(const std::string& name, const std::string& text) const { std::ofstream(at(name)) << text; }
  [[nodiscard]] std::size_t entries() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }
  [[nodiscard]] struct stat info(const std::string& name) const {
    struct stat found {};
    EXPECT_EQ(::stat(at(name).c_str(), &found), 0) << name;
    return found;
  }

  testing_support::TemporaryFolder temporary_;
  std::string folder_ = temporary_.path();
};

TEST_F(Staged, NothingStandsThereBeforeTheCommitAndNothingIsLeftWithoutOne) {
  put("old", "old");
  {
    const Result<StagedFile> kept = StagedFile::make(at("new"), "new"), replaced = StagedFile::make(at("old"), "new");
    ASSERT_TRUE(kept.has_value() && replaced.has_value());
    EXPECT_FALSE(fs::exists(at("new")));
    EXPECT_EQ(*read_file(at("old")), "old");
  }
  EXPECT_EQ(entries(), 1U);
  for (const char* name : {"new", "old"}) {
    Result<StagedFile> staged = StagedFile::make(at(name), "new");
    ASSERT_TRUE(staged.has_value() && staged->commit().has_value()) << name;
    EXPECT_EQ(*read_file(at(name)), "new");
  }
  EXPECT_EQ(entries(), 2U);
}

TEST_F(Staged, AFileThatCameMeanwhileIsReplaced) {
  Result<StagedFile> staged = StagedFile::make(at("new"), "new");
  ASSERT_TRUE(staged.has_value());
  put("new", "another process");
  ASSERT_TRUE(staged->commit().has_value());
  EXPECT_EQ(*read_file(at("new")), "new");
  EXPECT_EQ(entries(), 1U);
}

TEST_F(Staged, ASymbolicLinkStaysAndItsTargetIsWritten) {
  fs::create_directories(at("deep"));
  put("deep/target", "old");
  fs::create_symlink("deep/target", at("link"));
  fs::create_symlink("link", at("link to link"));
  fs::create_symlink("deep/none yet", at("dangling"));
  fs::create_symlink("circle", at("circle"));
  EXPECT_TRUE(write_file(at("link to link"), "new").has_value());
  EXPECT_TRUE(fs::is_symlink(at("link")) && fs::is_symlink(at("link to link")));
  EXPECT_EQ(*read_file(at("deep/target")), "new");
  EXPECT_TRUE(write_file(at("dangling"), "made").has_value());
  EXPECT_TRUE(fs::is_symlink(at("dangling")));
  EXPECT_EQ(*read_file(at("deep/none yet")), "made");
  EXPECT_EQ(write_file(at("circle"), "x").error().message,
            "cannot write the file: its symbolic links go in a circle; nothing was written");
  EXPECT_EQ(fs::read_symlink(at("circle")), "circle");
}

TEST_F(Staged, ModeAndOwnerOfAReplacedFileStay) {
  put("old", "old");
  ASSERT_EQ(::chmod(at("old").c_str(), 0640), 0);
  if (::geteuid() == 0) {
    ASSERT_EQ(::chown(at("old").c_str(), testing_support::kNobody, 4), 0);
  }
  const struct stat before = info("old");
  ASSERT_TRUE(write_file(at("old"), "new").has_value());
  const struct stat after = info("old");
  EXPECT_NE(before.st_ino, after.st_ino) << "not the old file overwritten";
  EXPECT_EQ(after.st_mode & 07777, 0640U);
  EXPECT_EQ(after.st_uid, before.st_uid);
  EXPECT_EQ(after.st_gid, before.st_gid);
}

TEST_F(Staged, ANewFileHasTheModeTheUserWants) {
  const mode_t mask = ::umask(027);
  EXPECT_TRUE(write_file(at("new"), "new").has_value());
  ::umask(mask);
  EXPECT_EQ(info("new").st_mode & 07777, 0640U);
}

TEST_F(Staged, TheOtherHardLinksKeepTheOldContent) {
  put("old", "old");
  fs::create_hard_link(at("old"), at("other"));
  ASSERT_TRUE(write_file(at("old"), "new").has_value());
  EXPECT_EQ(*read_file(at("old")), "new");
  EXPECT_EQ(*read_file(at("other")), "old");
}

TEST_F(Staged, WhatIsWriteProtectedOrOfAnotherUserIsNotReplaced) {
  put("mine", "mine");
  put("others", "others");
  ASSERT_EQ(::chmod(at("mine").c_str(), 0444), 0);
  ASSERT_EQ(::chmod(at("others").c_str(), 0666), 0);
  if (::geteuid() == 0) {
    ASSERT_EQ(::chown(at("mine").c_str(), testing_support::kNobody, testing_support::kNobody), 0);
  }
  const auto refused = [&](const char* name, const char* why) {
    return testing_support::as_nobody([&] {
      const Outcome written = write_file(at(name), "new");
      return written || written.error().message.find(why) == std::string::npos ? 1 : 0;
    });
  };
  EXPECT_EQ(refused("mine", "it is write-protected (Permission denied)"), 0);
  if (::geteuid() == 0) {
    EXPECT_EQ(refused("others", "it belongs to another user"), 0);
  }
  EXPECT_EQ(*read_file(at("mine")), "mine");
  EXPECT_EQ(*read_file(at("others")), "others");
  EXPECT_EQ(entries(), 2U);
}

TEST_F(Staged, ALimitOfTheShellIsReportedAndNothingIsLeft) {
  put("old", "old");
  const pid_t child = ::fork();
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{1000, 1000};
    const bool is_set = ::setrlimit(RLIMIT_FSIZE, &limit) == 0;
    const Outcome written = write_file(at("old"), std::string(5000, 'x'));
    ::_exit(is_set && !written && written.error().message.find("ulimit -f") != std::string::npos ? 0 : 1);
  }
  int status = -1;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  EXPECT_EQ(*read_file(at("old")), "old");
  EXPECT_EQ(entries(), 1U);
}

TEST_F(Staged, WhatAKilledProgramLeftIsRemovedAndNothingElse) {
  put(".gougecheck-0123456789av", "of a program that was killed");
  put(".gougecheck-0123456789az", "not one of these names");
  put(".gougecheck-0123456789a", "too short");
  put("gougecheck-0123456789av", "not one either");
  fs::create_symlink(at("gougecheck-0123456789av"), at(".gougecheck-vvvvvvvvvvvv"));
  ASSERT_TRUE(write_file(at("new"), "new").has_value());
  EXPECT_FALSE(fs::exists(at(".gougecheck-0123456789av")));
  EXPECT_EQ(entries(), 5U);
}

TEST_F(Staged, WhatAnotherProcessIsAboutToPutInPlaceStays) {
  const std::string name = at(".gougecheck-0123456789av");
  const int handle = ::open(name.c_str(), O_CREAT | O_WRONLY | O_CLOEXEC, 0644);
  keep_from_removal(handle);
  ASSERT_TRUE(write_file(at("new"), "new").has_value());
  EXPECT_TRUE(fs::exists(name));
  ::close(handle);
  ASSERT_TRUE(write_file(at("new"), "newer").has_value());
  EXPECT_FALSE(fs::exists(name));
}

TEST_F(Staged, ASignalRemovesTemporaryNamesThatAreInUse) {
  put("a", "a");
  put("b", "b");
  put("c", "c");
  TemporaryName a(at("a")), b(at("b")), moved(std::move(b));
  a.forget();
  remove_temporary_names();
  EXPECT_TRUE(fs::exists(at("a")));
  EXPECT_FALSE(fs::exists(at("b")));
  { const TemporaryName c(at("c")); }
  EXPECT_FALSE(fs::exists(at("c")));
}

TEST_F(Staged, ALongNameIsNoTrouble) {
  const std::string name(255, 'n');
  EXPECT_TRUE(write_file(at(name), "new").has_value());
  EXPECT_TRUE(write_file(at(name), "newer").has_value());
  EXPECT_EQ(*read_file(at(name)), "newer");
}

}  // namespace
}  // namespace gouge::staged_file_test
