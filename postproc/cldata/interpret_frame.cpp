#include <algorithm>
#include <cmath>
#include <string>

#include "lib/base/number_text.h"
#include "postproc/cldata/interpreter.h"
#include "postproc/cldata/text.h"

namespace gouge {
namespace {

constexpr double kFrameError = 1e-3;     // of length or of a right angle; beyond it a frame is refused
constexpr double kIdentityError = 1e-9;  // matrices are written with 5 decimals or more; this is rounding
constexpr std::array<double, 12> kIdentityByRows = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
constexpr std::array<double, 12> kIdentityByVectors = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};

template <class Identity>
bool is_identity(const std::vector<Argument>& arguments, const Identity& identity) {
  if (arguments.size() != identity.size()) return false;
  for (std::size_t i = 0; i < identity.size(); ++i) {
    if (!arguments[i].number || std::abs(*arguments[i].number - identity[i]) > kIdentityError) return false;
  }
  return true;
}

Vec3 vector_of(const std::vector<Argument>& arguments, std::size_t first) {
  return {*arguments[first].number, *arguments[first + 1].number, *arguments[first + 2].number};
}

}  // namespace

const char* Interpreter::frame_reason() const {
  for (const char* reason :
       {turning_reason_, contour_reason_, catia_reason_, mcs_reason_, csys_reason_, trntyp_reason_}) {
    if (reason != nullptr) return reason;
  }
  const bool is_turned =
      std::any_of(turned_.begin(), turned_.end(), [](double a) { return std::abs(a) > kIdentityError; });
  return is_turned ? Reasons::kTurned : nullptr;
}

void Interpreter::take_comment() {
  const std::string_view text = trim(statement_->pieces.front());
  if (dialect_.kind == DialectKind::creo && text.starts_with("->")) return take_creo_comment();
  if (dialect_.kind != DialectKind::catia) return;
  if (starts_with_ignoring_case(text, "*CATIA0")) {
    catia_row_ = 0;
    is_catia_identity_ = true;
    catia_reason_ = nullptr;
  } else if (catia_row_ >= 0) {
    take_catia_row(text);
  } else if (starts_with_ignoring_case(text, "OPERATION NAME")) {
    const std::size_t colon = text.find(':');
    if (colon != std::string_view::npos) name_operation(name_text(text.substr(colon + 1)));
  }
}

// $$*CATIA0 is followed by a line with a name and three lines with the rows of a matrix.
void Interpreter::take_catia_row(std::string_view text) {
  if (catia_row_++ == 0) return;
  Statement row;
  row.pieces.push_back(text);
  split_arguments(row, arguments_);
  std::array<double, 4> identity{};
  identity[static_cast<std::size_t>(catia_row_ - 2)] = 1;
  if (!is_identity(arguments_, identity)) catia_reason_ = Reasons::kCatia;
  if (catia_row_ == 4) catia_row_ = -1;
}

void Interpreter::take_creo_comment() {
  const std::string_view text = trim(trim(statement_->pieces.front()).substr(2));
  const std::string_view rest = trim(text.substr(std::min(text.find('/'), text.size() - 1) + 1));
  if (starts_with_ignoring_case(text, "CSYS")) {
    Statement values = *statement_;
    values.pieces.front() = rest;
    split_arguments(values, arguments_);
    csys_reason_ = is_identity(arguments_, kIdentityByRows) ? nullptr : Reasons::kCsys;
  } else if (starts_with_ignoring_case(text, "FEATNO")) {
    name_operation("FEATNO " + name_text(rest));
  } else if (starts_with_ignoring_case(text, "CUTCOM_GEOMETRY_TYPE")) {
    contour_reason_ = starts_with_ignoring_case(rest, "OUTPUT_ON_CENTER") ? nullptr : Reasons::kContour;
  } else if (starts_with_ignoring_case(text, "CUTTER")) {
    // Only the diameter is written: a flat, a ball and a bull-nose cutter look the same, so it defines no
    // tool.
    tool_.name = "diameter " + name_text(rest);
    is_tool_changed_ = true;
  }
}

