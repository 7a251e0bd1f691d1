#include "lib/base/input_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include "lib/base/files.h"
#include "lib/base/number_text.h"
#include "tests/support/temporary_folder.h"

namespace gouge::input_file_test {
namespace {

namespace fs = std::filesystem;

// A name in a folder of the test's own, which goes with it.
class InputFileTest : public testing::Test {
 protected:
  void SetUp() override { std::signal(SIGPIPE, SIG_IGN); }

  [[nodiscard]] std::string path() const { return folder_.at("input"); }

  // Written an hour ago, so that a change now shows whatever the clock's steps.
  void write(const std::string& bytes) const {
    std::ofstream(path(), std::ios::binary) << bytes;
    fs::last_write_time(path(), fs::file_time_type::clock::now() - std::chrono::hours(1));
  }

  testing_support::TemporaryFolder folder_;
};

// Reads the rest of the file.
std::string code_of_rest(InputReader& file) {
  char bytes[16];
  for (;;) {
    const Result<std::size_t> count = file.read(bytes, sizeof bytes);
    if (!count) return count.error().code;
    if (*count == 0) return "whole";
  }
}

TEST_F(InputFileTest, DevicesAreRefused) {
  for (const std::string device : {"/dev/zero", "/dev/urandom", "/dev/full", "/dev/null"}) {
    const auto read = read_file(device);
    ASSERT_FALSE(read) << device;
    EXPECT_EQ(to_text(read.error()), device + ": error: is a device; expected a file or a pipe [input-is-device]");
    EXPECT_EQ(view_file(device).error().code, "input-is-device");
  }
}

TEST_F(InputFileTest, AFileAboveTheLimitIsRefusedBeforeItIsRead) {
  write("");
  fs::resize_file(path(), 9'000'000'000'000);  // nothing of it is on the disk
  for (const auto& error : {read_file(path()).error(), view_file(path()).error()})
    EXPECT_EQ(to_text(error), path() +
                                  ": error: has 9000000000000 bytes; expected at most 8 GB; check that it is the right "
                                  "file, or allow more with --max-input [input-too-large]");
  write("12345");
  EXPECT_EQ(*read_file(path(), 5), "12345");
  EXPECT_EQ(view_file(path(), 5)->bytes, "12345");
  EXPECT_EQ(read_file(path(), 4).error().code, "input-too-large");
  EXPECT_EQ(view_file(path(), 4).error().code, "input-too-large");
}

TEST_F(InputFileTest, APipeIsReadUpToTheLimit) {
  ASSERT_EQ(::mkfifo(path().c_str(), 0600), 0);
  for (const bool is_view : {false, true}) {
    std::thread short_writer([&] { std::ofstream(path()) << std::string(3'000'000, 'x'); });
    const auto got = is_view ? std::string(view_file(path(), 3'000'000)->bytes) : *read_file(path(), 3'000'000);
    short_writer.join();
    EXPECT_EQ(got, std::string(3'000'000, 'x'));

    std::thread endless_writer([&] {
      std::ofstream pipe(path());
      while (pipe << "GOTO/1,2,3\n") {
      }
    });
    const auto error = is_view ? view_file(path(), 3'000'000).error() : read_file(path(), 3'000'000).error();
    endless_writer.join();
    EXPECT_EQ(error.message.substr(0, 41), "goes on after 3 MB; expected at most 3 MB");
    EXPECT_EQ(error.code, "input-too-large");
  }
}

TEST_F(InputFileTest, WhatChangesWhileItIsReadIsRefused) {
  const auto opened = [&] {
    write("0123456789012345678901234567890123456789");
    Result<InputReader> file = InputReader::open(path(), 1000);
    char bytes[16];
    EXPECT_TRUE(file && file->read(bytes, sizeof bytes));
    return std::move(*file);
  };
  {
    InputReader file = opened();
    EXPECT_EQ(code_of_rest(file), "whole");
  }
  {
    InputReader file = opened();
    std::ofstream(path(), std::ios::app) << "more";
    EXPECT_EQ(code_of_rest(file), "input-changed") << "grown";
  }
  {
    InputReader file = opened();
    fs::resize_file(path(), 20);
    EXPECT_EQ(code_of_rest(file), "input-changed") << "cut short";
  }
  {
    InputReader file = opened();
    std::fstream(path(), std::ios::in | std::ios::out) << "X";
    EXPECT_EQ(code_of_rest(file), "input-changed") << "written over";
  }
}

TEST_F(InputFileTest, AViewDoesNotFeelWhatHappensToTheFile) {
  const std::string bytes(1'000'000, 'x');
  write(bytes);
  const Result<FileView> view = view_file(path());
  ASSERT_TRUE(view);
  fs::resize_file(path(), 0);  // ends a program that has it mapped
  EXPECT_EQ(view->bytes, bytes);
}

TEST_F(InputFileTest, FilesOfTheSystemThatStateNoSizeAreRead) {
  EXPECT_GT(read_file("/proc/self/status")->size(), 10U);
  write("");
  EXPECT_EQ(*read_file(path()), "");
}

TEST(ByteSize, IsReadWithItsUnit) {
  EXPECT_EQ(parse_byte_size("8GB"), 8'000'000'000U);
  EXPECT_EQ(parse_byte_size("1.5 MiB"), 1'572'864U);
  EXPECT_EQ(parse_byte_size("200kb"), 200'000U);
  EXPECT_EQ(parse_byte_size("1KiB"), 1024U);
  EXPECT_EQ(parse_byte_size("4096"), 4096U);
  EXPECT_EQ(parse_byte_size("7B"), 7U);
  EXPECT_EQ(parse_byte_size("2TB"), 2'000'000'000'000U);
  for (const char* text :
       {"", "GB", "8G", "-1", "0", "0.5", "1e9", "1..5GB", "8 GB ", "99999999999999TB", "nan", "8  GB"})
    EXPECT_FALSE(parse_byte_size(text)) << text;
}

TEST(ByteSize, IsWrittenForPeople) {
  EXPECT_EQ(byte_size_text(8'000'000'000), "8 GB");
  EXPECT_EQ(byte_size_text(12'345'678), "12.34 MB");
  EXPECT_EQ(byte_size_text(1'050), "1.05 kB");
  EXPECT_EQ(byte_size_text(1'500), "1.5 kB");
  EXPECT_EQ(byte_size_text(999), "999 bytes");
  EXPECT_EQ(byte_size_text(1), "1 byte");
  EXPECT_EQ(byte_size_text(5'000'000'000'000'000), "5000 TB");
}

TEST_F(InputFileTest, StandardInputIsReadOnceUnderItsName) {
  write("GOTO/1,2,3\n");
  const int before = ::dup(STDIN_FILENO);
  ASSERT_NE(std::freopen(path().c_str(), "r", stdin), nullptr);
  const Result<std::string> first = read_file("-");
  ASSERT_TRUE(first.has_value()) << to_text(first.error());
  EXPECT_EQ(*first, "GOTO/1,2,3\n");
  const Result<std::string> second = read_file("-");
  ASSERT_FALSE(second.has_value());
  EXPECT_EQ(second.error().code, "input-twice");
  ::dup2(before, STDIN_FILENO);
  ::close(before);
}

}  // namespace
}  // namespace gouge::input_file_test
