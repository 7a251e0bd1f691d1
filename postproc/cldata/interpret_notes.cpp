#include "lib/base/number_text.h"
#include "postproc/cldata/interpreter.h"

// What is told of a file's motion once all of it is read.

namespace gouge {
namespace {

std::string counted(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

}  // namespace

void Interpreter::note_motion() {
  Diagnostics& notes = path_.notes;
  if (cutcoms_ > 0) {
    const std::string what = counted(cutcoms_, "CUTCOM statement") + " on: ";
    notes.push_back(
        !was_ever_compensated_
            ? make_note("path-cutcom", what + "positions are the cutter centre, as the file or the user says",
                        path_.file, first_cutcom_line_)
            : make_warning("path-cutcom",
                           what + "the file does not say whether its positions are the cutter centre or the "
                                  "contour, so these moves are not checked; --cutcom centre says they are",
                           path_.file, first_cutcom_line_));
  }
  if (offsets_chosen_ > 0) {
    notes.push_back(make_note("path-machine-text",
                              counted(offsets_chosen_, "text") +
                                  " for the machine's control that choose a work offset: taken as the one that "
                                  "positions are meant for",
                              path_.file, first_offset_line_));
  }
  if (turned_setup_line_ > 0) {
    notes.push_back(make_warning("path-setup",
                                 "positions are in the axes of a turned setup, not in those of the model: the parts must "
                                 "be exported in that setup's coordinate system",
                                 path_.file, turned_setup_line_));
  }
  if (not_swept_ > 0) {
    notes.push_back(make_note("path-not-swept",
                              counted(not_swept_, "time") +
                                  " the machine goes home or changes its tool, frame or sequence between two "
                                  "positions: nothing is swept there",
                              path_.file, first_not_swept_line_));
  }
  if (cycles_never_ended_ > 0) {
    notes.push_back(make_warning("path-cycle",
                                 counted(cycles_never_ended_, "cycle") +
                                     " never ended by CYCLE/OFF: which positions are holes and which are motions of "
                                     "their own the file does not say, so they are not checked",
                                 path_.file, first_cycle_never_ended_));
  }
  if (cycles_never_begun_ > 0) {
    notes.push_back(make_warning("path-cycle",
                                 counted(cycles_never_begun_, "CYCLE/OFF statement") +
                                     " without a cycle: the positions before it may be holes, so they are not checked",
                                 path_.file, first_cycle_never_begun_));
  }
  if (cycles_without_retract_ > 0) {
    notes.push_back(make_note("path-cycle",
                              counted(cycles_without_retract_, "cycle") +
                                  " without a retract height: taken to stay at the clearance between holes",
                              path_.file, first_cycle_without_retract_));
  }
}

void Interpreter::note_arcs() {
  close_arcs();
  if (radius_errors_ > 0) {
    path_.notes.push_back(make_warning("path-arc-radius",
                                       counted(radius_errors_, "arc") +
                                           " whose start, end and radius do not lie on one circle (off by up to " +
                                           fixed_text(worst_radius_error_mm_, 3) + " mm) not checked",
                                       path_.file, first_radius_error_line_));
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
