#include "cli/machine/machine_choice.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>

#include "cli/machine/start_notes.h"
#include "cli/values/parse_lengths.h"
#include "lib/base/files.h"
#include "lib/base/number_text.h"
#include "lib/base/similar_name.h"
#include "lib/base/units.h"
#include "lib/machine/joint_law.h"
#include "lib/machine/law_facts.h"
#include "lib/machine/linear_limits.h"
#include "lib/machine/linuxcnc_ini.h"
#include "lib/machine/machine.h"
#include "lib/machine/read_machine.h"
#include "lib/machine/rotary_law.h"
#include "lib/machine/tip_slack.h"
#include "postproc/gcode/running/program_setup.h"

namespace gouge {
namespace {

std::string degrees(double rad) { return display_text(rad / kDegree_rad, 3) + " degrees"; }

std::string length_range_text(const StatedMachine& stated) {
  const double middle = stated.tool_length_mm.value_or(0), half = stated.tool_length_slack_mm;
  const std::string low = display_text(middle - half, 6);
  return (half > 0 ? low + ".." + display_text(middle + half, 6) : low) + " mm";
}

/// The names of laws for a message: of feeds, or of rapids.
std::string law_words(bool is_feed) {
  return is_feed ? "vector, axis, documented, any or joint" : "vector, axis, documented, any, joint or independent";
}

/// Law of feeds that nothing states: manuals describe no other for a control with tool centre point control.
constexpr TurnLaw kUnstatedFeedLaw = TurnLaw::documented;

Result<TurnLaw> rapid_law(const Machine& machine, const std::string& stated, const std::string& option) {
  if (const auto law = turn_law_called(stated)) return *law;
  if (machine.control.rapid_law) return *machine.control.rapid_law;
  return make_error("machine-law", "the control of machine " + machine.name + " promises no law for rapids; expected " +
                                       option + " " + law_words(false));
}

/// Facts that a law of all joints needs and that are not given.
std::optional<Diagnostic> find_missing_fact(const Machine& machine, TurnLaw law,
                                            const std::optional<double>& tool_length_mm,
                                            const MachineOptionNames& names) {
  const std::string needs = "law " + std::string(turn_law_name(law)) + " on machine " + machine.name + " needs ";
  for (const MissingFact& missing : missing_facts(machine, law, tool_length_mm.has_value())) {
    const std::string& joint = machine.joints[missing.joint].name;
    if (missing.kind == MissingFact::Kind::point)
      return make_error("machine-law", needs + "the place of joint " + joint +
                                           "; expected \"point\" of this joint in a machine file, or " +
                                           names.joints.point + " " + joint + "=X,Y,Z");
    if (missing.kind == MissingFact::Kind::tool_length)
      return make_error("machine-law",
                        needs + "the length from the gauge point to the tip; expected " + names.tool_length);
    if (missing.kind == MissingFact::Kind::part_zero)
      return make_error("machine-law", needs + "the place of the part on the machine; expected " + names.zero);
  }
  return std::nullopt;
}

/// Null: the great circle, where no body needs the turn of the tool about its axis.
std::shared_ptr<const AxisLaw> axes_of(const Machine& machine, TurnLaw law, const std::optional<double>& tool_length_mm,
                                       bool has_heads) {
  switch (law) {
    case TurnLaw::vector:
      if (has_heads) return std::make_shared<const RotaryLaw>(machine, LawScope::circle);
      break;
    case TurnLaw::axis:
      return std::make_shared<const RotaryLaw>(machine);
    case TurnLaw::documented:
      return std::make_shared<const RotaryLaw>(machine, LawScope::documented);
    case TurnLaw::any:
      return std::make_shared<const RotaryLaw>(machine, LawScope::any);
    case TurnLaw::joint:
      return std::make_shared<const JointLaw>(machine, JointTiming::together, tool_length_mm);
    case TurnLaw::independent:
      return std::make_shared<const JointLaw>(machine, JointTiming::independent, tool_length_mm);
  }
  return nullptr;
}

Result<TurnLaws> laws_of(const Machine& machine, const StatedMachine& stated, RapidMode rapid,
                         const MachineOptionNames& names) {
  const TurnLaw feeds = turn_law_called(stated.feed_law).value_or(machine.control.feed_law.value_or(kUnstatedFeedLaw));
  const Result<TurnLaw> rapids = rapid_law(machine, stated.rapid_law, names.rapid_law);
  if (!rapids) return rapids.error();
  if (runs_joints(*rapids) && rapid == RapidMode::dogleg)
    return make_error("usage", names.rapid + " 'dogleg': expected straight or skip, as law " + turn_law_name(*rapids) +
                                   " states how rapids run");
  std::optional<TurnLaw> joint_rapids = turn_law_called(stated.joint_rapid_law);
  if (!joint_rapids && runs_joints(*rapids)) joint_rapids = *rapids;
  return TurnLaws{feeds, *rapids, joint_rapids ? joint_rapids : machine.control.joint_rapid_law};
}

/// Empty: nothing states the law of feeds.
std::string describe_law(const Machine& machine, const StatedMachine& stated, const MachineOptionNames& names) {
  if (stated.feed_law.empty() && !machine.control.feed_law) return {};
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
  if (!stated.feed_law.empty()) add(names.feed_law + " " + stated.feed_law);
  if (!stated.rapid_law.empty()) add(names.rapid_law + " " + stated.rapid_law);
  for (const std::string& fact : stated_texts(stated.joints, names.joints)) add(fact);
  if (!stated.zero.empty()) add(names.zero + " " + stated.zero);
  if (stated.tool_length_mm) add(names.tool_length + " " + length_range_text(stated));
  if (!stated.feed_law.empty() && !stated.rapid_law.empty()) return text;
  const Control& control = machine.control;
  add("control " + control.name + " of machine " + machine.name +
      (control.source.empty() ? "" : " (" + control.source + ")"));
  return text;
}

std::optional<Diagnostic> find_wrong_law(const std::string& stated, const std::string& option, bool is_feed,
                                         const std::string& needed) {
  const std::optional<TurnLaw> law = turn_law_called(stated);
  const std::string found = option + " '" + stated + "': expected ";
  if (!stated.empty() && (!law || (is_feed && law == TurnLaw::independent)))
    return make_error("usage", found + law_words(is_feed));
  if (law && law != TurnLaw::vector && !needed.empty())
    return make_error("usage", found + needed + " beside it: joints are those of a machine");
  return std::nullopt;
}

Result<Machine> read_stated(const std::string& typed, std::uint64_t max_bytes, std::string& bytes,
                            const MachineOptionNames& names) {
  if (typed.starts_with(kMachinePreset)) {
    const MachinePreset* const preset = find_preset(std::string_view(typed).substr(kMachinePreset.size()));
    if (preset == nullptr) {
      std::vector<std::string> known;
      for (const MachinePreset& one : machine_presets()) known.emplace_back(one.name);
      const std::string similar = find_similar_name(std::string_view(typed).substr(kMachinePreset.size()), known);
      return make_error(
          "usage", names.machine + " '" + typed + "': expected a machine file, or preset: and one of " + listed(known) +
                       (similar.empty() ? "" : "; did you mean " + std::string(kMachinePreset) + similar + "?"));
    }
    bytes = preset->text;
    return read_machine(typed, bytes);
  }
  Result<std::string> read = read_file(typed, max_bytes);
  if (!read) {
    Diagnostic error = read.error();
    if (find_preset(typed) != nullptr) error.message += "; did you mean " + std::string(kMachinePreset) + typed + "?";
    return error;
  }
  bytes = std::move(*read);
  return is_linuxcnc_ini(bytes) ? read_linuxcnc_ini(typed, bytes) : read_machine(typed, bytes);
}

void leave_move_unchecked(const std::string& reason, Move& move) {
  if (!move.not_checked_reason.empty() && !move.is_covered()) return;
  move.not_checked_reason = lasting_text(reason);
  move.cover = Cover::none;
}

/// The moves to and from a position.
void leave_unchecked(const std::string& reason, std::size_t move, Toolpath& path) {
  for (std::size_t i = move; i <= move + 1 && i < path.moves.size(); ++i) {
    if (i == move || path.moves[i].has_start) leave_move_unchecked(reason, path.moves[i]);
  }
}

/// Leaves moves unchecked whose law needs the angles of the rotary joints, where the program states the tool axis as a
/// vector: no manual states which of both solutions a control takes.
void leave_vectors_unchecked(const MotionLaw& law, bool is_turn_needed, Toolpath& path) {
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    Move& move = path.moves[i];
    const bool is_known = path.joints->end[i] && (!move.has_start || path.joints->start[i]);
    const bool is_turning = move.has_start && path.start_of(i).axis != move.end.axis;
    if (is_known || !law.is_by_axes(move) || !(is_turning || is_turn_needed)) continue;
    leave_move_unchecked(
        "the program states the tool axis as a vector, so that the angles of the rotary joints are not known, which the law "
        "of the check or a head needs; expected --feed-law vector and --rapid-law vector",
        move);
  }
}

/// Adds the exceeded limits of linear joints to `problems`. Returns a note if some cannot be compared.
Diagnostics add_linear_limits(const Machine& machine, const std::optional<double>& tool_length_mm, const Toolpath& path,
                              std::vector<JointProblem>& problems) {
  LinearLimits limits = check_linear_limits(machine, path, tool_length_mm);
  std::ranges::move(limits.problems, std::back_inserter(problems));
  std::ranges::stable_sort(problems, {}, &JointProblem::move);
  if (limits.open.empty()) return {};
  std::vector<std::string> names;
  for (const std::size_t k : limits.open) names.push_back(machine.joints[k].name);
  const bool has_points =
      std::ranges::all_of(machine.rotary, [&](std::size_t k) { return machine.joints[k].has_point; });
  const std::string why =
      !has_points       ? "state the points of the rotary joints (--joint-point) and, for a rotary head, --tool-length"
      : !tool_length_mm ? "state the tool length (--tool-length)"
                        : "one length is stated, and the path has " + std::to_string(path.tools.size()) + " tools";
  return {make_warning("machine-no-length",
                       "limits of " + std::string(names.size() == 1 ? "joint " : "joints ") + listed(names, " and ") +
                           " are not checked, because they depend on facts that are not given; " + why,
                       path.file)};
}

}  // namespace

