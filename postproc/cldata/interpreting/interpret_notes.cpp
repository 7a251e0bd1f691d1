#include "lib/base/number_text.h"
#include "postproc/cldata/interpreting/interpreter.h"

// What is reported of a file once all of it is read.

namespace gouge {
namespace {

std::string counted(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

}  // namespace

void Interpreter::write_notes() {
  Diagnostics& notes = path_.notes;
  if (renormalised_ > 0) {
    notes.push_back(make_note("path-axis-length",
                              counted(renormalised_, "tool axis vector") + " not of length 1 (worst " +
                                  exact_text(worst_axis_length_) + ") made so",
                              path_.file));
  }
  note_motion();
  note_arcs();
  if (plain_after_tilt_.count > 0) {
    notes.push_back(
        make_warning("path-plain-axis",
                     counted(plain_after_tilt_.count, "position") +
                         " of 3 numbers after one with a tilted axis: the file does not say which axis they have, so "
                         "they are not checked",
                     path_.file, plain_after_tilt_.first_line));
  }
  if (csys_told_.count > 0) {
    notes.push_back(make_note("path-csys",
                              counted(csys_told_.count, "CSYS statement") +
                                  " not applied: Creo writes positions in the machine coordinate system",
                              path_.file, csys_told_.first_line));
  }
  if (cutters_recomputed_.count > 0) {
    notes.push_back(
        make_note("path-cutter-recomputed",
                  counted(cutters_recomputed_.count, "CUTTER statement") +
                      " with e and f other than d, r, alpha and beta give: these are taken, as CAM "
                      "systems disagree about e and f",
                  path_.file, cutters_recomputed_.first_line));
  }
  if (dialect_.has_end_word && !has_end_) {
    notes.push_back(
        make_warning("path-cut-short", "the file ends without END or FINI: it may be cut short", path_.file));
  }
  if (is_block_open_) {
    notes.push_back(make_warning(
        "path-cut-short", "the last TOOL PATH has no END-OF-PATH: the file may be cut short", path_.file));
  }
  if (!path_.words_not_understood.empty()) {
    std::size_t count = 0;
    for (const auto& entry : path_.words_not_understood) count += entry.second;
    notes.push_back(make_warning("path-words",
                                 counted(count, "statement") +
                                     " with words that are not understood, taken to move "
                                     "nothing where no move is not checked for them; path info lists them",
                                 path_.file));
  }
}

void Interpreter::note_motion() {
  Diagnostics& notes = path_.notes;
  if (cutcoms_.count > 0) {
    const std::string what = counted(cutcoms_.count, "CUTCOM statement") + " on: ";
    notes.push_back(
        !was_ever_compensated_
            ? make_note("path-cutcom", what + "positions are the cutter centre, as the file or the user says",
                        path_.file, cutcoms_.first_line)
            : make_warning("path-cutcom",
                           what + "the file does not say whether its positions are the cutter centre or the "
                                  "contour, so these moves are not checked; --cutcom centre says they are",
                           path_.file, cutcoms_.first_line));
  }
  if (offsets_chosen_.count > 0) {
    notes.push_back(make_note("path-machine-text",
                              counted(offsets_chosen_.count, "text") +
                                  " for the machine's control that choose a work offset: taken as the one that "
                                  "positions are meant for",
                              path_.file, offsets_chosen_.first_line));
  }
  if (turned_setup_line_ > 0) {
    notes.push_back(make_warning("path-setup",
                                 "positions are in the axes of a turned setup, not in those of the model: the parts must "
                                 "be exported in that setup's coordinate system",
                                 path_.file, turned_setup_line_));
  }
  if (not_swept_.count > 0) {
    notes.push_back(make_note("path-not-swept",
                              counted(not_swept_.count, "time") +
                                  " the machine goes home or changes its tool, frame or sequence between two "
                                  "positions: nothing is swept there",
                              path_.file, not_swept_.first_line));
  }
  if (cycles_never_ended_.count > 0) {
    notes.push_back(make_warning("path-cycle",
                                 counted(cycles_never_ended_.count, "cycle") +
                                     " never ended by CYCLE/OFF: which positions are holes and which are motions of "
                                     "their own the file does not say, so they are not checked",
                                 path_.file, cycles_never_ended_.first_line));
  }
  if (cycles_never_begun_.count > 0) {
    notes.push_back(make_warning("path-cycle",
                                 counted(cycles_never_begun_.count, "CYCLE/OFF statement") +
                                     " without a cycle: the positions before it may be holes, so they are not checked",
                                 path_.file, cycles_never_begun_.first_line));
  }
  if (cycles_without_retract_.count > 0) {
    notes.push_back(make_note("path-cycle",
                              counted(cycles_without_retract_.count, "cycle") +
                                  " without a retract height: taken to stay at the clearance between holes",
                              path_.file, cycles_without_retract_.first_line));
  }
}

void Interpreter::note_arcs() {
  close_arcs();
  if (radius_errors_.count > 0) {
    path_.notes.push_back(make_warning("path-arc-radius",
                                       counted(radius_errors_.count, "arc") +
                                           " whose start, end and radius do not lie on one circle (off by up to " +
                                           fixed_text(worst_radius_error_mm_, 3) + " mm) not checked",
                                       path_.file, radius_errors_.first_line));
  }
  constexpr std::size_t kFewest = 3;
  if (reversing_arcs_ >= kFewest && reversing_arcs_ > 2 * smooth_arcs_) {
    path_.notes.push_back(make_warning(
        "path-arc-sense",
        counted(reversing_arcs_, "arc") + " run back against the line before them, " +
            std::to_string(smooth_arcs_) + " go on smoothly: another dialect may have written this file (--dialect)",
        path_.file));
  }
}

}  // namespace gouge
