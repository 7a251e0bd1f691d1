#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>

#include "lib/base/number_text.h"
#include "postproc/cldata/interpreting/interpreter.h"
#include "postproc/cldata/language/text.h"
#include "postproc/cldata/language/unit_words.h"

namespace gouge {
namespace {

constexpr double kFrameError = 1e-3;     // of length or of a right angle; beyond it a frame is refused
constexpr double kIdentityError = 1e-9;  // matrices are written with 5 decimals or more; this is rounding
constexpr std::array<double, 12> kIdentityByRows = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};

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

bool is_all_zero(std::span<const Argument> arguments) {
  return std::all_of(arguments.begin(), arguments.end(),
                     [](const Argument& a) { return a.number && std::abs(*a.number) <= 0; });
}

// "9.X1", "ANG1": what holds a digit and is no number may be an angle.
bool has_digit(const Argument& argument) {
  return argument.number || argument.text.find_first_of("0123456789") != std::string_view::npos;
}

}  // namespace

const char* Interpreter::frame_reason() const {
  for (const char* reason : {block_reason_, matrix_reason_, turning_reason_, contour_reason_, adjust_reason_, spline_reason_, unread_frame_reason_,
                             mcs_reason_, csys_reason_, trans_reason_, origin_reason_, trntyp_reason_, mode_reason_,
                             multax_reason_, cutter_reason_, loading_reason_, setup_reason_, machine_shift_reason_,
                             machine_cycle_reason_, machine_steps_reason_}) {
    if (reason != nullptr) return reason;
  }
  return clt_setup_reason_;
}

// Four numbers in a comment: one of the rows after $$*CATIA0.
bool Interpreter::is_matrix_row(std::string_view text) {
  Statement row;
  row.pieces.push_back(text);
  split_arguments(row, arguments_);
  return arguments_.size() == 4 && find_word_argument(arguments_) == nullptr;
}

void Interpreter::take_comment() {
  const std::string_view text = trim(statement_->pieces.front());
  if (dialect_.comments == CommentForm::creo && text.starts_with("->")) return take_creo_comment();
  if (starts_with_ignoring_case(text, "*CATIA0")) {
    if (catia_row_ >= 0) fail_catia_rows();
    catia_row_ = 0;
  } else if (catia_row_ >= 0 || is_catia_nameless_) {
    take_catia_row(text);
  } else if (dialect_.comments == CommentForm::catia && is_matrix_row(text)) {
    matrix_reason_ = reasons_.name(Reasons::kMatrixRow, "$$", statement_->line);
  } else if (dialect_.comments == CommentForm::catia && starts_with_ignoring_case(text, "OPERATION NAME")) {
    const std::size_t colon = text.find(':');
    if (colon != std::string_view::npos) name_operation(name_text(text.substr(colon + 1)));
  }
}

void Interpreter::fail_catia_rows() {
  fail("path-frame", "$$*CATIA0 is not followed by the whole of its matrix; expected a line with a name and 3 lines of "
                     "4 numbers");
  catia_row_ = -1;
  is_catia_nameless_ = false;
}

// $$*CATIA0 is followed by a line with a name and three lines with the rows of a matrix: absolute = R p + t. Where the
// name is missing, or looks like a row, four such lines cannot be told from three.
void Interpreter::take_catia_row(std::string_view text) {
  const bool is_row = is_matrix_row(text);
  if (catia_row_ < 0) {
    is_catia_nameless_ = false;
    if (is_row) fail_catia_rows();
    return;
  }
  if (catia_row_++ == 0) {
    is_catia_nameless_ = is_row;
    if (!is_row) return;
    ++catia_row_;
  }
  if (!is_row) {
    catia_row_ = -1;
    is_catia_nameless_ = false;
    return fail("path-frame", "$$*CATIA0: " + quoted_text(text) +
                                  " is not a row of its matrix; expected 4 numbers in each of 3 lines");
  }
  const auto first = static_cast<std::size_t>(catia_row_ - 2) * 4;
  for (std::size_t i = 0; i < 4; ++i) catia_rows_[first + i] = *arguments_[i].number;
  if (catia_row_ != 4) return;
  catia_row_ = -1;
  const auto column = [&](std::size_t c) {
    return Vec3(catia_rows_[c], catia_rows_[c + 4], catia_rows_[c + 8]);
  };
  const std::optional<RigidTransform> frame =
      make_frame(column(3) * mm_per_unit_, column(0), column(1), "$$*CATIA0");
  if (!frame) return;
  if (column(2).dot(frame->rotation.col(2)) < 0)
    return fail("path-frame", "$$*CATIA0: the matrix mirrors; expected a right-handed axis system");
  matrix_reason_ = nullptr;
  set_frame(*frame);
}