Result<Machine> load_machine(const StatedMachine& stated, std::uint64_t max_bytes, std::string& bytes,
                             const MachineOptionNames& names) {
  Result<Machine> machine = read_stated(stated.machine, max_bytes, bytes, names);
  if (!machine) return machine;
  if (const auto wrong = state_joints(stated.joints, names.joints, *machine)) return *wrong;
  if (stated.zero.empty()) return machine;
  const std::optional<RigidTransform> zero = parse_place(stated.zero);
  if (!zero)
    return make_error("usage",
                      names.zero + " '" + stated.zero +
                          "': expected x,y,z or x,y,z,rx,ry,rz: lengths in mm, or with a unit (0.5in), then degrees");
  return place_part(std::move(*machine), *zero);
}

Result<MotionLaw> make_motion_law(const Machine& machine, const TurnLaws& laws, RapidMode rapid,
                                  const std::optional<double>& tool_length_mm, bool has_heads,
                                  const MachineOptionNames& names) {
  for (const TurnLaw law : {laws.feeds, laws.rapids}) {
    if (auto missing = find_missing_fact(machine, law, tool_length_mm, names)) return *missing;
  }
  const auto feeds = axes_of(machine, laws.feeds, tool_length_mm, has_heads);
  const auto rapids = laws.rapids == laws.feeds ? feeds : axes_of(machine, laws.rapids, tool_length_mm, has_heads);
  MotionLaw law(rapid, feeds, rapids);
  const auto any = std::make_shared<const RotaryLaw>(machine, LawScope::any);
  const auto widest = [&](TurnLaw of) { return !runs_joints(of) && of != TurnLaw::any ? any : nullptr; };
  law.set_widest(widest(laws.feeds), widest(laws.rapids));
  return law;
}

