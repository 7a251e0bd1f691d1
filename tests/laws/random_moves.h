#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tests/laws/random_scenes.h"
#include "tests/support/random_tools.h"
#include "tests/support/reference.h"
#include "tests/support/solids.h"

// Random moves of every kind with tools of every shape among closed and open meshes, most of them touching the tool
// somewhere during it. Header only.

namespace gouge::laws {

struct RandomJob {
  ToolVariants tool;
  std::string tool_name;
  Toolpath path;
  Scene scene;
  std::vector<IndexedMesh> heads;  ///< in the tool's frame
  bool is_closed = false;          ///< all meshes are closed, outward, and apart from each other or nested as one solid
};

class RandomJobs {
 public:
  explicit RandomJobs(std::uint64_t stream) : scatter_(stream), shapes_(seed() * 7919 + stream) {}

  RandomJob next() {
    if (uses_left_ == 0) make_tool();
    --uses_left_;
    RandomJob job;
    job.tool = *tool_;
    job.tool_name = tool_name_;
    make_path(job);
    if (scatter_.below(12) == 0) job.heads.push_back(head());
    make_scene(job);
    return job;
  }

 private:
  double in(double low, double high) { return scatter_.in(low, high); }
  bool chance(double share) { return in(0, 1) < share; }

  void make_tool() {
    uses_left_ = 4;
    tool_.reset();
    const std::uint64_t kind = shapes_.next() % 3;
    if (kind == 0) {  // any profile at all
      const test::RandomTool random = test::random_tool(shapes_.next() % 1'000'000);
      ToolVariants variants;
      variants.bare = variants.against_part = variants.against_fixture = compile_tool("random", random.profile);
      tool_ = std::move(variants);
      tool_name_ = random.name;
    }
    while (!tool_) {
      ToolAssembly assembly;
      assembly.cutter = test::random_cutter(shapes_);
      assembly.shank = test::random_segments(shapes_, 2);
      assembly.holder = test::random_segments(shapes_, 3);
      const double stock = kind == 1 ? 0 : shapes_.in(0, 0.5);
      Result<ToolVariants> variants = make_tool_variants(assembly, stock, 0, 0);
      if (!variants) continue;
      tool_ = std::move(*variants);
      tool_name_ = "cutter " + std::to_string(assembly.cutter.index());
    }
    size_ = std::max(tool_->bare.r_max_mm, 0.1);
    height_ = std::max(tool_->bare.z_max_mm, 0.1);
  }

  // --- the way ---

  void make_path(RandomJob& job) {
    const std::size_t count = 10 + scatter_.below(12);
    job.path.file = "random.apt";
    job.path.tools.resize(1);
    Pose at{scatter_.point(size_), scatter_.axis(1)};
    add(job.path, at, MoveKind::feed);
    while (job.path.moves.size() < count) {
      const double distance = size_ * std::pow(10, in(-3, chance(0.15) ? 0.5 : -1.3));
      const double kind = in(0, 1);
      if (kind < 0.5) {
        add_straight(job.path, distance);
      } else if (kind < 0.7) {
        add_arc(job.path, distance);
      } else if (kind < 0.85) {
        add_spline(job.path, distance);
      } else if (kind < 0.97) {
        add_cycle(job.path, distance);
      } else {  // a place reached in a way that is not known
        add(job.path, {scatter_.point(size_), scatter_.axis(1)}, MoveKind::feed);
        job.path.moves.back().has_start = false;
      }
    }
    job.path.moves.front().has_start = false;
  }

  static void add(Toolpath& path, const Pose& end, MoveKind kind) {
    Move move;
    move.kind = kind;
    move.line = path.moves.size() + 1;
    move.has_start = true;
    move.end = end;
    move.tool = 0;
    path.moves.push_back(move);
  }

  Vec3 turned(const Vec3& axis) {
    const double kind = in(0, 1);
    if (kind < 0.4) return axis;
    return (axis + std::pow(10, in(-3, kind < 0.9 ? -1 : 0.3)) * scatter_.point(1)).normalized();
  }

  void add_straight(Toolpath& path, double distance) {
    const Pose from = path.moves.back().end;
    const bool is_turn_alone = chance(0.15), is_home = chance(0.05);
    const Vec3 tip = is_home ? Vec3(scatter_.point(size_)) : Vec3(from.tip + scatter_.point(distance));
    add(path, {is_turn_alone ? from.tip : tip, turned(from.axis)}, chance(0.15) ? MoveKind::rapid : MoveKind::feed);
  }

