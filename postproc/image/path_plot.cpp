#include "postproc/image/path_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "lib/base/number_text.h"
#include "lib/motion/chord_instants.h"
#include "lib/path/chords.h"
#include "lib/path/path_info.h"
#include "postproc/image/plot_panel.h"
#include "postproc/image/render_drawing.h"
#include "postproc/image/shade.h"
#include "postproc/image/thin_lines.h"
#include "postproc/image/walk_line.h"

namespace gouge {

namespace {

constexpr double kWidth = 1600, kHeight = 1000, kMargin = 24, kTitle = 84;
constexpr double kAxisShare = 0.04;      // length of a drawn tool axis, relative to the box's diagonal
constexpr std::size_t kAxesDrawn = 400;  // maximum number of axes, evenly distributed over the path
constexpr double kPathFont = 16;

const Colour kPathInk{40, 44, 52, 1};
const Colour kAxis{120, 130, 150, 0.45};

struct Ink {
  const char* name;
  Colour colour;
  std::vector<double> dashes;
};

// In the order of MoveKind, then moves that cannot be checked.
const std::array<Ink, 5> kInks = {{{"feed", {25, 95, 180, 1}, {}},
                                   {"rapid", {225, 140, 20, 1}, {6, 4}},
                                   {"arc", {20, 140, 95, 1}, {}},
                                   {"cycle", {130, 60, 170, 1}, {}},
                                   {"cannot be checked", {200, 30, 40, 1}, {}}}};

const Ink& ink_of(const Move& move) {
  return move.not_checked_reason.empty() ? kInks[static_cast<std::size_t>(move.kind)] : kInks.back();
}

std::uint8_t number_of(const Ink& ink) { return static_cast<std::uint8_t>(&ink - kInks.data()); }

void add_path_text(Drawing& drawing, double x, double y, const std::string& text, const Colour& colour,
                   double size = kPathFont) {
  drawing.items.emplace_back(DrawnText{{x, y}, text, size, colour, TextAnchor::left, false});
}

void draw_panel(const Toolpath& path, const PlotPanel& panel, double axis_length, Drawing& drawing) {
  const std::size_t every = 1 + path.moves.size() / kAxesDrawn;
  for (std::size_t i = 0; i < path.moves.size(); i += every) {
    const Pose& pose = path.moves[i].end;
    drawing.items.emplace_back(
        DrawnLine{{panel.at(pose.tip), panel.at(pose.tip + axis_length * pose.axis)}, kAxis, 1, false, {}});
  }
  ThinLines lines({panel.x, panel.y}, {panel.x + panel.width, panel.y + panel.height});
  std::vector<Vec2> points;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const Move& move = path.moves[i];
    if (!move.has_start) continue;
    const Ink& ink = ink_of(move);
    points.assign(1, panel.at(path.start_of(i).tip));
    if (move.curve_kind == CurveKind::none) {
      points.push_back(panel.at(move.end.tip));
    } else {
      for (const Pose& pose : chords_of(path, i, 0.15 / panel.scale)) points.push_back(panel.at(pose.tip));
    }
    lines.add(points, number_of(ink), {{}, ink.colour, 1.4, false, ink.dashes});
  }
  for (DrawnLine& line : lines.take()) drawing.items.emplace_back(std::move(line));
}

void draw_path_legend(const Toolpath& path, Drawing& drawing) {
  std::vector<const Ink*> used;
  for (const Move& move : path.moves) {
    const Ink* ink = &ink_of(move);
    if (move.has_start && std::find(used.begin(), used.end(), ink) == used.end()) used.push_back(ink);
  }
  std::sort(used.begin(), used.end(), [](const Ink* a, const Ink* b) { return std::string(a->name) < b->name; });
  double x = kMargin;
  for (const Ink* ink : used) {
    drawing.items.emplace_back(DrawnLine{{{x, 66}, {x + 34, 66}}, ink->colour, 2, false, ink->dashes});
    add_path_text(drawing, x + 42, 71, ink->name, kPathInk);
    x += 62 + 9.0 * static_cast<double>(std::string(ink->name).size());
  }
  drawing.items.emplace_back(DrawnLine{{{x, 66}, {x + 34, 66}}, kAxis, 2, false, {}});
  add_path_text(drawing, x + 42, 71, "tool axis", kPathInk);
}

std::string size_text(const Toolpath& path, const Box3& box) {
  const double factor = mm_per(path.unit);
  const Vec3 size = (box.max() - box.min()) / factor;
  std::string text = path.dialect + ", " + std::to_string(path.moves.size()) + " moves, box ";
  for (Eigen::Index i = 0; i < 3; ++i) text += (i > 0 ? " x " : "") + display_text(size[i], 2, Zeros::kept);
  return text + " " + unit_name(path.unit);
}

}  // namespace

