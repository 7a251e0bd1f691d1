#include "lib/base/files.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/support/temporary_folder.h"

namespace gouge::files_test {
namespace {

TEST(Files, WriteThenReadGivesTheSameBytes) {
  const testing_support::TemporaryFolder folder;
  const std::string path = folder.at("files.bin");
  const std::string bytes("a\0b\r\n\xff", 6);
  ASSERT_TRUE(write_file(path, bytes).has_value());
  EXPECT_EQ(*read_file(path), bytes);
}

TEST(Files, WhatCannotBeReadSaysWhy) {
  EXPECT_EQ(read_file("/no/such/file").error().code, "file-not-found");
  EXPECT_EQ(read_file("/tmp").error().code, "file-is-folder");
}

TEST(Files, AViewShowsTheSameBytesAndOutlivesTheName) {
  const testing_support::TemporaryFolder folder;
  const std::string path = folder.at("view.bin");
  const std::string bytes = std::string("a\0b\r\n\xff", 6) + std::string(100'000, 'x');
  ASSERT_TRUE(write_file(path, bytes).has_value());
  const Result<FileView> view = view_file(path);
  ASSERT_TRUE(view.has_value());
  std::filesystem::remove(path);
  EXPECT_EQ(view->bytes, bytes);
}

TEST(Files, AViewOfWhatIsNoPlainFileIsRead) {
  const testing_support::TemporaryFolder folder;
  const std::string path = folder.at("empty.bin");
  ASSERT_TRUE(write_file(path, "").has_value());
  EXPECT_EQ(view_file(path)->bytes, "");
  EXPECT_EQ(view_file("/no/such/file").error().code, "file-not-found");
  EXPECT_EQ(view_file("/tmp").error().code, "file-is-folder");
}

TEST(Files, AFailedWriteLeavesNothingBehind) {
  EXPECT_EQ(write_file("/no/such/folder/out.txt", "x").error().code, "file-unwritable");
  EXPECT_FALSE(std::filesystem::exists("/no/such/folder"));
  EXPECT_EQ(write_file("/dev/full", "x").error().code, "file-unwritable");
}

}  // namespace
}  // namespace gouge::files_test
