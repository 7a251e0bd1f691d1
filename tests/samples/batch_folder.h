#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/samples/program.h"

// The folder of a batch as tests compare it.

namespace gouge::testing_samples {

/// Writes FOLDER/jobs.json: a check and a correction of each of `samples`, which stand below `folder`, as make_samples
/// leaves them. Even ones have no report.
void write_job_list(const std::string& folder, const std::vector<std::string>& samples);

/// A fresh folder with all samples and such a list of some.
[[nodiscard]] std::string samples_with_list(const std::vector<std::string>& samples);

/// Runs gougecheck batch in `folder`, with these words.
Outcome run_batch(const std::string& folder, std::vector<std::string> words);

/// summary.json of a batch.
[[nodiscard]] nlohmann::json summary_of(const std::string& folder);

/// Every file of a batch by its name, without what may differ between two runs of the same jobs: the columns seconds,
/// memory_mb, host and rank, JUnit's times, and the manifest, which has the hashes of these. The store is its rows,
/// sorted.
[[nodiscard]] std::map<std::string, std::string> batch_files(const std::string& folder);

/// Runs `sql` on a store, as somebody else may.
void change_store(const std::string& file, const std::string& sql);

/// The number that `sql` selects from a store; -1 where there is none.
[[nodiscard]] long number_in_store(const std::string& file, const std::string& sql);

/// Names that differ or are on one side alone, for messages; empty where both are the same.
[[nodiscard]] std::string difference(const std::map<std::string, std::string>& a,
                                     const std::map<std::string, std::string>& b);

}  // namespace gouge::testing_samples
