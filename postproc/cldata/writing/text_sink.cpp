#include "postproc/cldata/writing/text_sink.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lib/base/number_text.h"

namespace gouge {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kSameAxis = 1e-12;

bool is_plus_z(const Vec3& axis) {
  return (axis - Vec3::UnitZ()).cwiseAbs().maxCoeff() <= kSameAxis;
}

// Enough for a feed to keep its value, which in inches per revolution may be small.
int feed_decimals(double value, int usual) {
  constexpr double kRelativeError = 1e-5;
  constexpr int kMostDecimals = 15;
  int decimals = usual;
  while (decimals < kMostDecimals && 0.5 * std::pow(10.0, -decimals) > kRelativeError * value) ++decimals;
  return decimals;
}

std::string feed_text(double value, int usual) {
  return fixed_text(value, feed_decimals(value, usual));
}

double degrees(double radians) {
  return radians * 180 / kPi;
}

}  // namespace

TextSink::TextSink(const TextSinkOptions& options) : options_(options), format_(text_format(options.kind)) {
  format_.decimals = std::max(format_.decimals, options.decimals);
  format_.axis_decimals = std::max(format_.axis_decimals, options.axis_decimals);
  const bool has_axis_when_multax =
      options.kind == DialectKind::autodesk || options.kind == DialectKind::camplete;
  if (has_axis_when_multax) format_.always_has_axis = options.is_tilted;
  begin_file();
}

void TextSink::begin_catia_file() {
  line("$$ -----------------------------------------------------------------");
  line("$$     CATIA APT VERSION 1.0");
  line("$$ -----------------------------------------------------------------");
  line("$$*CATIA0");
  line("$$ " + options_.name);
  for (Eigen::Index row = 0; row < 3; ++row) {
    std::string text = "$$ ";
    for (Eigen::Index column = 0; column < 4; ++column)
      text += row == column ? "    1.00000" : "     0.00000";
    line(text);
  }
  line("PARTNO " + options_.name);
  if (options_.unit == LengthUnit::inch) line("UNITS/INCHES");
  line("MULTAX");
}

// Positions are written in part coordinates.
void TextSink::write_mcs() {
  line("MCS/1.000000000, 0.000000000, 0.000000000, $");
  line("0.000000000, 1.000000000, 0.000000000, $");
  line("0.000000000, 0.000000000, 1.000000000, $");
  line("0.000000, 0.000000, 0.000000");
}

// Creo: it holds for one sequence.
void TextSink::say_on_centre() {
  if (options_.is_on_centre) line("$$-> CUTCOM_GEOMETRY_TYPE / OUTPUT_ON_CENTER");
}

void TextSink::begin_file() {
  const std::string multax = options_.is_tilted ? "ON" : "OFF";
  switch (options_.kind) {
    case DialectKind::catia:
      return begin_catia_file();
    case DialectKind::creo:
      line("$$*          Pro/CLfile");
      line("PARTNO / " + options_.name);
      say_on_centre();
      line("UNITS / " + unit_word());
      if (options_.is_tilted) line("MULTAX / ON");
      return;
    case DialectKind::solidworks_cam:
      line("PARTNO/" + options_.name);
      line("UNIT/" + std::string(options_.unit == LengthUnit::inch ? "INCH" : "MM"));
      return line("TRNTYP/WORLD,0,0,0");
    case DialectKind::clt:
      line("UNITS/ " + unit_word() + " ");
      return line("OPFEATSTART/" + options_.name);  // what tells the dialect
    case DialectKind::autodesk:
    case DialectKind::camplete:
      line("MODE/MILL");
      line("PARTNO/'" + options_.name + "'");
      line("UNITS/" + unit_word());
      line("MULTAX/" + multax);
      if (options_.kind == DialectKind::camplete) write_mcs();
      return;
    case DialectKind::mori:
      line("BEGIN");
      line("UNITS/ " + unit_word());
      line("MCSYS/ NUM, 1, POINT, 0, 0, 0, VECTOR, 1, 0, 0, VECTOR, 0, 1, 0");
      return line("MULTAX/ ON");
    case DialectKind::nccs:
      line("REMARK " + options_.name + " NCLCAM");
      line("UNITS/" + unit_word());
      return line("MULTAX/ON");
    case DialectKind::apt:
      line("PARTNO " + options_.name);
      line("UNITS/" + unit_word());
      return line("MULTAX/ON");
    default:
      return;
  }
}

