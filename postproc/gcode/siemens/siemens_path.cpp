#include <algorithm>
#include <cmath>

#include "lib/base/number_text.h"
#include "postproc/gcode/siemens/siemens_runner.h"

// How far the control may leave the programmed path: smoothing, compressor, and the law by which the tool turns.

namespace gouge {
namespace {

using Mode = SiemensBlending::Mode;

/// Returns whether a check by one law covers motions by another.
bool covers(TurnLaw checked, TurnLaw run) {
  return checked == run || checked == TurnLaw::documented || checked == TurnLaw::any;
}

TurnLaw law_of(const SiemensRow& row) {
  return row.meaning == SiemensMeaning::turn_by_axis ? TurnLaw::axis : TurnLaw::vector;
}

}  // namespace

void SiemensRunner::take_blending() {
  SiemensBlending& blending = modes_.blending;
  if (const auto* const code = words_.code_of(SiemensGroup::path_control)) {
    using Meaning = SiemensMeaning;
    const Meaning meaning = code->row->meaning;
    if (meaning == Meaning::smoothing) {
      take_smoothing_cycle(*code->word);
    } else {
      blending.word = here(code->word->name);
      blending.mode = meaning == Meaning::exact_path        ? Mode::exact
                      : meaning == Meaning::smooth_distance ? Mode::distance
                      : meaning == Meaning::smooth_path     ? Mode::free
                                                            : Mode::tolerance;
    }
  }
  if (const auto* const code = words_.code_of(SiemensGroup::compressor))
    blending.is_compressed = code->row->meaning == SiemensMeaning::compressor_on;
  if (words_.value("ADIS") != nullptr) blending.distance_mm = length("ADIS");
  if (words_.value("CTOL") != nullptr) blending.tolerance_mm = length("CTOL");
  if (const auto* const code = words_.code_of(SiemensGroup::turn_frame)) modes_.turn_frame = code->row;
  if (const auto* const code = words_.code_of(SiemensGroup::turn_path)) modes_.turn_path = code->row;
  if (const auto* const code = words_.code_of(SiemensGroup::rapid_kind)) modes_.rapid_kind = code->row;
  settle_path();
}

// The cycle sets the smoothing and the compressor. Without a tolerance it sets what machine data state.
void SiemensRunner::take_smoothing_cycle(const SiemensWord& cycle) {
  SiemensBlending& blending = modes_.blending;
  const double tolerance = siemens_argument(cycle, 0, 0);
  const bool ends = std::abs(tolerance) <= 0;
  blending = {ends ? Mode::not_stated : Mode::tolerance, !ends, here("CYCLE832"), kUnknownValue,
              tolerance > 0 ? tolerance * mm_per_unit() : kUnknownValue};
}

std::string SiemensRunner::why_path_open() const {
  const SiemensBlending& blending = modes_.blending;
  if (blending.mode == Mode::exact && !blending.is_compressed) return {};
  double bound = kUnknownValue;
  if (blending.mode == Mode::exact) bound = 0;
  if (blending.mode == Mode::distance) bound = blending.distance_mm;
  if (blending.mode == Mode::tolerance) bound = blending.tolerance_mm;
  if (blending.is_compressed) {
    const bool is_known_bound = is_known(bound) && is_known(blending.tolerance_mm);
    bound = is_known_bound ? bound + blending.tolerance_mm : kUnknownValue;
    // CYCLE832 has one tolerance for both.
    if (blending.mode == Mode::tolerance) bound = blending.tolerance_mm;
  }
  if (setup_.tip_tolerance_mm && !(bound > *setup_.tip_tolerance_mm)) return {};
  const std::string by = is_known(bound) ? display_text(bound, 4) + " mm" : "an unknown distance";
  return blending.word + " lets the tool leave its path by " + by + "; expected --tip-tolerance, or G60 with COMPOF";
}

// Words that state another law than that of the check. Machine data choose which of the two groups counts.
std::string SiemensRunner::why_turn_open() const {
  if (motion_.tip_control() != TipControl::on) return {};
  const TurnLaws laws = setup_.laws.value_or(TurnLaws{});
  for (const SiemensRow* row : {modes_.turn_frame, modes_.turn_path}) {
    if (row == nullptr) continue;
    const TurnLaw run = law_of(*row);
    for (const TurnLaw checked : {laws.feeds, laws.rapids}) {
      if (covers(checked, run)) continue;
      return std::string(row->name) + " turns the tool by law " + turn_law_name(run) + ", and the check runs by " +
             turn_law_name(checked) + "; expected --law documented";
    }
  }
  return {};
}

void SiemensRunner::settle_path() {
  std::string open = why_path_open();
  if (open.empty()) open = why_turn_open();
  const SiemensRow* const rapids = modes_.rapid_kind;
  const bool runs_apart = rapids != nullptr && rapids->meaning == SiemensMeaning::rapid_apart;
  const bool runs_straight = rapids != nullptr && !runs_apart;
  const bool is_other =
      runs_apart ? setup_.are_joint_rapids_straight : runs_straight && !setup_.are_joint_rapids_straight;
  if (open.empty() && motion_.mapper().has_machine() && is_other)
    open = std::string(rapids->name) + " runs rapids by law " + (runs_apart ? "independent" : "joint") +
           ", and the machine states another one";
  if (open.empty())
    motion_.end_doubt(ProgramDoubt::path_control);
  else
    motion_.doubt(ProgramDoubt::path_control, std::move(open));
}

}  // namespace gouge
