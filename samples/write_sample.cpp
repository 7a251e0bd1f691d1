#include "samples/write_sample.h"

#include "lib/base/files.h"
#include "lib/base/number_text.h"

namespace gouge::samples {
namespace {

std::string quoted(const std::string& text) { return "\"" + text + "\""; }

std::string file_list(const std::vector<NamedSolid>& solids) {
  std::string out = "[";
  for (const NamedSolid& solid : solids) out += (out.size() > 1 ? ", " : "") + quoted(solid.file);
  return out + "]";
}

constexpr const char* kMachineFile = "machine.json";

std::string findings_json(const std::vector<ExpectedFinding>& findings) {
  std::string out = "[";
  for (const ExpectedFinding& f : findings) {
    out += out.size() == 1 ? "\n    {" : ",\n    {";
    out += "\"line\": " + std::to_string(f.line) + ", \"state\": " + quoted(f.state) + ", \"body\": " + quoted(f.body) +
           ", \"against\": " + quoted(f.against) + ", \"depth_min\": " + fixed_text(f.depth_min, 5) +
           ", \"depth_max\": " + fixed_text(f.depth_max, 5) + "}";
  }
  return out + (findings.empty() ? "]" : "\n  ]");
}

}  // namespace

std::string expected_json(const Sample& sample) {
  std::string out = "{\n";
  const auto field = [&out](const std::string& name, const std::string& value) {
    out += "  " + quoted(name) + ": " + value + ",\n";
  };
  field("name", quoted(sample.name));
  field("about", quoted(sample.about));
  field("toolpath", quoted(sample.toolpath_file));
  field("tools", quoted("tools.json"));
  field("unit", quoted(sample.unit));
  field("parts", file_list(sample.parts));
  field("fixtures", file_list(sample.fixtures));
  field("heads", file_list(sample.heads));
  field("check_exit", std::to_string(sample.check_exit));
  field("correct_exit", std::to_string(sample.correct_exit));
  field("moves", std::to_string(sample.moves));
  if (sample.overlap > 0) field("overlap", fixed_text(sample.overlap, 5));
  if (!sample.machine.empty()) {
    field("machine", quoted(kMachineFile));
    field("by_machine", findings_json(sample.by_machine));
  }
  return out + "  \"findings\": " + findings_json(sample.findings) + "\n}\n";
}

Outcome write_sample(const Sample& sample, const std::string& folder) {
  const std::string own = folder + "/" + sample.name;
  if (const Outcome made = make_folder(own); !made) return made;
  std::vector<std::pair<std::string, std::string>> files = {
      {sample.toolpath_file, sample.toolpath}, {"tools.json", sample.tools}, {"expected.json", expected_json(sample)}};
  if (!sample.machine.empty()) files.emplace_back(kMachineFile, sample.machine);
  for (const auto* solids : {&sample.parts, &sample.fixtures, &sample.heads}) {
    for (const NamedSolid& solid : *solids) files.emplace_back(solid.file, stl_bytes(solid.solid));
  }
  for (const auto& [name, bytes] : files) {
    if (const Outcome written = write_file(own + "/" + name, bytes); !written) return written;
  }
  return Done{};
}

std::string index_text(const std::vector<Sample>& samples) {
  std::string out;
  for (const Sample& sample : samples) {
    out += sample.name + " " + std::to_string(sample.check_exit) + " " + std::to_string(sample.correct_exit) + " " +
           sample.toolpath_file + " --tools tools.json";
    for (const NamedSolid& part : sample.parts) out += " --part " + part.file;
    for (const NamedSolid& fixture : sample.fixtures) out += " --fixture " + fixture.file;
    for (const NamedSolid& head : sample.heads) out += " --head " + head.file;
    out += "\n";
  }
  return out;
}

}  // namespace gouge::samples
