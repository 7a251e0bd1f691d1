#include "lib/head/head_body.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "lib/base/tolerance.h"
#include "lib/check/scene_reach.h"
#include "lib/head/revolved_cover.h"
#include "lib/mesh/union_find.h"

namespace gouge {
namespace {

constexpr std::size_t kTries = 200;
constexpr double kMinBall = 1e-7;   // share of the size: thinner parts of a body are not searched
constexpr double kMinDepth = 1e-4;  // share of the size: minimum depth at which the search for a ball inside starts
constexpr int kMaxClimbs = 40;

/// Returns, for each triangle, the piece of surface to which it belongs. Pieces are numbered from 0 in the order of
/// their first triangle.
std::vector<std::uint32_t> pieces_of(const IndexedMesh& mesh) {
  UnionFind joined(mesh.vertices.size());
  for (const TriangleCorners& t : mesh.triangles) {
    joined.join(t[0], t[1]);
    joined.join(t[0], t[2]);
  }
  constexpr std::uint32_t kNew = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> number(mesh.vertices.size(), kNew), piece;
  piece.reserve(mesh.triangles.size());
  std::uint32_t count = 0;
  for (const TriangleCorners& t : mesh.triangles) {
    std::uint32_t& own = number[joined.root(t[0])];
    if (own == kNew) own = count++;
    piece.push_back(own);
  }
  return piece;
}

/// Adds one core for each piece of a surface that is the boundary of its body.
void add_cores_of_pieces(HeadBody& head) {
  const IndexedMesh& mesh = head.surface.mesh();
  const std::vector<std::uint32_t> piece = pieces_of(mesh);
  const std::uint32_t pieces = *std::max_element(piece.begin(), piece.end()) + 1;
  head.cores.resize(pieces, Vec3::Zero());
  head.core_depths_mm.resize(pieces, 0);
  const double size = head.box.diagonal().norm();
  const std::size_t step = std::max<std::size_t>(1, mesh.triangles.size() / (kTries * pieces));
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (t % step != 0 && head.core_depths_mm[piece[t]] > 0) continue;
    const Vec3 centre = (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3.0;
    for (double depth = 0.5 * size; depth > kMinDepth * size; depth *= 0.5) {
      const Vec3 core = centre - depth * head.surface.face_normal(t);
      const auto foot = head.surface.closest_point(core);
      if (!foot || !foot->is_inside || piece[foot->triangle] != piece[t]) continue;
      if (foot->distance_mm <= head.core_depths_mm[piece[t]]) continue;
      head.core_depths_mm[piece[t]] = foot->distance_mm;
      head.cores[piece[t]] = core;
    }
  }
}

/// Balls inside a body. Each grows from a point of the boundary, which it touches, until it is the largest nearby. Two
/// balls that meet are in one connected part of the inside; the larger is kept.
class CoreBalls {
 public:
  explicit CoreBalls(const Surface& surface) : surface_(surface), size_mm_(surface.mesh().box().diagonal().norm()) {}

  /// Adds a ball that touches a triangle at its middle. Returns false if all balls there are tiny.
  bool add_from(std::uint32_t triangle) {
    const std::array<Vec3, 3> corners = surface_.corners(triangle);
    const Vec3 start = (corners[0] + corners[1] + corners[2]) / 3.0;
    for (double depth = 0.5 * size_mm_; depth > kMinBall * size_mm_; depth *= 0.5) {
      Ball ball{start - depth * surface_.face_normal(triangle), 0};
      const auto foot = surface_.closest_point(ball.centre);
      if (!foot->is_inside || foot->distance_mm < depth - Tolerance::kSamePoint_mm) continue;
      ball.radius_mm = foot->distance_mm;
      keep(grown(ball, *foot));
      return true;
    }
    return false;
  }

  void move_to(HeadBody& head) const {
    for (const Ball& ball : balls_) {
      head.cores.push_back(ball.centre);
      head.core_depths_mm.push_back(ball.radius_mm);
    }
  }

 private:
  struct Ball {
    Vec3 centre = Vec3::Zero();
    double radius_mm = 0;
  };

  /// Returns a larger ball. Each next centre is within the ball before it.
  [[nodiscard]] Ball grown(Ball ball, ClosestPoint foot) const {
    double step = 0.9;
    for (int k = 0; k < kMaxClimbs && step > 0.01; ++k) {
      const Vec3 next = ball.centre - step * ball.radius_mm * foot.normal;
      const ClosestPoint there = *surface_.closest_point(next);
      if (there.is_inside && there.distance_mm > ball.radius_mm) {
        ball = {next, there.distance_mm};
        foot = there;
      } else {
        step *= 0.5;
      }
    }
    return ball;
  }

  void keep(Ball ball) {
    const auto meets = [&](const Ball& other) {
      return (other.centre - ball.centre).norm() < 0.999 * (other.radius_mm + ball.radius_mm);
    };
    for (const Ball& other : balls_) {
      if (meets(other) && other.radius_mm >= ball.radius_mm) return;
    }
    std::erase_if(balls_, [&](const Ball& other) { return meets(other); });
    balls_.push_back(ball);
  }