std::optional<Diagnostic> find_wrong_machine_fact(const StatedMachine& stated, const MachineOptionNames& names) {
  const std::string needed = stated.machine.empty() ? names.machine : "";
  if (auto wrong = find_wrong_law(stated.feed_law, names.feed_law, true, needed)) return wrong;
  if (auto wrong = find_wrong_law(stated.rapid_law, names.rapid_law, false, needed)) return wrong;
  if (const std::optional<TurnLaw> joints = turn_law_called(stated.joint_rapid_law);
      !stated.joint_rapid_law.empty() && (!joints || !runs_joints(*joints)))
    return make_error("usage",
                      names.joint_rapid_law + " '" + stated.joint_rapid_law + "': expected joint or independent");
  if (needed.empty()) return std::nullopt;
  std::vector<std::string> facts = stated_texts(stated.joints, names.joints);
  if (!stated.zero.empty()) facts.push_back(names.zero + " " + stated.zero);
  if (facts.empty()) return std::nullopt;
  return make_error("usage", facts.front() + ": expected " + needed + " beside it: joints are those of a machine");
}

Result<std::optional<ChosenMachine>> choose_machine(const StatedMachine& stated, RapidMode rapid,
                                                    std::uint64_t max_bytes, const MachineOptionNames& names) {
  if (const auto wrong = find_wrong_machine_fact(stated, names)) return *wrong;
  if (stated.machine.empty()) return std::optional<ChosenMachine>();
  std::string bytes;
  Result<Machine> machine = load_machine(stated, max_bytes, bytes, names);
  if (!machine) return machine.error();
  const Result<TurnLaws> laws = laws_of(*machine, stated, rapid, names);
  if (!laws) return laws.error();
  const std::optional<double> slack_mm = tip_slack_mm(*machine, *laws, stated.tool_length_slack_mm);
  if (!slack_mm)
    return make_error("machine-law",
                      "intervals of points or of the tool length need linear joints beside each other in "
                      "the chain of machine " +
                          machine->name + "; expected single values");
  Result<MotionLaw> law = make_motion_law(*machine, *laws, rapid, stated.tool_length_mm, stated.has_heads, names);
  if (!law) return law.error();
  std::string evidence = describe_law(*machine, stated, names);
  if (*slack_mm > 0 && !evidence.empty())
    evidence += ", with " + display_text(*slack_mm, 6) + " mm of tip tolerance for intervals";
  return std::optional(ChosenMachine{std::move(*machine), *laws, std::move(*law), std::move(evidence), std::move(bytes),
                                     stated.tool_length_mm, *slack_mm});
}