void Interpreter::note_creo_csys() {
  if (!is_identity(arguments_, kIdentityByRows)) csys_told_.add(statement_->line);
}

void Interpreter::take_creo_comment() {
  const std::string_view text = trim(trim(statement_->pieces.front()).substr(2));
  const std::string_view rest = trim(text.substr(std::min(text.find('/'), text.size() - 1) + 1));
  if (starts_with_ignoring_case(text, "CSYS")) {
    Statement values = *statement_;
    values.pieces.front() = rest;
    split_arguments(values, arguments_);
    note_creo_csys();
  } else if (starts_with_ignoring_case(text, "FEATNO")) {
    name_operation("FEATNO " + name_text(rest));
    break_motion();  // between sequences the machine goes home
  } else if (starts_with_ignoring_case(text, "CUTCOM_GEOMETRY_TYPE")) {
    const bool is_on_centre = starts_with_ignoring_case(rest, "OUTPUT_ON_CENTER");
    contour_reason_ = is_on_centre ? nullptr : reasons_.name(Reasons::kContour, "CUTCOM_GEOMETRY_TYPE", statement_->line);
    is_cutter_centre_ = is_cutter_centre_ || is_on_centre;
  } else if (starts_with_ignoring_case(text, "CUTTER")) {
    take_creo_cutter(rest);
  }
}

std::optional<RigidTransform> Interpreter::make_frame(const Vec3& origin, const Vec3& x, const Vec3& y,
                                                      const char* what) {
  const bool is_frame = std::abs(x.norm() - 1) <= kFrameError && std::abs(y.norm() - 1) <= kFrameError &&
                        std::abs(x.dot(y)) <= kFrameError;
  if (!is_frame) {
    fail("path-frame",
         std::string(what) + ": the axes are not two unit vectors at right angles; expected X and Y axis");
    return std::nullopt;
  }
  RigidTransform frame;
  const Vec3 unit_x = x.normalized();
  const Vec3 unit_z = unit_x.cross(y).normalized();
  frame.rotation.col(0) = unit_x;
  frame.rotation.col(1) = unit_z.cross(unit_x);
  frame.rotation.col(2) = unit_z;
  frame.shift = origin;
  return frame;
}

// Under another frame the machine has turned its table or head: nothing is known of the way there.
void Interpreter::set_frame(const RigidTransform& to_part) {
  const double change = (to_part.rotation - to_part_.rotation).cwiseAbs().maxCoeff() +
                        (to_part.shift - to_part_.shift).cwiseAbs().maxCoeff();
  if (change > kIdentityError) {
    break_motion();
    can_link_ = false;
  }
  // A block and a section have one frame, which stands before their positions.
  const bool has_blocks = is_block_open_ || dialect_.operations_are_blocks;
  if (change > kIdentityError && has_blocks && block_ > 0 && block_begin_ < path_.moves.size())
    unread_frame_reason_ = because(Reasons::kUnreadFrame);
  setup_reason_ = nullptr;  // the file says where it is
  to_part_ = to_part;
  is_frame_recorded_ = false;
}

void Interpreter::take_msys() {
  if (arguments_.size() != 9 || find_word_argument(arguments_) != nullptr) {
    return fail("path-frame", "MSYS has " + std::to_string(arguments_.size()) +
                                  " arguments; expected 9 numbers: the origin, the X axis and the Y axis");
  }
  const std::optional<RigidTransform> frame = make_frame(
      vector_of(arguments_, 0) * mm_per_unit_, vector_of(arguments_, 3), vector_of(arguments_, 6), "MSYS");
  if (!frame) return;
  set_frame(*frame);
  is_msys_ever_ = true;
  if (!is_block_open_) return;
  block_reason_ = nullptr;
  block_has_msys_ = block_has_msys_ || block_begin_ == path_.moves.size();  // before its positions, as written
}

void Interpreter::take_csys() {
  csys_reason_ = is_identity(arguments_, kIdentityByRows) ? nullptr : because(Reasons::kCsys);
}

