#include "lib/path/motion_key.h"

#include <array>
#include <bit>
#include <cstdint>

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

}  // namespace

std::string motion_key(const Toolpath& path, std::size_t index) {
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
