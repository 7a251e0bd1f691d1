#include "lib/stock/convex_pieces.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace gouge {

namespace {

double value_of_arc(const ConvexPiece::Face& face, const Vec2& q) {
  const Vec2 from = q - face.center;
  // The sector of the arc: between its end normals, which turn counter-clockwise from a to b.
  const auto cross = [](const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); };
  if (cross(face.normal_a, from) >= 0 && cross(from, face.normal_b) >= 0) return from.norm() - face.radius_mm;
  return std::max(face.normal_a.dot(from), face.normal_b.dot(from)) - face.radius_mm;
}

/// Returns the least sine of half the interior angle between faces that follow each other, both ends included. The
/// interior angle of two faces whose normals enclose the angle a is pi - a.
double growth_of(const ConvexPiece& piece) {
  double least = 1;
  Vec2 before(0, -1);
  const auto meet = [&](const Vec2& normal) {
    const double cosine = std::clamp(before.dot(normal), -1.0, 1.0);
    least = std::min(least, std::sqrt(0.5 * (1 + cosine)));
  };
  for (const ConvexPiece::Face& face : piece.faces) {
    meet(face.is_arc ? face.normal_a : face.normal);
    before = face.is_arc ? face.normal_b : face.normal;
  }
  meet(Vec2(0, 1));
  return least;
}

/// Makes the pieces along the contour, from the tip up.
class PieceMaker {
 public:
  explicit PieceMaker(const CompiledTool& tool) : tool_(tool) {}

  std::vector<ConvexPiece> run() {
    highest_ = tool_.z_min_mm;
    for (const BoundaryElement& e : tool_.elements) {
      if (e.body != Body::cutter) break;
      if (e.kind == ElementKind::vertex) {
        if (e.is_reflex) close();
        continue;
      }
      if (e.b.y() < e.a.y()) {
        turn_back(e);
      } else if (e.kind == ElementKind::arc && e.is_reflex) {
        add_reflex(e);
      } else {
        add(e);
      }
    }
    close();
    for (ConvexPiece& piece : pieces_) piece.growth = growth_of(piece);
    return std::move(pieces_);
  }

 private:
  void open(double z) {
    piece_ = {};
    piece_.z_lo_mm = std::max(z, highest_);
    is_open_ = true;
  }

  void add(const BoundaryElement& e) {
    if (!is_open_) open(e.a.y());
    ConvexPiece::Face face;
    face.normal = e.normal;
    face.offset_mm = e.normal.dot(e.a);
    if (e.kind == ElementKind::arc) {
      face.is_arc = true;
      face.center = e.center;
      face.radius_mm = e.radius_mm;
      face.normal_a = (e.a - e.center).normalized();
      face.normal_b = (e.b - e.center).normalized();
    }
    piece_.faces.push_back(face);
    end_at(e);
  }

  void end_at(const BoundaryElement& e) {
    piece_.z_hi_mm = e.b.y();
    double widest = std::max(e.a.x(), e.b.x());
    if (e.kind == ElementKind::arc && !e.is_reflex) widest = std::max(widest, e.center.x() + e.radius_mm);
    piece_.r_max_mm = std::max(piece_.r_max_mm, widest);
  }

  /// The tangent at the middle of a part of the arc lies inside the solid.
  void add_reflex(const BoundaryElement& e) {
    close();
    const Vec2 from = e.a - e.center, to = e.b - e.center;
    const double a = std::atan2(from.y(), from.x());
    double turn = std::atan2(to.y(), to.x()) - a;
    turn = std::remainder(turn, 2 * std::numbers::pi);
    for (int k = 0; k < kReflexParts; ++k) {
      const auto at = [&](double share) {
        const double angle = a + turn * (k + share) / kReflexParts;
        return Vec2(std::cos(angle), std::sin(angle));
      };
      const Vec2 middle = at(0.5);
      BoundaryElement part = e;
      part.kind = ElementKind::segment;
      part.a = e.center + e.radius_mm * at(0);
      part.b = e.center + e.radius_mm * at(1);
      if (part.b.y() < part.a.y()) {
        turn_back(part);
        continue;
      }
      open(part.a.y());
      ConvexPiece::Face face;
      face.normal = -middle;
      face.offset_mm = -middle.dot(e.center) - e.radius_mm;
      piece_.faces.push_back(face);
      end_at(part);
      close();
    }
  }

  /// Where the contour goes down, only heights beyond it are free of it.
  void turn_back(const BoundaryElement& e) {
    close();
    for (ConvexPiece& piece : pieces_) piece.z_hi_mm = std::min(piece.z_hi_mm, e.b.y());
    std::erase_if(pieces_, [](const ConvexPiece& piece) { return !(piece.z_hi_mm > piece.z_lo_mm); });
    highest_ = std::max(highest_, e.a.y());
  }

  void close() {
    if (std::exchange(is_open_, false) && piece_.z_hi_mm > piece_.z_lo_mm && !piece_.faces.empty())
      pieces_.push_back(piece_);
  }

  const CompiledTool& tool_;
  std::vector<ConvexPiece> pieces_;
  ConvexPiece piece_;
  bool is_open_ = false;
  double highest_ = 0;
};

}  // namespace

double ConvexPiece::value(double r_mm, double z_mm) const {
  const Vec2 q(r_mm, z_mm);
  double most = std::max(z_lo_mm - z_mm, z_mm - z_hi_mm);
  for (const Face& face : faces)
    most = std::max(most, face.is_arc ? value_of_arc(face, q) : face.normal.dot(q) - face.offset_mm);
  return most;
}

double ConvexPiece::value(const Disc& disc, const Vec3& tip, const Vec3& axis) const {
  const Vec3 from_tip = disc.center - tip;
  const double z = from_tip.dot(axis);
  const double r = std::sqrt(std::max(0.0, from_tip.squaredNorm() - z * z));
  if (!(disc.radius_mm > 0)) return value(r, z);
  const double sine = disc.normal.cross(axis).norm() * disc.radius_mm;
  const double widest = r + disc.radius_mm;
  const double above = value(widest, z + sine);
  return sine > 0 ? std::max(above, value(widest, z - sine)) : above;
}

std::vector<ConvexPiece> convex_pieces(const CompiledTool& tool) { return PieceMaker(tool).run(); }

}  // namespace gouge