Drawing draw_path(const Toolpath& path, const std::vector<IndexedMesh>& parts) {
  Drawing drawing;
  drawing.width = kWidth;
  drawing.height = kHeight;
  const Box3 tips = describe_path(path).box;
  Box3 box = tips;
  const double axis_length = kAxisShare * (tips.max() - tips.min()).norm();
  for (const Move& move : path.moves) box.extend(move.end.tip + axis_length * move.end.axis);
  for (const IndexedMesh& part : parts) box.extend(part.box());
  add_path_text(drawing, kMargin, 36, path.file.substr(path.file.find_last_of('/') + 1) + ": " + size_text(path, tips),
                kPathInk, 20);
  draw_path_legend(path, drawing);
  const double half = (kWidth - 3 * kMargin) / 2, tall = kHeight - kTitle - kMargin;
  const double low = (tall - kMargin) / 2;
  const Vec3 isometric_right = Vec3(1, 1, 0).normalized();
  const Vec3 isometric_up = Vec3(-1, 1, 2).normalized();
  PlotPanel top{kMargin, kTitle, half, low, "from above: x right, y up", Vec3::UnitX(), Vec3::UnitY()};
  PlotPanel front{kMargin,       kTitle + low + kMargin, half, low, "from the front: x right, z up",
                  Vec3::UnitX(), Vec3::UnitZ()};
  PlotPanel isometric{2 * kMargin + half, kTitle,      half, tall, "isometric, from -y and +x: z up",
                      isometric_right,    isometric_up};
  for (PlotPanel panel : {top, front, isometric}) {
    panel.fit(box);
    draw_parts(panel, parts, drawing);
    draw_panel(path, panel, axis_length, drawing);
    draw_frame(panel, path.unit, drawing);
  }
  return drawing;
}

Result<std::string> plot_path(const Toolpath& path, const std::vector<IndexedMesh>& parts, bool is_svg) {
  const Drawing drawing = draw_path(path, parts);
  if (is_svg) return render_svg(drawing);
  return render_png(drawing);
}

namespace {

constexpr std::size_t kMaxMoves = 100'000;
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
    const double slack = 4 * buffer_.view.mm_per_pixel;  // for points on a surface that is seen at an angle
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

void lay_path(Raster& raster, const SurfaceBuffer& buffer, const CheckedToolpath& input) {
  constexpr std::size_t kMaxChords = 64;
  const Toolpath& path = *input.toolpath;
  const CheckResult& result = *input.result;
  Overlay overlay(buffer);
  const std::size_t every = 1 + path.moves.size() / kMaxMoves;
  for (std::size_t i = 0; i < path.moves.size(); i += every) {
    const Move& move = path.moves[i];
    if (!move.has_start || move.kind == MoveKind::rapid) continue;
    const Mark mark = is_checked(result.verdicts[i]) ? kChecked : kUnchecked;
    Vec3 from = path.start_of(i).tip;
    const double error_mm = std::max(buffer.view.mm_per_pixel, 1e-3);
    if (move.curve_kind == CurveKind::none) {
      const Motion motion = input.options.law.of(path, i);
      const bool is_line = motion.is_straight() || !motion.is_defined();
      for (const double t : is_line ? std::vector<double>{1} : chord_instants(motion, error_mm, kMaxChords)) {
        const Vec3 to = t < 1 ? motion.at(t).tip : move.end.tip;
        overlay.line(from, to, mark);
        from = to;
      }
      continue;
    }
    for (const Pose& pose : chords_of(path, i, error_mm)) {
      overlay.line(from, pose.tip, mark);
      from = pose.tip;
    }
  }
  overlay.blend(raster);
}

}  // namespace gouge
