#include "cli/batch/batch_list.h"

#include <glob.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <utility>

#include "cli/batch/job_names.h"
#include "cli/batch/toolpath_files.h"
#include "cli/commands/job_words.h"
#include "cli/output/output_file.h"
#include "cli/output/report_folder.h"
#include "lib/base/files.h"
#include "lib/base/printable_text.h"
#include "lib/json/json_file.h"

namespace gouge {
namespace {

namespace fs = std::filesystem;
using ListJson = nlohmann::json;

// Returns whether a name is a pattern. The name of an existing file is not a pattern, because browsers write "path
// [1].apt".
bool is_pattern(const std::string& file) {
  std::error_code ignored;
  return file.find_first_of("*?[") != std::string::npos && !fs::exists(file, ignored);
}

std::vector<std::string> files_like(const std::string& pattern) {
  glob_t found{};
  std::vector<std::string> files;
  if (::glob(pattern.c_str(), 0, nullptr, &found) == 0) files.assign(found.gl_pathv, found.gl_pathv + found.gl_pathc);
  ::globfree(&found);
  std::sort(files.begin(), files.end());
  return files;
}

void place_outputs(BatchJob& job, const BatchFolder& folder) {
  JobArguments& arguments = job.job();
  arguments.progress = "never";
  arguments.is_quiet = true;
  job.has_report = job.has_report && folder.has_reports;
  arguments.batch_job = job.name;
  if (job.has_report) arguments.report_folder = folder.report_of(job.name);
  if (auto* correct = std::get_if<CorrectArguments>(&job.arguments); correct != nullptr && correct->output.empty()) {
    correct->output_name = BatchFolder::corrected_name(job);
    correct->output = folder.path + "/" + correct->output_name;
  }
  job.has_own_certificate = folder.has_certificates && job.arguments.index() == 0 && arguments.certificate_file.empty();
  if (job.has_own_certificate) arguments.certificate_file = folder.path + "/" + BatchFolder::certificate_name(job);
}

// The parser requires an output. If the job names none, its output is below the folder of the batch, and is not among
// the words of the job.
constexpr const char* kNoOutput = "\x01";

Result<BatchJob> make_job(std::string name, const std::string& command, std::vector<std::string> words,
                          const std::string& path) {
  BatchJob job;
  job.name = std::move(name);
  job.words = std::move(words);
  std::vector<std::string> line = job.words;
  const bool has_output = std::ranges::any_of(line, [](const std::string& w) { return w.starts_with("--output="); });
  if (command == "correct" && !has_output) line.push_back(std::string("--output=") + kNoOutput);
  if (path.starts_with('-')) line.emplace_back("--");
  line.push_back(path);
  job.words.push_back(path);
  Result<CommandArguments> parsed = parse_command(command, line);
  if (!parsed) return parsed.error();
  job.arguments = std::move(*parsed);
  if (auto* correct = std::get_if<CorrectArguments>(&job.arguments); correct != nullptr && !has_output)
    correct->output.clear();
  return job;
}

class JobListReader {
 public:
  JobListReader(std::string file, const BatchFolder& folder)
      : file_(std::move(file)), base_(fs::path(file_).parent_path().string()), folder_(folder) {}

  Result<std::vector<BatchJob>> run() {
    constexpr std::uint64_t kMaxBytes = 256'000'000;
    const Result<std::string> bytes = read_file(file_, kMaxBytes);
    if (!bytes) return bytes.error();
    Result<JsonFile> json = parse_json(file_, *bytes, {"jobs-syntax", "jobs-duplicate-key", "a job list"});
    if (!json) return json.error();
    lines_ = &json->lines;
    read(json->root);
    if (error_) return *error_;
    return std::move(jobs_);
  }

 private:
  void fail(const std::string& message, const std::string& pointer, const char* code = "jobs-field") {
    if (!error_) error_ = make_error(code, message, file_, lines_->at(pointer));
  }

  void read(const ListJson& root) {
    if (!root.is_object())
      return fail("this is no object; expected a job list: {\"defaults\": {...}, \"jobs\": [...]}", "");
    for (const auto& [key, value] : root.items()) {
      if (key != "defaults" && key != "jobs")
        fail("a job list has no \"" + key + "\"; expected \"defaults\" and \"jobs\"", "/" + key);
    }
    const ListJson defaults = root.value("defaults", ListJson::object());
    if (!defaults.is_object()) return fail("\"defaults\" is no object; expected one of options", "/defaults");
    if (defaults.contains("name"))
      fail("\"defaults\" has a \"name\"; expected one in each job alone", "/defaults/name");
    const auto jobs = root.find("jobs");
    if (jobs == root.end() || !jobs->is_array() || jobs->empty())
      return fail("expected \"jobs\", a list with at least one job", jobs == root.end() ? "" : "/jobs");
    for (std::size_t k = 0; k < jobs->size() && !error_; ++k)
      read_job(defaults, (*jobs)[k], "/jobs/" + std::to_string(k));
  }

