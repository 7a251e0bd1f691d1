#include "postproc/cldata/interpreting/cutter_compensation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "lib/base/number_text.h"
#include "lib/base/tolerance.h"
#include "postproc/cldata/interpreting/reasons.h"
#include "postproc/cldata/language/text.h"

namespace gouge {
namespace {

bool is_in_xy(const Argument& argument) {
  constexpr std::array<std::string_view, 5> kWords = {"LEFT", "RIGHT", "ON", "XYPLAN", "OSETNO"};
  return argument.number || is_one_of(argument.text, kWords);
}

}  // namespace

void CutterCompensation::begin() {
  statements_.add(in_.line());
  side_ = in_.has("LEFT") ? CutcomSide::left : in_.has("RIGHT") ? CutcomSide::right : CutcomSide::unknown;
  is_across_axis_ = is_across_axis_ && std::ranges::all_of(in_.arguments, is_in_xy);
  was_ever_on_ = was_ever_on_ || is_on();
}

Cover CutterCompensation::cover(const Move& move, const std::optional<Pose>& start, const Vec3& plane_normal) const {
  const auto is_across = [&](const Vec3& axis) { return axis.cross(plane_normal).norm() <= Tolerance::kSameDirection; };
  const bool is_covered = is_across_axis_ && is_across(move.end.axis) && (!start || is_across(start->axis)) &&
                          move.curve_kind != CurveKind::spline;
  return is_covered ? Cover::wide : Cover::none;
}

bool CutterCompensation::end() {
  return std::exchange(side_, CutcomSide::none) == CutcomSide::none && was_ever_on_ && !is_centre_;
}

// Under CUTCOM the path of the program's positions is still known.
std::string_view CutterCompensation::reason() const {
  if (is_on()) return is_contour_ ? Reasons::kContour : Reasons::kCutcom;
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
      !was_ever_on_
          ? make_note("path-cutcom", what + "positions are the cutter centre, as the file or the user says",
                      in_.path.file, statements_.first_line)
          : make_warning("path-cutcom",
                         what + "the file does not say whether its positions are the cutter centre or the "
                                "contour, so moves that could touch anything within a diameter beside them are "
                                "not checked; --cutcom centre says they are",
                         in_.path.file, statements_.first_line));
}

}  // namespace gouge
