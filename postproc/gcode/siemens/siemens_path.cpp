#include <algorithm>
#include <cmath>

#include "lib/base/axis_tolerance.h"
#include "lib/base/number_text.h"
#include "postproc/gcode/siemens/siemens_runner.h"

// How far the control may leave the programmed path: smoothing, compressor, and the law by which the tool turns.

namespace gouge {
namespace {

using Mode = SiemensBlending::Mode;

/// Returns whether a check by one law covers motions by another. The great circle leaves the box of the rotary joints.
bool covers(TurnLaw checked, TurnLaw run) {
  return checked == run || checked == TurnLaw::documented || (checked == TurnLaw::any && run == TurnLaw::axis);
}

TurnLaw law_of(const SiemensRow& row) {
  return row.meaning == SiemensMeaning::turn_by_axis ? TurnLaw::axis : TurnLaw::vector;
}

}  // namespace

void SiemensRunner::take_blending() {
  SiemensBlending& blending = modes_.blending;
  if (const auto* const code = words_.code_of(SiemensGroup::path_control)) {
    const SiemensMeaning meaning = code->row->meaning;
    if (meaning == SiemensMeaning::smoothing) {
      take_smoothing_cycle(*code->word);
    } else {
      blending.word = here(code->word->name);
      blending.mode = meaning == SiemensMeaning::exact_path        ? Mode::exact
                      : meaning == SiemensMeaning::smooth_distance ? Mode::distance
                      : meaning == SiemensMeaning::smooth_path     ? Mode::free
                                                                   : Mode::tolerance;
    }
  }
  if (const auto* const code = words_.code_of(SiemensGroup::compressor)) {
    blending.is_compressed = code->row->meaning == SiemensMeaning::compressor_on;
    blending.compressor = here(code->word->name);
  }
  if (words_.value("ADIS") != nullptr) blending.distance_mm = length("ADIS");
  if (words_.value("ADISPOS") != nullptr) blending.rapid_distance_mm = length("ADISPOS");
  // A value below 0 ends the tolerance.
  const auto tolerance = [](double stated) { return stated >= 0 ? stated : kUnknownValue; };
  if (const SiemensWord* const turn = words_.value("OTOL")) blending.turn_deg = tolerance(turn->value);
  if (words_.value("CTOL") != nullptr) blending.tolerance_mm = tolerance(length("CTOL"));
  if (const auto* const code = words_.code_of(SiemensGroup::turn_frame)) modes_.turn_frame = code->row;
  if (const auto* const code = words_.code_of(SiemensGroup::turn_path)) modes_.turn_path = code->row;
  if (const auto* const code = words_.code_of(SiemensGroup::rapid_kind)) modes_.rapid_kind = code->row;
  settle_path();
}

// The cycle sets the smoothing and the compressor. Without a tolerance, or with machining type 0, it sets what machine data
// state.
void SiemensRunner::take_smoothing_cycle(const SiemensWord& cycle) {
  SiemensBlending& blending = modes_.blending;
  const double tolerance = siemens_argument(cycle, 0, 0), type = siemens_argument(cycle, 1, 0);
  const bool ends = std::abs(tolerance) <= 0 || !(std::fmod(type, 10) > 0);
  blending = SiemensBlending{};
  blending.word = here("CYCLE832");
  if (ends) return;
  blending.mode = Mode::cycle;
  if (tolerance > 0) blending.tolerance_mm = tolerance * mm_per_unit();
  blending.turn_deg = siemens_argument(cycle, 2, kUnknownValue);
}

// The tolerance of G642, G643, the compressor and CYCLE832 may be one of each axis: the tool leaves its path by more. The
// cycle may switch on both smoothing and a compressor. Of ADIS and ADISPOS the stated ones count.
double SiemensRunner::path_bound() const {
  const SiemensBlending& blending = modes_.blending;
  const double together = blending.tolerance_mm * kThreeAxes;
  const double compressed = blending.is_compressed ? together : 0;
  switch (blending.mode) {
    case Mode::exact:
      return compressed;
    case Mode::distance:
      return std::fmax(blending.distance_mm, blending.rapid_distance_mm) + (is_known(compressed) ? compressed : 0);
    case Mode::tolerance:
      return together + compressed;
    case Mode::cycle:
      return blending.tolerance_mm * kSmoothingCycleShare;
    case Mode::not_stated:
    case Mode::free:
      break;
  }
  return kUnknownValue;
}

std::string SiemensRunner::why_path_open() const {
  const SiemensBlending& blending = modes_.blending;
  if (blending.mode == Mode::exact && !blending.is_compressed) return {};
  const double bound = path_bound();
  if (!setup_.tip_tolerance_mm || bound > *setup_.tip_tolerance_mm) {
    const std::string by = is_known(bound) ? display_text(bound, 4) + " mm" : "an unknown distance";
    return blending.cause() + " lets the tool leave its path by " + by +
           "; expected --tip-tolerance, or G60 with COMPOF";
  }
  return {};
}

std::string SiemensRunner::why_turn_rounded() const {
  const SiemensBlending& blending = modes_.blending;
  if (blending.mode == Mode::exact && !blending.is_compressed) return {};
  const double turn_rad = blending.turn_deg * kDegree_rad;
  if (setup_.axis_tolerance_rad && !(turn_rad > *setup_.axis_tolerance_rad)) return {};
  const std::string by = is_known(turn_rad) ? display_text(blending.turn_deg, 4) + " degrees" : "an unknown angle";
  return blending.cause() + " lets the tool turn away from its path by " + by + "; expected --axis-tolerance";
}

// Words that state another law than that of the check. Machine data choose which of the two groups counts.
std::string SiemensRunner::why_turn_open() const {
  if (motion_.tip_control() != TipControl::on) return {};
  const TurnLaws laws = setup_.laws.value_or(TurnLaws{});
  for (const SiemensRow* row : {modes_.turn_frame, modes_.turn_path}) {
    if (row == nullptr) continue;
    const TurnLaw run = law_of(*row);
    for (const bool is_feed : {true, false}) {
      const TurnLaw checked = is_feed ? laws.feeds : laws.rapids;
      if (covers(checked, run)) continue;
      return std::string(row->name) + " turns the tool by law " + turn_law_name(run) + ", and the check runs by " +
             turn_law_name(checked) + "; expected " + (is_feed ? "--feed-law" : "--rapid-law") + " documented";
    }
  }
  return {};
}

void SiemensRunner::settle_path() {
  std::string open = why_path_open();
  const std::string rounded = why_turn_rounded();
  motion_.doubt_turns(rounded);
  if (open.empty() && motion_.tip_control() == TipControl::on) open = rounded;
  if (open.empty()) open = why_turn_open();
  const SiemensRow* const rapids = modes_.rapid_kind;
  const bool runs_apart = rapids != nullptr && rapids->meaning == SiemensMeaning::rapid_apart;
  const bool runs_straight = rapids != nullptr && !runs_apart;
  const bool has_machine = motion_.mapper().has_machine();
  if (runs_straight && !has_machine) motion_.run_rapids_together();
  const bool is_other = !has_machine ? runs_apart
                        : runs_apart ? setup_.are_joint_rapids_straight
                                     : runs_straight && !setup_.are_joint_rapids_straight;
  if (open.empty() && is_other)
    open = std::string(rapids->name) + " runs rapids by law " + (runs_apart ? "independent" : "joint") +
           ", and the check by another one";
  if (open.empty())
    motion_.end_doubt(ProgramDoubt::path_control);
  else
    motion_.doubt(ProgramDoubt::path_control, std::move(open));
}

}  // namespace gouge