void TextSink::begin_operation(const std::string& name) {
  operation_ = name;
  switch (options_.kind) {
    case DialectKind::catia:
      return line("$$ OPERATION NAME : " + name);
    case DialectKind::creo:  // nothing is swept from one FEATNO to the next
      if (!is_alone_) return;
      line("$$-> FEATNO / " + std::string(name.starts_with("FEATNO ") ? name.substr(7) : name));
      return say_on_centre();
    case DialectKind::solidworks_cam:
      return line("INSERT/" + name);
    case DialectKind::clt:
      return line("OPFEATSTART/" + name);
    case DialectKind::camplete:
      return line("CSI_TOOL_PATH/" + name);
    case DialectKind::mori:
      return line("OPNAME/ " + name);
    case DialectKind::autodesk:
    case DialectKind::apt:
    case DialectKind::nccs:
      return line("PPRINT/'" + name + "'");
    default:
      return;
  }
}

bool TextSink::break_motion() {
  is_alone_ = true;
  axis_.reset();
  if (options_.kind == DialectKind::goto_list) return false;
  if (options_.kind == DialectKind::nx_clsf) {
    is_block_due_ = true;
  } else {
    line(options_.kind == DialectKind::solidworks_cam || options_.kind == DialectKind::clt ? "GOHOME/"
                                                                                           : "GOHOME");
  }
  return true;
}

bool TextSink::set_cutcom(CutcomSide side) {
  if (options_.kind == DialectKind::goto_list) return false;
  if (is_block_due_ && options_.kind == DialectKind::nx_clsf) begin_nx_block();
  const bool is_creo = options_.kind == DialectKind::creo;
  const bool has_blank = options_.kind == DialectKind::clt || options_.kind == DialectKind::mori;
  line(std::string(is_creo ? "CUTCOM / " : has_blank ? "CUTCOM/ " : "CUTCOM/") + cutcom_word(side));
  return true;
}

void TextSink::retract() {
  if (is_block_due_ && options_.kind == DialectKind::nx_clsf) begin_nx_block();
  line("RETRCT");
  axis_.reset();
}

// NCL writes no unit; once one per revolution was written, every one needs its own.
bool TextSink::set_feed(const Feed& feed) {
  if (options_.kind == DialectKind::goto_list) return false;
  if (is_block_due_ && options_.kind == DialectKind::nx_clsf) begin_nx_block();
  const double value = scaled(feed.mm);
  const bool is_per_turn = feed.unit == FeedUnit::per_revolution;
  has_feed_per_turn_ = has_feed_per_turn_ || is_per_turn;
  const std::string unit = std::string(options_.unit == LengthUnit::inch ? "IP" : "MMP") + (is_per_turn ? "R" : "M");
  switch (options_.kind) {
    case DialectKind::nx_clsf:
      line("FEDRAT/" + unit + "," + feed_text(value, 4));
      break;
    case DialectKind::catia:
      line("FEDRAT/ " + feed_text(value, 4) + "," + unit);
      break;
    case DialectKind::creo:
      line("FEDRAT / " + feed_text(value, 6) + ",  " + unit);
      break;
    case DialectKind::clt:
      line("FEDRAT/ " + unit + "," + feed_text(value, 6));
      break;
    case DialectKind::mori:
      line(std::string("FEDRAT/ ") + (is_per_turn ? "PERREV, " : "PERMIN, ") + exact_text(value));
      break;
    case DialectKind::nccs:
      line("FEDRAT/ " + exact_text(value) + (has_feed_per_turn_ ? "," + unit : ""));
      break;
    case DialectKind::solidworks_cam:
      line("FEDRAT/" + format_.number(value, feed_decimals(value, 6)) + "," + unit);
      break;
    default:
      line("FEDRAT/" + feed_text(value, 6) + ", " + unit);
  }
  return true;
}

bool TextSink::make_rapid() {
  if (options_.kind == DialectKind::goto_list) return false;
  if (is_block_due_ && options_.kind == DialectKind::nx_clsf) begin_nx_block();
  line(std::string(format_.rapid));
  return true;
}

void TextSink::go_to(const Pose& end) {
  const bool is_modal = options_.kind == DialectKind::nx_clsf;
  if (is_block_due_ && is_modal) begin_nx_block();
  std::string text(format_.go_to);
  text += format_.point(end.tip / mm_per(options_.unit));
  const std::string direction = format_.direction(end.axis);
  const Vec3 usual = is_modal ? axis_.value_or(Vec3::Zero()) : Vec3::UnitZ();
  const bool is_usual = is_modal ? direction == format_.direction(usual) : is_plus_z(end.axis);
  if (format_.always_has_axis || !is_usual) {
    text += format_.separator;
    if (format_.breaks_before_axis) text += " $" + std::string(format_.line_end);
    text += direction;
  }
  axis_ = end.axis;
  is_alone_ = false;
  if (options_.kind == DialectKind::clt) text += " ";
  line(text);
}