void Interpreter::take_msys() {
  if (arguments_.size() != 9 || find_word_argument(arguments_) != nullptr) {
    return fail("path-frame", "MSYS has " + std::to_string(arguments_.size()) +
                                  " arguments; expected 9 numbers: the origin, the X axis and the Y axis");
  }
  const Vec3 x = vector_of(arguments_, 3);
  const Vec3 y = vector_of(arguments_, 6);
  const bool is_frame = std::abs(x.norm() - 1) <= kFrameError && std::abs(y.norm() - 1) <= kFrameError &&
                        std::abs(x.dot(y)) <= kFrameError;
  if (!is_frame)
    return fail("path-frame",
                "MSYS: the axes are not two unit vectors at right angles; expected X and Y axis");
  const Vec3 unit_x = x.normalized();
  const Vec3 unit_z = unit_x.cross(y).normalized();
  to_part_.rotation.col(0) = unit_x;
  to_part_.rotation.col(1) = unit_z.cross(unit_x);
  to_part_.rotation.col(2) = unit_z;
  to_part_.shift = vector_of(arguments_, 0) * mm_per_unit_;
}

void Interpreter::take_csys() {
  csys_reason_ = is_identity(arguments_, kIdentityByRows) ? nullptr : Reasons::kCsys;
}

void Interpreter::take_mcs() {
  mcs_reason_ = is_identity(arguments_, kIdentityByVectors) ? nullptr : Reasons::kMcs;
}

// MCSYS/ NUM,n,POINT,x,y,z,VECTOR,i,j,k,VECTOR,i,j,k: an origin, an X axis and a Y axis.
void Interpreter::take_mcsys() {
  std::vector<Argument> numbers;
  bool is_counting = false;
  for (const Argument& argument : arguments_) {
    is_counting = is_counting || equals_ignoring_case(argument.text, "POINT");
    if (is_counting && argument.number) numbers.push_back(argument);
  }
  constexpr std::array<double, 9> kPlain = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  mcs_reason_ = is_identity(numbers, kPlain) ? nullptr : Reasons::kMcs;
}

// ROTABL/angle,AAXIS,...: turns add up and are undone by the same angle the other way.
void Interpreter::take_rotabl() {
  const auto number = std::find_if(arguments_.begin(), arguments_.end(),
                                   [](const Argument& a) { return a.number.has_value(); });
  if (number == arguments_.end()) return count_unknown();
  const std::size_t axis = has_argument(arguments_, "BAXIS") ? 1 : has_argument(arguments_, "CAXIS") ? 2 : 0;
  turned_[axis] += *number->number;
}

void Interpreter::take_trntyp() {
  const bool is_world = !arguments_.empty() && equals_ignoring_case(arguments_.front().text, "WORLD");
  trntyp_reason_ = is_world ? nullptr : Reasons::kTrntyp;
}

void Interpreter::take_tlaxis() {
  // CAMWorks CLT writes the axis in model axes while its positions are in setup axes, where it is +Z.
  if (is_tlaxis_ignored_ || dialect_.kind == DialectKind::clt) return;
  if (arguments_.size() != 3 || find_word_argument(arguments_) != nullptr) {
    if (path_.moves.empty() && find_word_argument(arguments_) != nullptr)
      return refuse_part_program("TLAXIS");
    return fail("path-count",
                "TLAXIS has " + std::to_string(arguments_.size()) + " arguments; expected i,j,k");
  }
  const std::optional<Vec3> axis = read_axis(0);
  if (!axis) return;
  fixed_axis_ = *axis;
  if (dialect_.is_axis_modal) modal_axis_ = *axis;
}

void Interpreter::take_units() {
  for (const Argument& argument : arguments_) {
    if (const std::optional<LengthUnit> unit = unit_of_word(argument.text)) {
      mm_per_unit_ = mm_per(*unit);
      return;
    }
  }
  fail("path-statement",
       std::string(statement_->major) + ": " +
           (arguments_.empty() ? std::string("nothing") : quoted_text(arguments_.front().text)) +
           " is not a unit; expected MM or INCHES");
}

// TOOL PATH/operation,TOOL,tool: a block of its own, with its own frame, axis and tool.
void Interpreter::take_tool_path() {
  const std::string_view text = statement_->pieces.front();
  const std::size_t cut = text.find(",TOOL,");
  const std::string tool = cut == std::string_view::npos ? std::string() : name_text(text.substr(cut + 6));
  name_operation(name_text(text.substr(0, cut)));
  if (tool != tool_.name || tool.empty()) {
    tool_ = {};
    tool_.name = tool;
    tool_.line = statement_->line;
  }
  is_tool_changed_ = true;
  break_motion();
  is_rapid_ = false;
  is_cycle_ = false;
  modal_axis_ = Vec3::UnitZ();
  to_part_ = {};
  feed_mm_per_min_ = 0;
  ++block_;
  is_block_open_ = true;
}

}  // namespace gouge
