#include "cli/job/mesh_copies.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <thread>
#include <vector>

#include "tests/support/temporary_folder.h"

namespace gouge::mesh_copies_test {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMost = 1'000'000;

using testing_support::TemporaryFolder;

std::string made(const std::string& folder) {
  fs::create_directories(folder);
  return folder;
}

void write(const std::string& file, const std::string& text) { std::ofstream(file) << text; }

std::string seen(MeshCopies& copies, const std::string& file) {
  const Result<FileView> view = copies.view(file, kMost);
  return view ? std::string(view->bytes) : view.error().code;
}

std::vector<fs::path> copies_below(const std::string& disk) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(disk)) {
    if (entry.is_regular_file() && entry.path().filename().string().size() == 64) files.push_back(entry.path());
  }
  return files;
}

TEST(MeshCopies, AreMadeOnceForAllWhoReadAFile) {
  const TemporaryFolder temporary;
  const std::string folder = temporary.path(), disk = made(folder + "/disk"), file = folder + "/part.stl";
  write(file, "solid one\n");
  {
    MeshCopies first(disk), second(disk);
    std::atomic<int> same = 0;
    std::vector<std::thread> readers;
    for (int k = 0; k < 8; ++k)
      readers.emplace_back([&, k] { same += seen(k % 2 == 0 ? first : second, file) == "solid one\n" ? 1 : 0; });
    for (std::thread& reader : readers) reader.join();
    EXPECT_EQ(same, 8);
    EXPECT_EQ(first.files() + second.files(), 1U);
    EXPECT_EQ(first.bytes() + second.bytes(), 10U);
    EXPECT_EQ(copies_below(disk).size(), 1U);
    // Another of its name, of the same length.
    write(folder + "/new", "solid two\n");
    fs::rename(folder + "/new", file);
    EXPECT_EQ(seen(second, file), "solid two\n");
    EXPECT_EQ(seen(first, file), "solid two\n");
    EXPECT_EQ(first.files() + second.files(), 2U);
    EXPECT_EQ(seen(first, folder + "/gone.stl"), "file-not-found");
    EXPECT_FALSE(first.trouble() || second.trouble());
  }
  EXPECT_TRUE(fs::is_empty(disk)) << "the last one tidies up";
}

TEST(MeshCopies, AreReadOnlyAsTheyWereMade) {
  const TemporaryFolder temporary;
  const std::string folder = temporary.path(), disk = made(folder + "/disk"), file = folder + "/part.stl";
  write(file, "solid one\n");
  MeshCopies first(disk), second(disk);
  ASSERT_EQ(seen(first, file), "solid one\n");
  const std::vector<fs::path> copies = copies_below(disk);
  ASSERT_EQ(copies.size(), 1U);
  write(copies.front().string(), "solid 0ne\n");
  EXPECT_EQ(seen(second, file), "solid one\n");
  fs::remove(copies.front());
  EXPECT_EQ(seen(second, file), "solid one\n");
}

// Nothing tidies up after SIGKILL but the next one.
TEST(MeshCopies, OfOneThatWasKilledAreRemovedByTheNext) {
  const TemporaryFolder temporary;
  const std::string folder = temporary.path(), disk = made(folder + "/disk"), file = folder + "/part.stl";
  write(file, "solid one\n");
  const pid_t child = ::fork();
  if (child == 0) {
    MeshCopies killed(disk);
    static_cast<void>(killed.view(file, kMost));
    ::_exit(0);
  }
  ASSERT_EQ(::waitpid(child, nullptr, 0), child);
  ASSERT_EQ(copies_below(disk).size(), 1U);
  {
    MeshCopies next(disk);
    EXPECT_TRUE(copies_below(disk).empty());
    EXPECT_EQ(seen(next, file), "solid one\n");
    EXPECT_EQ(next.files(), 1U);
  }
  EXPECT_TRUE(fs::is_empty(disk));
}

TEST(MeshCopies, AreDoneWithoutWhereTheyCannotBe) {
  const TemporaryFolder temporary;
  const std::string folder = temporary.path(), disk = made(folder + "/disk"), file = folder + "/part.stl";
  write(file, "solid one\n");
  MeshCopies nowhere(folder + "/gone");
  ASSERT_TRUE(nowhere.trouble().has_value());
  EXPECT_EQ(nowhere.trouble()->code, "scratch-unusable");
  EXPECT_EQ(seen(nowhere, file), "solid one\n");
  // Somebody else could have put a mesh there.
  const fs::path own = disk + "/gougecheck-meshes-" + std::to_string(::geteuid());
  fs::create_directory(own);
  fs::permissions(own, fs::perms::all);
  MeshCopies open_to_all(disk);
  EXPECT_TRUE(open_to_all.trouble().has_value());
  EXPECT_EQ(seen(open_to_all, file), "solid one\n");
  EXPECT_TRUE(fs::is_empty(own));
  MeshCopies unasked("");
  EXPECT_FALSE(unasked.trouble().has_value());
  EXPECT_EQ(seen(unasked, file), "solid one\n");
}

}  // namespace
}  // namespace gouge::mesh_copies_test
