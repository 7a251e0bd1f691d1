#include "cli/commands/reading_of_new.h"

#include <CLI/CLI.hpp>
#include <cctype>
#include <deque>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "cli/options/joint_options.h"

namespace gouge {
namespace {

constexpr const char* kGroup = "NEW alone (--paths)";
constexpr const char* kPrefix = "--new-";

using Member = std::pair<const char*, std::string ProgramReading::*>;
constexpr Member kMembers[] = {{"--tool-length", &ProgramReading::tool_length},
                               {"--tip-tolerance", &ProgramReading::tip_tolerance},
                               {"--axis-tolerance", &ProgramReading::axis_tolerance}};

using MachineMember = std::pair<const char*, std::string StatedMachine::*>;
constexpr MachineMember kMachineMembers[] = {{"--machine", &StatedMachine::machine},
                                             {"--joint-rapid-law", &StatedMachine::joint_rapid_law},
                                             {"--zero", &StatedMachine::zero}};

std::string name_for_new(const std::string& name) { return kPrefix + name.substr(name.find_first_not_of('-')); }

std::string help_of(const std::string& name) { return "As " + name + ", for NEW alone"; }

/// Returns the rows with the prefix. The names must outlive them.
template <class Arguments>
OptionRows<Arguments> with_prefix(OptionRows<Arguments> rows, std::deque<std::string>& names) {
  for (OptionRow<Arguments>& row : rows) {
    const std::string name = row.name;
    row.name = names.emplace_back(name_for_new(name)).c_str();
    row.help = help_of(name);
    row.group = kGroup;
  }
  return rows;
}

/// Replaces the facts that `given` states, which are texts.
template <class Arguments>
void replace(Arguments& facts, const Arguments& given, const OptionRows<Arguments>& rows) {
  const auto replace_with = [&](auto field) {
    if (!(given.*field).empty()) facts.*field = given.*field;
  };
  for (const OptionRow<Arguments>& row : rows) {
    if (const auto* const text = std::get_if<std::string Arguments::*>(&row.field)) replace_with(*text);
    if (const auto* const all = std::get_if<std::vector<std::string> Arguments::*>(&row.field)) replace_with(*all);
  }
}

}  // namespace

void add_reading_of_new(CLI::App& command, ProgramReading& of_new) {
  static std::deque<std::string> names;
  static const OptionRows<StatedJoints> joints = with_prefix(joint_options(), names);
  static const OptionRows<ReadingArguments> reading = with_prefix(reading_options(), names);
  const std::string usual_group = command.option_defaults()->get_group();
  const auto add = [&](const std::string& name, std::string& text) {
    const std::string type = command.get_option(name)->get_type_name();
    command.add_option(name_for_new(name), text, help_of(name))->type_name(type)->group(kGroup);
  };
  for (const auto& [name, member] : kMachineMembers) add(name, of_new.stated.*member);
  for (const auto& [name, member] : kMembers) add(name, of_new.*member);
  add_options(command, of_new.stated.joints, joints);
  add_options(command, of_new.reading, reading);
  command.option_defaults()->group(usual_group);
}

ProgramReading reading_of_new(const ProgramReading& both, const ProgramReading& of_new) {
  ProgramReading facts = both;
  if (!of_new.stated.machine.empty() || !of_new.reading.control.empty()) {
    facts = {};
    facts.input = both.input;
    for (const auto member : {&ReadingArguments::dialect, &ReadingArguments::units, &ReadingArguments::cutcom,
                              &ReadingArguments::retract_plane})
      facts.reading.*member = both.reading.*member;
    facts.reading.harmless_words = both.reading.harmless_words;
  }
  for (const auto& [name, member] : kMachineMembers)
    if (!(of_new.stated.*member).empty()) facts.stated.*member = of_new.stated.*member;
  for (const auto& [name, member] : kMembers)
    if (!(of_new.*member).empty()) facts.*member = of_new.*member;
  replace(facts.stated.joints, of_new.stated.joints, joint_options());
  replace(facts.reading, of_new.reading, reading_options());
  return facts;
}

Diagnostic with_options_of_new(Diagnostic error) {
  const std::string prefix = kPrefix;
  std::string& text = error.message;
  for (std::size_t at = text.find("--"); at != std::string::npos; at = text.find("--", at + 1)) {
    const bool is_option = at + 2 < text.size() && std::islower(static_cast<unsigned char>(text[at + 2])) != 0;
    if (is_option && text.compare(at, prefix.size(), prefix) != 0) text.replace(at, 2, prefix);
  }
  return error;
}

}  // namespace gouge
