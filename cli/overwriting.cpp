#include "cli/overwriting.h"

#include <filesystem>

namespace gouge {
namespace {

bool is_same_file(const std::string& a, const std::string& b) {
  std::error_code ignored;
  if (std::filesystem::equivalent(a, b, ignored)) return true;
  const auto plain = [&](const std::string& name) { return std::filesystem::weakly_canonical(name, ignored); };
  return plain(a) == plain(b);
}

bool is_file(const std::string& name) {
  return !name.empty() && name != "-";
}

}  // namespace

std::optional<Diagnostic> find_overwriting(const std::vector<FileOption>& inputs,
                                           const std::vector<FileOption>& outputs) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const FileOption& output = outputs[i];
    if (!is_file(output.file)) continue;
    for (const FileOption& input : inputs) {
      if (!is_file(input.file) || !is_same_file(output.file, input.file)) continue;
      return make_error("usage",
                        output.what + " '" + output.file + "' is " + input.what + " itself; name another file");
    }
    for (std::size_t k = 0; k < i; ++k) {
      if (!is_file(outputs[k].file) || !is_same_file(output.file, outputs[k].file)) continue;
      return make_error("usage", output.what + " '" + output.file + "' is the file of " + outputs[k].what +
                                     " as well; name another file");
    }
  }
  return std::nullopt;
}

std::optional<Diagnostic> find_overwriting(const JobArguments& a, const std::string& corrected) {
  std::vector<FileOption> inputs = {{"the toolpath", a.path}, {"the tool library", a.tools_file}};
  for (const std::string& file : a.parts) inputs.push_back({"the part", file});
  for (const std::string& file : a.fixtures) inputs.push_back({"the fixture", file});
  for (const std::string& file : a.heads) inputs.push_back({"the head", file});
  return find_overwriting(inputs, {{"-o", corrected},
                                   {"--json", a.json_file},
                                   {"--csv", a.csv_file},
                                   {"--sarif", a.sarif_file},
                                   {"--junit", a.junit_file}});
}

}  // namespace gouge
