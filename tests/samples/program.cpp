#include "tests/samples/program.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

namespace gouge::testing_samples {
namespace {

// Reports carry the date; where tests compare them to the byte it is this one.
const int kDateIsSet = ::setenv("SOURCE_DATE_EPOCH", "1700000000", 1);

Outcome run(const std::string& program, const std::string& folder, const std::vector<std::string>& arguments) {
  const std::string out = folder + "/.stdout", err = folder + "/.stderr";
  std::vector<std::string> words = {program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  pid_t child = 0;
  const int failed = posix_spawn(&child, program.c_str(), &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);

  Outcome outcome;
  if (failed != 0) return outcome;
  int status = 0;
  if (waitpid(child, &status, 0) == child && WIFEXITED(status)) outcome.exit_status = WEXITSTATUS(status);
  outcome.out = text_of(out);
  outcome.err = text_of(err);
  return outcome;
}

}  // namespace

Outcome run_gougecheck(const std::string& folder, const std::vector<std::string>& arguments) {
  return run(GOUGE_BINARY, folder, arguments);
}

Outcome run_script(const std::string& folder, const std::string& script) {
  return run("/bin/sh", folder, {"-c", std::string("GOUGECHECK='") + GOUGE_BINARY + "'\n" + script});
}

Outcome run_make_samples(const std::string& folder) { return run(GOUGE_MAKE_SAMPLES, folder, {folder}); }

std::string text_of(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

void write_text(const std::string& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

}  // namespace gouge::testing_samples
