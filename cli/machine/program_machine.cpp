#include "cli/machine/program_machine.h"

#include "cli/values/parse_lengths.h"

namespace gouge {
namespace {

std::string frame_text(const Toolpath& program) {
  return program.work_offset.empty() ? "those of the part" : "those of work offset " + program.work_offset;
}

}  // namespace

std::shared_ptr<const ProgramSetup> with_machine(const std::shared_ptr<const ProgramSetup>& setup,
                                                 const Machine& machine, const StatedMachine& stated,
                                                 const std::optional<TurnLaws>& laws,
                                                 const std::optional<double>& tip_tolerance_mm,
                                                 const std::optional<double>& axis_tolerance_rad) {
  ProgramSetup full = setup ? *setup : ProgramSetup{};
  full.machine = std::make_shared<const Machine>(machine);
  if (full.control.empty()) full.control = machine.control.program;
  if (!machine.control.start.empty()) full.start = machine.control.start + "\n" + full.start;
  if (!stated.zero.empty()) full.zero = parse_place(stated.zero);
  full.tool_length_mm = stated.tool_length_mm;
  full.tip_tolerance_mm = tip_tolerance_mm;
  full.axis_tolerance_rad = axis_tolerance_rad;
  const Control& control = machine.control;
  full.laws = laws;
  if (!laws && control.feed_law && control.rapid_law)
    full.laws = TurnLaws{*control.feed_law, *control.rapid_law, control.joint_rapid_law};
  const std::optional<TurnLaw> joint_rapids = laws ? laws->joint_rapids : control.joint_rapid_law;
  full.are_joint_rapids_straight = joint_rapids == TurnLaw::joint;
  full.feed_law = laws ? std::optional(laws->feeds) : machine.control.feed_law;
  return std::make_shared<const ProgramSetup>(std::move(full));
}

std::shared_ptr<const ProgramSetup> with_control(const std::shared_ptr<const ProgramSetup>& setup,
                                                 const ControlFacts& facts) {
  ProgramSetup full = setup ? *setup : ProgramSetup{};
  full.are_joint_rapids_straight = facts.joint_rapid_law == TurnLaw::joint;
  full.tool_length_mm = facts.tool_length_mm;
  full.tip_tolerance_mm = facts.tip_tolerance_mm;
  full.axis_tolerance_rad = facts.axis_tolerance_rad;
  return std::make_shared<const ProgramSetup>(std::move(full));
}

std::optional<Diagnostic> find_other_offset(const Toolpath& before, const Toolpath& path) {
  const bool are_programs = before.dialect == kProgramDialect && path.dialect == kProgramDialect;
  if (!are_programs || before.work_offset == path.work_offset) return std::nullopt;
  return make_error("before-place",
                    "its coordinates are " + frame_text(before) + ", and the coordinates of the toolpath are " +
                        frame_text(path) + "; expected place=X,Y,Z, or --zero and --offset of both",
                    before.file);
}

}  // namespace gouge
