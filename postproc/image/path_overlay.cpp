#include "postproc/image/path_overlay.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "lib/path/chords.h"
#include "postproc/image/shade.h"
#include "postproc/image/walk_line.h"

namespace gouge {
namespace {

constexpr std::size_t kMostMoves = 100'000;
constexpr double kOpacity = 0.5;

enum Mark : std::uint8_t { kNothing, kChecked, kUnchecked };

class Overlay {
 public:
  explicit Overlay(const SurfaceBuffer& buffer) : buffer_(buffer), marks_(buffer.z.size(), kNothing) {}

  void line(const Vec3& from, const Vec3& to, Mark mark) {
    walk_line(buffer_.view.project(from), buffer_.view.project(to), [&](const Vec3& p) {
      for (int k = 0; k < 4; ++k) put(p, k % 2, k / 2, mark);
    });
  }

  void blend(Raster& raster) const {
    for (int y = 0; y < raster.height; ++y) {
      for (int x = 0; x < raster.width; ++x) {
        const std::uint8_t mark = marks_[buffer_.index(x, y)];
        if (mark != kNothing) blend_pixel(raster, x, y, mark == kChecked ? kCheckedPath : kUncheckedPath, kOpacity);
      }
    }
  }

 private:
  void put(const Vec3& p, int dx, int dy, Mark mark) {
    const int x = static_cast<int>(std::floor(p.x())) + dx;
    const int y = static_cast<int>(std::floor(p.y())) + dy;
    if (x < 0 || y < 0 || x >= buffer_.view.width || y >= buffer_.view.height) return;
    const std::size_t i = buffer_.index(x, y);
    const double slack = 4 * buffer_.view.mm_per_pixel;  // what lies on a surface seen at a slant
    if (p.z() + slack < static_cast<double>(buffer_.z[i])) return;
    marks_[i] = std::max(marks_[i], static_cast<std::uint8_t>(mark));
  }

  const SurfaceBuffer& buffer_;
  std::vector<std::uint8_t> marks_;
};

bool is_checked(const MoveVerdict& verdict) {
  return verdict.state != MoveState::not_checked && verdict.state != MoveState::not_certified;
}

}  // namespace

void lay_path(Raster& raster, const SurfaceBuffer& buffer, const Toolpath& path, const CheckResult& result) {
  Overlay overlay(buffer);
  const std::size_t every = 1 + path.moves.size() / kMostMoves;
  for (std::size_t i = 0; i < path.moves.size(); i += every) {
    const Move& move = path.moves[i];
    if (!move.has_start || move.kind == MoveKind::rapid) continue;
    const Mark mark = is_checked(result.verdicts[i]) ? kChecked : kUnchecked;
    Vec3 from = path.start_of(i).tip;
    if (move.curve_kind == CurveKind::none) {
      overlay.line(from, move.end.tip, mark);
      continue;
    }
    for (const Pose& pose : chords_of(path, i, std::max(buffer.view.mm_per_pixel, 1e-3))) {
      overlay.line(from, pose.tip, mark);
      from = pose.tip;
    }
  }
  overlay.blend(raster);
}

}  // namespace gouge