  // The value of a key, with its place: in the job, else in the defaults.
  struct Field {
    const ListJson* value = nullptr;
    std::string pointer;
  };
  using Fields = std::map<std::string, Field>;

  void read_job(const ListJson& defaults, const ListJson& own, const std::string& pointer) {
    if (!own.is_object()) return fail("a job is no object; expected {\"name\": ..., \"path\": ...}", pointer);
    Fields fields;
    for (const auto& [key, value] : defaults.items()) fields[key] = {&value, "/defaults/" + key};
    for (const auto& [key, value] : own.items()) fields[key] = {&value, pointer + "/" + key};
    std::erase_if(fields, [](const auto& field) { return field.second.value->is_null(); });
    const std::string name = take_text(fields, "name", "");
    const std::string command = take_text(fields, "command", "check");
    if (command != "check" && command != "correct")
      return fail("\"command\" is '" + printable(command) + "'; expected check or correct", pointer + "/command");
    const bool has_report = take_report(fields);
    std::set<std::string> found;
    const std::vector<std::string> paths = take_paths(fields, pointer, found);
    // A correction takes no baseline: to leave out that of the defaults makes no verdict better.
    const auto baseline = fields.find("baseline");
    const bool leaves_baseline = command == "correct" && baseline != fields.end() && !own.contains("baseline");
    if (leaves_baseline) fields.erase(baseline);
    JobWords words(command, base_);
    for (const auto& [key, field] : fields) {
      const Outcome added = words.add(key, *field.value);
      if (!added) return fail(called(name, paths) + added.error().message, field.pointer, "jobs-option");
    }
    const std::vector<std::string> of_files = names_of_toolpaths(paths);
    for (std::size_t k = 0; k < paths.size(); ++k) {
      std::string job_name = name.empty() ? of_files[k] : paths.size() == 1 ? name : name + " " + of_files[k];
      // A person can change a name in the list, but a pattern finds whatever lies in its folder.
      std::optional<Diagnostic> refusal;
      if (found.contains(paths[k]) && (name.empty() || !why_no_name(name))) refusal = replace_odd(job_name, paths[k]);
      add(job_name, command, words.words(), paths[k], has_report, {pointer, fields});
      if (error_) continue;
      jobs_.back().leaves_baseline = leaves_baseline;
      jobs_.back().refusal = refusal;
    }
  }

  /// A job in the list, and its options.
  struct Place {
    std::string pointer;
    const Fields& fields;

    /// Returns the place of the option that a message of the parser names, which may be in the defaults.
    [[nodiscard]] const std::string& of(const std::string& message) const {
      for (const auto& [key, field] : fields) {
        const std::size_t at = message.find("--" + key);
        const std::size_t end = at + 2 + key.size();
        if (at != std::string::npos && (end == message.size() || (!is_letter(message[end]) && message[end] != '-')))
          return field.pointer;
      }
      return pointer;
    }
  };

  // Returns whether the value can be the name of a file. The system reads a name only up to a null character, so such a
  // name would lead to another file than the one examined.
  static bool is_named(const ListJson& value) {
    return value.is_string() && !value.get_ref<const std::string&>().empty() &&
           value.get_ref<const std::string&>().find('\0') == std::string::npos;
  }

  static std::string called(const std::string& name, const std::vector<std::string>& paths) {
    return "job " + (name.empty() && !paths.empty() ? paths.front() : name) + ": ";
  }

  std::string take_text(Fields& fields, const std::string& key, const std::string& otherwise) {
    const auto found = fields.find(key);
    if (found == fields.end()) return otherwise;
    const Field field = found->second;
    fields.erase(found);
    if (is_named(*field.value)) return field.value->get<std::string>();
    fail("\"" + key + "\" is no text, empty, or holds the character U+0000; expected a text", field.pointer);
    return otherwise;
  }

  bool take_report(Fields& fields) {
    const auto found = fields.find("report");
    if (found == fields.end()) return true;
    const Field field = found->second;
    fields.erase(found);
    if (field.value->is_boolean()) return field.value->get<bool>();
    fail("\"report\" is neither true nor false; expected one of them: reports stand in the folder of the batch",
         field.pointer);
    return true;
  }