// CAMplete: the X, Y and Z axes, then the origin.
void Interpreter::take_mcs() {
  if (arguments_.size() != 12 || find_word_argument(arguments_) != nullptr) {
    return fail("path-frame", "MCS has " + std::to_string(arguments_.size()) +
                                  " arguments; expected 12 numbers: the X, Y and Z axes and the origin");
  }
  const std::optional<RigidTransform> frame = make_frame(
      vector_of(arguments_, 9) * mm_per_unit_, vector_of(arguments_, 0), vector_of(arguments_, 3), "MCS");
  if (!frame) return;
  if ((vector_of(arguments_, 6) - frame->rotation.col(2)).norm() > kFrameError)
    return fail("path-frame",
                "MCS: the third axis is not the first cross the second; expected a right-handed system");
  set_frame(*frame);
  // Files whose only system is the part's own need not repeat it.
  const double turn = (frame->rotation - RigidTransform{}.rotation).cwiseAbs().maxCoeff();
  is_msys_ever_ = is_msys_ever_ || turn > kIdentityError || frame->shift.norm() > kIdentityError;
  block_has_msys_ = block_has_msys_ || block_begin_ == path_.moves.size();
}

// MCSYS/ NUM,n,POINT,x,y,z,VECTOR,i,j,k,VECTOR,i,j,k: an origin, an X axis and a Y axis. Its writer turns positions
// into no other system before it writes them, and those of three numbers have their axis from nowhere else.
void Interpreter::take_mcsys() {
  constexpr std::array<std::string_view, 13> kForm = {"NUM", "",       "POINT", "", "", "", "VECTOR",
                                                      "",    "",       "",      "VECTOR", "", ""};
  std::vector<Argument> numbers;
  bool has_form = arguments_.size() == kForm.size() + 1;
  for (std::size_t i = 0; i < arguments_.size() && has_form; ++i) {
    const bool is_word = i < kForm.size() && !kForm[i].empty();
    has_form = is_word ? equals_ignoring_case(arguments_[i].text, kForm[i]) : arguments_[i].number.has_value();
    if (!is_word && i > 1) numbers.push_back(arguments_[i]);
  }
  mcs_reason_ = has_form ? nullptr : because(Reasons::kMcsys);
  if (mcs_reason_ != nullptr) return;
  const std::optional<RigidTransform> frame =
      make_frame(vector_of(numbers, 0) * mm_per_unit_, vector_of(numbers, 3), vector_of(numbers, 6), "MCSYS");
  if (frame) set_frame(*frame);
}

// CAMWorks CLT, ROTABL/angle,AAXIS,TABLE,CCLW: turns are undone by the opposite ones, the last one first. Elsewhere
// angles may be absolute or relative, and of one of several tables, so nothing undoes them.
void Interpreter::take_rotabl() {
  if (std::none_of(arguments_.begin(), arguments_.end(), has_digit)) {
    distrust(Word::rotabl);
    return count_unknown();
  }
  const std::optional<TableTurn> turn = dialect_.has_setups ? clt_turn(arguments_) : std::nullopt;
  if (!turn) {
    const bool is_turned = std::any_of(arguments_.begin(), arguments_.end(), [](const Argument& a) {
      return a.number ? std::abs(*a.number) > 0 : has_digit(a);
    });
    if (is_turned) unread_frame_reason_ = because(Reasons::kTurned);
    return;
  }
  take_clt_turn(*turn);
}

// All that is known of other systems than the part's is that these three numbers would shift them.
void Interpreter::take_trntyp() {
  const std::span<const Argument> all(arguments_);
  const bool is_world = !all.empty() && equals_ignoring_case(all.front().text, "WORLD") &&
                        (all.size() == 1 || is_all_zero(all.subspan(1)));
  trntyp_reason_ = is_world ? nullptr : because(Reasons::kTrntyp);
}

// TRANS and ORIGIN shift what a post-processor writes. Whether the part shifts with it no file shows. Zeros undo
// their own word's shift, unless another word says how they are meant.
void Interpreter::take_trans() {
  if (arguments_.empty()) return;
  const bool is_origin = equals_ignoring_case(statement_->major, "ORIGIN");
  const char*& reason = is_origin ? origin_reason_ : trans_reason_;
  std::size_t& run = is_origin ? origin_run_ : trans_run_;
  const bool is_zero = is_all_zero(arguments_);
  if (is_zero && reason == nullptr) doubt_run(Reasons::kStrayOff, run);
  run = path_.moves.size();
  reason = is_zero ? nullptr : because(Reasons::kTrans);
}

