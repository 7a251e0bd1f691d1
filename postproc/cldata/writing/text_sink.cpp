#include "postproc/cldata/writing/text_sink.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lib/base/number_text.h"

namespace gouge {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kSameTextAxis = 1e-12;

bool is_plus_z(const Vec3& axis) { return (axis - Vec3::UnitZ()).cwiseAbs().maxCoeff() <= kSameTextAxis; }

// Enough for a feed to keep its value, which in inches per revolution may be small.
int feed_decimals(double value, int usual) {
  constexpr double kRelativeError = 1e-5;
  constexpr int kMostDecimals = 15;
  int decimals = usual;
  while (decimals < kMostDecimals && 0.5 * std::pow(10.0, -decimals) > kRelativeError * value) ++decimals;
  return decimals;
}

double degrees(double radians) { return radians * 180 / kPi; }

}  // namespace

TextSink::TextSink(const TextSinkOptions& options)
    : options_(options), format_(text_format(options.dialect.kind)), is_block_due_(options.dialect.has_blocks) {
  format_.decimals = std::max(format_.decimals, options.decimals);
  format_.axis_decimals = std::max(format_.axis_decimals, options.axis_decimals);
  if (format_.has_axis_when_tilted) format_.always_has_axis = options.is_tilted;
  begin_file();
}

void TextSink::fill(std::string_view form, std::initializer_list<Value> values) {
  while (!form.empty()) {
    std::string_view rest = form.substr(0, form.find('\n'));
    form.remove_prefix(std::min(rest.size() + 1, form.size()));
    std::string text;
    while (!rest.empty()) {
      const std::size_t open = std::min(rest.find('{'), rest.size());
      text += rest.substr(0, open);
      rest.remove_prefix(open);
      if (rest.empty()) break;
      const std::size_t close = rest.find('}');
      const std::string_view name = rest.substr(1, close - 1);
      text += std::find_if(values.begin(), values.end(), [&](const Value& v) { return v.first == name; })->second;
      rest.remove_prefix(close + 1);
    }
    if (!text.empty()) line(text);
  }
}

// Creo: it holds for one sequence.
std::string TextSink::on_centre() const {
  return options_.is_on_centre ? "$$-> CUTCOM_GEOMETRY_TYPE / OUTPUT_ON_CENTER" : "";
}

void TextSink::begin_file() {
  fill(format_.head, {{"name", options_.name},
                      {"unit", is_inch() ? "INCHES" : "MM"},
                      {"unit_once", is_inch() ? "INCH" : "MM"},
                      {"units_if_inch", is_inch() ? "UNITS/INCHES" : ""},
                      {"multax", options_.is_tilted ? "ON" : "OFF"},
                      {"multax_if_tilted", options_.is_tilted ? "MULTAX / ON" : ""},
                      {"on_centre", on_centre()}});
}

void TextSink::begin_operation(const std::string& name) {
  operation_ = name;
  if (format_.has_separate_operations && !is_alone_) return;
  const std::string featno = name.starts_with("FEATNO ") ? name.substr(7) : name;
  fill(format_.operation, {{"name", name}, {"featno", featno}, {"on_centre", on_centre()}});
}

bool TextSink::break_motion() {
  is_alone_ = true;
  axis_.reset();
  if (options_.dialect.has_positions_alone) return false;
  is_block_due_ = options_.dialect.has_blocks;
  if (!is_block_due_) line(std::string(format_.gohome));
  return true;
}

void TextSink::begin_block_if_due() {
  if (is_block_due_) begin_block();
}

bool TextSink::set_cutcom(CutcomSide side) {
  if (options_.dialect.has_positions_alone) return false;
  begin_block_if_due();
  line(std::string(format_.cutcom) + cutcom_word(side));
  return true;
}

void TextSink::retract() {
  begin_block_if_due();
  line("RETRCT");
  axis_.reset();
}

// Where no unit is written, every feed needs its own once one per revolution was written.
bool TextSink::set_feed(const Feed& feed) {
  if (options_.dialect.has_positions_alone) return false;
  begin_block_if_due();
  const double value = scaled(feed.mm);
  const bool is_per_turn = feed.unit == FeedUnit::per_revolution;
  has_feed_per_turn_ = has_feed_per_turn_ || is_per_turn;
  const std::string unit = std::string(is_inch() ? "IP" : "MMP") + (is_per_turn ? "R" : "M");
  fill(format_.feed, {{"feed", format_.number_text(value, feed_decimals(value, format_.feed_decimals))},
                      {"exact", exact_text(value)},
                      {"unit", unit},
                      {"unit_after_turn", has_feed_per_turn_ ? "," + unit : ""},
                      {"per", is_per_turn ? "PERREV" : "PERMIN"}});
  return true;
}

bool TextSink::make_rapid() {
  if (options_.dialect.has_positions_alone) return false;
  begin_block_if_due();
  line(std::string(format_.rapid));
  return true;
}

void TextSink::go_to(const Pose& end) {
  const bool is_modal = options_.dialect.is_axis_modal;
  begin_block_if_due();
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
  line(text.append(format_.go_to_end));
}

// Of the arc's vector each dialect has its own sense; the end is the position that follows.
bool TextSink::go_round(const PathArc& arc, const Pose& start, const Pose& end) {
  const double sweep = std::abs(arc.sweep_rad);
  if (sweep > 2 * kPi * (1 + 1e-9)) return false;
  if (format_.has_tlon) return write_tlon(arc, start, end);
  if (format_.circle.empty() || is_block_due_) return false;
  const Vec3 right = arc.sweep_rad < 0 ? Vec3(-arc.axis) : arc.axis;
  if (options_.dialect.has_z_alone && std::abs(std::abs(right.z()) - 1) > kSameTextAxis) return false;
  const Vec3 radial = start.tip - arc.center;
  const CutterStatement cutter = tool_ && tool_->cutter ? *tool_->cutter : CutterStatement{};
  fill(format_.circle, {{"center", format_.point(arc.center / mm_per(options_.unit))},
                        {"right", format_.direction(right)},
                        {"left", format_.direction(-right)},
                        {"plus_z", format_.direction(Vec3::UnitZ())},
                        {"radius", format_.coordinate(scaled((radial - radial.dot(arc.axis) * arc.axis).norm()))},
                        {"turn", fixed_text(degrees(sweep), 6)},
                        {"sense", right.z() > 0 ? "COUNTERCLOCKWISE" : "CLOCKWISE"},
                        {"d", fixed_text(scaled(cutter.d_mm), 4)},
                        {"r", fixed_text(scaled(cutter.r_mm), 4)}});
  go_to(end);
  return true;
}

// A planar arc of less than a full turn, with the axis of the position before it.
bool TextSink::write_tlon(const PathArc& arc, const Pose& start, const Pose& end) {
  const Vec3 right = arc.sweep_rad < 0 ? Vec3(-arc.axis) : arc.axis;
  const Vec3 radial = start.tip - arc.center;
  const double sweep = std::abs(arc.sweep_rad);
  const double half_digit = 0.5 * std::pow(10.0, -format_.decimals);
  const bool is_planar =
      std::abs(radial.dot(right)) <= half_digit && std::abs((end.tip - start.tip).dot(right)) <= half_digit;
  const bool keeps_axis = (start.axis - end.axis).cwiseAbs().maxCoeff() <= kSameTextAxis;
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
  if (is_block_open_) line("END-OF-PATH");
  fill(format_.end);
  return std::move(text_);
}

}  // namespace gouge
