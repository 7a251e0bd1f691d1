#include "postproc/cldata/interpreting/cutter_compensation.h"

#include <string>

#include "lib/base/number_text.h"
#include "postproc/cldata/interpreting/reasons.h"

namespace gouge {

void CutterCompensation::begin() {
  statements_.add(in_.line());
  side_ = in_.has("LEFT") ? CutcomSide::left : in_.has("RIGHT") ? CutcomSide::right : CutcomSide::unknown;
  was_ever_on_ = was_ever_on_ || is_on();
}

bool CutterCompensation::end() { return std::exchange(side_, CutcomSide::none) == CutcomSide::none && !is_centre_; }

// The path of the program's positions is known all the same.
std::string_view CutterCompensation::reason() const {
  if (is_on()) return Reasons::kCutcom;
  return was_on_ ? Reasons::kAfterCutcom : "";
}

void CutterCompensation::note_position() {
  was_on_ = is_on();
  was_ever_on_ = was_ever_on_ || was_on_;
}

void CutterCompensation::write_note() const {
  if (statements_.count == 0) return;
  const std::string what = count_text(statements_.count, "CUTCOM statement") + " on: ";
  in_.path.notes.push_back(
      !was_ever_on_ ? make_note("path-cutcom", what + "positions are the cutter centre, as the file or the user says",
                                in_.path.file, statements_.first_line)
                    : make_warning("path-cutcom",
                                   what + "the file does not say whether its positions are the cutter centre or the "
                                          "contour, so these moves are not checked; --cutcom centre says they are",
                                   in_.path.file, statements_.first_line));
}

}  // namespace gouge
