#include <array>
#include <cmath>
#include <cstddef>

#include "tests/laws/expander_statements.h"

// Positions, arcs, splines and holes of the mutation law's own reader.

namespace gouge::laws {
namespace {

constexpr double kUnitOff = 1e-3;
constexpr double kSame = 1e-9;

bool is_unit(const double* v) { return std::abs(Vec3(v[0], v[1], v[2]).norm() - 1) <= kUnitOff; }

// Without what parts words from each other.
std::string letters_of(std::string_view text) {
  std::string letters;
  for (const char c : text) {
    if (std::string_view(",/() \t").find(c) == std::string_view::npos) letters += c;
  }
  return letters;
}

}  // namespace

void StatementExpander::emit(const std::optional<Pose>& start, const Pose& to, std::optional<CurvePoints> curve) {
  out_.motions.push_back({line_, start, to, curve, now_.tool, now_.diameter_mm});
}

// The axis of a position of three numbers.
bool StatementExpander::axis_of_three(Vec3& axis) {
  const Vec3 plain = now_.frame.turned(now_.plain_axis);
  // Posts that write the axis of every position under MULTAX, and of none without it.
  const bool is_by_multax = is("apt-autodesk") || is("apt-camplete") || is("apt-mori");
  const bool is_known =
      is("apt-solidworks-cam") || is("apt-creo") || is("camworks-clt") || (is_by_multax && now_.multax != Multax::on);
  axis = is("nx-clsf") ? now_.axis : is_known ? now_.frame.turned(Vec3::UnitZ()) : plain;
  if (is("nx-clsf") || is_known || now_.multax == Multax::off) return true;
  if (!now_.has_moved || (now_.axis - axis).norm() <= kSame) return true;
  uncertainty("an axis that is +Z or the one before");
  return false;
}

bool StatementExpander::pose_of(const double* v, std::size_t count, Pose& pose) {
  pose.tip = now_.frame.placed(now_.mm * Vec3(v[0], v[1], v[2]));
  if (count == 3) return axis_of_three(pose.axis);
  if (!is_unit(v + 3)) {
    uncertainty("an axis that is no unit vector");
    return false;
  }
  pose.axis = now_.frame.turned(Vec3(v[3], v[4], v[5])).normalized();
  return true;
}

void StatementExpander::positions(const std::vector<double>& v) {
  const std::size_t n = v.size();
  const bool is_single = is("nx-clsf") || is("apt-solidworks-cam") || is("camworks-clt") || is("goto-list");
  std::size_t stride = 0;
  if (n == 3)
    stride = 3;
  else if (is_single)
    stride = n == 6 ? 6 : 0;
  else if (now_.multax == Multax::on)
    stride = n % 6 == 0 ? 6 : 0;
  else if (n == 6 && is_unit(&v[3])) {
    const bool may_be_two = now_.multax == Multax::off || is("apt-creo") || is("apt-nccs");
    stride = may_be_two ? 0 : 6;
  } else if (n % 3 == 0) {
    stride = n % 6 == 0 && is_unit(&v[3]) && is_unit(&v[n - 3]) ? 0 : 3;
  }
  if (stride == 0) return uncertainty("one position or several");
  if (now_.arc && n > stride && !is("apt-creo") && !is("apt-nccs")) return uncertainty("an arc to several positions");
  const std::optional<StatedArc> arc = now_.arc;
  for (std::size_t i = 0; i < n && out_.uncertainties.empty(); i += stride) {
    Pose to;
    if (!pose_of(&v[i], stride, to)) return;
    now_.arc = arc;
    move_to(to);
  }
}

void StatementExpander::move_to(const Pose& to) {
  if (is("nx-clsf") && !now_.is_block_open) return uncertainty("a position outside a block");
  if (is("nx-clsf") && !now_.diameter_mm) return uncertainty("a block without its tool");
  if (!now_.is_frame_said && now_.has_frames) return uncertainty("a section without its frame");
  if (now_.is_compensated && !now_.is_cutter_centre) return uncertainty("a compensated position");
  if (!now_.lost_word.empty()) return uncertainty(now_.lost_word);
  if (!now_.unknown_word.empty()) return uncertainty(now_.unknown_word);
  if (!now_.tool_uncertainty.empty()) return uncertainty(now_.tool_uncertainty);
  if (!now_.cutter_uncertainty.empty()) return uncertainty(now_.cutter_uncertainty);
  if (!now_.matrix_uncertainty.empty()) return uncertainty(now_.matrix_uncertainty);
  if (now_.diameter_mm && *now_.diameter_mm < 0) return uncertainty("a tool whose cutter nothing defines");
  const bool is_on_arc = now_.arc.has_value();
  if (now_.cycle) {
    if (is_on_arc || !now_.cycle->contradicted.empty())
      return uncertainty("a hole of the cycle of line " + std::to_string(now_.cycle->line) +
                         ", or none: " + now_.cycle->contradicted);
    if (!now_.cycle->stated) return uncertainty(now_.cycle->contradicted);
    hole(to);
  } else if (is_on_arc) {
    if (!now_.at) return uncertainty("an arc from nowhere");
    std::string why;
    const std::optional<CurvePoints> curve = arc_points(*now_.arc, now_.at->tip, to.tip, why);
    if (!curve) return uncertainty(why);
    emit(now_.at, to, curve);
    now_.at = to;
  } else {
    emit(now_.at, to);
    now_.at = to;
  }
  now_.arc.reset();
  now_.axis = to.axis;
  now_.is_behind_cycle = false;
  now_.step_from.reset();
  if (!now_.cycle) now_.positions_without_cycle = is_on_arc || now_.is_rapid ? 0 : now_.positions_without_cycle + 1;
  now_.is_rapid = false;
  ++now_.positions_without_cutcom;
  now_.has_moved = now_.has_block_moved = true;
  now_.is_cutter_new = false;
  if (now_.tool && now_.diameter_mm) now_.known_tools[*now_.tool] = *now_.diameter_mm;
}

void StatementExpander::hole(const Pose& at) {
  const StatedCycle& stated = *now_.cycle->stated;
  const auto above = [&](const Vec3& tip, double height) { return Pose{tip + now_.mm * height * at.axis, at.axis}; };
  const Pose clear = above(at.tip, stated.clearance);
  if (now_.at) {
    const double height = (now_.at->tip - at.tip).dot(at.axis) / now_.mm;
    const double over = std::max(height, stated.clearance);
    const Pose up = above(now_.at->tip, over - height), across = above(at.tip, over);
    // How the tool turns on its way to a hole of another axis is the machine's own business.
    if ((now_.at->axis - at.axis).norm() <= kSame) {
      emit(now_.at, up);
      emit(up, across);
      emit(across, clear);
    }
  } else
    emit(std::nullopt, clear);
  emit(clear, above(at.tip, stated.bottom));
  now_.at = above(at.tip, stated.retract);
  emit(above(at.tip, stated.bottom), *now_.at);
  now_.cycle->last_hole = at.tip;
  ++now_.cycle->holes;
}

void StatementExpander::step_by(const std::vector<double>& v) {
  const bool is_hole = now_.cycle && now_.cycle->last_hole;  // goes on from the hole, not from above it
  if (!is_hole && now_.is_behind_cycle) return uncertainty("a step from a hole or from above it");
  const std::optional<Pose> start = now_.at ? now_.at : now_.step_from;
  if (!start || (v.size() != 3 && v.size() != 1)) return uncertainty("a step from a place that is not known");
  Pose to = *start;
  const Vec3 step = v.size() == 1 ? Vec3(v[0] * now_.axis) : now_.frame.turned(Vec3(v[0], v[1], v[2]));
  if (is_hole) to.tip = *now_.cycle->last_hole;
  to.tip += now_.mm * step;
  move_to(to);
}

void StatementExpander::from(const std::vector<double>& v, bool is_home) {
  if (v.size() != 3 && v.size() != 6) return uncertainty("a place without its numbers");
  Pose to;
  if (!pose_of(v.data(), v.size(), to)) return;
  if (!is_home) now_.at.reset();
  if (out_.uncertainties.empty()) move_to(to);
}

void StatementExpander::arc(const LooseStatement& s) {
  std::vector<double> v;
  std::string words;
  for (const LooseArgument& argument : s.arguments) {
    if (argument.number)
      v.push_back(*argument.number);
    else
      words += argument.text + ",";
  }
  const std::size_t n = v.size();
  StatedArc stated;
  double sense = 1;
  const bool is_plain = words.empty() && (n == 6 || n == 7 || n == 11);
  bool is_whole = is_plain;
  if (is("nx-clsf")) {
    sense = -1;
    is_whole = is_plain || ((n == 12 || n == 8) && words == "TIMES,");
    if (!words.empty() && n > 0) stated.turns = static_cast<int>(std::lround(v.back()));
  } else if (is("apt-camplete")) {
    sense = -1;
    is_whole = is_plain || (n == 8 && words.empty());
    if (n > 7) stated.sweep_deg = v[7];
  } else if (is("camworks-clt")) {
    is_whole = n == 7 && (words == "CLOCKWISE," || words == "COUNTERCLOCKWISE,");
    if (words == "CLOCKWISE,") sense = -1;
  } else if (is("apt-autodesk")) {
    is_whole = is_plain || (n == 8 && words == "ANGLE,");
    if (n == 8) stated.sweep_deg = v[7];
  } else if (is("apt") && n == 7 && (words == "CLOCKWISE," || words == "COUNTERCLOCKWISE,")) {
    is_whole = true;
    if (words == "CLOCKWISE,") sense = -1;
  } else if (is("apt-mori")) {
    is_whole = n == 7 && words == "CENTER,AXIS,RADIUS,";
  }
  if (!is_whole || (n > 6 && v[6] <= 0)) return uncertainty("an arc that is not understood");
  if (!is_unit(&v[3])) return uncertainty("an arc whose vector is no unit vector");
  stated.center = now_.frame.placed(now_.mm * Vec3(v[0], v[1], v[2]));
  stated.normal = (sense * now_.frame.turned(Vec3(v[3], v[4], v[5]))).normalized();
  if (n > 6) stated.radius = v[6] * now_.mm;
  stated.is_short_way = is("apt-nccs");
  now_.arc = stated;
}

// TLON,GOFWD/(CIRCLE/x,y,z,r),ON[,2,INTOF],(LINE/a,b,c,d,e,f)
void StatementExpander::chained_line(const LooseStatement& s) {
  const std::optional<Vec3> direction = now_.direction;
  now_.direction.reset();
  const std::string& text = s.whole;
  const std::size_t circle = text.find("CIRCLE"), line = text.find("LINE");
  const std::size_t close = text.find(')', circle);
  if (circle == std::string::npos || line == std::string::npos || close > line)
    return uncertainty("TLON that is not understood");
  const std::string head = letters_of(text.substr(0, circle)), middle = letters_of(text.substr(close, line - close));
  const bool is_far = middle == "ON2INTOF";
  if (head != "TLONGOFWD" || (middle != "ON" && !is_far) || !direction || now_.arc)
    return uncertainty("TLON that is not understood, or has no INDIRV of its own");
  std::vector<double> c, l;
  const auto inside = [&](std::size_t begin, std::size_t end) {
    const std::size_t first = text.find_first_not_of("/ ", begin);
    return loose_arguments(text.substr(first, text.find_last_not_of(") ", end - 1) + 1 - first));
  };
  if (!numbers(inside(circle + 6, close), c) || !numbers(inside(line + 4, text.size()), l)) return;
  if (c.size() != 4 || l.size() != 6 || !now_.at) return uncertainty("TLON without its numbers or its start");
  if (now_.cycle) return uncertainty("an arc within a cycle");
  Pose to;
  if (!pose_of(&l[3], 3, to)) {
    if (now_.multax != Multax::on) return;
    out_.uncertainties.clear();  // under MULTAX the tool keeps its axis on an arc, which names none
    to.axis = now_.axis;
  }
  StatedArc stated;
  stated.center = now_.frame.placed(now_.mm * Vec3(c[0], c[1], c[2]));
  stated.radius = c[3] * now_.mm;
  const Vec3 outward = now_.at->tip - stated.center;
  if (std::abs(outward.normalized().dot(direction->normalized())) > 0.01) return uncertainty("INDIRV does not touch");
  stated.normal = outward.cross(*direction).normalized();
  const Vec3 end = to.tip - stated.center;
  const bool is_long = stated.normal.dot(outward.cross(end)) < 0;
  if (is_long != is_far) return uncertainty("INTOF against the way of the arc");
  now_.arc = stated;
  move_to(to);
}

void StatementExpander::end_spline() {
  if (!now_.is_spline_open) return;
  now_.is_spline_open = false;
  std::vector<Vec3> control = now_.control;
  std::vector<double> knots = now_.knots;
  now_.control.clear();
  now_.knots.clear();
  if (!now_.at || knots.empty() || std::abs(knots.back() - 1) > kSame || control.size() + 1 != knots.size() + 3)
    return uncertainty("a spline without its start, or with other knots than it needs");
  knots.pop_back();
  control.insert(control.begin(), now_.at->tip);
  const Pose to{control.back(), now_.at->axis};
  emit(now_.at, to, spline_points(control, knots));
  now_.at = to;
}

}  // namespace gouge::laws
