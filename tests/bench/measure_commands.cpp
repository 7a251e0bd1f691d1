#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "lib/base/number_text.h"
#include "tests/bench/scene_files.h"

// Whole commands as users run them, a process each: the processor seconds (user and system) and the memory of each,
// least of several runs, beside those of another program in turn, as a table of ratios.
//
//   measure_commands FOLDER NEW [OLD] [--repeat N] [--threads N] [--only WORD]
//
// FOLDER keeps the scenes (write_scene's) from one run to the next; NEW and OLD are gougecheck programs.

namespace gouge::bench {
namespace {

struct Case {
  std::string name;
  std::string scene;               ///< a folder of FOLDER
  std::vector<std::string> words;  ///< after the program, run in the scene's folder
  std::string aim;
};

struct Cost {
  double seconds = 1e300;
  double megabytes = 0;
  int status = -1;
};

struct Wanted {
  std::string folder;
  std::vector<std::string> programs;
  int repeats = 5;
  std::string threads = "1";
  std::string only;
};

std::vector<std::string> joined(std::vector<std::string> words, const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

std::vector<Case> cases(const std::string& threads) {
  const std::vector<std::string> job = {"path.apt",   "--part",    "part.stl", "--tools",
                                        "tools.json", "--threads", threads,    "-q"};
  const auto check = joined({"check"}, job), correct = joined({"correct"}, job);
  std::vector<Case> all;
  for (const std::string size : {"2400", "200000", "2000000"}) {
    all.push_back({"check, clean, " + size, "ball " + size + " clean", check, ""});
    if (size == "2000000") continue;
    all.push_back({"check, 7 % of the moves gouge, " + size, "ball " + size + " all", check, "2 x clean"});
    all.push_back({"correct, the same", "ball " + size + " all", joined(correct, {"-o", "out.apt"}), "2 x check"});
    all.push_back(
        {"check --report, the same", "ball " + size + " all", joined(check, {"--report", "r"}), "check + 1.2 s"});
    all.push_back({"check --csv --json, the same", "ball " + size + " all",
                   joined(check, {"--csv", "o.csv", "--json", "o.json"}), ""});
  }
  for (const std::string size : {"2400", "200000", "2000000"})
    all.push_back({"check, bull-nose, few gouges, " + size, "bull " + size + " few", check, "2 x from 2,400 to 2M"});
  all.push_back(
      {"check --report, few gouges, 2000000", "ball 2000000 few", joined(check, {"--report", "r"}), "check + 4 s"});
  for (const std::string head : {"576", "12544", "50176"})
    all.push_back({"check --head of " + head + " facets, 2400", "ball 2400 clean",
                   joined(check, {"--head", "head" + head + ".stl"}), "60 us a move more"});
  all.push_back({"mesh, 2000000", "ball 2000000 clean", {"mesh", "part.stl"}, "8 s, 400 MB"});
  return all;
}

Outcome make_scene(const std::string& folder, const std::string& scene) {
  const std::string path = folder + "/" + scene;
  if (std::filesystem::exists(path + "/path.apt")) return Done{};
  std::printf("writing %s\n", path.c_str());
  WorkloadKey key;
  const std::size_t first = scene.find(' '), second = scene.rfind(' ');
  key.tool = scene.substr(0, first) == "bull" ? ToolKind::bull : ToolKind::ball;
  key.triangles = std::stoul(scene.substr(first + 1, second - first - 1));
  if (Outcome written = write_scene_files(path, key, scene.substr(second + 1)); !written) return written;
  constexpr double kBottom_mm = 11;  // just over what is cut
  struct {
    const char* name;
    int around, steps;
  } const heads[] = {{"/head576.stl", 24, 5}, {"/head12544.stl", 112, 27}, {"/head50176.stl", 224, 55}};
  for (const auto& head : heads) {
    if (Outcome written = write_head_file(path + head.name, kBottom_mm, head.around, head.steps); !written)
      return written;
  }
  return Done{};
}

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

Cost run(const std::string& program, const std::string& folder, const std::vector<std::string>& words) {
  std::vector<std::string> all = joined({program}, words);
  std::vector<char*> arguments;
  for (std::string& word : all) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    const int nothing = open("/dev/null", O_WRONLY);
    dup2(nothing, STDOUT_FILENO);
    dup2(nothing, STDERR_FILENO);
    if (chdir(folder.c_str()) == 0) execv(program.c_str(), arguments.data());
    _exit(127);
  }
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  return {seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime), static_cast<double>(usage.ru_maxrss) / 1024,
          WIFEXITED(status) ? WEXITSTATUS(status) : -1};
}

int measure(const Wanted& wanted) {
  std::printf("| command | new | old | ratio | aim |\n|---|---|---|---|---|\n");
  for (const Case& one : cases(wanted.threads)) {
    if (one.name.find(wanted.only) == std::string::npos) continue;
    if (const Outcome made = make_scene(wanted.folder, one.scene); !made) {
      std::fprintf(stderr, "%s\n", to_text(made.error()).c_str());
      return 1;
    }
    std::vector<Cost> least(wanted.programs.size());
    for (int k = 0; k < wanted.repeats; ++k) {
      for (std::size_t p = 0; p < least.size(); ++p) {
        const Cost cost = run(wanted.programs[p], wanted.folder + "/" + one.scene, one.words);
        if (cost.seconds < least[p].seconds) least[p] = cost;
      }
    }
    const auto text = [](const Cost& cost) {
      const std::string failed = cost.status > 1 || cost.status < 0 ? ", exit " + std::to_string(cost.status) : "";
      return fixed_text(cost.seconds, 2) + " s, " + fixed_text(cost.megabytes, 0) + " MB" + failed;
    };
    const bool has_old = least.size() > 1;
    std::printf("| %s | %s | %s | %s | %s |\n", one.name.c_str(), text(least[0]).c_str(),
                has_old ? text(least[1]).c_str() : "",
                has_old ? fixed_text(least[0].seconds / least[1].seconds, 2).c_str() : "", one.aim.c_str());
    std::fflush(stdout);
  }
  return 0;
}

}  // namespace
}  // namespace gouge::bench

int main(int count, char** words) {
  gouge::bench::Wanted wanted;
  std::vector<std::string> names;
  for (int k = 1; k < count; ++k) {
    const std::string word = words[k], value = k + 1 < count ? words[k + 1] : "";
    if (word == "--repeat") {
      wanted.repeats = std::max(1, std::atoi(value.c_str()));
    } else if (word == "--threads") {
      wanted.threads = value;
    } else if (word == "--only") {
      wanted.only = value;
    } else {
      names.push_back(std::filesystem::absolute(word));
      continue;
    }
    ++k;
  }
  if (names.size() < 2 || names.size() > 3) {
    std::fprintf(stderr, "measure_commands FOLDER NEW [OLD] [--repeat N] [--threads N] [--only WORD]\n");
    return 2;
  }
  wanted.folder = names[0];
  wanted.programs.assign(names.begin() + 1, names.end());
  return gouge::bench::measure(wanted);
}
