#include "cli/output/overwriting.h"

#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>

#include "cli/machine/machine_choice.h"
#include "cli/output/report_folder.h"
#include "lib/base/staged_file.h"

namespace gouge {
namespace {

namespace fs = std::filesystem;

/// A file that may be written: the file of an option, or one of the files of a report.
struct Target {
  const Output* output;
  std::string file;
  std::string name;  ///< its name in the folder of a report; else empty
};

bool is_file(const std::string& name) { return !name.empty() && name != "-"; }

std::vector<Target> targets_of(const Output& output) {
  if (!is_file(output.file)) return {};
  std::vector<Target> targets = {{&output, output.file, {}}};
  if (output.kind != Output::Kind::report_folder) return targets;
  for (const std::string& name : names_of_report())
    targets.push_back({&output, (fs::path(output.file) / name).string(), name});
  return targets;
}

// Returns the place to which a name leads, also if no file exists there yet.
fs::path path_of(const std::string& name) {
  const Result<std::string> target = follow_links(name);
  std::error_code failed;
  const fs::path absolute = fs::absolute(target ? *target : name, failed);
  // Fails for names that are too long, which are different files all the same.
  const fs::path canonical = fs::weakly_canonical(absolute, failed);
  return failed ? absolute.lexically_normal() : canonical;
}

bool is_same_file(const std::string& a, const std::string& b) {
  std::error_code ignored;
  return fs::equivalent(a, b, ignored) || path_of(a) == path_of(b);
}

bool is_standard_output(const std::string& file) {
  struct stat named {
  }, output{};
  return ::fstat(STDOUT_FILENO, &output) == 0 && S_ISREG(output.st_mode) && ::stat(file.c_str(), &named) == 0 &&
         named.st_dev == output.st_dev && named.st_ino == output.st_ino;
}

std::string spoken(const Target& target) { return target.output->option + " '" + target.output->file + "'"; }

std::string collision_with_input(const Target& target, const InputOption& input) {
  if (target.name.empty()) return spoken(target) + " is " + input.what + " itself; name another file";
  return spoken(target) + " would replace or remove its file " + target.name + ", which is " + input.what + " '" +
         input.file + "'; name another folder";
}

// Describes a collision. `target` belongs to a later option than `earlier`.
std::string collision_with_output(const Target& target, const Target& earlier) {
  const bool is_report = earlier.name.empty() && target.output->kind == Output::Kind::report_folder;
  const Target& file = is_report ? earlier : target;
  const Target& other = is_report ? target : earlier;
  if (other.output->kind == Output::Kind::file)
    return spoken(file) + " is the file of " + other.output->option + " as well; name another file";
  return spoken(file) + " is the " + (other.name.empty() ? "folder" : "file " + other.name) + " of " +
         other.output->option + " as well; name another file";
}

}  // namespace

std::vector<InputOption> inputs_of(const JobArguments& a) {
  std::vector<InputOption> inputs = {{"the toolpath", a.path},
                                     {"the tool library", a.tools_file},
                                     {"the accepted findings", a.baseline_file},
                                     {"the tool lengths", a.reading.tool_lengths}};
  for (const std::string& file : a.parts) inputs.push_back({"the part", file});
  for (const std::string& file : a.fixtures) inputs.push_back({"the fixture", file});
  for (const std::string& file : a.heads) inputs.push_back({"the head", file});
  if (!a.machine.empty() && !a.machine.starts_with(kMachinePreset)) inputs.push_back({"the machine", a.machine});
  if (names_stock_file(a.stock)) inputs.push_back({"the stock", a.stock});
  for (const std::string& typed : a.before) {
    const BeforeText before = split_before(typed);
    inputs.push_back({"the program before", before.path});
    if (!before.tools.empty()) inputs.push_back({"the tools of the program before", before.tools});
  }
  return inputs;
}

std::optional<Diagnostic> find_overwriting(const std::vector<InputOption>& inputs, const OutputTable& outputs) {
  std::vector<Target> earlier;
  for (const Output& output : outputs) {
    const std::vector<Target> targets = targets_of(output);
    for (const Target& target : targets) {
      for (const InputOption& input : inputs) {
        if (is_file(input.file) && is_same_file(target.file, input.file))
          return make_error("usage", collision_with_input(target, input));
      }
      for (const Target& other : earlier) {
        if (is_same_file(target.file, other.file)) return make_error("usage", collision_with_output(target, other));
      }
      if (is_standard_output(target.file))
        return make_error("usage", spoken(target) + " is where standard output goes; name another file");
    }
    earlier.insert(earlier.end(), targets.begin(), targets.end());
  }
  return std::nullopt;
}

std::string canonical_place(const std::string& name) { return path_of(name).string(); }

}  // namespace gouge