Diagnostic describe_problem(const Machine& machine, const Toolpath& path, const JointProblem& problem) {
  const std::string joint = "joint " + machine.joints[problem.joint].name;
  const std::size_t line = path.moves[problem.move].line;
  switch (problem.kind) {
    case JointProblem::Kind::unreachable:
    case JointProblem::Kind::in_plane:
      return make_warning("machine-unreachable", problem_text(machine, problem), path.file, line);
    case JointProblem::Kind::limit:
      return make_warning("machine-limit", problem_text(machine, problem), path.file, line);
    case JointProblem::Kind::flip:
      return make_warning(
          "machine-flip",
          joint + " turns by " + degrees(problem.value) + " while the tool axis turns by " + degrees(problem.limit),
          path.file, line);
    case JointProblem::Kind::undecided:
      return make_warning("machine-undecided", problem_text(machine, problem), path.file, line);
    case JointProblem::Kind::unwind:
      return make_warning("machine-unwind", joint + " turns back by " + degrees(problem.value), path.file, line);
  }
  return {};
}

namespace {

/// Problems of the same kind at the same limit of the same joint.
struct EqualProblems {
  JointProblem worst;
  std::size_t count = 0, first_line = 0, last_line = 0;
};

bool are_equal(const JointProblem& a, const JointProblem& b) {
  const bool is_same_limit = a.kind != JointProblem::Kind::limit || !(a.limit < b.limit || b.limit < a.limit);
  return a.kind == b.kind && a.joint == b.joint && is_same_limit;
}

/// Returns one warning for all equal problems, at the worst of them, in the order in which each occurs first.
Diagnostics describe_problems(const Machine& machine, const Toolpath& path, const std::vector<JointProblem>& problems) {
  std::vector<EqualProblems> groups;
  for (const JointProblem& one : problems) {
    const std::size_t line = path.moves[one.move].line;
    const auto group = std::ranges::find_if(groups, [&](const EqualProblems& g) { return are_equal(g.worst, one); });
    if (group == groups.end()) {
      groups.push_back({one, 1, line, line});
      continue;
    }
    ++group->count;
    group->first_line = std::min(group->first_line, line);
    group->last_line = std::max(group->last_line, line);
    const auto excess = [](const JointProblem& p) { return std::abs(p.value - p.limit); };
    if (excess(one) > excess(group->worst)) group->worst = one;
  }
  Diagnostics notes;
  for (const EqualProblems& group : groups) {
    notes.push_back(describe_problem(machine, path, group.worst));
    if (group.count == 1) continue;
    notes.back().message += "; this is the worst of " + std::to_string(group.count) + " such positions, lines " +
                            std::to_string(group.first_line) + " to " + std::to_string(group.last_line);
  }
  return notes;
}

/// Returns why a move is left open by a problem; empty: it is not. Values that differ from move to move are in the warning
/// about the worst one, so that equal reasons are one line of the findings.
std::string open_reason(const Machine& machine, const JointProblem& problem, const std::string& message) {
  const Joint& joint = machine.joints[problem.joint];
  switch (problem.kind) {
    case JointProblem::Kind::limit:
      return "the machine cannot be there: joint " + joint.name + " would be beyond its limit, " +
             joint_value_text(joint, problem.limit);
    case JointProblem::Kind::unreachable:
      return "the machine cannot be there: " + message;
    case JointProblem::Kind::in_plane:
      return "the limits of the machine are not compared: " + message;
    case JointProblem::Kind::undecided:
      return "the motion of the machine is undecided: joint " + joint.name +
             " may turn either way; add a position between, or set limits";
    case JointProblem::Kind::flip:
    case JointProblem::Kind::unwind:
      break;
  }
  return {};
}

}  // namespace