  void add_arc(Toolpath& path, double distance) {
    const Pose from = path.moves.back().end;
    PathArc arc;
    arc.axis = chance(0.5) ? from.axis : Vec3(scatter_.point(1).normalized());
    const Vec3 out = Eigen::AngleAxisd(in(0, 2 * std::numbers::pi), arc.axis) * arc.axis.unitOrthogonal();
    const double radius = distance * in(0.2, 3);
    arc.center = from.tip - radius * out + (chance(0.5) ? 0 : in(-distance, distance)) * arc.axis;
    arc.sweep_rad = 2 * std::numbers::pi * (chance(0.3) ? (chance(0.5) ? 1.0 : -1.0) : in(-1.4, 1.4));
    const double rise = chance(0.5) ? 0 : in(-distance, distance);
    const double grown = chance(0.7) ? 1 : 1 + in(-0.1, 0.1);
    const Vec3 h = (from.tip - arc.center).dot(arc.axis) * arc.axis;
    const Vec3 r = Eigen::AngleAxisd(arc.sweep_rad, arc.axis) * Vec3(from.tip - arc.center - h);
    add(path, {arc.center + h + grown * r + rise * arc.axis, turned(from.axis)}, MoveKind::arc);
    path.moves.back().curve_kind = CurveKind::arc;
    path.moves.back().curve = path.arcs.size();
    path.arcs.push_back(arc);
  }

  void add_spline(Toolpath& path, double distance) {
    const Pose from = path.moves.back().end;
    std::vector<Vec3> control{from.tip};
    std::vector<double> knots;
    for (std::size_t k = scatter_.below(3); k > 0; --k) knots.push_back(in(0.1, 0.9));
    std::sort(knots.begin(), knots.end());
    while (control.size() < knots.size() + 4) control.push_back(control.back() + scatter_.point(distance));
    const PathSpline spline = make_spline(control, knots);
    if (spline.pieces.empty()) return;
    add(path, {spline.pieces.back().control[3], turned(from.axis)}, MoveKind::feed);
    path.moves.back().curve_kind = CurveKind::spline;
    path.moves.back().curve = path.splines.size();
    path.splines.push_back(spline);
  }

  /// Over the hole, down along the axis in one go or in pecks, and out again.
  void add_cycle(Toolpath& path, double distance) {
    Pose at = path.moves.back().end;
    at.tip += distance * at.axis.unitOrthogonal();
    add(path, at, MoveKind::cycle);
    const double depth = distance * in(0.2, 2);
    const std::size_t pecks = 1 + scatter_.below(3);
    for (std::size_t k = 1; k <= pecks; ++k) {
      const double share = static_cast<double>(k) / static_cast<double>(pecks);
      add(path, {at.tip - share * depth * at.axis, at.axis}, MoveKind::cycle);
      if (k < pecks && chance(0.5)) add(path, at, MoveKind::cycle);
    }
    add(path, at, MoveKind::cycle);
  }

  // --- what stands there ---

  void make_scene(RandomJob& job) {
    const double kind = in(0, 1);
    job.is_closed = kind < 0.6;
    IndexedMesh part;
    if (kind < 0.6) {
      part = placed_solid(job);
    } else if (kind < 0.8) {
      part = opened(placed_solid(job));
    } else {
      part.name = "triangles";
    }
    while (kind >= 0.6 && (part.triangles.empty() || chance(0.7))) add_triangle(part, job);
    job.scene.parts.push_back(std::move(part));
    if (chance(0.2)) job.scene.fixtures.push_back(placed_solid(job));
  }

  IndexedMesh solid() {
    switch (scatter_.below(9)) {
      case 0:
      case 1:
        return shapes::box(Vec3(0, 0, 0), Vec3(in(0.05, 1), in(0.2, 1), in(0.2, 1)));
      case 2:
        return shapes::sphere(1, 6, 9);
      case 3:
        return shapes::torus(1, in(0.1, 0.4), 9, 6);
      case 4:
        return shapes::star_prism(4, 1, in(0.3, 0.7), in(0.1, 1));
      case 5:
        return shapes::hollow_cube(1);
      case 6:
        return shapes::slotted_block(0.1, 0.6, 1, 2);
      case 7:
        return shapes::needle_fan(40, 1, 0.5);
      default:
        return shapes::tetrahedron(1);
    }
  }

  struct Touch {
    Vec3 at, outward;  ///< a place on the tool's boundary at some instant of some move
  };

  Touch touch(const RandomJob& job) {
    const std::size_t move = scatter_.below(job.path.moves.size());
    const Pose pose = reference::movement(job.path, move).at(chance(0.3) ? 1.0 : in(0, 1));
    const std::vector<BoundaryElement>& elements = job.tool.bare.elements;
    const BoundaryElement& e = elements[scatter_.below(elements.size())];
    Vec2 at = e.a + in(0, 1) * (e.b - e.a);
    Vec2 out = e.normal;
    if (e.kind == ElementKind::arc && e.radius_mm > 0 && (at - e.center).norm() > 0) {
      out = (at - e.center).normalized();
      at = e.center + e.radius_mm * out;
      if (e.is_reflex) out = -out;
    }
    if (!(out.norm() > 0.5)) out = Vec2(1, 0);
    const Vec3 sideways =
        Eigen::AngleAxisd(in(-std::numbers::pi, std::numbers::pi), pose.axis) * pose.axis.unitOrthogonal();
    return {pose.tip + at.x() * sideways + at.y() * pose.axis, (out.x() * sideways + out.y() * pose.axis).normalized()};
  }

