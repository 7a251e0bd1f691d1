#include "toolmodels/arrangement.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "lib/base/tolerance.h"
#include "toolmodels/box_tree.h"
#include "toolmodels/offset_curves.h"

namespace gouge::detail {
namespace {

class CurveCutter {
 public:
  CurveCutter(const std::vector<ProfileElement>& curves, double slack) : curves_(curves), slack_(slack) {}

  Arrangement run() {
    ends_.resize(curves_.size());
    for (std::size_t i = 0; i < curves_.size(); ++i) ends_[i] = {vertex(curves_[i].a), vertex(curves_[i].b)};
    std::vector<Eigen::AlignedBox2d> boxes, points;
    for (const ProfileElement& curve : curves_) boxes.push_back(box_around(curve, 5 * slack_));
    const BoxTree curve_tree(boxes);
    for (std::size_t i = 0; i < curves_.size(); ++i) {
      for (const Vec2& p : axis_points(curves_[i], slack_)) vertex(p);
      curve_tree.for_each_meeting(boxes[i], [&](std::size_t j) {
        if (j <= i) return;
        for (const Vec2& p : meeting_points(curves_[i], curves_[j], slack_)) vertex(p);
      });
    }
    for (const Vec2& v : made_.vertices) points.emplace_back(v);
    const BoxTree vertex_tree(points);
    for (std::size_t i = 0; i < curves_.size(); ++i) cut(i, boxes[i], vertex_tree);
    drop_shared();
    return std::move(made_);
  }

 private:
  // Returns the earliest vertex at most twice the slack away from `p`, or adds one.
  std::size_t vertex(Vec2 p) {
    if (std::abs(p.x()) <= slack_) p.x() = 0;
    // Vertices are sorted by their place along a direction in which hardly any two corners of a tool have equal places.
    const double place = std::cos(1.0) * p.x() + std::sin(1.0) * p.y();
    std::size_t found = made_.vertices.size();
    for (auto at = places_.lower_bound(place - 3 * slack_); at != places_.end() && at->first <= place + 3 * slack_;
         ++at)
      if (at->second < found && (made_.vertices[at->second] - p).norm() <= 2 * slack_) found = at->second;
    if (found < made_.vertices.size()) return found;
    places_.emplace(place, found);
    made_.vertices.push_back(p);
    return found;
  }

  // Cuts curve i at all vertices on it. The search covers all vertices, so that curves that overlap are cut at the same
  // ones.
  void cut(std::size_t i, const Eigen::AlignedBox2d& box, const BoxTree& vertex_tree) {
    const ProfileElement& curve = curves_[i];
    const auto [first, last] = ends_[i];
    std::vector<std::pair<double, std::size_t>> cuts;
    vertex_tree.for_each_meeting(box, [&, from = first, to = last](std::size_t v) {
      if (v != from && v != to && passes(curve, made_.vertices[v], 4 * slack_))
        cuts.emplace_back(length_along(curve, made_.vertices[v]), v);
    });
    std::sort(cuts.begin(), cuts.end());
    cuts.emplace_back(curve_length(curve), last);
    std::size_t from = first;
    for (const auto& [contour, to] : cuts) {
      if (to != from) add(curve, from, to);
      from = to;
    }
  }

  void add(const ProfileElement& curve, std::size_t from, std::size_t to) {
    ProfileElement piece = curve;
    piece.a = made_.vertices[from];
    piece.b = made_.vertices[to];
    if (middle(piece).x() > slack_) made_.pieces.push_back({piece, from, to});
  }

  // Returns whether two pieces between the same two vertices lie on each other.
  [[nodiscard]] bool coincide(const CurvePiece& p, const CurvePiece& q) const {
    return (middle(p.curve) - middle(q.curve)).norm() <= 4 * slack_;
  }

  void drop_shared() {
    std::vector<CurvePiece>& pieces = made_.pieces;
    std::vector<bool> is_dropped(pieces.size());
    std::map<std::pair<std::size_t, std::size_t>, std::vector<std::size_t>> between;
    for (std::size_t j = 0; j < pieces.size(); ++j) {
      std::vector<std::size_t>& earlier = between[std::minmax(pieces[j].from, pieces[j].to)];
      for (const std::size_t i : earlier) {
        if (!coincide(pieces[i], pieces[j])) continue;
        is_dropped[j] = true;
        if (pieces[i].from != pieces[j].from) is_dropped[i] = true;
      }
      earlier.push_back(j);
    }
    std::vector<CurvePiece> kept;
    for (std::size_t i = 0; i < pieces.size(); ++i)
      if (!is_dropped[i]) kept.push_back(pieces[i]);
    pieces = std::move(kept);
  }

