#include <gougecheck/path.h>

#include "cli/library/content.h"
#include "cli/library/program_machine_key.h"
#include "cli/machine/program_facts.h"
#include "cli/machine/program_files.h"
#include "cli/machine/program_machine.h"
#include "lib/base/files.h"

namespace gougecheck {
namespace {

gouge::StatedMachine stated_machine(const ProgramOptions& options) {
  gouge::StatedMachine stated;
  stated.machine = options.machine;
  stated.tool_length_mm = options.tool_length;
  stated.joints = {options.joint_limits, options.joint_points, options.joint_rates};
  stated.zero = options.zero;
  stated.joint_rapid_law = options.joint_rapid_law;
  return stated;
}

/// Returns the options as the command records them.
std::vector<gouge::OptionText> recorded(const ProgramOptions& options) {
  std::vector<gouge::OptionText> all;
  const auto add = [&](const char* key, const std::string& text) {
    if (!text.empty()) all.push_back({key, text});
  };
  const auto add_all = [&](const char* key, const std::vector<std::string>& texts) {
    for (const std::string& text : texts) add(key, text);
  };
  add("toolpath-units", options.unit);
  add_all("harmless-word", options.harmless_words);
  add("control", options.control);
  add_all("offset", options.offsets);
  add("tool-lengths", options.tool_lengths);
  add_all("start", options.start);
  add_all("tip-control-end", options.tip_control_ends);
  add("block-delete", options.block_delete);
  add("home", options.home);
  add("plain-numbers", options.plain_numbers);
  add("tip-frame", options.tip_frame);
  add("rotary-turns", options.rotary_turns);
  add("joint-rapid-law", options.joint_rapid_law);
  return all;
}

/// Returns the set-up, and adds the files that it reads to `files`.
gouge::ProgramSetup understood(const ProgramOptions& options, std::vector<gouge::InputFile>& files) {
  gouge::StatedProgram stated;
  stated.control = options.control;
  stated.offsets = options.offsets;
  stated.start = options.start;
  stated.tip_control_ends = options.tip_control_ends;
  stated.block_delete = options.block_delete;
  stated.home = options.home;
  stated.plain_numbers = options.plain_numbers;
  stated.rotary_turns = options.rotary_turns;
  stated.tip_frame = options.tip_frame;
  gouge::ProgramSetup setup = value_or_raise(gouge::understand_program(
      stated, {"offsets", "home", "block_delete", "plain_numbers", "rotary_turns", "tip_frame"}));
  if (options.tool_lengths.empty()) return setup;
  const std::string bytes = value_or_raise(gouge::read_file(options.tool_lengths));
  files.push_back(gouge::describe_input("tool-lengths", options.tool_lengths, bytes));
  gouge::take_tool_table(value_or_raise(gouge::parse_tool_lengths(options.tool_lengths, bytes)), setup);
  return setup;
}

}  // namespace

Path Path::read_program(const std::string& file, const ProgramOptions& options) {
  gouge::ReadOptions reading;
  reading.dialect = gouge::gcode_dialect();
  reading.harmless_words = options.harmless_words;
  reading.unit = gouge::unit_called(options.unit);
  if (!options.unit.empty() && !reading.unit)
    raise(gouge::make_error("usage", "unit '" + options.unit + "': expected mm or inch", file));
  std::vector<gouge::InputFile> lengths, files;
  gouge::SearchLog searches;
  std::optional<gouge::Diagnostic> unreadable;
  auto setup = std::make_shared<const gouge::ProgramSetup>(understood(options, lengths));
  const gouge::StatedMachine stated = stated_machine(options);
  if (!stated.machine.empty()) {
    std::string bytes;
    const gouge::Machine machine = value_or_raise(gouge::load_machine(stated, gouge::kMaxInputBytes, bytes));
    setup = gouge::with_machine(setup, machine, stated, std::nullopt, std::nullopt, std::nullopt);
  }
  reading.program =
      gouge::with_files_beside(setup, file, gouge::kMaxInputBytes, searches,
                               [&](const std::string& beside, const gouge::Result<std::string>& bytes) {
                                 if (bytes)
                                   files.push_back(gouge::describe_input("program-beside", beside, *bytes));
                                 else if (!unreadable)
                                   unreadable = bytes.error();
                               });
  const Path path = PathAccess::from_bytes(file, value_or_raise(gouge::read_file(file)), reading);
  if (unreadable) raise(*unreadable);
  files.insert(files.end(), lengths.begin(), lengths.end());
  return PathAccess::with_program(path,
                                  {machine_key(stated), options.joint_rapid_law, recorded(options), std::move(files)});
}

}  // namespace gougecheck