  /// How deep in the tool, or away from it where negative: mostly about the tolerance.
  double deeper() {
    const double kind = in(0, 1);
    if (kind < 0.2) return 0;
    const double sign = chance(0.15) ? 1 : -1;
    return sign * (kind < 0.6 ? std::pow(10, in(-4, -1.5)) : size_ * std::pow(10, in(-3, 0)));
  }

  Eigen::Matrix3d turn_onto(const Vec3& from, const Vec3& to) {
    const Eigen::Quaterniond onto = Eigen::Quaterniond::FromTwoVectors(from, to);
    return Eigen::AngleAxisd(in(-3, 3), to).toRotationMatrix() * onto.toRotationMatrix();
  }

  /// A solid set against the tool at some instant, one of its faces onto the tool's surface or as it comes. Sometimes
  /// so large that the tool is wholly inside it.
  IndexedMesh placed_solid(const RandomJob& job) {
    IndexedMesh mesh = solid();
    const double scale = chance(0.05) ? 20 * (size_ + height_) : size_ * std::pow(10, in(-0.7, 0.9));
    for (Vec3& v : mesh.vertices) v *= scale;
    const std::size_t t = scatter_.below(mesh.triangles.size());
    const Vec3 a = mesh.corner(t, 0), b = mesh.corner(t, 1), c = mesh.corner(t, 2);
    const double u = in(0, 1), v = in(0, 1 - u);
    const Vec3 at = chance(0.3) ? a : Vec3(a + u * (b - a) + v * (c - a));
    const Touch place = touch(job);
    const Vec3 normal = (b - a).cross(c - a).normalized();
    const Eigen::Matrix3d turn =
        chance(0.8) ? turn_onto(normal, -place.outward) : turn_onto(normal, Vec3(scatter_.point(1).normalized()));
    const Vec3 to = place.at - deeper() * place.outward;
    const Vec3 inside = chance(0.1) ? Vec3(0.4 * scale * scatter_.point(1)) : Vec3::Zero();
    for (Vec3& vertex : mesh.vertices) vertex = turn * (vertex - at) + to + inside;
    return mesh;
  }

  IndexedMesh opened(IndexedMesh mesh) {
    for (std::size_t k = 1 + scatter_.below(3); k > 0 && mesh.triangles.size() > 1; --k) {
      mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(scatter_.below(mesh.triangles.size())));
    }
    mesh.file_triangle.resize(mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) mesh.file_triangle[t] = static_cast<std::uint32_t>(t);
    return mesh;
  }

  /// Against the tool, of any size and thinness, nearly in its tangent plane or across.
  void add_triangle(IndexedMesh& mesh, const RandomJob& job) {
    const Touch place = touch(job);
    const double size = size_ * std::pow(10, in(-2, 0.5)), thin = chance(0.3) ? 1e-3 : 1.0;
    const Vec3 normal = chance(0.85) ? place.outward : Vec3(scatter_.point(1).normalized());
    const double lean = chance(0.7) ? 0 : std::pow(10, in(-4, 0));
    const Vec3 foot = place.at - deeper() * place.outward;
    const Vec3 a = normal.unitOrthogonal(), b = normal.cross(a);
    const std::size_t n = mesh.vertices.size();
    for (int c = 0; c < 3; ++c)
      mesh.vertices.push_back(foot + size * (in(-1, 1) * a + thin * in(-1, 1) * b + lean * in(-1, 1) * normal));
    shapes::add_triangle(mesh, n, n + 1, n + 2);
  }

  /// Beside or above the tool, closed, with few faces.
  IndexedMesh head() {
    const double s = 2 * size_;
    IndexedMesh mesh = chance(0.5) ? shapes::box(Vec3(0, 0, 0), Vec3(s * in(0.3, 2), s * in(0.3, 2), s * in(0.3, 2)))
                                   : shapes::star_prism(3, s, s * in(0.4, 0.8), s * in(0.3, 1));
    const Vec3 shift(in(-s, s), in(-s, s), height_ * in(0.3, 1.2));
    return shapes::moved(mesh, shift);
  }

  SceneScatter scatter_;
  test::Scatter shapes_;
  std::optional<ToolVariants> tool_;
  std::string tool_name_;
  int uses_left_ = 0;
  double size_ = 1, height_ = 1;
};

}  // namespace gouge::laws
