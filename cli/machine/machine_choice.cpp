#include "cli/machine/machine_choice.h"

#include <algorithm>
#include <memory>

#include "lib/base/files.h"
#include "lib/base/number_text.h"
#include "lib/base/units.h"
#include "lib/machine/linuxcnc_ini.h"
#include "lib/machine/read_machine.h"
#include "lib/machine/rotary_law.h"

namespace gouge {
namespace {

std::string degrees(double rad) { return display_text(rad / kDegree_rad, 3) + " degrees"; }

Result<TurnLaw> chosen_law(const Machine& machine, const std::string& stated, const std::optional<TurnLaw>& promised,
                           const std::string& option, const char* moves) {
  if (const auto law = turn_law_called(stated)) return *law;
  if (promised) return *promised;
  return make_error("machine-law", "the control of machine " + machine.name + " promises no law for " + moves +
                                       "; expected " + option + " vector or " + option + " axis");
}

Result<MotionLaw> law_of(const Machine& machine, const StatedMachine& stated, RapidMode rapid,
                         const MachineOptionNames& names) {
  const Control& control = machine.control;
  const Result<TurnLaw> feed = chosen_law(machine, stated.feed_law, control.feed_law, names.feed_law, "feeds");
  if (!feed) return feed.error();
  const Result<TurnLaw> rapids = chosen_law(machine, stated.rapid_law, control.rapid_law, names.rapid_law, "rapids");
  if (!rapids) return rapids.error();
  const auto axes = std::make_shared<const RotaryLaw>(machine);
  return MotionLaw(rapid, *feed == TurnLaw::axis ? axes : nullptr, *rapids == TurnLaw::axis ? axes : nullptr);
}

std::string describe_law(const Machine& machine, const StatedMachine& stated, const MachineOptionNames& names) {
  std::string text;
  if (!stated.feed_law.empty()) text += names.feed_law + " " + stated.feed_law;
  if (!stated.rapid_law.empty()) text += (text.empty() ? "" : ", ") + names.rapid_law + " " + stated.rapid_law;
  if (!stated.feed_law.empty() && !stated.rapid_law.empty()) return text;
  const Control& control = machine.control;
  return text + (text.empty() ? "" : ", ") + "control " + control.name + " of machine " + machine.name +
         (control.source.empty() ? "" : " (" + control.source + ")");
}

std::optional<Diagnostic> find_wrong_law(const std::string& stated, const std::string& option,
                                         const std::string& needed) {
  const std::optional<TurnLaw> law = turn_law_called(stated);
  const std::string found = option + " '" + stated + "': expected ";
  if (!stated.empty() && !law) return make_error("usage", found + "vector or axis");
  if (law == TurnLaw::axis && !needed.empty())
    return make_error("usage", found + needed + " beside it: rotary joints are those of a machine");
  return std::nullopt;
}

void leave_unchecked(const std::string& reason, std::size_t move, Toolpath& path) {
  const std::string_view text = lasting_text(reason);
  for (std::size_t i = move; i <= move + 1 && i < path.moves.size(); ++i) {
    Move& of = path.moves[i];
    if ((i == move || of.has_start) && (of.not_checked_reason.empty() || of.is_covered())) {
      of.not_checked_reason = text;
      of.cover = Cover::none;
    }
  }
}

}  // namespace

Result<Machine> load_machine(const std::string& typed, std::uint64_t max_bytes, std::string& bytes,
                             const MachineOptionNames& names) {
  if (typed.starts_with(kMachinePreset)) {
    const MachinePreset* const preset = find_preset(std::string_view(typed).substr(kMachinePreset.size()));
    if (preset == nullptr) {
      std::string known;
      for (const MachinePreset& one : machine_presets()) known += (known.empty() ? "" : ", ") + std::string(one.name);
      return make_error("usage",
                        names.machine + " '" + typed + "': expected a machine file, or preset: and one of " + known);
    }
    bytes = preset->text;
    return read_machine(typed, bytes);
  }
  Result<std::string> read = read_file(typed, max_bytes);
  if (!read) return read.error();
  bytes = std::move(*read);
  return is_linuxcnc_ini(bytes) ? read_linuxcnc_ini(typed, bytes) : read_machine(typed, bytes);
}

Result<std::optional<ChosenMachine>> choose_machine(const StatedMachine& stated, RapidMode rapid,
                                                    std::uint64_t max_bytes, const MachineOptionNames& names) {
  const std::string needed = stated.machine.empty() ? names.machine : "";
  if (const auto wrong = find_wrong_law(stated.feed_law, names.feed_law, needed)) return *wrong;
  if (const auto wrong = find_wrong_law(stated.rapid_law, names.rapid_law, needed)) return *wrong;
  if (stated.machine.empty()) return std::optional<ChosenMachine>();
  std::string bytes;
  Result<Machine> machine = load_machine(stated.machine, max_bytes, bytes, names);
  if (!machine) return machine.error();
  Result<MotionLaw> law = law_of(*machine, stated, rapid, names);
  if (!law) return law.error();
  std::string evidence = describe_law(*machine, stated, names);
  return std::optional(ChosenMachine{std::move(*machine), std::move(*law), std::move(evidence), std::move(bytes)});
}

Diagnostic describe_problem(const Machine& machine, const Toolpath& path, const JointProblem& problem) {
  const std::string joint = "joint " + machine.joints[problem.joint].name;
  const std::size_t line = path.moves[problem.move].line;
  switch (problem.kind) {
    case JointProblem::Kind::unreachable:
      return make_warning("machine-unreachable", "no position of the rotary joints gives this tool axis", path.file,
                          line);
    case JointProblem::Kind::limit:
      return make_warning("machine-limit",
                          joint + " would be at " + degrees(problem.value) + "; its limit is " + degrees(problem.limit),
                          path.file, line);
    case JointProblem::Kind::flip:
      return make_warning(
          "machine-flip",
          joint + " turns by " + degrees(problem.value) + " while the tool axis turns by " + degrees(problem.limit),
          path.file, line);
    case JointProblem::Kind::undecided:
      return make_warning("machine-undecided",
                          joint + " may turn by " + degrees(problem.value) +
                              " or another way that is equally near; add a position between, or set limits",
                          path.file, line);
    case JointProblem::Kind::unwind:
      return make_warning("machine-unwind", joint + " turns back by " + degrees(problem.value), path.file, line);
  }
  return {};
}

Diagnostics choose_joints_of(const Machine& machine, Toolpath& path) {
  constexpr std::size_t kMaxNotes = 20;
  JointChoice choice = choose_joints(machine, path);
  path.joints = std::make_shared<const JointPath>(std::move(choice.path));
  Diagnostics notes;
  for (const JointProblem& problem : choice.problems) {
    const Diagnostic note = describe_problem(machine, path, problem);
    if (problem.kind == JointProblem::Kind::limit || problem.kind == JointProblem::Kind::unreachable)
      leave_unchecked("the machine cannot be there: " + note.message, problem.move, path);
    if (problem.kind == JointProblem::Kind::undecided)
      leave_unchecked("the motion of the machine is undecided: " + note.message, problem.move, path);
    if (notes.size() < kMaxNotes) notes.push_back(note);
  }
  if (choice.problems.size() > kMaxNotes)
    notes.push_back(make_note("machine-more",
                              std::to_string(choice.problems.size() - kMaxNotes) + " more positions of this kind",
                              path.file));
  return notes;
}

}  // namespace gouge
