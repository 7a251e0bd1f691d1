#include "postproc/cldata/writing/text_sink.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lib/base/number_text.h"
#include "lib/base/tolerance.h"
#include "postproc/cldata/parsing/cutter_statement.h"

namespace gouge {
namespace {

constexpr double kPi = std::numbers::pi;

bool is_plus_z(const Vec3& axis) { return (axis - Vec3::UnitZ()).cwiseAbs().maxCoeff() <= Tolerance::kExactDirection; }

// Returns the number of decimals that keeps the value of a feed, which in inches per revolution may be small.
int feed_decimals(double value, int usual) {
  constexpr double kRelativeError = 1e-5;
  constexpr int kMaxDecimals = 15;
  int decimals = usual;
  while (decimals < kMaxDecimals && 0.5 * std::pow(10.0, -decimals) > kRelativeError * value) ++decimals;
  return decimals;
}

double degrees(double radians) { return radians * 180 / kPi; }

bool is_straight(const CutterStatement& cutter) {
  return !(std::abs(cutter.alpha_deg) > 0) && !(std::abs(cutter.beta_deg) > 0);
}

// Returns a text that a reader recognizes as the name of a tool. A reader would pass any other text to the control.
std::string certain_name(const std::string& name, const std::string& size) {
  if (is_tool_name(name)) return name;
  return is_tool_name(name + " " + size) ? name + " " + size : size;
}

}  // namespace

TextSink::TextSink(const SinkOptions& options)
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

// Returns the statement for positions of the cutter's centre. In Creo it holds for one sequence.
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

// Writes a feed. The unit of a feed per minute may be omitted until the file has a feed per revolution. From then on every
// feed states its unit.
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

void TextSink::stop_spindle(bool is_stopped) {
  begin_block_if_due();
  line(is_stopped ? "SPINDL/OFF" : "SPINDL/ON");
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

// Writes an arc. Each dialect has its own sense of the arc's vector. The next position is the end of the arc.
bool TextSink::go_round(const PathArc& arc, const Pose& start, const Pose& end) {
  const double sweep = std::abs(arc.sweep_rad);
  if (sweep > 2 * kPi * (1 + Tolerance::kRounding)) return false;
  if (format_.has_tlon) return write_tlon(arc, start, end);
  if (format_.circle.empty() || is_block_due_) return false;
  const Vec3 right = arc.sweep_rad < 0 ? Vec3(-arc.axis) : arc.axis;
  if (options_.dialect.has_z_alone && std::abs(std::abs(right.z()) - 1) > Tolerance::kExactDirection) return false;
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

// Writes a planar arc of less than a full turn, with the axis of the previous position.
bool TextSink::write_tlon(const PathArc& arc, const Pose& start, const Pose& end) {
  const Vec3 right = arc.sweep_rad < 0 ? Vec3(-arc.axis) : arc.axis;
  const Vec3 radial = start.tip - arc.center;
  const double sweep = std::abs(arc.sweep_rad);
  const double half_digit = 0.5 * std::pow(10.0, -format_.decimals);
  const bool is_planar =
      std::abs(radial.dot(right)) <= half_digit && std::abs((end.tip - start.tip).dot(right)) <= half_digit;
  const bool keeps_axis = (start.axis - end.axis).cwiseAbs().maxCoeff() <= Tolerance::kExactDirection;
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

// Writers of tools: CUTTER, TLDATA and the words for their numbers in each dialect.

std::string TextSink::seven(const CutterStatement& c) const {
  double e = scaled(c.e_mm), f = scaled(c.f_mm);
  // Some posts write the tip diameter for e, others omit e and f; a reader recomputes both.
  if (options_.dialect.has_tip_diameter && is_straight(c)) e = scaled(c.d_mm - 2 * c.r_mm);
  if (format_.has_no_corner && is_straight(c)) e = f = 0;
  std::string text;
  for (const double value : {scaled(c.d_mm), scaled(c.r_mm), e, f, c.alpha_deg, c.beta_deg, scaled(c.h_mm)}) {
    if (!text.empty()) text += format_.cutter_separator;
    text += format_.number_text(value, 6);
  }
  return text;
}

void TextSink::begin_block() {
  if (is_block_open_) line("END-OF-PATH");
  is_block_open_ = true;
  is_block_due_ = false;
  axis_.reset();
  const std::string operation = operation_.empty() ? "OPERATION" : operation_;
  const std::string name = !tool_                 ? "NONE"
                           : !tool_->name.empty() ? tool_->name
                           : tool_->number        ? "T" + std::to_string(*tool_->number)
                                                  : "TOOL";
  line("TOOL PATH/" + operation + ",TOOL," + name);
  if (tool_ && tool_->cutter) {
    const CutterStatement& c = *tool_->cutter;
    std::string text = "TLDATA/MILL";
    for (const double value : {scaled(c.d_mm), scaled(c.r_mm), scaled(c.h_mm), c.beta_deg, c.alpha_deg})
      text += "," + fixed_text(value, format_.decimals);
    line(text);
  }
  line("MSYS/0.0000,0.0000,0.0000,1.0000000,0.0000000,0.0000000,0.0000000,1.0000000,0.0000000");
  if (tool_ && tool_->number) line("LOAD/TOOL," + std::to_string(*tool_->number));
}

void TextSink::write_tool(const PathTool& tool) {
  const bool is_diameter_stated =
      options_.dialect.cutter_form == CutterForm::diameter_alone && tool.stated_diameter_mm > 0;
  const double diameter_mm = tool.cutter ? tool.cutter->d_mm : is_diameter_stated ? tool.stated_diameter_mm : 0;
  const std::string d = fixed_text(scaled(diameter_mm), 6);
  const char* const unit = options_.unit == LengthUnit::mm ? "MM" : "IN";
  if (!tool.name.empty() && (tool.cutter || !options_.dialect.inserts_are_names))
    fill(format_.tool_name, {{"name", tool.name}, {"certain_name", certain_name(tool.name, d + unit)}});
  if (tool.cutter || is_diameter_stated)
    fill(format_.cutter, {{"seven", tool.cutter ? seven(*tool.cutter) : ""}, {"d", d}});
  if (tool.number) {
    fill(format_.number, {{"number", std::to_string(*tool.number)},
                          {"d", d},
                          {"tprint", tool.name.empty() ? "" : "TPRINT/" + tool.name}});
  }
  if (tool.flute_length_mm > 0)
    fill(format_.flutes, {{"flutes", format_.number_text(scaled(tool.flute_length_mm), 6)}});
}

void TextSink::change_tool(const PathTool& tool) {
  tool_ = tool;
  is_alone_ = true;
  if (options_.dialect.has_positions_alone) return;
  is_block_due_ = options_.dialect.has_blocks;
  if (!is_block_due_) write_tool(tool);
}

std::string TextSink::finish() {
  if (is_block_open_) line("END-OF-PATH");
  fill(format_.end);
  return std::move(text_);
}

std::unique_ptr<MotionSink> make_text_sink(const SinkOptions& options) { return std::make_unique<TextSink>(options); }

}  // namespace gouge