  const std::vector<ProfileElement>& curves_;
  double slack_;
  Arrangement made_;
  std::multimap<double, std::size_t> places_;  // the vertices, by place along the direction of vertex()
  std::vector<std::pair<std::size_t, std::size_t>> ends_;
};

double turn_between(const Vec2& u, const Vec2& v) {
  const double turn = std::atan2(u.x() * v.y() - u.y() * v.x(), u.dot(v));
  return turn < -std::numbers::pi + Tolerance::kTangent ? std::numbers::pi : turn;
}

double curvature(const ProfileElement& e) {
  if (!e.is_arc) return 0;
  return (e.is_concave ? -1 : 1) / e.radius_mm;
}

class Walker {
 public:
  explicit Walker(const Arrangement& arrangement)
      : vertices_(arrangement.vertices), pieces_(arrangement.pieces), leaving_(vertices_.size()) {
    for (std::size_t i = 0; i < pieces_.size(); ++i) leaving_[pieces_[i].from].push_back(i);
  }

  std::optional<std::vector<ProfileElement>> walk() {
    const std::optional<std::size_t> start = lowest_start();
    if (!start) return std::nullopt;
    is_used_.assign(pieces_.size(), false);
    enter(*start);
    while (!path_.empty() && !is_at_top()) step();
    if (path_.empty()) return std::nullopt;
    std::vector<ProfileElement> contour;
    for (const Step& s : path_) contour.push_back(pieces_[s.piece].curve);
    return contour;
  }

 private:
  struct Step {
    std::size_t piece;
    std::vector<std::size_t> next;  // candidates for the next piece; the best is last
  };

  [[nodiscard]] bool is_on_axis(std::size_t vertex) const { return !(vertices_[vertex].x() > 0); }
  [[nodiscard]] double height(std::size_t vertex) const { return vertices_[vertex].y(); }

  std::optional<std::size_t> lowest_start() {
    std::optional<std::size_t> start;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      if (is_on_axis(pieces_[i].from) && (!start || height(pieces_[i].from) < height(pieces_[*start].from))) start = i;
      if (is_on_axis(pieces_[i].to)) top_ = std::max(top_, height(pieces_[i].to));
    }
    return start;
  }

  [[nodiscard]] bool is_at_top() const {
    const std::size_t end = pieces_[path_.back().piece].to;
    return is_on_axis(end) && !(height(end) < top_);
  }

  void enter(std::size_t piece) {
    is_used_[piece] = true;
    const Vec2 arriving = end_direction(pieces_[piece].curve);
    std::vector<std::pair<double, std::size_t>> turns;
    for (const std::size_t i : leaving_[pieces_[piece].to])
      if (!is_used_[i]) turns.emplace_back(turn_between(arriving, start_direction(pieces_[i].curve)), i);
    std::sort(turns.begin(), turns.end(), [&](const auto& p, const auto& q) {
      if (std::abs(p.first - q.first) > Tolerance::kTangent) return p.first > q.first;
      const double bend = curvature(pieces_[p.second].curve) - curvature(pieces_[q.second].curve);
      return bend > 0 || (!(bend < 0) && p.second > q.second);
    });
    Step step{piece, {}};
    for (const auto& [turn, i] : turns) step.next.push_back(i);
    path_.push_back(std::move(step));
  }

  void step() {
    if (path_.back().next.empty()) {
      path_.pop_back();
      return;
    }
    const std::size_t next = path_.back().next.back();
    path_.back().next.pop_back();
    if (!is_used_[next]) enter(next);
  }

  const std::vector<Vec2>& vertices_;
  const std::vector<CurvePiece>& pieces_;
  std::vector<std::vector<std::size_t>> leaving_;  // for each vertex, the pieces that start there
  std::vector<bool> is_used_;
  std::vector<Step> path_;
  double top_ = -1e300;
};

}  // namespace

Arrangement arrange(const std::vector<ProfileElement>& curves, double slack_mm) {
  return CurveCutter(curves, slack_mm).run();
}

std::optional<std::vector<ProfileElement>> outer_contour(const Arrangement& arrangement) {
  return Walker(arrangement).walk();
}

}  // namespace gouge::detail