// Of the arc's vector each dialect has its own sense; the end is the position that follows.
bool TextSink::go_round(const PathArc& arc, const Pose& start, const Pose& end) {
  const double sweep = std::abs(arc.sweep_rad);
  if (sweep > 2 * kPi * (1 + 1e-9)) return false;
  const Vec3 right = arc.sweep_rad < 0 ? Vec3(-arc.axis) : arc.axis;
  const Vec3 radial = start.tip - arc.center;
  const double radius = scaled((radial - radial.dot(arc.axis) * arc.axis).norm());
  const std::string sep(format_.separator);
  const std::string center = format_.point(arc.center / mm_per(options_.unit));
  const auto circle = [&](const Vec3& vector) { return center + sep + format_.direction(vector); };
  const std::string r = format_.coordinate(radius);
  const std::string turn = fixed_text(degrees(sweep), 6);
  switch (options_.kind) {
    case DialectKind::nx_clsf: {
      if (is_block_due_) return false;
      const CutterStatement cutter = tool_ && tool_->cutter ? *tool_->cutter : CutterStatement{};
      line("CIRCLE/" + circle(-right) + "," + r + ",0.0600,0.5000," + fixed_text(scaled(cutter.d_mm), 4) +
           "," + fixed_text(scaled(cutter.r_mm), 4));
      break;
    }
    case DialectKind::camplete:
      line("CIRCLE/" + circle(-right) + ", " + r + ", " + turn + ", 0.0, 0.0, 0.0");
      break;
    case DialectKind::autodesk:
      line("MOVARC/" + circle(right) + ", " + r + ", ANGLE, " + turn);
      break;
    case DialectKind::mori:
      line("MOVARC/ CENTER, " + center + ", AXIS, " + format_.direction(right) + ", RADIUS, " + r);
      break;
    case DialectKind::creo:
      line("CIRCLE / " + center + ",  $");
      line(format_.direction(right) + ",  " + r);
      break;
    case DialectKind::solidworks_cam:
      line("CIRCLE/" + circle(right));
      break;
    case DialectKind::clt:
      if (std::abs(std::abs(right.z()) - 1) > kSameAxis) return false;
      line("CIRCLE/ " + circle(Vec3::UnitZ()) + "," + r + "," +
           (right.z() > 0 ? "COUNTERCLOCKWISE " : "CLOCKWISE "));
      break;
    case DialectKind::catia:
      return write_catia_arc(arc, start, end);
    default:
      return false;
  }
  go_to(end);
  return true;
}

// A planar arc of less than a full turn, with the axis of the position before it.
bool TextSink::write_catia_arc(const PathArc& arc, const Pose& start, const Pose& end) {
  const Vec3 right = arc.sweep_rad < 0 ? Vec3(-arc.axis) : arc.axis;
  const Vec3 radial = start.tip - arc.center;
  const double sweep = std::abs(arc.sweep_rad);
  const double half_digit = 0.5 * std::pow(10.0, -format_.decimals);
  const bool is_planar =
      std::abs(radial.dot(right)) <= half_digit && std::abs((end.tip - start.tip).dot(right)) <= half_digit;
  const bool keeps_axis = (start.axis - end.axis).cwiseAbs().maxCoeff() <= kSameAxis;
  if (!is_planar || !keeps_axis || sweep > 2 * kPi - 0.1) return false;
  const std::string center = format_.point(arc.center / mm_per(options_.unit));
  line("AUTOPS");
  line("INDIRV/" + format_.point(right.cross(radial).normalized()));
  line("TLON,GOFWD/ (CIRCLE/" + center + ",$");
  line(" " + format_.coordinate(scaled(radial.norm())) + (sweep > kPi ? "),ON,2,INTOF,$" : "),ON,$"));
  line("(LINE/" + center + ",$");
  line(format_.point(end.tip / mm_per(options_.unit)) + ")");
  return true;
}

std::string TextSink::finish() {
  switch (options_.kind) {
    case DialectKind::nx_clsf:
      if (is_block_open_) line("END-OF-PATH");
      break;
    case DialectKind::catia:
      line("END");
      break;
    case DialectKind::autodesk:
    case DialectKind::camplete:
      line("END");
      line("FINI");
      break;
    case DialectKind::mori:
      line("END/");
      break;
    case DialectKind::creo:
      line("$$-> END / ");
      line("FINI ");
      break;
    case DialectKind::goto_list:
      break;
    default:
      line("FINI");
  }
  return std::move(text_);
}

}  // namespace gouge
