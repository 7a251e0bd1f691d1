#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "cli/options/check_options.h"
#include "lib/base/result.h"

namespace gouge {

/// Share of a job list to run: number `index` of `count`, from 1.
struct Shard {
  std::size_t index = 1, count = 1;

  /// Returns whether the share has a job, by the job's place in its list alone.
  [[nodiscard]] bool has(std::size_t job) const { return job % count == index - 1; }
};

struct BatchArguments : Verbosity {
  std::vector<std::string> files;  ///< a job list, or toolpaths
  CheckArguments check;            ///< how toolpaths are checked; `check.job.threads` of the whole batch
  std::vector<std::string> words;  ///< the options of `check` that were given
  std::string folder, progress = "auto", stop_on, shard, watch, scratch;
  std::uint32_t jobs = 0;
  double memory_gb = 0;
  std::size_t chunk = 65536;  ///< moves
  bool is_resumed = false, is_fresh = false, is_rehearsal = false, is_without_reports = false, is_forced = false;
  bool has_certificates = false;
};

/// Parses "2/8". Errors (code usage).
[[nodiscard]] Result<Shard> understand_shard(const std::string& text);

void add_batch_options(CLI::App& command, BatchArguments& arguments);

/// Notes which options of a job were given. To be called after the parse.
void take_words(const CLI::App& command, BatchArguments& arguments);

}  // namespace gouge
