#include "lib/path/motion_key.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "lib/base/sha256.h"
#include "lib/path/run_kind.h"

namespace gouge {
namespace {

class KeyText {
 public:
  // Adds eight bytes, the lowest first on any machine. Zero has no sign.
  void add(double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value + 0.0);
    std::array<char, 8> bytes{};
    for (unsigned i = 0; i < bytes.size(); ++i) bytes.at(i) = static_cast<char>(bits >> (8 * i) & 0xffU);
    text_.append(bytes.data(), bytes.size());
  }
  void add(const Vec3& v) {
    for (int k = 0; k < 3; ++k) add(v[k]);
  }
  void add(const Pose& pose) {
    add(pose.tip);
    add(pose.axis);
  }
  void add(bool value) { text_ += value ? '1' : '0'; }
  void add(std::string_view word) { text_.append(word).append(1, '\n'); }

  [[nodiscard]] std::string key() const { return sha256_of(text_).substr(0, kMotionDigits); }

 private:
  std::string text_;
};

/// Returns an angle in steps, of which a whole turn has kStepsOfTurn.
constexpr double kStepsOfTurn = 1e10;
double steps_of(double angle_rad) { return std::round(angle_rad / (2 * std::numbers::pi) * kStepsOfTurn); }

/// Adds where the rotary joints begin within a turn, and how far they turn. Without a start they stand.
void add_turns(const Toolpath& path, std::size_t index, KeyText& text) {
  const JointPath* const joints = path.joints.get();
  if (joints == nullptr || index >= joints->end.size() || !joints->end[index]) return;
  const RotaryAngles& end = *joints->end[index];
  std::optional<RotaryAngles> start = joints->start[index];
  if (!start && index > 0 && path.moves[index].is_linked) start = joints->end[index - 1];
  text.add(std::string_view("turns"));
  for (std::size_t k = 0; k < end.size(); ++k) {
    const double from = steps_of(start.value_or(end)[k]);
    text.add(from - kStepsOfTurn * std::floor(from / kStepsOfTurn));
    text.add(steps_of(end[k]) - from);
  }
}

}  // namespace

std::string motion_key(const Toolpath& path, std::size_t index, bool is_by_joints) {
  const Move& move = path.moves[index];
  KeyText text;
  text.add(std::string_view(kind_name(move.kind)));
  if (run_kind(move) != move.kind) text.add(std::string_view("in rapid"));
  text.add(move.has_start);
  text.add(move.is_linked);
  if (move.runs_joints) text.add(std::string_view("joints"));
  text.add(move.not_checked_reason);
  if (move.is_covered()) text.add(static_cast<double>(move.cover));
  if (index > 0 && (move.has_start || move.is_linked)) text.add(path.start_of(index));
  text.add(move.end);
  if (is_by_joints) add_turns(path, index, text);
  if (move.curve_kind == CurveKind::arc) {
    const PathArc& arc = path.arcs[move.curve];
    text.add(std::string_view("arc"));
    text.add(arc.center);
    text.add(arc.axis);
    text.add(arc.sweep_rad);
  } else if (move.curve_kind == CurveKind::spline) {
    text.add(std::string_view("spline"));
    for (const SplinePiece& piece : path.splines[move.curve].pieces) {
      text.add(piece.u0);
      text.add(piece.u1);
      for (const Vec3& control : piece.control) text.add(control);
    }
  }
  return text.key();
}

}  // namespace gouge
