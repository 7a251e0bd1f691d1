#include "postproc/gcode/heidenhain/klartext_frame.h"

#include <cmath>

#include "lib/base/units.h"

namespace gouge {

Vec3 KlartextFrame::outside(const Vec3& program) const {
  Vec3 made = program;
  for (int i = 0; i < 3; ++i) made[i] *= (i < 2 && mirror_.at(static_cast<std::size_t>(i)) ? -1 : 1);
  if (std::abs(rotation_deg_) > 0) {
    const double c = std::cos(rotation_deg_ * kDegree_rad), s = std::sin(rotation_deg_ * kDegree_rad);
    made = Vec3(c * made.x() - s * made.y(), s * made.x() + c * made.y(), made.z());
  }
  return made + shift_;
}

Vec3 KlartextFrame::inside(const Vec3& outside) const {
  Vec3 made = outside - shift_;
  if (std::abs(rotation_deg_) > 0) {
    const double c = std::cos(rotation_deg_ * kDegree_rad), s = std::sin(rotation_deg_ * kDegree_rad);
    made = Vec3(c * made.x() + s * made.y(), -s * made.x() + c * made.y(), made.z());
  }
  for (int i = 0; i < 3; ++i) made[i] *= (i < 2 && mirror_.at(static_cast<std::size_t>(i)) ? -1 : 1);
  return made;
}

bool KlartextFrame::is_turned() const { return std::abs(rotation_deg_) > 0 || mirror_[0] || mirror_[1] || is_scaled_; }

void KlartextFrame::lose(const std::string& reason) {
  if (open_.empty()) open_ = reason;
}

// Only combinations in the order of the manual's example are known.
void KlartextFrame::combine(const char* what) {
  const int turned = (std::abs(rotation_deg_) > 0 ? 1 : 0) + (mirror_[0] || mirror_[1] ? 1 : 0) + (is_scaled_ ? 1 : 0);
  if (turned > 1)
    lose(std::string("no manual at hand states the order of ") + what + " and the transformation before it");
}

void KlartextFrame::shift(std::size_t axis, double value_mm, bool is_step) {
  double& own = shift_[static_cast<int>(axis)];
  const bool has_two_origins = is_tilted_ && (is_step || !tilt_origin_.isZero(0));
  if (is_turned() && (is_step || std::abs(value_mm - own) > 0))
    lose("a datum shift after a rotation, mirror image or scale: no manual at hand states its directions");
  if (has_two_origins) lose("a datum shift in a tilted plane that has one before it");
  own = is_step ? own + value_mm : value_mm;
  (is_step ? stepped_ : named_).at(axis) = true;
  if (!std::isfinite(own)) lose("a value of a datum shift is not known");
}

void KlartextFrame::begin_shift() {
  end_shift();
  named_ = stepped_ = {};
  is_shifting_ = true;
}

void KlartextFrame::end_shift() {
  if (!is_shifting_) return;
  is_shifting_ = false;
  bool is_whole = true;
  for (std::size_t i = 0; i < 3; ++i) {
    is_whole = is_whole && named_.at(i);
    const double value = shift_[static_cast<int>(i)];
    if (!named_.at(i) && !stepped_.at(i) && !(std::abs(value) <= 0))
      lose("a datum shift leaves out an axis that is shifted");
  }
  if (is_whole && !is_turned() && !is_tilted_ && shift_.allFinite()) open_.clear();
}

void KlartextFrame::rotate(double degrees, bool is_step) {
  rotation_deg_ = is_step ? rotation_deg_ + degrees : degrees;
  if (!std::isfinite(rotation_deg_)) {
    lose("the angle of a rotation is not known");
    rotation_deg_ = 0;
  }
  combine("a rotation");
}

void KlartextFrame::mirror(bool x, bool y) {
  mirror_ = {x, y};
  combine("a mirror image");
}

// Machine parameter 7410 states whether a scale holds for all three axes or for the working plane.
void KlartextFrame::scale(double factor) {
  is_scaled_ = !(std::abs(factor - 1) <= 0);
  if (is_scaled_) lose("a parameter of the control states which axes a scale changes");
}

Vec3 KlartextFrame::begin_tilt() {
  if (is_turned()) lose("a tilted plane after a rotation, mirror image or scale");
  if (is_tilted_ && !shift_.isZero(0)) lose("a tilted plane within another that has a datum shift");
  if (!is_tilted_) {
    tilt_origin_ = shift_;
    shift_.setZero();
  }
  is_tilted_ = true;
  return tilt_origin_;
}

void KlartextFrame::end_tilt() {
  if (!is_tilted_) return;
  is_tilted_ = false;
  if (is_turned() || !shift_.isZero(0))
    lose("a tilted plane ends before the shift, rotation, mirror image or scale in it");
  shift_ = tilt_origin_;
}

}  // namespace gouge