  const Surface& surface_;
  double size_mm_;
  std::vector<Ball> balls_;
};

/// Returns the triangles of each piece, the largest first.
std::vector<std::vector<std::uint32_t>> triangles_by_piece(const IndexedMesh& mesh) {
  const std::vector<std::uint32_t> piece = pieces_of(mesh);
  std::vector<std::vector<std::uint32_t>> all(*std::max_element(piece.begin(), piece.end()) + 1);
  std::vector<double> areas2(mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    all[piece[t]].push_back(t);
    const Vec3& first = mesh.corner(t, 0);
    areas2[t] = (mesh.corner(t, 1) - first).cross(mesh.corner(t, 2) - first).norm();
  }
  for (std::vector<std::uint32_t>& triangles : all)
    std::ranges::stable_sort(triangles, [&](std::uint32_t a, std::uint32_t b) { return areas2[a] > areas2[b]; });
  return all;
}

/// Adds cores if the boundary consists of parts of the surface. It tries some hundred triangles, and those of each piece
/// until one has a ball. A piece of which none has one is thin everywhere, or its core of depth 0 proves nothing clean.
void add_cores_of_boundary(HeadBody& head) {
  const IndexedMesh& mesh = head.surface.mesh();
  const std::size_t step = std::max<std::size_t>(1, mesh.triangles.size() / kTries);
  CoreBalls balls(head.surface);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); t += static_cast<std::uint32_t>(step)) balls.add_from(t);
  std::vector<Vec3> unknown;
  for (const std::vector<std::uint32_t>& triangles : triangles_by_piece(mesh)) {
    const std::size_t tries = std::min(triangles.size(), kTries);
    const bool has_ball = std::any_of(triangles.begin(), triangles.begin() + static_cast<std::ptrdiff_t>(tries),
                                      [&](std::uint32_t t) { return balls.add_from(t); });
    if (!has_ball && tries < triangles.size()) unknown.push_back(mesh.corner(triangles.front(), 0));
  }
  balls.move_to(head);
  head.cores.insert(head.cores.end(), unknown.begin(), unknown.end());
  head.core_depths_mm.resize(head.cores.size(), 0);
}

}  // namespace

Result<HeadBody> build_head_body(IndexedMesh mesh) { return build_head_body(Surface(std::move(mesh))); }

Result<HeadBody> build_head_body(const Surface& whole) {
  if (auto error = find_too_far(whole.mesh(), "head", "--stl-units")) return *std::move(error);
  if (!whole.is_solid()) {
    return make_error("mesh-head-open",
                      "is not a closed solid facing outward; expected one, since what is inside the head must be "
                      "known; 'gougecheck mesh FILE --repair OUT.stl' reports what is wrong",
                      whole.mesh().name);
  }
  HeadBody head{whole, whole.boundary(), {}, {}, {}, {}, {}};
  if (!head.surface.is_solid() || head.surface.mesh().triangles.empty()) {
    return make_error("mesh-head-crosses",
                      "crosses itself so that rounding leaves unknown where its inside ends; expected a plain solid; "
                      "'gougecheck mesh FILE' reports where",
                      whole.mesh().name);
  }
  head.box = head.surface.mesh().box();
  head.cover = make_revolved_cover(head.surface.mesh());
  head.supports = SupportPlanes(head.surface);
  whole.is_boundary() ? add_cores_of_pieces(head) : add_cores_of_boundary(head);
  return head;
}

std::vector<Surface> head_pieces(const Surface& whole) {
  if (find_mesh_findings(whole.mesh()).cavities > 0 || !whole.is_boundary()) return {whole};
  std::vector<IndexedMesh> shells = shells_of(whole.mesh());
  if (shells.size() < 2) return {whole};
  std::vector<Surface> pieces;
  for (IndexedMesh& shell : shells) pieces.emplace_back(std::move(shell));
  return pieces;
}

Result<std::vector<HeadBody>> moved_up(const std::vector<HeadBody>& heads, double by_mm) {
  std::vector<HeadBody> moved;
  for (const HeadBody& head : heads) {
    IndexedMesh mesh = head.whole.mesh();
    for (Vec3& vertex : mesh.vertices) vertex.z() += by_mm;
    Result<HeadBody> body = build_head_body(std::move(mesh));
    if (!body) return body.error();
    moved.push_back(std::move(*body));
  }
  return moved;
}

std::vector<IndexedMesh> shells_of(const IndexedMesh& mesh) {
  const std::vector<std::uint32_t> piece = pieces_of(mesh);
  std::vector<IndexedMesh> all(piece.empty() ? 0 : *std::max_element(piece.begin(), piece.end()) + 1);
  constexpr Corner kNew = std::numeric_limits<Corner>::max();
  std::vector<Corner> slot(mesh.vertices.size(), kNew);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    IndexedMesh& own = all[piece[t]];
    TriangleCorners corners = mesh.triangles[t];
    for (Corner& c : corners) {
      if (slot[c] == kNew) {
        slot[c] = static_cast<Corner>(own.vertices.size());
        own.vertices.push_back(mesh.vertices[c]);
      }
      c = slot[c];
    }
    own.triangles.push_back(corners);
    own.file_triangle.push_back(mesh.file_triangle[t]);
  }
  for (IndexedMesh& own : all) own.name = mesh.name;
  return all;
}

}  // namespace gouge
