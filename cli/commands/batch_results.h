#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/options/reading_options.h"
#include "lib/base/files.h"
#include "lib/base/result.h"
#include "postproc/result/stored_result.h"

namespace gouge {

/// A file that a job wrote, with its content at that time.
struct WrittenFile {
  std::string file, sha256;
};

/// A job in the summary of a batch.
struct ListedJob {
  std::string name, verdict;
  std::string result_file = {};  ///< empty: the job has no report
  std::string report_file = {};  ///< the page of the report; empty: the job has none
  std::string command = {};
  std::optional<int> status = {};        ///< none: the job has not run
  std::string result_sha256 = {};        ///< of the result that the job wrote; empty: not stated
  std::vector<WrittenFile> others = {};  ///< files outside its report that may be certificates
  std::vector<std::string> messages = {};
};

/// Returns the jobs of the batch in a folder, in their order. If the folder has a manifest, the summary must be the one
/// that it lists.
/// Errors: result-format, result-syntax, result-edited, and those of read_file.
[[nodiscard]] Result<std::vector<ListedJob>> read_batch_jobs(const std::string& folder, const InputLimit& limit);

/// Reads the bytes of the result of a job that has a report. Errors: those of view_file; file-unreadable for a pipe.
[[nodiscard]] Result<FileView> view_job_result(const ListedJob& job, const InputLimit& limit);

/// Returns the error about the bytes of a job's result if they are not those that the job wrote, such as a report that
/// was copied from another job. Code: result-edited.
[[nodiscard]] std::optional<Diagnostic> find_foreign_result(const ListedJob& job, std::string_view bytes);

/// Reads the result of a job that has a report. Errors: result-edited, and those of view_job_result and read_result.
[[nodiscard]] Result<StoredResult> load_job_result(const ListedJob& job, const InputLimit& limit);

/// The certificate of a job, with its content.
struct CertificateFile {
  std::string name;  ///< empty: the job wrote none, or it is no longer there
  FileView view;
};

/// Reads the certificate that a job wrote. Errors: certificate-invalid, if the file has other bytes than the job wrote,
/// and those of read_file.
[[nodiscard]] Result<CertificateFile> read_certificate_of(const ListedJob& job, const InputLimit& limit);

/// Returns why a folder or file that exists is not the folder of a batch that ended, with the remedy, as the rest of a sentence that
/// begins with its name.
[[nodiscard]] std::string describe_no_batch(const std::string& name);

}  // namespace gouge