  // Adds to `found_by_pattern` the files that are like a pattern.
  std::vector<std::string> take_paths(Fields& fields, const std::string& job, std::set<std::string>& found_by_pattern) {
    const auto found = fields.find("path");
    if (found == fields.end()) {
      fail("a job has no \"path\"; expected its toolpath, or a pattern such as \"ops/*.apt\"", job);
      return {};
    }
    const Field field = found->second;
    fields.erase(found);
    const std::vector<ListJson> values =
        field.value->is_array() ? field.value->get<std::vector<ListJson>>() : std::vector<ListJson>{*field.value};
    std::vector<std::string> paths;
    for (const ListJson& value : values) {
      if (!is_named(value)) {
        fail("\"path\" holds no text, an empty one, or one with the character U+0000; expected files or patterns",
             field.pointer);
        return {};
      }
      const std::string path = JobWords("check", base_).located(value.get<std::string>());
      std::error_code ignored;
      if (path.find('\\') != std::string::npos && !fs::exists(path, ignored)) {
        fail("there is no \"path\" " + printable(path) + "; folders in it are separated by /, not by a backslash",
             field.pointer);
        return {};
      }
      if (!is_pattern(path)) {
        paths.push_back(path);
        continue;
      }
      const std::vector<std::string> found_files = files_like(path);
      if (found_files.empty())
        fail("no file is like \"path\" " + printable(path) + "; expected one at least", field.pointer);
      paths.insert(paths.end(), found_files.begin(), found_files.end());
      found_by_pattern.insert(found_files.begin(), found_files.end());
    }
    if (paths.empty()) fail("\"path\" is an empty list; expected one file at least", field.pointer);
    return paths;
  }

  void add(const std::string& name, const std::string& command, const std::vector<std::string>& words,
           const std::string& path, bool has_report, const Place& place) {
    if (error_) return;
    const std::string& pointer = place.pointer;
    const std::size_t line = lines_->at(pointer);
    if (const auto why = why_no_name(name))
      return fail("the name of a job '" + printable(name) + "' " + *why +
                      "; expected one that can name a folder: give it a \"name\"",
                  pointer);
    const auto [other, is_new] = lines_of_.try_emplace(name, line);
    if (!is_new)
      return fail("a second job is called " + name + ", as that of line " + std::to_string(other->second) +
                      "; expected a \"name\" for each, and a job of its own for each of several files called alike",
                  pointer);
    Result<BatchJob> job = make_job(name, command, words, path);
    if (!job) return fail("job " + name + ": " + job.error().message, place.of(job.error().message), "jobs-option");
    job->line = line;
    job->has_report = has_report;
    place_outputs(*job, folder_);
    jobs_.push_back(std::move(*job));
  }

  std::string file_, base_;
  const BatchFolder& folder_;
  const JsonLines* lines_ = nullptr;
  std::optional<Diagnostic> error_;
  std::map<std::string, std::size_t> lines_of_;
  std::vector<BatchJob> jobs_;
};

}  // namespace

JobArguments& BatchJob::job() {
  return std::visit([](auto& of) -> JobArguments& { return of.job; }, arguments);
}

const JobArguments& BatchJob::job() const {
  return std::visit([](const auto& of) -> const JobArguments& { return of.job; }, arguments);
}

std::string BatchJob::output() const {
  const auto* correct = std::get_if<CorrectArguments>(&arguments);
  return correct == nullptr ? std::string() : correct->output;
}

std::string BatchFolder::corrected_name(const BatchJob& job) {
  return std::string(kCorrectedFolder) + "/" + job.name + split_toolpath_name(job.job().path).ending;
}

std::string BatchFolder::certificate_name(const BatchJob& job) {
  return std::string(kCertificatesFolder) + "/" + job.name + ".gcp";
}

std::vector<std::string> BatchFolder::own_outputs(const BatchJob& job) const {
  std::vector<std::string> names;
  if (const std::string name = corrected_name(job); job.output() == path + "/" + name) names.push_back(name);
  if (job.has_own_certificate) names.push_back(certificate_name(job));
  return names;
}

Result<std::vector<BatchJob>> read_job_list(const std::string& file, const BatchFolder& folder) {
  return JobListReader(file, folder).run();
}

Result<std::vector<BatchJob>> list_jobs(const std::vector<std::string>& places, const std::vector<std::string>& words,
                                        const BatchFolder& folder) {
  const auto has_word = [&](std::string_view begin) {
    return std::ranges::any_of(words, [&](const std::string& word) { return word.starts_with(begin); });
  };
  if (!has_word("--part="))
    return make_error("usage",
                      "toolpaths need --part; a job list, which says it of each job, is one file called *.json");
  const Result<std::vector<std::string>> toolpaths = expand_folders(places, folder.path, are_of_programs(words));
  if (!toolpaths) return toolpaths.error();
  for (const std::string& path : *toolpaths) {
    std::error_code ignored;
    if (is_pattern(path) && !fs::exists(path, ignored))
      return make_error("usage", "no file is like " + printable(path) + "; expected one at least");
  }
  std::vector<std::string> names = names_of_toolpaths(*toolpaths);
  const auto refusals = settle_names(*toolpaths, names);
  if (!refusals) return refusals.error();
  std::vector<BatchJob> jobs;
  for (std::size_t k = 0; k < toolpaths->size(); ++k) {
    Result<BatchJob> job = make_job(names[k], "check", words, (*toolpaths)[k]);
    if (!job) return job.error();
    job->refusal = (*refusals)[k];
    place_outputs(*job, folder);
    jobs.push_back(std::move(*job));
  }
  return jobs;
}

}  // namespace gouge
