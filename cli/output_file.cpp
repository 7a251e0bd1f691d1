#include "cli/output_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <optional>
#include <ostream>

#include "lib/base/files.h"

namespace gouge {
namespace {

namespace fs = std::filesystem;

std::optional<std::string> why_closed(const fs::path& path, int wanted) {
  if (::access(path.c_str(), wanted) == 0) return std::nullopt;
  return std::strerror(errno);
}

// A file is written beside its place and renamed, so its folder must be open to us and it itself need not.
std::optional<std::string> why_unwritable(const fs::path& file) {
  std::error_code ignored;
  const fs::file_status status = fs::status(file, ignored);
  if (fs::is_directory(status)) return "it is a folder";
  if (fs::exists(status) && !fs::is_regular_file(status)) return why_closed(file, W_OK);
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  if (!file.has_filename()) return "it is the name of a folder; expected a file";
  if (!fs::exists(folder, ignored)) return "the folder " + folder.string() + " does not exist; make it first";
  if (!fs::is_directory(folder, ignored)) return folder.string() + " is a file; expected a folder";
  if (const auto why = why_closed(folder, W_OK | X_OK)) return "the folder " + folder.string() + ": " + *why;
  return std::nullopt;
}

std::optional<std::string> why_not_made(const fs::path& folder) {
  std::error_code ignored;
  fs::path there = folder;
  while (!there.empty() && !fs::exists(there, ignored)) there = there.parent_path();
  if (there.empty()) there = ".";
  if (!fs::is_directory(there, ignored)) return "a file of the name " + there.string() + " exists";
  if (const auto why = why_closed(there, W_OK | X_OK)) return there.string() + ": " + *why;
  return std::nullopt;
}

}  // namespace

Outcome write_output(const std::string& file, std::string_view bytes, std::ostream& out) {
  if (file != "-") return write_file(file, bytes);
  out << bytes;
  return Done{};
}

Diagnostics find_unwritable(const std::vector<std::string>& files) {
  Diagnostics errors;
  for (const std::string& file : files) {
    if (file.empty() || file == "-") continue;
    if (const auto why = why_unwritable(file))
      errors.push_back(make_error("file-unwritable", "cannot write the file: " + *why + "; nothing was written", file));
  }
  return errors;
}

Diagnostics find_unwritable(const JobArguments& a, const std::string& corrected) {
  Diagnostics errors = find_unwritable({corrected, a.json_file, a.csv_file, a.sarif_file, a.junit_file});
  if (a.report_folder.empty()) return errors;
  if (const auto why = why_not_made(a.report_folder))
    errors.push_back(make_error("folder-unwritable", "cannot make the report: " + *why + "; nothing was written",
                                a.report_folder));
  return errors;
}

}  // namespace gouge
