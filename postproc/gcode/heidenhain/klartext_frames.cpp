#include <algorithm>
#include <cmath>

#include "postproc/gcode/heidenhain/klartext_runner.h"

// Tilted planes and tool centre point control.

namespace gouge {
namespace {

/// Turns about X, then about Y, then about Z of the frame that does not tilt. Degrees.
/// Source   TNC 620, 10/2017, p. 540, PLANE SPATIAL: A-B-C in the frame that is not tilted.
Eigen::Matrix3d spatial_rotation(const Vec3& degrees) {
  const auto turn = [](double angle, const Vec3& axis) {
    return Eigen::AngleAxisd(angle * kDegree_rad, axis).toRotationMatrix();
  };
  return turn(degrees.z(), Vec3::UnitZ()) * turn(degrees.y(), Vec3::UnitY()) * turn(degrees.x(), Vec3::UnitX());
}

constexpr std::string_view kStay = "STAY";

}  // namespace

// Words of the positioning behaviour. Source: iTNC 530 60642x-04, Specifying the positioning behavior of the PLANE
// function.
std::string KlartextRunner::take_positioning(const Words& words, std::size_t first, std::string_view& found) const {
  static constexpr std::array<std::string_view, 3> kForms = {"STAY", "MOVE", "TURN"};
  static constexpr std::array<std::string_view, 9> kNames = {"FMAX", "FAUTO", "F",     "MAX", "AUTO",
                                                             "MB",   "TABLE", "COORD", "ROT"};
  static constexpr std::array<std::string_view, 4> kNumbers = {"F", "DIST", "ABST", "MB"};
  for (std::size_t i = first; i < words.size(); ++i) {
    const KlartextWord& word = words[i];
    const auto is_one_of = [&](const auto& names) {
      return std::ranges::find(names, std::string_view(word.name)) != names.end();
    };
    const bool is_form = word.kind == KlartextWord::Kind::name && is_one_of(kForms);
    for (std::size_t k = first; k < i; ++k)
      if (words[k].name == word.name) return "'" + word_text(word) + "' is a second word of its kind in PLANE";
    if (is_form && !found.empty()) return word_text(word) + " is a second positioning in PLANE";
    if (is_form) found = *std::ranges::find(kForms, std::string_view(word.name));
    const bool is_choice = word.kind == KlartextWord::Kind::sign && (word.name == "SEQ" || word.name == "SYM");
    const bool is_read = is_form || is_choice || (word.kind == KlartextWord::Kind::name && is_one_of(kNames)) ||
                         (word.kind == KlartextWord::Kind::number && is_one_of(kNumbers));
    if (!is_read) return "'" + word_text(word) + "' has no place in PLANE";
  }
  return found.empty() ? "PLANE states neither MOVE nor TURN nor STAY" : "";
}

void KlartextRunner::define_plane(std::string_view text) {
  Words words;
  if (!read_words(text, words)) return;
  if (words.empty()) return lose_rest("PLANE states no form");
  if (!has_preset_) choose_preset(std::nullopt);
  std::string_view positioning;
  if (words[0].is("RESET")) {
    const std::string wrong = take_positioning(words, 1, positioning);
    return wrong.empty() ? end_tilt(positioning) : lose_rest(wrong);
  }
  if (!words[0].is("SPATIAL")) return lose_rest("PLANE " + words[0].name + " is not read; expected PLANE SPATIAL");
  static constexpr std::array<std::string_view, 3> kAngles = {"SPA", "SPB", "SPC"};
  Vec3 angles = Vec3::Zero();
  for (std::size_t i = 0; i < 3; ++i) {
    if (i + 1 >= words.size() || !words[i + 1].has_number(kAngles.at(i)))
      return lose_rest("PLANE SPATIAL needs SPA, SPB and SPC, in this order");
    angles[static_cast<int>(i)] = words[i + 1].value;
  }
  const std::string wrong = take_positioning(words, 4, positioning);
  if (!wrong.empty()) return lose_rest(wrong);
  tilt(angles.hasNaN() ? "an angle of PLANE SPATIAL is not known" : "", angles, positioning);
}

void KlartextRunner::tilt(const std::string& reason, const Vec3& angles_deg, std::string_view positioning) {
  if (motion_.has_turned_offset())
    return lose_rest("a tilted plane with a preset of rotary axes, whose effect no manual at hand states");
  tangent_.reset();
  pole_.reset();
  RigidTransform plane;
  plane.shift = frame_.begin_tilt();
  if (reason.empty()) plane.rotation = spatial_rotation(angles_deg);
  tilt_open_ = reason;
  has_tilt_ = true;
  settle_frame();
  motion_.set_plane(plane);
  is_tilt_open_ = positioning == kStay;
  if (!is_tilt_open_) motion_.align_to_plane();
}

// MOVE and TURN bring the rotary axes to their home positions.
void KlartextRunner::end_tilt(std::string_view positioning) {
  tangent_.reset();
  pole_.reset();
  const bool stays_tilted = has_tilt_ && !is_tilt_open_ && positioning == kStay && !motion_.mapper().has_machine();
  frame_.end_tilt();
  motion_.set_plane(std::nullopt);
  has_tilt_ = is_tilt_open_ = false;
  if (positioning != kStay) {
    AxisPlace home;
    for (std::size_t k = 0; k < 2; ++k)
      home.angles.at(k) = motion_.mapper().has_machine() ? motion_.angle_from_program(k, 0) : 0;
    motion_.go_unchecked(MoveKind::rapid, home, "the motion that ends the tilted plane is not known");
    tilt_open_.clear();
  } else if (stays_tilted) {
    tilt_open_ = "PLANE RESET STAY" + in_line(line_) +
                 " leaves the rotary axes tilted; expected --machine, which states where they are";
  } else if (motion_.mapper().has_machine()) {
    tilt_open_.clear();
  }
  settle_frame();
}

void KlartextRunner::settle_frame() {
  const std::string& open = !tilt_open_.empty() ? tilt_open_ : frame_.open();
  if (open.empty())
    motion_.end_doubt(ProgramDoubt::frame);
  else
    motion_.doubt(ProgramDoubt::frame, open);
}

// Source: TNC 640 34059x-02, p. 400 and 401, FUNCTION TCPM: F, AXIS, PATHCTRL; REFPNT of later versions.
void KlartextRunner::control_tip(std::string_view text) {
  Words words;
  if (!read_words(text, words)) return;
  std::string whole;
  for (const KlartextWord& word : words) whole += (whole.empty() ? "" : " ") + word_text(word);
  if (whole == "RESET TCPM") return end_tip_control();
  std::string_view rest = whole;
  const auto take = [&](std::string_view option) {
    if (!rest.starts_with(option)) return false;
    const bool is_whole = rest.size() == option.size() || rest[option.size()] == ' ';
    if (is_whole) rest.remove_prefix(std::min(option.size() + 1, rest.size()));
    return is_whole;
  };
  if (!take("TCPM") || (!take("F TCP") && !take("F CONT")))
    return lose_rest("FUNCTION " + whole + " is not read; expected TCPM F TCP, TCPM F CONT or RESET TCPM");
  const bool is_spatial = take("AXIS SPAT");
  if (!is_spatial && !take("AXIS POS")) return lose_rest("FUNCTION TCPM needs AXIS POS or AXIS SPAT");
  const bool is_vector = take("PATHCTRL VECTOR");
  if (!is_vector && !take("PATHCTRL AXIS")) return lose_rest("FUNCTION TCPM needs PATHCTRL AXIS or PATHCTRL VECTOR");
  const bool is_tip = take("REFPNT TIP- TIP");
  if (!rest.empty()) return lose_rest("'" + std::string(rest) + "' in FUNCTION TCPM is not read");
  if (is_spatial) return begin_tip_control("FUNCTION TCPM with AXIS SPAT: the control chooses the rotary positions");
  if (is_vector)
    return begin_tip_control("FUNCTION TCPM with PATHCTRL VECTOR: the control chooses the rotary positions");
  begin_tip_control(is_tip ? "" : why_point_open());
}

// Source: iTNC 530 60642x-04, p. 516, M128: the tool length must refer to the centre of the ball. REFPNT states it.
std::string KlartextRunner::why_point_open() const {
  return are_points_of_tip_
             ? ""
             : "nothing states whether positions under tool centre point control are of the tip or of the centre of a "
               "ball; expected --start \"REFPNT TIP-TIP\", with lengths to the tip";
}

void KlartextRunner::begin_tip_control(const std::string& open) {
  if (!motion_.mapper().has_machine()) {
    if (!facts_.error)
      facts_.error = make_error("gcode-machine", "the program begins tool centre point control; expected --machine",
                                input_.path.file, line_);
    return;
  }
  if (motion_.has_turned_offset())
    return lose_rest("tool centre point control with a preset of rotary axes, whose effect no manual at hand states");
  tangent_.reset();
  tip_open_ = open;
  switch_tip_control(TipControl::on);
  settle_length();
}

// Whether the length must be known depends on tip control, so that it is applied anew.
void KlartextRunner::switch_tip_control(TipControl control) {
  motion_.set_tip_control(control);
  motion_.apply_length(std::nullopt);
}

void KlartextRunner::end_tip_control() {
  const bool chose_positions = tip_open_.find("chooses") != std::string::npos;
  tip_open_.clear();
  tangent_.reset();
  if (chose_positions)
    motion_.go_unchecked(MoveKind::feed, AxisPlace{},
                         "the rotary positions at the end of tool centre point control are not known");
  switch_tip_control(TipControl::off);
  settle_length();
}

}  // namespace gouge
