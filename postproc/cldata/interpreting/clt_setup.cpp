#include "postproc/cldata/interpreting/clt_setup.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "lib/base/tolerance.h"
#include "postproc/cldata/interpreting/frame_state.h"
#include "postproc/cldata/interpreting/reasons.h"
#include "postproc/cldata/language/text.h"

namespace gouge {
namespace {

constexpr std::array<std::string_view, 3> kTables = {"AAXIS", "BAXIS", "CAXIS"};

}  // namespace

std::optional<CltSetup::TableTurn> CltSetup::turn_of(std::span<const Argument> arguments) {
  if (arguments.size() != 4 || !arguments[0].number || !equals_ignoring_case(arguments[2].text, "TABLE"))
    return std::nullopt;
  const auto* const axis = std::ranges::find_if(
      kTables, [&](std::string_view word) { return equals_ignoring_case(word, arguments[1].text); });
  const bool is_clockwise = equals_ignoring_case(arguments[3].text, "CLW");
  if (axis == kTables.end() || (!is_clockwise && !equals_ignoring_case(arguments[3].text, "CCLW"))) return std::nullopt;
  return TableTurn{*axis, is_clockwise ? -*arguments[0].number : *arguments[0].number};
}

// Returns the axes of the setup in those of the model. They result from the turns in force. Each turn is about an axis
// in its position after the previous turns.
Eigen::Matrix3d CltSetup::axes() const {
  Eigen::Matrix3d setup = Eigen::Matrix3d::Identity();
  for (const TableTurn& turn : turns_) {
    const auto axis = static_cast<Eigen::Index>(std::ranges::find(kTables, turn.axis) - kTables.begin());
    setup = setup * Eigen::AngleAxisd(turn.angle, Vec3::Unit(axis)).toRotationMatrix();
  }
  return setup;
}

void CltSetup::begin() {
  is_new_ = true;
  word_ = in_.statement().major;
  line_ = in_.line();
}

bool CltSetup::take_turn() {
  const std::optional<TableTurn> turn = turn_of(in_.arguments);
  if (!turn) return false;
  begin();
  if (!turns_.empty() && turns_.back().axis == turn->axis) {
    turns_.back().angle += turn->angle;
  } else {
    turns_.push_back(*turn);
  }
  if (std::abs(turns_.back().angle) <= Tolerance::kRounding) turns_.pop_back();
  return true;
}

// The third feature of the real file undoes no turn, and the fourth one turns as the others do.
void CltSetup::end_feature() {
  if (turns_.empty()) return;
  turns_.clear();
  begin();
}

void CltSetup::take_axis() {
  begin();
  axis_.reset();
  if (!in_.has_numbers_alone(3)) return;
  const Vec3 axis = in_.vector(0);
  if (std::abs(axis.norm() - 1) <= kFrameError) axis_ = axis.normalized();
}

// Compares the Z axis of the setup, as it results from the turns, with TLAXIS. A first position before both has the axes
// of the model.
void CltSetup::settle() {
  if (!in_.dialect.has_setups) return;
  if (!is_new_ && !first_) first_ = axes();
  if (!is_new_) return;
  is_new_ = false;
  const auto uncertainty = [&](const char* reason) {
    uncertainties_.set(Uncertainty::clt_setup, in_.named(reason, word_, line_));
  };
  const Eigen::Matrix3d setup = axes();
  uncertainties_.clear(Uncertainty::clt_setup);
  if (!axis_) {
    uncertainty(Reasons::kCltAxis);
  } else if ((setup.col(2) - *axis_).norm() > Tolerance::kFileAxis) {
    uncertainty(turns_.empty() ? Reasons::kCltAxis : Reasons::kSetupAxis);
  } else if (first_ && (setup - *first_).cwiseAbs().maxCoeff() > Tolerance::kFileAxis) {
    uncertainty(Reasons::kOtherSetup);
  } else if (!first_) {
    first_ = setup;
    if (!turns_.empty()) turned_line_ = line_;
  }
}

void CltSetup::write_note() const {
  if (turned_line_ == 0) return;
  in_.path.notes.push_back(make_warning("path-setup",
                                        "positions are in the axes of a turned setup, not in those of the model: the "
                                        "parts must be exported in that setup's coordinate system",
                                        in_.path.file, turned_line_));
}

}  // namespace gouge
