#include <algorithm>
#include <cmath>

#include "postproc/gcode/running/program_text.h"
#include "postproc/gcode/siemens/siemens_runner.h"

// Drilling cycles as the motions that the control makes. Pecks are on the line of the hole.
// Source: Siemens, Programming Guide Cycles (PGZ), 11.02, 2.1: RTP, RFP, SDIS, DP, DPR.

namespace gouge {

void SiemensRunner::take_cycle() {
  const auto* const cycle = words_.code(SiemensMeaning::drill);
  if (words_.code(SiemensMeaning::modal_call) != nullptr) {
    if (cycle == nullptr && words_.codes().size() > 1) return lose_rest("MCALL calls a word that is no cycle", line_);
    modes_.modal_cycle = cycle == nullptr ? std::nullopt : std::optional(*cycle->word);
    modes_.open_modal_cycle.clear();
    return;
  }
  if (cycle != nullptr) drill(*cycle->word);
}

// No manual at hand states whether the cycle takes a variable at MCALL or at each of its runs.
void SiemensRunner::note_change(const std::string& variable, std::size_t line) {
  if (!modes_.modal_cycle) return;
  const std::vector<std::string>& used = modes_.modal_cycle->variables;
  const bool is_used = std::ranges::any_of(
      used, [&](const std::string& one) { return one == variable || (one == "R" && is_r_parameter(variable)); });
  if (is_used)
    modes_.open_modal_cycle = variable + ", an argument of MCALL " + modes_.modal_cycle->name + ", changes" +
                              in_line(line) + " before the cycle runs";
}

void SiemensRunner::drill(const SiemensWord& cycle) {
  const SiemensCycle* const row = find_siemens_cycle(cycle.name);
  if (row == nullptr) return lose_rest(cycle.name + " has no row", line_);
  const auto value = [&](std::size_t index) { return siemens_argument(cycle, index, kUnknownValue); };
  const double out = value(0), reference = value(1), safety = siemens_argument(cycle, 2, 0), absolute = value(3),
               relative = value(4);
  const bool has_both = is_known(absolute) && is_known(relative) && std::abs(relative) > 0;
  const double depth = is_known(absolute) ? absolute : reference - relative;
  const double above = reference + safety;
  std::string open;
  for (std::size_t i = row->known_arguments; i < cycle.arguments.size(); ++i)
    if (!cycle.arguments[i].is_empty && !(std::abs(cycle.arguments[i].value) <= 0))
      open = "an argument of " + cycle.name + " is not read";
  if (!is_known(out + above + depth)) open = "a level of " + cycle.name + " is not known";
  for (const std::size_t depth_word : {std::size_t{3}, std::size_t{4}})
    if (depth_word < cycle.arguments.size() && !cycle.arguments[depth_word].is_empty && !is_known(value(depth_word)))
      open = "the depth of " + cycle.name + " is not known";
  if (has_both) open = cycle.name + " states its depth twice";
  if (open.empty() && (!(safety >= 0) || !(depth < reference) || !(out >= above)))
    open = "the levels of " + cycle.name + " are not in their order";
  if (!modes_.plane || *modes_.plane != PlaneAxes{0, 1, 2}) open = cycle.name + " is not in the plane of G17";
  if (modes_.unit == LengthUnit::inch) open = "the unit of the arguments of " + cycle.name + " is not stated";
  if (row->form == DrillForm::not_checked) open = cycle.name + " moves across the hole";
  if (const std::string missing = missing_fact(); !missing.empty()) open = missing;
  AxisPlace at = motion_.place();
  if (open.empty() && !(at.xyz.z() >= above)) open = cycle.name + " begins below its safe level, or at an unknown one";
  const auto level = [&](double z) {
    AxisPlace place = at;
    place.xyz.z() = z;
    return place;
  };
  if (!open.empty()) {
    AxisPlace place = at;
    place.xyz.setConstant(kUnknownValue);
    return motion_.go_unchecked(MoveKind::feed, place, open);
  }
  if (row->form == DrillForm::thread) motion_.stop_spindle(false);  // tapping turns it
  motion_.go(MoveKind::rapid, level(above));
  motion_.go(MoveKind::feed, level(depth));
  if (row->form != DrillForm::feed_in_rapid_out) motion_.go(MoveKind::feed, level(above));
  motion_.go(MoveKind::rapid, level(out));
  modes_.is_moved.z() = 0;
}

}  // namespace gouge
