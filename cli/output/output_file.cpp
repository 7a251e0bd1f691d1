#include "cli/output/output_file.h"

#include <unistd.h>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <optional>
#include <ostream>

#include "cli/output/report_folder.h"
#include "cli/terminal/print_diagnostics.h"
#include "cli/terminal/terminal.h"
#include "lib/base/exit_code.h"
#include "lib/base/files.h"
#include "postproc/image/font.h"

namespace gouge {

namespace {

namespace fs = std::filesystem;

std::optional<std::string> why_closed(const fs::path& path, int wanted) {
  if (::access(path.c_str(), wanted) == 0) return std::nullopt;
  return std::strerror(errno);
}

// Returns why a file cannot be written. A file is written beside its place and renamed, so its folder must be writable
// for us.
std::optional<std::string> why_unwritable(const std::string& named) {
  const Result<std::string> target = follow_links(named);
  if (!target) return "its symbolic links go in a circle";
  std::error_code ignored;
  const fs::path file = fs::exists(named, ignored) && !fs::is_regular_file(named, ignored) ? named : *target;
  const fs::file_status status = fs::status(file, ignored);
  if (fs::is_directory(status)) return "it is a folder";
  if (fs::exists(status) && !fs::is_regular_file(status)) return why_closed(file, W_OK);
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  if (!file.has_filename()) return "it is the name of a folder; expected a file";
  if (!fs::exists(folder, ignored)) return "the folder " + folder.string() + " does not exist; make it first";
  if (!fs::is_directory(folder, ignored)) return folder.string() + " is a file; expected a folder";
  if (const auto why = why_closed(folder, W_OK | X_OK)) return "the folder " + folder.string() + ": " + *why;
  return fs::exists(status) ? why_not_replaceable(file.string()) : std::nullopt;
}

std::optional<std::string> why_not_made(const std::string& folder) {
  const Result<std::string> target = follow_links(folder);
  if (!target) return "its symbolic links go in a circle";
  std::error_code ignored;
  fs::path there = *target;
  while (!there.empty() && !fs::exists(there, ignored)) there = there.parent_path();
  if (there.empty()) there = ".";
  if (!fs::is_directory(there, ignored)) return "a file of the name " + there.string() + " exists";
  if (const auto why = why_closed(there, W_OK | X_OK)) return there.string() + ": " + *why;
  return std::nullopt;
}

}  // namespace

Outcome PendingOutputs::add(const std::string& file, std::string_view bytes) {
  return add(file, [bytes](const PutText& put) { put(bytes); });
}

Outcome PendingOutputs::add(const std::string& file, const TextWriter& write) {
  if (file == "-") {
    for_stdout_.emplace();
    write([&](std::string_view bytes) { *for_stdout_ += bytes; });
    return Done{};
  }
  Result<StagedFile> staged = StagedFile::make(file, write);
  if (!staged) return staged.error();
  files_.push_back(std::move(*staged));
  return Done{};
}

Outcome PendingOutputs::commit(std::ostream& out) {
  for (StagedFile& file : files_) {
    if (Outcome put = file.commit(); !put) return put;
  }
  if (!for_stdout_) return Done{};
  out << *for_stdout_ << std::flush;
  if (!out) return describe_failed_output();
  return Done{};
}

Outcome write_output(const std::string& file, std::string_view bytes, std::ostream& out) {
  PendingOutputs pending;
  if (Outcome added = pending.add(file, bytes); !added) return added;
  return pending.commit(out);
}

ToolpathName split_toolpath_name(const std::string& file) {
  const std::filesystem::path name = std::filesystem::path(file).filename(), stem = name.stem();
  const std::string last = name.extension().string();
  const bool is_version = last.size() > 1 && last.find_first_not_of("0123456789", 1) == std::string::npos;
  if (!is_version || !stem.has_extension()) return {stem.string(), last};
  return {stem.stem().string(), stem.extension().string() + last};
}

Diagnostics find_unwritable(const OutputTable& outputs) {
  Diagnostics errors;
  for (const Output& output : outputs) {
    if (output.kind == Output::Kind::report_folder) {
      if (const auto why = why_not_made(output.file))
        errors.push_back(
            make_error("folder-unwritable", "cannot make the report: " + *why + "; nothing was written", output.file));
    } else if (output.file != "-") {
      if (const auto why = why_unwritable(output.file))
        errors.push_back(
            make_error("file-unwritable", "cannot write the file: " + *why + "; nothing was written", output.file));
    }
  }
  return errors;
}

namespace {

/// Returns the error for an output that would replace a file of a report or of a batch.
std::optional<Diagnostic> find_kept_file(const OutputTable& outputs, bool is_of_batch) {
  for (const Output& output : outputs) {
    if (output.kind == Output::Kind::report_folder || output.file == "-") continue;
    if (const std::string why = why_kept(output.file, is_of_batch); !why.empty())
      return make_error("usage", output.option + " '" + output.file + "' " + why);
  }
  return std::nullopt;
}

}  // namespace

RefusedOutputs find_refused(const std::vector<InputOption>& inputs, const OutputTable& outputs, bool is_of_batch) {
  std::optional<Diagnostic> wrong = find_overwriting(inputs, outputs);
  if (!wrong) wrong = find_kept_file(outputs, is_of_batch);
  if (const Result<bool> taken = is_stdout_taken(outputs); !taken) wrong = taken.error();
  if (wrong) return {{*wrong}, status_of({*wrong})};
  return {find_unwritable(outputs), kExitInternal};
}

std::optional<int> refuse_outputs(const std::vector<InputOption>& inputs, const OutputTable& outputs, std::ostream& err,
                                  bool is_of_batch) {
  const RefusedOutputs refused = find_refused(inputs, outputs, is_of_batch);
  if (refused.errors.empty()) return std::nullopt;
  return fail(err, refused.errors, refused.status);
}

Result<bool> is_svg_file(const std::string& file) {
  if (has_ending(file, ".svg")) return true;
  if (has_ending(file, ".png")) return false;
  return make_error("usage", "-o '" + file + "': the picture must be a .png or an .svg file");
}

Diagnostics find_missing_letters(const Toolpath& path, const std::vector<std::string>& meshes) {
  std::vector<std::string> names = meshes;
  names.push_back(path.file);
  for (const PathTool& tool : path.tools) names.push_back(tool.name);
  for (const Operation& operation : path.operations) names.push_back(operation.name);
  return find_missing_letters(names);
}

}  // namespace gouge