bool needs_turn(const TurnLaws& laws, bool has_heads) {
  return has_heads || runs_joints(laws.feeds) || runs_joints(laws.rapids);
}

Diagnostics choose_joints_of(const Machine& machine, const MotionLaw& law, const std::optional<double>& tool_length_mm,
                             bool is_turn_needed, Toolpath& path) {
  const bool are_stated = path.joints != nullptr && path.dialect == kProgramDialect;
  JointChoice choice =
      are_stated ? check_joints(machine, path, *path.joints) : choose_joints(machine, path, is_turn_needed);
  path.joints = std::make_shared<const JointPath>(std::move(choice.path));
  Diagnostics notes = add_linear_limits(machine, tool_length_mm, path, choice.problems);
  for (const JointProblem& problem : choice.problems) {
    const std::string reason = open_reason(machine, problem, describe_problem(machine, path, problem).message);
    if (!reason.empty()) leave_unchecked(reason, problem.move, path);
  }
  std::ranges::move(describe_problems(machine, path, choice.problems), std::back_inserter(notes));
  if (are_stated) leave_vectors_unchecked(law, is_turn_needed, path);
  if (!are_stated) std::ranges::move(describe_other_starts(machine, law, path), std::back_inserter(notes));
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    if (!path.moves[i].has_start) continue;
    const std::string open = law.why_open(path, i);
    if (!open.empty()) leave_move_unchecked("the motion of the machine is not known: " + open, path.moves[i]);
  }
  return notes;
}

}  // namespace gouge
