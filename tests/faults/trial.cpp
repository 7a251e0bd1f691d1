#include "tests/faults/trial.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <thread>

namespace gouge::testing_faults {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr double kLongest_s = 600;  // the machine may have other work

std::string bytes_of(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::vector<std::string> environment_of(const Misfortune& misfortune) {
  std::vector<std::string> all;
  for (char** entry = environ; *entry != nullptr; ++entry) all.emplace_back(*entry);
  if (misfortune.fault.empty() && misfortune.counts_file.empty()) return all;
  all.emplace_back("LD_PRELOAD=" GOUGE_FAULT_LIBRARY);
  if (!misfortune.fault.empty()) all.push_back("GOUGE_FAULT=" + misfortune.fault);
  if (!misfortune.counts_file.empty()) all.push_back("GOUGE_FAULT_COUNTS=" + misfortune.counts_file);
  if (misfortune.is_early) all.emplace_back("GOUGE_FAULT_EARLY=1");
  return all;
}

std::vector<char*> pointers_to(std::vector<std::string>& words) {
  std::vector<char*> all;
  for (std::string& word : words) all.push_back(word.data());
  all.push_back(nullptr);
  return all;
}

pid_t start(const std::string& folder, std::vector<std::string> words, std::vector<std::string> environment) {
  words.insert(words.begin(), GOUGE_BINARY);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  for (const auto& [stream, name] : {std::pair(STDOUT_FILENO, ".out"), std::pair(STDERR_FILENO, ".err")})
    posix_spawn_file_actions_addopen(&actions, stream, (folder + name).c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  // A job in the background of a shell ignores SIGINT, and so would the program.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t usual;
  ::sigemptyset(&usual);
  ::sigaddset(&usual, SIGINT);
  ::sigaddset(&usual, SIGTERM);
  posix_spawnattr_setsigdefault(&attributes, &usual);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
  pid_t child = 0;
  const int failed = posix_spawn(&child, GOUGE_BINARY, &actions, &attributes, pointers_to(words).data(),
                                 pointers_to(environment).data());
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  return failed == 0 ? child : -1;
}

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

}  // namespace

Ending run_program(const std::string& folder, const std::vector<std::string>& arguments, const Misfortune& misfortune) {
  const Clock::time_point begin = Clock::now();
  Ending ending;
  const pid_t child = start(folder, arguments, environment_of(misfortune));
  if (child < 0) return ending;
  int status = 0;
  int to_send = misfortune.signal;
  while (::waitpid(child, &status, WNOHANG) == 0) {
    const double now = seconds_since(begin);
    if (to_send != 0 && now >= misfortune.after_s) {
      ::kill(child, to_send);
      to_send = 0;
    }
    if (now > kLongest_s) {
      ::kill(child, SIGKILL);
      ::waitpid(child, &status, 0);
      status = SIGALRM;
      break;
    }
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
  ending.seconds = seconds_since(begin);
  if (WIFEXITED(status)) ending.exit_status = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) ending.signal = WTERMSIG(status);
  ending.out = bytes_of(folder + ".out");
  ending.err = bytes_of(folder + ".err");
  return ending;
}

Files files_of(const std::string& folder) {
  static const std::regex kSeconds("time=\"[0-9.]+\"");
  Files files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_directory()) files[fs::relative(entry.path(), folder).string() + "/"];
    if (!entry.is_regular_file()) continue;
    std::string bytes = bytes_of(entry.path().string());
    if (entry.path().extension() == ".xml") bytes = std::regex_replace(bytes, kSeconds, "time=\"\"");
    files[fs::relative(entry.path(), folder).string()] = std::move(bytes);
  }
  return files;
}

void put_files(const std::string& folder, const Files& files) {
  fs::remove_all(folder);
  fs::create_directories(folder);
  for (const auto& [name, bytes] : files) {
    const fs::path file = fs::path(folder) / name;
    fs::create_directories(file.parent_path());
    if (!name.ends_with('/')) std::ofstream(file, std::ios::binary) << bytes;
  }
}

}  // namespace gouge::testing_faults
