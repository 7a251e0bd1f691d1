#pragma once

#include "postproc/cldata/parsing/machine_text.h"

namespace gouge {

/// The motion code (G0 to G3) in force in the control. A post-processor may write it only where it changes. So after
/// text for the control with another code, motions of the same kind as before may run with the code of the text.
class ControlMotion {
 public:
  /// Takes the code of a text, with the reason not to check the motions that may run with it.
  void take_text(MotionCode code, const char* reason) {
    const bool is_same = code != MotionCode::other && code == written_;
    reason_ = is_same ? nullptr : reason;
    text_ = code;
  }
  /// Notes a motion of the file. `other`: its code is not known, as of an arc that may be cut into lines. Returns why it may
  /// run with another code, or null.
  const char* note(MotionCode code) {
    const bool is_known = code != MotionCode::other;
    const bool is_text = is_known && code == text_;
    const bool is_new = is_known && written_ != MotionCode::other && written_ != code;
    if (is_text || is_new) reason_ = nullptr;
    if (is_known || reason_ == nullptr) written_ = code;
    return reason_;
  }

  [[nodiscard]] bool is_doubtful() const { return reason_ != nullptr; }

 private:
  MotionCode written_ = MotionCode::other;  // of the last motion of the file; other: not known
  MotionCode text_ = MotionCode::other;
  const char* reason_ = nullptr;
};

}  // namespace gouge
