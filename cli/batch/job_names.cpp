#include "cli/batch/job_names.h"

#include <filesystem>
#include <map>

#include "lib/base/printable_text.h"
#include "lib/base/sha256.h"

namespace gouge {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxBytes = 100;

bool are_one_place(const std::string& a, const std::string& b) {
  return fs::absolute(a).lexically_normal() == fs::absolute(b).lexically_normal();
}

// Returns a name for a job whose file has a `name` that no job can have: odd characters are replaced by _, a long name
// is cut, and `digits` of the hash of its place are added.
std::string safe_name(const std::string& name, const std::string& place, std::size_t digits = 8) {
  constexpr std::size_t kMaxKept = 32;
  std::string safe;
  for (std::size_t at = 0; at < name.size();) {
    const std::optional<CodePoint> code = decode_utf8(name, at);
    const std::string character = name.substr(at, code ? code->bytes : 1);
    at += character.size();
    if (safe.size() + character.size() > kMaxKept) break;
    const bool is_odd = character == "/" || character == "\\" || printable(character) != character;
    safe += is_odd ? "_" : character;
  }
  if (safe.empty() || safe.front() == '.' || safe.front() == '-' || safe.front() == ' ') safe.insert(0, "_");
  return safe + "_" + sha256_of(place).substr(0, digits);
}

}  // namespace

std::optional<std::string> why_no_name(const std::string& name) {
  if (name.empty()) return "is empty";
  if (name.size() > kMaxBytes) return "has more than " + std::to_string(kMaxBytes) + " bytes";
  if (name.front() == '.' || name.front() == '-') return std::string("begins with ") + name.front();
  if (name.find('/') != std::string::npos) return "holds a /";
  if (name.front() == ' ' || name.back() == ' ') return "begins or ends with a blank";
  if (printable(name) != name) return "holds characters that cannot be printed";
  return std::nullopt;
}

std::optional<Diagnostic> replace_odd(std::string& name, const std::string& path) {
  const auto why = why_no_name(name);
  if (!why) return std::nullopt;
  const Diagnostic error = make_error(
      "job-name",
      "the name of a job, '" + printable(name) + "', " + *why +
          "; expected a file name that can name a folder: rename the file, or give the job a \"name\" in a job list",
      printable(path));
  name = safe_name(name, path);
  return error;
}

Result<std::vector<std::optional<Diagnostic>>> settle_names(const std::vector<std::string>& toolpaths,
                                                            std::vector<std::string>& names) {
  std::vector<std::optional<Diagnostic>> refusals(names.size());
  std::map<std::string, std::string> files;
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (why_no_name(names[k])) continue;
    const auto [other, is_new] = files.try_emplace(names[k], toolpaths[k]);
    if (is_new) continue;
    const std::string said = "two jobs would be called " + printable(names[k]) + ": " + printable(other->second) +
                             " and " + printable(toolpaths[k]) +
                             "; expected files of different names, or a job list with names";
    if (are_one_place(other->second, toolpaths[k])) return make_error("usage", said);
    refusals[k] = make_error("job-name", said, printable(toolpaths[k]));
    names[k] = safe_name(names[k], toolpaths[k]);
  }
  for (std::size_t k = 0; k < names.size(); ++k) {
    const std::string name = names[k];
    if (!refusals[k] && !(refusals[k] = replace_odd(names[k], toolpaths[k]))) continue;
    constexpr std::size_t kMaxDigits = 64;
    std::size_t digits = 8;
    while (!files.try_emplace(names[k], toolpaths[k]).second) {
      if (digits == kMaxDigits) return make_error("usage", printable(toolpaths[k]) + " is given twice; expected once");
      names[k] = safe_name(name, toolpaths[k], digits *= 2);
    }
  }
  return refusals;
}

}  // namespace gouge
