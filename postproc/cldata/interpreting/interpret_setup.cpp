#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "postproc/cldata/interpreting/interpreter.h"
#include "postproc/cldata/language/text.h"
#include "postproc/cldata/nccs/nccs_words.h"

// Setups of CAMWorks CLT, and what Creo 9 writes where older files have comments: CAMERA and PPWORD.

namespace gouge {
namespace {

constexpr double kSameTurn = 1e-5;  // angles in radians and axes have 6 decimals
constexpr double kFrameError = 1e-3;
constexpr std::array<std::string_view, 3> kTables = {"AAXIS", "BAXIS", "CAXIS"};

bool is_axis_name(const Argument& argument) {
  constexpr std::array<std::string_view, 12> kNames = {"X",     "Y",     "Z",     "A",     "B",     "C",
                                                       "XAXIS", "YAXIS", "ZAXIS", "AAXIS", "BAXIS", "CAXIS"};
  return std::any_of(kNames.begin(), kNames.end(),
                     [&](std::string_view name) { return equals_ignoring_case(argument.text, name); });
}

// Rows of three components of an axis and one of the origin.
bool is_rigid_by_rows(const std::vector<Argument>& arguments) {
  if (arguments.size() != 12 || find_word_argument(arguments) != nullptr) return false;
  Eigen::Matrix3d rotation;
  for (Eigen::Index row = 0; row < 3; ++row) {
    for (Eigen::Index column = 0; column < 3; ++column)
      rotation(row, column) = *arguments[static_cast<std::size_t>(4 * row + column)].number;
  }
  return (rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() <= kFrameError &&
         rotation.determinant() > 0;
}

}  // namespace

// A turn as CAMWorks writes it; nothing where another word stands beside its four.
std::optional<Interpreter::TableTurn> Interpreter::clt_turn(std::span<const Argument> arguments) {
  if (arguments.size() != 4 || !arguments[0].number || !equals_ignoring_case(arguments[2].text, "TABLE"))
    return std::nullopt;
  const auto* const axis = std::find_if(kTables.begin(), kTables.end(), [&](std::string_view word) {
    return equals_ignoring_case(word, arguments[1].text);
  });
  const bool is_clockwise = equals_ignoring_case(arguments[3].text, "CLW");
  if (axis == kTables.end() || (!is_clockwise && !equals_ignoring_case(arguments[3].text, "CCLW")))
    return std::nullopt;
  return TableTurn{*axis, is_clockwise ? -*arguments[0].number : *arguments[0].number};
}

// The axes of the setup in those of the model: the turns in force, one after another, each about an axis as it lies
// after those before it.
Eigen::Matrix3d Interpreter::clt_setup() const {
  Eigen::Matrix3d setup = Eigen::Matrix3d::Identity();
  for (const TableTurn& turn : turns_) {
    const auto axis = static_cast<Eigen::Index>(std::find(kTables.begin(), kTables.end(), turn.axis) - kTables.begin());
    setup = setup * Eigen::AngleAxisd(turn.angle, Vec3::Unit(axis)).toRotationMatrix();
  }
  return setup;
}

// Positions are in the axes of their setup. Where it lies in the model no word says; so the first setup of the file is
// the frame of its positions, those of other setups are not checked, and what the words say twice must agree: the
// setup's Z is TLAXIS.
void Interpreter::settle_setup() {
  if (!dialect_.has_setups || !is_setup_new_) return;
  is_setup_new_ = false;
  const auto named = [&](const char* reason) { return reasons_.name(reason, setup_word_, setup_line_); };
  const Eigen::Matrix3d setup = clt_setup();
  clt_setup_reason_ = nullptr;
  if (!clt_axis_) {
    clt_setup_reason_ = named(Reasons::kCltAxis);
  } else if ((setup.col(2) - *clt_axis_).norm() > kSameTurn) {
    clt_setup_reason_ = named(turns_.empty() ? Reasons::kCltAxis : Reasons::kSetupAxis);
  } else if (first_setup_ && (setup - *first_setup_).cwiseAbs().maxCoeff() > kSameTurn) {
    clt_setup_reason_ = named(Reasons::kOtherSetup);
  } else if (!first_setup_) {
    first_setup_ = setup;
    if (!turns_.empty()) turned_setup_line_ = setup_line_;
  }
}

// The setup is settled at the first position that follows, as it takes several statements.
void Interpreter::note_setup_statement() {
  is_setup_new_ = true;
  setup_word_ = statement_->major;
  setup_line_ = statement_->line;
}

// CAMWorks CLT, ROTABL/angle,AAXIS,TABLE,CCLW: turns are undone by the opposite ones, the last one first.
void Interpreter::take_clt_turn(const TableTurn& turn) {
  note_setup_statement();
  if (!turns_.empty() && turns_.back().axis == turn.axis) {
    turns_.back().angle += turn.angle;
  } else {
    turns_.push_back(turn);
  }
  if (std::abs(turns_.back().angle) <= 1e-9) turns_.pop_back();
}

// A feature states its turns itself: what another one has left in force ends with it. The real file's third feature
// undoes nothing, and the fourth turns as the others do.
void Interpreter::end_clt_feature() {
  if (turns_.empty()) return;
  turns_.clear();
  note_setup_statement();
}

// In the axes of the model.
void Interpreter::take_clt_axis() {
  note_setup_statement();
  clt_axis_.reset();
  if (arguments_.size() != 3 || find_word_argument(arguments_) != nullptr) return;
  const Vec3 axis(*arguments_[0].number, *arguments_[1].number, *arguments_[2].number);
  if (std::abs(axis.norm() - 1) <= kFrameError) clt_axis_ = axis.normalized();
}

// Creo 9 writes it where older files have the comment $$-> CSYS, with the same twelve numbers.
void Interpreter::take_camera() {
  if (dialect_.has_camera_csys && is_rigid_by_rows(arguments_)) return note_creo_csys();
  count_unknown();
  unread_frame_reason_ = because(Reasons::kUnreadFrame);
}

// PPWORD/word,code: a word of the post-processor and its number in the table of words. One that is read here must keep
// its meaning: the numbers from 3150 are those of Creo's GPOST for words of its own, others those of IBM's table.
void Interpreter::take_ppword() {
  constexpr double kFirstOfGpost = 3150, kLastOfGpost = 3199;
  const bool has_form = arguments_.size() == 2 && !arguments_[0].number && arguments_[1].number;
  if (!has_form) return count_unknown();
  const Word word = find_word(arguments_[0].text);
  if (word == Word::unknown || word == Word::harmless || word == Word::free_text) return;
  const double code = *arguments_[1].number;
  if (code >= kFirstOfGpost && code <= kLastOfGpost) return;
  const bool is_code = code >= 1 && code <= 9999;
  if (is_code && equals_ignoring_case(nccs_major(static_cast<std::uint16_t>(code)), arguments_[0].text)) return;
  fail("path-statement", "PPWORD gives " + quoted_text(arguments_[0].text) +
                             " another meaning; expected the words themselves: write them in place of their synonyms");
}

// GOHOME / Z: these axes go home, at rapid. Where that is no file says, so the next position stands alone, as after
// GOHOME without words.
bool Interpreter::names_axes_only() const {
  return !arguments_.empty() && dialect_.gohome_names_axes &&
         std::all_of(arguments_.begin(), arguments_.end(), is_axis_name);
}

}  // namespace gouge
