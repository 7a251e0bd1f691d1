#include "cli/commands/batch_results.h"

#include <exception>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <utility>

#include "cli/output/report_folder.h"
#include "lib/base/file_kind.h"
#include "lib/base/sha256.h"
#include "lib/json/json_file.h"
#include "lib/verify/certificate_text.h"

namespace gouge {
namespace {

namespace fs = std::filesystem;

/// Returns the error about a summary that is not the one that the manifest of the batch lists; none without a manifest.
std::optional<Diagnostic> find_edited_summary(const std::string& folder, const std::string& summary,
                                              std::string_view bytes) {
  std::error_code ignored;
  if (!fs::exists(fs::path(folder) / kManifestName, ignored)) return std::nullopt;
  const Result<std::optional<ReportManifest>> manifest = manifest_in(folder);
  if (!manifest) return manifest.error();
  if (*manifest && (*manifest)->has(describe_bytes(kBatchSummaryName, bytes))) return std::nullopt;
  return make_error("result-edited",
                    std::string("is not the summary that the batch wrote, by its SHA-256 in ") + kManifestName +
                        "; restore it, or run the batch again with --force",
                    summary);
}

/// Reads the object of a job in the summary. Throws std::exception if it is none.
ListedJob job_of(const nlohmann::json& object, const std::string& folder) {
  ListedJob job{object.at("job"), object.at("verdict")};
  job.command = object.at("command");
  if (const auto& status = object.at("status"); !status.is_null()) job.status = status.get<int>();
  job.messages = object.at("messages").get<std::vector<std::string>>();
  if (const auto& report = object.at("report"); !report.is_null()) {
    const fs::path page = fs::path(folder) / report.get<std::string>();
    job.report_file = page.string();
    job.result_file = fs::path(page).replace_filename(kResultName).string();
  }
  for (const auto& output : object.at("outputs")) {
    const std::string name = output.at("file");
    const std::string file = (fs::path(folder) / name).string();
    const std::string sha256 = output.at("sha256");
    if (file == job.result_file) job.result_sha256 = sha256;
    if (name.starts_with('/') || fs::path(name).parent_path() == kCertificatesFolder)
      job.others.push_back({file, sha256});
  }
  return job;
}

/// Returns whether a file is a certificate, by its first bytes or its ending.
bool is_certificate(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string begin(kCertificateMagic.size(), '\0');
  stream.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  return begin == kCertificateMagic || begin == kStockCertificateMagic || has_ending(file, ".gcp");
}

Diagnostic other_certificate(const std::string& file, std::string_view bytes) {
  if (const std::string stand_in = describe_stand_in({}, bytes); !stand_in.empty())
    return make_error("certificate-invalid", stand_in, file);
  return make_error("certificate-invalid",
                    std::string("is not the certificate that the job wrote, by its SHA-256 in ") + kBatchSummaryName +
                        "; restore it, or run the batch again",
                    file);
}

}  // namespace

Result<std::vector<ListedJob>> read_batch_jobs(const std::string& folder, const InputLimit& limit) {
  const std::string file = (fs::path(folder) / kBatchSummaryName).string();
  const Result<std::string> bytes = read_file(file, limit.max_bytes);
  if (!bytes) return bytes.error();
  const Result<JsonFile> json = parse_json(file, *bytes, {"result-syntax", "result-syntax", "the summary of a batch"});
  if (!json) return json.error();
  std::vector<ListedJob> jobs;
  try {
    if (json->root.at("format") != "gougecheck-batch") throw std::invalid_argument("another format");
    if (const auto edited = find_edited_summary(folder, file, *bytes)) return *edited;
    for (const auto& job : json->root.at("jobs")) jobs.push_back(job_of(job, folder));
  } catch (const std::exception&) {
    return make_error("result-format", "is no summary of a batch; expected the folder of batch -o", file);
  }
  return jobs;
}

Result<FileView> view_job_result(const ListedJob& job, const InputLimit& limit) {
  std::error_code ignored;
  if (fs::exists(job.result_file, ignored) && !fs::is_regular_file(job.result_file, ignored))
    return make_error("file-unreadable", "is no plain file; expected the result that the batch wrote", job.result_file);
  return view_file(job.result_file, limit.max_bytes);
}

std::optional<Diagnostic> find_foreign_result(const ListedJob& job, std::string_view bytes) {
  if (job.result_sha256.empty() || sha256_of(bytes) == job.result_sha256) return std::nullopt;
  return make_error("result-edited",
                    "is not the result that the batch wrote for job " + job.name + ", by its SHA-256 in " +
                        kBatchSummaryName + "; restore the report, or run the batch again with --force",
                    job.result_file);
}

Result<StoredResult> load_job_result(const ListedJob& job, const InputLimit& limit) {
  const Result<FileView> view = view_job_result(job, limit);
  if (!view) return view.error();
  Result<StoredResult> result = read_result(job.result_file, view->bytes);
  if (!result) return result;
  if (auto foreign = find_foreign_result(job, view->bytes)) return *foreign;
  return result;
}

Result<CertificateFile> read_certificate_of(const ListedJob& job, const InputLimit& limit) {
  std::error_code ignored;
  for (const WrittenFile& written : job.others) {
    if (!fs::is_regular_file(written.file, ignored) || !is_certificate(written.file)) continue;
    Result<FileView> view = view_file(written.file, limit.max_bytes);
    if (!view) return view.error();
    if (sha256_of(view->bytes) != written.sha256) return other_certificate(written.file, view->bytes);
    return CertificateFile{written.file, std::move(*view)};
  }
  return CertificateFile{};
}

std::string describe_no_batch(const std::string& name) {
  std::error_code ignored;
  const fs::path path(name);
  if (!fs::is_directory(path, ignored)) return "is a file; expected the folder of another batch";
  if (is_interrupted_batch(name)) return kIsInterrupted;
  if (fs::exists(result_in(name), ignored)) return "is the report of one job; expected the folder of another batch";
  return "has neither the results of a batch nor those of a job";
}

}  // namespace gouge
