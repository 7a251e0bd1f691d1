#include "cli/commands/acceptance_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <ostream>

#include "cli/output/output_file.h"
#include "cli/terminal/length_text.h"
#include "lib/base/exit_code.h"
#include "lib/base/files.h"
#include "lib/base/number_text.h"
#include "lib/base/printable_text.h"

namespace gouge {
namespace {

namespace fs = std::filesystem;

/// Returns the place of the accepted finding, its text, and the remark of the person who accepted it.
std::string text_of(const Acceptance& entry) {
  return entry.toolpath + ":" + std::to_string(entry.line) + ": " + entry.finding + "; accepted by " + entry.by +
         " on " + entry.date + ": " + entry.reason;
}

/// Returns the entries of a file; none if it is empty.
Result<std::vector<Acceptance>> entries_in(const std::string& file, const std::string& bytes) {
  return bytes.empty() ? std::vector<Acceptance>() : read_accepted(file, bytes);
}

/// Returns the error if a number is not that of an entry.
std::optional<Diagnostic> find_wrong_number(const std::string& file, const std::vector<std::uint32_t>& sorted,
                                            std::size_t count) {
  for (const std::uint32_t number : sorted) {
    if (number < 1 || number > count)
      return usage_error("--withdraw", std::to_string(number),
                         "the number of an entry of " + file + ", which has " + count_text(count, "accepted finding") +
                             "; 'gougecheck accept " + file + "' lists them");
  }
  if (const auto twice = std::ranges::adjacent_find(sorted); twice != sorted.end())
    return make_error("usage", "--withdraw names entry " + std::to_string(*twice) + " twice; expected each once");
  return std::nullopt;
}

}  // namespace

FolderLock::FolderLock(const std::string& file) {
  const fs::path folder = fs::path(file).parent_path();
  handle_ = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (handle_ >= 0) ::flock(handle_, LOCK_EX);
}

FolderLock::~FolderLock() {
  if (handle_ >= 0) ::close(handle_);
}

Result<std::vector<Acceptance>> read_acceptances(const std::string& file, const InputLimit& limit) {
  std::error_code ignored;
  // A link to a file that does not exist yet is none either: the file is written there.
  if (!fs::exists(file, ignored) && !ignored) return std::vector<Acceptance>();
  if (fs::is_fifo(fs::status(file, ignored)))
    return make_error("accepted-format", "is a pipe; expected a file that accepted findings can be added to", file);
  const Result<std::string> bytes = read_file(file, limit.max_bytes);
  if (!bytes) return bytes.error();
  return entries_in(file, *bytes);
}

std::string count_line(const std::string& file, std::size_t count) {
  return printable(file + " has " + count_text(count, "accepted finding")) + "\n";
}

void list_acceptances(const std::string& file, const std::vector<Acceptance>& entries, std::ostream& out) {
  for (std::size_t k = 0; k < entries.size(); ++k)
    out << printable(std::to_string(k + 1) + "  " + text_of(entries[k])) << "\n";
  out << count_line(file, entries.size());
}

int withdraw_acceptances(const std::string& file, std::vector<std::uint32_t> numbers, const InputLimit& limit,
                         std::ostream& out, std::ostream& err) {
  const FolderLock lock(file);
  const Result<std::string> bytes = read_file(file, limit.max_bytes);
  if (!bytes) return fail(err, {bytes.error()});
  const Result<std::vector<Acceptance>> entries = entries_in(file, *bytes);
  if (!entries) return fail(err, {entries.error()});
  std::ranges::sort(numbers);
  if (const auto wrong = find_wrong_number(file, numbers, entries->size())) return fail(err, {*wrong});
  std::vector<Acceptance> kept, withdrawn;
  for (std::size_t k = 0; k < entries->size(); ++k)
    (std::ranges::binary_search(numbers, k + 1) ? withdrawn : kept).push_back((*entries)[k]);
  if (const Outcome written = write_output(file, write_accepted(kept), out); !written)
    return fail(err, {written.error()}, kExitInternal);
  for (const Acceptance& entry : withdrawn) out << printable("withdrawn: " + text_of(entry)) << "\n";
  out << count_line(file, kept.size());
  return kExitClean;
}

}  // namespace gouge