// A lathe's or a wire's program has its positions in another plane.
void Interpreter::take_mode() {
  if (has_argument(arguments_, "MILL")) mode_reason_ = nullptr;
  for (const char* word : {"TURN", "LATHE", "WIRE", "EDM"}) {
    if (has_argument(arguments_, word)) mode_reason_ = because(Reasons::kTurning);
  }
  for (const char* word : {"INCR", "INCREMENTAL"}) {
    if (has_argument(arguments_, word)) unread_frame_reason_ = because(Reasons::kUnreadFrame);
  }
  for (const Argument& argument : arguments_) {
    const std::optional<LengthUnit> unit = unit_of_word(argument.text);
    const bool is_other = unit && std::abs(mm_per(*unit) / mm_per_unit_ - 1) > 1e-9;
    if (is_other || equals_ignoring_case(argument.text, "METRIC")) unread_frame_reason_ = because(Reasons::kUnreadFrame);
  }
}

void Interpreter::take_tlaxis() {
  if (is_tlaxis_ignored_) return;
  if (dialect_.has_setups) return take_clt_axis();
  if (arguments_.size() != 3 || find_word_argument(arguments_) != nullptr) {
    if (path_.moves.empty() && find_word_argument(arguments_) != nullptr)
      return refuse_part_program("TLAXIS");
    return fail("path-count",
                "TLAXIS has " + std::to_string(arguments_.size()) + " arguments; expected i,j,k");
  }
  const std::optional<Vec3> axis = read_axis(0);
  if (!axis) return;
  fixed_axis_ = *axis;
  is_tlaxis_new_ = true;
  if (dialect_.is_axis_modal) modal_axis_ = *axis;
}

void Interpreter::take_units() {
  std::optional<LengthUnit> stated;
  for (const Argument& argument : arguments_) {
    const std::optional<LengthUnit> unit = unit_of_word(argument.text);
    if (!unit) continue;
    if (stated && *stated != *unit) {
      return fail("path-statement",
                  std::string(statement_->major) + " states two units; expected MM or INCHES: leave the right one");
    }
    stated = unit;
  }
  if (!stated) {
    return fail("path-statement",
                std::string(statement_->major) + ": " +
                    (arguments_.empty() ? std::string("nothing") : quoted_text(arguments_.front().text)) +
                    " is not a unit; expected MM or INCHES");
  }
  const double mm = mm_per(*stated);
  const bool is_late = !std::exchange(is_unit_stated_, true) && !path_.moves.empty();
  // The guess of the unit knows of it; before it a reader takes mm.
  const bool is_other = *stated != LengthUnit::mm || std::abs(mm - mm_per_unit_) > 0;
  if (is_late && is_other) doubt_moves(0, path_.moves.size(), because(Reasons::kLateUnit));
  mm_per_unit_ = mm;
  is_frame_recorded_ = false;
}

void Interpreter::begin_block() {
  close_block();
  ++block_;
}

// Where the other blocks of a file state their frame, one that states none has lost it.
void Interpreter::close_block() {
  if (block_ > 0 && !block_has_msys_ && block_begin_ < path_.moves.size()) {
    blocks_without_msys_.emplace_back(block_begin_, path_.moves.size());
  }
  block_has_msys_ = false;
  block_begin_ = path_.moves.size();
}

void Interpreter::doubt_blocks_without_msys() {
  close_block();
  if (!is_msys_ever_) return;
  for (const auto& [begin, end] : blocks_without_msys_) doubt_moves(begin, end, Reasons::kNoMsys);
}

// TOOL PATH/operation,TOOL,tool: a block of its own, with its own frame, axis and tool.
void Interpreter::take_tool_path() {
  begin_block();
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
  cutter_reason_ = loading_reason_ = nullptr;
  break_motion();
  modal_axis_ = Vec3::UnitZ();
  to_part_ = {};
  is_frame_recorded_ = false;
  feed_ = {};
  is_block_open_ = true;
  cycle_words_.clear();
  block_reason_ = std::exchange(is_msys_outside_, false) ? Reasons::kMsysOutside : nullptr;
}

}  // namespace gouge
